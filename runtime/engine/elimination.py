"""Factors of sparse square matrices whose entries are always in the same places: one pivot order for all of them."""

from __future__ import annotations

from typing import Any

import numpy as np
from scipy.sparse import csc_array

from flexel.base.arrays import Array, Index
from flexel.engine.solvers import SparseFactors
from flexel.generated._kernels import ffi, lib

# Measured, factorization with the order known and one solution, this elimination and SuperLU: hoist (410 unknowns) 0.06
# and 0.8 ms, rope of 250 cables (1503) 0.12 and 1.2 ms, grid of 22 x 22 beams (2904) 4 and 20 ms, cube of 8 x 8 x 8
# beams (3072) 28 and 64 ms: always faster. But the order costs as much as 3 to 30 factorizations by SuperLU (5 ms for
# the rope, 1.7 s for the cube), growing with the fill: beyond the border SuperLU counts the fill first.
BORDER = 3000  # unknowns above which matrices with much fill are left to SuperLU
MUCH = 60  # entries of the factors for each unknown: ropes and chains have 10 to 30, grids 200


class Elimination:
    """Places of the entries of square matrices, and LU factors with a pivot order that serves all of them.

    The first order is found from samples, or from the first matrix that is factorized. Where it is unsound for a later
    one it is replaced by another that is sound for that one, and for the samples if possible.

    Parameters
    ----------
    rows, columns : ndarray of int (entries,)
        Place of each entry; several entries of one place are stored as one, those outside of the matrix not at all.
    size : int
        Unknowns.
    samples : tuple of ndarray (stored,), optional
        Stored matrices from which the first order is determined.

    Attributes
    ----------
    rows, columns : ndarray of int (stored,)
        Place of each stored number.
    """

    def __init__(self, rows: Index, columns: Index, size: int, samples: tuple[Array, ...] = ()) -> None:
        self.size = size
        inside = (rows < size) & (columns < size)
        unique = np.unique((columns * size + rows)[inside])
        self.rows, self.columns = unique % max(size, 1), unique // max(size, 1)
        self._samples = samples
        self._order: PivotOrder | None = None
        self._filled: bool | None = None if size > BORDER else False

    def __getstate__(self) -> dict[str, Any]:
        """Return everything but the order, which lives in C; it is found again from the same samples."""
        return self.__dict__ | {"_order": None}

    @property
    def order(self) -> PivotOrder | None:
        """The present order of the pivots; None before the first factorization, and by SuperLU."""
        return self._order

    def matrix(self, stored: Array) -> Any:
        """Return a stored matrix as a scipy.sparse array."""
        starts = np.searchsorted(self.columns, np.arange(self.size + 1))
        return csc_array((stored, self.rows, starts), shape=(self.size, self.size))

    def factorize(self, stored: Array) -> Eliminated | LargeFactors:
        """Factorize a stored matrix; the factors are not regular if it is singular, apart from rounding errors."""
        if self._filled is not False:
            large = LargeFactors(self.matrix(stored))
            if large.regular:
                self._filled = large.entries > MUCH * self.size
            return large
        stored = np.ascontiguousarray(stored, dtype=np.float64)
        order = self._order or self._begun(stored)
        factors = None if order is None else order.factorize(stored)
        return factors if factors is not None else self._ordered_anew(stored)

    def factorized(self, stored: Array) -> Eliminated | LargeFactors:
        """Factorize a stored matrix, by SuperLU if there is no sound order of the pivots.

        A matrix that is singular but for rounding errors, of a straight rope without tension, still has a solution if
        nothing acts where there is no stiffness: SuperLU refuses pivots only if they are zero.
        """
        found = self.factorize(stored)
        return found if found.regular else LargeFactors(self.matrix(stored))

    def _begun(self, stored: Array) -> PivotOrder | None:
        """Find the first order: from the samples, or from this matrix if there are none."""
        samples = self._samples or (stored.copy(),)
        order = self._found(samples)
        if order is not None:
            self._samples, self._order = samples, order
        return order

    def _ordered_anew(self, stored: Array) -> Eliminated:
        for samples in ((stored, *self._samples), (stored,)):
            order = self._found(samples)
            factors = None if order is None else order.factorize(stored)
            if factors is not None:
                self._order = order
                return factors
        return Eliminated(None, np.zeros(0))

    def _found(self, samples: tuple[Array, ...]) -> PivotOrder | None:
        return PivotOrder.find(self.rows, self.columns, self.size, samples)


