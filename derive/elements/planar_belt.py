"""Belt between two pulleys in the plane: one of its straight parts."""

from sympy import Matrix, atan2, pi, sqrt

from flexel.derive.declare import Deformation, Element, Let, Output, Parameter, PlanarAngle, PlanarPoint
from flexel.derive.declare.rotation import dot
from flexel.derive.elements.picture_outputs import WHEELS_DOC, frame, planar_axes
from flexel.derive.elements.triads import line_angle

RADIUS_P = Parameter(
    "radius_p", 1, "m", "radius of the pulley at p, positive if the belt leaves it on the left"
)
RADIUS_Q = Parameter(
    "radius_q", 1, "m", "radius of the pulley at q, positive if the belt runs on it on the left"
)
PSI0 = Parameter("psi0", 1, "rad", "direction of the line of centres from which its turn is counted")
ZERO = Parameter("zero", 1, "m", "length without strain, angles and turn taken as zero")


def _planar_belt() -> Element:
    p, rp, q, rq = PlanarPoint("p"), PlanarAngle("rp"), PlanarPoint("q"), PlanarAngle("rq")
    let = Let()
    d = let.vector("d", q.x - p.x)
    step = let.scalar("step", RADIUS_P.symbol - RADIUS_Q.symbol)
    free = let.scalar("free_length", sqrt(dot(d, d) - step**2))
    psi = let.scalar("psi", line_angle(let, d, PSI0.symbol))
    theta = let.scalar("theta", psi - atan2(step, free))
    left = Matrix([step * d[0] - free * d[1], free * d[0] + step * d[1]]) / dot(d, d)
    ends = p.x + RADIUS_P.symbol * left, q.x + RADIUS_Q.symbol * left
    wound = RADIUS_P.symbol * (rp.x[0] - theta) - RADIUS_Q.symbol * (rq.x[0] - theta)
    return Element(
        name="planar_belt",
        family="belt",
        picture="belt",
        nodes=(p, rp, q, rq),
        parameters=(RADIUS_P, RADIUS_Q, PSI0, ZERO),
        let=let.entries,
        deformations=(
            Deformation(
                "elongation",
                "m",
                free + wound - ZERO.symbol,
                period=2 * pi * (RADIUS_P.symbol - RADIUS_Q.symbol),
            ),
        ),
        doc=(
            "d = xq - xp, psi its angle counted from psi0 (less than half a turn away)\n"
            "free_length = sqrt(d.d - (radius_p - radius_q)^2), of the common tangent on the left of d\n"
            "theta = psi - atan2(radius_p - radius_q, free_length), turn of the points of contact\n"
            "elongation = free_length + radius_p (angle_p - theta) - radius_q (angle_q - theta) - zero,\n"
            "period 2 pi (radius_p - radius_q): a turn of the line of centres, whose angle is a principal value\n"
            "run: from xp + radius_p left to xq + radius_q left, left the normal of the common tangent"
            + WHEELS_DOC
        ),
        source="SPACAR95 manual (Schwab and Meijaard 2000), PLBELT; terms in theta from the geometry: without "
        "them the tension would not act along the belt",
        outputs=(
            Output("run", "m", Matrix.hstack(*ends).T, draws="bar"),
            *frame(p.x, *planar_axes(rp.x[0]), of="_p"),
            *frame(q.x, *planar_axes(rq.x[0]), of="_q"),
        ),
    )


PLANAR_BELT = _planar_belt()
