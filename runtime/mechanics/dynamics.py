"""Equations of motion in minimal coordinates, without Lagrange multipliers.

H' [ M a + h - f + De' sigma + V' tau ] = 0 with a = H q_d'' + g.  The multipliers (stresses of rigid
deformations and rolling contacts, driving forces of prescribed motions) follow from the same
factorization of B.  Source: Jonker and Meijaard (1990); Schwab and Meijaard (2003), eqs. (17)-(22).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from scipy.linalg import get_lapack_funcs
from scipy.sparse import block_array, coo_array

from flexel.base.arrays import Array
from flexel.base.errors import DynamicsError
from flexel.engine.finite import check_finite
from flexel.engine.solvers import Solvable, factorize
from flexel.mechanics.kinematics import Configuration, Kinematics
from flexel.structure.loads import Loads
from flexel.structure.state import Energy, State

_posv: Any = get_lapack_funcs("posv", dtype=np.float64)


class InertiaError(DynamicsError):
    """A motion moves no mass, so its acceleration is undetermined."""


@dataclass(frozen=True)
class Forces:
    """Inertia and forces at a configuration with velocities; symbols as in the formulation.

    Attributes
    ----------
    M : ndarray (n, n)
        Sparse in a large model.
    F : ndarray (n,)
        f - h - De' sigma - V' tau over all given stresses.
    stress : ndarray (m + k,)
        Given stresses of laws and loads.
    potential, strain : float
        Energies of body forces and of laws [J].
    zd : ndarray (nz,)
        Rates of the laws' internal states.
    dissipated : float
        Power dissipated by the laws [W].
    """

    M: Any
    F: Array
    stress: Array
    potential: float
    strain: float
    zd: Array
    dissipated: float


def forces(kinematics: Kinematics, loads: Loads, c: Configuration, v: Array, e: Array, z: Array) -> Forces:
    """Mass matrix, given forces and potentials at a configuration with rates.

    Parameters
    ----------
    c : Configuration
    v : ndarray (n,)
    e : ndarray (m,)
        Deformations with their turns.
    z : ndarray (nz,)
        Internal states of laws.
    """
    s = kinematics.structure
    evaluation = kinematics.evaluation
    inertia = evaluation.sparse_inertia if kinematics.large else evaluation.inertia
    M, h, f, U = inertia(c.x, v)
    rates = c.J[: s.m + s.k] @ v
    law = evaluation.constitutive(e, rates[: s.m], rates[s.m :], z, c.t)
    nodal, applied = loads.at(c.t)
    stress = law.stress + applied
    F = f - h + nodal
    if loads.any or s.laws:
        F = F - _without_infinity(stress) @ c.J[: s.m + s.k]
    return Forces(M, F, stress, U, law.stored, _without_infinity(law.zd), law.dissipated)


def _without_infinity(values: Array) -> Array:
    """The values with NaN for infinity: infinity times zero would warn before the law can be reported."""
    return np.where(np.isinf(values), np.nan, values)


@dataclass(frozen=True)
class Acceleration:
    """Accelerations at a state: a = H q_d'' + g."""

    H: Array
    qdd: Array
    a: Array


def accelerations(
    kinematics: Kinematics, c: Configuration, B: Solvable, v: Array, forces_: Forces
) -> Acceleration:
    """Accelerations from (H' M H) q_d'' = H' (F - M g) and a = H q_d'' + g.

    Parameters
    ----------
    c : Configuration
    B : Solvable
        Velocity matrix at c, factorized.
    v : ndarray (n,)
        Rates of the coordinates.
    forces_ : Forces
        Mass matrix and given forces.

    Raises
    ------
    DynamicsError
        If the reduced mass matrix is not positive definite: names the degree of freedom without inertia.
    """
    nf, nd = kinematics.structure.nf, kinematics.roles.nd
    both = np.zeros((nf, nd + 1))
    both[nf - nd :, :nd] = np.eye(nd)
    both[:, nd] = kinematics.convective(c, v)
    solution = B.solve(both)
    H, g = solution[:, :nd], solution[:, nd]
    qdd = np.zeros(0)
    if nd:
        heavy = kinematics.heavy
        X = solution if kinematics.large else solution[heavy]
        M = forces_.M[:nf, :nf] if kinematics.large else forces_.M[heavy[:, None], heavy]
        MX = X[:, :nd].T @ (M @ X)
        qdd = solve_mass(kinematics, MX[:, :nd], H.T @ forces_.F[:nf] - MX[:, nd])
    a = np.zeros(kinematics.structure.n)
    a[:nf] = H @ qdd + g
    return Acceleration(H, qdd, a)


def unit_solutions(kinematics: Kinematics, B: Solvable) -> Array:
    """First-order transfer function H = dv/dq_d' (nf, nd): the last columns of the inverse of B."""
    nf, nd = kinematics.structure.nf, kinematics.roles.nd
    return B.solve(np.eye(nf)[:, nf - nd :])


def solve_mass(kinematics: Kinematics, Mr: Array, rhs: Array) -> Array:
    """Solve with the reduced mass matrix (nd, nd), which must be positive definite."""
    _, x, info = _posv(Mr, rhs)
    if info:
        w, V = np.linalg.eigh(Mr)
        culprit = kinematics.roles.dynamic[int(np.argmax(np.abs(V[:, 0])))]
        raise InertiaError(
            f"reduced mass matrix is not positive definite (smallest eigenvalue {w[0]:.3g}): the degree of freedom "
            f"{kinematics.names([culprit])} moves no mass; give its bodies mass and inertia, or prescribe it"
        )
    return np.asarray(x)


def complete(
    kinematics: Kinematics,
    loads: Loads,
    c: Configuration,
    v: Array,
    e: Array,
    z: Array,
    qdd: Array | None = None,
) -> State:
    """The complete state at a configuration with velocities: accelerations, stresses, reactions, energy.

    Parameters
    ----------
    c : Configuration
    v : ndarray (n,)
    e : ndarray (m,)
        Deformations with their turns.
    z : ndarray (nz,)
        Internal states of laws.
    qdd : ndarray (nd,), optional
        Second rates of the dynamic degrees of freedom, where the motion is driven: stresses of those that are
        deformations, and reactions of those that are coordinates, then hold what drives them.

    Raises
    ------
    DynamicsError
        If a degree of freedom has no inertia; names it.
    """
    s, roles = kinematics.structure, kinematics.roles
    given = forces(kinematics, loads, c, v, e, z)
    multiplier = np.zeros(len(s.names))
    if kinematics.large and qdd is None:
        a, mu = saddle_accelerations(kinematics, c, v, given)
        multiplier[np.concatenate([roles.holonomic, roles.zero])] = mu
        return with_multipliers(kinematics, loads, c, v, a, e, z, given, multiplier)
    B = kinematics.velocity_matrix(c)
    if qdd is None:
        a = accelerations(kinematics, c, B, v, given).a
    else:
        rhs = kinematics.convective(c, v)
        rhs[s.nf - roles.nd :] += qdd
        a = np.zeros(s.n)
        a[: s.nf] = B.solve(rhs)
    residual = given.F - given.M @ a
    mu = B.solve(residual[: s.nf], transposed=True)
    if qdd is None:
        mu[s.nf - roles.nd :] = 0.0
    multiplier[roles.velocity_rows] = mu
    return with_multipliers(kinematics, loads, c, v, a, e, z, given, multiplier)


def saddle_accelerations(
    kinematics: Kinematics, c: Configuration, v: Array, given: Forces
) -> tuple[Array, Array]:
    """Accelerations (n,) and multipliers of a large model, from the sparse matrix [M C'; C 0].

    Parameters
    ----------
    c : Configuration
    v : ndarray (n,)
    given : Forces
        Mass matrix and given forces.

    Raises
    ------
    DynamicsError
        If a motion moves no mass.
    """
    s, roles = kinematics.structure, kinematics.roles
    nf, count = s.nf, s.nf - roles.nd
    C = c.J[np.concatenate([roles.holonomic, roles.zero])][:, :nf]
    factors = factorize(block_array([[given.M[:nf, :nf], C.T], [C, coo_array((count, count))]]))
    if not factors.regular:
        raise InertiaError(
            "the mass matrix is singular: a motion moves no mass; give its bodies mass and inertia, or start from rest "
            "(start=system.at_rest)"
        )
    solution = factors.solve(np.concatenate([given.F[:nf], kinematics.convective(c, v)[:count]]))
    return np.concatenate([solution[:nf], np.zeros(s.n - nf)]), solution[nf:]


def with_multipliers(
    kinematics: Kinematics,
    loads: Loads,
    c: Configuration,
    v: Array,
    a: Array,
    e: Array,
    z: Array,
    given: Forces,
    multiplier: Array,
) -> State:
    """The state with known accelerations and multipliers of constraints.

    Parameters
    ----------
    c : Configuration
    v, a : ndarray (n,)
        Rates and accelerations of the coordinates.
    e : ndarray (m,)
        Deformations with their turns.
    z : ndarray (nz,)
        Internal states of laws.
    given : Forces
        Mass matrix and given forces.
    multiplier : ndarray (m + k + n,)
        Multipliers by quantity, zero where there is no constraint.

    Raises
    ------
    DynamicsError
        If a force of a law is not finite; names it.
    """
    s, roles = kinematics.structure, kinematics.roles
    first = s.m + s.k
    check_finite(s, given.stress, given.zd, c.t)
    reactions = -multiplier[first:]
    unbalance = given.F - given.M @ a - multiplier[:first] @ c.J[:first]
    reactions[s.nf :] = -unbalance[s.nf :]
    potential = given.potential + loads.potential(c.t, kinematics.values(e, c.x))
    return State(
        t=c.t,
        x=c.x,
        v=v,
        a=a,
        e=e,
        rates=c.J @ v,
        stresses=given.stress + multiplier[:first],
        reactions=reactions,
        roles=roles,
        evaluation=kinematics.evaluation,
        energy=Energy(float(v @ given.M @ v) / 2, potential, given.strain),
        drift=kinematics.drift(e, c.x),
        z=z,
        zd=given.zd,
        dissipated=given.dissipated,
        Phi_v=kinematics.evaluation.convective(c.x, v) + c.J @ a,
    )