class PivotOrder:
    """An order of pivots: constant, shared by the factors that were computed with it.

    Attributes
    ----------
    lu : C data (flexel_lu *)
        The order, for functions in C.
    """

    def __init__(self, lu: Any, size: int, entries: int) -> None:
        self.lu = ffi.gc(lu, lib.flexel_lu_free)
        self.size = size
        self.slots = int(lib.flexel_lu_slots(lu))
        self._source = np.arange(entries, dtype=np.int32)

    @classmethod
    def find(cls, rows: Index, columns: Index, size: int, samples: tuple[Array, ...]) -> PivotOrder | None:
        """Find an order that is sound for all samples (stored,); return None if there is none."""
        places = [np.ascontiguousarray(indices, dtype=np.int32) for indices in (rows, columns)]
        pointers = [ffi.from_buffer("int[]", indices) for indices in places]
        values = np.concatenate(samples)
        failed = ffi.new("size_t *")
        lu = lib.flexel_lu_order(
            size, rows.size, *pointers, len(samples), ffi.from_buffer("double[]", values), failed
        )
        if lu == ffi.NULL:
            if failed[0] == size:
                raise MemoryError(f"order of the pivots of {size} unknowns")
            return None
        return cls(lu, size, rows.size)

    @property
    def operations(self) -> int:
        """Multiplications with subtraction in one factorization."""
        return int(lib.flexel_lu_operations(self.lu))

    def factorize(self, stored: Array) -> Eliminated | None:
        """Factorize a stored matrix (stored,); return None if a pivot is too small."""
        a = np.empty(self.slots)
        source, values = ffi.from_buffer("int[]", self._source), ffi.from_buffer("double[]", stored)
        if lib.flexel_lu_factor(self.lu, 1.0, source, values, ffi.from_buffer("double[]", a)):
            return None
        return Eliminated(self, a)


class Eliminated:
    """LU factors with a given order of the pivots; not regular if there is no order.

    Parameters
    ----------
    order : PivotOrder or None
    factors : ndarray (slots,)
    """

    def __init__(self, order: PivotOrder | None, factors: Array) -> None:
        self.order = order
        self.factors = factors

    @property
    def regular(self) -> bool:
        """False if the matrix is singular, apart from rounding errors."""
        return self.order is not None

    @property
    def sign(self) -> int:
        """Sign of the determinant; zero if the matrix is singular."""
        if self.order is None:
            return 0
        return int(lib.flexel_lu_sign(self.order.lu, ffi.from_buffer("double[]", self.factors)))

    def solve(self, b: Array, transposed: bool = False) -> Array:
        """Solve A x = b, or A' x = b, for one or several columns."""
        if self.order is None:
            raise ValueError("a singular matrix has no solutions")
        x = np.array(b, dtype=np.float64, order="C")
        if x.size:
            work = np.empty(x.size)
            pointers = [ffi.from_buffer("double[]", values) for values in (self.factors, x, work)]
            run = lib.flexel_lu_solve_transposed if transposed else lib.flexel_lu_solve
            run(self.order.lu, pointers[0], x.size // self.order.size, pointers[1], pointers[1], pointers[2])
        return x


class LargeFactors(SparseFactors):
    """LU factors of a matrix beyond the border, by SuperLU."""

    @property
    def entries(self) -> int:
        """Entries of the factors."""
        return int(self._lu.nnz)

    @property
    def sign(self) -> int:
        """Sign of the determinant; zero if the matrix is singular."""
        if not self.regular:
            return 0
        signs = np.sign(self._lu.U.diagonal()).prod()
        return int(signs) * _parity(self._lu.perm_r) * _parity(self._lu.perm_c)


def _parity(permutation: Index) -> int:
    """Return the sign of a permutation, from its number of cycles."""
    todo, cycles = np.ones(permutation.size, dtype=bool), 0
    for i in range(permutation.size):
        cycles += int(todo[i])
        while todo[i]:
            todo[i] = False
            i = permutation[i]
    return -1 if (permutation.size - cycles) % 2 else 1
