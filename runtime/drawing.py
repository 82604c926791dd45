"""What a mechanism looks like at one instant: polylines and marks in global axes, for any kind of picture.

Everything is read from the structure's instances and a state; how it is painted is the business of
`flexel.scene`.  Imports numpy and the runtime rooms of structure, state and orientation.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from flexel.orientation import conjugate, matrix, product
from flexel.state import State
from flexel.structure import Array, Instance

SPOKES = 8
RIM = np.linspace(0, 2 * np.pi, 49)


@dataclass(frozen=True)
class Shape:
    """Lines and marks of one part, to be painted in one style.

    Attributes
    ----------
    style : str
        bar, beam, rim, spoke, valve, axle, mass, joint, fixed or sketch.
    name : str
        Name of the element or node.
    lines : tuple of ndarray (k, 3)
        Polylines in global axes [m]; a mark is a polyline of one point.
    """

    style: str
    name: str
    lines: tuple[Array, ...]


@dataclass(frozen=True)
class Sketch:
    """A polyline that a body carries, only to be seen: it has no part in the mechanics.

    Parameters
    ----------
    point, frame : str
        Nodes of the body.
    drawn : sequence of (x, y, z)
        Vertices in global axes, as the model is drawn (before it moves) [m].
    """

    point: str
    frame: str
    drawn: Sequence[Sequence[float]]


def shapes(state: State, sketches: Sequence[Sketch] = ()) -> list[Shape]:
    """All parts of the model at a state, elements in their order, then sketches, then the nodes."""
    shown = [z for z in state.structure.instances if "." not in z.name]  # the others only measure
    found = [shape for instance in shown for shape in _element(state, instance)]
    found += [_sketch(state, sketch) for sketch in sketches]
    for node in state.structure.nodes:
        if node.kind.endswith("point") and "." not in node.name:
            style = "fixed" if node.fixed.all() else "joint"
            found.append(Shape(style, node.name, (_place(state, node.name)[None],)))
    return found


def roads(state: State) -> list[tuple[Array, float]]:
    """Unit normal and height of every plane on which a wheel rolls, each once."""
    found: dict[tuple[float, ...], tuple[Array, float]] = {}
    for instance in state.structure.instances:
        if "normal" in instance.parameters:
            normal, height = instance.parameters["normal"], float(instance.parameters["height"][0])
            found[(*normal.tolist(), height)] = (np.asarray(normal, dtype=float), height)
    return list(found.values())


def upward(state: State) -> Array:
    """The direction (3,) that a picture shows as up: normal to the road, against gravity, or the z axis."""
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
    """Shapes of one element; hinges, norms and sensors have none."""
    kind = instance.spec.name.removesuffix("_first_order")
    if kind in PAINTERS:
        yield from PAINTERS[kind](state, instance)
    elif not kind.startswith("planar_hinge"):
        ends = [n for n in instance.nodes if state.structure.node(n).kind.endswith("point")]
        if len(ends) > 1:  # a user's own element: the line through its points
            yield Shape("bar", instance.name, (np.array([_place(state, n) for n in ends]),))


def _bar(state: State, instance: Instance) -> Iterator[Shape]:
    ends = [n for n in instance.nodes if state.structure.node(n).kind.endswith("point")]
    yield Shape("bar", instance.name, (np.array([_place(state, n) for n in ends]),))


def _beam(state: State, instance: Instance) -> Iterator[Shape]:
    """The axis of a beam as the cubic through its end points and end directions."""
    p, rp, q, rq = instance.nodes
    l0 = float(instance.parameters["l0"][0])
    if instance.spec.name.startswith("planar"):
        starts = [float(instance.parameters[a][0]) for a in ("alpha0", "alphaq0")]
        turns = [float(state.position(r)[0]) + a for r, a in zip((rp, rq), starts, strict=True)]
        slopes = [l0 * np.array([np.cos(a), np.sin(a), 0.0]) for a in turns]
    else:
        triads = [product(state.position(r), instance.parameters[t]) for r, t in ((rp, "tp"), (rq, "tq"))]
        slopes = [l0 * matrix(t)[:, 0] for t in triads]
    yield Shape("beam", instance.name, (_cubic(state, p, q, slopes),))


def _cable(state: State, instance: Instance) -> Iterator[Shape]:
    """A cable as the cubic through its end points with its end slopes."""
    p, dp, q, dq = instance.nodes
    l0 = float(instance.parameters["l0"][0])
    yield Shape("beam", instance.name, (_cubic(state, p, q, [l0 * _place(state, d) for d in (dp, dq)]),))


def _cubic(state: State, p: str, q: str, slopes: Sequence[Array]) -> Array:
    """Polyline (17, 3) along the cubic between two points with the given derivatives by the fraction of the length."""
    xi = np.linspace(0, 1, 17)[:, None]
    line = (1 - 3 * xi**2 + 2 * xi**3) * _place(state, p) + (3 * xi**2 - 2 * xi**3) * _place(state, q)
    return np.asarray(line + (xi - 2 * xi**2 + xi**3) * slopes[0] + (xi**3 - xi**2) * slopes[1])


def _wheel(state: State, instance: Instance) -> Iterator[Shape]:
    """Rim, spokes, axle, and one spoke of its own style (the valve) that shows the turning."""
    hub, frame = instance.nodes[:2]
    centre, R = _place(state, hub), matrix(state.position(frame))
    radius, axle = float(instance.parameters["radius"][0]), instance.parameters["axle"]
    first = np.cross(axle, np.eye(3)[int(np.argmin(np.abs(axle)))])
    first /= np.linalg.norm(first)
    across = np.column_stack([first, np.cross(axle, first)])

    def circle(angles: Array) -> Array:
        return np.asarray(centre + radius * (R @ across @ np.array([np.cos(angles), np.sin(angles)])).T)

    yield Shape("rim", instance.name, (circle(RIM),))
    tips = circle(np.arange(SPOKES) * 2 * np.pi / SPOKES)
    yield Shape("spoke", instance.name, tuple(np.array([centre, tip]) for tip in tips[1:]))
    yield Shape("valve", instance.name, (np.array([centre, tips[0]]),))
    half = 0.15 * radius * (R @ axle)
    yield Shape("axle", instance.name, (np.array([centre - half, centre + half]),))


def _body(state: State, instance: Instance) -> Iterator[Shape]:
    """The mass centre, with a thin line to the point that carries the body."""
    p, r = instance.nodes
    c = instance.parameters["c"]
    start = _place(state, p)
    if instance.spec.name.startswith("planar"):
        a = float(state.position(r)[0])
        arm = np.array([np.cos(a) * c[0] - np.sin(a) * c[1], np.sin(a) * c[0] + np.cos(a) * c[1], 0.0])
    else:
        arm = matrix(state.position(r)) @ c
    yield Shape("mass", instance.name, ((start + arm)[None],))
    if np.any(c):
        yield Shape("spoke", instance.name, (np.array([start, start + arm]),))


def _mass(state: State, instance: Instance) -> Iterator[Shape]:
    yield Shape("mass", instance.name, (_place(state, instance.nodes[0])[None],))


PAINTERS: dict[str, Callable[[State, Instance], Iterator[Shape]]] = {
    "truss": _bar,
    "planar_truss": _bar,
    "beam3": _bar,
    "planar_beam3": _bar,
    "bearing": _bar,
    "beam": _beam,
    "planar_beam": _beam,
    "cable": _cable,
    "planar_cable": _cable,
    "wheel": _wheel,
    "toroidal_wheel": _wheel,
    "tyre": _wheel,
    "tyre_on_road": _wheel,
    "body": _body,
    "planar_body": _body,
    "point_mass": _mass,
    "planar_point_mass": _mass,
}


def _sketch(state: State, sketch: Sketch) -> Shape:
    structure = state.structure
    point, frame = structure.node(sketch.point), structure.node(sketch.frame)
    turn = matrix(product(state.position(frame.name), conjugate(frame.x0)))
    arms = np.asarray(sketch.drawn, dtype=float) - point.x0
    return Shape("sketch", sketch.frame, (_place(state, point.name) + arms @ turn.T,))


def _place(state: State, node: str) -> Array:
    """Place (3,) of a point (or direction of a slope); planar points lie in z = 0."""
    x = state.position(node)
    return np.append(x, 0.0) if x.size == 2 else x
