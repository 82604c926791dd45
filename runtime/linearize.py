"""Analytic linearization about any state, holonomic or not; nothing is differenced.

Letters as in the formulation: G = dx/dq, H = dv/dq_d', N = dv/dq, A_q, A_v; M̄ δq_d'' + C̄ δq_d' + K̄ δq + Z δz = F̄ δu,
δq_k' = 𝒜 δq_d' + ℬ δq, and for internal states of laws δz' = Z_v δq_d' + Z_q δq + Z_z δz.
Source: Schwab and Meijaard (2003), "Dynamics of flexible multibody systems with
non-holonomic constraints: a finite element approach"; Meijaard (1991).
Imports numpy, scipy.linalg and the dynamics.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import eig

from flexel import control
from flexel.dynamics import solve_mass
from flexel.errors import LinearizationError
from flexel.evaluate import Tangents
from flexel.inputs import names as checked_names
from flexel.kinematics import Configuration, Kinematics
from flexel.saved import archive_linear
from flexel.solvers import Factorization
from flexel.state import State, own_state
from flexel.structure import Array

_eig: Any = eig
ComplexArray = NDArray[np.complex128]


@dataclass(frozen=True)
class Transfer:
    """Transfer functions at a state, for the freedoms and the prescribed motions u side by side.

    Attributes
    ----------
    G, N, A_q : ndarray (nf, nq + nu)
        Derivatives of x, v, a with respect to (q, u) at fixed rates of the rest.
    H, A_v : ndarray (nf, nd + nu)
        Derivatives of v and a with respect to (q_d', u'); H is also that of a to (q_d'', u'').
    """

    G: Array
    N: Array
    H: Array
    A_q: Array
    A_v: Array


def transfer_functions(kinematics: Kinematics, c: Configuration, T: Tangents) -> Transfer:
    """First- and second-order transfer functions and their derivatives at a configuration."""
    roles, nf = kinematics.roles, kinematics.structure.nf
    B = kinematics.velocity_matrix(c)
    P = Factorization(c.J[roles.position_rows, :nf])
    if not P.regular:
        raise LinearizationError(
            f"the freedoms {kinematics.names(roles.freedoms)} do not determine the position here; choose others"
        )
    nr, nu, nd = roles.rigid.size, roles.prescribed.size, roles.nd
    unit = np.eye(nf)
    G = P.solve(np.hstack([unit[:, nr + nu :], unit[:, nr : nr + nu]]))
    H = B.solve(np.hstack([unit[:, nf - nd :], unit[:, nr : nr + nu]]))
    rows = roles.velocity_rows
    Phi_x, Psi_x, Psi_v = T.Phi_x[rows, :nf], T.Psi_x[rows, :nf], T.Psi_v[rows, :nf]
    N = -B.solve(Phi_x @ G)
    return Transfer(G, N, H, -B.solve(Psi_x @ G + Psi_v @ N), -B.solve(Psi_v @ H))


@dataclass(frozen=True)
class Mode:
    """A mode of the linearized motion.

    Attributes
    ----------
    eigenvalue : complex
        [1/s]
    shape : dict of str to complex
        Amplitude of each freedom and internal state of a law, the largest one 1.
    participation : dict of str to float
        Share of each of them (dynamic freedoms with their rates) in the mode, from left and right vectors; sums to 1.
    """

    eigenvalue: complex
    shape: dict[str, complex]
    participation: dict[str, float]

    @property
    def name(self) -> str:
        """The freedoms that take part most, joined by ``+``."""
        order = sorted(self.participation, key=lambda z: -self.participation[z])
        return "+".join(z for z in order if self.participation[z] >= 0.25 * self.participation[order[0]])

    @property
    def frequency(self) -> float:
        """Undamped natural frequency |eigenvalue| [rad/s]."""
        return abs(self.eigenvalue)

    @property
    def damping(self) -> float:
        """Damping ratio -Re/|.|; 0 for a zero eigenvalue."""
        return -self.eigenvalue.real / self.frequency if self.frequency else 0.0


@dataclass(frozen=True)
class Reduced:
    """Second-order equations of some freedoms, decoupled from the rest: M q'' + C q' + K q = 0."""

    names: tuple[str, ...]
    M: Array
    C: Array
    K: Array

    @property
    def state_matrix(self) -> Array:
        """First-order form for (q', q)."""
        n = len(self.names)
        top = -np.linalg.solve(self.M, np.hstack([self.C, self.K]))
        return np.vstack([top, np.hstack([np.eye(n), np.zeros((n, n))])])

    def eigenvalues(self) -> ComplexArray:
        """The 2 n eigenvalues [1/s], sorted by real, then imaginary part."""
        return sort_eigenvalues(np.linalg.eigvals(self.state_matrix))


