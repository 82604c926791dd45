"""Bearing: a hinge that also measures the relative displacement of its two points."""

from flexel.derive.declare import Deformation, Element, Frame, Let, Point
from flexel.derive.declare.rotation import components
from flexel.derive.elements.hinge import HINGE_DOC, hinge_deformations
from flexel.derive.elements.picture_outputs import LINK_DOC, axes, displacement
from flexel.derive.elements.shared_parameters import D0, TP, TQ
from flexel.derive.elements.triads import named_quaternion, named_triad


def _bearing() -> Element:
    p, rp, q, rq = Point("p"), Frame("rp"), Point("q"), Frame("rq")
    let = Let()
    u_p, u_q = named_quaternion(let, rp, TP, "p"), named_quaternion(let, rq, TQ, "q")
    triads = named_triad(let, u_p, "p"), named_triad(let, u_q, "q")
    hinge = hinge_deformations(let, u_p, u_q, *triads)
    d = let.vector("d", q.x - p.x)
    relative = components(triads[0], d) - D0.vector
    return Element(
        name="bearing",
        family="bearing",
        picture="bearing",
        nodes=(p, rp, q, rq),
        parameters=(TP, TQ, D0),
        let=let.entries,
        deformations=(
            *hinge,
            Deformation("axial", "m", relative[0]),
            Deformation("radial1", "m", relative[1]),
            Deformation("radial2", "m", relative[2]),
        ),
        doc=HINGE_DOC + "\nd = xq - xp\n(axial, radial1, radial2) = R(u_p)' d - d0" + LINK_DOC,
        source="SPACAR95 manual (Schwab and Meijaard 2000), BEARING",
        outputs=(axes(*triads[0]), displacement(relative)),
    )


BEARING = _bearing()
