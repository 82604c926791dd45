"""Painters: a table of functions that return the shapes of each kind of element, in one state or in many.

A new kind needs one function and one line in `PAINTERS`. Arrays may have the states along their first axis; see
`flexel.apps.view.poses.Poses`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping

import numpy as np

from flexel.apps.view import planar_painters
from flexel.apps.view.poses import Poses
from flexel.apps.view.primitives import (
    Shape,
    circle,
    frame_of,
    outline_of,
    posed,
    rectangle,
    section_outline,
    segment,
    spatial,
    triad_of,
)
from flexel.apps.view.rope_painters import contact, stretch
from flexel.base.arrays import Array
from flexel.model.instances import Instance
from flexel.model.profiles import SectionForces
from flexel.model.structure import Structure
from flexel.parts.materials import Profile

SPOKES = 8
TYRE = 0.22  # half the height of a tyre's section, relative to its radius
ROUND = np.linspace(0, 2 * np.pi, 12, endpoint=False)
RIM = np.linspace(0, 2 * np.pi, 49)
BLADE = 0.06  # half the length of a blade, relative to the model
HINGE = 0.02  # half the length of a hinge's pin, relative to the model


def as_lines(poses: Poses, instance: Instance) -> Iterator[Shape]:
    """Draw the lines and marks that an element's definition names, or the line through its points if it names none."""
    found = list(declared(poses, instance))
    yield from found or _through_points(poses, instance)


def declared(poses: Poses, instance: Instance) -> Iterator[Shape]:
    """Draw the lines and marks that an element's definition names."""
    named = [output for output in instance.spec.outputs if output.draws]
    outputs = poses.outputs(instance) if named else {}
    for output in named:
        line = spatial(outputs[output.name])
        line = line[..., None, :] if len(output.shape) < 2 else line
        if output.carrier:
            pose = frame_of(outputs, output.carrier)
            yield Shape(output.draws, instance.name, (posed(line, pose),), pose)
        else:
            yield _line(poses, instance, output.draws, line)


def _line(poses: Poses, instance: Instance, style: str, line: Array) -> Shape:
    """Draw a line of an element with its section, coloured by its forces; a mark has neither."""
    if line.shape[-2] < 2:
        return Shape(style, instance.name, (line,))
    outputs, outline = poses.outputs(instance), section_outline(instance)
    across = None if outline is None else _across(outputs)
    values = _axial(poses, instance) | _bending(instance, outputs) | stretch(instance, outputs)
    return Shape(style, instance.name, (line,), outline=outline, across=across, values=values)


def _through_points(poses: Poses, instance: Instance) -> Iterator[Shape]:
    """Draw the line through the points of an element as a bar, or its only point as a mass if it has inertia."""
    ends = [n for n in instance.nodes if poses.structure.node(n).kind.endswith("point")]
    if len(ends) == 1 and "inertia" in instance.spec.kernels:
        yield Shape("mass", instance.name, (poses.place(ends[0])[..., None, :],))
    if len(ends) > 1:
        yield _line(poses, instance, "bar", np.stack([poses.place(n) for n in ends], axis=-2))


def _across(outputs: Mapping[str, Array]) -> Array | None:
    """Return the section's y axes at both ends: those that are reported, or that of the whole element."""
    if "across" in outputs:
        return spatial(outputs["across"])
    if "axes" not in outputs:
        return None
    side = triad_of(outputs)[..., 1]
    return segment(side, side)


def wheel(poses: Poses, instance: Instance) -> Iterator[Shape]:
    """Draw a wheel with the force of the road on it."""
    contact = instance.nodes[2]
    yield from tyre(poses, instance)
    force = poses.outputs(instance)["force"]
    yield Shape("force", instance.name, (poses.place(contact)[..., None, :],), force=force)


def tyre(poses: Poses, instance: Instance) -> Iterator[Shape]:
    """Draw rim, spokes, axle, and one spoke in another style (the valve) that shows the rotation."""
    pose = frame_of(poses.outputs(instance))
    radius, axle = float(instance.parameters["radius"][0]), instance.parameters["axle"]
    first = np.cross(axle, np.eye(3)[int(np.argmin(np.abs(axle)))])
    first /= np.linalg.norm(first)
    across = np.column_stack([first, np.cross(axle, first)])

    def ring(angles: Array) -> Array:
        return np.asarray(radius * (across @ np.array([np.cos(angles), np.sin(angles)])).T)

    name, centre = instance.name, np.zeros(3)
    if instance.spec.picture == "tyre":
        side = pose[1] @ axle
        profile = TYRE * radius * np.column_stack([1.1 * np.sin(ROUND), np.cos(ROUND)])
        yield Shape("tyre", name, (posed((1 - TYRE) * ring(RIM), pose),), pose, profile, segment(side, side))
    else:
        yield Shape("rim", name, (posed(ring(RIM), pose),), pose)
    tips = ring(np.arange(SPOKES) * 2 * np.pi / SPOKES)
    spokes = [posed(segment(centre, tip), pose) for tip in tips]
    yield Shape("spoke", name, tuple(spokes[1:]), pose)
    yield Shape("valve", name, (spokes[0],), pose)
    half = 0.15 * radius * axle
    yield Shape("axle", name, (posed(np.array([-half, half]), pose),), pose)


