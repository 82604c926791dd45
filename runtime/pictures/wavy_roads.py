"""The ground under tyres on a road of waves: a strip for each distinct road, as long and wide as its tyres go."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from flexel.base.arrays import Array
from flexel.declare.wheels import Waves
from flexel.pictures.shape import Shape, place
from flexel.structure.instances import Instance
from flexel.structure.state import State

STEPS = 40  # of the strip in a wavelength
MOST = 2000  # steps in all
BESIDE = 1.2  # width beside the middle of a tyre, relative to its radius
COLOUR = "#c9d0d6"


def wavy_roads(states: Sequence[State]) -> Iterator[Shape]:
    """Strips of ground that do not move, for all states of a motion."""
    found: dict[tuple[float, ...], list[Instance]] = {}
    for instance in states[0].structure.instances:
        z = instance.parameters
        if instance.spec.picture == "tyre" and "waves" in z:
            shape = (float(z[name][0]) for name in ("amplitude", "wavelength", "start", "waves"))
            key = (*shape, *z["heading"].tolist(), float(z["height"][0]))
            found.setdefault(key, []).append(instance)
    for key, tyres in found.items():
        amplitude, wavelength, start, count, along, across, height = key
        road = Waves(amplitude, wavelength, start, count, (along, across), height)
        yield _strip(road, tyres, states)


def _strip(road: Waves, tyres: Sequence[Instance], states: Sequence[State]) -> Shape:
    """The surface of a road where these tyres go."""
    ahead = np.append(road.heading, 0.0)
    left = np.array([-ahead[1], ahead[0], 0.0])
    radius = max(float(z.parameters["radius"][0]) for z in tyres)
    hubs = np.array([place(state, z.nodes[0]) for state in states for z in tyres])
    begin, end = float(np.min(hubs @ ahead)) - 2 * radius, float(np.max(hubs @ ahead)) + 2 * radius
    right, far = float(np.min(hubs @ left)) - BESIDE * radius, float(np.max(hubs @ left)) + BESIDE * radius
    count = int(np.clip(np.ceil((end - begin) / road.wavelength * STEPS), 2, MOST))
    s = np.linspace(begin, end, count)
    rows = [_row(road, side, s, ahead, left) for side in (right, far)]
    i = np.arange(count - 1)
    triangles = np.vstack(
        [np.column_stack([i, i + 1, i + count]), np.column_stack([i + 1, i + count + 1, i + count])]
    )
    origin = (np.zeros(3), np.eye(3))
    lines = (rows[0], rows[1])
    return Shape("ground", "road", lines, origin, surface=(np.vstack(rows), triangles), colour=COLOUR)


def _row(road: Waves, side: float, s: Array, ahead: Array, left: Array) -> Array:
    places = np.outer(s, ahead) + side * left
    places[:, 2] = [road.level(float(x), float(y)) for x, y, _ in places]
    return places
