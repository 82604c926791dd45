"""Periodic motion of any model with periodic prescribed motions: linearized, nonlinear, and over a range of speeds.

Small vibrations about the nominal motion come from harmonic balance of the linearized equations; the full nonlinear
periodic motion from Newton's method with the same coefficients, evaluated along the current guess, as Jacobian.  If
a range of speeds cannot be completed, the results so far are kept, with a warning that says where and why it stopped.
Source: Schwab and Meijaard, "SPACAR" (2004); Cameron and Griffin (1989) for alternating frequency and time.
"""

from __future__ import annotations

import warnings
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, Generic, TypeVar

import numpy as np

from flexel.base.arrays import Array, ComplexArray
from flexel.base.errors import FlexelError, IncompleteWarning, LinearizationError, PositionError
from flexel.linear.harmonics import (
    Coefficients,
    PeriodicVibration,
    cosine_sine,
    fourier_sum,
    refined,
    spectrum,
)
from flexel.linear.orbits import Orbit, orbit
from flexel.mechanics.core import Core

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
MAX_ITERATIONS = 30
HALVINGS = 4  # halvings of a step in speed
Result = TypeVar("Result")


def periodic_motion(
    system: Core,
    period: float,
    harmonics: int,
    start: ComplexArray | None = None,
    samples: int | None = None,
    accuracy: float | None = None,
) -> tuple[Orbit, PeriodicVibration]:
    """Nonlinear periodic motion by harmonic balance, Newton's method with the analytic Jacobian.

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
    omega, size = 2 * np.pi / period, np.inf
    if start is None:
        X = np.array(orbit(system, period, ns).coefficients.harmonic_balance(k).X)
        X[k] += system.at_rest.q
    else:
        X = np.array(start)
    for _ in range(MAX_ITERATIONS):
        found = orbit(system, period, ns, lambda t, X=X: fourier_sum(X, omega, t - system.at_rest.t))  # type: ignore[misc]
        step = found.coefficients.harmonic_balance(k)
        size, last = float(np.abs(step.X).max()), size
        X = X + step.X
        if size > 1e3 * last or not np.isfinite(size):
            break
        if size < TOLERANCE * max(float(np.abs(X).max()), 1e-3):
            vibration = PeriodicVibration(found.coefficients, X, step.neglected)
            _check(vibration, accuracy)
            return found, vibration
    raise PositionError(
        f"no periodic motion found at {omega:g} rad/s with {k} harmonics in {MAX_ITERATIONS} iterations (last change "
        f"{size:.2g}): start from the solution at a nearby speed, or take more harmonics"
    )


def _check(vibration: PeriodicVibration, accuracy: float | None) -> None:
    if accuracy is None or vibration.error <= accuracy:
        return
    error = LinearizationError(
        f"{vibration.harmonics} harmonics at {vibration.coefficients.omega:g} rad/s neglect about "
        f"{vibration.error:.2g} of the largest amplitude; {accuracy:g} was requested: take more harmonics"
    )
    error.reached = vibration  # type: ignore[attr-defined]
    raise error


@dataclass(frozen=True)
class SpeedFamily:
    """Coefficients of a nominal motion as polynomials in its speed: M; C0 + C1 ω; K, F of second degree.

    Exact where the prescribed motion depends on the phase ω t alone and damping is linear.
    """

    M: Array
    C: Array  # (2, ns, nd, nd)
    K: Array  # (3, ns, nd, nd)
    F: Array  # (3, ns, nd)
    names: tuple[str, ...]

    @classmethod
    def through(cls, orbits: Sequence[Orbit]) -> SpeedFamily:
        """The family through three orbits that differ only in their speed.

        Raises
        ------
        LinearizationError
            The periods are not three different ones, or the coefficients are not such polynomials.
        """
        if len({z.period for z in orbits}) != 3 or len(orbits) != 3:
            raise LinearizationError("a family of speeds needs three orbits of three different periods")
        w = np.array([z.coefficients.omega for z in orbits])
        V = np.linalg.inv(np.vander(w, 3, increasing=True))
        M, C, K, F = (np.array([getattr(z.coefficients, n) for z in orbits]) for n in ("M", "C", "K", "F"))
        polynomial = [np.tensordot(V, z, axes=1) for z in (C, K, F)]
        for name, off, of in (("M", M - M[0], M), ("C", polynomial[0][2] * w.max() ** 2, C)):
            if np.abs(off).max(initial=0.0) > 1e-7 * np.abs(of).max(initial=1e-300):
                raise LinearizationError(
                    f"a family of speeds: {name} is not a polynomial of the speed; the prescribed motion must depend "
                    "on the phase alone"
                )
        return cls(M[0], polynomial[0][:2], polynomial[1], polynomial[2], orbits[0].coefficients.names)

    def at(self, omega: float) -> Coefficients:
        """Coefficients at a speed [rad/s], which must be positive."""
        if not 0 < omega < np.inf:
            raise LinearizationError(f"a speed of {omega:g} rad/s has no period; give positive speeds")
        C, K, F = (_at(z, omega) for z in (self.C, self.K, self.F))
        M, *others = self._spectra
        return Coefficients(omega, self.M, C, K, F, self.names, known=(M, *(_at(z, omega) for z in others)))

    @cached_property
    def _spectra(self) -> list[ComplexArray]:
        """Fourier coefficients of M (ns, nd, nd), and of the polynomials' coefficients of C, K and F."""
        return [spectrum(self.M), *(np.array([spectrum(y) for y in z]) for z in (self.C, self.K, self.F))]


def _at(polynomial: Any, omega: float) -> Any:
    """Value of a polynomial with arrays as coefficients (degree + 1, …)."""
    powers = omega ** np.arange(len(polynomial))
    return (powers @ polynomial.reshape(len(polynomial), -1)).reshape(polynomial.shape[1:])


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
    """Evaluate a function at every speed; stop at the first singular one, and keep the results so far.

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
    """The results before a speed that fails, with a warning."""
    message = f"stopped at {omega:g} rad/s: {error}"
    warnings.warn(message, IncompleteWarning, stacklevel=3)
    return SpeedRange(np.array(speeds[: len(found)], dtype=float), found, message)


def nonlinear_range(
    system: Callable[[float], Core],
    speeds: Sequence[float] | Array,
    harmonics: int,
    measure: Callable[[Orbit, PeriodicVibration], Result],
    accuracy: float | None = None,
) -> SpeedRange[Result]:
    """Nonlinear periodic motions over a range of speeds, each started from its neighbours.

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
    system: Callable[[float], Core],
    omega: float,
    harmonics: int,
    known: list[tuple[float, ComplexArray]],
    accuracy: float | None,
) -> tuple[Orbit, PeriodicVibration]:
    """The motion at a speed, through intermediate speeds if necessary; adds the solutions to `known`."""
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
            if not known or halvings > HALVINGS:
                raise
            parts *= 2
            continue
        known[:] = [*known[-1:], (target, found[1].X)]
        if target == omega:
            return found
        parts -= 1


def _guess(known: list[tuple[float, ComplexArray]], omega: float) -> ComplexArray | None:
    """Linear extrapolation of the last two solutions."""
    if len(known) < 2 or known[-1][0] == known[-2][0]:
        return known[-1][1] if known else None
    (a, X), (b, Y) = known
    return np.asarray(Y + (Y - X) * (omega - b) / (b - a))
