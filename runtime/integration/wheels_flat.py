"""Whether rigid wheels fall flat on the road: nothing holds them beyond, and the hub passes below the road."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from flexel.integration.outcome import States
from flexel.model.instances import Instance
from flexel.model.structure import Structure


def fallen(structure: Structure, states: States) -> Iterator[str]:
    """Describe wheels whose hub is above the road at first, and below it at a later stored state."""
    wheels = [one for one in structure.instances if _rolls(one)]
    x = states.coordinates if wheels else np.zeros((0, 0))
    for wheel in wheels:
        hub, *_, contact = wheel.nodes
        height = (x[:, structure.places(hub)] - x[:, structure.places(contact)]) @ wheel.parameters["normal"]
        below = np.flatnonzero(height < 0)
        if below.size and height[0] > 0:
            yield (
                f"wheel '{wheel.name}' has fallen flat: at t = {states.times[below[0]]:g} s its hub is below the road, "
                f"where no contact holds it; end the motion earlier, such as by an event on the height of '{hub}'"
            )


def _rolls(element: Instance) -> bool:
    """Whether an element keeps its last node on a road below its first."""
    touches = any(deformation.kind == "touch" for deformation in element.spec.deformations)
    return touches and "axle" in element.parameters and "normal" in element.parameters
