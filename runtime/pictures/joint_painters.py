"""Shapes of skates, cams and their followers at a state."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from flexel.base.arrays import Array
from flexel.base.quaternions import matrix
from flexel.declare.cams import at_knots, slope_at_knots
from flexel.pictures.shape import Shape, axes_of, extent, place, turned
from flexel.structure.instances import Instance
from flexel.structure.state import State

FACE = 1.2  # half the length of a flat face, relative to how far the place of contact moves along it
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
    r, e, _ = _polar(instance)
    yield from _rim(state, instance, r[:, None] * e)


def flat_cam(state: State, instance: Instance) -> Iterator[Shape]:
    """A cam under a flat face, which is the envelope of its tangents; and the face, as long as it is touched."""
    h, e, t = _polar(instance)
    slope = slope_at_knots(instance.parameters["control"])
    yield from _rim(state, instance, h[:, None] * e + np.append(slope, slope[0])[:, None] * t)
    _, _, q, frame = instance.nodes
    turn, axes = instance.parameters["alphaq0" if instance.spec.planar else "tq"], axes_of(state, frame)
    axes = axes @ (turned(float(turn[0])) if instance.spec.planar else matrix(turn))
    half = FACE * float(np.abs(slope).max()) * axes[:, 1]
    centre = place(state, q)
    yield Shape("rim", instance.name, (np.array([centre - half, centre + half]),), (centre, axes))


def _polar(instance: Instance) -> tuple[Array, Array, Array]:
    """Values of the outline round a turn, directions of their angles in the cam, and those across them."""
    r = at_knots(instance.parameters["control"])
    angles = np.arange(r.size + 1) * 2 * np.pi / r.size
    c, s, o = np.cos(angles), np.sin(angles), 0 * angles
    return np.append(r, r[0]), np.column_stack([c, s, o]), np.column_stack([-s, c, o])


def _rim(state: State, instance: Instance, ring: Array) -> Iterator[Shape]:
    """A closed line in a cam, and a spoke to its start."""
    p, frame = instance.nodes[:2]
    turn = instance.parameters["alpha0" if instance.spec.planar else "tp"]
    axes = axes_of(state, frame) @ (turned(float(turn[0])) if instance.spec.planar else matrix(turn))
    centre = place(state, p)
    line = centre + ring @ axes.T
    yield Shape("rim", instance.name, (line,), (centre, axes))
    yield Shape("valve", instance.name, (np.array([centre, line[0]]),), (centre, axes))