def sort_eigenvalues(values: Any) -> ComplexArray:
    """Complex numbers sorted by real, then imaginary part; real parts equal to rounding count as equal."""
    w = np.asarray(values, dtype=complex)
    scale = float(np.max(np.abs(w), initial=1e-300))
    order = np.lexsort((w.imag, np.round(w.real / scale, 11)))
    return w[order]


@dataclass(frozen=True)
class Linearization:
    """Linearized equations about a state.

    Attributes
    ----------
    M, C : ndarray (nd, nd)
    K : ndarray (nd, nq)
        Columns for dynamic, then kinematic freedoms.
    A_k : ndarray (nk, nd), B_k : ndarray (nk, nq)
        𝒜 and ℬ of δq_k' = 𝒜 δq_d' + ℬ δq.
    Z : ndarray (nd, nz)
        Generalized forces of the laws' internal states: M δq_d'' + C δq_d' + K δq + Z δz = F δu.
    Z_v, Z_q, Z_z : ndarray (nz, nd), (nz, nq), (nz, nz)
        δz' = Z_v δq_d' + Z_q δq + Z_z δz.
    dynamic, kinematic, prescribed, internal : tuple of str
        Names of the freedoms, of the prescribed motions and of the laws' internal states.
    state : State
        Where it was linearized.
    """

    M: Array
    C: Array
    K: Array
    A_k: Array
    B_k: Array
    M_u: Array = field(repr=False)
    C_u: Array = field(repr=False)
    K_u: Array = field(repr=False)
    A_ku: Array = field(repr=False)
    B_ku: Array = field(repr=False)
    Z: Array = field(repr=False)
    Z_v: Array = field(repr=False)
    Z_q: Array = field(repr=False)
    Z_z: Array = field(repr=False)
    Z_vu: Array = field(repr=False)
    Z_qu: Array = field(repr=False)
    dynamic: tuple[str, ...]
    kinematic: tuple[str, ...]
    prescribed: tuple[str, ...]
    internal: tuple[str, ...]
    state: State = field(repr=False)
    transfer: Transfer = field(repr=False)
    tangents: Tangents = field(repr=False)
    mass: Array = field(repr=False)  # M (n, n) of all coordinates

    @property
    def freedoms(self) -> tuple[str, ...]:
        """Names of q = (q_d, q_k)."""
        return self.dynamic + self.kinematic

    @property
    def states(self) -> tuple[str, ...]:
        """Names of the states (q_d', q_d, q_k, z)."""
        return tuple(f"{z}'" for z in self.dynamic) + self.freedoms + self.internal

    @property
    def state_matrix(self) -> Array:
        """Matrix of the first-order equations for (δq_d', δq_d, δq_k, δz), (2 nd + nk + nz) square."""
        nd, nk, nz = len(self.dynamic), len(self.kinematic), len(self.internal)
        top = -np.linalg.solve(self.M, np.hstack([self.C, self.K, self.Z])) if nd else np.zeros((0, nk + nz))
        middle = np.hstack([np.eye(nd), np.zeros((nd, nd + nk + nz))])
        rolling = np.hstack([self.A_k, self.B_k, np.zeros((nk, nz))])
        return np.vstack([top, middle, rolling, np.hstack([self.Z_v, self.Z_q, self.Z_z])])

    def eigenvalues(self) -> ComplexArray:
        """All eigenvalues [1/s] of the state matrix, sorted by real, then imaginary part.

        The zeros of a non-holonomic system are defective and come out with large rounding errors; use
        `reduced` for the freedoms of interest.
        """
        return sort_eigenvalues(np.linalg.eigvals(self.state_matrix))

    def modes(self) -> list[Mode]:
        """Modes, sorted as the eigenvalues, one for each complex pair (the one with positive imaginary part)."""
        w, left, right = _eig(self.state_matrix, left=True, right=True)
        scale = float(np.max(np.abs(w), initial=1e-300))
        keep = [i for i in range(w.size) if w[i].imag >= -1e-12 * scale]
        keep.sort(key=lambda i: (round(w[i].real / scale, 11), w[i].imag))
        return [self._mode(complex(w[i]), left[:, i], right[:, i]) for i in keep]

    def _mode(self, value: complex, left: ComplexArray, right: ComplexArray) -> Mode:
        nd = len(self.dynamic)
        displacement = right[nd:]
        names = self.freedoms + self.internal
        pivot = displacement[int(np.argmax(np.abs(displacement)))]
        share = np.abs(left.conj() * right)
        share = np.concatenate([share[:nd] + share[nd : 2 * nd], share[2 * nd :]])
        total = float(share.sum()) or 1.0
        shape = {n: complex(z / pivot) for n, z in zip(names, displacement, strict=True)}
        return Mode(value, shape, {n: float(z / total) for n, z in zip(names, share, strict=True)})

    def reduced(self, names: Sequence[str], tolerance: float = 1e-9) -> Reduced:
        """Second-order equations of the named dynamic freedoms, after a check that they are decoupled.

        Raises
        ------
        LinearizationError
            If another freedom enters their equations by more than `tolerance` of the largest entry.
        """
        if not checked_names(names, "reduced") or len(set(names)) < len(names):
            raise LinearizationError(f"reduced: {names!r} given; name one dynamic freedom or more, each once")
        for name in names:
            if name not in self.dynamic:
                raise LinearizationError(
                    f"reduced: '{name}' is not a dynamic freedom; name some of {self.dynamic}"
                )
        i = [self.dynamic.index(name) for name in names]
        for matrix, label in ((self.M, "M"), (self.C, "C"), (self.K, "K"), (self.Z, "Z")):
            block = matrix[i]
            columns = self.internal if label == "Z" else self.freedoms[: matrix.shape[1]]
            for j, name in enumerate(columns):
                largest = float(np.max(np.abs(self.K[i] if label == "Z" else block)))
                if name not in names and np.max(np.abs(block[:, j])) > tolerance * largest:
                    raise LinearizationError(
                        f"{tuple(names)} are not decoupled: '{name}' enters through {label} "
                        f"({np.max(np.abs(block[:, j])):.3g}); include it, or use the full state matrix"
                    )
        grid = np.ix_(i, i)
        return Reduced(tuple(names), self.M[grid], self.C[grid], self.K[grid])

    def input_matrix(self, names: Sequence[str]) -> Array:
        """F̄ (nd, inputs): generalized forces of loads on the named coordinates, deformations or slips."""
        rows = [self.state.structure.find(name, "input") for name in checked_names(names, "inputs")]
        for name, i in zip(names, rows, strict=True):
            if i >= self.state.rates.size - self.state.x.size + self.state.structure.nf:
                raise LinearizationError(f"input '{name}' is a fixed coordinate and moves nothing; drop it")
        nd, nf = len(self.dynamic), self.state.structure.nf
        return np.asarray((self.state.J[rows, :nf] @ self.transfer.H[:, :nd]).T)

    def state_space(
        self, inputs: Sequence[str] = (), outputs: Sequence[str] = ()
    ) -> tuple[Array, Array, Array, Array]:
        """State-space matrices A, B, C, D.

        Parameters
        ----------
        inputs : sequence of str
            Names of loads (any quantity: the generalized force dual to it) or of prescribed motions.  The input of
            a prescribed motion is its acceleration; its rate and value join the states, in that order.
        outputs : sequence of str
            Names of quantities; a suffix ``'`` asks for the rate, ``''`` for the acceleration, and a prefix
            ``force:`` for the stress or reaction.

        Returns
        -------
        A, B, C, D : ndarray
        """
        from flexel.sensors import state_space

        return state_space(self, inputs, outputs)

    # control engineering, pictures, files: at home in flexel.control and flexel.saved.archive_linear
    to_control = control.to_control
    to_scipy = control.to_scipy
    save_state_space = control.save_state_space
    units = property(archive_linear.units)
    to_xarray = archive_linear.to_xarray
    to_pandas = archive_linear.to_pandas
    save = archive_linear.save
    plot = archive_linear.plot
    plot_mode = archive_linear.plot_mode
    view = archive_linear.view
    mode_shape = archive_linear.mode_shape


def linearize(kinematics: Kinematics, state: State) -> Linearization:
    """Linearized equations of motion about a complete state."""
    structure, roles = kinematics.structure, kinematics.roles
    own_state(structure, state, "linearize")
    nf, nd, nq = structure.nf, roles.nd, roles.nq
    J = state.J
    c = Configuration(state.t, state.x, state.e, J)
    m, k, nz = structure.m, structure.k, structure.nz
    T = kinematics.evaluation.tangents(state.x, state.v, state.a, J, state.e, state.stress, state.z, state.t)
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
