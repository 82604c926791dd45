"""A point of a planar cable near a circle or a line on a moving, rotating body: gap and sliding velocity.

The planar counterparts of the cylinder and of the plane in ``rope_contact``.
"""

from sympy import Expr, Matrix

from flexel.derive.declare import (
    Deformation,
    Element,
    Let,
    Parameter,
    PlanarAngle,
    PlanarPoint,
    PlanarSlope,
    Slip,
)
from flexel.derive.declare.rotation import dot, norm
from flexel.derive.elements.arc_point import ARC_POINT, arc_point
from flexel.derive.elements.parameters import L0
from flexel.derive.elements.planar_beam import ALPHA0
from flexel.derive.elements.rope_contact import RADIUS, ROPE_RADIUS, XI
from flexel.derive.elements.triads import named_directions

PLANAR_OFFSET = Parameter("offset", 2, "m", "origin of the circle or line from c, on ex and ey", ("x", "y"))


def _planar_contact(name: str, parameters: tuple[Parameter, ...], doc: str) -> Element:
    p, dp, q, dq = PlanarPoint("p"), PlanarSlope("dp"), PlanarPoint("q"), PlanarSlope("dq")
    c, r = PlanarPoint("c"), PlanarAngle("r")
    let = Let()
    cable = (p, dp, q, dq)
    x, xd = arc_point(let, cable, XI.symbol)
    d, rate = let.vector("d", x - c.x), xd - c.v
    sliding = let.vector("sliding", rate - r.v[0] * Matrix([-d[1], d[0]]))
    ex, ey = named_directions(let, r, ALPHA0, "r")
    gap, tangential = (_circle if RADIUS in parameters else _line)(let, d, sliding, ex, ey)
    return Element(
        name=name,
        family="contact",
        picture="contact",
        nodes=(*cable, c, r),
        parameters=(L0, XI, ALPHA0, PLANAR_OFFSET, *parameters),
        let=let.entries,
        deformations=(Deformation("gap", "m", gap, free=True, kind="gap"),),
        slips=(Slip("tangential", "m/s", tangential, free=True),),
        doc=(
            ARC_POINT + "ex, ey: directions at angle + alpha0\n"
            "w = xdot - xcdot - angledot ez x (x - xc), the velocity seen from the body\n" + doc
        ),
        source="planar counterpart of contact in space",
    )


def _circle(let: Let, d: Matrix, sliding: Matrix, ex: Matrix, ey: Matrix) -> tuple[Expr, Expr]:
    offset = PLANAR_OFFSET.vector
    arm = let.vector("arm", d - offset[0] * ex - offset[1] * ey)
    distance = let.scalar("distance", norm(arm))
    tangential = (arm[0] * sliding[1] - arm[1] * sliding[0]) / distance
    return distance - RADIUS.symbol - ROPE_RADIUS.symbol, tangential


def _line(let: Let, d: Matrix, sliding: Matrix, ex: Matrix, ey: Matrix) -> tuple[Expr, Expr]:  # noqa: ARG001
    return dot(ey, d) - PLANAR_OFFSET.vector[1] - ROPE_RADIUS.symbol, dot(ex, sliding)


PLANAR_CABLE_CIRCLE = _planar_contact(
    "planar_cable_circle",
    (RADIUS, ROPE_RADIUS),
    "a = x - xc - offset_x ex - offset_y ey\n"
    "gap = |a| - radius - rope_radius,  tangential = (ax wy - ay wx)/|a|, counterclockwise",
)
PLANAR_CABLE_LINE = _planar_contact(
    "planar_cable_line",
    (ROPE_RADIUS,),
    "gap = ey.(x - xc) - offset_y - rope_radius,  tangential = ex.w",
)
