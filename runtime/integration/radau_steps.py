"""Single steps of Radau IIA of order 5 in C, and their dense output; see radau.h.

With steps of length h the estimates of the local error are of order h^4, and the error of the motion is of order h^5:
so the tolerance of the estimate is TIGHT rtol^(4/5), and the error is proportional to rtol.
Source: Hairer and Wanner (1996), IV.8; Gustafsson (1994).
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from flexel.base.arrays import Array, Index
from flexel.base.quaternions import matrix
from flexel.engine.angles import Angles, placed
from flexel.engine.coordinate_work import CoordinateWork
from flexel.engine.covered import Covered
from flexel.engine.lapack import lapack
from flexel.engine.rotations import Rotations
from flexel.engine.structs import Struct
from flexel.engine.turns import Turns
from flexel.generated._kernels import ffi, lib
from flexel.integration.followed import TRAVEL, turning_weights
from flexel.integration.inputs import give
from flexel.integration.knots import Knots
from flexel.integration.radau_saddle import SaddleFactors
from flexel.integration.radau_tableau import COLLOCATION, CORRECTION, NODES, PAIR, REAL, WEIGHTS, T
from flexel.integration.segments import Variables
from flexel.integration.step_method import MINOR, natural_scales_of_y
from flexel.mechanics.kinematics import Kinematics
from flexel.model.snapshot import Snapshot

PLACES: list[float] = NODES.tolist()
POWERS = np.arange(1, 5)
TIGHT = 0.25  # the program RADAU5 has 0.1 rtol^(2/3), which is the same at 1e-3 and looser below
LOOSEST = 0.03  # tolerance of the iteration, relative to that of the estimate
ROUNDING = 10 * np.finfo(float).eps
FIRST = 1e-6  # first step, relative to the time left, where the rates say nothing
LEAST_FIRST = 1e-9  # the same at least: values of y that are rounding errors, or zero, ask for less
KNOWN = 1e-5  # sizes of y and its rates, relative to the tolerance, from which they say something
FINEST = 7e-15  # error of coordinates, relative to their size or natural scale, that shortens no step: an iteration
# whose changes are rounding errors ends there, see radau_stages.c
KEPT = 1e-10  # error of a position that one correction with factors of another stage brings down to rounding
PART = 0.01  # of y, by which it changes in the first step
METHOD = {
    "T": T,
    "inverse": np.linalg.inv(T),
    "C": NODES,
    "b": WEIGHTS[2],
    "collocation": COLLOCATION,
    "correction": CORRECTION,
}


def estimated(rtol: float) -> float:
    """Return the tolerance of the estimates of the local error."""
    return float(TIGHT * rtol ** (4 / 5))


class Collocation(Struct):
    """The struct of radau.h for one choice of degrees of freedom.

    Parameters
    ----------
    kinematics : Kinematics
    rtol : float
    atol : ndarray (ny,)
        In the units of y.
    minor : float
        Of a degree of freedom or rate relative to the largest ones, that counts as zero.
    saddle : SaddleFactors, optional
        Sparse factors for these degrees of freedom, instead of dense ones.

    Attributes
    ----------
    y, f : ndarray (ny,)
        Values and rates at the start of the step.
    turns : Turns
        Orientations that turn freely, of which y, f and J have rotations and angular velocities.
    angles : Angles
        Those with a single Euler parameter, of which they have angles.
    J : ndarray (ny, ny)
        The Jacobian, to be filled in when a step asks for it; empty with sparse factors.
    """

    def __init__(
        self,
        kinematics: Kinematics,
        rtol: float,
        atol: Array,
        minor: float = MINOR,
        saddle: SaddleFactors | None = None,
    ) -> None:
        super().__init__(ffi.new("flexel_radau *"))
        self.kinematics = kinematics
        self.choice = CoordinateWork(
            kinematics.evaluation.work, kinematics.lists
        )  # dense output does not change it
        c, s, roles, ny = self.struct, kinematics.structure, kinematics.roles, atol.size
        c.ny, c.nd, c.nk, c.size = ny, roles.nd, roles.nq - roles.nd, ny - roles.nd
        c.mu, c.pair[0], c.pair[1] = REAL, PAIR.real, PAIR.imag
        c.real_factorize, c.complex_factorize = (lapack(z, "flexel_getrf") for z in ("dgetrf", "zgetrf"))
        r = Rotations.of(s, roles)
        self.turns = saddle.turns if saddle is not None else Turns(r)
        self.angles = saddle.angles if saddle is not None else Angles(s, roles)
        c.turns, c.angles = self.turns.struct, self.angles.struct
        self._turning = np.concatenate([r.dof.ravel(), self.angles.dof])
        twice = np.ones(ny)
        twice[self._turning] = twice[roles.nq + self._turning] = (
            2.0  # Euler parameters turn by half of an angle
        )
        self._rtol, self._tight = rtol, estimated(rtol)
        c.rtol, c.tolerance = self._tight, max(ROUNDING / self._tight, min(LOOSEST, self._tight**0.5))
        self._atol = atol * twice * (self._tight / rtol)
        natural = natural_scales_of_y(kinematics) * twice
        constant = METHOD | {"atol": self._atol, "natural": natural, "turning": turning_weights(s)}
        for name, array in constant.items():
            setattr(c, name, self.pointer(np.ascontiguousarray(array)))
        c.travel, c.minor, c.stale, c.finest = TRAVEL, minor, True, FINEST
        self.choice.struct.kept = KEPT
        self.saddle = saddle
        if saddle is not None:
            c.saddle = saddle.struct
        self._vectors(ny, int(c.size))
        self._matrices(ny, int(c.size))
        c.ngiven = self.choice.motion.size + self.choice.loads.size
        self._given = self.new("given", 4 * c.ngiven).reshape(4, -1)
        at = np.concatenate([r.at.ravel(), self.angles.at.ravel()])
        self.new("known", at.size)
        known = self.choice.struct
        known.nknown, known.known, known.known_x = at.size, self.integers(at), c.known

    def _vectors(self, ny: int, size: int) -> None:
        s = self.kinematics.structure
        self.y, self.f, self.largest, self.estimate, _, self.scale, _ = (
            self.new(name, ny) for name in ("y", "f", "largest", "estimate", "f_new", "scale", "placed")
        )
        self.x, self.v = self.new("x", s.n), self.new("v", s.n)
        self.e, self.ed = self.new("e", s.m), self.new("ed", s.m)
        self.Z, _, _ = (self.new(name, 3 * ny).reshape(3, ny) for name in ("Z", "W", "F"))
        self.new("V", 3 * s.nf)
        self.new("space", 3 * ny)
        self.new("divided", 2 * int(self.struct.nd))
        self.powers = self.new("powers", 4 * ny).reshape(4, ny)

    def _matrices(self, ny: int, size: int) -> None:
        """Space for those that are dense."""
        if self.saddle is not None:
            ny = size = 0
        self.J = self.new("J", ny * ny).reshape(ny, ny)
        self.new("real_factors", size * size)
        self.new("complex_factors", 2 * size * size)
        for name in ("real_pivots", "complex_pivots"):
            setattr(self.struct, name, self.integers(np.zeros(size, dtype=np.int32)))

    @property
    def _structs(self) -> tuple[Any, Any, Any]:
        return self.choice.work.struct, self.choice.struct, self.struct

    def start(self, now: Snapshot, y: Array, knots: Knots, covered: Covered) -> None:
        """Begin at an instant, with y in Euler parameters; the Jacobian and the largest values so far are kept.

        Raises
        ------
        PositionError, ConstraintError, InertiaError
            If the rates cannot be evaluated.
        """
        self._knots, self._covered, self.struct.covered = knots, covered, covered.struct
        self.choice.reset(self._rtol)
        self.choice.struct.accept = 0.0
        self.struct.t = now.t
        covered.begin(y, self.kinematics.roles.dofs)
        self.y[:], self.x[:], self.v[:], self.e[:], self.ed[:] = y, now.x, now.v, now.e, now.ed
        give(self.kinematics, knots.interval, self._given[3:], [now.t])
        self.kinematics.check(lib.flexel_radau_begin(*self._structs), now.t, self.choice)

    def take_over(self, before: Collocation) -> None:
        """Keep what is known from other degrees of freedom: sizes of variables, and how far frames have turned.

        To be called before the start.
        """
        here, there = self._common(before)
        self.largest[here] = before.largest[there]
        self.angles.take_over(before.angles)
        self.turns.keep_first(before.turns)

    def resume(self, before: Collocation) -> None:
        """Go on as if the degrees of freedom had not changed, if only Euler parameters have changed places.

        To be called after the start, which is that of the step that other degrees of freedom would have taken.
        """
        c, old = self.struct, before.struct
        here, there = self._common(before)
        known = self.angles.known and before.angles.known
        if here.size < self.y.size or there.size < before.y.size or c.t != old.t or not known:
            return
        self.powers[:, here], c.last_h, c.last_error = before.powers[:, there], old.last_h, old.last_error
        if self.saddle is None:
            self.J[np.ix_(here, here)] = before.J[np.ix_(there, there)]
            self.turns.take_over(before.turns)
            c.stale = old.stale

    def _common(self, other: Collocation) -> tuple[Index, Index]:
        """Numbers of the variables that both have."""
        numbers = {name: i for i, name in enumerate(other._names)}
        found = [(i, numbers[name]) for i, name in enumerate(self._names) if name in numbers]
        here, there = np.array(found, dtype=np.intp).reshape(-1, 2).T
        return here, there

    @cached_property
    def _names(self) -> list[tuple[int, ...]]:
        """What the variables are: value, rate or internal state, of a quantity, or of a frame along one of its axes."""
        roles, r = self.kinematics.roles, self.turns.rotations
        names: list[tuple[int, ...]] = [(0, int(i)) for i in roles.dofs]
        names += [(1, int(i)) for i in roles.dynamic]
        names += [(2, i) for i in range(self.y.size - len(names))]
        for at, dof in zip(r.at, r.dof, strict=True):
            for axis, i in enumerate(dof.tolist()):
                names[i], names[r.nq + i] = (3, int(at[0]), axis), (4, int(at[0]), axis)
        for at, i in zip(self.angles.at, self.angles.dof.tolist(), strict=True):
            names[i], names[r.nq + i] = (5, int(at[0])), (6, int(at[0]))
        return names

    def first_step(self, left: float) -> float:
        """Return a first step [s] in which y changes by a hundredth of itself."""
        size = np.abs(self.y)
        size[self._turning] = 1.0
        scale = self._atol + self._tight * size
        value, rate = _norm(size / scale), _norm(self.f / scale)
        known = value > KNOWN and rate > KNOWN
        return max(PART * value / rate, LEAST_FIRST * left) if known else FIRST * left

    def step(self) -> int:
        """Take one step; return zero, or a code of radau.h or of an evaluation that failed."""
        while True:
            code = int(lib.flexel_radau_step(*self._structs))
            if code != lib.FLEXEL_RADAU_INPUTS:
                return code
            self.give_stages()

    def give_stages(self) -> None:
        """Set prescribed motions and loads at the stages of the trial that waits for them."""
        c = self.struct
        give(self.kinematics, self._knots.interval, self._given[:3], [c.t + part * c.h for part in PLACES])

    @property
    def now(self) -> Snapshot:
        """The start of the step."""
        return Snapshot(self.struct.t, self.x.copy(), self.v.copy(), self.e.copy(), self.ed.copy())

    def look(self, A: Array) -> None:
        """Take the Jacobian of the start of the step, of y in Euler parameters."""
        turns = self.turns
        J = turns.jacobian(A, self.y, self.f)
        if turns.rotations.count and self.choose_axes(turns.acting_in(J)):
            J = turns.jacobian(A, self.y, self.f)
        self.J[:] = self.angles.jacobian(J, self.y, self.f)

    def choose_axes(self, acting: Array) -> bool:
        """Choose the axes of orientations by what acts on them; return whether any have changed."""
        found = self.turns.steadier(acting, self.struct.h)
        for i in found.tolist():
            self.turns.change_axes(i, self.y, self.f, self.powers)
        return bool(found.size)

    def look_again(self) -> None:
        """Take the known Jacobian as that of the start of the step."""
        lib.flexel_radau_look_again(self.struct)

    def refuse(self, factor: float) -> None:
        """Try a step that is shorter by a factor."""
        lib.flexel_radau_refuse(self.struct, factor)

    def end(self, t: float) -> Snapshot:
        """Return position and rates at the end of the last step."""
        work = self.choice.work
        return Snapshot(t, work.x.copy(), work.v.copy(), work.e.copy(), work.w[: work.e.size].copy())

    def accept(self, first: Snapshot, last: Snapshot) -> StagePolynomial:
        """Continue from the end of the last step; return its dense output between its ends."""
        c, t, y, L = self.struct, self.struct.t, self.y.copy(), self.turns.start.copy()
        end, charts, space = y + self.Z[2], self.angles.charts, self.turns.space.copy()
        lib.flexel_radau_accept(*self._structs)
        powers, rotations = self.powers.copy(), self.turns.rotations
        return StagePolynomial(
            self.kinematics, first, last, t, c.last_h, y, powers, end, rotations, L, space, charts
        )


@dataclass(frozen=True)
class StagePolynomial(Variables):
    """Dense output of a step: the collocation polynomial, corrected so that its rates at the start are right too.

    The defect of the collocation polynomial is a multiple of (s - c1)(s - c2)(s - 1) to its leading order, and known
    at the start from the estimate of the error.  Its integral is subtracted: the local error is of order 5 instead of
    4, and stiff components are filtered as in the estimate.

    Attributes
    ----------
    t, h : float
        Start and length of the step [s].
    y : ndarray (ny,)
        Values at its start; of orientations, rotations from there and angular velocities, and angles.
    coefficients : ndarray (4, ny)
        Of the powers 1 to 4 of the part of the step that has passed.
    end : ndarray (ny,)
        Values at its end.
    rotations : Rotations
        Orientations that turn freely.
    L : ndarray (count, 4)
        Their Euler parameters at the start.
    space : ndarray of int (count,)
        Whether their values are along the axes of space.
    charts : ndarray (angles, 3)
        What the angles are, see `Angles.charts`.
    """

    t: float
    h: float
    y: Array
    coefficients: Array
    end: Array
    rotations: Rotations
    L: Array
    space: NDArray[np.int32]
    charts: Array

    def __call__(self, t: float) -> Array:
        """Values (ny,) of y = (q, q_d', z) at a time [s]."""
        part = (t - self.t) / self.h
        found = self.end if part == 1.0 else self.y + part**POWERS @ self.coefficients
        r, found = self.rotations, placed(found, self.charts, self.rotations.nq)
        if not r.count:
            return found
        p, w, y = found[r.dof], found[r.nq + r.dof], found.copy()
        along = np.flatnonzero(self.space)
        for i in along:
            p[i] = matrix(self.L[i]).T @ p[i]
        L = r.turned(self.L, p)
        for i in along:
            w[i] = matrix(L[i]).T @ w[i]
        y[r.dof] = np.take_along_axis(L, r.part, axis=1)
        return r.place(y, w.ravel(), L[np.arange(r.count), r.rest])


def _norm(x: Array) -> float:
    return float(np.linalg.norm(x) / max(x.size, 1) ** 0.5)
