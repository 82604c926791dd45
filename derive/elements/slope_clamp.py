"""Direction of a cable's end held by a body: the slope stays along an axis of the body, free to stretch."""

from flexel.derive.declare import Deformation, Element, Frame, Let, Parameter, PlanarAngle, PlanarSlope, Slope
from flexel.derive.declare.rotation import dot, product, triad
from flexel.derive.elements.planar_beam import ALPHA0
from flexel.derive.elements.triads import named_directions

T = Parameter(
    "t", 4, "1", "unit quaternion from the body frame to a triad whose first axis is the held direction"
)


def _slope_clamp() -> Element:
    r, d = Frame("r"), Slope("d")
    let = Let()
    u = let.vector("u", product(r.x, T.vector))
    _, ey, ez = triad(u)
    return Element(
        name="slope_clamp",
        family="clamp",
        nodes=(r, d),
        parameters=(T,),
        let=let.entries,
        deformations=(Deformation("across_y", "1", dot(ey, d.x)), Deformation("across_z", "1", dot(ez, d.x))),
        doc="triad ex, ey, ez: columns of R(lambda o t);  across_y = ey.d,  across_z = ez.d",
        source="textbook mechanics",
    )


def _planar_slope_clamp() -> Element:
    r, d = PlanarAngle("r"), PlanarSlope("d")
    let = Let()
    _, ey = named_directions(let, r, ALPHA0, "r")
    return Element(
        name="planar_slope_clamp",
        family="clamp",
        nodes=(r, d),
        parameters=(ALPHA0,),
        let=let.entries,
        deformations=(Deformation("across", "1", dot(ey, d.x)),),
        doc="ex, ey: directions at angle + alpha0;  across = ey.d",
        source="planar counterpart of slope_clamp",
    )


SLOPE_CLAMP = _slope_clamp()
PLANAR_SLOPE_CLAMP = _planar_slope_clamp()
