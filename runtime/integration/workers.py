"""Who works most at an instant of a motion: laws that take power out, loads, and prescribed motions."""

from __future__ import annotations

from collections.abc import Iterator

from flexel.base.shown import listed
from flexel.mechanics.kinematics import Kinematics
from flexel.model.state import State

WORKERS = 3  # named at most
LARGE_SHARE = 0.1  # least power of one that is named, relative to the largest


def workers(kinematics: Kinematics, state: State) -> str:
    """Name those with the largest powers at a state, with these; empty if nothing works."""
    found = sorted(_powers(kinematics, state), key=lambda pair: -pair[1])[:WORKERS]
    return listed(
        [f"{name} ({power:.2g} W)" for name, power in found if power and power >= LARGE_SHARE * found[0][1]]
    )


def _powers(kinematics: Kinematics, state: State) -> Iterator[tuple[str, float]]:
    """Yield what works, and the size of its power [W]."""
    structure, tables = kinematics.structure, kinematics.evaluation.tables
    work = kinematics.evaluation.at(state.t, state.x, state.v, None, state.z, state.e)
    work.laws()
    for i, batch in enumerate(tables.laws):
        for member, power in zip(batch.members, work.law_P[tables.law.first[i] :], strict=False):
            yield f"law '{structure.laws[member].name}'", abs(float(power))
    loads = kinematics.loads
    for i, force in zip(loads.quantities, loads.values(state.t), strict=True):
        yield f"load on '{structure.names[i]}'", abs(float(force * state.rates[i]))
    for i in kinematics.roles.prescribed:
        name = structure.names[i]
        yield f"drive of '{name}'", abs(float(state.force(name)) * float(state.rates[i]))
