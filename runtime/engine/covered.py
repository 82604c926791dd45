"""The ranges that a motion has covered so far, the scale of its tolerances; see covered.h."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from flexel.base.arrays import Array, Index
from flexel.engine.structs import Struct
from flexel.engine.workspace import Workspace
from flexel.generated._kernels import ffi, lib
from flexel.model.structure import Structure

FULL = 50  # steps that get the full tolerances
LEAST = 1 / 32  # of the tolerances that every step gets: less meets the rounding errors of users' functions
MOVED = ("low", "high", "quick", "sizes", "sizes_new", "states", "states_new")  # by the motion itself
OF_Y = ("least_y", "most_y")
FINEST = 1e-12  # relative tolerance of a step that is not reduced


def state_groups(structure: Structure) -> NDArray[np.int32]:
    """Return the numbers (nz,) of groups of internal states: states of the same law share one."""
    kinds = [(law.spec.name, i) for law in structure.laws for i in range(len(law.states))]
    numbers = {kind: i for i, kind in enumerate(dict.fromkeys(kinds))}
    return np.array([numbers[kind] for kind in kinds], dtype=np.int32)


def number_of(group: NDArray[np.int32]) -> int:
    """Return how many groups there are."""
    return int(group.max(initial=-1)) + 1


def ranges(least: Array, most: Array, y: Array) -> Array:
    """Return the ranges of values between their least and most so far and y, all (ny,)."""
    return np.asarray(np.maximum(most, y) - np.minimum(least, y))


class Covered(Struct):
    """The sizes of one motion.

    Parameters
    ----------
    structure : Structure
    weight : ndarray (nf,)
        One over natural scales of the free coordinates.
    rtol : float
        Relative tolerance of a step.
    atol : float
        Absolute tolerance of a motion of the machine's size, in natural scales.
    resolution : float
        Rounding errors of coordinates, relative to them.
    relative : bool
        Whether the tolerances are relative to the motion.
    full : float, optional
        Steps that get the full tolerances; by default `FULL`.
    """

    def __init__(
        self,
        structure: Structure,
        weight: Array,
        rtol: float,
        atol: float,
        resolution: float,
        relative: bool,
        full: float | None = None,
    ) -> None:
        super().__init__(ffi.new("flexel_covered *"))
        c, nf = self.struct, structure.nf
        c.relative, c.rtol, c.atol, c.resolution = relative, rtol, atol, resolution / atol
        c.full = FULL if full is None else full
        c.least = min(max(FINEST / rtol, resolution / atol, LEAST), 1.0)
        group = state_groups(structure)
        c.group, c.groups = self.integers(group), number_of(group)
        self._weight = np.ascontiguousarray(weight)
        self.arrays = {name: self.new(name, nf) for name in ("low", "high", "quick")}
        self.arrays |= {name: self.new(name, lib.FLEXEL_SIZES) for name in ("sizes", "sizes_new")}
        self.arrays |= {name: self.new(name, c.groups) for name in ("states", "states_new")}
        self._begun = False
        self._dofs: Index | None = None  # degrees of freedom of y

    def take(self, work: Workspace, x: Array, v: Array, z: Array) -> None:
        """Take an instant of the motion into it: coordinates, their rates, and internal states."""
        if not self._begun:
            for name in ("low", "high"):
                self.arrays[name][:] = x[: self._weight.size]
            self._begun = True
        arrays = [np.ascontiguousarray(a) for a in (self._weight, x, v, z)]
        vectors = [ffi.from_buffer("double[]", a) for a in arrays]
        lib.flexel_covered_look(work.struct, self.struct, *vectors)
        lib.flexel_covered_begin(work.struct, self.struct, *vectors[1:3])

    def take_over(self, before: Covered) -> None:
        """Continue with what a motion has covered, after a change of its method."""
        for name in MOVED:
            self.arrays[name][:] = before.arrays[name]
        self._begun = before._begun
        if before._dofs is not None:
            self._reserve(int(before.struct.ny))
            for name in OF_Y:
                self.arrays[name][:] = before.arrays[name]
            self._dofs = before._dofs

    def begin(self, y: Array, dofs: Index) -> None:
        """Continue with these values of y (ny,), in these degrees of freedom.

        Of new ones nothing is known: they count as if they had come from zero.
        """
        self._reserve(y.size)
        least, most = (self.arrays[name] for name in OF_Y)
        if self._dofs is None:
            least[:] = most[:] = y
        elif np.array_equal(self._dofs, dofs):
            least[:], most[:] = np.minimum(least, y), np.maximum(most, y)
        else:
            least[:], most[:] = np.minimum(y, 0.0), np.maximum(y, 0.0)
        self._dofs = dofs

    def _reserve(self, ny: int) -> None:
        if self.struct.ny != ny:
            self.struct.ny = ny
            self.arrays |= {name: self.new(name, ny) for name in OF_Y}

    def ranges(self, y: Array) -> Array:
        """Return how far y (ny,) has moved in the present degrees of freedom, these values included."""
        return ranges(self.arrays["least_y"], self.arrays["most_y"], y)

    def skip(self, steps: float) -> None:
        """Give the next steps the tolerances that they would have after so many."""
        self.arrays["sizes"][lib.FLEXEL_TAKEN] = steps

    @property
    def finest(self) -> float:
        """The rounding errors of the coordinates, relative to their largest range so far; zero if nothing has moved."""
        c, covered = self.struct, self.widest
        return c.resolution * c.atol * max(1.0, self.farthest) / covered if covered else 0.0

    def finest_of_step(self, span: float, steps: int) -> float:
        """Return the same relative to what the fastest one moves in a step, for so many steps in a time [s]."""
        c, moved = self.struct, self.fastest * span
        return c.resolution * c.atol * max(1.0, self.farthest) * steps / moved if moved else 0.0

    @property
    def widest(self) -> float:
        """The largest range of a coordinate so far, in natural scales."""
        return float(self.arrays["sizes"][lib.FLEXEL_RANGE])

    @property
    def fastest(self) -> float:
        """The largest rate of a coordinate so far, in natural scales."""
        return float(self.arrays["sizes"][lib.FLEXEL_FASTEST])

    @property
    def farthest(self) -> float:
        """The largest coordinate so far, in natural scales."""
        return float(self.arrays["sizes"][lib.FLEXEL_FARTHEST])

    @property
    def part(self) -> float:
        """The part of the tolerances that the next step gets."""
        return float(lib.flexel_part_of_step(self.struct, self.arrays["sizes"][lib.FLEXEL_TAKEN]))

    def accepted_error(self, accept: float) -> float:
        """Return the error of a position below which J is kept in the next step."""
        sizes = self.arrays["sizes"]
        of_motion = sizes[lib.FLEXEL_RANGE], sizes[lib.FLEXEL_TAKEN]
        return float(lib.flexel_accepted_error(self.struct, accept, *of_motion))
