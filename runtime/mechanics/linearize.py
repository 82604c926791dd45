"""Linearizes analytically about any state, holonomic or not; nothing is differentiated numerically.

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
from flexel.engine.linearizer import Linearized
from flexel.engine.solvers import definite
from flexel.mechanics.inertia import massless
from flexel.mechanics.kinematics import Kinematics
from flexel.mechanics.linearized_system import LinearizedSystem
from flexel.mechanics.transfer import GeometricTransfer
from flexel.mechanics.variation import Afterwards
from flexel.model.state import State, own_state


def linearize(kinematics: Kinematics, state: State) -> LinearizedSystem:
    """Linearize the equations of motion about a complete state.

    Raises
    ------
    ConstraintError
        If the degrees of freedom do not determine position and velocities.
    TangentError, InertiaError
        If a law has no slope there; if a degree of freedom moves no mass.
    """
    return linearize_all(kinematics, [state])[0]


def linearize_all(kinematics: Kinematics, states: Sequence[State]) -> list[LinearizedSystem]:
    """Linearize about several states in one call of the engine; each result is independent of the others."""
    for state in states:
        own_state(kinematics.structure, state, "linearize")
    rows = kinematics.linearizer.rows(states)
    found = linearized(kinematics, rows)
    return [found.about(state, i) for i, state in enumerate(states)]


def linearized(kinematics: Kinematics, rows: Array) -> Stack:
    """Linearize at complete states in rows, see `Linearizer.rows`; raises as `linearize`."""
    structure, roles, linearizer = kinematics.structure, kinematics.roles, kinematics.linearizer
    found = linearizer.run(kinematics.choice, rows)
    for i in range(found.done + bool(found.code)):
        check_laws(kinematics.evaluation, linearizer.slopes(found, i), float(rows[i, 0]))
    if found.code:
        raise kinematics.failure(found.code, float(rows[found.done, 0]))
    transfers = linearizer.transfers(found)
    matrices = transfers[1][:, :, : roles.nd].transpose(0, 2, 1) @ found.factors
    matrices[:, :, linearizer.width :] += found.laws
    for matrix in matrices:
        if not definite(matrix[:, : roles.nd]):
            raise massless(structure, roles, matrix[:, : roles.nd])
    return Stack(kinematics, found, transfers, matrices)


class Stack:
    """Linearized equations at some states of one choice of degrees of freedom.

    Attributes
    ----------
    blocks : dict of str to ndarray (states, rows, columns)
        M, C, K, A_k, B_k and those of the prescribed motions, by the names of `Linearization`.
    """

    def __init__(
        self, kinematics: Kinematics, found: Linearized, transfers: list[Array], matrices: Array
    ) -> None:
        self.kinematics, self.found, self._transfers = kinematics, found, transfers
        roles, width = kinematics.roles, kinematics.linearizer.width
        nd, nq, nu = roles.nd, roles.nq, roles.prescribed.size
        rolling = transfers[3]
        parts = {
            ("M", "M_u", nd): matrices,
            ("C", "C_u", nd): matrices[:, :, width:],
            ("K", "K_u", nq): matrices[:, :, 2 * width :],
            ("A_k", "A_ku", nd): rolling,
            ("B_k", "B_ku", nq): rolling[:, :, width:],
        }
        self.blocks: dict[str, Array] = {}
        for (own, prescribed, size), block in parts.items():
            self.blocks[own], self.blocks[prescribed] = block[:, :, :size], block[:, :, size : size + nu]

    @property
    def H(self) -> Array:  # noqa: N802
        """First-order transfer functions (states, nf, nd)."""
        return self._transfers[1][:, :, : self.kinematics.roles.nd]

    def transfer(self, i: int) -> GeometricTransfer:
        """Return the transfer functions at state number i."""
        roles, width = self.kinematics.roles, self.kinematics.linearizer.width
        G, first, second = (transfer[i] for transfer in self._transfers[:3])
        nu = roles.prescribed.size
        r, p = slice(0, roles.nd + nu), slice(width, width + roles.nq + nu)
        return GeometricTransfer(G[:, : roles.nq + nu], first[:, p], first[:, r], second[:, p], second[:, r])

    def about(self, state: State, i: int) -> LinearizedSystem:
        """Return the equations at state number i, which is given."""
        kinematics = self.kinematics
        dynamic, kinematic, prescribed = kinematics.role_names
        X, T = self.transfer(i), kinematics.linearizer.derivatives(self.found, i)
        found = LinearizedSystem(
            **{name: block[i] for name, block in self.blocks.items()},
            **self.internal_states(X, T),
            dynamic=dynamic,
            kinematic=kinematic,
            prescribed=prescribed,
            internal=tuple(kinematics.structure.internal),
            state=state,
            transfer=X,
            derivatives=T,
        )
        # not a field: it is neither pickled nor saved
        object.__setattr__(found, "_afterwards", Afterwards(linearize_all, kinematics))
        return found

    def all_internal_states(self) -> dict[str, Array]:
        """Return the blocks of the laws' internal states at all states (states, …), by name."""
        linearizer = self.kinematics.linearizer
        numbers = range(self.found.factors.shape[0])
        some = [
            self.internal_states(self.transfer(i), linearizer.derivatives(self.found, i)) for i in numbers
        ]
        return {name: np.array([linearization[name] for linearization in some]) for name in some[0]}

    def internal_states(self, X: GeometricTransfer, T: Derivatives) -> dict[str, Array]:
        """Return Z, Z_v, Z_q and Z_z of the laws' internal states, and the part of prescribed motions."""
        s, roles = self.kinematics.structure, self.kinematics.roles
        nf, nd = s.nf, roles.nd
        if not s.nz:
            rates, values = np.zeros((0, X.H.shape[1])), np.zeros((0, X.G.shape[1]))
            return self._lag_blocks(np.zeros((nd, 0)), rates, values, np.zeros((0, 0)))
        zd_x, zd_v, zd_z = T.internal_states
        zd_x, zd_v = zd_x[:, :nf], zd_v[:, :nf]
        J = self.kinematics.evaluation.tables.J.matrix(T.J)[: s.m + s.k][:, :nf]
        Z_v, Z_q = zd_v @ X.H, zd_x @ X.G + zd_v @ X.N
        return self._lag_blocks(X.H[:, :nd].T @ (J.T @ T.stress_z), Z_v, Z_q, zd_z)

    def _lag_blocks(self, Z: Array, Z_v: Array, Z_q: Array, Z_z: Array) -> dict[str, Array]:
        nd, nq = self.kinematics.roles.nd, self.kinematics.roles.nq
        parts = {"Z": Z, "Z_v": Z_v[:, :nd], "Z_q": Z_q[:, :nq], "Z_z": Z_z}
        return parts | {"Z_vu": Z_v[:, nd:], "Z_qu": Z_q[:, nq:]}
