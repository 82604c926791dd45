"""A point of a cable near the surface of a moving, rotating body: gap and sliding velocities.

The place y and the velocity ydot of the point in the axes of the body are all that a surface asks for. Sliding is
taken at the centre of the rope, where the body's velocity field is continued to: a rope that lies on a turning
drum as if glued to it does not slip, and the moment of friction is that of the tension along the rope's centre line.
Positive gaps are open; the contact force is a law's.
"""

from collections.abc import Callable
from dataclasses import replace

from sympy import Expr, Matrix, Piecewise, atan2, cos, pi, sin, sqrt

from flexel.derive.declare import Deformation, Element, Frame, Let, Parameter, Point, Slip, Slope
from flexel.derive.declare.rotation import body_angular_velocity, components, cross, norm, product, triad
from flexel.derive.elements.arc_point import ARC_POINT, arc_point
from flexel.derive.elements.parameters import L0

XI = Parameter("xi", 1, "1", "place along the element, from 0 at p to 1 at q")
T = Parameter("t", 4, "1", "unit quaternion from the body frame to the surface's triad ex, ey, ez")
OFFSET = Parameter("offset", 3, "m", "origin of the surface from the node c, on its triad", ("x", "y", "z"))
RADIUS = Parameter("radius", 1, "m", "radius at which the rope's surface touches, about the axle ex")
LEAD = Parameter(
    "lead", 1, "m", "axial distance of two turns of the groove, positive for a right-handed helix"
)
ROPE_RADIUS = Parameter("rope_radius", 1, "m", "outer radius of the rope")
GROOVE_RADIUS = Parameter("groove_radius", 1, "m", "radius of the groove's round bottom")
FLANK = Parameter("flank", 2, "1", "sine and cosine of half the opening angle of the flanks", ("sin", "cos"))

_COMMON = (
    ARC_POINT + "triad ex, ey, ez: columns of R(lambda o t)\n"
    "y = components of x - xc on the triad - offset, ydot = their rates as long as lambda.lambda = 1\n"
)
_SOURCE = "textbook mechanics"
Modes = tuple[tuple[Deformation, ...], tuple[Slip, ...]]
Surface = Callable[[Let, Matrix, Matrix], Modes]


def _gap(expr: Expr, name: str = "gap") -> Deformation:
    return Deformation(name, "m", expr, free=True, kind="gap")


def _slip(name: str, expr: Expr) -> Slip:
    return Slip(name, "m/s", expr, free=True)


def _contact(name: str, parameters: tuple[Parameter, ...], surface: Surface, doc: str) -> Element:
    """Element of a rope's point and a surface that is given by its modes as functions of y and ydot."""
    p, dp, q, dq, c, r = Point("p"), Slope("dp"), Point("q"), Slope("dq"), Point("c"), Frame("r")
    let = Let()
    cable = (p, dp, q, dq)
    x, xd = arc_point(let, cable, XI.symbol)
    d, rate = let.vector("d", x - c.x), let.vector("dd", xd - c.v)
    u = let.vector("u", product(r.x, T.vector))
    omega = let.vector("omega", body_angular_velocity(u, product(r.v, T.vector)))
    axes = triad(u)
    axes = (let.vector("ex", axes[0]), let.vector("ey", axes[1]), let.vector("ez", axes[2]))
    arm = let.vector("arm", components(axes, d))
    y = let.vector("y", arm - OFFSET.vector)
    yd = let.vector("yd", components(axes, rate) - cross(omega, arm))
    deformations, slips = surface(let, y, yd)
    return Element(
        name=name,
        family="contact",
        picture="contact",
        nodes=(*cable, c, r),
        parameters=(L0, XI, T, OFFSET, *parameters),
        let=let.entries,
        deformations=deformations,
        slips=slips,
        doc=_COMMON + doc,
        source=_SOURCE,
    )


def _around(let: Let, y: Matrix, yd: Matrix) -> tuple[Expr, Expr, Expr]:
    """Distance from the axle ex, its rate, and the velocity around it."""
    distance = let.scalar("distance", norm(Matrix(y[1:])))
    ny, nz = let.scalar("ny", y[1] / distance), let.scalar("nz", y[2] / distance)
    return distance, ny * yd[1] + nz * yd[2], ny * yd[2] - nz * yd[1]


def _cylinder(let: Let, y: Matrix, yd: Matrix) -> Modes:
    distance, _, around = _around(let, y, yd)
    gap = distance - RADIUS.symbol - ROPE_RADIUS.symbol
    return (_gap(gap),), (_slip("tangential", around), _slip("axial", yd[0]))


def _plane(let: Let, y: Matrix, yd: Matrix) -> Modes:  # noqa: ARG001 (a surface is a function of these three)
    return (_gap(y[2] - ROPE_RADIUS.symbol),), (_slip("x", yd[0]), _slip("y", yd[1]))


def _v_groove(let: Let, y: Matrix, yd: Matrix) -> Modes:
    s, c = FLANK.vector
    distance, radial, around = _around(let, y, yd)
    height = let.scalar("height", s * (distance - RADIUS.symbol - ROPE_RADIUS.symbol))
    gaps = (_gap(height - c * y[0], "gap1"), _gap(height + c * y[0], "gap2"))
    along = let.scalar("along", c * radial)
    slips = (
        _slip("tangential", around),
        _slip("across1", along + s * yd[0]),
        _slip("across2", along - s * yd[0]),
    )
    return gaps, slips


