"""Draws springs, dampers and guides, between parts of a model and to the ground."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from flexel.apps.view.painters import pin_place
from flexel.apps.view.poses import Poses
from flexel.apps.view.primitives import Shape, rectangle, section_outline, segment, triad_of
from flexel.base.arrays import Array
from flexel.model.instances import Instance, LawInstance

BAR = 1e6  # [N] stiffness times length from which a truss is drawn as an elastic bar, not as a coil
LENGTH = 0.12  # of a spring on a displacement, relative to the model
SPIRAL = 0.035  # radius of a torsional spring, relative to the model
GUIDE = 0.08  # half length of a guide beyond the sliding part, relative to the model
TURNS = np.linspace(0.2, 1.0, 49)  # along a torsional spring: two turns and a half
# Deformations that are displacements along the axes of a triad.
AXES = {"along": 0, "axial": 0, "across": 1, "across1": 1, "radial1": 1, "across2": 2, "radial2": 2}
SLIDING = ("link", "bearing")  # families that measure displacements


def springs(poses: Poses) -> Iterator[Shape]:
    """Draw a coil for each spring and a dashpot for each damper on elongations, displacements and angles of joints."""
    instances = {instance.name: instance for instance in poses.structure.instances}
    angles: set[str] = set()
    controllers = {controller.name for controller in poses.structure.controllers}
    for law in poses.structure.laws:
        if law.name in controllers:
            continue
        ends = _between(poses, law, instances)
        if ends is not None:
            yield from _line(law.name, law, 0, ends)
            continue
        for i, quantity in enumerate(law.deformations):
            name, _, part = quantity.rpartition(".")
            if name in instances and any(_acts(law, i)):
                instance = instances[name]
                if instance.spec.family == "hinge" and name not in angles and part == "angle":
                    angles.add(name)
                    yield from _spiral(poses, instance)
                else:
                    yield from _spring(poses, law, i, instance)


def _acts(law: LawInstance, i: int) -> tuple[bool, bool]:
    """Whether a law is a spring and a damper for its deformation i; curves and formulas of one are springs."""
    if _is_linear(law):
        return _own(law, "S", i) > 0, _own(law, "D", i) > 0
    if "coefficients" not in law.parameters:
        return law.code is not None and len(law.deformations) == 1, False  # a formula
    stores = "stored" in law.parameters  # the energy of a spring's curve
    return stores, not stores


def _is_linear(law: LawInstance) -> bool:
    """Whether a law has a matrix of stiffness and one of damping."""
    return {"S", "D"} <= law.parameters.keys()


def _own(law: LawInstance, key: str, i: int) -> float:
    """Return stiffness or damping of a linear law for its deformation i alone.

    It is given by the upper triangle of a matrix, row by row; that of a cable in an older file, by its diagonal.
    """
    values, m = law.parameters[key], len(law.deformations)
    return float(values[i if values.size == m else i * m - i * (i - 1) // 2])


def _between(poses: Poses, law: LawInstance, instances: dict[str, Instance]) -> Array | None:
    """Return the line between two points whose difference in one coordinate a spring measures."""
    if (
        not _is_linear(law)
        or len(law.deformations) != 2
        or not all(".displacement." in name for name in law.deformations)
    ):
        return None
    points = [instances[name.rpartition(".")[0]].nodes[-1] for name in law.deformations]
    if points[0] == points[1] or any(
        not poses.structure.node(point).kind.endswith("point") for point in points
    ):
        return None
    return segment(poses.place(points[0]), poses.place(points[1]))


def _spring(poses: Poses, law: LawInstance, i: int, instance: Instance) -> Iterator[Shape]:
    """Draw the spring or damper on one deformation of an element between points."""
    name, _, part = law.deformations[i].rpartition(".")
    family = instance.spec.family
    if family == "truss" and part == "elongation":
        if section_outline(instance) is None and not _is_bar(law, i, instance):
            ends = segment(poses.place(instance.nodes[0]), poses.place(instance.nodes[-1]))
            yield from _line(name, law, i, ends, poses.stress(law.deformations[i]))
    elif family in SLIDING and part in AXES and instance.spec.reports("axes", "displacement"):
        outputs, end = poses.outputs(instance), poses.place(instance.nodes[2])
        along = triad_of(outputs)[..., AXES[part]]
        # not the deformation of the state: a displaced state of a picture has only positions
        moved = outputs["displacement"][..., AXES[part], None]
        foot = end - (LENGTH * poses.size + moved) * along
        shown = name.removesuffix(".displacement")  # a spring to the ground is named after the point
        yield from _line(shown, law, i, segment(foot, end), poses.stress(law.deformations[i]))


def _is_bar(law: LawInstance, i: int, instance: Instance) -> bool:
    """Whether a linear law is so stiff that its element is an elastic bar."""
    if not _is_linear(law) or "l0" not in instance.parameters:
        return False
    return _own(law, "S", i) * float(instance.parameters["l0"][0]) >= BAR


def _line(name: str, law: LawInstance, i: int, ends: Array, force: Array | None = None) -> Iterator[Shape]:
    """Draw a coil, a dashpot, or one within the other."""
    spring, damper = _acts(law, i)
    values = {} if force is None else {"tension": force[..., None]}
    for style, on in (("spring", spring), ("damper", damper)):
        if on:
            yield Shape(style, name, (ends,), values=values)


def _spiral(poses: Poses, instance: Instance) -> Iterator[Shape]:
    """Draw a torsional spring about the pin of a hinge, carried by its first body."""
    found = pin_place(poses, instance)
    if found is None:
        return
    centre, axis = found
    R = poses.axes(instance.nodes[0])
    carried = np.linalg.vecdot(np.swapaxes(R, -1, -2), axis[..., None, :])  # the axis in the body's axes
    u = R[..., int(np.argmin(np.max(np.abs(carried.reshape(-1, 3)), axis=0)))]
    u = u - np.linalg.vecdot(u, axis)[..., None] * axis
    u /= np.linalg.norm(u, axis=-1, keepdims=True)
    angle, r = 5 * np.pi * TURNS[:, None], SPIRAL * poses.size * TURNS[:, None]
    v = np.cross(axis, u)[..., None, :]
    line = centre[..., None, :] + r * np.cos(angle) * u[..., None, :] + r * np.sin(angle) * v
    yield Shape("spiral", instance.name, (line,), (centre, R))


def guides(poses: Poses) -> Iterator[Shape]:
    """Draw a rail and a block for points that move in one fixed direction only, and for sliding joints."""
    half = GUIDE * poses.size
    for node in poses.structure.nodes:
        if node.kind.endswith("point") and "." not in node.name and np.sum(~node.fixed) == 1:
            along = np.append(~node.fixed, False)[:3].astype(float)
            yield from _guide(node.name, poses.place(node.name), along, half)
    for instance in poses.structure.instances:
        if (slides := _slides(poses, instance)) is not None:
            at, axis = poses.place(instance.nodes[2]), triad_of(poses.outputs(instance))[..., slides]
            yield from _guide(instance.name, at, axis, half)


def _slides(poses: Poses, instance: Instance) -> int | None:
    """Return the only free displacement of a link or bearing that holds the others, if there is one."""
    if "." in instance.name or instance.spec.family not in SLIDING or not instance.spec.reports("axes"):
        return None
    parts = [deformation.name for deformation in instance.spec.deformations if deformation.name in AXES]
    free = [
        axis for axis in parts if poses.structure.index[f"{instance.name}.{axis}"] not in poses.roles.rigid
    ]
    return AXES[free[0]] if len(free) == 1 and len(parts) > 1 else None


def _guide(name: str, at: Array, axis: Array, half: float) -> Iterator[Shape]:
    """Draw a rail around a part that slides along an axis, and the block in it; motions draw one rail, full length."""
    start = axis.reshape(-1, 3)[0]  # of the first state
    across = np.cross(axis, np.eye(3)[2 if abs(start[2]) < 0.9 else 0])
    across /= np.linalg.norm(across, axis=-1, keepdims=True)
    sides, rail = segment(across, across), segment(at - half * axis, at + half * axis)
    for side in (-1, 1):
        line = rail + side * 0.3 * half * sides
        yield Shape("guide", name, (line,), outline=rectangle(0.1 * half, 0.5 * half), across=sides)
    block = segment(at - 0.3 * half * axis, at + 0.3 * half * axis)
    R = np.stack([axis, across, np.cross(axis, across)], axis=-1)
    yield Shape("slide", name, (block,), (at, R), rectangle(0.46 * half, 0.4 * half), sides)


def united(rail: Shape) -> Shape:
    """Draw the rail of a guide once for all states: as long as the travel of the sliding part."""
    ends = rail.lines[0].reshape(-1, 3)
    axis = ends[1] - ends[0]
    axis /= np.linalg.norm(axis)
    far = (ends - ends[0]) @ axis
    if np.max(np.linalg.norm(ends - ends[0] - np.outer(far, axis), axis=1)) > 1e-6 * np.ptp(far):
        return rail  # carried by a body
    line = ends[0] + np.outer([far.min(), far.max()], axis)
    return replace(rail, lines=(np.broadcast_to(line, rail.lines[0].shape),))
