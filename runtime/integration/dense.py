"""Dense output of DOP853: the state at a time within a step, by four more stages or ten, which are found on demand.

Every value within a step is y + h sum of share[j] K[j] with the rates K at its stages, and the same shares give
coordinates and angular velocities from their rates.  Source: Hairer, Norsett and Wanner (1993), II.6; coefficients are
those of SciPy.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from itertools import accumulate
from operator import mul
from typing import NamedTuple

import numpy as np
from numpy.polynomial import legendre
from scipy.integrate._ivp import dop853_coefficients as tableau

from flexel.base.arrays import Array
from flexel.generated._kernels import ffi, lib
from flexel.integration.dop853_stages import UNNOTICED, Stages
from flexel.integration.dop853_steps import Steps
from flexel.integration.inputs import give
from flexel.integration.knots import Interval
from flexel.integration.segments import DenseOutput
from flexel.mechanics.kinematics import Kinematics
from flexel.model.snapshot import Snapshot

# Largest defect of an interpolation times the step, in allowed errors. Where it is looked at, it is 1.7 to 10 times the
# error in any step that is stable, whether rates depend on the state or on time alone; it vanishes elsewhere in some.
UNRELIABLE = 20.0
NODES = 0.5 + 0.5 * np.array(
    [-1.0, *np.sort(legendre.Legendre.basis(7).deriv().roots().real), 1.0]
)  # Lobatto's
CHECKED = 6  # the one of them, 0.94, where the defect of the interpolation of order 7 is largest
LOOKED_AT = 0.62  # part of the step where the defect of that of order 8 is looked at
RISE = np.array(
    [0.5, 0.6, 0.0, -0.1]
)  # 3 s² - 2 s³ for the part s of a step, in Legendre polynomials of 2 s - 1
FITTED = np.linalg.inv(legendre.legvander(2 * NODES - 1, NODES.size - 1))
UP, DOWN = np.arange(2, 9) // 2, np.arange(1, 8) // 2  # powers of the part that has passed, and of the rest
INSIDE = int(lib.FLEXEL_INSIDE)
EXTRA, CHECK, LOBATTO, FINAL = (
    13,
    16,
    17,
    INSIDE - 1,
)  # first stages of each kind; the last one shows the defect of order 8


def _shares(part: float) -> Array:
    """Return the shares (7,) of the polynomials of order 7 in the values at a part of the step."""
    rest = 1 - part
    return np.array([*accumulate((part, rest, part, rest, part, rest, part), mul)])


def _slopes(part: float) -> Array:
    """Return the shares in the derivative with respect to the part, within the step."""
    return np.asarray(_shares(part) * (UP / part - DOWN / (1 - part)))


def _legendre(x: float) -> Array:
    """Return Legendre's polynomials (9,) at a place."""
    found = [1.0, x]
    for n in range(1, NODES.size):
        found.append(((2 * n + 1) * x * found[n] - n * found[n - 1]) / (n + 1))
    return np.array(found)


def _of_order_7() -> Array:
    """Coefficients (7, INSIDE) of the polynomials, over h, of the rates at the stages."""
    found = np.zeros((7, INSIDE))
    change, start, end = np.zeros((3, INSIDE))
    change[:12], start[0], end[12] = tableau.B, 1.0, 1.0
    found[:3] = change, start - change, 2 * change - (start + end)
    found[3:, :CHECK] = tableau.D
    return found


def _of_order_8() -> Array:
    """Coefficients (9, INSIDE), over h, of Legendre polynomials: the integral of the rates at Lobatto's nodes.

    It is corrected so that it ends where the step ends.
    """
    places = [0, *range(LOBATTO, FINAL), CHECK, 12]
    rates = np.zeros((NODES.size, INSIDE))
    rates[np.arange(NODES.size), places] = 1.0
    found = np.asarray(legendre.legint(FITTED @ rates, scl=0.5, lbnd=-1), dtype=float)
    found[: RISE.size] += np.outer(RISE, SEVENTH[0] - legendre.legval(1.0, found))
    return found


SEVENTH = _of_order_7()
EIGHTH = _of_order_8()
ROWS = np.zeros((INSIDE - EXTRA, INSIDE))  # of the stages after the end of the step
ROWS[:3, : tableau.A.shape[1]] = tableau.A[EXTRA:]
PLACED = np.array([*tableau.C[EXTRA:], NODES[CHECKED], *np.delete(NODES[1:-1], CHECKED - 1), LOOKED_AT])
for _number, _part in enumerate(PLACED[3:-1].tolist(), start=3):
    ROWS[_number] = _shares(_part) @ SEVENTH
ROWS[-1] = _legendre(2 * LOOKED_AT - 1) @ EIGHTH
SLOPE_7 = _slopes(NODES[CHECKED]) @ SEVENTH  # where it is checked
SLOPE_8 = np.asarray(2 * legendre.legval(2 * LOOKED_AT - 1, legendre.legder(EIGHTH)), dtype=float)


