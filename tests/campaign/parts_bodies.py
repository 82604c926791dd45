"""Bodies, masses and rigid bars."""

from typing import Any

import numpy as np

from campaign.algebra import body_rate, dot, rotated, rotated_rate, turned
from campaign.parts import Drawing, handler
from campaign.twin import Twin
from flexel.base.arrays import Array
from flexel.parts import bodies, couplings, joints


class PointMass(Twin):
    """A mass at a point."""

    def __init__(self, node: str, mass: float, gravity: Array) -> None:
        self.nodes, self.mass, self.gravity = (node,), mass, gravity

    def kinetic(self, x: Array, v: Array) -> Array:
        return self.mass * dot(v, v) / 2

    def potential(self, x: Array) -> Array:
        return -self.mass * dot(self.gravity, x)


class Body(Twin):
    """A body in space: a point and a frame."""

    def __init__(self, nodes: tuple[str, str], mass: float, J: Array, offset: Array, gravity: Array) -> None:
        self.nodes, self.mass, self.J, self.offset, self.gravity = nodes, mass, J, offset, gravity

    def kinetic(self, x: Array, v: Array) -> Array:
        centre = v[:3] + rotated_rate(x[3:], v[3:], self.offset)
        w = body_rate(x[3:], v[3:])
        return (self.mass * dot(centre, centre) + dot(w, np.tensordot(self.J, w, 1))) / 2

    def potential(self, x: Array) -> Array:
        return -self.mass * dot(self.gravity, x[:3] + rotated(x[3:], self.offset))


class PlanarBody(Twin):
    """A body in the plane: a point and an angle."""

    def __init__(self, nodes: tuple[str, str], mass: float, J: float, offset: Array, gravity: Array) -> None:
        self.nodes, self.mass, self.J, self.offset, self.gravity = nodes, mass, J, offset, gravity

    def kinetic(self, x: Array, v: Array) -> Array:
        arm = turned(x[2], self.offset)
        centre = v[:2] + np.array([-arm[1], arm[0]]) * v[2]
        return (self.mass * dot(centre, centre) + self.J * v[2] ** 2) / 2

    def potential(self, x: Array) -> Array:
        return -self.mass * dot(self.gravity, x[:2] + turned(x[2], self.offset))


class Rotor(Twin):
    """Rotary inertia of a frame or an angle."""

    def __init__(self, node: str, J: Array) -> None:
        self.nodes, self.J = (node,), J

    def kinetic(self, x: Array, v: Array) -> Array:
        w = body_rate(x, v) if len(x) == 4 else v
        return dot(w, np.tensordot(self.J, w, 1)) / 2


class Bar(Twin):
    """The mass of a straight uniform bar: its points move linearly between its ends."""

    def __init__(self, nodes: tuple[str, str], mass: float, gravity: Array) -> None:
        self.nodes, self.mass, self.gravity = nodes, mass, gravity

    def kinetic(self, x: Array, v: Array) -> Array:
        p, q = np.split(v, 2)
        middle = (p + q) / 2
        return self.mass * (dot(p, p) + 4 * dot(middle, middle) + dot(q, q)) / 12  # Simpson's rule is exact

    def potential(self, x: Array) -> Array:
        p, q = np.split(x, 2)
        return -self.mass * dot(self.gravity, p + q) / 2


def tensor(given: Any) -> Array:
    """An inertia tensor (3, 3) from three or six numbers; one number gives (1, 1)."""
    J = np.atleast_1d(np.array(given, float))
    if J.size <= 3:
        return np.diag(J)
    xx, yy, zz, xy, xz, yz = J
    return np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])


@handler(bodies.PointMass)
def _point_mass(drawing: Drawing, part: bodies.PointMass) -> None:
    drawing.twins.append(PointMass(str(part.point), part.mass, drawing.gravity))


@handler(couplings.RotaryInertia)
def _rotary_inertia(drawing: Drawing, part: couplings.RotaryInertia) -> None:
    drawing.twins.append(Rotor(str(part.frame), tensor(part.inertia)))


@handler(bodies.Body, options="offset")
def _body(drawing: Drawing, part: bodies.Body) -> None:
    J, size = tensor(part.inertia), len(drawing.gravity)
    offset = np.zeros(size) if part.offset is None else np.array(part.offset)
    mass, g = part.mass, drawing.gravity
    pair = (str(part.point), str(part.frame))
    new = PlanarBody(pair, mass, J[0, 0], offset, g) if size == 2 else Body(pair, mass, J, offset, g)
    drawing.twins.append(new)


def held_in_body(drawing: Drawing, name: str, p: str, frame: str, q: str) -> None:
    """Constraints that keep q at its drawn place in the body (p, frame)."""
    x, size = drawing.x(p, frame, q), len(drawing.gravity)
    d = x[-size:] - x[:size]
    place = turned(-x[2], d) if size == 2 else rotated(_back(x[3:7]), d)

    def gap(y: Array, i: int) -> Array:
        arm = turned(y[2], place) if size == 2 else rotated(y[3:7], place)
        return np.asarray(y[i - size] - y[i] - arm[i])

    for i in range(size):
        drawing.measure(f"{name}.#{i}", (p, frame, q), lambda y, i=i: gap(y, i), True)


def _back(lam: Array) -> Array:
    return np.array([lam[0], *-lam[1:]])


@handler(joints.BodyPoint)
def _body_point(drawing: Drawing, part: joints.BodyPoint) -> None:
    held_in_body(drawing, part.name, str(part.p), str(part.frame), str(part.q))
