"""Painters: a table of functions that give the shapes of each kind of element at a state.

A new kind needs one function and one line in `PAINTERS`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np

from flexel.base.arrays import Array
from flexel.base.quaternions import matrix, product
from flexel.declare.materials import Profile
from flexel.declare.sections import SectionForces
from flexel.mechanics.stress import section_forces
from flexel.pictures import joint_painters, planar_painters
from flexel.pictures.rope_painters import contact, rope
from flexel.pictures.shape import (
    Shape,
    axes_of,
    circle,
    cubic,
    extent,
    outline_of,
    place,
    rectangle,
    resultant,
    section_outline,
    turned,
)
from flexel.structure.instances import Instance
from flexel.structure.state import State
from flexel.structure.structure import Structure

SPOKES = 8
TYRE = 0.22  # half the height of a tyre's section, relative to its radius
ROUND = np.linspace(0, 2 * np.pi, 12, endpoint=False)
RIM = np.linspace(0, 2 * np.pi, 49)
STEPS = np.linspace(0, 1, 17)[:, None]  # vertices of a bent beam
HINGE = 0.02  # half the length of a hinge's pin, relative to the model


def bar(state: State, instance: Instance) -> Iterator[Shape]:
    """The line through an element's points: trusses, rigid links, user-defined elements."""
    ends = [n for n in instance.nodes if state.structure.node(n).kind.endswith("point")]
    line = np.array([place(state, n) for n in ends])
    if len(line) > 1:
        outline = section_outline(instance)
        across = None if outline is None else _across(state, instance, line)
        yield Shape(
            "bar", instance.name, (line,), outline=outline, across=across, values=_axial(state, instance)
        )


def _across(state: State, instance: Instance, line: Array) -> Array | None:
    """The section's y axes of a rigid beam with one frame."""
    if "tp" not in instance.parameters:
        return None
    y = matrix(product(state.position(instance.nodes[1]), instance.parameters["tp"]))[:, 1]
    return np.array([y, y])


def beam(state: State, instance: Instance) -> Iterator[Shape]:
    """The axis of a beam as the cubic through its end points and end directions."""
    p, rp, q, rq = instance.nodes[:4]
    l0 = float(instance.parameters["l0"][0])
    if instance.spec.planar:
        starts = [float(instance.parameters[a][0]) for a in ("alpha0", "alphaq0")]
        triads = [turned(float(state.position(r)[0]) + a) for r, a in zip((rp, rq), starts, strict=True)]
    else:
        pairs = ((rp, "tp"), (rq, "tq"))
        triads = [matrix(product(state.position(r), instance.parameters[t])) for r, t in pairs]
    line = cubic(STEPS, (place(state, p), place(state, q)), (l0 * triads[0][:, 0], l0 * triads[1][:, 0]))
    across = np.array([t[:, 1] for t in triads])
    values = _axial(state, instance) | _bending(state, instance)
    yield Shape(
        "beam", instance.name, (line,), outline=section_outline(instance), across=across, values=values
    )


def wheel(state: State, instance: Instance) -> Iterator[Shape]:
    """A wheel with the road's force on it."""
    hub, _, contact = instance.nodes
    yield from tyre(state, instance)
    force = resultant(state, instance, (hub, contact))
    yield Shape("force", instance.name, (place(state, contact)[None],), force=force)


def tyre(state: State, instance: Instance) -> Iterator[Shape]:
    """Rim, spokes, axle, and one spoke in its own style (the valve) that shows the rotation."""
    hub, frame = instance.nodes[:2]
    centre, R = place(state, hub), axes_of(state, frame)
    radius, axle = float(instance.parameters["radius"][0]), instance.parameters["axle"]
    first = np.cross(axle, np.eye(3)[int(np.argmin(np.abs(axle)))])
    first /= np.linalg.norm(first)
    across = np.column_stack([first, np.cross(axle, first)])

    def ring(angles: Array) -> Array:
        return np.asarray(centre + radius * (R @ across @ np.array([np.cos(angles), np.sin(angles)])).T)

    name, pose = instance.name, (centre, R)
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
    """The mass centre, a thin line to the point that carries the body, and the box with its inertia."""
    p, r = instance.nodes
    start, R = place(state, p), axes_of(state, r)
    c = np.append(instance.parameters["c"], 0.0)[:3]
    centre = start + R @ c
    yield Shape("mass", instance.name, (centre[None],))
    if np.any(c):
        yield Shape("spoke", instance.name, (np.array([start, centre]),), (start, R))
    sides, T = _box(instance)
    # boxes that are thin, or larger than the whole model, are omitted: the inertia does not represent a shape
    if np.min(np.sort(sides)[1:]) > 0 and np.max(sides) < extent(state.structure):
        axes = R @ T
        half = sides[0] / 2 * axes[:, 0]
        line = np.array([centre - half, centre + half])
        outline, across = rectangle(sides[1], sides[2]), np.array([axes[:, 1], axes[:, 1]])
        yield Shape("box", instance.name, (line,), (centre, axes), outline, across)


