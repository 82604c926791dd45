"""Messages on prescribed quantities that actuators move, and on analyses that do not allow such motions."""

from __future__ import annotations

from flexel.base.errors import DynamicsError, ModelError
from flexel.base.shown import quoted
from flexel.model.role_lists import Roles
from flexel.model.structure import Structure


def path_of(structure: Structure, roles: Roles) -> tuple[list[str], list[str]]:
    """Return the names of the quantities that actuators move, and of these."""
    assert roles.actuators is not None
    path, actuators = roles.prescribed[roles.moved], roles.actuators[roles.moved]
    return [structure.names[i] for i in path], [structure.names[i] for i in actuators]


def unheld(structure: Structure, roles: Roles) -> DynamicsError:
    """Return the error for actuators that do not move their path."""
    path, actuators = path_of(structure, roles)
    return DynamicsError(
        f"the actuators {quoted(actuators)} cannot hold the path of {quoted(path)}: here their forces do not move it "
        "in all its directions, or a motion has no mass; keep the path away from this position (a stretched "
        "arm?), or name actuators that move it without a spring in between"
    )


def refuse_actuators(structure: Structure, roles: Roles) -> None:
    """Refuse an analysis that assumes that the forces of prescribed motions act in the prescribed quantities.

    Raises
    ------
    ModelError
        Names the path and the actuators.
    """
    if roles.actuated:
        path, actuators = path_of(structure, roles)
        raise ModelError(
            f"the path of {quoted(path)} is held by the actuators {quoted(actuators)}: only simulate, with DOP853, "
            "computes such motions; prescribe the path without actuators, or apply their forces with m.load"
        )


def refuse_jumps(structure: Structure, roles: Roles, t: float) -> None:
    """Refuse a path whose rates jump at time t [s], as the forces of its actuators are finite.

    Raises
    ------
    DynamicsError
    """
    if roles.actuated:
        path, _ = path_of(structure, roles)
        raise DynamicsError(
            f"simulate: prescribed rates jump at t = {t:.6g} s, but the path of {quoted(path)} is held by actuators, "
            "whose forces are finite; give it smooth rates"
        )
