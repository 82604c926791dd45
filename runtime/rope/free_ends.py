"""Ropes with a free end, which need some bending stiffness: a check before the system is built."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable

import numpy as np

from flexel.base.errors import ModelError
from flexel.rope.cables import bending_stiffness
from flexel.structure.instances import Instance
from flexel.structure.structure import Structure

# Smallest EI over w l³ (w: weight per length, l: length of the element) at which the slope at the free end of a hanging
# rope is stable.  Tension that varies within an element acts on its slopes; at a slack end nothing else holds them.
# The limit was found from the stiffness of ropes of 1 to 16 elements: 0.00769 for two or more, 0.00789 for one.
LEAST = 0.008


def check_free_ends(structure: Structure, held: Iterable[str]) -> None:
    """Refuse cables whose free end is unstable.

    Parameters
    ----------
    held : iterable of str
        Coordinates that are fixed or prescribed, or carry a load.

    Raises
    ------
    ModelError
        Names the cable and its end.
    """
    users: dict[str, list[Instance]] = defaultdict(list)
    for instance in structure.instances:
        if instance.spec.family != "contact":  # touches the rope, but does not hold its end
            for node in dict.fromkeys(instance.nodes):
                users[node].append(instance)
    taken = {name.rpartition(".")[0] for name in held}
    for cable in structure.instances:
        if cable.spec.family == "cable":
            for node in cable.nodes[::2]:
                if users[node] == [cable] and node not in taken:
                    _check(structure, cable, node)


def _check(structure: Structure, cable: Instance, node: str) -> None:
    l, rhoA = (float(cable.parameters[z][0]) for z in ("l0", "rhoA"))
    weight = rhoA * float(np.linalg.norm(cable.parameters["gravity"]))
    EI, least = bending_stiffness(structure, cable), LEAST * weight * l**3
    if EI < least:
        raise ModelError(
            f"cable '{cable.name}': its end '{node}' is free, and its bending stiffness EI = {EI:.3g} N m² is below "
            f"{least:.3g} N m² ({LEAST:g} times weight per length times length³), so that its slope there is unstable; "
            "use m.chain for a rope without bending stiffness, or give shorter elements or a larger EI"
        )
