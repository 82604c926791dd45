"""Factorizations that use the assembly order of a mechanism: block lower triangular form.

The constraints of a mechanism whose joints are its degrees of freedom determine one body after another: with rows and
columns in that order the matrix has small diagonal blocks (a body, or the bodies of a closed loop) and nothing to the
right of them. The form follows from the places of the entries alone, computed once; LU factors are needed only for the
diagonal blocks, with row interchanges inside them. Source: Duff and Reid (1978), ACM Trans. Math. Softw. 4:137.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from scipy.sparse import coo_array, csr_array
from scipy.sparse.csgraph import connected_components, maximum_bipartite_matching

from flexel.base.arrays import Array, Index
from flexel.engine.solvers import Factorization, Solvable
from flexel.generated._kernels import ffi, lib


class BlockForm:
    """Block lower triangular form of square matrices with entries in the same places.

    Parameters
    ----------
    rows, columns : ndarray of int (entries,)
        Place of each entry, without duplicates.
    size : int
        Unknowns.

    Attributes
    ----------
    regular : bool
        False if no values of the entries could make the matrix regular; it then has no form.
    rows, columns : ndarray of int (size,)
        Order of rows and columns.
    start : ndarray of int (blocks + 1,)
        Where the diagonal blocks begin.
    """

    def __init__(self, rows: Index, columns: Index, size: int) -> None:
        self.size = size
        pattern = csr_array(coo_array((np.ones(rows.size), (rows, columns)), shape=(size, size)))
        partner = np.asarray(maximum_bipartite_matching(pattern, perm_type="column"), dtype=np.intp)
        self.regular = size > 0 and bool((partner >= 0).all())
        if not self.regular:
            return
        count, found = connected_components(pattern[:, partner], directed=True, connection="strong")
        label = np.asarray(found, dtype=np.intp)
        place = _sequence(pattern[:, partner].tocoo(), label, count)
        self.rows = np.argsort(place[label], kind="stable").astype(np.intp)
        self.columns = partner[self.rows]
        self.start = np.concatenate([[0], np.cumsum(np.bincount(place[label]))]).astype(np.uintp)
        self._entries(rows, columns)

    @property
    def operations(self) -> float:
        """Approximate number of multiplications in the factorization."""
        return float((np.diff(self.start).astype(float) ** 3).sum() / 3)

    def _entries(self, rows: Index, columns: Index) -> None:
        """Slots of the entries in the storage: diagonal blocks row by row, then the off-diagonal entries."""
        i, j = (np.argsort(order)[z] for order, z in ((self.rows, rows), (self.columns, columns)))
        start = self.start.astype(np.intp)
        block, width = np.repeat(np.arange(start.size - 1), np.diff(start)), np.diff(start)
        first = np.concatenate([[0], np.cumsum(width**2)])
        k = block[i]
        inside = block[j] == k
        self.slots = first[k] + (i - start[k]) * width[k] + j - start[k]
        beside = np.flatnonzero(~inside)
        beside = beside[np.argsort(i[beside], kind="stable")]
        self.diagonal = int(first[-1])
        self.slots[beside] = self.diagonal + np.arange(beside.size)
        self.length = self.diagonal + beside.size
        ends = np.cumsum(np.bincount(i[beside], minlength=self.size))
        self._tables = [self.start, np.concatenate([[0], ends]).astype(np.uintp), j[beside].astype(np.uintp)]
        pointers = [ffi.from_buffer("size_t[]", z) for z in self._tables]
        self.form = ffi.new("flexel_form *", [start.size - 1, *pointers])

    def factorize(self, stored: Array) -> BlockFactors:
        """LU factors of a matrix in its storage (length,), which is overwritten."""
        return BlockFactors(self, stored)


def _sequence(pattern: Any, label: Index, count: int) -> Index:
    """Place (count,) of each block so that none needs unknowns of a later one."""
    i, j = label[pattern.row], label[pattern.col]
    pairs = np.unique(np.stack([j, i])[:, i != j], axis=1)
    waits = np.bincount(pairs[1], minlength=count)
    users = np.split(pairs[1], np.cumsum(np.bincount(pairs[0], minlength=count))[:-1])
    ready, place, done = list(np.flatnonzero(waits == 0)), np.empty(count, dtype=np.intp), 0
    while ready:
        block = ready.pop()
        place[block], done = done, done + 1
        waits[users[block]] -= 1
        ready.extend(z for z in users[block] if waits[z] == 0)
    return place


class BlockFactors:
    """LU factors of a matrix in block lower triangular form."""

    def __init__(self, form: BlockForm, stored: Array) -> None:
        self._form = form
        self._stored = stored
        self._pivots = np.empty(form.size, dtype=np.uintp)
        first = ffi.from_buffer("double[]", stored)
        self._pointers = form.form, first, ffi.from_buffer("size_t[]", self._pivots), first + form.diagonal
        self.regular = lib.flexel_factor_blocks(*self._pointers[:3]) == 0

    def solve(self, b: Array, transposed: bool = False) -> Array:
        """Solution of A x = b, or of A' x = b, for one or several columns."""
        before, after = self._form.rows, self._form.columns
        if transposed:
            before, after = after, before
        x = np.ascontiguousarray(b[before], dtype=np.float64)
        run = lib.flexel_solve_blocks_transposed if transposed else lib.flexel_solve_blocks
        if x.size:
            run(*self._pointers, x.size // x.shape[0], ffi.from_buffer("double[]", x))
        found = np.empty_like(x)
        found[after] = x
        return found


class ExchangedFactors:
    """Factors of a matrix that differs from a factorized one in a few rows: those of rolling conditions.

    The factorized matrix is [L; D; K], this one [L; S; D], with as many rows in S as in K.

    Parameters
    ----------
    factors : Solvable
        Of [L; D; K], regular.
    S : ndarray (k, n)
    after : int
        Rows of L.
    """

    def __init__(self, factors: Solvable, S: Array, after: int) -> None:
        k, n = S.shape
        self._factors, self._S, self._first, self._k = factors, S, after, k
        self._W = factors.solve(np.eye(n)[:, n - k :])
        self._small = Factorization(np.asfortranarray(S @ self._W))
        self.regular = self._small.regular

    def solve(self, b: Array, transposed: bool = False) -> Array:
        """Solution of A x = b, or of A' x = b, for one or several columns."""
        i, k = self._first, self._k
        if transposed:
            last = self._factors.solve(b, transposed=True)[b.shape[0] - k :]
            mu = self._small.solve(last, transposed=True)
            rest = self._factors.solve(b - self._S.T @ mu, transposed=True)
            return np.concatenate([rest[:i], mu, rest[i : b.shape[0] - k]])
        x = self._factors.solve(np.concatenate([b[:i], b[i + k :], np.zeros_like(b[:k])]))
        change: Array = self._W @ self._small.solve(b[i : i + k] - self._S @ x)
        return x + change
