"""Wheel or knife edge that rolls on the plane itself, upright: two slips and no deformations."""

from sympy import Matrix, cos, sin

from flexel.derive.declare import Element, Let, Parameter, PlanarAngle, PlanarPoint, Slip
from flexel.derive.declare.rotation import dot
from flexel.derive.elements.picture_outputs import frame
from flexel.derive.elements.planar_beam import ALPHA0
from flexel.derive.elements.triads import named_directions

ROLLING_RADIUS = Parameter("radius", 1, "m", "radius of the wheel")


def _planar_wheel() -> Element:
    p, r, s = PlanarPoint("p"), PlanarAngle("r"), PlanarAngle("s")
    let = Let()
    ex, ey = named_directions(let, r, ALPHA0, "r")
    c, s_turn = cos(s.x[0]), sin(s.x[0])
    spoke, behind = Matrix([*(c * ex), -s_turn]), Matrix([*(-s_turn * ex), -c])
    return Element(
        name="planar_wheel",
        family="wheel",
        picture="disc",
        nodes=(p, r, s),
        parameters=(ROLLING_RADIUS, ALPHA0),
        let=let.entries,
        slips=(
            Slip("longitudinal", "m/s", dot(ex, p.v) - ROLLING_RADIUS.symbol * s.v[0]),
            Slip("lateral", "m/s", dot(ey, p.v)),
        ),
        doc=(
            "ex, ey: direction of travel (angle_r + alpha0) and its normal; angle_s is the turn about the axle\n"
            "longitudinal = ex.v - radius angledot_s,  lateral = ey.v\n"
            "axes: of the wheel in space, in rows: a spoke, which turns from ex down, its normal, and the axle ey\n"
            "origin: x"
        ),
        source="SPACAR95 manual (Schwab and Meijaard 2000), PLWHEEL",
        outputs=frame(p.x, spoke, behind, Matrix([*ey, 0])),
    )


PLANAR_WHEEL = _planar_wheel()
