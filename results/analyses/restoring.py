"""Simulations continued from saved results."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from flexel.base.arguments import flag, number
from flexel.base.arrays import Index
from flexel.base.blas import in_one_thread
from flexel.base.errors import ModelError
from flexel.mechanics import dynamics
from flexel.mechanics.kinematics import wrap
from flexel.model.role_lists import Roles
from flexel.model.state import State
from flexel.model.structure import Structure
from flexel.results.motion import Motion
from flexel.system import CoreSystem

# Violation of a constraint, in natural scales, from which a position belongs to another model.
MAX_VIOLATION = 1e-6


@in_one_thread
def restore(
    system: CoreSystem, saved: Motion | State, time: float | None = None, *, as_saved: bool = False
) -> State:
    """Restore a saved state in this system: to continue a simulation, linearize about it, or draw it.

    Coordinates, rates, turns, internal states of laws and the choice of degrees of freedom come from the file,
    bit for bit; accelerations, forces and energies are recomputed with the current loads of the model.

    Parameters
    ----------
    saved : Motion or State
        From `flexel.load`, or of another system built in the same way.
    time : float, optional
        One of the stored times of a motion [s]; the last one by default.
    as_saved : bool
        Take accelerations, forces and energies from the file too: if a degree of freedom has no inertia they
        cannot be computed from the state.

    Raises
    ------
    ModelError
        A time that is not stored; a model with other quantities, other constraints or other dimensions.
    """
    state = _stored(saved, time)
    if flag(as_saved, "restore", "as_saved"):
        return restored(system, state)
    roles = _roles(system, state)
    return dynamics.complete(system.kinematics_of(roles), state.t, state.x, state.v, state.e, state.z)


def restored(system: CoreSystem, state: State) -> State:
    """Convert a saved state to a state of a system, with all saved values; see `Restoring.restore`."""
    return replace(state, roles=_roles(system, state), evaluation=system.evaluation)


def _roles(system: CoreSystem, state: State) -> Roles:
    """Return the roles of a system with a saved state's choice of degrees of freedom."""
    _check_names(system.structure, state.structure)
    _check_constraints(system, state)
    roles, rows = system.roles, [state.roles.dynamic, state.roles.kinematic]
    if all(np.array_equal(a, b) for a, b in zip(rows, (roles.dynamic, roles.kinematic), strict=True)):
        return roles
    _check_dofs(system, rows)
    return roles.with_dofs(*rows)


def _stored(saved: Any, time: float | None) -> State:
    """Return the stored state at a time."""
    if isinstance(saved, State):
        if time is not None and number(time, "restore", "time") != saved.t:
            raise ModelError(
                f"restore: the state is at t = {saved.t:g} s, not {time:g} s; give the motion instead"
            )
        return saved
    if not isinstance(saved, Motion):
        raise ModelError(
            f"restore: {type(saved).__name__} is not a motion or a state; give the result of fx.load, or one of "
            "its states"
        )
    if time is None:
        return saved[-1]
    t = number(time, "restore", "time")
    state = saved.nearest(t)
    if abs(state.t - t) > 1e-9 * max(float(np.ptp(saved.t)), abs(t)):
        raise ModelError(f"restore: no state is stored at t = {t:g} s; the nearest time is {state.t:.12g} s")
    return state


def _check_names(own: Structure, other: Structure) -> None:
    """Check that both have the same quantities in the same order."""
    differing = _only_in(own, other) or _only_in(other, own)
    if differing:
        raise ModelError(
            f"restore: only one of the saved state and this model has {', '.join(map(repr, differing[:4]))}; build the "
            "model that was saved"
        )
    if own.names != other.names or tuple(own.internal) != tuple(other.internal):
        raise ModelError(
            "restore: this model was declared in a different order from the saved one, or has different "
            "coordinates; build the model that was saved"
        )


def _check_constraints(system: CoreSystem, state: State) -> None:
    """Check that a saved position fulfils the constraints of the model, which may have other dimensions."""
    rows, structure = system.roles.rigid, system.structure
    e = system.evaluation.position(state.x, state.e)[0]
    period = structure.period[rows]
    held = wrap(e[rows], period)
    off = np.abs(held) / system.kinematics.scales(rows)
    if off.max(initial=0.0) > max(MAX_VIOLATION, 10 * state.drift):
        k = int(np.argmax(off))
        raise ModelError(
            f"restore: the saved position does not fit this model: the rigid '{structure.names[rows[k]]}' would be "
            f"{held[k]:.3g} {structure.units[rows[k]]}; build the model that was saved, with the same dimensions, or "
            "take system.state_at with the saved degrees of freedom"
        )


def _only_in(a: Structure, b: Structure) -> list[str]:
    """Return the quantities and internal states that only the first structure has."""
    return [name for name in (*a.names, *a.internal) if name not in b.index and name not in b.internal]


def _check_dofs(system: CoreSystem, rows: list[Index]) -> None:
    """Check that the saved degrees of freedom are as many as the model's, and none of them constrained."""
    roles, names = system.roles, system.structure.names
    taken = {*roles.rigid.tolist(), *roles.prescribed.tolist(), *roles.zero.tolist()}
    held = [names[i] for row in rows for i in row.tolist() if i in taken]
    if held or [row.size for row in rows] != [roles.nd, roles.nq - roles.nd]:
        found = tuple(names[i] for row in rows for i in row.tolist())
        raise ModelError(
            f"restore: the saved state has the degrees of freedom {found}, this model "
            f"{system.dynamic + system.kinematic}"
            f"{': ' + ', '.join(held) + ' is constrained now' if held else ''}; build it with the same constraints"
        )
