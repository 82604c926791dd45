"""Draws springs, dampers and guides, between parts of a model and to the ground."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from flexel.apps.view.painters import pin_place
from flexel.apps.view.primitives import (
    Shape,
    axes_of,
    extent,
    place,
    rectangle,
    reported,
    reports,
    section_outline,
    triad_of,
)
from flexel.base.arrays import Array
from flexel.model.instances import Instance, LawInstance
from flexel.model.state import State

BAR = 1e6  # [N] stiffness times length from which a truss is drawn as an elastic bar, not as a coil
LENGTH = 0.12  # of a spring on a displacement, relative to the model
SPIRAL = 0.035  # radius of a torsional spring, relative to the model
GUIDE = 0.08  # half length of a guide beyond the sliding part, relative to the model
TURNS = np.linspace(0.2, 1.0, 49)  # along a torsional spring: two turns and a half
# Deformations that are displacements along the axes of a triad.
AXES = {"along": 0, "axial": 0, "across": 1, "across1": 1, "radial1": 1, "across2": 2, "radial2": 2}
SLIDING = ("link", "bearing")  # families that measure displacements


def springs(state: State) -> Iterator[Shape]:
    """Draw a coil for each spring and a dashpot for each damper on elongations, displacements and angles of joints."""
    instances = {instance.name: instance for instance in state.structure.instances}
    angles: set[str] = set()
    controllers = {controller.name for controller in state.structure.controllers}
    for law in state.structure.laws:
        if law.name in controllers:
            continue
        ends = _between(state, law, instances)
        if ends is not None:
            yield from _line(law.name, law, 0, ends)
            continue
        for i, quantity in enumerate(law.deformations):
            name, _, part = quantity.rpartition(".")
            if name in instances and any(_acts(law, i)):
                instance = instances[name]
                if instance.spec.family == "hinge" and name not in angles and part == "angle":
                    angles.add(name)
                    yield from _spiral(state, instance)
                else:
                    yield from _spring(state, law, i, instance)


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


def _between(state: State, law: LawInstance, instances: dict[str, Instance]) -> tuple[Array, Array] | None:
    """Return positions of two points whose difference in one coordinate a spring measures."""
    if (
        not _is_linear(law)
        or len(law.deformations) != 2
        or not all(".displacement." in name for name in law.deformations)
    ):
        return None
    points = [instances[name.rpartition(".")[0]].nodes[-1] for name in law.deformations]
    if points[0] == points[1] or any(
        not state.structure.node(point).kind.endswith("point") for point in points
    ):
        return None
    return place(state, points[0]), place(state, points[1])


def _spring(state: State, law: LawInstance, i: int, instance: Instance) -> Iterator[Shape]:
    """Draw the spring or damper on one deformation of an element between points."""
    name, _, part = law.deformations[i].rpartition(".")
    family = instance.spec.family
    if family == "truss" and part == "elongation":
        if section_outline(instance) is None and not _is_bar(law, i, instance):
            ends = place(state, instance.nodes[0]), place(state, instance.nodes[-1])
            yield from _line(name, law, i, ends, state.force(law.deformations[i]))
    elif family in SLIDING and part in AXES and reports(instance, "axes", "displacement"):
        outputs, end = reported(state, instance), place(state, instance.nodes[2])
        along = triad_of(outputs)[:, AXES[part]]
        # not the deformation of the state: a displaced state of a picture has only positions
        moved = float(outputs["displacement"][AXES[part]])
        foot = end - (LENGTH * extent(state.structure) + moved) * along
        shown = name.removesuffix(".displacement")  # a spring to the ground is named after the point
        yield from _line(shown, law, i, (foot, end), state.force(law.deformations[i]))


def _is_bar(law: LawInstance, i: int, instance: Instance) -> bool:
    """Whether a linear law is so stiff that its element is an elastic bar."""
    if not _is_linear(law) or "l0" not in instance.parameters:
        return False
    return _own(law, "S", i) * float(instance.parameters["l0"][0]) >= BAR


def _line(
    name: str, law: LawInstance, i: int, ends: tuple[Array, Array], force: float | None = None
) -> Iterator[Shape]:
    """Draw a coil, a dashpot, or one within the other."""
    spring, damper = _acts(law, i)
    values = {} if force is None else {"tension": np.array([force])}
    for style, on in (("spring", spring), ("damper", damper)):
        if on:
            yield Shape(style, name, (np.array(ends),), values=values)


def _spiral(state: State, instance: Instance) -> Iterator[Shape]:
    """Draw a torsional spring about the pin of a hinge, carried by its first body."""
    found = pin_place(state, instance)
    if found is None:
        return
    centre, axis = found
    R = axes_of(state, instance.nodes[0])
    u = R[:, int(np.argmin(np.abs(R.T @ axis)))]
    u = u - (u @ axis) * axis
    u /= np.linalg.norm(u)
    angle, r = 5 * np.pi * TURNS, SPIRAL * extent(state.structure) * TURNS
    line = centre + np.outer(r * np.cos(angle), u) + np.outer(r * np.sin(angle), np.cross(axis, u))
    yield Shape("spiral", instance.name, (line,), (centre, R))


def guides(state: State) -> Iterator[Shape]:
    """Draw a rail and a block for points that move in one fixed direction only, and for sliding joints."""
    half = GUIDE * extent(state.structure)
    for node in state.structure.nodes:
        if node.kind.endswith("point") and "." not in node.name and np.sum(~node.fixed) == 1:
            along = np.append(~node.fixed, False)[:3].astype(float)
            yield from _guide(node.name, place(state, node.name), along, half)
    for instance in state.structure.instances:
        if (slides := _slides(state, instance)) is not None:
            at, axis = place(state, instance.nodes[2]), triad_of(reported(state, instance))[:, slides]
            yield from _guide(instance.name, at, axis, half)


def _slides(state: State, instance: Instance) -> int | None:
    """Return the only free displacement of a link or bearing that holds the others, if there is one."""
    if "." in instance.name or instance.spec.family not in SLIDING or not reports(instance, "axes"):
        return None
    parts = [deformation.name for deformation in instance.spec.deformations if deformation.name in AXES]
    free = [
        axis for axis in parts if state.structure.index[f"{instance.name}.{axis}"] not in state.roles.rigid
    ]
    return AXES[free[0]] if len(free) == 1 and len(parts) > 1 else None


def _guide(name: str, at: Array, axis: Array, half: float) -> Iterator[Shape]:
    """Draw a rail around a part that slides along an axis, and the block in it; motions draw one rail, full length."""
    across = np.cross(axis, np.eye(3)[2 if abs(axis[2]) < 0.9 else 0])
    across /= np.linalg.norm(across)
    sides = np.array([across, across])
    for side in (-1, 1):
        line = np.array([at - half * axis, at + half * axis]) + side * 0.3 * half * across
        yield Shape("guide", name, (line,), outline=rectangle(0.1 * half, 0.5 * half), across=sides)
    block = np.array([at - 0.3 * half * axis, at + 0.3 * half * axis])
    R = np.column_stack([axis, across, np.cross(axis, across)])
    yield Shape("slide", name, (block,), (at, R), rectangle(0.46 * half, 0.4 * half), sides)


def united(column: list[Shape]) -> list[Shape]:
    """Draw the rail of a guide over all frames: as long as the travel of the sliding part."""
    ends = np.vstack([part.lines[0] for part in column])
    axis = column[0].lines[0][1] - column[0].lines[0][0]
    axis /= np.linalg.norm(axis)
    far = (ends - ends[0]) @ axis
    if np.max(np.linalg.norm(ends - ends[0] - np.outer(far, axis), axis=1)) > 1e-6 * np.ptp(far):
        return column  # carried by a body
    line = ends[0] + np.outer([far.min(), far.max()], axis)
    return [replace(part, lines=(line,)) for part in column]
