"""Wheels: a disc or a torus that rolls on a plane, and the upright wheel of the plane."""

import numpy as np

from campaign.algebra import conjugate, cross, dot, norm, rotated
from campaign.parts import Drawing, handler
from flexel.base.arrays import Array
from flexel.parts.couplings import PlanarWheel
from flexel.parts.wheels import Wheel


def spin_row(lam: Array, w: Array) -> Array:
    """The row (4, ...) of w·ω by the rates of Euler parameters: ω = 2 (λ0 λ̇ - λ̇0 λ + λ × λ̇)."""
    axis = lam[1:]
    return np.concatenate([[-2 * dot(w, axis)], 2 * (lam[0] * w + cross(w, axis))])


class Geometry:
    """A wheel's contact in terms of x: hub (3), Euler parameters (4), contact (3)."""

    def __init__(self, axle: Array, normal: Array, height: float, radius: float, crown: float) -> None:
        self.axle, self.n, self.height, self.rim, self.crown = axle, normal, height, radius - crown, crown

    def normal(self, x: Array) -> Array:
        """The normal beside x."""
        return np.asarray(self.n.reshape(3, *(1,) * (x.ndim - 1)) + 0 * x[:3])

    def centre(self, x: Array) -> Array:
        """From the hub to the centre of the tube above the contact."""
        return np.asarray(x[7:] - x[:3] + self.crown * self.normal(x))

    def distance(self, x: Array) -> Array:
        """The centre of the tube is on a circle about the hub …"""
        r = self.centre(x)
        return norm(r) - self.rim

    def plane(self, x: Array) -> Array:
        """… in the plane of the wheel …"""
        return dot(self.centre(x), rotated(x[3:7], self.axle))

    def road(self, x: Array) -> Array:
        """… as far above the road as the tube is thick …"""
        return dot(self.normal(x), x[7:]) - self.height

    def lowest(self, x: Array) -> Array:
        """… and below the hub: on the line of steepest descent in the wheel's plane."""
        return dot(cross(rotated(x[3:7], self.axle), self.normal(x)), self.centre(x))

    def row(self, x: Array, direction: Array) -> Array:
        """Velocity of the material point in contact along a direction, as a row."""
        arm = x[7:] - x[:3]
        return np.concatenate([direction, spin_row(x[3:7], cross(arm, direction)), 0 * arm])

    def heading(self, x: Array) -> Array:
        """Horizontal, in the wheel's plane."""
        line = cross(self.centre(x), rotated(x[3:7], self.axle))
        return line / norm(line)

    def sideways(self, x: Array) -> Array:
        """Horizontal, across the heading."""
        return cross(self.normal(x), self.heading(x))


@handler(Wheel, options="normal height crown")
def _wheel(drawing: Drawing, part: Wheel) -> None:
    name, hub, frame, contact = map(str, (part.name, part.hub, part.frame, part.contact))
    axle = np.array(part.axle, float) / np.linalg.norm(part.axle)
    normal = np.array(part.normal, float) / np.linalg.norm(part.normal)
    in_frame = rotated(conjugate(drawing.x(frame)), axle)
    wheel = Geometry(in_frame, normal, part.height, part.radius, part.crown)
    nodes = (hub, frame, contact)
    for condition in (wheel.distance, wheel.plane, wheel.road, wheel.lowest):
        drawing.measure(f"{name}.#{condition.__name__}", nodes, condition, True)
    drawing.slip(f"{name}.longitudinal", nodes, lambda x: wheel.row(x, wheel.heading(x)), True)
    drawing.slip(f"{name}.lateral", nodes, lambda x: wheel.row(x, wheel.sideways(x)), True)


@handler(PlanarWheel, options="direction")
def _planar_wheel(drawing: Drawing, part: PlanarWheel) -> None:
    name, *nodes = map(str, (part.name, part.point, part.heading, part.spin))
    x0, y0 = part.direction
    start = np.arctan2(y0, x0) - drawing.x(nodes[1])[0]

    def longitudinal(x: Array) -> Array:
        c, s = np.cos(x[2] + start), np.sin(x[2] + start)
        return np.array([c, s, 0 * c, 0 * c - part.radius])

    def lateral(x: Array) -> Array:
        c, s = np.cos(x[2] + start), np.sin(x[2] + start)
        return np.array([-s, c, 0 * c, 0 * c])

    drawing.slip(f"{name}.longitudinal", tuple(nodes), longitudinal, True)
    drawing.slip(f"{name}.lateral", tuple(nodes), lateral, True)
