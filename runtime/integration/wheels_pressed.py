"""Checks whether rigid wheels press on the road: their contact, which is never lost, would hold one that would lift."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from flexel.base.arrays import Array
from flexel.integration.outcome import Pending, States
from flexel.mechanics.dynamics import holding_forces
from flexel.model.role_lists import Roles
from flexel.model.state import State
from flexel.model.structure import Structure

FAMILY, HEIGHT = "wheel", "surface"  # of a wheel, the deformation that is the height of its contact
LEAST_LOOKS = 20  # stored states that are looked at
EVALUATIONS_PER_LOOK = 50  # of the motion, where it takes more
ROUNDING = 1e-9  # of the largest force on a wheel


def pulling(structure: Structure, roles: Roles, states: States, evaluations: int) -> Iterator[str]:
    """Describe wheels that pull on the road, at stored states.

    All complete states are examined, and some of the others, whose forces cost an evaluation of the equations
    of motion each: more of them in a motion with many evaluations.

    Parameters
    ----------
    structure : Structure
    roles : Roles
    states : States
    evaluations : int
        Number of evaluations of the equations of motion that the motion has taken.
    """
    wheels = [instance.name for instance in structure.instances if instance.spec.family == FAMILY]
    heights = {wheel: structure.index.get(f"{wheel}.{HEIGHT}") for wheel in wheels}
    rows = {wheel: row for wheel, row in heights.items() if row is not None}
    if not rows:
        return
    looked = states.complete_and(max(LEAST_LOOKS, evaluations // EVALUATIONS_PER_LOOK))
    places = list(rows.values())
    forces = np.array([_forces(entry)[places] for entry in looked])
    if forces.max() <= 0:
        return
    worst, least = np.argmax(forces, axis=0), ROUNDING * np.abs(forces).max()
    for column, (wheel, row) in enumerate(rows.items()):
        force, when = forces[worst[column], column], looked[worst[column]].t
        if force > least and row in roles.rigid:
            yield (
                f"wheel '{wheel}' pulls on the road by {force:.3g} N at t = {when:g} s, where it would lift: give it a "
                "tyre (m.tyre with a law), which can lift, or end the motion earlier"
            )


def _forces(entry: State | Pending) -> Array:
    """Forces on the constraints at a stored state; zero where the position is singular."""
    if isinstance(entry, State):
        return entry.stresses
    found = holding_forces(entry.kinematics, entry.moment, entry.z)
    return np.zeros(entry.kinematics.structure.m) if found is None else found
