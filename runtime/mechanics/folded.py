"""Finds beams that are folded back: turned by more than a right angle, which the sine of the angle does not tell.

Their deformations are those of a beam that is turned by the supplement of the angle, or straight: an equilibrium of
such beams is none of the structure.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from flexel.base.arrays import Array
from flexel.engine.outputs import element_outputs
from flexel.model.instances import Instance
from flexel.model.structure import Structure

OUTPUT = "turn_cosines"  # of the elements that have them: at both ends against the chord and, in space, of the twist


@dataclass(frozen=True)
class Folded:
    """A beam that is folded back.

    Attributes
    ----------
    angle : float
        The turns of its ends against the line between them, together; or its twist [°].
    text : str
        What to say about it, and about others.
    """

    angle: float
    text: str


def folded(
    structure: Structure, elements: Sequence[Instance], x: Array, e: Array, allowed: float
) -> Folded | None:
    """Return the beam that is folded back most in a state; None if there is none.

    Parameters
    ----------
    structure : Structure
    elements : sequence of Instance
    x, e : ndarray (1, n), (1, m)
        Coordinates and deformations.
    allowed : float
        Angle within one element that is in the range [°].
    """
    found: list[tuple[float, str]] = []
    types: dict[int, list[Instance]] = {}
    for element in elements:
        if any(output.name == OUTPUT for output in element.spec.outputs):
            types.setdefault(id(element.spec), []).append(element)
    stresses = np.zeros((1, structure.m + structure.k))  # do not matter
    for same in types.values():
        cosines = element_outputs(structure, same, x, e, stresses)[OUTPUT][0].reshape(len(same), -1)
        for i in np.flatnonzero(cosines.min(axis=1) < 0):
            ends, twist = np.split(np.degrees(np.arccos(np.clip(cosines[i], -1, 1))), [2])
            found.append((float(max([ends.sum(), *twist])), same[i].name))
    if not found:
        return None
    angle, name = max(found)
    others = f" (and {len(found) - 1} more)" if len(found) > 1 else ""
    return Folded(
        angle,
        f"'{name}' is folded back{others}, by {angle:.0f}°, which its deformations do not tell: this is no state of "
        f"the structure; use {int(np.ceil(angle / allowed))} elements in place of each",
    )
