"""Factorizations of matrices with a fixed pattern of entries, chosen once by that pattern.

Dense LAPACK where the matrix is small; banded LAPACK after reverse Cuthill-McKee for chains and ropes, with
the few unknowns that couple to everything (a drum under a rope) kept apart in a border; `splu` otherwise.  The
entries are summed directly into the storage of the factorization.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np
from scipy.linalg import get_lapack_funcs
from scipy.sparse import coo_array, csc_array, csr_array, issparse
from scipy.sparse.csgraph import reverse_cuthill_mckee
from scipy.sparse.linalg import splu

from flexel.base.arrays import Array, Index
from flexel.engine.assembly import summed

_getrf: Any = get_lapack_funcs("getrf", dtype=np.float64)
_getrs: Any = get_lapack_funcs("getrs", dtype=np.float64)
_gecon: Any = get_lapack_funcs("gecon", dtype=np.float64)
_gbtrf: Any = get_lapack_funcs("gbtrf", dtype=np.float64)
_gbtrs: Any = get_lapack_funcs("gbtrs", dtype=np.float64)
_splu: Any = splu
_issparse: Any = issparse
SMALL = 100  # unknowns below which a dense factorization is always the fastest
LARGEST_DENSE = 1500
MOST_HUBS = 64  # unknowns in the border of a banded matrix
KINDS = ("dense", "banded", "sparse")


class Factors(Protocol):
    """A factorized square matrix."""

    @property
    def regular(self) -> bool:
        """False if a pivot is exactly zero."""

    def solve(self, b: Array) -> Array:
        """Solution of A x = b, for one or several columns."""


class Factorization:
    """LU factors of a dense square matrix; row scaling is up to the caller."""

    def __init__(self, matrix: Array) -> None:
        self._matrix = matrix
        self._lu: Array = matrix
        self._pivots: Any = None
        self._info = 0
        if matrix.size:
            self._lu, self._pivots, self._info = _getrf(matrix)

    @property
    def regular(self) -> bool:
        """False if a pivot is exactly zero."""
        return self._info == 0

    @property
    def rcond(self) -> float:
        """Estimate of the reciprocal condition number in the 1-norm."""
        if not self._lu.size:
            return 1.0
        return float(_gecon(self._lu, np.abs(self._matrix).sum(axis=0).max())[0])

    def solve(self, b: Array, transposed: bool = False) -> Array:
        """Solution of A x = b, or of A' x = b."""
        if not self._lu.size or not b.size:
            return np.zeros(b.shape)
        x: Array = _getrs(self._lu, self._pivots, b, trans=1 if transposed else 0)[0]
        return x


class SparseFactors:
    """LU factors of a sparse square matrix."""

    def __init__(self, matrix: Any) -> None:
        self._lu: Any = None
        try:
            self._lu = _splu(matrix)
        except RuntimeError as error:  # SuperLU's only report of a zero pivot
            if "singular" not in str(error):
                raise

    @property
    def regular(self) -> bool:
        """False if a pivot is exactly zero."""
        return self._lu is not None

    def solve(self, b: Array, transposed: bool = False) -> Array:
        """Solution of A x = b, or of A' x = b."""
        x: Array = self._lu.solve(b, trans="T" if transposed else "N")
        return x


class Solvable(Protocol):
    """A factorized square matrix that also solves with its transpose."""

    @property
    def regular(self) -> bool:
        """False if a pivot is exactly zero."""

    def solve(self, b: Array, transposed: bool = False) -> Array:
        """Solution of A x = b, or of A' x = b, for one or several columns."""


def factorize(matrix: Any) -> Solvable:
    """LU factors of a dense or sparse square matrix."""
    return SparseFactors(csc_array(matrix)) if _issparse(matrix) else Factorization(matrix)


@dataclass(frozen=True)
class Band:
    """A band matrix with a border: the order of the unknowns, and the width of the band."""

    order: Index  # unknowns in the order of the band, the border's last
    inner: int  # unknowns in the band
    width: int  # of either side

    @property
    def lines(self) -> int:
        """Rows of LAPACK's band storage, including space for row interchanges."""
        return 3 * self.width + 1

    def slots(self, rows: Index, columns: Index) -> Index:
        """Places of entries in the storage [band | right border | lower border | corner]."""
        place = np.empty(self.order.size, dtype=np.intp)
        place[self.order] = np.arange(self.order.size)
        i, j, n, h = place[rows], place[columns], self.inner, self.order.size - self.inner
        start = n * self.lines
        inside = j * self.lines + 2 * self.width + i - j
        right = start + (j - n) * n + i
        lower = start + h * n + (i - n) * n + j
        corner = start + 2 * h * n + (i - n) * h + j - n
        slots: Index = np.where(i < n, np.where(j < n, inside, right), np.where(j < n, lower, corner))
        return slots

    @property
    def size(self) -> int:
        """Length of the storage."""
        h = self.order.size - self.inner
        return self.inner * self.lines + 2 * h * self.inner + h * h