class Inside(Stages):
    """The stages of one step, and those for the states within it."""

    def __init__(self, kinematics: Kinematics) -> None:
        super().__init__(kinematics, kinematics.choice, INSIDE)
        self._of: Interpolant | None = None  # whose stages these are
        self._known = 0  # number of stages
        self._rows, self._parts, self._row = self.pointer(ROWS), self.pointer(PLACED), np.zeros(INSIDE)
        self._own_row = self.pointer(self._row)
        self._slopes = {CHECK: self.pointer(SLOPE_7), FINAL: self.pointer(SLOPE_8)}

    def take(self, step: Interpolant, live: Stages) -> None:
        """Take the stages of a step that was just found."""
        lib.flexel_dop853_take(self.choice.work.struct, self.struct, live.struct)
        self.holds(step)

    def holds(self, step: Interpolant) -> None:
        """These are the stages of a step, up to its end."""
        self._of, self._known = step, EXTRA

    def again(self, step: Interpolant, h: float, given: Array | None = None) -> None:
        """Take the stages of a step anew, or those of a shorter one from its start, of length h [s].

        Prescribed motions and loads at the stages are those that are given, if they are known.
        """
        self._of, t = None, step.first.t
        self.place(step.first, step.y0, step.rtol)
        self.K[0], self.w[:], self.w_rates[0] = step.rates0, step.w0, step.w_rates0
        self.V[0], self.turning[0] = step.first.v[: self.V.shape[1]], step.first.ed[self.periodic]
        if given is None:
            self.give_stages(step.interval, t, h)
        else:
            self.given_stages[:] = given
        self.choice.struct.accept = step.accept
        code = lib.flexel_dop853_again(*self._structs, t, h)
        self._restore()
        self.kinematics.check(code, t + h, self.choice)
        if h == step.h:
            self.holds(step)

    def _restore(self) -> None:
        """Let positions be found to rounding again, by all who use these arrays."""
        self.choice.struct.accept = 0.0
        self.choice.reset()

    def knows(self, step: Interpolant, stages: int) -> bool:
        """Find the stages of a step up to a number of them; whether there are all."""
        if self._of is not step:
            self.again(step, step.h)
        return all(self._finds(step, end) for end in (LOBATTO, INSIDE) if self._known < end <= stages)

    def _finds(self, step: Interpolant, end: int) -> bool:
        """Find the stages up to the next kind; whether there are all."""
        first, t, h = self._known, step.first.t, step.h
        self.choice.reset(UNNOTICED * step.rtol)  # the same, whether the stages before were taken or found
        own = slice(first - EXTRA, end - EXTRA)
        if self._given.size:
            times = [t + part * h for part in PLACED[own].tolist()]
            give(self.kinematics, step.interval, self._given[first:end], times)
        rows, parts = self._rows + own.start * INSIDE, self._parts + own.start
        failed = lib.flexel_dop853_more(*self._structs, t, h, first, end, rows, parts)
        self._restore()
        if failed:
            return False
        self._known = end
        return True

    def satisfied(self, step: Interpolant, stage: int) -> bool:
        """Whether the derivative of an interpolation belongs to the rates at a stage."""
        work, allowed = self.choice.work.struct, ffi.from_buffer("double[]", step.allowed)
        defect = lib.flexel_dop853_defect(work, self.struct, step.h, self._slopes[stage], stage, allowed)
        return bool(defect <= UNRELIABLE)

    def at(self, step: Interpolant, t: float, shares: Array) -> tuple[Snapshot, Array]:
        """Return the instant at a time [s] for shares of the rates at the stages, and the internal states."""
        choice = self.choice
        choice.reset()
        if self._given.size:
            give(self.kinematics, step.interval, self._given[:1], [t])
        self._row[: shares.size] = shares
        code = lib.flexel_dop853_locate(*self._structs, t, step.h, self._own_row, shares.size)
        self.kinematics.check(code, t, choice)
        return self.moment(step, t, self.space)

    def moment(self, step: Interpolant, t: float, y: Array) -> tuple[Snapshot, Array]:
        """Return the instant that the workspace holds, with rates of deformations nearby, and the internal states."""
        work, roles = self.choice.work, self.kinematics.roles
        e, first = work.e.copy(), roles.nq + roles.nd
        own = roles.dofs < e.size
        e[roles.dofs[own]] = y[: roles.nq][own]
        z = y[first : first + work.z.size].copy()
        return Snapshot(t, work.x.copy(), work.v.copy(), e, step.first.ed), z


