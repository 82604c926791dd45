"""Follows solution curves by arc length, past folds of the parameter: one method for all analyses.

A curve consists of the solutions of n equations r(u, p) = 0 in n unknowns u and a parameter p.  A step of given arc
length follows the tangent; Newton's method returns to the curve in the plane normal to it.  Newton's method may reach
another curve, or a distant part of the same one; so a point is rejected if the tangent has turned much, if it is far
from its guess, or if the way to it is not along the mean tangent.  The sign of det ∂r/∂u times the tangent's parameter
changes only where curves cross; if it changes in a longer step, a fold was stepped over.  The number of unstable
motions changes by one at a fold or a crossing; if it changes by more in a longer step, another curve was reached.
Steps that fail are halved.  Sources: Crisfield (1981), Keller (1977).
"""

from __future__ import annotations

import logging
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Generic, Protocol, TypeVar

import numpy as np

from flexel.base.arrays import Array
from flexel.mechanics.newton import newton

log = logging.getLogger("flexel.continuation")
MAX_ITERATIONS = 20
FEW, GROWTH, CUT = 4, 1.5, 0.7  # the arc grows after at most this many iterations, and is cut after more
COSINE = 0.9  # smallest cosine between the tangents of adjacent points
ALONG = 0.99  # smallest cosine between their mean tangent and the chord: one, for a parabola or a circle
SHORT = 1e-4  # longest arc across a corner, where a contact opens, and across a point where curves cross
AROUND = 10.0  # largest distance of a point from its guess around a corner, relative to the arc
ASTRAY = 0.5  # largest distance of a point from its guess, relative to the arc
Equations = TypeVar("Equations")
Result = TypeVar("Result")


class SolutionCurve(Protocol[Equations]):
    """The equations of a curve; y = (u, p) is a vector (n + 1,) with the parameter at its end."""

    tolerance: float
    stalled: float
    further: int  # steps of Newton's method after it has converged, for the last digits
    retried: tuple[type[Exception], ...]  # errors of trial points that a shorter step may avoid

    def equations(self, y: Array, last: Equations) -> Equations:
        """Evaluate the equations at y, near a point of the curve at which they are known."""
        ...

    def error(self, equations: Equations) -> float:
        """Return the size of their residual in natural scales."""
        ...

    def solve(self, equations: Equations) -> Array:
        """Return A⁻¹ r and A⁻¹ ∂r/∂p as columns (n, 2), with A = ∂r/∂u."""
        ...

    def sign(self, equations: Equations) -> int:
        """Return the sign of det A; zero if it is not known."""
        ...

    def unstable(self, equations: Equations) -> int | None:
        """Return the number of motions in which a solution is unstable; None if it is not known."""
        ...

    def weights(self, equations: Equations) -> Array:
        """Return the weights (n + 1,) of the squares of small changes of y in the squared arc length, near a point."""
        ...

    def allows(self, step: Array, arc: float) -> bool:
        """Whether a step (n + 1,) of Newton's method is short enough to be useful, after an arc of this length."""
        ...


@dataclass(frozen=True)
class CurvePoint(Generic[Equations]):
    """A point of a curve.

    Attributes
    ----------
    y : ndarray (n + 1,)
    equations
    tangent : ndarray (n + 1,)
        Of unit arc length; its last entry is the change of the parameter, zero at a fold.
    iterations : int
        Evaluations that led to it.
    unstable : int or None
        Number of motions in which it is unstable, if that is known.
    """

    y: Array
    equations: Equations
    tangent: Array
    iterations: int = 0
    unstable: int | None = None


@dataclass(frozen=True)
class Arcs:
    """Arc lengths of steps, and the largest number of steps."""

    first: float
    largest: float
    smallest: float
    steps: int


def point_at(
    curve: SolutionCurve[Equations],
    y: Array,
    equations: Equations,
    before: Array | None = None,
    iterations: int = 0,
) -> CurvePoint[Equations]:
    """Make a point with these equations; its tangent points onward from the last one, first to larger parameters."""
    slope, weights = -curve.solve(equations)[:, 1], curve.weights(equations)
    tangent = np.append(slope, 1.0)
    tangent /= np.sqrt(float(weights @ tangent**2))
    if before is not None and (weights * tangent) @ before < 0:
        tangent = -tangent
    return CurvePoint(y, equations, tangent, iterations)


