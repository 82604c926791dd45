"""Coefficients of small vibrations about a motion: rolling and internal states of laws as equations of first order."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from flexel.base.arrays import Array
from flexel.linear.harmonics import Coefficients
from flexel.mechanics.linearized_system import LinearizedSystem


def coefficients(period: float, samples: Sequence[LinearizedSystem], forces: Array) -> Coefficients:
    """Return the equations of (q_d, q_k, z) over a period; those of q_k and z are of first order.

    Parameters
    ----------
    period : float
        [s]
    samples : sequence of LinearizedSystem
        At equidistant times.
    forces : ndarray (ns, n) or (ns, nd)
        Right-hand sides; zero for equations of first order that are not given.
    """
    first = samples[0]
    names = first.dofs + first.internal
    ns, nd, nq, n = len(samples), len(first.dynamic), len(first.dofs), len(names)
    M, C, K, F = np.zeros((ns, n, n)), np.zeros((ns, n, n)), np.zeros((ns, n, n)), np.zeros((ns, n))
    C[:, nd:, nd:] = np.eye(n - nd)
    F[:, : forces.shape[1]] = forces
    for i, lin in enumerate(samples):
        M[i, :nd, :nd], C[i, :nd, :nd] = lin.M, lin.C
        K[i, :nd, :nq], K[i, :nd, nq:] = lin.K, lin.Z
        C[i, nd:nq, :nd], K[i, nd:nq, :nq] = -lin.A_k, -lin.B_k
        C[i, nq:, :nd], K[i, nq:, :nq], K[i, nq:, nq:] = -lin.Z_v, -lin.Z_q, -lin.Z_z
    return Coefficients(2 * np.pi / period, M, C, K, F, names, second=nd)
