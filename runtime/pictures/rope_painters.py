"""Shapes of ropes, and of what touches: the cable's curve with its tension, balls, sheaves, and contact forces."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

import numpy as np

from flexel.base.arrays import Array
from flexel.base.quaternions import matrix, product
from flexel.declare.materials import Profile
from flexel.declare.sections import Section
from flexel.pictures.planar_painters import disc
from flexel.pictures.shape import (
    Shape,
    axes_of,
    circle,
    cubic,
    outline_of,
    place,
    resultant,
    section_outline,
    turned,
)
from flexel.rope.cable_results import cable_rows
from flexel.rope.cables import PLACES
from flexel.rope.wire_rope import WireRope
from flexel.structure.instances import Instance
from flexel.structure.state import State

STEPS = np.linspace(0, 1, 9)[:, None]  # vertices of an element
RING = np.linspace(0, 2 * np.pi, 65)
WIDTH = 6.0  # width of a sheave, relative to the rope's radius
FLAT = 0.2  # the same relative to its own radius, where what touches it is a point or a ball


def rope(state: State, instance: Instance) -> Iterator[Shape]:
    """The centre line of a cable element: the cubic through its points with the slopes dr/ds there."""
    values = _stretch(state, instance)
    yield Shape(
        "rope",
        instance.name,
        (_curve(state, instance, STEPS),),
        outline=section_outline(instance),
        values=values,
    )


def _curve(state: State, instance: Instance, xi: Array) -> Array:
    """Places (k, 3) on a cable, or on the cable of a contact, at xi (k, 1)."""
    p, dp, q, dq = instance.nodes[:4]
    l0 = float(instance.parameters["l0"][0])
    return cubic(xi, (place(state, p), place(state, q)), (l0 * place(state, dp), l0 * place(state, dq)))


def _stretch(state: State, instance: Instance) -> dict[str, Array]:
    """Tension and strain along a cable, at equal steps between the points where it is known."""
    rows, steps = cable_rows(state, [instance.name]), np.linspace(0, 1, 5)
    found = {"tension": rows.tension(state)[0], "strain": abs(rows.strain(state)[0])}
    if isinstance(instance.profile, Profile):
        found["bending strain"] = rows.curvature(state)[0] * _fibre(instance.profile.section)
        found["strain"] = found["strain"] + found["bending strain"]
    return {key: np.interp(steps, PLACES, values) for key, values in found.items()}


def _fibre(section: Section) -> float:
    """Distance [m] of the outermost fibre from the axis about which it bends: of a wire in a rope of wires."""
    if isinstance(section, WireRope):
        return section.wire / 2
    return float(np.max(np.linalg.norm(outline_of(section), axis=1)))


def contact(state: State, instance: Instance) -> Iterator[Shape]:
    """The force of a contact on a rope, a point or a ball, and the ball."""
    if "xi" in instance.parameters:
        centre = _curve(state, instance, instance.parameters["xi"][:, None])
        force = resultant(state, instance, instance.nodes[:3:2])
    else:
        point, *frame, _, _ = instance.nodes
        centre, force = place(state, point)[None], resultant(state, instance, (point,))
        if frame:
            R = axes_of(state, frame[0])
            centre = centre + R @ np.append(instance.parameters["centre"], 0.0)[:3]
            yield from _ball(instance, centre[0], R)
    yield Shape("force", instance.name, (centre,), force=force)


def is_ball(instance: Instance) -> bool:
    """Whether an element is the contact of a ball or disc about the point of its body, and shows the body so."""
    z = instance.parameters
    return "centre" in z and "sphere_radius" in z and z["sphere_radius"][0] > 0 and not np.any(z["centre"])


def _ball(instance: Instance, centre: Array, R: Array) -> Iterator[Shape]:
    """A disc with a radius that shows the rotation, and in space circles about the two other axes of the body."""
    radius = float(instance.parameters["sphere_radius"][0])
    if radius:
        yield from disc(instance.name, centre, R, radius)
        if not instance.spec.planar:
            rings = tuple(centre + _ring(radius, np.delete(R, i, axis=1)) for i in (0, 1))
            yield Shape("rim", instance.name, rings, (centre, R))


def _ring(radius: float, across: Array) -> Array:
    """Points (k, 3) of a circle about the origin, in the plane of two directions, the columns of `across`."""
    return np.asarray(radius * (across @ np.array([np.cos(RING), np.sin(RING)])).T)


def sheaves(state: State, contacts: Iterable[Instance]) -> Iterator[Shape]:
    """The distinct sheaves and drums of the contacts."""
    seen: set[tuple[str, float]] = set()
    for instance in contacts:
        if "radius" in instance.parameters:
            key = instance.nodes[-2], float(instance.parameters["radius"][0])
            if key not in seen:
                seen.add(key)
                yield from _sheave(state, instance)


def _sheave(state: State, instance: Instance) -> Iterator[Shape]:
    """A cylinder about the axle, a few rope diameters wide, and a spoke that shows its rotation."""
    z = instance.parameters
    body, frame = instance.nodes[-2:]
    radius = float(z["radius"][0])
    half = WIDTH / 2 * float(z["rope_radius"][0]) if "rope_radius" in z else FLAT / 2 * radius
    if instance.spec.planar:
        R = turned(float(state.position(frame)[0]) + float(z["alpha0"][0]))
        axle, spoke = R[:, 2], R[:, 0]
    else:
        R = matrix(product(state.position(frame), z["t"]))
        axle, spoke = R[:, 0], R[:, 1]
    centre = place(state, body) + R @ np.append(z["offset"], 0.0)[:3]
    line = np.array([centre - half * axle, centre + half * axle])
    name, pose = f"{body} {radius:g}", (centre, R)
    yield Shape("sheave", name, (line,), pose, circle(radius, RING.size - 1), np.array([spoke, spoke]))
    faces = [centre + side * 1.05 * half * axle for side in (-1, 1)]
    marks = tuple(np.array([face, face + 0.95 * radius * spoke]) for face in faces)
    yield Shape("valve", name, marks, pose)
    across = np.column_stack([spoke, np.cross(axle, spoke)])
    ring = _ring(radius, across)
    yield Shape("spoke", name, tuple(ring + face for face in faces), pose)
