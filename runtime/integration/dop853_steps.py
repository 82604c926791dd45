"""Single steps of DOP853 in C, with predicted coordinates; see runge_kutta.h."""

from __future__ import annotations

import numpy as np

from flexel.base.arrays import Array
from flexel.engine.coordinate_work import CoordinateWork
from flexel.engine.covered import Covered
from flexel.generated._kernels import ffi, lib
from flexel.integration.dop853_stages import TIMES, UNNOTICED, Stages
from flexel.integration.inputs import give
from flexel.integration.knots import Knots
from flexel.mechanics.kinematics import Kinematics
from flexel.model.snapshot import Snapshot


def accepted_error(kinematics: Kinematics, rtol: float) -> float:
    """Error of a position below which J and the deformations are kept from before the last correction.

    Zero where laws act: the error of a deformation times a large stiffness is noise in the accelerations, to which the
    step control would respond with short steps.
    """
    return 0.0 if kinematics.structure.laws else UNNOTICED * rtol


class Steps(Stages):
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
        own = CoordinateWork(kinematics.evaluation.work, kinematics.lists)  # dense output does not change it
        super().__init__(kinematics, own, TIMES.size)
        c, weight = self.struct, kinematics.lists.step_weight
        c.rtol, c.atol, c.weight = rtol, self.pointer(atol), self.pointer(weight)
        c.apart = self.pointer(self.rotations.apart(weight))
        self.scale = self.new("scale", y.size)
        self.determinant = np.zeros(TIMES.size)
        self._determinant = self.pointer(self.determinant)
        self.start(now, y, knots, covered)

    def start(self, now: Snapshot, y: Array, knots: Knots, covered: Covered) -> None:
        """Begin at an instant; later results depend on nothing computed before, except what the motion has covered."""
        self._knots, self.covered, self.struct.covered = knots, covered, covered.struct
        self.place(now, y, self.struct.rtol)
        covered.begin(y, self.kinematics.roles.dofs)

    def begin(self, t: float) -> None:
        """Compute the rates at the start."""
        give(self.kinematics, self._knots.interval, self._given[:1], [t])
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
        self.give_stages(self._knots.interval, t, h)
        return int(lib.flexel_dop853_step(*self._structs, t, h))

    def end(self, t: float) -> Snapshot:
        """Return position and rates at the end of the last step."""
        work = self.choice.work
        work.rates()
        return Snapshot(t, self.x_new.copy(), work.v.copy(), work.e.copy(), work.w[: work.e.size].copy())

    def accept(self) -> None:
        """Continue from the end of the last step."""
        lib.flexel_dop853_accept(self.choice.work.struct, self.struct)
