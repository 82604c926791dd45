"""Factorizations for one-off solutions: LAPACK for dense matrices, SuperLU for sparse ones.

Matrices that are factorized again and again have a separate class, in `flexel.engine.elimination`.
"""

from __future__ import annotations

from typing import Any, Protocol

import numpy as np
from scipy.linalg import get_lapack_funcs
from scipy.sparse import csc_array, eye_array, issparse
from scipy.sparse.linalg import splu

from flexel.base.arrays import Array, ComplexArray

_getrf: Any = get_lapack_funcs("getrf", dtype=np.float64)
_getrs: Any = get_lapack_funcs("getrs", dtype=np.float64)
_gelsy: Any = get_lapack_funcs("gelsy", dtype=np.float64)
_gesv: Any = get_lapack_funcs("gesv", dtype=np.float64)
_potrf: Any = get_lapack_funcs("potrf", dtype=np.float64)
_gesdd: Any = get_lapack_funcs("gesdd", dtype=np.float64)
_geev: Any = get_lapack_funcs("geev", dtype=np.float64)
_splu: Any = splu
_issparse: Any = issparse


# For matrices of a few rows NumPy's own functions spend most of their time on checks.


def solved(A: Array, b: Array) -> Array:
    """Solve A x = b for a small matrix (n, n) and columns (n, r).

    Raises
    ------
    numpy.linalg.LinAlgError
        If the matrix is singular.
    """
    if not b.size:
        return np.zeros(b.shape)
    _, _, x, info = _gesv(A, b)
    if info:
        raise np.linalg.LinAlgError("Singular matrix")
    return np.asarray(x)


def definite(A: Array) -> bool:
    """Whether a symmetric matrix (n, n) is positive definite."""
    return not A.size or _potrf(A)[1] == 0


def eigenvalues(A: Array) -> ComplexArray:
    """Compute the eigenvalues (n,) of a matrix (n, n).

    Raises
    ------
    numpy.linalg.LinAlgError
        If the matrix is not finite, or the iteration does not converge.
    """
    if not np.isfinite(A).all():
        raise np.linalg.LinAlgError("the matrix has entries that are not finite")
    if not A.size:
        return np.zeros(0, dtype=complex)
    real, imaginary, _, _, info = _geev(A, compute_vl=0, compute_vr=0)
    if info:
        raise np.linalg.LinAlgError("the eigenvalues did not converge")
    return np.asarray(real + 1j * imaginary)


def least(A: Array, b: Array, rcond: float) -> Array:
    """Find the smallest x that minimizes |A x - b|, for a small matrix (r, n) and a vector (r,).

    Columns that depend on others up to `rcond` of the largest count as dependent.
    """
    r, n = A.shape
    if not A.size:
        return np.zeros(n)
    padded = np.zeros(max(r, n))
    padded[:r] = b
    found: Array = _gelsy(A, padded, np.zeros(n, dtype=np.int32), rcond, 64 * (r + n + 1))[1]
    return found[:n]


def singular_values(A: Array) -> tuple[Array, Array, Array]:
    """Compute U (r, k), s (k,) and V (n, n) of A = U diag(s) V[:k], k = min(r, n), for a small matrix (r, n).

    Raises
    ------
    numpy.linalg.LinAlgError
        If the iteration does not converge.
    """
    r, n = A.shape
    if not A.size:
        return np.zeros((r, 0)), np.zeros(0), np.eye(n)
    U, s, V, info = _gesdd(A, full_matrices=r < n)
    if info:
        raise np.linalg.LinAlgError("the singular values did not converge")
    return U, s, V


class Factorization:
    """LU factors of a dense square matrix; row scaling is up to the caller."""

    def __init__(self, matrix: Array) -> None:
        self._lu: Array = matrix
        self._pivots: Any = None
        self._info = 0
        if matrix.size:
            self._lu, self._pivots, self._info = _getrf(matrix)

    @property
    def regular(self) -> bool:
        """False if a pivot is exactly zero."""
        return self._info == 0

    def solve(self, b: Array, transposed: bool = False) -> Array:
        """Solve A x = b, or A' x = b."""
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
        """Solve A x = b, or A' x = b."""
        x: Array = self._lu.solve(b, trans="T" if transposed else "N")
        return x


SHIFT = 1e-12  # of the diagonal, relative to the largest entry, with which a singular matrix is factorized
ITERATIONS = 4  # of inverse iteration
ROUNDING = 1e-9  # entries of a null vector, relative to the largest, that count as zero
# Entries of its image, over the sums of their terms, and over the largest entry of the matrix.
CANCELLING, BELOW = 1e-11, 1e-14


def null_vector(matrix: Any) -> Array | None:
    """Find a unit vector (n,) that a sparse matrix (n, n) maps to zero; return None if the matrix is regular.

    By inverse iteration with a small shift of the diagonal.
    """
    n, size = matrix.shape[0], float(abs(matrix).max()) or 1.0
    shifted = SparseFactors(csc_array(matrix + SHIFT * size * eye_array(n)))
    if not shifted.regular:
        return None
    x = np.cos(np.arange(n, dtype=float))  # any vector that is not orthogonal to it
    for _ in range(ITERATIONS):
        x = shifted.solve(x)
        x /= np.abs(x).max()
    image, terms = np.abs(matrix @ x), abs(matrix) @ np.abs(x)
    if np.any(image > CANCELLING * terms + BELOW * size):
        return None
    x[np.abs(x) < ROUNDING] = 0.0
    return x


class Solvable(Protocol):
    """A factorized square matrix that also solves with its transpose."""

    @property
    def regular(self) -> bool:
        """False if a pivot is exactly zero."""

    def solve(self, b: Array, transposed: bool = False) -> Array:
        """Solve A x = b, or A' x = b, for one or several columns."""


def factorize(matrix: Any) -> Solvable:
    """Factorize a dense or sparse square matrix."""
    return SparseFactors(csc_array(matrix)) if _issparse(matrix) else Factorization(matrix)
