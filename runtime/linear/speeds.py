"""Equations of the curve of nonlinear periodic motions over the speed of prescribed motions and loads.

The unknowns are the Fourier coefficients of the degrees of freedom, and the logarithm of the speed; the derivative by
the speed is analytic.  Source: Cameron and Griffin (1989).
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from flexel.base.arrays import Array, ComplexArray
from flexel.base.errors import PositionError
from flexel.linear.harmonics import Coefficients, PeriodicVibration, symmetric
from flexel.linear.periodic import STALLED_TOLERANCE, TOLERANCE, vibrating
from flexel.model.state import State
from flexel.system import CoreSystem

SPEED_WEIGHT = 5.0  # an arc of 0.1 is a change of the speed by 2 %, or of the motion by 10 %
MIN_AMPLITUDE = 1e-3  # smallest amplitude that matters, in natural scales


@dataclass(frozen=True)
class Balanced:
    """The harmonic balance at one point: the motion, and the solutions for its residual and its rate by the speed.

    Attributes
    ----------
    system : CoreSystem
        At its speed.
    states : list of State
    coefficients : Coefficients
    X : ndarray of complex (2k + 1, nd)
    both : ndarray (n, 2)
    amplitudes : ndarray (n,)
        Scale of each unknown.
    """

    system: CoreSystem
    states: list[State]
    coefficients: Coefficients
    X: ComplexArray
    both: Array
    amplitudes: Array

    @property
    def vibration(self) -> PeriodicVibration:
        """Return the Fourier series with its linearized equations."""
        remainder = self.coefficients.vibration(np.zeros_like(self.X))  # the remaining residual
        return replace(remainder, X=self.X)


class PeriodicCurve:
    """Periodic motions of a system; y = (real and imaginary parts of X_0…X_k, p), speed = omega exp(sense p)."""

    tolerance, stalled, further = TOLERANCE, STALLED_TOLERANCE, 0  # the tolerance is one of the motion
    retried: tuple[type[Exception], ...] = (PositionError,)

    def __init__(self, system: CoreSystem, omega: float, samples: int, harmonics: int, sense: float) -> None:
        self.system, self.omega, self.samples = system, omega, samples
        self.k, self.sense, self.nd = harmonics, sense, system.roles.nd
        self.floor = MIN_AMPLITUDE * system.kinematics.scales(system.roles.dynamic)

    def pack(self, X: ComplexArray) -> Array:
        """Return the unknowns for Fourier coefficients; both halves of a series contain the same numbers."""
        half = X[self.k :]
        return np.concatenate([half.real.ravel(), half[1:].imag.ravel()])

    def unpack(self, unknowns: Array) -> ComplexArray:
        """Return the Fourier coefficients (2k + 1, nd) for the unknowns."""
        return symmetric(unknowns.reshape(2 * self.k + 1, self.nd))

    def equations(self, y: Array, last: Balanced | None) -> Balanced:
        """Evaluate the balance at y."""
        factor, X = float(np.exp(self.sense * y[-1])), self.unpack(y[:-1])
        system = self.system.time_scaled(factor)
        orbit = vibrating(system, X, 2 * np.pi / (self.omega * factor), self.samples)
        forces = orbit.coefficients.F, self.sense * orbit.force_by_speed()
        both = np.column_stack(
            [-self.pack(response) for response in orbit.coefficients.responses(self.k, *forces)]
        )
        return Balanced(system, orbit.states, orbit.coefficients, X, both, self._amplitudes(X))

    def _amplitudes(self, X: ComplexArray) -> Array:
        """Return, for each unknown, the root mean square of the oscillation of its degree of freedom."""
        oscillation = np.delete(X, self.k, axis=0)
        size = np.maximum(np.sqrt((np.abs(oscillation) ** 2).sum(axis=0)), self.floor)
        return np.tile(size, 2 * self.k + 1)

    def sign(self, _: Balanced) -> int:
        """Return zero: the sign is unknown, as only the solutions of the balance are kept."""
        return 0

    def unstable(self, _: Balanced) -> None:
        """Return nothing: stability is judged by multipliers."""

    def weights(self, equations: Balanced) -> Array:
        """Return the weights of relative changes: the mean square over the degrees of freedom, and the speed."""
        both_halves = np.concatenate([np.ones(self.nd), np.full(2 * self.k * self.nd, 2.0)])
        return np.append(both_halves / equations.amplitudes**2 / max(self.nd, 1), SPEED_WEIGHT**2)

    def error(self, equations: Balanced) -> float:
        """Find the shortest way to the curve, by the linearized balance."""
        weights, (residual, rate) = self.weights(equations), equations.both.T
        dp = -(weights[:-1] * residual) @ rate / (weights[:-1] @ rate**2 + weights[-1])
        step = np.append(residual + rate * dp, dp)
        return float(np.sqrt(weights @ step**2))

    def solve(self, equations: Balanced) -> Array:
        """Return the solutions for the residual and for its derivative by the parameter."""
        return equations.both

    def allows(self, step: Array, arc: float) -> bool:
        """Whether the speed changes by no more than a few arcs."""
        return bool(np.isfinite(step).all() and abs(step[-1]) * SPEED_WEIGHT < 4 * arc)
