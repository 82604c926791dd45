"""Dense output of DOP853: y(t) within a step, by three more evaluations, made on demand."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from scipy.integrate._ivp import dop853_coefficients as tableau

from flexel.base.arrays import Array
from flexel.base.copies import Portable
from flexel.mechanics.kinematics import Kinematics
from flexel.mechanics.states import between
from flexel.structure.moment import Moment


@dataclass(frozen=True)
class Interpolant(Portable):
    """Interpolation of order 7 in a step of DOP853.

    Attributes
    ----------
    kinematics : Kinematics
        The degrees of freedom of the step.
    first, last : Moment
        Its ends.
    y0, y1 : ndarray (ny,)
        Values at the ends.
    K : ndarray (13, ny)
        Rates at the stages and the end.
    """

    kinematics: Kinematics
    first: Moment
    last: Moment
    y0: Array
    y1: Array
    K: Array

    @cached_property
    def _coefficients(self) -> Array:
        """Coefficients (7, ny) of the interpolation, as in SciPy."""
        h = self.last.t - self.first.t
        K = np.concatenate([self.K, np.zeros((3, self.y0.size))])
        for s, (a, c) in enumerate(zip(tableau.A[13:], tableau.C[13:], strict=True), start=13):
            K[s] = self._rates(self.first.t + c * h, self.y0 + h * (K[:s].T @ a[:s]))
        change = self.y1 - self.y0
        F = np.empty((7, self.y0.size))
        F[0] = change
        F[1] = h * K[0] - change
        F[2] = 2 * change - h * (K[12] + K[0])
        F[3:] = h * (tableau.D @ K)
        return F

    def _rates(self, t: float, y: Array) -> Array:
        """Rates of y at a time in the step."""
        near = between(self.first, self.last, t)
        choice = self.kinematics.given(t)
        choice.reset()
        self.kinematics.check(choice.evaluate(t, y, near.x, near.e), t)
        return choice.dy.copy()

    def __call__(self, t: float) -> Array:
        """Values (ny,) at a time [s] in the step."""
        if t == self.last.t:
            return self.y1
        part = (t - self.first.t) / (self.last.t - self.first.t)
        y = np.zeros_like(self.y0)
        for i, f in enumerate(self._coefficients[::-1]):
            y = (y + f) * (part if i % 2 == 0 else 1 - part)
        return y + self.y0
