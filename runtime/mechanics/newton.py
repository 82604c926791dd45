"""Newton's method for equilibria, paths and steady motion: one loop with one convergence criterion."""

from __future__ import annotations

import logging
from collections.abc import Callable
from dataclasses import dataclass
from typing import Generic, TypeVar

import numpy as np

from flexel.base.arrays import Array

log = logging.getLogger("flexel.newton")
Point = TypeVar("Point")
Equations = TypeVar("Equations")


@dataclass(frozen=True)
class Arrival(Generic[Point, Equations]):
    """Result of Newton's method.

    Attributes
    ----------
    point
        The last point; the solution if it has converged.
    equations
        The equations at the last point of evaluation.
    error : float
        Error of these equations.
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
    """Apply Newton's method from a starting point.

    It has converged when the error is below the tolerance, or below `stalled` and no longer halved, since rounding
    errors prevent further progress.  It stops at an error that is not finite, or a step without progress.

    Parameters
    ----------
    start
        Any description of the unknowns.
    evaluate : callable
        The equations at a point, and the size of their error in natural scales.
    move : callable
        The next point, from a point and the equations there; None if the step is useless.
    tolerance, stalled : float
        Errors at which a point is accepted: immediately, and when the error stalls.
    most : int
        Maximum number of evaluations.

    Returns
    -------
    Arrival
    """
    point, best = start, np.inf
    for iteration in range(1, most + 1):
        equations, error = evaluate(point)
        log.debug("evaluation %d: error %.3g", iteration, error)
        if error < tolerance or (error < stalled and error > 0.5 * best):
            return Arrival(point, equations, error, iteration, True)
        best = min(best, error)
        following = move(point, equations) if np.isfinite(error) else None
        if following is None:
            break
        point = following
    return Arrival(point, equations, error, iteration, False)


def shortened(step: Array, size: float, longest: float) -> Array:
    """Limit a step to the size `longest` in natural scales."""
    return step * min(1.0, longest / max(size, 1e-300))
