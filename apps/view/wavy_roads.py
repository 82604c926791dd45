"""Draws the ground under tyres on a road of waves: a strip for each distinct road, as long and wide as its tyres go."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from flexel.apps.view.poses import Poses
from flexel.apps.view.primitives import Shape
from flexel.base.arrays import Array
from flexel.model.instances import Instance
from flexel.model.state import State
from flexel.parts.wheels import Waves

STEPS_PER_WAVELENGTH = 40  # of the strip per wavelength
MAX_STEPS = 2000  # steps in all
SIDE_MARGIN = 1.2  # margin on each side of the middle of a tyre, relative to its radius
COLOUR = "#c9d0d6"


def wavy_roads(states: Sequence[State]) -> Iterator[Shape]:
    """Return strips of ground that do not move, for all states of a motion."""
    found: dict[tuple[float, ...], list[Instance]] = {}
    for instance in states[0].structure.instances:
        parameters = instance.parameters
        if instance.spec.picture == "tyre" and "waves" in parameters:
            shape = (float(parameters[name][0]) for name in ("amplitude", "wavelength", "start", "waves"))
            key = (*shape, *parameters["heading"].tolist(), float(parameters["height"][0]))
            found.setdefault(key, []).append(instance)
    for key, tyres in found.items():
        amplitude, wavelength, start, count, along, across, height = key
        road = Waves(amplitude, wavelength, start, count, (along, across), height)
        yield _strip(road, tyres, states)


def _strip(road: Waves, tyres: Sequence[Instance], states: Sequence[State]) -> Shape:
    """Return the surface of a road where these tyres go."""
    ahead = np.append(road.heading, 0.0)
    left = np.array([-ahead[1], ahead[0], 0.0])
    radius = max(float(tyre.parameters["radius"][0]) for tyre in tyres)
    poses = Poses(states)
    hubs = np.concatenate([poses.place(tyre.nodes[0]) for tyre in tyres])
    begin, end = float(np.min(hubs @ ahead)) - 2 * radius, float(np.max(hubs @ ahead)) + 2 * radius
    right, far = (
        float(np.min(hubs @ left)) - SIDE_MARGIN * radius,
        float(np.max(hubs @ left)) + SIDE_MARGIN * radius,
    )
    count = int(np.clip(np.ceil((end - begin) / road.wavelength * STEPS_PER_WAVELENGTH), 2, MAX_STEPS))
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
