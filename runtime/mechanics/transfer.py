"""Geometric transfer functions: derivatives of coordinates, rates and accelerations by the degrees of freedom."""

from __future__ import annotations

from dataclasses import dataclass

from flexel.base.arrays import Array


@dataclass(frozen=True)
class GeometricTransfer:
    """Geometric transfer functions at a state, for the degrees of freedom and the prescribed motions u together.

    Attributes
    ----------
    G, N, A_q : ndarray (nf, nq + nu)
        Derivatives of x, v, a with respect to (q, u) at fixed rates of the others.
    H, A_v : ndarray (nf, nd + nu)
        Derivatives of v and a with respect to (q_d', u'); H is also that of a to (q_d'', u'').
    """

    G: Array
    N: Array
    H: Array
    A_q: Array
    A_v: Array