class BandFactors:
    """LU factors of a band matrix with a border: the band first, then the Schur complement of the border."""

    def __init__(self, band: Band, stored: Array) -> None:
        n, h, w = band.inner, band.order.size - band.inner, band.width
        self._band = band
        start = n * band.lines
        ab = stored[:start].reshape(n, band.lines).T
        self._lu, self._pivots, info = _gbtrf(ab, w, w)
        self.regular = info == 0
        self._right = np.zeros((n, 0))
        self._lower = stored[start + h * n : start + 2 * h * n].reshape(h, n)
        self._corner = Factorization(np.zeros((0, 0)))
        if h and self.regular:
            right = stored[start : start + h * n].reshape(h, n).T
            self._right = self._inside(right)
            corner = stored[start + 2 * h * n :].reshape(h, h)
            self._corner = Factorization(corner - self._lower @ self._right)
            self.regular = self._corner.regular

    def _inside(self, b: Array) -> Array:
        x: Array = _gbtrs(self._lu, self._band.width, self._band.width, b, self._pivots)[0]
        return x

    def solve(self, b: Array) -> Array:
        """Solution of A x = b."""
        band = self._band
        y = b[band.order]
        inner = self._inside(y[: band.inner])
        if band.inner < band.order.size:
            outer = self._corner.solve(y[band.inner :] - self._lower @ inner)
            inner = inner - self._right @ outer
            y[band.inner :] = outer
        y[: band.inner] = inner
        x = np.empty_like(y)
        x[band.order] = y
        return x


class Pattern:
    """Pattern of the entries of a square matrix, its storage, and its factorization.

    Parameters
    ----------
    rows, columns : ndarray of int (entries,)
        Position of each entry; several entries of one position are summed, those outside are dropped.
    size : int
        Unknowns.
    kind : str, optional
        dense, banded or sparse; by default the one expected to be fastest.
    """

    def __init__(self, rows: Index, columns: Index, size: int, kind: str | None = None) -> None:
        self.size = size
        inside = (rows < size) & (columns < size)
        flat = np.where(inside, columns * size + rows, -1)
        unique, self._position = np.unique(flat, return_inverse=True)
        self._first = int(unique.size > 0 and unique[0] < 0)  # the dropped entries come first
        unique = unique[self._first :]
        self._rows, self._columns = unique % max(size, 1), unique // max(size, 1)
        self._band = None if size <= SMALL and kind is None else _band(self._rows, self._columns, size)
        self.kind = kind or self._fastest()
        self._slots, self._length = self._storage()
        self._sparse_index: Index | None = None

    @property
    def description(self) -> str:
        """How the matrix is factorized, in words."""
        if self.kind == "banded" and self._band is not None:
            border = self.size - self._band.inner
            return f"banded, half width {self._band.width}" + (f", border {border}" if border else "")
        return self.kind

    def _fastest(self) -> str:
        n, band = self.size, self._band
        if n <= SMALL or band is None:
            return "dense"
        h, w = n - band.inner, band.width
        seconds = {  # measured rates of LAPACK and SuperLU on one core
            "banded": band.inner * (5e-8 + 4 * w * w / 2e9 + h * (3 * w + h) / 1e9),
            "sparse": 1e-4 + 7e-8 * self._rows.size,
        }
        if n <= LARGEST_DENSE:
            seconds["dense"] = n**3 * 2 / 3 / 4e9
        return min(seconds, key=lambda z: seconds[z])

    def _storage(self) -> tuple[Index, int]:
        """Slot of every entry in the storage, dropped ones beyond its end; and the storage's length."""
        if self.kind == "dense":
            places, length = self._columns * self.size + self._rows, self.size**2
        elif self.kind == "banded" and self._band is not None:
            places, length = self._band.slots(self._rows, self._columns), self._band.size
        else:
            places, length = np.arange(self._rows.size), self._rows.size
        self._places = places
        return np.concatenate([np.full(self._first, length), places])[self._position], length

    def assemble(self, entries: Array) -> Array:
        """The matrix in its storage, from its entries in the order in which the positions were given."""
        return summed(self._slots, entries, self._length + 1)[: self._length]

    def factorize(self, stored: Array) -> Factors:
        """LU factors of a stored matrix."""
        if self.kind == "dense":
            return Factorization(stored.reshape(self.size, self.size).T)
        if self.kind == "banded" and self._band is not None:
            factors = BandFactors(self._band, stored)
            if factors.regular or self._band.inner == self.size:
                return factors
        return SparseFactors(self.matrix(stored))  # a border may leave a singular band in a regular matrix

    def matrix(self, stored: Array) -> Any:
        """The stored matrix as a scipy.sparse array."""
        indptr = np.searchsorted(self._columns, np.arange(self.size + 1))
        shape = (self.size, self.size)
        return csc_array((stored[self._places], self._rows, indptr), shape=shape)


def _band(rows: Index, columns: Index, size: int) -> Band:
    """Order of the unknowns with a narrow band, hubs apart."""
    graph = csr_array(coo_array((np.ones(rows.size), (rows, columns)), shape=(size, size)))
    graph = csr_array(graph + graph.T)
    degree = np.diff(graph.indptr)
    usual = 3 * float(np.median(degree)) + 8
    hubs = np.flatnonzero(degree > usual)
    if hubs.size > MOST_HUBS:
        hubs = hubs[:0]
    apart = np.zeros(size, dtype=bool)
    apart[hubs] = True
    # an unknown that touches hubs alone (a multiplier of a hub's own condition) has an empty row in the band
    touched = graph @ (~apart).astype(float)
    apart |= touched == 0
    inner = np.flatnonzero(~apart)
    part = csr_array(graph[inner][:, inner])
    order = inner[reverse_cuthill_mckee(part, symmetric_mode=True)] if inner.size else inner
    place = np.empty(size, dtype=np.intp)
    place[order] = np.arange(order.size)
    both = ~(apart[rows] | apart[columns])
    width = int(np.abs(place[rows[both]] - place[columns[both]]).max(initial=0))
    return Band(np.concatenate([order, np.flatnonzero(apart)]), inner.size, width)
