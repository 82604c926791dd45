"""Velocity of a point in the axes of a body, as slips: they carry forces that follow the body."""

from sympy import Matrix, cos, sin

from flexel.derive.declare import Element, Frame, PlanarAngle, PlanarPoint, Point, Slip
from flexel.derive.declare.rotation import dot, triad


def _slips(components: list[object]) -> tuple[Slip, ...]:
    return tuple(Slip(f"v{axis}", "m/s", c, free=True) for axis, c in zip("xyz", components, strict=False))


def _body_velocity() -> Element:
    p, r = Point("p"), Frame("r")
    return Element(
        name="body_velocity",
        family="sensor",
        nodes=(p, r),
        slips=_slips([dot(e, p.v) for e in triad(r.x)]),
        doc="(vx, vy, vz) = R(lambda)' xdot_p, velocity of the point in the axes of the frame",
        source="textbook mechanics",
    )


def _planar_body_velocity() -> Element:
    p, r = PlanarPoint("p"), PlanarAngle("r")
    c, s = cos(r.x[0]), sin(r.x[0])
    axes = (Matrix([c, s]), Matrix([-s, c]))
    return Element(
        name="planar_body_velocity",
        family="sensor",
        nodes=(p, r),
        slips=_slips([dot(e, p.v) for e in axes]),
        doc="(vx, vy) = R(angle)' xdot_p, velocity of the point in the axes of the angle node",
        source="textbook mechanics",
    )


BODY_VELOCITY = _body_velocity()
PLANAR_BODY_VELOCITY = _planar_body_velocity()
