"""Stages of DOP853 in C, with predicted coordinates: what single steps and the states within them share."""

from __future__ import annotations

from typing import Any

import numpy as np
from scipy.integrate._ivp import dop853_coefficients as tableau

from flexel.base.arrays import Array
from flexel.engine.coordinate_work import CoordinateWork
from flexel.engine.lanes import aligned
from flexel.engine.rotations import LISTS, Rotations
from flexel.engine.structs import Struct
from flexel.generated._kernels import ffi
from flexel.integration.inputs import give
from flexel.integration.knots import Interval
from flexel.mechanics.kinematics import Kinematics
from flexel.model.snapshot import Snapshot

A, B, C = (np.ascontiguousarray(z, dtype=float) for z in (tableau.A[:12, :12], tableau.B, tableau.C[:12]))
E3, E5 = (np.ascontiguousarray(z, dtype=float) for z in (tableau.E3, tableau.E5))
TIMES = np.append(C, 1.0)  # of the stages and the end
LATER_STAGES: list[float] = TIMES[1:-1].tolist()
UNNOTICED = 0.01  # errors of positions and of linear algebra, relative to rtol, which the control of steps does not see
TABLEAU = {"A": A, "B": B, "C": C, "E3": E3, "E5": E5}


class Stages(Struct):
    """The struct of runge_kutta.h for one choice of degrees of freedom, without its tolerances.

    Parameters
    ----------
    kinematics : Kinematics
    choice : CoordinateWork
        Arrays of this choice of degrees of freedom.
    rows : int
        Number of stages: 13, or FLEXEL_INSIDE.

    Attributes
    ----------
    y, K, w, w_rates : ndarray (ny,), (rows, ny), (3 count,), (rows, 3 count)
        Values at the start and rates at the stages, of y and of angular velocities.
    V, turning : ndarray (rows, nf), (rows, periodic.size)
        Rates of coordinates and of periodic deformations.
    periodic : ndarray of int
        Deformations with a period.
    """

    def __init__(self, kinematics: Kinematics, choice: CoordinateWork, rows: int) -> None:
        super().__init__(ffi.new("flexel_dop853 *"))
        self.kinematics, self.choice = kinematics, choice
        c, s, roles = self.struct, kinematics.structure, kinematics.roles
        ny = roles.nq + roles.nd + s.nz
        self.periodic = np.flatnonzero(s.period[: s.m])
        c.ny = ny
        for name, array in TABLEAU.items():
            setattr(c, name, self.pointer(array))
        np_, nf = self.periodic.size, s.nf
        self.y, self.y_new = self.new("y", ny), self.new("y_new", ny)
        self.x, self.x_new = self.new("x", s.n), self.new("x_new", s.n)
        self.e, self.e_new = self.new("e", np_), self.new("e_new", np_)
        self.K = self.new("K", rows * ny).reshape(rows, ny)
        self.V = self.new("V", rows * nf).reshape(rows, nf)
        self.W = self.new("W", rows * nf).reshape(rows, nf)
        self.turning = self.new("turning", rows * np_).reshape(rows, np_)
        self.space = self.new("space", max(2 * ny, nf))
        c.ngiven = self.choice.motion.size + self.choice.loads.size
        self._given = self.new("given", rows * c.ngiven).reshape(rows, -1)
        self.given_stages = self._given[1 : TIMES.size]  # prescribed motions and loads, but for the start
        self.rotations = r = Rotations.of(s, roles)
        for name in LISTS:
            setattr(c.rotations, name, self.integers(getattr(r, name).flatten()))
        c.rotations.count = r.count
        found = {name: self._of_rotations(name, size) for name, size in r.sizes(rows).items()}
        self.w, self.w_new, self.w_rates = found["w"], found["w_new"], found["W"].reshape(rows, -1)
        self.w_scale = found["scale"]

    def _of_rotations(self, name: str, size: int) -> Array:
        """A new array of zeros (size,) for a field of rotations.h."""
        array = aligned(max(size, 1))[:size]
        setattr(self.struct.rotations, name, self.pointer(array))
        return array

    def place(self, now: Snapshot, y: Array, rtol: float) -> None:
        """Begin at an instant; later results depend on nothing computed before."""
        self.choice.reset(UNNOTICED * rtol)
        self.choice.struct.accept = 0.0
        self.y[:], self.x[:], self.e[:] = y, now.x, now.e[self.periodic]

    def give_stages(self, interval: Interval, t: float, h: float) -> None:
        """Set prescribed motions and loads at the stages of a step, in an interval where these are smooth."""
        if self._given.size:
            given = self.given_stages
            give(self.kinematics, interval, given[:-1], [t + part * h for part in LATER_STAGES])
            given[-1] = given[-2]  # the last stage is at the end

    @property
    def varies(self) -> bool:
        """Whether prescribed motions or loads vary with time."""
        return bool(self.kinematics.roles.motions) or not self.kinematics.loads.steady

    @property
    def _structs(self) -> tuple[Any, Any, Any]:
        return self.choice.work.struct, self.choice.struct, self.struct
