"""Builds the state-space form of a linearization with named inputs and outputs; every output is differentiated."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from flexel.base.arguments import names, unknown
from flexel.base.arrays import Array
from flexel.base.errors import LinearizationError, ModelError
from flexel.linear.state_space_inputs import Inputs
from flexel.mechanics.linearized_system import LinearizedSystem


@dataclass(frozen=True)
class Variations:
    """Small motions as linear maps of (states, inputs): δx, δv, δa (nf, states + inputs) and nodal loads."""

    x: Array
    v: Array
    a: Array
    load: Array  # generalized forces on the coordinates
    z: Array  # internal states (nz,) of laws
    applied: Array  # stresses (m + k,) of the loads on deformations and slips
    states: int


def state_space(
    lin: LinearizedSystem, inputs: Sequence[str], outputs: Sequence[str]
) -> tuple[Array, Array, Array, Array]:
    """Build the state-space matrices; see `Linearization.state_space`."""
    given, outputs = Inputs.of(lin, inputs), names(outputs, "outputs")
    loads = [quantity for i, quantity in enumerate(given.quantities) if i not in given.driven]
    driven = [lin.prescribed.index(given.quantities[i]) for i in given.driven]
    place = {quantity: i for i, quantity in enumerate(given.quantities)}
    nd, nq, nu = len(lin.dynamic), len(lin.dofs), len(driven)
    nz = len(lin.internal)
    own, ni = nd + nq + nz, len(given.quantities)
    ns = own + 2 * nu
    unit = np.eye(ns + ni)
    qd, q, z, ud, u = np.split(unit[:ns], np.cumsum([nd, nq, nz, nu]))
    udd = unit[[ns + place[lin.prescribed[i]] for i in driven]]
    f = unit[[ns + place[name] for name in loads]]
    forces = lin.input_matrix(loads) @ f - lin.Z @ z
    rhs = lin.C @ qd + lin.K @ q + lin.M_u[:, driven] @ udd + lin.C_u[:, driven] @ ud + lin.K_u[:, driven] @ u
    qdd = np.linalg.solve(lin.M, forces - rhs) if nd else np.zeros((0, ns + ni))
    qkd = lin.A_k @ qd + lin.B_k @ q + lin.A_ku[:, driven] @ ud + lin.B_ku[:, driven] @ u
    zd = lin.Z_v @ qd + lin.Z_q @ q + lin.Z_z @ z + lin.Z_vu[:, driven] @ ud + lin.Z_qu[:, driven] @ u
    rates = np.vstack([qdd, qd, qkd, zd, udd, ud])
    X = lin.transfer
    cq, cu, hu = slice(0, nq), [nq + i for i in driven], [nd + i for i in driven]
    structure = lin.state.structure
    rows = [structure.find(name) for name in loads]
    applied = np.zeros((len(structure.names), ns + ni))
    np.subtract.at(applied, rows, f)
    motion = Variations(
        x=X.G[:, cq] @ q + X.G[:, cu] @ u,
        v=X.N[:, cq] @ q + X.N[:, cu] @ u + X.H[:, :nd] @ qd + X.H[:, hu] @ ud,
        a=X.A_q[:, cq] @ q
        + X.A_q[:, cu] @ u
        + X.A_v[:, :nd] @ qd
        + X.A_v[:, hu] @ ud
        + X.H[:, :nd] @ qdd
        + X.H[:, hu] @ udd,
        load=lin.state.J[rows].T @ f,
        z=z,
        applied=applied[: structure.m + structure.k],
        states=ns,
    )
    Y = np.array([_output(lin, motion, name) for name in outputs]).reshape(len(outputs), ns + ni)
    return given.by_displacement((rates[:, :ns], rates[:, ns:], Y[:, :ns], Y[:, ns:]), own, outputs)


def _output(lin: LinearizedSystem, d: Variations, name: str) -> Array:
    """Return the row of the output matrix for one named quantity."""
    structure, T, J = lin.state.structure, lin.tangents, lin.state.J
    nf = structure.nf
    if name in structure.internal:
        return np.asarray(d.z[structure.internal[name]])
    if name.startswith("force:"):
        return _force(lin, d, structure.find(name.removeprefix("force:")))
    if ":" in name and name.rstrip("'") not in structure.index:
        raise ModelError(unknown(name, [f"force:{quantity}" for quantity in structure.index]))
    i = structure.find(name.rstrip("'"))
    order = len(name) - len(name.rstrip("'"))
    if order == 0:
        if structure.m <= i < structure.m + structure.k:
            raise LinearizationError(f"slip '{name}' has no value; use its rate, \"{name}'\"")
        return np.asarray(J[i, :nf] @ d.x)
    if order == 1:
        return np.asarray(T.Phi_x[i, :nf] @ d.x + J[i, :nf] @ d.v)
    if order == 2:
        return np.asarray(T.Psi_x[i, :nf] @ d.x + T.Psi_v[i, :nf] @ d.v + J[i, :nf] @ d.a)
    raise LinearizationError(f"output '{name}': only first and second rates exist; use at most two primes")


def _force(lin: LinearizedSystem, d: Variations, i: int) -> Array:
    """Return the variation of a stress (law and constraint parts) or of a reaction."""
    state, T = lin.state, lin.tangents
    structure, roles, J = state.structure, state.roles, state.J
    nf, m, k = structure.nf, structure.m, structure.k
    M = lin.tangents.M
    internal = T.stress_z @ d.z
    unbalance = T.r_x @ d.x + T.r_v @ d.v + M[:, :nf] @ d.a - d.load
    unbalance = unbalance + J[: m + k].T @ internal
    rows = roles.velocity_rows
    multipliers = np.zeros((len(structure.names), unbalance.shape[1]))
    multipliers[rows] = -np.linalg.solve(J[rows, :nf].T, unbalance[:nf])
    multipliers[roles.dynamic] = 0.0
    first = m + k
    if i < first:
        ed = T.Phi_x[: m + k, :nf] @ d.x + J[: m + k, :nf] @ d.v
        law = T.stress_e[i] @ (J[:m, :nf] @ d.x) + T.stress_ed[i] @ ed[:m] + T.stress_s[i] @ ed[m:]
        return np.asarray(law + internal[i] + d.applied[i] + multipliers[i])
    if i - first < nf:
        return np.asarray(-multipliers[i])
    return np.asarray((unbalance + J[:first].T @ multipliers[:first])[i - first])
