"""Analytic linearization about any state, holonomic or not; nothing is differentiated numerically.

Symbols as in the formulation: G = dx/dq, H = dv/dq_d', N = dv/dq, A_q, A_v; M̄ δq_d'' + C̄ δq_d' + K̄ δq + Z δz = F̄
δu, δq_k' = 𝒜 δq_d' + ℬ δq, and for internal states of laws δz' = Z_v δq_d' + Z_q δq + Z_z δz.
Source: Schwab and Meijaard (2003), "Dynamics of flexible multibody systems with
non-holonomic constraints: a finite element approach"; Meijaard (1991).
"""

from __future__ import annotations

import numpy as np

from flexel.base.errors import LinearizationError
from flexel.engine.evaluate import Tangents
from flexel.engine.solvers import Factorization
from flexel.mechanics.dynamics import solve_mass
from flexel.mechanics.kinematics import Configuration, Kinematics
from flexel.mechanics.linearization import Linearization
from flexel.mechanics.transfer import Transfer
from flexel.structure.state import State, own_state


def transfer_functions(kinematics: Kinematics, c: Configuration, T: Tangents) -> Transfer:
    """First- and second-order transfer functions and their derivatives at a configuration."""
    roles, nf = kinematics.roles, kinematics.structure.nf
    B = kinematics.velocity_matrix(c)
    P = Factorization(c.J[roles.position_rows, :nf])
    if not P.regular:
        raise LinearizationError(
            f"the degrees of freedom {kinematics.names(roles.dofs)} do not determine the position here; choose others"
        )
    nr, nu, nd = roles.rigid.size, roles.prescribed.size, roles.nd
    unit = np.eye(nf)
    G = P.solve(np.hstack([unit[:, nr + nu :], unit[:, nr : nr + nu]]))
    H = B.solve(np.hstack([unit[:, nf - nd :], unit[:, nr : nr + nu]]))
    rows = roles.velocity_rows
    Phi_x, Psi_x, Psi_v = T.Phi_x[rows, :nf], T.Psi_x[rows, :nf], T.Psi_v[rows, :nf]
    N = -B.solve(Phi_x @ G)
    return Transfer(G, N, H, -B.solve(Psi_x @ G + Psi_v @ N), -B.solve(Psi_v @ H))


def linearize(kinematics: Kinematics, state: State) -> Linearization:
    """Linearized equations of motion about a complete state."""
    structure, roles = kinematics.structure, kinematics.roles
    own_state(structure, state, "linearize")
    nf, nd, nq = structure.nf, roles.nd, roles.nq
    J = state.J
    c = Configuration(state.t, state.x, state.e, J)
    m, k, nz = structure.m, structure.k, structure.nz
    T = kinematics.evaluation.tangents(
        state.x, state.v, state.a, J, state.e, state.stresses, state.z, state.t
    )
    X = transfer_functions(kinematics, c, T)
    mass, *_ = kinematics.evaluation.inertia(state.x, state.v)
    M, r_x, r_v = mass[:nf, :nf], T.r_x[:nf, :nf], T.r_v[:nf, :nf]
    H = X.H[:, :nd]
    Mbar = H.T @ M @ X.H
    Cbar = H.T @ (r_v @ X.H + M @ X.A_v)
    Kbar = H.T @ (r_x @ X.G + r_v @ X.N + M @ X.A_q)
    Jk, Phik = J[roles.kinematic, :nf], T.Phi_x[roles.kinematic, :nf]
    A_k, B_k = Jk @ X.H, Phik @ X.G + Jk @ X.N
    Z_v, Z_q = T.zd_v[:, :nf] @ X.H, T.zd_x[:, :nf] @ X.G + T.zd_v[:, :nf] @ X.N
    Z = H.T @ (J[: m + k, :nf].T @ T.stress_z) if nz else np.zeros((nd, 0))
    if nd:
        solve_mass(kinematics, Mbar[:, :nd], np.zeros(nd))
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
        Z_z=T.zd_z,
        Z_vu=Z_v[:, nd:],
        Z_qu=Z_q[:, nq:],
        dynamic=tuple(names[i] for i in roles.dynamic),
        kinematic=tuple(names[i] for i in roles.kinematic),
        prescribed=tuple(names[i] for i in roles.prescribed),
        internal=tuple(structure.internal),
        state=state,
        transfer=X,
        tangents=T,
        mass=mass,
    )
