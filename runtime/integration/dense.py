"""Dense output of DOP853: y(t) within a step, by four more evaluations or ten, made on demand."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from itertools import accumulate
from operator import mul

import numpy as np
from numpy.polynomial import legendre
from scipy.integrate._ivp import dop853_coefficients as tableau

from flexel.base.arrays import Array
from flexel.base.errors import FlexelError
from flexel.engine.rotations import Rotations
from flexel.integration.segments import DenseOutput
from flexel.mechanics.kinematics import Kinematics
from flexel.mechanics.states import between
from flexel.model.snapshot import Snapshot

UNRELIABLE = 15.0  # largest defect of an interpolation times the step, in allowed errors: three to four times its error
NODES = 0.5 + 0.5 * np.array(
    [-1.0, *np.sort(legendre.Legendre.basis(7).deriv().roots().real), 1.0]
)  # Lobatto's
CHECKED = 5  # the one of them, 0.8, where the defect of the interpolation of order 7 is largest
MIDDLE = 0.5
RISE = np.array(
    [0.5, 0.6, 0.0, -0.1]
)  # 3 s² - 2 s³ for the part s of a step, in Legendre polynomials of 2 s - 1
FITTED = np.linalg.inv(legendre.legvander(2 * NODES - 1, NODES.size - 1))
UP, DOWN = np.arange(2, 9) // 2, np.arange(1, 8) // 2  # powers of the part that has passed, and of the rest
A, B, C = tableau.A[:12, :12], tableau.B, tableau.C[:12]


@dataclass(frozen=True)
class Interpolant(DenseOutput):
    """Interpolation in a step of DOP853; where it does not satisfy the equations, steps from its start.

    The step control does not see the error of an interpolation: it may be thirty times the error at the end,
    and more in steps that stability limits, or with vibrations that a jump of forces has excited.  It is
    found from the defect, y' less the rates that belong to y.  Where it is large, the rates at Lobatto's
    nodes are integrated, which has order 8 (a step of a Picard iteration); where that does not satisfy the
    equations either, the step is repeated up to the requested time.

    Attributes
    ----------
    kinematics : Kinematics
        The degrees of freedom of the step.
    first, last : Snapshot
        Its ends.
    y0, y1 : ndarray (ny,)
        Values at the ends.
    K : ndarray (13, ny)
        Rates at the stages and the end.
    rotations : Rotations
        Orientations that turn freely.
    w0, w1 : ndarray (3 count,)
        Their angular velocities at the ends.
    W : ndarray (13, 4 count)
        Rates of these, and of the Euler parameters that are not in y.
    allowed : ndarray (ny + 4 count,)
        Errors that were allowed in the step, of y, of angular velocities and of these Euler parameters.
    """

    kinematics: Kinematics
    first: Snapshot
    last: Snapshot
    y0: Array
    y1: Array
    K: Array
    rotations: Rotations
    w0: Array
    w1: Array
    W: Array
    allowed: Array

    @cached_property
    def _cubic(self) -> Array:
        """Coefficients (3, ny + 4 count) of the cubic through both ends with the rates there."""
        h, begin = self.last.t - self.first.t, self._begin
        change = np.concatenate([self.y1, self.w1, self.last.x[self.rotations.others]]) - begin
        r0, r1 = (h * np.concatenate([self.K[i], self.W[i]]) for i in (0, 12))
        return np.array([change, r0 - change, 2 * change - (r1 + r0)])

    @cached_property
    def _coefficients(self) -> Array:
        """Coefficients (7, ny + 4 count) of the interpolation, as in SciPy."""
        h, begin = self.last.t - self.first.t, self._begin
        K = np.concatenate([np.hstack([self.K, self.W]), np.zeros((3, begin.size))])
        for s, (a, c) in enumerate(zip(tableau.A[13:], tableau.C[13:], strict=True), start=13):
            K[s] = self._rates(self.first.t + c * h, self._placed(begin + h * (K[:s].T @ a[:s])))
        return np.concatenate([self._cubic, h * (tableau.D @ K)])

    @cached_property
    def _begin(self) -> Array:
        """What is interpolated, at the start: y, angular velocities, and Euler parameters that are not in y."""
        return np.concatenate([self.y0, self.w0, self.first.x[self.rotations.others]])

    def _placed(self, found: Array) -> Array:
        """Return the variables y of what was interpolated."""
        if not self.w0.size:
            return found
        y, w, other = np.split(found, np.cumsum([self.y0.size, self.w0.size]))
        return self.rotations.place(y, w, other)

    def _rates(self, t: float, y: Array) -> Array:
        """Return the rates of what is interpolated, at a time in the step."""
        guess = between(self.first, self.last, t)
        choice = self.kinematics.given(t)
        choice.reset()
        self.kinematics.check(choice.evaluate(t, y, guess.x, guess.e), t)
        if not self.w0.size:
            return choice.dy.copy()
        work, r = choice.work, self.rotations
        return np.concatenate([choice.dy, r.spins(work.x, work.a), work.v[r.others]])

    @cached_property
    def _rates_checked(self) -> Array | None:
        """Rates that belong to the interpolation of order 7 where it is checked; None if no position does."""
        return self._rates_of(NODES[CHECKED], self._begin + _shares(NODES[CHECKED]) @ self._coefficients)

    def _rates_of(self, part: float, found: Array) -> Array | None:
        """Return the rates for an interpolation at a part of the step; None if no position belongs to it."""
        try:
            return self._rates(self.first.t + part * (self.last.t - self.first.t), self._placed(found))
        except FlexelError:
            return None

    def _satisfied(self, slope: Array, rates: Array | None) -> bool:
        """Whether the derivative of an interpolation by the part of the step belongs to these rates."""
        if rates is None:
            return False
        defect = (slope - (self.last.t - self.first.t) * rates) / self.allowed
        return bool(np.max(np.abs(defect), initial=0.0) <= UNRELIABLE)

    @cached_property
    def _reliable(self) -> bool:
        """Whether the interpolation of order 7 satisfies the equations."""
        return self._satisfied(_slopes(NODES[CHECKED]) @ self._coefficients, self._rates_checked)

    @cached_property
    def _finer(self) -> Array | None:
        """Coefficients (9, ny + 4 count) of order 8, of Legendre polynomials; None if they are no better."""
        h, begin, K = self.last.t - self.first.t, self._begin, [np.hstack([self.K[0], self.W[0]])]
        for i, part in enumerate(NODES[1:-1].tolist(), start=1):
            found = begin + _shares(part) @ self._coefficients
            rates = self._rates_checked if i == CHECKED else self._rates_of(part, found)
            if rates is None:
                return None
            K.append(rates)
        K.append(np.hstack([self.K[12], self.W[12]]))
        finer = legendre.legint(FITTED @ K, scl=0.5 * h, lbnd=-1)
        finer[: RISE.size] += np.outer(RISE, self._coefficients[0] - legendre.legval(1.0, finer))
        finer[0] += begin
        rates = self._rates_of(MIDDLE, np.asarray(legendre.legval(0.0, finer)))
        slope = np.asarray(2 * legendre.legval(0.0, legendre.legder(finer)))
        return finer if self._satisfied(slope, rates) else None

    def _stepped(self, h: float) -> Array:
        """Return the values (ny,) at the end of a step of this length [s] from the start."""
        begin = self._begin
        K = np.zeros((12, begin.size))
        K[0] = np.hstack([self.K[0], self.W[0]])
        for s in range(1, 12):
            K[s] = self._rates(self.first.t + C[s] * h, self._placed(begin + h * (A[s, :s] @ K[:s])))
        return self._placed(begin + h * (B @ K))

    def roughly(self, t: float) -> Array:
        """Return the values (ny,) of the cubic at a time [s] in the step, without any evaluation."""
        part = (t - self.first.t) / (self.last.t - self.first.t)
        return self._placed(self._begin + _shares(part)[:3] @ self._cubic)

    def __call__(self, t: float) -> Array:
        """Return the values (ny,) at a time [s] in the step."""
        if t == self.last.t:
            return self.y1
        part = (t - self.first.t) / (self.last.t - self.first.t)
        if self._reliable:
            return self._placed(self._begin + _shares(part) @ self._coefficients)
        if self._finer is None:
            return self._stepped(t - self.first.t)
        return self._placed(np.asarray(legendre.legval(2 * part - 1, self._finer)))


def _shares(part: float) -> Array:
    """Return the shares (7,) of the coefficients of order 7 in the values at a part of the step."""
    rest = 1 - part
    return np.array([*accumulate((part, rest, part, rest, part, rest, part), mul)])


def _slopes(part: float) -> Array:
    """Return the shares in the derivative with respect to the part, within the step."""
    return np.asarray(_shares(part) * (UP / part - DOWN / (1 - part)))
