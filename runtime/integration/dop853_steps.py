"""Single steps of DOP853 in C, with predicted coordinates; see runge_kutta.h."""

from __future__ import annotations

from typing import Any

import numpy as np
from scipy.integrate._ivp import dop853_coefficients as tableau

from flexel.base.arrays import Array
from flexel.engine.coordinate_work import CoordinateWork
from flexel.engine.covered import Covered
from flexel.engine.lanes import aligned
from flexel.engine.rotations import LISTS, Rotations
from flexel.engine.structs import Struct
from flexel.generated._kernels import ffi, lib
from flexel.integration.inputs import give
from flexel.integration.knots import Knots
from flexel.mechanics.kinematics import Kinematics
from flexel.model.snapshot import Snapshot

ACCEPT = 0.01  # error of a position below which J is not evaluated again, relative to rtol, where no law acts
A, B, C = (np.ascontiguousarray(z, dtype=float) for z in (tableau.A[:12, :12], tableau.B, tableau.C[:12]))
E3, E5 = (np.ascontiguousarray(z, dtype=float) for z in (tableau.E3, tableau.E5))
TIMES = np.append(C, 1.0)  # of the stages and the end
TABLEAU = {"A": A, "B": B, "C": C, "E3": E3, "E5": E5}


def accepted_error(kinematics: Kinematics, rtol: float) -> float:
    """Error of a position below which J and the deformations are kept from before the last correction.

    Zero where laws act: the error of a deformation times a large stiffness is noise in the accelerations, to which the
    step control would respond with short steps.
    """
    return 0.0 if kinematics.structure.laws else ACCEPT * rtol


class Steps(Struct):
    """The struct of runge_kutta.h for one choice of degrees of freedom."""

    def __init__(
        self,
        kinematics: Kinematics,
        now: Snapshot,
        y: Array,
        rtol: float,
        atol: Array,
        knots: Knots,
        covered: Covered,
    ) -> None:
        super().__init__(ffi.new("flexel_dop853 *"))
        self.kinematics = kinematics
        self.choice = CoordinateWork(
            kinematics.evaluation.work, kinematics.lists
        )  # dense output does not change it
        c, s = self.struct, kinematics.structure
        self._periodic = np.flatnonzero(s.period[: s.m])
        c.ny, c.rtol = y.size, rtol
        for name, array in (*TABLEAU.items(), ("atol", atol)):
            setattr(c, name, self.pointer(array))
        c.weight = self.pointer(kinematics.lists.step_weight)
        nq, nf = self._periodic.size, s.nf
        self.y, self.y_new = self.new("y", y.size), self.new("y_new", y.size)
        self.x, self.x_new = self.new("x", s.n), self.new("x_new", s.n)
        self.e, self.e_new = self.new("e", nq), self.new("e_new", nq)
        self.K = self.new("K", 13 * y.size).reshape(13, y.size)
        self.V = self.new("V", 13 * nf).reshape(13, nf)
        self.W = self.new("W", 13 * nf).reshape(13, nf)
        self.turning = self.new("turning", 13 * nq).reshape(13, nq)
        self.new("space", max(2 * y.size, nf))
        self.determinant = np.zeros(TIMES.size)
        self._determinant = self.pointer(self.determinant)
        motion, loads = self.choice.motion.size, self.choice.loads.size
        c.ngiven = motion + loads
        self._given = self.new("given", 13 * (motion + loads)).reshape(13, -1)
        self.scale = self.new("scale", y.size)
        self.rotations = r = Rotations.of(s, kinematics.roles)
        for name in LISTS:
            setattr(c.rotations, name, self.integers(getattr(r, name).flatten()))
        c.rotations.count = r.count
        c.apart = self.pointer(r.apart(kinematics.lists.step_weight))
        found = {name: self._of_rotations(name, size) for name, size in r.sizes.items()}
        self.w, self.w_new, self.w_rates = found["w"], found["w_new"], found["W"].reshape(13, -1)
        self.w_scale = found["scale"]
        self.start(now, y, knots, covered)

    def _of_rotations(self, name: str, size: int) -> Array:
        """A new array of zeros (size,) for a field of rotations.h."""
        array = aligned(max(size, 1))[:size]
        setattr(self.struct.rotations, name, self.pointer(array))
        return array

    def start(self, now: Snapshot, y: Array, knots: Knots, covered: Covered) -> None:
        """Begin at an instant; later results depend on nothing computed before, except what the motion has covered."""
        self._knots, self.covered, self.struct.covered = knots, covered, covered.struct
        self.choice.reset(self.struct.rtol)
        self.choice.struct.accept = 0.0
        self.y[:], self.x[:], self.e[:] = y, now.x, now.e[self._periodic]
        covered.begin(y)

    @property
    def first_order(self) -> bool:
        """Whether the position matrix is factorized in the order of pivots that was found first."""
        P = self.choice.struct.P
        return bool(P.lu == P.first)

    def use_first_order(self) -> None:
        """Return to that order."""
        lib.flexel_matrix_reset(self.choice.P)

    def begin(self, t: float) -> None:
        """Compute the rates at the start."""
        give(self.kinematics, self._knots, self._given[:1], [t])
        self.kinematics.check(lib.flexel_dop853_begin(*self._structs, t), t, self.choice)

    def step(self, t: float, h: float, careful: bool) -> int:
        """Take one step; return the code of what failed, or zero.

        A careful step finds positions to rounding, and keeps the sizes of the determinants.
        """
        choice = self.choice.struct
        accepted = self.covered.accepted_error(accepted_error(self.kinematics, self.struct.rtol))
        choice.accept = 0.0 if careful else accepted
        self.struct.determinant = self._determinant if careful else ffi.NULL
        if careful:
            self.begin(t)
        if self._given.size:
            give(self.kinematics, self._knots, self._given[1:], [t + part * h for part in TIMES[1:]])
        return int(lib.flexel_dop853_step(*self._structs, t, h))

    @property
    def _structs(self) -> tuple[Any, Any, Any]:
        return self.choice.work.struct, self.choice.struct, self.struct

    def end(self, t: float) -> Snapshot:
        """Return position and rates at the end of the last step."""
        work = self.choice.work
        work.rates()
        return Snapshot(t, self.x_new.copy(), work.v.copy(), work.e.copy(), work.w[: work.e.size].copy())

    def accept(self) -> None:
        """Continue from the end of the last step."""
        lib.flexel_dop853_accept(self.choice.work.struct, self.struct)
