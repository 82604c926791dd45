"""Shapes of pulleys, gears and wheels of planar models at a state."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from flexel.base.arrays import Array
from flexel.pictures.shape import Shape, axes_of, place, turned
from flexel.structure.instances import Instance
from flexel.structure.state import State

RIM = np.linspace(0, 2 * np.pi, 49)


def disc(name: str, centre: Array, axes: Array, radius: float) -> Iterator[Shape]:
    """A circle in the plane of the first two axes, with one spoke that shows the rotation.

    Parameters
    ----------
    name : str
        Of the element.
    centre : ndarray (3,)
        [m]
    axes : ndarray (3, 3)
        Unit vectors in columns.
    radius : float
        [m]; its sign does not matter.
    """
    ring = abs(radius) * np.column_stack([np.cos(RIM), np.sin(RIM), 0 * RIM])
    yield Shape("rim", name, (centre + ring @ axes.T,), (centre, axes))
    yield Shape("valve", name, (np.array([centre, centre + abs(radius) * axes[:, 0]]),), (centre, axes))


def wheel(state: State, instance: Instance) -> Iterator[Shape]:
    """A wheel that rolls upright on the plane; its axle is at mid-height, in the plane of the picture."""
    point, heading, spin = instance.nodes
    ahead = turned(float(state.position(heading)[0]) + _number(instance, "alpha0"))
    upright = np.column_stack([ahead[:, 0], -ahead[:, 2], ahead[:, 1]])  # forward, down, along the axle
    axes = upright @ axes_of(state, spin)
    yield from disc(instance.name, place(state, point), axes, _number(instance, "radius"))


def gears(state: State, instance: Instance) -> Iterator[Shape]:
    """Both pitch circles."""
    p, rp, q, rq = instance.nodes
    for point, angle, radius in ((p, rp, "radius_p"), (q, rq, "radius_q")):
        yield from disc(instance.name, place(state, point), axes_of(state, angle), _number(instance, radius))


def belt(state: State, instance: Instance) -> Iterator[Shape]:
    """Both pulleys and the belt's run between them, coloured by its tension."""
    yield from gears(state, instance)
    tension = {"tension": np.array([state.force(f"{instance.name}.elongation")])}
    yield Shape("bar", instance.name, (run(state, instance),), values=tension)


def run(state: State, instance: Instance) -> Array:
    """Points (2, 3) where a belt leaves one pulley and meets the other: on the left of its direction."""
    p, _, q, _ = instance.nodes
    a, b = _number(instance, "radius_p"), _number(instance, "radius_q")
    start, end = place(state, p), place(state, q)
    d = end - start
    theta = np.arctan2(d[1], d[0]) - np.arctan2(a - b, np.sqrt(np.maximum(d @ d - (a - b) ** 2, 0.0)))
    left = np.array([-np.sin(theta), np.cos(theta), 0.0])
    return np.array([start + a * left, end + b * left])


def _number(instance: Instance, parameter: str) -> float:
    return float(instance.parameters[parameter][0])
