"""Collects the geometry of a mechanism: the shapes of all its parts in one state or in many, for any kind of picture.

Everything is read from the structure's instances and from states; painting is done by
`flexel.apps.view.scene` (matplotlib) and `flexel.apps.view.page` (a page with a viewer).
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np

from flexel.apps.view.painters import LINES, PAINTERS, body_points, declared, rolls
from flexel.apps.view.poses import Poses, axes_from
from flexel.apps.view.primitives import Shape, posed, spatial
from flexel.apps.view.rope_painters import is_ball, sheaves
from flexel.apps.view.solids import Sketch, Solid
from flexel.apps.view.spring_painters import guides, springs
from flexel.base.arrays import Array
from flexel.model.applied_loads import Loads
from flexel.model.instances import Instance
from flexel.model.state import State
from flexel.parts.looks import Look

__all__ = ["Shape", "Sketch", "Solid", "loads", "planar", "roads", "shapes", "upward"]
WHEELS = {
    f"{name}_{end}" for name in ("radius", "origin", "axes") for end in "pq"
}  # of two wheels at p and q
# What painters read, parameters and outputs: a user's element may have a picture without it.
NEEDS = {
    "bearing": {"axes"},
    "belt": WHEELS,
    "blade": {"ahead", "origin", "axes"},
    "body": {"centre", "J", "mass", "origin", "axes"},
    "contact": {"place", "force"},
    "disc": {"radius", "origin", "axes"},
    "gears": WHEELS,
    "tyre": {"radius", "axle", "origin", "axes"},
    "wheel": {"radius", "axle", "force", "origin", "axes"},
}
IN_SPACE = {"hinge": {"axes"}}


def shapes(states: State | Sequence[State], sketches: Sequence[Sketch | Solid] = ()) -> list[Shape]:
    """Return all parts of the model: elements in order of declaration, then sketches, then nodes.

    In several states of one model, the arrays of the shapes have these along their first axis; see `Shape`.
    """
    poses = Poses(states)
    nodes = poses.structure.nodes
    # the others are sensors
    shown = [instance for instance in poses.structure.instances if "." not in instance.name]
    contacts = [instance for instance in shown if instance.spec.family == "contact"]
    # a body that has a sketch or is a wheel, a ball or a sheave needs no box
    outlined = {sketch.frame for sketch in sketches}
    outlined |= {instance.nodes[1] for instance in shown if rolls(instance) or is_ball(instance)}
    outlined |= {instance.nodes[-1] for instance in contacts if "radius" in instance.parameters}
    found: list[Shape] = []
    for instance in shown:
        boxed = outlined.isdisjoint(instance.nodes)
        for part in _element(poses, instance):
            if part.style != "box":
                found.append(part)
            elif boxed:
                other = len(set(body_points(poses.structure, instance.nodes[1]))) > 1
                found.append(replace(part, aside=other))
    held = list(springs(poses))
    sprung = {part.name for part in held if part.style in ("spring", "damper")}
    found = [
        part for part in found if part.style != "bar" or part.name not in sprung
    ]  # drawn as a coil instead
    found += [*held, *guides(poses)]
    found += sheaves(poses, contacts)
    found = _dressed(found, shown)
    found += [_sketch(poses, sketch) for sketch in sketches]
    within = _within_lines(shown)
    for node in nodes:
        if node.kind.endswith("point") and "." not in node.name:
            style = "fixed" if node.fixed.all() else "joint"
            place = poses.place(node.name)[..., None, :]
            found.append(Shape(style, node.name, (place,), aside=style == "joint" and node.name in within))
    return [_in_all(part, poses.shape) for part in found]


def _within_lines(instances: Sequence[Instance]) -> set[str]:
    """Return points that two or more ropes or flexible beams share, and nothing else but what they touch."""
    lines: Counter[str] = Counter()
    others: set[str] = set()
    for instance in instances:
        if any(output.draws in ("rope", "beam") for output in instance.spec.outputs):
            lines.update(instance.nodes)
        elif instance.spec.family != "contact":
            others.update(instance.nodes)
    return {name for name, count in lines.items() if count > 1} - others


def _in_all(shape: Shape, states: tuple[int, ...]) -> Shape:
    """Give all arrays of a shape the axis of the states, along which some are constant."""

    def full(values: Array, axes: int) -> Array:
        return np.broadcast_to(values, (*states, *values.shape[values.ndim - axes :]))

    if not states:
        return shape
    return replace(
        shape,
        lines=tuple(full(line, 2) for line in shape.lines),
        pose=None if shape.pose is None else (full(shape.pose[0], 1), full(shape.pose[1], 2)),
        across=None if shape.across is None else full(shape.across, 2),
        force=None if shape.force is None else full(shape.force, 1),
        values={name: full(values, 1) for name, values in shape.values.items()},
    )


def _dressed(found: Sequence[Shape], instances: Sequence[Instance]) -> list[Shape]:
    """Give the shapes of elements their specified colours, and drop hidden ones."""
    looks = {instance.name: instance.look for instance in instances if isinstance(instance.look, Look)}
    dressed = []
    for shape in found:
        look = looks.get(shape.name)
        if look is None or shape.style == "force":
            dressed.append(shape)
        elif not look.hidden:
            opacity = 1.0 if look.opacity is None else look.opacity
            dressed.append(replace(shape, colour=look.colour, opacity=opacity))
    return dressed


def roads(state: State) -> list[tuple[Array, float]]:
    """Return unit normal and height of every distinct plane on which a wheel rolls."""
    found: dict[tuple[float, ...], tuple[Array, float]] = {}
    for instance in state.structure.instances:
        if rolls(instance) and "normal" in instance.parameters:
            normal, height = instance.parameters["normal"], float(instance.parameters["height"][0])
            found[(*normal.tolist(), height)] = (np.asarray(normal, dtype=float), height)
    return list(found.values())


def upward(state: State) -> Array:
    """Return the direction (3,) shown as up in a picture: normal to the road, against gravity, or the z axis."""
    for normal, _ in roads(state):
        return normal
    for instance in state.structure.instances:
        gravity = instance.parameters.get("gravity")
        if gravity is not None and gravity.size == 3 and np.any(gravity):
            return np.asarray(-gravity / np.linalg.norm(gravity))
    return np.array([0.0, 0.0, 1.0])


def planar(state: State) -> bool:
    """Whether the model has planar nodes only."""
    return all(node.kind.startswith("planar") for node in state.structure.nodes)


def _element(poses: Poses, instance: Instance) -> Iterator[Shape]:
    """Return the shapes of one element; none for norms and sensors; a line if a user's element lacks data."""
    word = instance.spec.picture if _complete(instance) else ""
    yield from PAINTERS[word](poses, instance)
    if word not in LINES:
        yield from declared(poses, instance)


