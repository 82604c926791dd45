"""Painters: a table of functions that return the shapes of each kind of element at a state.

A new kind needs one function and one line in `PAINTERS`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping

import numpy as np

from flexel.apps.view import planar_painters
from flexel.apps.view.primitives import (
    Shape,
    circle,
    extent,
    frame_of,
    outline_of,
    place,
    rectangle,
    reported,
    reports,
    section_outline,
    spatial,
    triad_of,
)
from flexel.apps.view.rope_painters import contact, stretch
from flexel.base.arrays import Array
from flexel.model.instances import Instance
from flexel.model.profiles import SectionForces
from flexel.model.state import State
from flexel.model.stress import end_forces
from flexel.model.structure import Structure
from flexel.parts.materials import Profile

SPOKES = 8
TYRE = 0.22  # half the height of a tyre's section, relative to its radius
ROUND = np.linspace(0, 2 * np.pi, 12, endpoint=False)
RIM = np.linspace(0, 2 * np.pi, 49)
BLADE = 0.06  # half the length of a blade, relative to the model
HINGE = 0.02  # half the length of a hinge's pin, relative to the model


def as_lines(state: State, instance: Instance) -> Iterator[Shape]:
    """Draw the lines and marks that an element's definition names, or the line through its points if it names none."""
    found = list(declared(state, instance))
    yield from found or _through_points(state, instance)


def declared(state: State, instance: Instance) -> Iterator[Shape]:
    """Draw the lines and marks that an element's definition names."""
    named = [output for output in instance.spec.outputs if output.draws]
    outputs = reported(state, instance) if named else {}
    for output in named:
        line = np.atleast_2d(spatial(outputs[output.name]))
        if output.carrier:
            pose = frame_of(outputs, output.carrier)
            yield Shape(output.draws, instance.name, (_posed(line, pose),), pose)
        else:
            yield _line(state, instance, output.draws, line)


def _posed(line: Array, pose: tuple[Array, Array]) -> Array:
    """Return places (k, 3) in global axes from those in the axes of a frame."""
    return np.asarray(pose[0] + line @ pose[1].T)


def _line(state: State, instance: Instance, style: str, line: Array) -> Shape:
    """Draw a line of an element with its section, coloured by its forces; a mark has neither."""
    if len(line) < 2:
        return Shape(style, instance.name, (line,))
    outputs, outline = reported(state, instance), section_outline(instance)
    across = None if outline is None else _across(outputs)
    values = _axial(state, instance) | _bending(instance, outputs) | stretch(instance, outputs)
    return Shape(style, instance.name, (line,), outline=outline, across=across, values=values)


def _through_points(state: State, instance: Instance) -> Iterator[Shape]:
    """Draw the line through the points of an element as a bar; nothing with fewer than two."""
    ends = [n for n in instance.nodes if state.structure.node(n).kind.endswith("point")]
    if len(ends) > 1:
        yield _line(state, instance, "bar", np.array([place(state, n) for n in ends]))


def _across(outputs: Mapping[str, Array]) -> Array | None:
    """Return the section's y axes at both ends: those that are reported, or that of the whole element."""
    if "across" in outputs:
        return spatial(outputs["across"])
    return np.tile(triad_of(outputs)[:, 1], (2, 1)) if "axes" in outputs else None


def wheel(state: State, instance: Instance) -> Iterator[Shape]:
    """Draw a wheel with the force of the road on it."""
    contact = instance.nodes[2]
    yield from tyre(state, instance)
    force = reported(state, instance)["force"]
    yield Shape("force", instance.name, (place(state, contact)[None],), force=force)


