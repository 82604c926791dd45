"""Computes periodic motions under periodic prescribed motions: linearized, nonlinear, and over a range of speeds.

Small vibrations about the nominal motion follow from harmonic balance of the linearized equations; the full nonlinear
periodic motion from Newton's method, with the same coefficients along the current iterate as its Jacobian.  If
a range of speeds cannot be completed, the results so far are kept, with a warning that says where and why it stopped.
Source: Schwab and Meijaard, "SPACAR" (2004); Cameron and Griffin (1989) for alternating frequency and time.
"""

from __future__ import annotations

import warnings
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Generic, TypeVar

import numpy as np

from flexel.base.arrays import Array, ComplexArray
from flexel.base.callers import outside
from flexel.base.errors import FlexelError, IncompleteWarning, LinearizationError, PositionError
from flexel.linear.families import SpeedFamily
from flexel.linear.harmonics import (
    Coefficients,
    PeriodicVibration,
    check_accuracy,
    cosine_sine,
    fourier_sum,
    refined,
)
from flexel.linear.orbits import Orbit, orbit
from flexel.mechanics.newton import newton
from flexel.system import CoreSystem

__all__ = [
    "Coefficients",
    "Orbit",
    "PeriodicVibration",
    "SpeedFamily",
    "SpeedRange",
    "cosine_sine",
    "fourier_sum",
    "nonlinear_range",
    "orbit",
    "periodic_motion",
    "refined",
    "speed_range",
]

TOLERANCE = 1e-9  # largest last change, relative to the largest amplitude; convergence is quadratic
STALLED_TOLERANCE = 1e-7  # the same, when rounding prevents further progress
MAX_GROWTH = 1e6  # a step whose change is larger by this factor does not converge
MAX_ITERATIONS = 30
MAX_HALVINGS = 4  # halvings of a step in speed
Result = TypeVar("Result")


def periodic_motion(
    system: CoreSystem,
    period: float,
    harmonics: int,
    start: ComplexArray | None = None,
    samples: int | None = None,
    accuracy: float | None = None,
) -> tuple[Orbit, PeriodicVibration]:
    """Compute the nonlinear periodic motion by harmonic balance, using Newton's method with the analytic Jacobian.

    Parameters
    ----------
    period : float
        [s]
    harmonics : int
    start : ndarray of complex (2 harmonics + 1, nd), optional
        First guess of the Fourier coefficients; the linearized solution about the nominal motion by default.
    samples : int, optional
        Times in the period; 4 per harmonic and 4 more by default.
    accuracy : float, optional
        Largest permitted amplitude of the neglected harmonics, relative to the largest amplitude.

    Returns
    -------
    Orbit, PeriodicVibration
        The motion, and its Fourier coefficients with the estimate of the neglected amplitude.

    Raises
    ------
    PositionError
        If Newton's method does not converge; reports what was reached.
    LinearizationError
        If the harmonics are too few for the accuracy; the attribute ``reached`` holds the solution.
    """
    ns, k = samples or 4 * harmonics + 4, harmonics
    size = system.kinematics.scales(system.roles.dynamic)
    if start is None:
        nominal = orbit(system, period, ns).coefficients
        first = np.zeros((2 * k + 1, size.size), dtype=complex)
        if not nominal.balanced(size):
            first += nominal.harmonic_balance(k).X
        first[k] += system.at_rest.q
    else:
        first = np.array(start)

    def evaluate(X: ComplexArray) -> tuple[tuple[Orbit, ComplexArray], float]:
        motion = vibrating(system, X, period, ns)
        # Where a Floquet multiplier is one, the change that rounding errors would cause is undetermined.
        if motion.coefficients.balanced(size):
            return (motion, np.zeros_like(X)), 0.0
        step = motion.coefficients.responses(k, motion.coefficients.F)[0]
        return (motion, step), relative_size(step, X)

    def move(X: ComplexArray, equations: tuple[Orbit, ComplexArray]) -> ComplexArray | None:
        step = equations[1]
        return None if relative_size(step, X) > MAX_GROWTH else X + step

    found = newton(first, evaluate, move, tolerance=TOLERANCE, stalled=STALLED_TOLERANCE, most=MAX_ITERATIONS)
    motion, step = found.equations
    if not found.converged:
        raise PositionError(
            f"no periodic motion found at {2 * np.pi / period:g} rad/s with {k} harmonics in {found.iterations} "
            f"iterations (last change {np.abs(step).max():.2g}): start from the solution at a nearby speed, or take "
            "more harmonics"
        )
    vibration = motion.coefficients.vibration(step)
    vibration = replace(vibration, X=found.point + step)
    check_accuracy(vibration, accuracy)
    return motion, vibration


