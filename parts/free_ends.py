"""Ropes with a free end, which need some bending stiffness: a check before the system is built."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable

import numpy as np

from flexel.base.errors import ModelError
from flexel.model.instances import Instance
from flexel.model.structure import Structure

# Smallest EI over w l³ (w: weight per length, l: length of the element) at which the slope at the free end of a hanging
# rope is stable.  Tension that varies within an element acts on its slopes; at a slack end nothing else holds them.
# The limit was found from the stiffness of ropes of 1 to 16 elements: 0.00769 for two or more, 0.00789 for one.
LEAST = 0.008
# Three curvatures belong to Gauss points on (-1, 1); their shares of EI l0.
POINTS, CURVATURES = np.polynomial.legendre.leggauss(3)
CURVATURES /= 2


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
        # a user's page may hold its end in its own way
        if cable.spec.family == "cable" and cable.code is None:
            for node in cable.nodes[::2]:
                if users[node] == [cable] and node not in taken:
                    _check(structure, cable, node)


def _check(structure: Structure, cable: Instance, node: str) -> None:
    l, rhoA = (float(cable.parameters[key][0]) for key in ("l0", "rhoA"))
    weight = rhoA * float(np.linalg.norm(cable.parameters["gravity"]))
    EI, least = bending_stiffness(structure, cable), LEAST * weight * l**3
    if EI < least:
        raise ModelError(
            f"cable '{cable.name}': its end '{node}' is free, and its bending stiffness EI = {EI:.3g} N m² is below "
            f"{least:.3g} N m² ({LEAST:g} times weight per length times length³), so that its slope there is unstable; "
            "use m.chain for a rope without bending stiffness, or give shorter elements or a larger EI"
        )


def bending_stiffness(structure: Structure, cable: Instance) -> float:
    """Return the smallest EI [N m²] of a cable of a model, including springs on its curvatures.

    It is infinite where a law of another kind acts on all of its curvatures, since that may do anything.
    """
    curvatures = cable.deformations[POINTS.size :]
    weights = np.repeat(CURVATURES, len(curvatures) // POINTS.size) * float(cable.parameters["l0"][0])
    EI = dict.fromkeys(curvatures, 0.0)
    for law in structure.laws:
        if law.called is not None and law.name == cable.name and law.code is None:
            added = dict.fromkeys(curvatures, float(law.parameters["EI"][0]))
        elif "S" in law.parameters and len(law.deformations) == 1:
            stiffness = dict(zip(law.deformations, law.parameters["S"], strict=True))
            shares = zip(curvatures, weights, strict=True)
            added = {name: stiffness.get(name, 0.0) / weight for name, weight in shares}
        else:
            added = dict.fromkeys(law.deformations, np.inf)
        for name in curvatures:
            EI[name] += added.get(name, 0.0)
    return float(min(EI.values()))
