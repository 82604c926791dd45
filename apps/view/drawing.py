"""Collects the geometry of a mechanism at one instant: the shapes of all its parts, for any kind of picture.

Everything is read from the structure's instances and a state; painting is done by
`flexel.apps.view.scene` (matplotlib) and `flexel.apps.view.page` (a page with a viewer).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np

from flexel.apps.view.painters import LINES, PAINTERS, declared, rolls
from flexel.apps.view.primitives import Shape, axes_of, place, turned
from flexel.apps.view.rope_painters import is_ball, sheaves
from flexel.apps.view.solids import Sketch, Solid
from flexel.apps.view.spring_painters import guides, springs
from flexel.base.arrays import Array
from flexel.base.quaternions import matrix
from flexel.model.applied_loads import Loads
from flexel.model.instances import Instance
from flexel.model.state import Geometry, State
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


def shapes(state: State, sketches: Sequence[Sketch | Solid] = ()) -> list[Shape]:
    """Return all parts of the model at a state: elements in order of declaration, then sketches, then nodes."""
    shown = [
        instance for instance in state.structure.instances if "." not in instance.name
    ]  # the others are sensors
    # a body that has a sketch or is a wheel or a ball needs no box
    outlined = {sketch.frame for sketch in sketches} | {
        instance.nodes[1] for instance in shown if rolls(instance) or is_ball(instance)
    }
    found: list[Shape] = []
    state = replace(state, evaluation=_Geometry(state.evaluation))
    for instance in shown:
        boxed = outlined.isdisjoint(instance.nodes)
        found += [part for part in _element(state, instance) if boxed or part.style != "box"]
    held = list(springs(state))
    sprung = {part.name for part in held if part.style in ("spring", "damper")}
    found = [
        part for part in found if part.style != "bar" or part.name not in sprung
    ]  # drawn as a coil instead
    found += [*held, *guides(state)]
    found += sheaves(state, (instance for instance in shown if instance.spec.family == "contact"))
    found = _dressed(found, shown)
    found += [_sketch(state, sketch) for sketch in sketches]
    for node in state.structure.nodes:
        if node.kind.endswith("point") and "." not in node.name:
            style = "fixed" if node.fixed.all() else "joint"
            found.append(Shape(style, node.name, (place(state, node.name)[None],)))
    return found


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


class _Geometry:
    """The geometry of the state in a picture, evaluated once for all parts."""

    def __init__(self, geometry: Geometry) -> None:
        self.structure = geometry.structure
        self._geometry = geometry
        self._found: tuple[Array, Array] | None = None
        self._reported: dict[int, tuple[dict[str, Array], int]] = {}

    def position(self, x: Array) -> tuple[Array, Array]:
        """Return deformations and J; see `flexel.model.state.Geometry`."""
        if self._found is None:
            self._found = self._geometry.position(x)
        return self._found

    def outputs(self, elements: Sequence[Instance], x: Array, e: Array, stresses: Array) -> dict[str, Array]:
        """Return the outputs of elements of one type; all of a type are evaluated together."""
        first = elements[0]
        if id(first) not in self._reported:
            same = [
                instance
                for instance in self.structure.instances
                if instance.spec is first.spec and instance.code is first.code
            ]
            found = self._geometry.outputs(same, x, e, stresses)
            self._reported |= {id(element): (found, i) for i, element in enumerate(same)}
        found, _ = self._reported[id(first)]
        places = [self._reported[id(element)][1] for element in elements]
        return {name: values[:, places] for name, values in found.items()}


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


def _element(state: State, instance: Instance) -> Iterator[Shape]:
    """Return the shapes of one element; none for norms and sensors; a line if a user's element lacks data."""
    word = instance.spec.picture if _complete(instance) else ""
    yield from PAINTERS[word](state, instance)
    if word not in LINES:
        yield from declared(state, instance)


def _complete(instance: Instance) -> bool:
    """Whether an element has the data that its picture shows."""
    word, spec = instance.spec.picture, instance.spec
    needed = NEEDS.get(word, set()) | (set() if spec.planar else IN_SPACE.get(word, set()))
    return needed <= instance.parameters.keys() | {output.name for output in spec.outputs}


def _sketch(state: State, sketch: Sketch | Solid) -> Shape:
    start, R = np.append(state.structure.node(sketch.point).x0, 0.0)[:3], np.eye(3)
    if sketch.frame is not None:
        x0 = state.structure.node(sketch.frame).x0
        R = axes_of(state, sketch.frame) @ (turned(float(x0[0])) if x0.size == 1 else matrix(x0)).T
    origin, name = place(state, sketch.point), sketch.frame or sketch.point
    lines = tuple(origin + (line - start) @ R.T for line in sketch.lines)
    if isinstance(sketch, Sketch):
        return Shape("sketch", name, lines, (origin, R))
    vertices, triangles = sketch.surface
    return Shape(
        "solid", name, lines, (origin, R), surface=(vertices - start, triangles), colour=sketch.colour
    )


def loads(state: State, given: Loads) -> list[Shape]:
    """Return an arrow for each point on which loads act, of one length with the forces of contacts."""
    s, nodal = state.structure, given.at(state.t)[0]
    found, loaded = [], {s.names[i] for i in given.quantities}
    for node in s.nodes:
        if node.kind.endswith("point") and loaded.intersection(node.coordinates):
            force = np.append(nodal[s.places(node.name)], 0.0)[:3]
            found.append(Shape("load", node.name, (place(state, node.name)[None],), force=force))
    return found