def tyre(state: State, instance: Instance) -> Iterator[Shape]:
    """Draw rim, spokes, axle, and one spoke in another style (the valve) that shows the rotation."""
    pose = centre, R = frame_of(reported(state, instance))
    radius, axle = float(instance.parameters["radius"][0]), instance.parameters["axle"]
    first = np.cross(axle, np.eye(3)[int(np.argmin(np.abs(axle)))])
    first /= np.linalg.norm(first)
    across = np.column_stack([first, np.cross(axle, first)])

    def ring(angles: Array) -> Array:
        return _posed(radius * (across @ np.array([np.cos(angles), np.sin(angles)])).T, pose)

    name = instance.name
    if instance.spec.picture == "tyre":
        side = R @ axle
        inner = centre + (1 - TYRE) * (ring(RIM) - centre)
        profile = TYRE * radius * np.column_stack([1.1 * np.sin(ROUND), np.cos(ROUND)])
        yield Shape("tyre", name, (inner,), pose, profile, np.array([side, side]))
    else:
        yield Shape("rim", name, (ring(RIM),), pose)
    tips = ring(np.arange(SPOKES) * 2 * np.pi / SPOKES)
    yield Shape("spoke", name, tuple(np.array([centre, tip]) for tip in tips[1:]), pose)
    yield Shape("valve", name, (np.array([centre, tips[0]]),), pose)
    half = 0.15 * radius * (R @ axle)
    yield Shape("axle", name, (np.array([centre - half, centre + half]),), pose)


def body(state: State, instance: Instance) -> Iterator[Shape]:
    """Draw a thin line from the mass centre to the point that carries the body, and the box with its inertia."""
    outputs = reported(state, instance)
    pose = start, R = frame_of(outputs)
    centre = spatial(outputs["centre"])
    if np.any(centre != start):
        yield Shape("spoke", instance.name, (np.array([start, centre]),), pose)
    sides, T = _box(instance)
    # boxes that are thin, or larger than the whole model, are omitted: the inertia does not represent a shape
    if np.min(np.sort(sides)[1:]) > 0 and np.max(sides) < extent(state.structure):
        axes = R @ T
        half = sides[0] / 2 * axes[:, 0]
        line = np.array([centre - half, centre + half])
        outline, across = rectangle(sides[1], sides[2]), np.array([axes[:, 1], axes[:, 1]])
        yield Shape("box", instance.name, (line,), (centre, axes), outline, across)


def _box(instance: Instance) -> tuple[Array, Array]:
    """Return sides (3,) and axes (3, 3) of the uniform box with a body's mass and principal moments of inertia."""
    mass, J = float(instance.parameters["mass"][0]), instance.parameters["J"]
    if J.size == 1:
        side = np.sqrt(6 * float(J[0]) / mass)
        return np.array([side, side, 0.1 * side]), np.eye(3)
    xx, yy, zz, xy, xz, yz = J
    w, T = np.linalg.eigh(np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]))
    T[:, 2] = np.cross(T[:, 0], T[:, 1])
    return np.sqrt(np.maximum(6 * (w.sum() - 2 * w) / mass, 0.0)), T


def blade(state: State, instance: Instance) -> Iterator[Shape]:
    """Draw the blade of a skate, a line on the ice."""
    outputs = reported(state, instance)
    pose, half = frame_of(outputs), BLADE * extent(state.structure) * spatial(outputs["ahead"])
    yield Shape("rim", instance.name, (np.array([pose[0] - half, pose[0] + half]),), pose)


def bearing(state: State, instance: Instance) -> Iterator[Shape]:
    """Draw the pin at its first point, and the link to the second."""
    yield _pin(state, instance, instance.nodes[0], _pin_axis(state, instance))
    yield from as_lines(state, instance)


def hinge(state: State, instance: Instance) -> Iterator[Shape]:
    """Draw the pin, if the bodies of the hinge have a common point; a hinge between frames alone has no position."""
    held = _pin_point(state, instance)
    if held:
        yield _pin(state, instance, held, _pin_axis(state, instance))


def pin_place(state: State, instance: Instance) -> tuple[Array, Array] | None:
    """Return position and axis, (3,) each, of the pin of a hinge, if it has a position and reports its axis."""
    held = _pin_point(state, instance)
    known = instance.spec.planar or reports(instance, "axes")
    return (place(state, held), _pin_axis(state, instance)) if held and known else None


