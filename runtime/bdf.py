"""Implicit integration by the backward differentiation formulas of SUNDIALS (IDA), a cross-check of the others.

Coordinates, rates, multipliers and internal states z of laws are integrated with the constraints on the
level of accelerations, stabilized so that their violation dies out within steps of the tolerance; the
multipliers are left out of the error control.  The linear equations are solved by GMRES with the sparse saddle-point matrix as its
preconditioner.  Source: Hindmarsh et al. (2005); Baumgarte (1972) for the stabilization.
Imports numpy, the balance, and lazily scikit-sundae, an optional package.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from flexel.balance import Balance, Matrix, Saddle, SaddlePattern
from flexel.errors import FlexelError, ModelError
from flexel.implicit import Control, Run
from flexel.locallaws import ImplicitStep
from flexel.state import State
from flexel.structure import Array

if TYPE_CHECKING:
    from flexel.system import System

FREE = 1e20  # absolute tolerance of what is left out of the error control
PULL = 300.0  # rate at which violations of the constraints die out, times the duration of the motion
MAX_ORDER = 5


class Equations(Saddle):
    """The equations of motion as a differential-algebraic system F(t, y, y') = 0 with y = (x, v, mu, z)."""

    def __init__(self, system: System, start: State, pull: float) -> None:
        super().__init__(system)
        self.pull = pull
        self.pattern = SaddlePattern(self.local, self.force_rows, self.force_rows)
        self.near, self._fixed = start.e, start
        self.evaluations = self.factorizations = self.iterations = 0
        nf, nc = self.structure.nf, self.force_rows.size
        self.ends = np.cumsum([0, nf, nf, nc, self.structure.nz])

    def split(self, y: Array) -> list[Array]:
        """(x, v, mu, z) of y, or their rates of y'."""
        return [y[a:b] for a, b in zip(self.ends[:-1], self.ends[1:], strict=True)]

    def first(self, start: State) -> tuple[Array, Array]:
        """y and y' at a state."""
        nf, none = self.structure.nf, np.zeros(self.force_rows.size)
        y = np.concatenate([start.x[:nf], start.v[:nf], self.multipliers(start), start.z])
        return y, np.concatenate([start.v[:nf], start.a[:nf], none, start.zd])

    def at(self, t: float, y: Array, yp: Array) -> Balance:
        """The balance of forces at y, y'."""
        nf = self.structure.nf
        x, v, mu, z = self.split(y)
        full = [np.concatenate([part, fixed[nf:]]) for part, fixed in ((x, self._fixed.x), (v, self.rest))]
        a = np.concatenate([self.split(yp)[1], self.rest[nf:]])
        self.z = np.array(z)
        return self.balance(t, full[0], full[1], a, np.array(mu), self.near)

    def residual(self, t: float, y: Array, yp: Array, out: Array) -> None:
        """F(t, y, y')."""
        b, rates = self.at(t, y, yp), self.split(yp)
        self.evaluations += 1
        nh, rows, p = self.roles.holonomic.size, self.force_rows, self.pull
        inner = rows < self.first_coordinate
        w, wd = (np.concatenate([deformation, coordinates]) for deformation, coordinates in (
            (b.w, b.v), (self.local.convective(b.x, b.v) + self.local.rates(b.J, b.a), b.a)
        ))  # fmt: skip
        rate, second = w[rows], wd[rows]
        del inner
        if self.roles.motions:
            _, ud, udd = self.roles.motion(t)
            driven = slice(self.roles.rigid.size, nh)
            rate[driven] -= ud
            second[driven] -= udd
        held = second + p * rate
        held[:nh] += p * rate[:nh] + p * p * b.gap
        parts = (rates[0] - self.split(y)[1], b.r, held, rates[3] - b.laws.zd)
        out[:] = np.concatenate(parts)
