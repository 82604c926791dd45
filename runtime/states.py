"""Complete states of a system: from values and rates by name, or from the integrator's variables.

Angles are kernels' principal values plus turns; the turns are counted from a nearby state.
Imports numpy, scipy.sparse, the errors and the dynamics.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from scipy.sparse import block_array, eye_array, vstack

from flexel import dynamics
from flexel.errors import ModelError, PositionError
from flexel.inputs import number, numbers
from flexel.kinematics import Configuration, Kinematics, turns
from flexel.roles import Roles
from flexel.solvers import factorize
from flexel.state import State, own_state
from flexel.structure import Array, Structure

if TYPE_CHECKING:
    from flexel.system import System


def unwrap(structure: Structure, e: Array, reference: Array) -> Array:
    """Deformations with the whole periods that bring those that wind nearest to a reference."""
    period = structure.period[: structure.m]
    return e + turns(reference - e, period) if period.any() else e


def with_freedoms(structure: Structure, e: Array, q: Array, roles: Roles) -> Array:
    """Deformations in which those that are freedoms take the freedoms' own values, turns included."""
    own = roles.freedoms < structure.m
    e = e.copy()
    e[roles.freedoms[own]] = q[own]
    return e


def with_turns(kinematics: Kinematics, c: Configuration, q: Array, reference: Array) -> Array:
    """Deformations with their turns: freedoms and prescribed angles know theirs, others are nearest to a reference."""
    structure, rows = kinematics.structure, kinematics.roles.position_rows
    own = rows < structure.m
    known = reference.copy()
    known[rows[own]] = kinematics.target(kinematics.motion(c), q)[own]
    return with_freedoms(structure, unwrap(structure, c.e, known), q, kinematics.roles)


def state_from(
    system: System, t: float, y: Array, roles: Roles, previous: State, guess: Array | None = None
) -> State:
    """Complete state from y = (q, q_d', z) in the coordinates `roles`; see `System.state_from`."""
    kinematics, nq, m = system.kinematics_of(roles), roles.nq, system.structure.m
    qd, z = np.split(y[nq:], [roles.nd])
    if guess is None:
        guess = previous.x + (t - previous.t) * previous.v if nq == 0 else previous.x
    c = kinematics.position(t, y[:nq], guess)
    v = kinematics.velocity(c, kinematics.velocity_matrix(c), qd)
    predicted = previous.e + (t - previous.t) * (previous.rates[:m] + c.J[:m] @ v) / 2
    return dynamics.complete(kinematics, system.loads, c, v, with_turns(kinematics, c, y[:nq], predicted), z)


@dataclass(frozen=True)
class End:
    """An end of a step of the integration: what is needed to find the states inside it again."""

    t: float
    x: Array
    v: Array
    e: Array
    ed: Array

    @staticmethod
    def of(state: State) -> End:
        """The end at a complete state."""
        return End(state.t, state.x, state.v, state.e, state.rates[: state.e.size])


def state_between(system: System, t: float, y: Array, roles: Roles, first: End, last: End) -> State:
    """Complete state inside a step, from y = (q, q_d', z) and the two ends of the step.

    Positions of a mechanism have branches and its angles turns; the cubic through both ends tells which are meant.
    """
    kinematics, nq = system.kinematics_of(roles), roles.nq
    qd, z = np.split(y[nq:], [roles.nd])
    h = last.t - first.t
    part = (t - first.t) / h
    a, b = part * part * (3 - 2 * part), h * part * (1 - part)
    guess = (1 - a) * first.x + a * last.x + b * ((1 - part) * first.v - part * last.v)
    c = kinematics.position(t, y[:nq], guess)
    v = kinematics.velocity(c, kinematics.velocity_matrix(c), qd)
    predicted = (1 - a) * first.e + a * last.e + b * ((1 - part) * first.ed - part * last.ed)
    return dynamics.complete(kinematics, system.loads, c, v, with_turns(kinematics, c, y[:nq], predicted), z)


