"""Draws pulleys, gears and wheels of planar models at a state."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from flexel.apps.view.poses import Poses
from flexel.apps.view.primitives import Shape, frame_of, posed, segment
from flexel.base.arrays import Array
from flexel.model.instances import Instance

RIM = np.linspace(0, 2 * np.pi, 49)


def disc(name: str, centre: Array, axes: Array, radius: float) -> Iterator[Shape]:
    """Draw a circle in the plane of the first two axes, with one spoke that shows the rotation.

    Parameters
    ----------
    name : str
        Of the element.
    centre : ndarray (..., 3)
        [m]
    axes : ndarray (..., 3, 3)
        Unit vectors in columns.
    radius : float
        [m]; its sign does not matter.
    """
    ring = abs(radius) * np.column_stack([np.cos(RIM), np.sin(RIM), 0 * RIM])
    yield Shape("rim", name, (posed(ring, (centre, axes)),), (centre, axes))
    spoke = segment(centre, centre + abs(radius) * axes[..., 0])
    yield Shape("valve", name, (spoke,), (centre, axes))


def wheel(poses: Poses, instance: Instance) -> Iterator[Shape]:
    """Draw a wheel that rolls upright on the plane; its axle is at mid-height, in the plane of the picture."""
    yield from disc(instance.name, *frame_of(poses.outputs(instance)), _number(instance, "radius"))


def gears(poses: Poses, instance: Instance) -> Iterator[Shape]:
    """Draw both pitch circles, or the pulleys of a belt."""
    outputs = poses.outputs(instance)
    for end in ("p", "q"):
        pose = frame_of(outputs, (f"origin_{end}", f"axes_{end}"))
        yield from disc(instance.name, *pose, _number(instance, f"radius_{end}"))


def _number(instance: Instance, parameter: str) -> float:
    return float(instance.parameters[parameter][0])
