"""Pair of gears in the plane, on centres that may move."""

from sympy import pi

from flexel.derive.declare import Deformation, Element, Let, Parameter, PlanarAngle, PlanarPoint
from flexel.derive.elements.picture_outputs import WHEELS_DOC, frame, planar_axes
from flexel.derive.elements.planar_hinge import OFFSET0
from flexel.derive.elements.triads import line_angle

PITCH_P = Parameter("radius_p", 1, "m", "pitch radius of the gear at p, negative for an internal gear")
PITCH_Q = Parameter("radius_q", 1, "m", "pitch radius of the gear at q, negative for an internal gear")


def _planar_gear() -> Element:
    p, rp, q, rq = PlanarPoint("p"), PlanarAngle("rp"), PlanarPoint("q"), PlanarAngle("rq")
    a, b = PITCH_P.symbol, PITCH_Q.symbol
    let = Let()
    d = let.vector("d", q.x - p.x)
    psi = let.scalar("psi", line_angle(let, d, OFFSET0.symbol))
    return Element(
        name="planar_gear",
        family="gear",
        picture="gears",
        nodes=(p, rp, q, rq),
        parameters=(PITCH_P, PITCH_Q, OFFSET0),
        let=let.entries,
        deformations=(
            Deformation("mesh", "rad", (a * rp.x[0] + b * rq.x[0]) / (a + b) - psi, period=2 * pi),
        ),
        doc=(
            "d = xq - xp, psi its angle counted from offset0, period 2 pi\n"
            "mesh = (radius_p angle_p + radius_q angle_q)/(radius_p + radius_q) - psi, an angle, so that any number\n"
            "of turns of the line of centres can be counted; (radius_p + radius_q) mesh is the displacement of the "
            "teeth" + WHEELS_DOC
        ),
        source="rolling of the pitch circles, radius_p (angle_p - psi) + radius_q (angle_q - psi) = const; "
        "UT SPACAR, GEAR",
        outputs=(
            *frame(p.x, *planar_axes(rp.x[0]), of="_p"),
            *frame(q.x, *planar_axes(rq.x[0]), of="_q"),
        ),
    )


PLANAR_GEAR = _planar_gear()
