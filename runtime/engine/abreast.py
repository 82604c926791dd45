"""Motions of eight variants abreast in C, with the arrays that they read and write; see lanes.h."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from flexel.base.arrays import Array
from flexel.engine.choice import TOLERANCE, Choice, ChoiceLists
from flexel.engine.lanes import LANES, aligned
from flexel.engine.structs import Struct
from flexel.engine.widework import WideWork
from flexel.generated._kernels import ffi, lib

COUNTS = ("doing", "taken", "refused", "tries")
NUMBERS = ("t", "h", "first", "to", "until", "reached", "reach", "allowed", "sign")
SAME = ("nr", "np", "nd", "nk", "saddle", "rows", "slips", "loaded", "nloads", "weight", "step_weight")
IDLE, RUNNING, PASSED, STOPPED = (
    getattr(lib, f"FLEXEL_{z}") for z in ("IDLE", "RUNNING", "PASSED", "STOPPED")
)


class WideStruct(Struct):
    """A structure in C whose arrays have eight numbers in each place."""

    def wide(self, name: str, *sizes: int) -> Array:
        """A new array of zeros (*sizes, 8) for a field."""
        array = aligned(max(int(np.prod(sizes)), 1) * LANES)
        setattr(self.struct, name, self.pointer(array))
        return array[: int(np.prod(sizes)) * LANES].reshape(*sizes, LANES)


class WideChoice(WideStruct):
    """A choice of degrees of freedom for eight variants.

    Parameters
    ----------
    lists : ChoiceLists
    one : Choice
        That of a variant, whose order of the pivots holds for all of them.
    """

    def __init__(self, lists: ChoiceLists, one: Choice) -> None:
        super().__init__(ffi.new("flexel_choice *"))
        c, s = self.struct, lists.tables.structure
        self._keep.append(one)
        for name in SAME:
            setattr(c, name, getattr(one.struct, name))
        for name in ("n", "nentries", "rows", "columns", "source"):
            setattr(c.P, name, getattr(one.struct.P, name))
        c.P.lu, c.tolerance = one.struct.P.first, TOLERANCE
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


class WideSteps(WideStruct):
    """Steps of DOP853 of eight variants.

    Parameters
    ----------
    work : WideWork
    ny : int
    atol : ndarray (ny,)
    weight : ndarray (nf,)
        One over natural scales of the free coordinates.
    tableau : mapping of str to ndarray
        A, B, C, E3 and E5 of the method.
    """

    def __init__(
        self, work: WideWork, ny: int, atol: Array, weight: Array, tableau: Mapping[str, Array]
    ) -> None:
        super().__init__(ffi.new("flexel_dop853 *"))
        c, s, turns = self.struct, work.struct, int(work.struct.nperiodic)
        c.ny = ny
        for name, array in {**tableau, "atol": atol, "weight": weight}.items():
            setattr(c, name, self.pointer(array))
        self.y, self.x, self.e = self.wide("y", ny), self.wide("x", s.n), self.wide("e", turns)
        self.y_new, self.x_new = self.wide("y_new", ny), self.wide("x_new", s.n)
        self.wide("e_new", turns)
        sizes = {"K": ny, "V": s.nf, "W": s.nf, "turning": turns}
        self.K, self.V, self.W, self.turning = (self.wide(name, 13, size) for name, size in sizes.items())
        self.wide("space", max(ny, s.nf))


class Abreast(WideStruct):
    """Eight motions, each in a lane with its own time and step.

    Attributes
    ----------
    work : WideWork
    choice : WideChoice
    steps : WideSteps
    doing, taken, refused, tries : ndarray of int (8,)
    t, h, first, to, until, reached, reach, allowed, sign : ndarray (8,)
        See lanes.h.
    v, e, w : ndarray (…, 8)
        Rates of coordinates, deformations and their rates at the start of the steps.
    """

    def __init__(
        self,
        work: WideWork,
        choice: WideChoice,
        steps: WideSteps,
        rules: Mapping[str, float],
        gaps: Sequence[int],
    ) -> None:
        super().__init__(ffi.new("flexel_lanes *"))
        c, s = self.struct, work.struct
        self.work, self.choice, self.steps = work, choice, steps
        c.work, c.choice, c.steps = work.struct, choice.struct, steps.struct
        self.wide("after", s.nf)
        self.v, self.e, self.w = self.wide("v", s.n), self.wide("e", s.m), self.wide("w", s.m)
        c.gaps, c.ngaps = self.integers(np.array(gaps, dtype=np.int32)), len(gaps)
        for name, value in rules.items():
            setattr(c, name, value)
        self.doing, self.taken, self.refused, self.tries = (self._counts(z) for z in COUNTS)
        found = [self.wide(z, 1)[0] for z in NUMBERS]
        self.t, self.h, self.first, self.to, self.until, self.reached, _, self.allowed, self.sign = found

    def _counts(self, name: str) -> np.ndarray[tuple[int], np.dtype[np.int32]]:
        array = np.zeros(LANES, dtype=np.int32)
        setattr(self.struct, name, self.integers(array))
        return array

    def run(self) -> None:
        """Take steps until a lane needs attention."""
        lib.flexel_lanes_run(self.struct)
