"""Motions of eight variants side by side in C, with the arrays that they read and write; see lanes.h."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from flexel.base.arrays import Array
from flexel.engine.contact_look import ContactLook
from flexel.engine.coordinate_work import TOLERANCE, CoordinateLists, CoordinateWork
from flexel.engine.covered import Covered, ranges
from flexel.engine.lane_workspace import LaneWorkspace
from flexel.engine.lanes import LANES, aligned
from flexel.engine.rotations import LISTS, Rotations
from flexel.engine.structs import Struct
from flexel.generated._kernels import ffi, lib

COUNTS = ("doing", "taken", "refused", "tries", "most")
NUMBERS = (
    "t",
    "h",
    "first",
    "to",
    "until",
    "amplification",
    "amplification_new",
    "allowed",
    "sign",
    "size",
    "size_new",
    "fall",
)
SAME = (
    "nr",
    "np",
    "nd",
    "nk",
    "saddle",
    "rows",
    "slips",
    "forced",
    "loaded",
    "nloads",
    "weight",
    "step_weight",
)
IDLE, RUNNING, PASSED, STOPPED = (
    getattr(lib, f"FLEXEL_{name}") for name in ("IDLE", "RUNNING", "PASSED", "STOPPED")
)


class LaneStruct(Struct):
    """A structure in C whose arrays have eight numbers in each place."""

    def wide(self, name: str, *sizes: int) -> Array:
        """Allocate an array of zeros (*sizes, 8) for a field."""
        array = aligned(max(int(np.prod(sizes)), 1) * LANES)
        setattr(self.struct, name, self.pointer(array))
        return array[: int(np.prod(sizes)) * LANES].reshape(*sizes, LANES)


class LaneCoordinateWork(LaneStruct):
    """A choice of degrees of freedom for eight variants.

    Parameters
    ----------
    lists : CoordinateLists
    one : CoordinateWork
        That of a variant, whose order of the pivots holds for all of them.
    """

    def __init__(self, lists: CoordinateLists, one: CoordinateWork) -> None:
        super().__init__(ffi.new("flexel_choice *"))
        c, s = self.struct, lists.tables.structure
        self._keep.append(one)
        for name in SAME:
            setattr(c, name, getattr(one.struct, name))
        for name in ("n", "nentries", "rows", "columns", "source"):
            setattr(c.P, name, getattr(one.struct.P, name))
        c.P.lu, c.P.noise, c.tolerance = one.struct.P.first, one.struct.P.noise, TOLERANCE
        factors = aligned(lib.flexel_lu_slots(c.P.lu) * LANES)
        c.P.a = self.pointer(factors)
        nd, nk, nf = c.nd, c.nk, s.nf
        c.columns, c.stride = (
            max(nd + nk, 2),
            nd + 1,
        )  # none for prescribed motions; one alone is summed otherwise
        small = max((nk + 1) * (c.columns + nk), (nd + 2) * c.stride)
        sizes = {"q": nd + nk, "qd": nd, "qdd": nd, "force": s.n, "inverse": nk * nk, "small": small}
        sizes |= dict.fromkeys(("target", "residual", "step"), nf)
        sizes |= {"G": nf * c.columns, "work": nf * c.columns, "X": nf * c.stride}
        for name, size in sizes.items():
            self.wide(name, size)
        self.loads = self.wide("loads", c.nloads)


class LaneCovered(LaneStruct):
    """What eight motions have covered so far.

    Parameters
    ----------
    one : Covered
        That of one of them, with the same tolerances.

    Attributes
    ----------
    arrays : dict of str to ndarray (…, 8)
    """

    def __init__(self, one: Covered) -> None:
        super().__init__(ffi.new("flexel_covered *"))
        self._keep.append(one)
        for name in ("relative", "rtol", "atol", "resolution", "full", "least", "ny", "groups", "group"):
            setattr(self.struct, name, getattr(one.struct, name))
        self.arrays = {name: self.wide(name, array.size) for name, array in one.arrays.items()}

    def ranges(self, lane: int, y: Array) -> Array:
        """Return how far y (ny,) has moved in a lane, these values included."""
        return ranges(self.arrays["least_y"][:, lane], self.arrays["most_y"][:, lane], y)

    def accepted_error(self, lane: int, accept: float) -> float:
        """Return the error of a position that is accepted in the next step of a lane."""
        sizes = self.arrays["sizes"][:, lane]
        of_motion = float(sizes[lib.FLEXEL_RANGE]), float(sizes[lib.FLEXEL_TAKEN])
        return float(lib.flexel_accepted_error(self.struct, accept, *of_motion))

    def part(self, lane: int) -> float:
        """Return the part of the tolerances that the next step of a lane gets."""
        return float(lib.flexel_part_of_step(self.struct, self.arrays["sizes"][lib.FLEXEL_TAKEN, lane]))


class LaneSteps(LaneStruct):
    """Steps of DOP853 of eight variants.

    Parameters
    ----------
    work : LaneWorkspace
    ny : int
    atol : ndarray (ny,)
    weight : ndarray (nf,)
        One over natural scales of the free coordinates.
    tableau : mapping of str to ndarray
        A, B, C, E3 and E5 of the method.
    covered : LaneCovered
    rotations : Rotations
    """

    def __init__(
        self,
        work: LaneWorkspace,
        ny: int,
        atol: Array,
        weight: Array,
        tableau: Mapping[str, Array],
        covered: LaneCovered,
        rotations: Rotations,
    ) -> None:
        super().__init__(ffi.new("flexel_dop853 *"))
        self.covered = covered
        self.struct.covered = covered.struct
        c, s, turns = self.struct, work.struct, int(work.struct.nperiodic)
        c.ny = ny
        apart = rotations.apart(weight)
        for name, array in {**tableau, "atol": atol, "weight": weight, "apart": apart}.items():
            setattr(c, name, self.pointer(array))
        self.y, self.x, self.e = self.wide("y", ny), self.wide("x", s.n), self.wide("e", turns)
        self.y_new, self.x_new = self.wide("y_new", ny), self.wide("x_new", s.n)
        self.wide("e_new", turns)
        sizes = {"K": ny, "V": s.nf, "W": s.nf, "turning": turns}
        self.K, self.V, self.W, self.turning = (self.wide(name, 13, size) for name, size in sizes.items())
        self.wide("space", max(2 * ny, s.nf))
        self.scale = self.wide("scale", ny)
        c.rotations.count = rotations.count
        for name in LISTS:
            setattr(c.rotations, name, self.integers(getattr(rotations, name).flatten()))
        found = {name: self._of_rotations(name, size) for name, size in rotations.sizes(13).items()}
        self.w, self.w_new, self.w_rates = found["w"], found["w_new"], found["W"].reshape(13, -1, LANES)
        self.w_scale = found["scale"]

    def _of_rotations(self, name: str, size: int) -> Array:
        """Allocate an array of zeros (size, 8) for a field of rotations.h."""
        array = aligned(max(size, 1) * LANES)
        setattr(self.struct.rotations, name, self.pointer(array))
        return array[: size * LANES].reshape(-1, LANES)


class LaneLook(LaneStruct):
    """Whether a step must end earlier for a contact, in eight motions; see `ContactLook`.

    Parameters
    ----------
    struct : cffi struct
    own : ContactLook
        That of one of the motions.

    Attributes
    ----------
    value, rate, rest : ndarray (k, 8)
    """

    def __init__(self, struct: Any, own: ContactLook) -> None:
        super().__init__(struct)
        self._own = own  # keeps the places, which are those of all motions
        for name in ("rows", "nrows", "gaps", "ngaps", "least", "sees_inside"):  # `passed` is of one motion
            setattr(struct, name, getattr(own.struct, name))
        self.value, self.rate, self.rest = (
            self.wide(name, own.value.size) for name in ("value", "rate", "rest")
        )


class LaneRun(LaneStruct):
    """Eight motions, each in a lane with its own time and step.

    Attributes
    ----------
    work : LaneWorkspace
    choice : LaneCoordinateWork
    steps : LaneSteps
    doing, taken, refused, tries, most : ndarray of int (8,)
    t, h, first, to, until, amplification, allowed, sign, size, fall : ndarray (8,)
        See lanes.h.
    v, e, w : ndarray (…, 8)
        Rates of coordinates, deformations and their rates at the start of the steps.
    look : LaneLook
    """

    def __init__(
        self,
        work: LaneWorkspace,
        choice: LaneCoordinateWork,
        steps: LaneSteps,
        rules: Mapping[str, float],
        look: ContactLook,
    ) -> None:
        super().__init__(ffi.new("flexel_lanes *"))
        c, s = self.struct, work.struct
        self.work, self.choice, self.steps = work, choice, steps
        c.work, c.choice, c.steps = work.struct, choice.struct, steps.struct
        self.wide("after", s.nf)
        c.U0 = self.pointer(work.U0)
        self.wide("accept", 1)
        self.v, self.e, self.w = self.wide("v", s.n), self.wide("e", s.m), self.wide("w", s.m)
        self.look = LaneLook(c.touching, look)
        for name, value in rules.items():
            setattr(c, name, value)
        self.doing, self.taken, self.refused, self.tries, self.most = map(self._counts, COUNTS)
        found = [self.wide(name, 1)[0] for name in NUMBERS]
        self.t, self.h, self.first, self.to, self.until, self.amplification, _, self.allowed, *rest = found
        self.sign, self.size, _, self.fall = rest

    def _counts(self, name: str) -> np.ndarray[tuple[int], np.dtype[np.int32]]:
        array = np.zeros(LANES, dtype=np.int32)
        setattr(self.struct, name, self.integers(array))
        return array

    def take_account(self, lane: int, account: Struct | None) -> None:
        """Keep the energy balance of a lane in a structure of account.h from now on; None for no balance."""
        self.struct.accounts[lane] = account.struct if account else ffi.NULL

    def run(self) -> None:
        """Take steps until a lane needs attention."""
        lib.flexel_lanes_run(self.struct)
