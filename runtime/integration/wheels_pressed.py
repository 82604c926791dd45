"""Checks whether contacts that are never lost press on the road: they would hold a rigid wheel that would lift."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from flexel.base.arrays import Array
from flexel.integration.outcome import States
from flexel.integration.segments import Pending
from flexel.mechanics.dynamics import holding_forces
from flexel.model.role_lists import Roles
from flexel.model.state import State
from flexel.model.structure import Structure

LEAST_LOOKS = 20  # stored states that are looked at
EVALUATIONS_PER_LOOK = 50  # of the motion, where it takes more
ROUNDING = 1e-9  # of the largest force on a wheel


def pulling(structure: Structure, roles: Roles, states: States, evaluations: int) -> Iterator[str]:
    """Describe wheels, and others whose contact is never lost, that pull on the road at stored states.

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
    places = structure.touching
    if not places.size:
        return
    looked = states.complete_and(max(LEAST_LOOKS, evaluations // EVALUATIONS_PER_LOOK))
    forces = np.array([_forces(entry)[places] for entry in looked])
    if forces.max() <= 0:
        return
    worst, least = np.argmax(forces, axis=0), ROUNDING * np.abs(forces).max()
    for column, row in enumerate(places):
        force, when = forces[worst[column], column], looked[worst[column]].t
        if force > least and row in roles.rigid:
            wheel = structure.names[row].rpartition(".")[0]
            what = f"{structure.element(wheel).spec.family} '{wheel}'".strip()  # a user's may have no family
            yield (
                f"{what} pulls on the road by {force:.3g} N at t = {when:g} s, where it would lift: give it "
                "a tyre (m.tyre with a law), which can lift, or end the motion earlier"
            )


def _forces(entry: State | Pending) -> Array:
    """Forces on the constraints at a stored state; zero where the position is singular."""
    if isinstance(entry, State):
        return entry.stresses
    found = holding_forces(entry.kinematics, entry.moment, entry.z)
    return np.zeros(entry.kinematics.structure.m) if found is None else found
