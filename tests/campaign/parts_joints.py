"""Bars, hinges, bearings, gears and relations."""

import numpy as np

from campaign.algebra import (
    about,
    across,
    conjugate,
    dot,
    norm,
    product,
    rotated,
    turned,
)
from campaign.parts import Drawing, Measure, handler
from campaign.parts_bodies import Bar, held_in_body
from flexel.base.arrays import Array
from flexel.parts.couplings import PlanarGear
from flexel.parts.joints import Bearing, Hinge, Truss
from flexel.parts.relations import Relation

X = np.array([1.0, 0.0, 0.0])


@handler(Truss, options="mass_per_length")
def _truss(drawing: Drawing, part: Truss) -> None:
    name, p, q = part.name, str(part.p), str(part.q)
    length = float(np.linalg.norm(drawing.x(q) - drawing.x(p)))

    def elongation(x: Array) -> Array:
        a, b = np.split(x, 2)
        return norm(b - a) - length

    drawing.measure(f"{name}.elongation", (p, q), elongation, True)
    if mass := part.mass_per_length * length:
        drawing.twins.append(Bar((p, q), mass, drawing.gravity))


def aligned(axis: Array) -> Array:
    """Euler parameters of a turn that brings x to the axis."""
    e = np.asarray(axis, float) / np.linalg.norm(axis)
    if abs(e[0]) > 1 - 1e-9:
        return np.array([1.0, 0, 0, 0]) if e[0] > 0 else about(np.array([0.0, 0, 1]), np.pi)
    return about(np.cross(X, e), float(np.arccos(e[0])))


def _in_frame(drawing: Drawing, frame: str, turn: Array) -> Array:
    """A turn seen from a frame as drawn."""
    return product(conjugate(drawing.x(frame)), turn)


def hinged(drawing: Drawing, name: str, p: str, q: str, axis: Array) -> None:
    """The angle between two frames about an axis (free), and the two conditions that hold it."""
    turn = aligned(axis)
    tp, tq = _in_frame(drawing, p, turn), _in_frame(drawing, q, turn)
    first, second = (rotated(conjugate(turn), direction) for direction in across(axis))

    def angle(x: Array) -> Array:
        c = product(conjugate(_by(x[:4], tp)), _by(x[4:], tq))
        return 2 * np.arctan(c[1] / c[0])

    def tilt(x: Array, side: Array) -> Array:
        return dot(rotated(_by(x[:4], tp), side), rotated(_by(x[4:], tq), X))

    drawing.measure(f"{name}.angle", (p, q), angle, False)
    drawing.measure(f"{name}.#1", (p, q), lambda x: tilt(x, first), True)
    drawing.measure(f"{name}.#2", (p, q), lambda x: tilt(x, second), True)


def _by(lam: Array, turn: Array) -> Array:
    """λ o turn; the turn is constant."""
    return product(lam, turn.reshape(4, *(1,) * (np.ndim(lam) - 1)))


@handler(Hinge, options="axis")
def _hinge(drawing: Drawing, part: Hinge) -> None:
    name, p, q = part.name, str(part.p), str(part.q)
    if len(drawing.gravity) == 2:
        drawn = drawing.x(p, q)
        drawing.measure(f"{name}.angle", (p, q), lambda x: x[1] - x[0] - (drawn[1] - drawn[0]), False)
    else:
        hinged(drawing, name, p, q, np.array(part.axis))


@handler(Bearing, options="axis")
def _bearing(drawing: Drawing, part: Bearing) -> None:
    name, p, rp, q, rq = part.name, *map(str, (part.p, part.rp, part.q, part.rq))
    if len(drawing.gravity) == 2:
        held_in_body(drawing, name, p, rp, q)
        drawn = drawing.x(rp, rq)
        drawing.measure(f"{name}.angle", (rp, rq), lambda x: x[1] - x[0] - (drawn[1] - drawn[0]), False)
        return
    axis = np.array(part.axis, float)
    hinged(drawing, name, rp, rq, axis)
    sides = zip(("axial", "#3", "#4"), (axis / np.linalg.norm(axis), *across(axis)), strict=True)
    for what, side in sides:
        e = rotated(conjugate(drawing.x(rp)), side)
        start = float(side @ (drawing.x(q) - drawing.x(p)))

        def distance(x: Array, e: Array = e, start: float = start) -> Array:
            return dot(rotated(x[3:7], e), x[7:] - x[:3]) - start

        drawing.measure(f"{name}.{what}", (p, rp, q), distance, True)


@handler(PlanarGear)
def _gear(drawing: Drawing, part: PlanarGear) -> None:
    a, b = part.radius_p, part.radius_q
    nodes = (str(part.p), str(part.angle_p), str(part.q), str(part.angle_q))
    drawn = drawing.x(*nodes)
    d0 = drawn[3:5] - drawn[:2]

    def slip(x: Array) -> Array:
        """Path of one pitch circle on the other: the line of centres turns by the angle of its tangent."""
        d = turned(-np.arctan2(d0[1], d0[0]), x[3:5] - x[:2])
        line = np.arctan(d[1] / d[0])
        return a * (x[2] - drawn[2] - line) + b * (x[5] - drawn[5] - line)

    drawing.measure(f"{part.name}.mesh", nodes, slip, True)


@handler(Relation)
def _relation(drawing: Drawing, part: Relation) -> None:
    name, terms = part.name, part.terms
    found = [(drawing.measured(term), c) for term, c in terms.items()]
    nodes = tuple(dict.fromkeys(n for measure, _ in found for n in measure.nodes))
    ends = np.cumsum([drawing.x(n).size for n in nodes])
    rows = {n: np.arange(end - drawing.x(n).size, end) for n, end in zip(nodes, ends, strict=True)}
    parts = [(measure.value, c, np.concatenate([rows[n] for n in measure.nodes])) for measure, c in found]
    drawn = drawing.x(*nodes)

    def total(x: Array) -> Array:
        return np.asarray(sum(c * value(x[own]) for value, c, own in parts))

    start = float(total(drawn))
    drawing.free(*terms)
    drawing.measures[f"{name}.relation"] = Measure(
        f"{name}.relation", nodes, lambda x: total(x) - start, True
    )