def _round_groove(let: Let, y: Matrix, yd: Matrix) -> Modes:
    """The normal (n_r, n_x) points into the wall: along w on the round bottom, constant on a flank."""
    s, c = FLANK.vector
    distance, radial, around = _around(let, y, yd)
    depth = let.scalar("depth", RADIUS.symbol + GROOVE_RADIUS.symbol - distance)
    side = y[0]
    bottom = c * depth > s * abs(side)  # the direction of w is one of the round bottom's
    sign = Piecewise((-1, side < 0), (1, True))
    square = let.scalar("square", Piecewise((depth**2 + side**2, bottom), (1, True)))
    length = let.scalar("length", sqrt(square))
    n_depth = let.scalar("n_depth", Piecewise((depth / length, bottom), (s, True)))
    n_side = let.scalar("n_side", Piecewise((side / length, bottom), (c * sign, True)))
    reach = let.scalar("reach", Piecewise((length, bottom), (s * depth + c * abs(side), True)))
    gap = GROOVE_RADIUS.symbol - ROPE_RADIUS.symbol - reach
    across = n_depth * yd[0] + n_side * radial
    return (_gap(gap),), (_slip("tangential", around), _slip("across", across))


def _helical_groove(let: Let, y: Matrix, yd: Matrix) -> Modes:
    """The round groove, with the distance from the nearest turn in place of the axial coordinate.

    The profile is that perpendicular to the groove: the gradient of the gap has the length one at the rope's centre,
    and its force is normal to the groove.  The angle atan2 jumps on the ridges; the gap is the same on both sides.
    """
    pitch = let.scalar("pitch", LEAD.symbol / (2 * pi))
    middle = let.scalar("middle", RADIUS.symbol + ROPE_RADIUS.symbol)
    slant = let.scalar("slant", sqrt(middle**2 + pitch**2))
    c, s = let.scalar("c_lead", middle / slant), let.scalar("s_lead", pitch / slant)
    turned = let.scalar("turned", y[0] / pitch)
    cosine, sine = let.scalar("c_turned", cos(turned)), let.scalar("s_turned", sin(turned))
    ahead = atan2(sine * y[1] - cosine * y[2], cosine * y[1] + sine * y[2])
    side = let.scalar("side", c * pitch * ahead)
    around = let.scalar("around", (y[1] * yd[2] - y[2] * yd[1]) / norm(Matrix(y[1:])))
    perpendicular = let.scalar("perpendicular", c * yd[0] - s * around)
    gaps, slips = _round_groove(let, Matrix([side, y[1], y[2]]), Matrix([perpendicular, yd[1], yd[2]]))
    return (replace(gaps[0], period=0),), (_slip("tangential", c * around + s * yd[0]), slips[1])


CABLE_CYLINDER = _contact(
    "cable_cylinder",
    (RADIUS, ROPE_RADIUS),
    _cylinder,
    "distance = |(yy, yz)| from the axle ex, (ny, nz) = (yy, yz)/distance\n"
    "gap = distance - radius - rope_radius,  tangential = ny ydot_z - nz ydot_y,  axial = ydot_x",
)
CABLE_PLANE = _contact(
    "cable_plane",
    (ROPE_RADIUS,),
    _plane,
    "gap = yz - rope_radius, the plane is z = 0;  x = ydot_x,  y = ydot_y",
)
CABLE_V_GROOVE = _contact(
    "cable_v_groove",
    (RADIUS, FLANK, ROPE_RADIUS),
    _v_groove,
    "distance = |(yy, yz)| from the axle ex, h = distance - radius - rope_radius; two flanks of half the angle beta\n"
    "gap1 = h sin beta - yx cos beta,  gap2 = h sin beta + yx cos beta: both closed at h = 0 in the middle\n"
    "tangential as for a cylinder,  across1, across2 = hdot cos beta +- ydot_x sin beta, up the flanks",
)
CABLE_ROUND_GROOVE = _contact(
    "cable_round_groove",
    (RADIUS, GROOVE_RADIUS, FLANK, ROPE_RADIUS),
    _round_groove,
    "w = (radius + groove_radius - distance from the axle ex, yx), from the centre of the round bottom to the rope\n"
    "gap = groove_radius - rope_radius - n.w, n = w/|w| on the bottom, (sin beta, +-cos beta) on the flanks that\n"
    "continue it;  tangential as for a cylinder,  across = n_0 ydot_x + n_1 distancedot, along the groove's profile",
)
CABLE_HELICAL_GROOVE = _contact(
    "cable_helical_groove",
    (RADIUS, LEAD, GROOVE_RADIUS, FLANK, ROPE_RADIUS),
    _helical_groove,
    "a round groove along the helix yx = lead phi/(2 pi), phi the angle of (yy, yz) about the axle ex from ey to ez\n"
    "side = (yx - lead phi/(2 pi)) cos gamma from the nearest turn, tan gamma = lead/(2 pi (radius + rope_radius))\n"
    "gap of the round groove with side for yx: its profile is perpendicular to the groove\n"
    "tangential along the groove;  across along its profile, perpendicular to the groove",
)
