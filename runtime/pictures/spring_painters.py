"""Shapes of what holds a model to itself and to the ground: springs, dampers, guides."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from flexel.base.arrays import Array
from flexel.base.quaternions import matrix, product
from flexel.pictures.painters import pin_place
from flexel.pictures.shape import Shape, axes_of, extent, place, rectangle, section_outline, turned
from flexel.structure.instances import Instance, LawInstance
from flexel.structure.state import State

BAR = 1e6  # [N] stiffness times length from which a truss is drawn as an elastic bar, not as a coil
LENGTH = 0.12  # of a spring that holds a displacement, relative to the model
SPIRAL = 0.035  # radius of a torsional spring, relative to the model
GUIDE = 0.08  # half length of a guide beside what slides in it, relative to the model
TURNS = np.linspace(0.2, 1.0, 49)  # along a torsional spring: two turns and a half
# Deformations that are displacements along the axes of a triad.
AXES = {"along": 0, "axial": 0, "across": 1, "across1": 1, "radial1": 1, "across2": 2, "radial2": 2}
SLIDING = ("link", "bearing")  # families that measure them


def springs(state: State) -> Iterator[Shape]:
    """A coil for each spring and a dashpot for each damper on elongations, displacements and angles of joints."""
    instances = {z.name: z for z in state.structure.instances}
    angles: set[str] = set()
    controllers = {z.name for z in state.structure.controllers}
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
    """Whether a law has a stiffness and a damping, in full or by their diagonals."""
    return {"S", "D"} <= law.parameters.keys()


def _own(law: LawInstance, key: str, i: int) -> float:
    """Stiffness or damping of a linear law for its deformation i alone.

    It is given by the diagonal of a matrix, or by its upper triangle, row by row.
    """
    z, m = law.parameters[key], len(law.deformations)
    return float(z[i if z.size == m else i * m - i * (i - 1) // 2])


def _between(state: State, law: LawInstance, instances: dict[str, Instance]) -> tuple[Array, Array] | None:
    """Places of two points whose difference in one coordinate a spring measures."""
    if (
        not _is_linear(law)
        or len(law.deformations) != 2
        or not all(".displacement." in z for z in law.deformations)
    ):
        return None
    points = [instances[z.rpartition(".")[0]].nodes[-1] for z in law.deformations]
    if points[0] == points[1] or any(not state.structure.node(z).kind.endswith("point") for z in points):
        return None
    return place(state, points[0]), place(state, points[1])


def _spring(state: State, law: LawInstance, i: int, instance: Instance) -> Iterator[Shape]:
    """The spring or damper on one deformation of an element between points."""
    name, _, part = law.deformations[i].rpartition(".")
    family = instance.spec.family
    if family == "truss" and part == "elongation":
        if section_outline(instance) is None and not _is_bar(law, i, instance):
            ends = place(state, instance.nodes[0]), place(state, instance.nodes[-1])
            yield from _line(name, law, i, ends, state.force(law.deformations[i]))
    elif family in SLIDING and part in AXES:
        along = _triad(state, instance)[:, AXES[part]]
        start, end = (place(state, z) for z in (instance.nodes[0], instance.nodes[2]))
        # by the places, not by the deformation: a displaced state of a picture has only these
        d0 = float(np.append(instance.parameters["d0"], 0.0)[AXES[part]])
        foot = end - (LENGTH * extent(state.structure) + (end - start) @ along - d0) * along
        shown = name.removesuffix(".displacement")  # a spring to the ground is the point's
        yield from _line(shown, law, i, (foot, end), state.force(law.deformations[i]))


def _is_bar(law: LawInstance, i: int, instance: Instance) -> bool:
    """Whether a linear law is so stiff that its element is an elastic bar."""
    if not _is_linear(law) or "l0" not in instance.parameters:
        return False
    return _own(law, "S", i) * float(instance.parameters["l0"][0]) >= BAR


def _line(
    name: str, law: LawInstance, i: int, ends: tuple[Array, Array], force: float | None = None
) -> Iterator[Shape]:
    """A coil, a dashpot, or one within the other."""
    spring, damper = _acts(law, i)
    values = {} if force is None else {"tension": np.array([force])}
    for style, on in (("spring", spring), ("damper", damper)):
        if on:
            yield Shape(style, name, (np.array(ends),), values=values)


def _triad(state: State, instance: Instance) -> Array:
    """Axes (3, 3) in which a link or bearing measures its displacements."""
    z, frame = instance.parameters, state.position(instance.nodes[1])
    if "tp" in z:
        return matrix(product(frame, z["tp"]))
    return turned(float(frame[0]) + float(z["alpha0"][0]))


def _spiral(state: State, instance: Instance) -> Iterator[Shape]:
    """A torsional spring about the pin of a hinge, carried by its first body."""
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
    """A rail and a block for points that move in one fixed direction only, and for joints that slide."""
    half = GUIDE * extent(state.structure)
    for node in state.structure.nodes:
        if node.kind.endswith("point") and "." not in node.name and np.sum(~node.fixed) == 1:
            along = np.append(~node.fixed, False)[:3].astype(float)
            yield from _guide(node.name, place(state, node.name), along, half)
    for instance in state.structure.instances:
        if (slides := _slides(state, instance)) is not None:
            at, axis = place(state, instance.nodes[2]), _triad(state, instance)[:, slides]
            yield from _guide(instance.name, at, axis, half)


def _slides(state: State, instance: Instance) -> int | None:
    """The only free displacement of a link or bearing that holds the others, if there is one."""
    if "." in instance.name or instance.spec.family not in SLIDING:
        return None
    parts = [z.name for z in instance.spec.deformations if z.name in AXES]
    free = [z for z in parts if state.structure.index[f"{instance.name}.{z}"] not in state.roles.rigid]
    return AXES[free[0]] if len(free) == 1 and len(parts) > 1 else None


def _guide(name: str, at: Array, axis: Array, half: float) -> Iterator[Shape]:
    """A rail around what slides along an axis, and the block in it; pictures of motions draw the rail once, as long."""
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
    """The rail of a guide over all frames: as long as what slides in it goes."""
    ends = np.vstack([z.lines[0] for z in column])
    axis = column[0].lines[0][1] - column[0].lines[0][0]
    axis /= np.linalg.norm(axis)
    far = (ends - ends[0]) @ axis
    if np.max(np.linalg.norm(ends - ends[0] - np.outer(far, axis), axis=1)) > 1e-6 * np.ptp(far):
        return column  # carried by a body
    line = ends[0] + np.outer([far.min(), far.max()], axis)
    return [replace(z, lines=(line,)) for z in column]
