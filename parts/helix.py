"""Paths over drums with helical grooves: how far a rope lies from the plane of its sheaves.

On a drum the path advances by the lead per turn.  Straight parts connect the points at their ends, at a fleet angle.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from flexel.base.arrays import Array
from flexel.model.surfaces import Surface
from flexel.parts.rope_path import PathPart, RopePath


def out_of_plane(path: RopePath, surfaces: Mapping[str, Surface], axes: Array) -> RopePath:
    """Return the path, with its arcs in the helical grooves.

    Of the turns of a groove, the one is taken that lies nearest to the plane where the rope leaves a drum at the start
    of the path, and where it arrives on others.

    Parameters
    ----------
    path : RopePath
        In the plane.
    surfaces : dict of str to Surface
        By name; those without a helical groove are ignored.
    axes : ndarray (2, 3)
        Axes of the plane.
    """
    helical = {name: surface for name, surface in surfaces.items() if surface.pitch}
    if not helical:
        return path
    arcs = [_arc(part, helical, axes, i == 0) for i, part in enumerate(path.parts)]
    parts = [_between(arcs, i) for i in range(len(arcs))]
    return RopePath(tuple(parts))


def _arc(part: PathPart, helical: Mapping[str, Surface], axes: Array, first: bool) -> PathPart:
    """Return a part of the path, in its groove if it has one."""
    if part.on not in helical:
        return part
    groove = helical[part.on]
    rise = part.sense * groove.pitch / part.radius
    known = part.length if first else 0.0
    arm = (part.at(np.array([known]))[0] - part.origin) @ axes
    near = -float(_to_turn(groove, arm, np.zeros(1))[0])
    if np.cross(*axes) @ groove.axle < 0:
        near = -near
    return replace(part, length=part.length * float(np.hypot(1, rise)), rise=rise, off=near - rise * known)


def helical_gaps(groove: Surface, off: Array, rope_radius: float) -> Array:
    """Return gaps (ns,) [m] between a rope and a helical groove, at points (ns, 3) from its centre; see the element."""
    sine, cosine = groove.parameters["flank"]
    bottom = float(groove.parameters["groove_radius"][0])
    axial = off @ groove.axle
    arm = off - axial[:, None] * groove.axle
    depth = groove.radius + bottom - np.linalg.norm(arm, axis=1)
    side = abs(_to_turn(groove, arm, axial)) * (groove.radius + rope_radius) / groove.per_radian(rope_radius)
    reach = np.where(cosine * depth > sine * side, np.hypot(depth, side), sine * depth + cosine * side)
    return np.asarray(bottom - rope_radius - reach)


def _to_turn(groove: Surface, arm: Array, axial: Array) -> Array:
    """Return axial distances (ns,) [m] from the groove's nearest turn, of points with arms (ns, 3) from the axle."""
    assert groove.across is not None
    angle = np.arctan2(arm @ np.cross(groove.axle, groove.across), arm @ groove.across)
    lead = 2 * np.pi * groove.pitch
    away = axial - groove.pitch * angle
    return np.asarray(away - lead * np.round(away / lead))


def _between(parts: list[PathPart], i: int) -> PathPart:
    """Return a straight part, from the end of the part before it to the start of the next one."""
    part = parts[i]
    if part.sense:
        return part
    before, after = parts[i - 1] if i else None, parts[i + 1] if i + 1 < len(parts) else None
    start = before.end_off if before is not None else 0.0
    rise = ((after.off if after is not None else 0.0) - start) / part.length
    return replace(part, length=part.length * float(np.hypot(1, rise)), rise=rise, off=start)