def _complete(instance: Instance) -> bool:
    """Whether an element has the data that its picture shows."""
    word, spec = instance.spec.picture, instance.spec
    needed = NEEDS.get(word, set()) | (set() if spec.planar else IN_SPACE.get(word, set()))
    return needed <= instance.parameters.keys() | {output.name for output in spec.outputs}


def _sketch(poses: Poses, sketch: Sketch | Solid) -> Shape:
    start, R = spatial(poses.structure.node(sketch.point).x0), np.eye(3)
    if sketch.frame is not None:
        R = poses.axes(sketch.frame) @ axes_from(poses.structure.node(sketch.frame).x0).T
    pose, name = (poses.place(sketch.point), R), sketch.frame or sketch.point
    lines = tuple(posed(line - start, pose) for line in sketch.lines)
    if isinstance(sketch, Sketch):
        return Shape("sketch", name, lines, pose)
    vertices, triangles = sketch.surface
    return Shape("solid", name, lines, pose, surface=(vertices - start, triangles), colour=sketch.colour)


def loads(states: Sequence[State], given: Loads) -> list[Shape]:
    """Return an arrow for each point on which loads act, of one length with the forces of contacts."""
    poses, s = Poses(states), states[0].structure
    nodal = np.array([given.at(state.t)[0] for state in states])
    found, loaded = [], {s.names[i] for i in given.quantities}
    for node in s.nodes:
        if node.kind.endswith("point") and loaded.intersection(node.coordinates):
            force = spatial(nodal[:, s.places(node.name)])
            found.append(Shape("load", node.name, (poses.place(node.name)[..., None, :],), force=force))
    return found
