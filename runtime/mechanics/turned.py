"""Warns of elements with nearly half a turn between their ends, at which their rotation vector jumps."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from flexel.base.arrays import Array
from flexel.model.structure import Structure

FAR = 150.0  # angle within one element [°]
AXES = ("turn_x", "turn_y", "turn_z")


def turned(structure: Structure, times: ArrayLike, e: Array) -> list[str]:
    """Describe the element in logarithmic rotations that is turned most, if by more than 150°.

    Parameters
    ----------
    structure : Structure
    times : array_like (states,)
    e : ndarray (states, m)
        Their deformations.
    """
    names, turns = _turns(structure, e)
    if not names or np.max(turns) <= FAR:
        return []
    when, which = np.unravel_index(int(np.argmax(turns)), turns.shape)
    angle = float(turns[when, which])
    return [
        f"the ends of '{names[which]}' are turned by {angle:.0f}° relative to one another{instant(times, int(when))}; "
        f"this may be {360 - angle:.0f}° the other way, since only angles below 180° are known within one "
        "element: use two elements in place of each"
    ]


def instant(times: ArrayLike, when: int) -> str:
    """Say at which of several times something is worst; of one state nothing, so that a loop repeats no warning."""
    t = np.asarray(times)
    return f" at t = {t[when]:g} s" if t.size > 1 else ""


def _turns(structure: Structure, e: Array) -> tuple[list[str], Array]:
    """Return names of elements in logarithmic rotations, and the angles (states, elements) between their ends [°]."""
    names, angles, first = [], [], 0
    for instance in structure.instances:
        kinds = np.array([deformation.kind for deformation in instance.spec.deformations])
        if AXES[0] in kinds:
            parts = e[:, first : first + len(kinds)] / instance.parameters["l0"][0]
            vector = np.array([parts[:, kinds == axis].sum(axis=1) for axis in AXES])
            names.append(instance.name)
            angles.append(np.degrees(np.linalg.norm(vector, axis=0)))
        first += len(kinds)
    return names, np.array(angles).T