def _box(instance: Instance) -> tuple[Array, Array]:
    """Sides (3,) and axes (3, 3) of the uniform box with a body's mass and principal moments of inertia."""
    mass, J = float(instance.parameters["mass"][0]), instance.parameters["J"]
    if J.size == 1:
        side = np.sqrt(6 * float(J[0]) / mass)
        return np.array([side, side, 0.1 * side]), np.eye(3)
    xx, yy, zz, xy, xz, yz = J
    w, T = np.linalg.eigh(np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]))
    T[:, 2] = np.cross(T[:, 0], T[:, 1])
    return np.sqrt(np.maximum(6 * (w.sum() - 2 * w) / mass, 0.0)), T


def mass(state: State, instance: Instance) -> Iterator[Shape]:
    """A mark at the point."""
    yield Shape("mass", instance.name, (place(state, instance.nodes[0])[None],))


def bearing(state: State, instance: Instance) -> Iterator[Shape]:
    """The pin at its first point, and the link to the second."""
    p, rp, *_ = instance.nodes
    yield _pin(state, instance, p, matrix(product(state.position(rp), instance.parameters["tp"]))[:, 0])
    yield from bar(state, instance)


def hinge(state: State, instance: Instance) -> Iterator[Shape]:
    """The pin, if the bodies of the hinge have a common point; a hinge between frames alone has no place."""
    held = _pin_point(state, instance)
    if held:
        yield _pin(state, instance, held, _pin_axis(state, instance))


def pin_place(state: State, instance: Instance) -> tuple[Array, Array] | None:
    """Place and axis, (3,) each, of the pin of a hinge, if it has a place."""
    held = _pin_point(state, instance)
    return (place(state, held), _pin_axis(state, instance)) if held else None


def _pin_point(state: State, instance: Instance) -> str:
    """A point that the bodies of a hinge have in common, or one of them has."""
    held = [_points(state.structure, r) for r in instance.nodes]
    found = [z for z in held[1] if z in held[0]] or held[1] or held[0]
    return found[0] if found else ""


def _pin_axis(state: State, instance: Instance) -> Array:
    if instance.spec.planar:
        return np.array([0.0, 0.0, 1.0])
    return matrix(product(state.position(instance.nodes[0]), instance.parameters["tp"]))[:, 0]


def _pin(state: State, instance: Instance, point: str, axis: Array) -> Shape:
    half = HINGE * extent(state.structure)
    centre = place(state, point)
    line = np.array([centre - half * axis, centre + half * axis])
    return Shape("hinge", instance.name, (line,), outline=circle(0.6 * half))


def _points(structure: Structure, frame: str) -> list[str]:
    """Points on the body of a frame, in the order of the elements that put them there."""
    found: list[str] = []
    for instance in structure.instances:
        if frame not in instance.nodes:
            continue
        ends = [n for n in instance.nodes if structure.node(n).kind.endswith("point")]
        frames = [n for n in instance.nodes if n not in ends]
        if len(frames) == len(ends):  # each end has its own
            ends = [ends[frames.index(frame)]]
        elif rolls(instance):
            ends = ends[:1]
        found += [z for z in ends if "." not in z]
    return found


def rolls(instance: Instance) -> bool:
    """Whether an element is a wheel or tyre with a hub and a frame."""
    return instance.spec.picture in ("wheel", "tyre")


def _axial(state: State, instance: Instance) -> dict[str, Array]:
    """Tension and axial strain of an element that can stretch and has an undeformed length."""
    name = f"{instance.name}.elongation"
    if name not in state.structure.index or "l0" not in instance.parameters:
        return {}
    strain = abs(state[name]) / float(instance.parameters["l0"][0])
    return {"tension": np.array([state.force(name)]), "strain": np.array([strain])}


def _bending(state: State, instance: Instance) -> dict[str, Array]:
    """Bending moments at the ends of a beam, and the largest strain in the sections there, if known."""
    ends = section_forces(state, instance.name)
    found = {"bending moment": np.array([np.hypot(z.My, z.Mz) for z in ends])}
    profile = instance.profile
    if isinstance(profile, Profile):
        k, (y, z) = profile.stiffness(), np.max(np.abs(outline_of(profile.section)), axis=0)
        parts = [(abs(f.N) / k["EA"], abs(f.My) * z / k["EIy"], abs(f.Mz) * y / k["EIz"]) for f in ends]
        warping = [_warping_strain(profile, f.B) for f in ends]
        found["strain"] = np.array([sum(p) + w for p, w in zip(parts, warping, strict=True)])
        found["bending strain"] = np.array([sum(p[1:]) for p in parts])
    return found


def _warping_strain(profile: Profile, bimoment: float) -> float:
    """Largest strain of a section under a bimoment alone."""
    if not bimoment:
        return 0.0
    places = profile.section.stresses(SectionForces(B=bimoment))
    return max(z.normal for z in places) / profile.material.E


# keys: the word for the picture in an element's declaration
PAINTERS: dict[str, Callable[[State, Instance], Iterator[Shape]]] = {
    "": bar,
    "bar": bar,
    "beam": beam,
    "bearing": bearing,
    "belt": planar_painters.belt,
    "blade": joint_painters.blade,
    "body": body,
    "cam": joint_painters.cam,
    "contact": contact,
    "flat cam": joint_painters.flat_cam,
    "disc": planar_painters.wheel,
    "gears": planar_painters.gears,
    "hinge": hinge,
    "mass": mass,
    "rope": rope,
    "tyre": tyre,
    "wheel": wheel,
}
