"""Circles and lines on a moving, rotating body of the plane: the planar counterparts of ``contact_surfaces``."""

from collections.abc import Callable
from dataclasses import dataclass

from sympy import Expr, Matrix

from flexel.derive.declare import Let, Node, Output, Parameter
from flexel.derive.declare.rotation import dot, norm
from flexel.derive.elements.contact_surfaces import RADIUS, Modes, Touching, gap
from flexel.derive.elements.picture_outputs import force, frame, planar_axes
from flexel.derive.elements.planar_beam import ALPHA0
from flexel.derive.elements.triads import named_directions

PLANAR_OFFSET = Parameter("offset", 2, "m", "origin of the circle or line from c, on ex and ey", ("x", "y"))

PLANAR_SEEN = (
    "ex, ey: directions at angle + alpha0\n"
    "w = xdot - xcdot - angledot ez x (x - xc), the velocity seen from the body\n"
)
PLANAR_ROLLING = "turn = angular velocity of the disc relative to the surface\n"


def planar_seen(
    let: Let, body: tuple[Node, Node], x: Matrix, xd: Matrix, radius: Expr, turning: Expr | None = None
) -> tuple[Touching, tuple[Matrix, Matrix]]:
    """Return the touching object with its centre at x, as seen from a body (c, r), and the axes of the surface.

    `turning` is its angular velocity, of what has a rotation of its own.
    """
    c, r = body
    d, rate = let.vector("d", x - c.x), xd - c.v
    sliding = let.vector("sliding", rate - r.v[0] * Matrix([-d[1], d[0]]))
    axes = named_directions(let, r, ALPHA0, "r")
    spin = None if turning is None else Matrix([turning - r.v[0]])
    return Touching(d, sliding, radius, spin), axes


def planar_contact_outputs(
    body: tuple[Node, Node], x: Matrix, points: tuple[Node, ...]
) -> tuple[Output, ...]:
    """Return the position of the touching object, the force on it, and where the surface is; see `contact_outputs`."""
    c, r = body
    ex, ey = planar_axes(r.x[0] + ALPHA0.symbol)
    origin = c.x + PLANAR_OFFSET.vector[0] * ex + PLANAR_OFFSET.vector[1] * ey
    return Output("place", "m", x), force(*points), *frame(origin, ex, ey)


@dataclass(frozen=True)
class PlanarSurface:
    """A circle or a line: its name, parameters, modes, and their description with `a` for what touches it."""

    name: str
    parameters: tuple[Parameter, ...]
    modes: Callable[[Let, Touching, tuple[Matrix, Matrix]], Modes]
    doc: str
    rolling: str


def _circle(let: Let, b: Touching, axes: tuple[Matrix, Matrix]) -> Modes:
    offset, sliding = PLANAR_OFFSET.vector, b.yd
    arm = let.vector("arm", b.y - offset[0] * axes[0] - offset[1] * axes[1])
    distance = let.scalar("distance", norm(arm))
    tangential = (arm[0] * sliding[1] - arm[1] * sliding[0]) / distance
    return (gap(distance - RADIUS.symbol - b.radius),), (b.slip("tangential", tangential, (1,)),)


def _line(let: Let, b: Touching, axes: tuple[Matrix, Matrix]) -> Modes:  # noqa: ARG001 (as _circle)
    ex, ey = axes
    height = dot(ey, b.y) - PLANAR_OFFSET.vector[1]
    return (gap(height - b.radius),), (b.slip("tangential", dot(ex, b.yd), (-1,)),)


PLANAR_SURFACES = (
    PlanarSurface(
        "circle",
        (RADIUS,),
        _circle,
        "a = x - xc - offset_x ex - offset_y ey\n"
        "gap = |a| - radius - {a},  tangential = (ax wy - ay wx)/|a|{turn}, counterclockwise",
        " - sphere_radius turn",
    ),
    PlanarSurface(
        "line",
        (),
        _line,
        "gap = ey.(x - xc) - offset_y - {a},  tangential = ex.w{turn}",
        " + sphere_radius turn",
    ),
)