def corrected(
    curve: SolutionCurve[Equations], guess: Array, normal: Array, known: CurvePoint[Equations], arc: float
) -> CurvePoint[Equations] | None:
    """Find the point of the curve in the plane through a guess, by Newton's method.

    Returns None if the method does not converge, or reaches a point that does not follow the nearby one.

    Parameters
    ----------
    guess : ndarray (n + 1,)
    normal : ndarray (n + 1,)
        Of the plane: all y with normal · (y - guess) = 0.
    known : CurvePoint
        A known point of the curve nearby.
    arc : float
        Distance of the guess from it.
    """

    def evaluate(y: Array) -> tuple[Equations, float]:
        found = curve.equations(y, known.equations)
        return found, curve.error(found)

    def move(y: Array, equations: Equations) -> Array | None:
        both = curve.solve(equations)
        # bordered elimination: u = -both0 - both1 dp, and the step stays in the plane
        bottom = normal[-1] - normal[:-1] @ both[:, 1]
        dp = (normal[:-1] @ both[:, 0] - normal @ (y - guess)) / bottom
        step = np.append(-both[:, 0] - both[:, 1] * dp, dp)
        return y + step if curve.allows(step, arc) else None

    limits = {"tolerance": curve.tolerance, "stalled": curve.stalled}
    found = newton(guess, evaluate, move, **limits, most=MAX_ITERATIONS)
    if not found.converged:
        return None
    y, equations = found.point, found.equations
    for _ in range(curve.further):
        onward = move(y, equations)
        if onward is None:
            break
        there, error = evaluate(onward)
        if not error <= max(curve.tolerance, found.error):  # false for NaN, which free motions cause
            break
        y, equations = onward, there
    point = point_at(curve, y, equations, known.tangent, found.iterations)
    return _counted(curve, point, known, arc) if _follows(curve, point, guess, known, arc) else None


def _counted(
    curve: SolutionCurve[Equations], point: CurvePoint[Equations], known: CurvePoint[Equations], arc: float
) -> CurvePoint[Equations] | None:
    """Return a point with its number of unstable motions; None if this changes by more than one in a longer step."""
    before, now = known.unstable, curve.unstable(point.equations)
    if arc > SHORT and before is not None and now is not None and abs(now - before) > 1:
        log.debug("point refused: unstable in %d motions after %d", now, before)
        return None
    return replace(point, unstable=now)


def _follows(
    curve: SolutionCurve[Equations],
    point: CurvePoint[Equations],
    guess: Array,
    known: CurvePoint[Equations],
    arc: float,
) -> bool:
    """Whether a point continues the curve: its tangent has turned little, and it is close to its guess."""
    weights = curve.weights(known.equations)

    def cosine(a: Array, b: Array) -> float:
        lengths = float(np.sqrt((weights @ a**2) * (weights @ b**2)))
        # a point on the last one does not follow it
        return float((weights * a) @ b) / lengths if lengths else 0.0

    astray = float(np.sqrt(weights @ (point.y - guess) ** 2))
    if arc <= SHORT:
        return astray < AROUND * arc
    same = np.sign([curve.sign(p.equations) * p.tangent[-1] for p in (known, point)])
    if same[0] * same[1] < 0:
        log.debug("point refused: it is beyond a fold, or curves cross")
        return False
    turned = cosine(known.tangent, point.tangent)
    along = cosine(known.tangent + point.tangent, point.y - known.y)
    if turned > COSINE and along > ALONG and astray < ASTRAY * arc:
        return True
    log.debug(
        "point refused: cosines %.3g of the tangents, %.3g of the chord; %.3g of an arc from its guess",
        turned,
        along,
        astray / arc,
    )
    return False


def follow(
    curve: SolutionCurve[Equations],
    here: CurvePoint[Equations],
    ends: tuple[float, float],
    arcs: Arcs,
    keep: Callable[[CurvePoint[Equations]], None],
    finish: Callable[[Array, CurvePoint[Equations], float], bool],
) -> float | None:
    """Follow a curve until its parameter reaches an end.

    Parameters
    ----------
    here : CurvePoint
        The start.
    ends : (float, float)
        Parameters below and above at which the curve ends.
    arcs : Arcs
    keep : callable(point)
        Called with each further point.
    finish : callable(guess, point, arc)
        Called near an end, with a guess of y there, the last point, and the arc between them; returns whether the
        solution was found.

    Returns
    -------
    float or None
        The last arc length if the curve was not completed.

    Raises
    ------
    Errors of trial points that remain with the shortest step.
    """
    arc, low, high = arcs.first, *ends

    def tried(action: Callable[..., Result], *arguments: object) -> Result | None:
        try:
            return action(*arguments)
        except curve.retried:
            if arc / 2 < arcs.smallest:
                raise
            return None

    for _ in range(arcs.steps):
        rate = here.tangent[-1]
        end = high if rate > 0 else low
        reach = (end - here.y[-1]) / rate if rate else np.inf
        if reach <= arc:
            if tried(finish, here.y + reach * here.tangent, here, max(reach, arcs.smallest)):
                return None
            arc = reach
        normal = curve.weights(here.equations) * here.tangent
        found = tried(corrected, curve, here.y + arc * here.tangent, normal, here, arc)
        if found is not None and not low < found.y[-1] < high:
            # the plane of the correction extends beyond the end
            if tried(finish, found.y, found, arc):
                return None
            found = None
        if found is None:
            arc /= 2
            log.debug("no point found; arc halved to %.3g", arc)
            if arc < arcs.smallest:
                return arc
            continue
        here = found
        log.debug("parameter %.6g after an arc of %.3g, %d evaluations", here.y[-1], arc, here.iterations)
        keep(here)
        arc = min(arc * (GROWTH if here.iterations <= FEW else CUT), arcs.largest)
    return arc
