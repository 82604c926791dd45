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
from flexel.pictures.painters import PAINTERS, rolls
from flexel.pictures.rope_painters import is_ball, sheaves
from flexel.pictures.shape import Shape, Sketch, axes_of, place, turned
from flexel.structure.instances import Instance
from flexel.structure.state import Geometry, State

__all__ = ["Shape", "Sketch", "planar", "roads", "shapes", "upward"]


def shapes(state: State, sketches: Sequence[Sketch] = ()) -> list[Shape]:
    """All parts of the model at a state: elements in order of declaration, then sketches, then nodes."""
    shown = [z for z in state.structure.instances if "." not in z.name]  # the others are sensors
    # a body that has a sketch or is a wheel or a ball needs no box
    outlined = {z.frame for z in sketches} | {z.nodes[1] for z in shown if rolls(z) or is_ball(z)}
    found: list[Shape] = []
    state = replace(state, evaluation=_Geometry(state.evaluation))
    for instance in shown:
        boxed = outlined.isdisjoint(instance.nodes)
        found += [z for z in _element(state, instance) if boxed or z.style != "box"]
    found += sheaves(state, (z for z in shown if z.spec.family == "contact"))
    found += [_sketch(state, sketch) for sketch in sketches]
    for node in state.structure.nodes:
        if node.kind.endswith("point") and "." not in node.name:
            style = "fixed" if node.fixed.all() else "joint"
            found.append(Shape(style, node.name, (place(state, node.name)[None],)))
    return found


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
    """Shapes of one element; norms and sensors have none."""
    yield from PAINTERS[instance.spec.picture](state, instance)


def _sketch(state: State, sketch: Sketch) -> Shape:
    structure = state.structure
    point, frame = structure.node(sketch.point), structure.node(sketch.frame)
    start = turned(float(frame.x0[0])) if frame.kind == "planar_angle" else matrix(frame.x0)
    turn = axes_of(state, frame.name) @ start.T
    arms = np.asarray(sketch.drawn, dtype=float) - np.append(point.x0, 0.0)[:3]
    origin = place(state, point.name)
    return Shape("sketch", sketch.frame, (origin + arms @ turn.T,), (origin, turn))
