"""Null spaces of matrices of constraints."""

import numpy as np

from flexel.base.arrays import Array

RANK_TOLERANCE = 1e-9  # singular value of the row-scaled matrix that counts as zero


def null_space(A: Array, columns: int) -> tuple[Array, Array]:
    """Return the right null space (columns, r) and left null space (rows, l) of a matrix with scaled rows."""
    if not A.shape[0]:
        return np.eye(columns), np.zeros((0, 0))
    scale = np.linalg.norm(A, axis=1)
    if np.any(scale == 0):
        left = np.eye(A.shape[0])[:, scale == 0]
        return null_space(A[scale > 0], columns)[0], left
    U, s, Vt = np.linalg.svd(A / scale[:, None])
    rank = int(np.sum(s > RANK_TOLERANCE * s[0]))
    return Vt[rank:].T, U[:, rank:]
