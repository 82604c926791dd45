"""Bearing in the plane: relative displacement of two points, in the axes of the first, and relative angle."""

from sympy import Matrix

from flexel.derive.declare import Deformation, Element, Let, PlanarAngle, PlanarPoint
from flexel.derive.declare.rotation import dot
from flexel.derive.elements.picture_outputs import LINK_DOC, axes, displacement
from flexel.derive.elements.planar_beam import ALPHA0
from flexel.derive.elements.planar_beam3 import PLANAR_D0
from flexel.derive.elements.planar_hinge import OFFSET0
from flexel.derive.elements.triads import named_directions


def _planar_bearing() -> Element:
    p, rp, q, rq = PlanarPoint("p"), PlanarAngle("rp"), PlanarPoint("q"), PlanarAngle("rq")
    let = Let()
    ex, ey = named_directions(let, rp, ALPHA0, "p")
    d = let.vector("d", q.x - p.x)
    relative = Matrix([dot(ex, d), dot(ey, d)]) - PLANAR_D0.vector
    return Element(
        name="planar_bearing",
        family="bearing",
        nodes=(p, rp, q, rq),
        parameters=(ALPHA0, PLANAR_D0, OFFSET0),
        let=let.entries,
        deformations=(
            Deformation("along", "m", relative[0]),
            Deformation("across", "m", relative[1]),
            Deformation("angle", "rad", rq.x[0] - rp.x[0] - OFFSET0.symbol, free=True),
        ),
        doc=(
            "ex, ey: directions of the element (angle_p + alpha0); d = xq - xp\n"
            "along = ex.d - d0_x,  across = ey.d - d0_y,  angle = angle_q - angle_p - offset0 (counts turns)"
            + LINK_DOC
        ),
        source="SPACAR95 manual (Schwab and Meijaard 2000), PLBEAR",
        outputs=(axes(ex, ey), displacement(relative)),
    )


PLANAR_BEARING = _planar_bearing()
