"""Whether rigid wheels fall flat on the road: nothing holds them beyond, and the hub passes below the road."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from flexel.base.arrays import Array
from flexel.model.structure import Structure


def fallen(structure: Structure, times: Sequence[float], x: Array) -> Iterator[str]:
    """Describe wheels whose hub is above the road at first, and below it at a later stored time, for x (times, n)."""
    wheels, matrix = structure.wheels
    heights = matrix @ x.T
    if heights.min(initial=0.0) >= 0:
        return
    for wheel, height in zip(wheels, heights, strict=True):
        if height.min() < 0 < height[0]:
            t = times[int(np.argmax(height < 0))]
            yield (
                f"wheel '{wheel.name}' has fallen flat: at t = {t:g} s its hub is below the road, where no contact "
                f"holds it; end the motion earlier, such as by an event on the height of '{wheel.nodes[0]}'"
            )
