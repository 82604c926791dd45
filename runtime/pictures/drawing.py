"""Geometry of a mechanism at one instant: the shapes of all its parts, for any kind of picture.

Everything is read from the structure's instances and a state; painting is done by
`flexel.pictures.scene` (matplotlib) and `flexel.pictures.view` (a page with a viewer).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np

from flexel.base.arrays import Array
from flexel.base.quaternions import matrix
from flexel.declare.looks import Look
from flexel.pictures.painters import PAINTERS, bar, rolls
from flexel.pictures.rope_painters import is_ball, sheaves
from flexel.pictures.shape import Shape, axes_of, place, turned
from flexel.pictures.solids import Sketch, Solid
from flexel.pictures.spring_painters import guides, springs
from flexel.structure.instances import Instance
from flexel.structure.loads import Loads
from flexel.structure.state import Geometry, State

__all__ = ["Shape", "Sketch", "Solid", "loads", "planar", "roads", "shapes", "upward"]
# What painters read: an element of a user may have a picture without it.  In space other triads than in the plane.
NEEDS = {
    "beam": {"l0"},
    "belt": {"radius_p", "radius_q"},
    "body": {"c", "J", "mass"},
    "disc": {"radius", "alpha0"},
    "gears": {"radius_p", "radius_q"},
    "rope": {"l0"},
    "tyre": {"radius", "axle"},
    "wheel": {"radius", "axle"},
}
IN_SPACE = {"beam": {"tp", "tq"}, "bearing": {"tp"}, "hinge": {"tp"}}
IN_PLANE = {"beam": {"alpha0", "alphaq0"}}
FAMILIES = {"beam": "beam", "rope": "cable"}  # whose forces are shown


def shapes(state: State, sketches: Sequence[Sketch | Solid] = ()) -> list[Shape]:
    """All parts of the model at a state: elements in order of declaration, then sketches, then nodes."""
    shown = [z for z in state.structure.instances if "." not in z.name]  # the others are sensors
    # a body that has a sketch or is a wheel or a ball needs no box
    outlined = {z.frame for z in sketches} | {z.nodes[1] for z in shown if rolls(z) or is_ball(z)}
    found: list[Shape] = []
    state = replace(state, evaluation=_Geometry(state.evaluation))
    for instance in shown:
        boxed = outlined.isdisjoint(instance.nodes)
        found += [z for z in _element(state, instance) if boxed or z.style != "box"]
    held = list(springs(state))
    sprung = {z.name for z in held if z.style in ("spring", "damper")}
    found = [z for z in found if z.style != "bar" or z.name not in sprung]  # a coil instead
    found += [*held, *guides(state)]
    found += sheaves(state, (z for z in shown if z.spec.family == "contact"))
    found = _dressed(found, shown)
    found += [_sketch(state, sketch) for sketch in sketches]
    for node in state.structure.nodes:
        if node.kind.endswith("point") and "." not in node.name:
            style = "fixed" if node.fixed.all() else "joint"
            found.append(Shape(style, node.name, (place(state, node.name)[None],)))
    return found


def _dressed(found: Sequence[Shape], instances: Sequence[Instance]) -> list[Shape]:
    """The shapes of elements in the colours that were said for them, without those that are hidden."""
    looks = {z.name: z.look for z in instances if isinstance(z.look, Look)}
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

    def position(self, x: Array) -> tuple[Array, Array]:
        """Deformations and J; see `flexel.structure.state.Geometry`."""
        if self._found is None:
            self._found = self._geometry.position(x)
        return self._found


def roads(state: State) -> list[tuple[Array, float]]:
    """Unit normal and height of every distinct plane on which a wheel rolls."""
    found: dict[tuple[float, ...], tuple[Array, float]] = {}
    for instance in state.structure.instances:
        if rolls(instance) and "normal" in instance.parameters:
            normal, height = instance.parameters["normal"], float(instance.parameters["height"][0])
            found[(*normal.tolist(), height)] = (np.asarray(normal, dtype=float), height)
    return list(found.values())


def upward(state: State) -> Array:
    """The direction (3,) shown as up in a picture: normal to the road, against gravity, or the z axis."""
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
    """Shapes of one element; norms and sensors have none, a user's without the numbers of its picture is a line."""
    painter = PAINTERS[instance.spec.picture] if _complete(instance) else bar
    yield from painter(state, instance)


def _complete(instance: Instance) -> bool:
    """Whether an element has what its picture shows."""
    word = instance.spec.picture
    needed = NEEDS.get(word, set()) | (IN_PLANE if instance.spec.planar else IN_SPACE).get(word, set())
    return (
        needed <= instance.parameters.keys()
        and FAMILIES.get(word, instance.spec.family) == instance.spec.family
    )


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
    """An arrow for each point on which loads act, of one length with the forces of contacts."""
    s, nodal = state.structure, given.at(state.t)[0]
    found, loaded = [], {s.names[i] for i in given.quantities}
    for node in s.nodes:
        if node.kind.endswith("point") and loaded.intersection(node.coordinates):
            force = np.append(nodal[s.places(node.name)], 0.0)[:3]
            found.append(Shape("load", node.name, (place(state, node.name)[None],), force=force))
    return found
