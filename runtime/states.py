"""Complete states of a system: from values and rates by name, or from the integrator's variables.

Angles are kernels' principal values plus turns; the turns are counted from a nearby state.
Imports numpy, the errors and the dynamics.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np

from flexel import dynamics
from flexel.errors import ModelError, PositionError
from flexel.kinematics import Configuration
from flexel.roles import Roles
from flexel.state import State
from flexel.structure import Array, Structure

if TYPE_CHECKING:
    from flexel.system import System


def unwrap(structure: Structure, e: Array, reference: Array) -> Array:
    """Deformations with the turns that bring angles nearest to a reference."""
    angle = structure.angle[: structure.m]
    if not angle.any():
        return e
    return np.asarray(e + 2 * np.pi * np.where(angle, np.round((reference - e) / (2 * np.pi)), 0.0))


def with_freedoms(structure: Structure, e: Array, q: Array, roles: Roles) -> Array:
    """Deformations in which those that are freedoms take the freedoms' own values, turns included."""
    own = roles.freedoms < structure.m
    e = e.copy()
    e[roles.freedoms[own]] = q[own]
    return e


def state_from(system: System, t: float, y: Array, roles: Roles, previous: State) -> State:
    """Complete state from y = (q, q_d') in the coordinates `roles`; see `System.state_from`."""
    kinematics, nq, m = system.kinematics_of(roles), roles.nq, system.structure.m
    guess = previous.x + (t - previous.t) * previous.v if nq == 0 else previous.x
    c = kinematics.position(t, y[:nq], guess)
    v = kinematics.velocity(c, kinematics.velocity_matrix(c), y[nq:])
    predicted = previous.e + (t - previous.t) * (previous.J[:m] @ previous.v + c.J[:m] @ v) / 2
    e = with_freedoms(system.structure, unwrap(system.structure, c.e, predicted), y[:nq], roles)
    return dynamics.complete(kinematics, system.loads, c, v, e)


def state_at(
    system: System,
    values: Mapping[str, float],
    rates: Mapping[str, float] | None,
    t: float | None,
    start: State,
) -> State:
    """Consistent state with given values and rates; see `System.state_at`."""
    structure, roles, kinematics = system.structure, system.roles, system.kinematics
    if start.structure is not structure:
        raise ModelError("the start state belongs to another model; take one of this system")
    q = np.array(start.values[roles.freedoms])
    for name, value in values.items():
        i = structure.find(name)
        if i not in roles.freedoms:
            raise ModelError(
                f"'{name}' is not a freedom; values can be given to {kinematics.names(roles.freedoms)}"
            )
        q[list(roles.freedoms).index(i)] = float(value)
    c = kinematics.position(start.t if t is None else t, q, start.x)
    e = with_freedoms(structure, unwrap(structure, c.e, start.e), q, roles)
    qd = start.J[roles.dynamic] @ start.v if rates is None else consistent_rates(system, c, rates)
    v = kinematics.velocity(c, kinematics.velocity_matrix(c), qd)
    return dynamics.complete(kinematics, system.loads, c, v, e)


def consistent_rates(system: System, c: Configuration, rates: Mapping[str, float]) -> Array:
    """Rates q_d' (nd,) that give the named rates; those that nothing determines are zero.

    Raises
    ------
    ModelError, PositionError
        Rates that are not finite; rates that contradict one another or the constraints.
    """
    structure, kinematics, nd = system.structure, system.kinematics, system.roles.nd
    rows = np.array([structure.find(name) for name in rates], dtype=np.intp)
    wanted = np.array([float(z) for z in rates.values()])
    if not np.all(np.isfinite(wanted)):
        raise ModelError(f"initial rates {dict(rates)} are not all finite; give finite numbers")
    B = kinematics.velocity_matrix(c)
    H = dynamics.unit_solutions(kinematics, B)
    v0 = kinematics.velocity(c, B, np.zeros(nd))
    J = c.J[rows, : structure.nf]
    missing = wanted - J @ v0[: structure.nf]
    qd = np.linalg.lstsq(J @ H, missing, rcond=1e-12)[0] if rows.size else np.zeros(nd)
    off = missing - J @ (H @ qd)
    scale = max(float(np.max(np.abs(wanted), initial=0.0)), 1e-12)
    if np.max(np.abs(off), initial=0.0) > 1e-9 * scale:
        worst = int(np.argmax(np.abs(off)))
        raise PositionError(
            f"initial rates are inconsistent: '{list(rates)[worst]}' cannot be {wanted[worst]:g} together with "
            f"the others and the constraints (off by {off[worst]:.3g}); give at most {nd} independent rates"
        )
    return np.asarray(qd)
