"""Hinge between two angles in the plane."""

from flexel.derive.declare import Deformation, Element, Parameter, PlanarAngle

OFFSET0 = Parameter("offset0", 1, "rad", "difference of the angles when the deformation is zero")


def _planar_hinge() -> Element:
    p, q = PlanarAngle("p"), PlanarAngle("q")
    return Element(
        name="planar_hinge",
        family="hinge",
        picture="hinge",
        nodes=(p, q),
        parameters=(OFFSET0,),
        deformations=(Deformation("angle", "rad", q.x[0] - p.x[0] - OFFSET0.symbol, free=True),),
        doc="angle = angle_q - angle_p - offset0 (counts turns)",
        source="SPACAR95 manual (Schwab and Meijaard 2000), PLHINGE",
    )


PLANAR_HINGE = _planar_hinge()