def relative_size(change: ComplexArray, X: ComplexArray) -> float:
    """Return the largest change of a Fourier coefficient, relative to the largest coefficient."""
    return float(np.abs(change).max()) / max(float(np.abs(X).max()), 1e-3)


def vibrating(system: CoreSystem, X: ComplexArray, period: float, samples: int) -> Orbit:
    """Return the motion for Fourier coefficients X (2k + 1, nd) of the degrees of freedom, and its residual force."""
    t0, omega = system.at_rest.t, 2 * np.pi / period
    return orbit(system, period, samples, lambda t: fourier_sum(X, omega, t - t0))


@dataclass(frozen=True)
class SpeedRange(Generic[Result]):
    """Results over a range of speeds.

    Attributes
    ----------
    speeds : ndarray
        Speeds reached [rad/s], in the requested order.
    results : list
        One for each speed.
    message : str
        Where it stopped and why; empty if the whole range was completed.
    """

    speeds: Array
    results: list[Result]
    message: str = ""


def speed_range(family: Callable[[float], Result], speeds: Sequence[float] | Array) -> SpeedRange[Result]:
    """Evaluate a function at every speed; stop at the first singular speed, and keep the results so far.

    Examples
    --------
    >>> speed_range(lambda w: family.at(w).harmonic_balance(12), speeds)  # doctest: +SKIP
    """
    found: list[Result] = []
    for omega in speeds:
        try:
            found.append(family(float(omega)))
        except FlexelError as error:
            return _cut_short(speeds, found, omega, error)
    return SpeedRange(np.array(speeds, dtype=float), found)


def _cut_short(
    speeds: Sequence[float] | Array, found: list[Result], omega: float, error: FlexelError
) -> SpeedRange[Result]:
    """Return the results up to a speed that fails, with a warning."""
    message = f"stopped at {omega:g} rad/s: {error}"
    warnings.warn(message, IncompleteWarning, stacklevel=outside())
    return SpeedRange(np.array(speeds[: len(found)], dtype=float), found, message)


def nonlinear_range(
    system: Callable[[float], CoreSystem],
    speeds: Sequence[float] | Array,
    harmonics: int,
    measure: Callable[[Orbit, PeriodicVibration], Result],
    accuracy: float | None = None,
) -> SpeedRange[Result]:
    """Compute nonlinear periodic motions over a range of speeds, each started from an adjacent one.

    Parameters
    ----------
    system : callable
        The system at a speed [rad/s].
    speeds : sequence of float
        Speeds in the order of continuation [rad/s].
    measure : callable(orbit, vibration)
        The result stored for each motion.
    accuracy : float, optional
        As in `periodic_motion`.

    Notes
    -----
    Steps that fail are halved up to four times; intermediate speeds are not stored.
    """
    known: list[tuple[float, ComplexArray]] = []
    found: list[Result] = []
    for omega in np.asarray(speeds, dtype=float):
        try:
            motion, vibration = _reach(system, float(omega), harmonics, known, accuracy)
        except FlexelError as error:
            return _cut_short(speeds, found, omega, error)
        found.append(measure(motion, vibration))
    return SpeedRange(np.array(speeds, dtype=float), found)


def _reach(
    system: Callable[[float], CoreSystem],
    omega: float,
    harmonics: int,
    known: list[tuple[float, ComplexArray]],
    accuracy: float | None,
) -> tuple[Orbit, PeriodicVibration]:
    """Compute the motion at a speed, through intermediate speeds if necessary; add the solutions to `known`."""
    if not 0 < omega < np.inf:
        raise LinearizationError(f"a speed of {omega:g} rad/s has no period; give positive speeds")
    parts, halvings = 1, 0
    while True:
        last = known[-1][0] if known else omega
        target = omega if not known else last + (omega - last) / parts
        try:
            found = periodic_motion(
                system(target), 2 * np.pi / target, harmonics, _guess(known, target), None, accuracy
            )
        except PositionError:
            halvings += 1
            if not known or halvings > MAX_HALVINGS:
                raise
            parts *= 2
            continue
        known[:] = [*known[-1:], (target, found[1].X)]
        if target == omega:
            return found
        parts -= 1


def _guess(known: list[tuple[float, ComplexArray]], omega: float) -> ComplexArray | None:
    """Extrapolate the last two solutions linearly."""
    if len(known) < 2 or known[-1][0] == known[-2][0]:
        return known[-1][1] if known else None
    (a, X), (b, Y) = known
    return np.asarray(Y + (Y - X) * (omega - b) / (b - a))
