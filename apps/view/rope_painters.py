"""Draws what ropes, points and balls touch: balls, sheaves, and contact forces; and colours of ropes."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping

import numpy as np

from flexel.apps.view.planar_painters import disc
from flexel.apps.view.poses import Poses
from flexel.apps.view.primitives import Shape, circle, frame_of, outline_of, posed, segment, spatial, triad_of
from flexel.base.arrays import Array
from flexel.model.instances import Instance
from flexel.model.profiles import Section
from flexel.parts.materials import Profile
from flexel.parts.wire_rope import WireRope

RING = np.linspace(0, 2 * np.pi, 65)
SHEAVE_WIDTH = 6.0  # width of a sheave, relative to the rope's radius
CONTACT_WIDTH = 0.2  # the same relative to the sheave's radius, for contacts of points and balls


def stretch(instance: Instance, outputs: Mapping[str, Array]) -> dict[str, Array]:
    """Return tension and strain along a cable, at equal steps between the points where it reports them."""
    if instance.spec.family != "cable" or "tension" not in outputs:
        return {}
    at, steps = outputs["arc_length"] / float(instance.parameters["l0"][0]), np.linspace(0, 1, 5)
    found = {"tension": outputs["tension"], "strain": abs(outputs["strain"])}
    if isinstance(instance.profile, Profile):
        found["bending strain"] = outputs["curvature"] * _fibre(instance.profile.section)
        found["strain"] = found["strain"] + found["bending strain"]
    return {key: _along(values, at, steps) for key, values in found.items()}


def _along(values: Array, at: Array, steps: Array) -> Array:
    """Interpolate values (..., k) at places (..., k), the same in all states; constant beyond the outermost."""
    first = at.reshape(-1, at.shape[-1])[0]
    after = np.clip(np.searchsorted(first, steps), 1, len(first) - 1)
    share = np.clip((steps - first[after - 1]) / (first[after] - first[after - 1]), 0, 1)
    return np.asarray((1 - share) * values[..., after - 1] + share * values[..., after])


def _fibre(section: Section) -> float:
    """Return the distance [m] of the outermost fibre from its bending axis: of a wire in a rope of wires."""
    if isinstance(section, WireRope):
        return section.wire / 2
    return float(np.max(np.linalg.norm(outline_of(section), axis=1)))


def contact(poses: Poses, instance: Instance) -> Iterator[Shape]:
    """Draw the force of a contact on a rope, a point or a ball, and the ball."""
    outputs = poses.outputs(instance)
    centre = spatial(outputs["place"])
    if "sphere_radius" in instance.parameters:
        turned = "centre" in instance.parameters  # else a point, which has no axes
        yield from _ball(instance, centre, triad_of(outputs, "axes_ball") if turned else np.eye(3))
    yield Shape("force", instance.name, (centre[..., None, :],), force=spatial(outputs["force"]))


def is_ball(instance: Instance) -> bool:
    """Whether an element is the contact of a ball or disc about the point of its body, and shows the body as such."""
    parameters = instance.parameters
    return (
        "centre" in parameters
        and "sphere_radius" in parameters
        and parameters["sphere_radius"][0] > 0
        and not np.any(parameters["centre"])
    )


def _ball(instance: Instance, centre: Array, R: Array) -> Iterator[Shape]:
    """Draw a disc with a radius that shows the rotation, and in space circles about the two other axes of the body."""
    radius = float(instance.parameters["sphere_radius"][0])
    if radius:
        yield from disc(instance.name, centre, R, radius)
        if not instance.spec.planar:
            rings = tuple(posed(_ring(radius, np.delete(np.eye(3), i, axis=1)), (centre, R)) for i in (0, 1))
            yield Shape("rim", instance.name, rings, (centre, R))


def _ring(radius: float, across: Array) -> Array:
    """Return points (k, 3) of a circle about the origin, in the plane of two directions, the columns of `across`."""
    return np.asarray(radius * (across @ np.array([np.cos(RING), np.sin(RING)])).T)


def sheaves(poses: Poses, contacts: Iterable[Instance]) -> Iterator[Shape]:
    """Draw the distinct sheaves and drums of the contacts."""
    seen: set[tuple[str, float]] = set()
    for instance in contacts:
        if "radius" in instance.parameters:
            key = instance.nodes[-2], float(instance.parameters["radius"][0])
            if key not in seen:
                seen.add(key)
                yield from _sheave(poses, instance)


def _sheave(poses: Poses, instance: Instance) -> Iterator[Shape]:
    """Draw a cylinder about the axle, a few rope diameters wide, and a spoke that shows its rotation."""
    parameters = instance.parameters
    body = instance.nodes[-2]
    radius = float(parameters["radius"][0])
    half = (
        SHEAVE_WIDTH / 2 * float(parameters["rope_radius"][0])
        if "rope_radius" in parameters
        else CONTACT_WIDTH / 2 * radius
    )
    pose = frame_of(poses.outputs(instance))
    axle, spoke = np.eye(3)[[2, 0] if instance.spec.planar else [0, 1]]
    name, side = f"{body} {radius:g}", pose[1] @ spoke
    line = posed(half * np.array([-axle, axle]), pose)
    yield Shape("sheave", name, (line,), pose, circle(radius, RING.size - 1), segment(side, side))
    faces = [-1.05 * half * axle, 1.05 * half * axle]
    marks = tuple(posed(np.array([face, face + 0.95 * radius * spoke]), pose) for face in faces)
    yield Shape("valve", name, marks, pose)
    ring = _ring(radius, np.column_stack([spoke, np.cross(axle, spoke)]))
    yield Shape("spoke", name, tuple(posed(ring + face, pose) for face in faces), pose)
