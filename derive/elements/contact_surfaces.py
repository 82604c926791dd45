"""Surfaces on a moving, rotating body, as something round that touches them sees them: gaps and sliding velocities.

The place y and the velocity ydot of the centre in the axes of the surface are all that a surface asks for, and how fast
what touches it turns relative to it. Where that has no rotation of its own (a rope, a point), sliding is taken at its
centre, where the body's velocity field is continued to: a rope that lies on a turning drum as if glued to it does not
slip, and the moment of friction is that of the tension along the rope's centre line. For a sphere of a body, sliding is
that of the material point of the sphere at the contact, so that it may roll.
Positive gaps are open; the contact force is a law's.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

from sympy import Expr, Matrix, Piecewise, atan2, cos, pi, sin, sqrt

from flexel.derive.declare import Deformation, Let, Node, Output, Parameter, Slip
from flexel.derive.declare.rotation import (
    body_angular_velocity,
    combination,
    components,
    cross,
    dot,
    norm,
    product,
    triad,
)
from flexel.derive.elements.picture_outputs import force, frame

T = Parameter("t", 4, "1", "unit quaternion from the body frame to the surface's triad ex, ey, ez")
OFFSET = Parameter("offset", 3, "m", "origin of the surface from the node c, on its triad", ("x", "y", "z"))
RADIUS = Parameter(
    "radius", 1, "m", "radius at which the rope's or sphere's surface touches, about the axle ex"
)
LEAD = Parameter(
    "lead", 1, "m", "axial distance of two turns of the groove, positive for a right-handed helix"
)
GROOVE_RADIUS = Parameter("groove_radius", 1, "m", "radius of the groove's round bottom")
FLANK = Parameter("flank", 2, "1", "sine and cosine of half the opening angle of the flanks", ("sin", "cos"))
SPHERE_RADIUS = Parameter("sphere_radius", 1, "m", "radius of the sphere; 0: a point", sign="not negative")

SEEN = (
    "triad ex, ey, ez: columns of R(lambda o t)\n"
    "y = components of x - xc on the triad - offset, ydot = their rates as long as lambda.lambda = 1\n"
)
ROLLING = (
    "turn = angular velocity of the sphere relative to the surface, on the triad; every slip along a direction d is\n"
    "less by sphere_radius turn.(n x d), n the normal to the sphere: that of the sphere's material point in contact\n"
    "(in a V groove it has two, with tangential1 and tangential2)\n"
)
DRAWN = "\nplace: x, force: on what touches, origin: of the surface, in global axes;  axes: its directions in rows"
BALL = "\naxes_ball: axes of the body of what touches, in rows"
Modes = tuple[tuple[Deformation, ...], tuple[Slip, ...]]


def gap(expr: Expr, name: str = "gap", kinked: bool = False) -> Deformation:
    """Return the mode of a gap, free by default."""
    return Deformation(name, "m", expr, free=True, kind="gap", kinked=kinked)


@dataclass(frozen=True)
class Touching:
    """What touches a surface, on the surface's triad.

    Attributes
    ----------
    y, yd : Matrix (3, 1)
        Place and velocity of its centre.
    radius : Expr
    spin : Matrix (3, 1), optional
        Its angular velocity relative to the surface; none for what has no rotation of its own.
    """

    y: Matrix
    yd: Matrix
    radius: Expr
    spin: Matrix | None = None

    def slip(self, name: str, velocity: Expr, axis: Sequence[Expr]) -> Slip:
        """Return the mode of sliding along a direction d.

        Parameters
        ----------
        name : str
        velocity : Expr
            That of the centre along d.
        axis : sequence of Expr (3,)
            n x d, the axis about which a sphere rolls forward along d; n is the normal towards the sphere.
        """
        rolling = 0 if self.spin is None else self.radius * dot(self.spin, Matrix(axis))
        return Slip(name, "m/s", velocity - rolling, free=True)


def seen(
    let: Let, body: tuple[Node, Node], x: Matrix, xd: Matrix, radius: Expr, turning: Matrix | None = None
) -> Touching:
    """Return the touching object with its centre at x, as seen from a surface on a body (c, r).

    Parameters
    ----------
    let : Let
    body : (Node, Node)
        Point and frame of the body.
    x, xd : Matrix (3, 1)
        Place and velocity of the centre in global axes.
    radius : Expr
    turning : Matrix (3, 1), optional
        Angular velocity in global axes, of what has a rotation of its own.
    """
    c, r = body
    d, rate = let.vector("d", x - c.x), let.vector("dd", xd - c.v)
    u = let.vector("u", product(r.x, T.vector))
    omega = let.vector("omega", body_angular_velocity(u, product(r.v, T.vector)))
    columns = triad(u)
    e = (let.vector("ex", columns[0]), let.vector("ey", columns[1]), let.vector("ez", columns[2]))
    arm = let.vector("arm", components(e, d))
    y = let.vector("y", arm - OFFSET.vector)
    yd = let.vector("yd", components(e, rate) - cross(omega, arm))
    spin = None if turning is None else let.vector("turn", components(e, turning) - omega)
    return Touching(y, yd, radius, spin)


def contact_outputs(body: tuple[Node, Node], x: Matrix, points: Sequence[Node]) -> tuple[Output, ...]:
    """Return the position of the touching object, the force on it, and where the surface is.

    Parameters
    ----------
    body : (Node, Node)
        Point and frame of the body with the surface.
    x : Matrix (3, 1)
    points : sequence of Node
        Those of what touches.
    """
    c, r = body
    columns = triad(product(r.x, T.vector))
    origin = c.x + combination(columns, OFFSET.vector)
    return Output("place", "m", x), force(*points), *frame(origin, *columns)


@dataclass(frozen=True)
class SurfaceKind:
    """A surface: its name, parameters, modes, and their description with `a` for what touches it."""

    name: str
    parameters: tuple[Parameter, ...]
    modes: Callable[[Let, Touching], Modes]
    doc: str


def _around(let: Let, b: Touching) -> tuple[Expr, Expr, Expr, Matrix]:
    """Return the distance from the axle ex, its rate, the velocity around it, and the radial direction."""
    distance = let.scalar("distance", norm(Matrix(b.y[1:])))
    ny, nz = let.scalar("ny", b.y[1] / distance), let.scalar("nz", b.y[2] / distance)
    radial, around = ny * b.yd[1] + nz * b.yd[2], ny * b.yd[2] - nz * b.yd[1]
    return distance, radial, around, Matrix([0, ny, nz])


def _cylinder(let: Let, b: Touching) -> Modes:
    distance, _, around, (_, ny, nz) = _around(let, b)
    slips = (b.slip("tangential", around, (1, 0, 0)), b.slip("axial", b.yd[0], (0, nz, -ny)))
    return (gap(distance - RADIUS.symbol - b.radius),), slips


def _plane(let: Let, b: Touching) -> Modes:  # noqa: ARG001 (a surface is a function of these two)
    slips = (b.slip("x", b.yd[0], (0, 1, 0)), b.slip("y", b.yd[1], (-1, 0, 0)))
    return (gap(b.y[2] - b.radius),), slips


def _v_groove(let: Let, b: Touching) -> Modes:
    """Return gap and slips of a V-groove; what turns slides differently on the two flanks, also around the axle."""
    s, c = FLANK.vector
    distance, radial, around, (_, ny, nz) = _around(let, b)
    height = let.scalar("height", s * (distance - RADIUS.symbol - b.radius))
    gaps = (gap(height - c * b.y[0], "gap1"), gap(height + c * b.y[0], "gap2"))
    along = let.scalar("along", c * radial)
    across1 = b.slip("across1", along + s * b.yd[0], (0, nz, -ny))
    across2 = b.slip("across2", along - s * b.yd[0], (0, -nz, ny))
    if b.spin is None:
        return gaps, (b.slip("tangential", around, (0, 0, 0)), across1, across2)
    tangential1 = b.slip("tangential1", around, (s, c * ny, c * nz))
    tangential2 = b.slip("tangential2", around, (s, -c * ny, -c * nz))
    return gaps, (tangential1, across1, tangential2, across2)


def _round_groove(let: Let, b: Touching) -> Modes:
    """Return gap and slips; the normal (n_r, n_x) points into the wall: along w on the bottom, constant on a flank.

    Outside the groove, in the middle between its flanks, the gap has a kink.
    """
    s, c = FLANK.vector
    distance, radial, around, (_, ny, nz) = _around(let, b)
    depth = let.scalar("depth", RADIUS.symbol + GROOVE_RADIUS.symbol - distance)
    side = b.y[0]
    bottom = c * depth > s * abs(side)  # the direction of w is one of the round bottom's
    sign = Piecewise((-1, side < 0), (1, True))
    square = let.scalar("square", Piecewise((depth**2 + side**2, bottom), (1, True)))
    length = let.scalar("length", sqrt(square))
    n_depth = let.scalar("n_depth", Piecewise((depth / length, bottom), (s, True)))
    n_side = let.scalar("n_side", Piecewise((side / length, bottom), (c * sign, True)))
    reach = let.scalar("reach", Piecewise((length, bottom), (s * depth + c * abs(side), True)))
    across = n_depth * b.yd[0] + n_side * radial
    slips = (
        b.slip("tangential", around, (n_depth, n_side * ny, n_side * nz)),
        b.slip("across", across, (0, nz, -ny)),
    )
    return (gap(GROOVE_RADIUS.symbol - b.radius - reach, kinked=True),), slips


def _helical_groove(let: Let, b: Touching) -> Modes:
    """Return gap and slips of the round groove, axially measured from the nearest turn; for ropes.

    The profile is that perpendicular to the groove: the gradient of the gap has the length one at the rope's centre,
    and its force is normal to the groove.  The angle atan2 jumps on the ridges; the gap is the same on both sides.
    """
    y, yd = b.y, b.yd
    pitch = let.scalar("pitch", LEAD.symbol / (2 * pi))
    middle = let.scalar("middle", RADIUS.symbol + b.radius)
    slant = let.scalar("slant", sqrt(middle**2 + pitch**2))
    c, s = let.scalar("c_lead", middle / slant), let.scalar("s_lead", pitch / slant)
    turned = let.scalar("turned", y[0] / pitch)
    cosine, sine = let.scalar("c_turned", cos(turned)), let.scalar("s_turned", sin(turned))
    ahead = atan2(sine * y[1] - cosine * y[2], cosine * y[1] + sine * y[2])
    side = let.scalar("side", c * pitch * ahead)
    around = let.scalar("around", (y[1] * yd[2] - y[2] * yd[1]) / norm(Matrix(y[1:])))
    perpendicular = let.scalar("perpendicular", c * yd[0] - s * around)
    seen_along = replace(b, y=Matrix([side, y[1], y[2]]), yd=Matrix([perpendicular, yd[1], yd[2]]))
    gaps, slips = _round_groove(let, seen_along)
    return (replace(gaps[0], period=0),), (b.slip("tangential", c * around + s * yd[0], (0, 0, 0)), slips[1])


SURFACES = (
    SurfaceKind(
        "cylinder",
        (RADIUS,),
        _cylinder,
        "distance = |(yy, yz)| from the axle ex, (ny, nz) = (yy, yz)/distance\n"
        "gap = distance - radius - {a},  tangential = ny ydot_z - nz ydot_y,  axial = ydot_x",
    ),
    SurfaceKind(
        "plane",
        (),
        _plane,
        "gap = yz - {a}, the plane is z = 0;  x = ydot_x,  y = ydot_y",
    ),
    SurfaceKind(
        "v_groove",
        (RADIUS, FLANK),
        _v_groove,
        "distance = |(yy, yz)| from the axle ex, h = distance - radius - {a}; two flanks of half the angle beta\n"
        "gap1 = h sin beta - yx cos beta,  gap2 = h sin beta + yx cos beta: both closed at h = 0 in the middle\n"
        "tangential as for a cylinder,  across1, across2 = hdot cos beta +- ydot_x sin beta, up the flanks",
    ),
    SurfaceKind(
        "round_groove",
        (RADIUS, GROOVE_RADIUS, FLANK),
        _round_groove,
        "w = (radius + groove_radius - distance from the axle ex, yx), from the centre of the round bottom to the {b}\n"
        "gap = groove_radius - {a} - n.w, n = w/|w| on the bottom, (sin beta, +-cos beta) on the flanks that\n"
        "continue it;  tangential as for a cylinder,  "
        "across = n_0 ydot_x + n_1 distancedot, along the groove's profile",
    ),
)
HELICAL_GROOVE = SurfaceKind(
    "helical_groove",
    (RADIUS, LEAD, GROOVE_RADIUS, FLANK),
    _helical_groove,
    "a round groove along the helix yx = lead phi/(2 pi), phi the angle of (yy, yz) about the axle ex from ey to ez\n"
    "side = (yx - lead phi/(2 pi)) cos gamma from the nearest turn, tan gamma = lead/(2 pi (radius + {a}))\n"
    "gap of the round groove with side for yx: its profile is perpendicular to the groove\n"
    "tangential along the groove;  across along its profile, perpendicular to the groove",
)
