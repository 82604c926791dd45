"""Whether rigid wheels fall flat on the road: nothing holds them beyond, and the hub passes below the road."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from flexel.base.arrays import Array
from flexel.model.instances import Instance
from flexel.model.structure import Structure


def fallen(structure: Structure, times: Sequence[float], x: Array) -> Iterator[str]:
    """Describe wheels whose hub is above the road at first, and below it at a later stored time, for x (times, n)."""
    for wheel in filter(_rolls, structure.instances):
        hub, *_, contact = wheel.nodes
        height = (x[:, structure.places(hub)] - x[:, structure.places(contact)]) @ wheel.parameters["normal"]
        below = np.flatnonzero(height < 0)
        if below.size and height[0] > 0:
            yield (
                f"wheel '{wheel.name}' has fallen flat: at t = {times[below[0]]:g} s its hub is below the road, "
                f"where no contact holds it; end the motion earlier, such as by an event on the height of '{hub}'"
            )


def _rolls(element: Instance) -> bool:
    """Whether an element keeps its last node on a road below its first."""
    touches = any(deformation.kind == "touch" for deformation in element.spec.deformations)
    return touches and "axle" in element.parameters and "normal" in element.parameters
