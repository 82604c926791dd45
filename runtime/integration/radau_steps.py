"""Single steps of Radau IIA of order 5 in C, and their dense output; see radau.h.

With steps of length h the estimates of the local error are of order h^4, and the error of the motion is of order h^5:
so the tolerance of the estimate is TIGHT rtol^(4/5), and the error is proportional to rtol.
Source: Hairer and Wanner (1996), IV.8; Gustafsson (1994).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from flexel.base.arrays import Array
from flexel.base.copies import Portable
from flexel.engine.choice import Choice
from flexel.engine.lapack import lapack
from flexel.engine.structs import Struct
from flexel.generated._kernels import ffi, lib
from flexel.integration.followed import TRAVEL, turning_weights
from flexel.integration.inputs import give
from flexel.integration.knots import Knots
from flexel.integration.minimal import natural_scales_of_y
from flexel.integration.radau_tableau import COLLOCATION, CORRECTION, NODES, PAIR, REAL, WEIGHTS, T
from flexel.mechanics.kinematics import Kinematics
from flexel.structure.moment import Moment

POWERS = np.arange(1, 5)
TIGHT = 0.25  # the program RADAU5 has 0.1 rtol^(2/3), which is the same at 1e-3 and looser below
LOOSEST = 0.03  # tolerance of the iteration, relative to that of the estimate
ROUNDING = 10 * np.finfo(float).eps
FIRST = 1e-6  # first step, relative to the time left, where the rates say nothing
LEAST_FIRST = 1e-9  # the same at least: values of y that are rounding errors, or zero, ask for less
KNOWN = 1e-5  # sizes of y and its rates, relative to the tolerance, from which they say something
PART = 0.01  # of y, by which it changes in the first step
METHOD = {
    "T": T,
    "inverse": np.linalg.inv(T),
    "C": NODES,
    "b": WEIGHTS[2],
    "collocation": COLLOCATION,
    "correction": CORRECTION,
}


class Collocation(Struct):
    """The struct of radau.h for one choice of degrees of freedom.

    Parameters
    ----------
    kinematics : Kinematics
    rtol : float
    atol : ndarray (ny,)
        In the units of y.

    Attributes
    ----------
    y, f : ndarray (ny,)
        Values and rates at the start of the step.
    J : ndarray (ny, ny)
        The Jacobian, to be filled in when a step asks for it.
    """

    def __init__(self, kinematics: Kinematics, rtol: float, atol: Array) -> None:
        super().__init__(ffi.new("flexel_radau *"))
        self.kinematics = kinematics
        self.choice = Choice(kinematics.evaluation.work, kinematics.lists)  # dense output does not change it
        c, s, roles, ny = self.struct, kinematics.structure, kinematics.roles, atol.size
        c.ny, c.nd, c.nk, c.size = ny, roles.nd, roles.nq - roles.nd, ny - roles.nd
        c.mu, c.pair[0], c.pair[1] = REAL, PAIR.real, PAIR.imag
        c.real_factorize, c.complex_factorize = (lapack(z, "flexel_getrf") for z in ("dgetrf", "zgetrf"))
        self._tight = TIGHT * rtol ** (4 / 5)
        c.rtol, c.tolerance = self._tight, max(ROUNDING / self._tight, min(LOOSEST, self._tight**0.5))
        self._atol = atol * (self._tight / rtol)
        natural = natural_scales_of_y(kinematics)
        constant = METHOD | {"atol": self._atol, "natural": natural, "turning": turning_weights(s)}
        for name, array in constant.items():
            setattr(c, name, self.pointer(np.ascontiguousarray(array)))
        c.travel, c.stale = TRAVEL, True
        self._vectors(ny, int(c.size))
        c.ngiven = self.choice.motion.size + self.choice.loads.size
        self._given = self.new("given", 4 * c.ngiven).reshape(4, -1)

    def _vectors(self, ny: int, size: int) -> None:
        s = self.kinematics.structure
        self.y, self.f, _, self.estimate, _, self.scale = (
            self.new(name, ny) for name in ("y", "f", "largest", "estimate", "f_new", "scale")
        )
        self.x, self.v = self.new("x", s.n), self.new("v", s.n)
        self.e, self.ed = self.new("e", s.m), self.new("ed", s.m)
        self.Z, _, _ = (self.new(name, 3 * ny).reshape(3, ny) for name in ("Z", "W", "F"))
        self.new("V", 3 * s.nf)
        self.new("space", 3 * ny)
        self.powers = self.new("powers", 4 * ny).reshape(4, ny)
        self.J = self.new("J", ny * ny).reshape(ny, ny)
        self.new("real_factors", size * size)
        self.new("complex_factors", 2 * size * size)
        for name in ("real_pivots", "complex_pivots"):
            setattr(self.struct, name, self.integers(np.zeros(size, dtype=np.int32)))

    @property
    def _structs(self) -> tuple[Any, Any, Any]:
        return self.choice.work.struct, self.choice.struct, self.struct

    def start(self, now: Moment, y: Array, knots: Knots) -> None:
        """Begin at an instant; the Jacobian and the largest values so far are kept.

        Raises
        ------
        PositionError, ConstraintError, InertiaError
            If the rates cannot be evaluated.
        """
        self._knots = knots
        self.choice.reset()
        self.choice.struct.accept = 0.0
        self.struct.t = now.t
        self.y[:], self.x[:], self.v[:], self.e[:], self.ed[:] = y, now.x, now.v, now.e, now.ed
        give(self.kinematics, knots, self._given[3:], [now.t])
        self.kinematics.check(lib.flexel_radau_begin(*self._structs), now.t, self.choice)

    def first_step(self, left: float) -> float:
        """A first step [s] in which y changes by a hundredth of itself."""
        scale = self._atol + self._tight * np.abs(self.y)
        value, rate = _norm(self.y / scale), _norm(self.f / scale)
        known = value > KNOWN and rate > KNOWN
        return max(PART * value / rate, LEAST_FIRST * left) if known else FIRST * left

    def step(self) -> int:
        """One step: zero, or a code of radau.h or of an evaluation that failed."""
        while True:
            code = int(lib.flexel_radau_step(*self._structs))
            if code != lib.FLEXEL_RADAU_INPUTS:
                return code
            c = self.struct
            give(self.kinematics, self._knots, self._given[:3], [c.t + part * c.h for part in NODES])

    def look_again(self) -> None:
        """The Jacobian is that of the start of the step, as far as it is known."""
        c = self.struct
        c.fresh, c.stale, c.factorized = True, False, 0.0

    def refuse(self, factor: float) -> None:
        """Try a step that is shorter by a factor."""
        lib.flexel_radau_refuse(self.struct, factor)

    def end(self, t: float) -> Moment:
        """Position and rates at the end of the last step."""
        work = self.choice.work
        return Moment(t, work.x.copy(), work.v.copy(), work.e.copy(), work.w[: work.e.size].copy())

    def accept(self) -> Polynomial:
        """Continue from the end of the last step; its dense output."""
        c, t, y = self.struct, self.struct.t, self.y.copy()
        lib.flexel_radau_accept(self.choice.work.struct, c)
        return Polynomial(t, c.last_h, y, self.powers.copy(), self.y.copy())


@dataclass(frozen=True)
class Polynomial(Portable):
    """Dense output of a step: the collocation polynomial, corrected so that its rates at the start are right too.

    The defect of the collocation polynomial is a multiple of (s - c1)(s - c2)(s - 1) to its leading order, and known
    at the start from the estimate of the error.  Its integral is subtracted: the local error is of order 5 instead of
    4, and stiff components are filtered as in the estimate.

    Attributes
    ----------
    t, h : float
        Start and length of the step [s].
    y : ndarray (ny,)
        Values at its start.
    coefficients : ndarray (4, ny)
        Of the powers 1 to 4 of the part of the step that has passed.
    end : ndarray (ny,)
        Values at its end.
    """

    t: float
    h: float
    y: Array
    coefficients: Array
    end: Array

    def __call__(self, t: float) -> Array:
        """Values (ny,) at a time [s]."""
        part = (t - self.t) / self.h
        return self.end if part == 1.0 else np.asarray(self.y + part**POWERS @ self.coefficients)


def _norm(x: Array) -> float:
    return float(np.linalg.norm(x) / max(x.size, 1) ** 0.5)