def _pin_point(state: State, instance: Instance) -> str:
    """Return a point common to the bodies of a hinge, or one of either body."""
    held = [_points(state.structure, r) for r in instance.nodes]
    found = [name for name in held[1] if name in held[0]] or held[1] or held[0]
    return found[0] if found else ""


def _pin_axis(state: State, instance: Instance) -> Array:
    if instance.spec.planar:
        return np.array([0.0, 0.0, 1.0])
    return triad_of(reported(state, instance))[:, 0]


def _pin(state: State, instance: Instance, point: str, axis: Array) -> Shape:
    half = HINGE * extent(state.structure)
    centre = place(state, point)
    line = np.array([centre - half * axis, centre + half * axis])
    return Shape("hinge", instance.name, (line,), outline=circle(0.6 * half))


def _points(structure: Structure, frame: str) -> list[str]:
    """Return points on the body of a frame, in the order of the elements that attach them."""
    found: list[str] = []
    for instance in structure.instances:
        if frame not in instance.nodes:
            continue
        ends = [n for n in instance.nodes if structure.node(n).kind.endswith("point")]
        frames = [n for n in instance.nodes if n not in ends]
        if len(frames) == len(ends):  # each end has a separate frame
            ends = [ends[frames.index(frame)]]
        elif rolls(instance):
            ends = ends[:1]
        found += [name for name in ends if "." not in name]
    return found


def rolls(instance: Instance) -> bool:
    """Whether an element is a wheel or tyre with a hub and a frame."""
    return instance.spec.picture in ("wheel", "tyre")


def _axial(state: State, instance: Instance) -> dict[str, Array]:
    """Return tension and axial strain of an element that can stretch, the strain if it has an undeformed length."""
    name = f"{instance.name}.elongation"
    if name not in state.structure.index:
        return {}
    found = {"tension": np.array([state.force(name)])}
    if "l0" in instance.parameters:
        found["strain"] = np.array([abs(state[name]) / float(instance.parameters["l0"][0])])
    return found


def _bending(instance: Instance, outputs: Mapping[str, Array]) -> dict[str, Array]:
    """Return bending moments at the ends of a beam, and the largest strain in the sections there, if known."""
    if instance.spec.family != "beam" or "moment_p" not in outputs:
        return {}
    ends = [end_forces(outputs, end) for end in "pq"]
    found = {"bending moment": np.array([np.hypot(end.My, end.Mz) for end in ends])}
    profile = instance.profile
    if isinstance(profile, Profile):
        k, (y, z) = profile.stiffness(), np.max(np.abs(outline_of(profile.section)), axis=0)
        parts = [(abs(f.N) / k["EA"], abs(f.My) * z / k["EIy"], abs(f.Mz) * y / k["EIz"]) for f in ends]
        warping = [_warping_strain(profile, f.B) for f in ends]
        found["strain"] = np.array([sum(p) + w for p, w in zip(parts, warping, strict=True)])
        found["bending strain"] = np.array([sum(p[1:]) for p in parts])
    return found


def _warping_strain(profile: Profile, bimoment: float) -> float:
    """Return the largest strain of a section under a bimoment alone."""
    if not bimoment:
        return 0.0
    places = profile.section.stresses(SectionForces(B=bimoment))
    return max(end.normal for end in places) / profile.material.E


LINES = (
    "",
    "bar",
    "beam",
    "bearing",
    "rope",
)  # pictures that show the declared lines; others have them beside
# keys: the word for the picture in an element's declaration
PAINTERS: dict[str, Callable[[State, Instance], Iterator[Shape]]] = {
    "": as_lines,
    "bar": as_lines,
    "beam": as_lines,
    "bearing": bearing,
    "belt": planar_painters.gears,
    "blade": blade,
    "body": body,
    "contact": contact,
    "disc": planar_painters.wheel,
    "gears": planar_painters.gears,
    "hinge": hinge,
    "rope": as_lines,
    "tyre": tyre,
    "wheel": wheel,
}
