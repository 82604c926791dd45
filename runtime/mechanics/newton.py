"""Newton's method for equilibria, paths and steady motion: one loop, with one rule for when it has arrived."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Generic, TypeVar

import numpy as np

from flexel.base.arrays import Array

Point = TypeVar("Point")
Equations = TypeVar("Equations")


@dataclass(frozen=True)
class Arrival(Generic[Point, Equations]):
    """Where Newton's method has ended.

    Attributes
    ----------
    point
        The last point; the solution where it has converged.
    equations
        The equations at the last point where they were evaluated.
    error : float
        Of these.
    iterations : int
        Evaluations of the equations.
    converged : bool
    """

    point: Point
    equations: Equations
    error: float
    iterations: int
    converged: bool


def newton(
    start: Point,
    evaluate: Callable[[Point], tuple[Equations, float]],
    move: Callable[[Point, Equations], Point | None],
    *,
    tolerance: float,
    stalled: float,
    most: int,
) -> Arrival[Point, Equations]:
    """Newton's method from a starting point.

    It has converged where the error is below the tolerance, or below `stalled` when it is no longer halved: rounding
    then lets it go no further.  It gives up at an error that is not finite, and where a step leads nowhere.

    Parameters
    ----------
    start
        Any description of the unknowns.
    evaluate : callable
        The equations at a point, and the size of their error in natural scales.
    move : callable
        The next point, from a point and the equations there; None where the step is of no use.
    tolerance, stalled : float
        Errors at which a point is accepted, at once and when the error stalls.
    most : int
        Evaluations after which it gives up.

    Returns
    -------
    Arrival
    """
    point, best = start, np.inf
    for iteration in range(1, most + 1):
        equations, error = evaluate(point)
        if error < tolerance or (error < stalled and error > 0.5 * best):
            return Arrival(point, equations, error, iteration, True)
        best = min(best, error)
        following = move(point, equations) if np.isfinite(error) else None
        if following is None:
            break
        point = following
    return Arrival(point, equations, error, iteration, False)


def shortened(step: Array, size: float, longest: float) -> Array:
    """A step whose size, in natural scales, is at most `longest`."""
    return step * min(1.0, longest / max(size, 1e-300))
