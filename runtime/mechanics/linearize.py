"""Analytic linearization about any state, holonomic or not; nothing is differentiated numerically.

Symbols as in the formulation: G = dx/dq, H = dv/dq_d', N = dv/dq, A_q, A_v; M̄ δq_d'' + C̄ δq_d' + K̄ δq + Z δz = F̄
δu, δq_k' = 𝒜 δq_d' + ℬ δq, and for internal states of laws δz' = Z_v δq_d' + Z_q δq + Z_z δz.
Source: Schwab and Meijaard (2003), "Dynamics of flexible multibody systems with
non-holonomic constraints: a finite element approach"; Meijaard (1991).
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from flexel.base.arrays import Array
from flexel.engine.derivatives import Derivatives, check_laws
from flexel.engine.solvers import definite
from flexel.mechanics.inertia import massless
from flexel.mechanics.kinematics import Kinematics
from flexel.mechanics.linearization import Linearization
from flexel.mechanics.transfer import Transfer
from flexel.structure.state import State, own_state


def linearize(kinematics: Kinematics, state: State) -> Linearization:
    """Linearized equations of motion about a complete state.

    Raises
    ------
    ConstraintError
        If the degrees of freedom do not determine position and velocities.
    TangentError, InertiaError
        If a law has no slope there; if a degree of freedom moves no mass.
    """
    return linearize_all(kinematics, [state])[0]


def linearize_all(kinematics: Kinematics, states: Sequence[State]) -> list[Linearization]:
    """The same about several states, each as if it were alone, in one call of the engine."""
    structure, roles, linearizer = kinematics.structure, kinematics.roles, kinematics.linearizer
    for state in states:
        own_state(structure, state, "linearize")
    found = linearizer.run(kinematics.choice, states)
    for i in range(found.done + bool(found.code)):
        check_laws(kinematics.evaluation, linearizer.slopes(found, i), states[i].t)
    if found.code:
        raise kinematics.failure(found.code, states[found.done].t)
    transfers = [linearizer.transfer(found, i) for i in range(len(states))]
    matrices = [z[1][:, : roles.nd].T @ factors for z, factors in zip(transfers, found.factors, strict=True)]
    for z in matrices:
        if not definite(z[:, : roles.nd]):
            raise massless(structure, roles, z[:, : roles.nd])
    parts = zip(states, matrices, transfers, strict=True)
    return [_assembled(kinematics, *part, linearizer.derivatives(found, i)) for i, part in enumerate(parts)]


def _assembled(
    kinematics: Kinematics, state: State, matrices: Array, transfer: list[Array], T: Derivatives
) -> Linearization:
    """Names and blocks of [M C K], transfer functions and derivatives at a state."""
    roles, width = kinematics.roles, kinematics.linearizer.width
    nd, nq, nu = roles.nd, roles.nq, roles.prescribed.size
    r, p = slice(0, nd + nu), slice(width, width + nq + nu)
    dynamic, kinematic, prescribed = kinematics.role_names
    G, first, second, rolling = transfer
    X = Transfer(G[:, : nq + nu], first[:, p], first[:, r], second[:, p], second[:, r])
    (M, M_u), (C, C_u) = ((z[:, :nd], z[:, nd : nd + nu]) for z in (matrices, matrices[:, width:]))
    (K, K_u), (B, B_u) = (
        (z[:, :nq], z[:, nq : nq + nu]) for z in (matrices[:, 2 * width :], rolling[:, width:])
    )
    Z, Z_v, Z_q, zd_z = _lagging(kinematics, T, X) if kinematics.structure.nz else _no_lags(X, nd)
    return Linearization(
        M=M,
        C=C,
        K=K,
        A_k=rolling[:, :nd],
        B_k=B,
        M_u=M_u,
        C_u=C_u,
        K_u=K_u,
        A_ku=rolling[:, nd : nd + nu],
        B_ku=B_u,
        Z=Z,
        Z_v=Z_v[:, :nd],
        Z_q=Z_q[:, :nq],
        Z_z=zd_z,
        Z_vu=Z_v[:, nd:],
        Z_qu=Z_q[:, nq:],
        dynamic=dynamic,
        kinematic=kinematic,
        prescribed=prescribed,
        internal=tuple(kinematics.structure.internal),
        state=state,
        transfer=X,
        derivatives=T,
    )


def _lagging(kinematics: Kinematics, T: Derivatives, X: Transfer) -> tuple[Array, Array, Array, Array]:
    """Z, Z_v, Z_q and Z_z of the laws' internal states."""
    s, nf, nd = kinematics.structure, kinematics.structure.nf, kinematics.roles.nd
    zd_x, zd_v, zd_z = T.lags
    zd_x, zd_v = zd_x[:, :nf], zd_v[:, :nf]
    J = kinematics.evaluation.tables.J.matrix(T.J)[: s.m + s.k][:, :nf]
    return X.H[:, :nd].T @ (J.T @ T.stress_z), zd_v @ X.H, zd_x @ X.G + zd_v @ X.N, zd_z


def _no_lags(X: Transfer, nd: int) -> tuple[Array, Array, Array, Array]:
    """The same without internal states."""
    none = np.zeros
    return none((nd, 0)), none((0, X.H.shape[1])), none((0, X.G.shape[1])), none((0, 0))
