"""Analytic linearization about any state, holonomic or not; nothing is differentiated numerically.

Symbols as in the formulation: G = dx/dq, H = dv/dq_d', N = dv/dq, A_q, A_v; M̄ δq_d'' + C̄ δq_d' + K̄ δq + Z δz = F̄
δu, δq_k' = 𝒜 δq_d' + ℬ δq, and for internal states of laws δz' = Z_v δq_d' + Z_q δq + Z_z δz.
Source: Schwab and Meijaard (2003), "Dynamics of flexible multibody systems with
non-holonomic constraints: a finite element approach"; Meijaard (1991).
"""

from __future__ import annotations

import numpy as np

from flexel.base.arrays import Array
from flexel.engine.derivatives import Derivatives, derivatives_of
from flexel.mechanics.inertia import massless
from flexel.mechanics.kinematics import Kinematics
from flexel.mechanics.linearization import Linearization
from flexel.mechanics.transfer import Transfer
from flexel.structure.state import State, own_state


def transfer_functions(kinematics: Kinematics, T: Derivatives) -> Transfer:
    """First- and second-order transfer functions and their derivatives at the position in the workspace.

    Raises
    ------
    ConstraintError
        If the degrees of freedom do not determine position and velocities.
    """
    roles, nf = kinematics.roles, kinematics.structure.nf
    choice = kinematics.given(float(kinematics.choice.work.struct.t))
    choice.reset()
    kinematics.check(choice.directions(), choice.work.struct.t)
    nr, nu, nd, nq = roles.rigid.size, roles.prescribed.size, roles.nd, roles.nq
    unit = np.eye(nf)
    G = choice.positions_for(np.hstack([unit[:, nr + nu :], unit[:, nr : nr + nu]]))
    H = choice.rates_for(np.hstack([unit[:, nf - nd :], unit[:, nr : nr + nu]]))
    rows = kinematics.velocity_rows
    N = -choice.rates_for(rows.times(T.Phi_x, G))
    by_v = rows.times(T.Psi_v, np.hstack([N, H]))
    by_v[:, : nq + nu] += rows.times(T.Psi_x, G)
    both = -choice.rates_for(by_v)
    return Transfer(G, N, H, both[:, : nq + nu], both[:, nq + nu :])


def linearize(kinematics: Kinematics, state: State) -> Linearization:
    """Linearized equations of motion about a complete state."""
    structure, roles = kinematics.structure, kinematics.roles
    own_state(structure, state, "linearize")
    nd, nq, nz = roles.nd, roles.nq, structure.nz
    T = derivatives_of(kinematics.evaluation, state)
    X = transfer_functions(kinematics, T)
    mass, free, kinematic = kinematics.free_mass, kinematics.free_tangent, kinematics.kinematic_rows
    H, columns = X.H[:, :nd], np.cumsum([nd + roles.prescribed.size, nd + roles.prescribed.size])
    by_M = H.T @ mass.times(T.M, np.hstack([X.H, X.A_v, X.A_q]))
    by_v = H.T @ free.times(T.r_v, np.hstack([X.H, X.N]))
    Mbar, *rest = np.split(by_M, columns, axis=1)
    Cbar, by_N = np.split(by_v, columns[:1], axis=1)
    Cbar, Kbar = Cbar + rest[0], H.T @ free.times(T.r_x, X.G) + by_N + rest[1]
    Jk, B_k = np.split(kinematic.times(T.J, np.hstack([X.H, X.N])), columns[:1], axis=1)
    A_k, B_k = Jk, kinematic.times(T.Phi_x, X.G) + B_k
    Z, Z_v, Z_q, zd_z = _lagging(kinematics, T, X) if nz else _no_lags(X, nd)
    if nd and np.linalg.eigvalsh(Mbar[:, :nd])[0] <= 0:
        raise massless(structure, roles, Mbar[:, :nd])
    names = structure.names
    return Linearization(
        M=Mbar[:, :nd],
        C=Cbar[:, :nd],
        K=Kbar[:, :nq],
        A_k=A_k[:, :nd],
        B_k=B_k[:, :nq],
        M_u=Mbar[:, nd:],
        C_u=Cbar[:, nd:],
        K_u=Kbar[:, nq:],
        A_ku=A_k[:, nd:],
        B_ku=B_k[:, nq:],
        Z=Z,
        Z_v=Z_v[:, :nd],
        Z_q=Z_q[:, :nq],
        Z_z=zd_z,
        Z_vu=Z_v[:, nd:],
        Z_qu=Z_q[:, nq:],
        dynamic=tuple(names[i] for i in roles.dynamic),
        kinematic=tuple(names[i] for i in roles.kinematic),
        prescribed=tuple(names[i] for i in roles.prescribed),
        internal=tuple(structure.internal),
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