class Allowed(NamedTuple):
    """What the control of a step of DOP853 has allowed at its end; errors allowed within it follow from that.

    Attributes
    ----------
    scale, of_rotations : ndarray (ny,), (4 count,)
        Allowed errors at its end, of y and of orientations that turn freely.
    y1, ranges : ndarray (ny,)
        Values at its end, and how far they have moved.
    part : float
        Of the tolerances, that the step got.
    relative : bool
        Whether tolerances are relative to the motion.
    """

    scale: Array
    of_rotations: Array
    y1: Array
    ranges: Array
    part: float
    relative: bool

    def inside(self, y0: Array, rates: slice, rtol: float) -> Array:
        """Return errors allowed of an interpolation from y0 (ny,) to y1, whose rates are known by a slice.

        Rates that hardly change are as exact relative to their range, as all that is stored: at its end a step is more
        exact than it has to be. An error that only rounding explains is not more of an interpolation.
        """
        allowed = self.scale.copy()
        if self.relative:
            size = np.maximum(np.abs(y0), np.abs(self.y1))
            of_range = self.part * rtol * np.minimum(size, self.ranges)[rates]
            allowed[rates] = (allowed[rates] - of_range) / UNRELIABLE + of_range
        return allowed


@dataclass(frozen=True, eq=False)
class Interpolant(DenseOutput):
    """Interpolation in a step of DOP853; where it does not satisfy the equations, steps from its start.

    The step control does not see the error of an interpolation: it may be thirty times the error at the end,
    and more in steps that stability limits, or with vibrations that a jump of forces has excited.  It is
    found from the defect, y' less the rates that belong to y.  Where it is large, the rates at Lobatto's
    nodes are integrated, which has order 8 (a step of a Picard iteration); where that does not satisfy the
    equations either, the step is repeated up to the requested time.

    Attributes
    ----------
    y0, rates0 : ndarray (ny,)
        Values at the start, and their rates.
    w0, w_rates0 : ndarray (3 count,)
        Angular velocities of orientations that turn freely, at the start, and their rates.
    z1 : ndarray (nz,)
        Internal states at the end.
    of_step : Allowed
    interval : Interval
        In which the functions of time were evaluated.
    rtol, accept : float
        With which positions were found.
    """

    y0: Array
    rates0: Array
    w0: Array
    w_rates0: Array
    z1: Array
    of_step: Allowed
    interval: Interval
    rtol: float
    accept: float

    @property
    def h(self) -> float:
        """Length of the step [s]."""
        return self.last.t - self.first.t

    @cached_property
    def allowed(self) -> Array:
        """Errors (ny + 4 count,) allowed of y, of angular velocities and of Euler parameters that are not in y."""
        roles, given = self.kinematics.roles, self.of_step
        of_y = given.inside(self.y0, slice(roles.nq, roles.nq + roles.nd), self.rtol)
        return self.inside.rotations.allowed(of_y, given.of_rotations) / given.part

    @property
    def inside(self) -> Inside:
        """The stages of this thread, which may be those of another step."""
        return self.kinematics.own(Inside)

    @cached_property
    def _order(self) -> int:
        """Order of the interpolation that satisfies the equations; zero if neither does."""
        inside = self.inside
        if not inside.knows(self, LOBATTO):
            return 0
        if inside.satisfied(self, CHECK):
            return 7
        return 8 if inside.knows(self, INSIDE) and inside.satisfied(self, FINAL) else 0

    def take(self, live: Steps, stored: bool) -> None:
        """Take the stages of a step that was just found, if they will be the same when they are found anew.

        They are not where rates at the start were those of other degrees of freedom: where states within the step are
        stored, they are then found anew at once.
        """
        if np.array_equal(live.V[0], self.first.v[: live.V.shape[1]]):
            self.inside.take(self, live)
        elif stored:
            self.inside.again(self, self.h, live.given_stages)

    def moment(self, t: float) -> tuple[Snapshot, Array]:
        """Return the instant at a time [s] in the step, and the internal states."""
        if t == self.last.t:
            return self.last, self.z1
        if t == self.first.t:
            return self.first, self.y0[self.y0.size - self.z1.size :]
        order, inside, part = self._order, self.inside, (t - self.first.t) / self.h
        if not (order and inside.knows(self, LOBATTO if order == 7 else INSIDE)):
            inside.again(self, t - self.first.t)
            return inside.moment(self, t, inside.y_new)
        if order == 7:
            return inside.at(self, t, (_shares(part) @ SEVENTH)[:CHECK])
        return inside.at(self, t, _legendre(2 * part - 1) @ EIGHTH)

    def near(self, t: float) -> tuple[Snapshot, Array]:
        """Return the same by the cubic through both ends with the rates there."""
        inside, part = self.inside, (t - self.first.t) / self.h
        inside.knows(self, EXTRA)
        return inside.at(self, t, (_shares(part)[:3] @ SEVENTH[:3])[:EXTRA])
