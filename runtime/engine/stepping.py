"""Single steps of the generalized-alpha method in C, with the arrays that they read and write."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from flexel.base.arrays import Array, Index
from flexel.engine.balancing import Balancing
from flexel.engine.covered import number_of, state_groups
from flexel.engine.elimination import Eliminated, Elimination, LargeFactors
from flexel.engine.structs import Struct
from flexel.generated._kernels import ffi, lib
from flexel.model.structure import Structure


class Stepping(Struct):
    """Newton's method for a step, see implicit.h; loads and conditions at its end are set in the balance before.

    Attributes
    ----------
    struct : cffi struct
        Its counts and errors can be read, its parameters set.
    singular : bool
        Whether the last step was not found because its matrix is singular.
    old, now : dict of str to ndarray
        The vectors of the points at the start and at the end of a step.
    """

    def __init__(
        self, balancing: Balancing, elimination: Elimination, source: Index, scales: Mapping[str, Array]
    ) -> None:
        work = balancing.work
        s, nforce = work.tables.structure, balancing.mu.size
        self.balancing, self._values, self.singular = balancing, work.values, False
        super().__init__(ffi.new("flexel_step *"))
        c = self.struct
        c.balance, c.values = balancing.struct, self.pointer(work.values)
        self.use(elimination, source)
        for name, values in scales.items():
            setattr(c, name, self.pointer(values))
        self.stiffness, self._step = np.zeros(s.nf), np.zeros(s.nf + nforce)
        c.stiffness, c.step = self.pointer(self.stiffness), self.pointer(self._step)
        c.space = self.pointer(np.zeros(s.nf + nforce))
        sizes = dict.fromkeys(("x", "v", "a", "w"), s.n) | {"mu": nforce, "e": s.m}
        sizes |= dict.fromkeys(("z", "zd", "zw"), s.nz)
        self.old, self.now = ({name: np.zeros(size) for name, size in sizes.items()} for _ in range(2))
        for point, vectors in ((c.old, self.old), (c.now, self.now)):
            for name, array in vectors.items():
                setattr(point, name, self.pointer(array))
        self._ranges(s)

    def _ranges(self, structure: Structure) -> None:
        """Set the ranges of coordinates and internal states, which are empty."""
        group = state_groups(structure)
        found, nf, nz = self.struct.ranges, structure.nf, structure.nz
        found.group, found.groups = self.integers(group), number_of(group)
        self._wide = {"x_low": np.full(nf, np.inf), "z_low": np.full(nz, np.inf)}
        self._wide |= {"x_high": np.full(nf, -np.inf), "z_high": np.full(nz, -np.inf)}
        for name, array in self._wide.items():
            setattr(found, name, self.pointer(array))
        found.group_range, found.zd_before = self.pointer(np.zeros(found.groups)), self.pointer(np.zeros(nz))

    def begin(self) -> None:
        """Take the point `old` into the ranges of the motion; there is no step before it."""
        for kind in "xz":
            low, high = self._wide[f"{kind}_low"], self._wide[f"{kind}_high"]
            np.minimum(low, self.old[kind][: low.size], out=low)
            np.maximum(high, self.old[kind][: high.size], out=high)
        self.struct.ranges.h_before = 0.0

    def use(self, elimination: Elimination, source: Index) -> None:
        """Factorize with this pattern from now on, whose entries are at those places of the workspace's values."""
        self._elimination, self._places = elimination, source
        self._source = source.astype(np.int32)
        self._factors: Eliminated | LargeFactors | None = None
        self.struct.source = ffi.from_buffer("int[]", self._source)
        self.struct.lu, self.struct.matrix_step = ffi.NULL, 0.0

    def run(self, h: float) -> bool:
        """Try a step of length h; return whether it was found.

        Raises
        ------
        FloatingPointError
            If a law has no slope at a trial point, which the workspace holds.
        """
        self.struct.h, self.singular = h, False
        code = lib.flexel_step_begin(self.struct)
        while code in (lib.FLEXEL_FACTORIZE, lib.FLEXEL_SOLVE):
            if code == lib.FLEXEL_FACTORIZE:
                self._factorize()
            if self._factors is None or not self._factors.regular:
                self.struct.matrix_step, self.singular = 0.0, True
                return False
            self._step[:] = self._factors.solve(self._step)
            code = lib.flexel_step_resume(self.struct)
        if code == lib.FLEXEL_NO_SLOPE:
            raise FloatingPointError
        return bool(code == lib.FLEXEL_FOUND)

    def _factorize(self) -> None:
        """Factorize with an order of pivots for the present values, which later matrices use too; or by SuperLU."""
        self._factors = factors = self._elimination.factorized(self._values[self._places])
        if isinstance(factors, Eliminated) and factors.order is not None:
            self.struct.lu = factors.order.lu
            self.struct.factors = ffi.from_buffer("double[]", factors.factors)
        else:
            self.struct.lu = ffi.NULL

    def accept(self) -> None:
        """Continue from the end of the step."""
        lib.flexel_step_accept(self.struct)
