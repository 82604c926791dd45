"""Elements that have shrunk to no length, where what they measure has no direction."""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from flexel.base.arrays import Array
from flexel.model.structure import Structure

NONE = 1e-6  # distance of two points of an element, relative to that as drawn, from which it may end a motion


def collapsed(structure: Structure, x: Array) -> str:
    """Describe the element whose points have come together, for coordinates x (n,); empty if there is none."""
    for element in structure.instances:
        points = [name for name in element.nodes if structure.node(name).kind in ("point", "planar_point")]
        for one, other in pairwise(points):
            places = structure.places(one), structure.places(other)
            drawn, now = (float(np.linalg.norm(at[places[0]] - at[places[1]])) for at in (structure.x0, x))
            if now < NONE * drawn:
                return (
                    f"'{element.name}' has shrunk to {now:.2g} m: '{one}' and '{other}' meet there, and what it "
                    "measures has no direction"
                )
    return ""
