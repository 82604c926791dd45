"""Computes eigenvalues of first-order equations, exact where they are zero."""

from __future__ import annotations

from typing import Any

import numpy as np
from scipy.linalg import eig, matrix_balance

from flexel.base.arrays import Array, ComplexArray

ROUNDING = 64 * float(np.finfo(float).eps)  # entries, relative to the largest, that may come from rounding
CERTAIN = 4.0  # error bounds of an eigenvalue below which it counts as zero

_eig: Any = eig
_balance: Any = matrix_balance


def spectrum(A: Array, nd: int) -> tuple[ComplexArray, ComplexArray, ComplexArray]:
    """Compute the eigenvalues of a state matrix (n, n), with left and right eigenvectors in columns.

    The eigenvalues of rigid-body motions are zero, but often defective: numerically, they are as large as a root of the
    rounding errors.  The matrix without entries at rounding level has a number of zero eigenvalues: as many of the
    smallest are set to zero, if they are no larger than this root.

    Parameters
    ----------
    A : ndarray (n, n)
    nd : int
        Number of rates, which are the first states.
    """
    if not np.isfinite(A).all():
        raise np.linalg.LinAlgError("the matrix has entries that are not finite")
    if not A.size:
        none = np.zeros((0, 0), dtype=complex)
        return np.zeros(0, dtype=complex), none, none
    found, left, right = _eig(A, left=True, right=True)
    w = np.asarray(found, dtype=complex)
    frequency = float(np.sqrt(np.abs(A[:nd, nd:]).max(initial=0.0))) or 1.0
    scale = np.ones(len(A))
    scale[:nd] = 1 / frequency  # values and rates alike
    scaled = scale[:, None] * A / scale
    limit = ROUNDING * float(np.abs(scaled).max())
    order = np.argsort(np.abs(w), kind="stable")
    least = order[: _zeros(np.where(np.abs(scaled) > limit, scaled, 0.0))]
    w[least[np.abs(w[least]) <= np.sqrt(ROUNDING) * np.abs(scaled).max()]] = 0.0
    return w, left, right


def _zeros(A: Array) -> int:
    """Count the eigenvalues smaller than their error bounds: rounding, times norm, times condition."""
    balanced = _balance(A, permute=False)[0]
    w, left, right = _eig(balanced, left=True, right=True)
    product = np.abs((left.conj() * right).sum(axis=0))
    condition = 1 / np.maximum(product, np.finfo(float).tiny)
    bound = CERTAIN * np.finfo(float).eps * np.linalg.norm(balanced) * condition
    return int(np.sum(np.abs(w) <= bound))