def body(poses: Poses, instance: Instance) -> Iterator[Shape]:
    """Draw a thin line from the mass centre to the point that carries the body, and the box with its inertia."""
    outputs = poses.outputs(instance)
    pose = start, R = frame_of(outputs)
    centre = spatial(outputs["centre"])
    if np.any(centre != start):
        yield Shape("spoke", instance.name, (segment(start, centre),), pose)
    sides, T = _box(instance)
    # boxes that are thin, or larger than the whole model, are omitted: the inertia does not represent a shape
    if np.min(np.sort(sides)[1:]) > 0 and np.max(sides) < poses.size:
        axes = R @ T
        half, side = sides[0] / 2 * axes[..., 0], axes[..., 1]
        line, outline = segment(centre - half, centre + half), rectangle(sides[1], sides[2])
        yield Shape("box", instance.name, (line,), (centre, axes), outline, segment(side, side))


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


def blade(poses: Poses, instance: Instance) -> Iterator[Shape]:
    """Draw the blade of a skate, a line on the ice."""
    outputs = poses.outputs(instance)
    pose, half = frame_of(outputs), BLADE * poses.size * spatial(outputs["ahead"])
    yield Shape("rim", instance.name, (segment(pose[0] - half, pose[0] + half),), pose)


def bearing(poses: Poses, instance: Instance) -> Iterator[Shape]:
    """Draw the pin at its first point, and the link to the second."""
    yield _pin(poses, instance, instance.nodes[0], _pin_axis(poses, instance))
    yield from as_lines(poses, instance)


def hinge(poses: Poses, instance: Instance) -> Iterator[Shape]:
    """Draw the pin, if the bodies of the hinge have a common point; a hinge between frames alone has no position."""
    held = _pin_point(poses, instance)
    if held:
        yield _pin(poses, instance, held, _pin_axis(poses, instance))


def pin_place(poses: Poses, instance: Instance) -> tuple[Array, Array] | None:
    """Return position and axis, (..., 3) each, of the pin of a hinge, if it has a position and reports its axis."""
    held = _pin_point(poses, instance)
    known = instance.spec.planar or instance.spec.reports("axes")
    return (poses.place(held), _pin_axis(poses, instance)) if held and known else None


def _pin_point(poses: Poses, instance: Instance) -> str:
    """Return a point common to the bodies of a hinge, or one of either body."""
    held = [body_points(poses.structure, r) for r in instance.nodes]
    found = [name for name in held[1] if name in held[0]] or held[1] or held[0]
    return found[0] if found else ""


def _pin_axis(poses: Poses, instance: Instance) -> Array:
    if instance.spec.planar:
        return np.array([0.0, 0.0, 1.0])
    return triad_of(poses.outputs(instance))[..., 0]


def _pin(poses: Poses, instance: Instance, point: str, axis: Array) -> Shape:
    half = HINGE * poses.size
    centre = poses.place(point)
    line = segment(centre - half * axis, centre + half * axis)
    return Shape("hinge", instance.name, (line,), outline=circle(0.6 * half))


def body_points(structure: Structure, frame: str) -> list[str]:
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


def _axial(poses: Poses, instance: Instance) -> dict[str, Array]:
    """Return tension and axial strain of an element that can stretch, the strain if it has an undeformed length."""
    name = f"{instance.name}.elongation"
    if name not in poses.structure.index:
        return {}
    found = {"tension": poses.stress(name)[..., None]}
    if "l0" in instance.parameters:
        found["strain"] = abs(poses.deformation(name)[..., None]) / float(instance.parameters["l0"][0])
    return found


def _bending(instance: Instance, outputs: Mapping[str, Array]) -> dict[str, Array]:
    """Return bending moments at the ends of a beam, and the largest strain in the sections there, if known."""
    if instance.spec.family != "beam" or "moment_p" not in outputs:
        return {}
    N, moments, B = (_at_ends(outputs, name) for name in ("force", "moment", "bimoment"))
    My, Mz = (moments[..., -2] if moments.shape[-1] > 1 else 0.0 * N[..., 0]), moments[..., -1]
    found = {"bending moment": np.hypot(My, Mz)}
    profile = instance.profile
    if isinstance(profile, Profile):
        k, (y, z) = profile.stiffness(), np.max(np.abs(outline_of(profile.section)), axis=0)
        bent = abs(My) * z / k["EIy"] + abs(Mz) * y / k["EIz"]
        found["strain"] = abs(N[..., 0]) / k["EA"] + bent + abs(B[..., 0]) * _warping_strain(profile, B)
        found["bending strain"] = bent
        found["normal stress"] = profile.material.E * found["strain"]
    return found


def _at_ends(outputs: Mapping[str, Array], name: str) -> Array:
    """Return the forces (..., 2, k) of a beam at both ends, p and q; zero if it has none of this name."""
    if f"{name}_p" not in outputs:
        return np.zeros((2, 1))
    return np.stack([outputs[f"{name}_{end}"] for end in "pq"], axis=-2)


def _warping_strain(profile: Profile, bimoments: Array) -> float:
    """Return the largest strain of a section under a unit bimoment alone; zero if there is none."""
    if not np.any(bimoments):
        return 0.0
    places = profile.section.stresses(SectionForces(B=1.0))
    return max(end.normal for end in places) / profile.material.E


LINES = (
    "",
    "bar",
    "beam",
    "bearing",
    "rope",
)  # pictures that show the declared lines; others have them beside
# keys: the word for the picture in an element's declaration
PAINTERS: dict[str, Callable[[Poses, Instance], Iterator[Shape]]] = {
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