def state_at(
    system: System,
    values: Mapping[str, float],
    rates: Mapping[str, float] | None,
    t: float | None,
    start: State,
) -> State:
    """Consistent state with given values and rates; see `System.state_at`."""
    structure, roles, kinematics = system.structure, system.roles, system.kinematics
    own_state(structure, start, "state_at")
    wanted = numbers(values, "state_at", "value")
    time = start.t if t is None else number(t, "state_at", "time t")
    q, z = np.array(start.values[roles.freedoms]), start.z.copy()
    for name, value in wanted.items():
        if name in structure.internal:
            z[structure.internal[name]] = value
            continue
        i = structure.find(name, "state_at")
        if i not in roles.freedoms:
            raise ModelError(
                f"'{name}' is not a freedom; values can be given to {kinematics.names(roles.freedoms)}"
            )
        q[list(roles.freedoms).index(i)] = value
    c = kinematics.position(time, q, start.x)
    e = with_freedoms(structure, unwrap(structure, c.e, start.e), q, roles)
    qd = start.qd if rates is None else consistent_rates(system, c, rates)
    v = kinematics.velocity(c, kinematics.velocity_matrix(c), qd)
    return dynamics.complete(kinematics, system.loads, c, v, e, z)


def consistent_rates(system: System, c: Configuration, rates: Mapping[str, float]) -> Array:
    """Rates q_d' (nd,) that give the named rates; those that nothing determines are zero.

    Raises
    ------
    ModelError, PositionError
        Rates that are not finite; rates that contradict one another or the constraints.
    """
    structure, kinematics, nd = system.structure, system.kinematics, system.roles.nd
    given = numbers(rates, "initial rates", "rate")
    rows = np.array([structure.find(name, "initial rates") for name in given], dtype=np.intp)
    wanted, nf = np.array(list(given.values())), structure.nf
    if not rows.size:
        return np.zeros(nd)
    B = kinematics.velocity_matrix(c)
    v0 = kinematics.velocity(c, B, np.zeros(nd))
    J = c.J[rows][:, :nf]
    missing = wanted - J @ v0[:nf]
    if kinematics.large:
        qd = smallest(c.J[system.roles.dynamic][:, :nf], c.J, system.roles, J, missing)
    else:
        by_freedoms = B.solve(np.ascontiguousarray(J.T), transposed=True)[nf - nd :].T
        qd = np.linalg.lstsq(by_freedoms, missing, rcond=1e-12)[0]
    v = v0[:nf] + B.solve(np.concatenate([np.zeros(nf - nd), qd]))
    off = wanted - J @ v
    speeds = np.concatenate([wanted, v0, v, [1e-12]])
    scale = float(np.max(np.abs(speeds)))
    if np.max(np.abs(off), initial=0.0) > 1e-9 * scale:
        worst = int(np.argmax(np.abs(off)))
        raise PositionError(
            f"initial rates are inconsistent: '{list(rates)[worst]}' cannot be {wanted[worst]:g} together with "
            f"the others and the constraints (off by {off[worst]:.3g}); give at most {nd} independent rates"
        )
    return np.asarray(qd)


def smallest(S: Any, J: Any, roles: Roles, rows: Any, wanted: Array) -> Array:
    """Rates S v (nd,) of the freedoms, smallest in size, that change the given rows of rates as wanted.

    For large models: v from the sparse conditions of the constrained least squares.
    """
    nf = S.shape[1]
    C = J[np.concatenate([roles.holonomic, roles.zero])][:, :nf]
    A = vstack([C, rows])
    damping = -1e-14 * eye_array(A.shape[0])  # for rates that repeat one another
    factors = factorize(block_array([[S.T @ S, A.T], [A, damping]]))
    rhs = np.concatenate([np.zeros(nf + C.shape[0]), wanted])
    return np.asarray(S @ factors.solve(rhs)[:nf])
