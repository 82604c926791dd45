"""Shapes of skates and cams at a state."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from flexel.base.quaternions import matrix
from flexel.declare.cams import at_knots
from flexel.pictures.shape import Shape, axes_of, extent, place, turned
from flexel.structure.instances import Instance
from flexel.structure.state import State

BLADE = 0.06  # half the length of a blade, relative to the model


def blade(state: State, instance: Instance) -> Iterator[Shape]:
    """The blade of a skate, a line on the ice."""
    point, frame = instance.nodes
    centre, axes = place(state, point), axes_of(state, frame)
    if instance.spec.planar:
        ahead = axes @ turned(float(instance.parameters["alpha0"][0]))[:, 0]
    else:
        ahead = axes @ instance.parameters["blade"]
    half = BLADE * extent(state.structure) * ahead
    yield Shape("rim", instance.name, (np.array([centre - half, centre + half]),), (centre, axes))


def cam(state: State, instance: Instance) -> Iterator[Shape]:
    """The pitch curve of a cam, with a spoke at the angle zero."""
    p, frame, _ = instance.nodes
    turn = instance.parameters["alpha0" if instance.spec.planar else "tp"]
    axes = axes_of(state, frame) @ (turned(float(turn[0])) if instance.spec.planar else matrix(turn))
    r = at_knots(instance.parameters["control"])
    angles = np.arange(r.size + 1) * 2 * np.pi / r.size
    ring = np.append(r, r[0])[:, None] * np.column_stack([np.cos(angles), np.sin(angles), 0 * angles])
    centre = place(state, p)
    line = centre + ring @ axes.T
    yield Shape("rim", instance.name, (line,), (centre, axes))
    yield Shape("valve", instance.name, (np.array([centre, line[0]]),), (centre, axes))
