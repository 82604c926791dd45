"""A point of a cable near the surface of a moving, rotating body: gap and sliding velocities at the rope's centre."""

from flexel.derive.declare import Element, Frame, Let, Parameter, Point, Slope
from flexel.derive.elements.arc_point import ARC_POINT, arc_point
from flexel.derive.elements.contact_surfaces import (
    DRAWN,
    HELICAL_GROOVE,
    OFFSET,
    SEEN,
    SURFACES,
    SurfaceKind,
    T,
    contact_outputs,
    seen,
)
from flexel.derive.elements.shared_parameters import L0

XI = Parameter("xi", 1, "1", "place along the element, from 0 at p to 1 at q")
ROPE_RADIUS = Parameter("rope_radius", 1, "m", "outer radius of the rope")


def _contact(surface: SurfaceKind) -> Element:
    p, dp, q, dq, c, r = Point("p"), Slope("dp"), Point("q"), Slope("dq"), Point("c"), Frame("r")
    let = Let()
    cable = (p, dp, q, dq)
    x, xd = arc_point(let, cable, XI.symbol)
    deformations, slips = surface.modes(let, seen(let, (c, r), x, xd, ROPE_RADIUS.symbol))
    return Element(
        name=f"cable_{surface.name}",
        family="contact",
        picture="contact",
        nodes=(*cable, c, r),
        parameters=(L0, XI, T, OFFSET, *surface.parameters, ROPE_RADIUS),
        let=let.entries,
        deformations=deformations,
        slips=slips,
        doc=ARC_POINT + SEEN + surface.doc.format(a="rope_radius", b="rope") + DRAWN,
        source="textbook mechanics",
        outputs=contact_outputs((c, r), x, (p, q)),
    )


CABLE_CYLINDER, CABLE_PLANE, CABLE_V_GROOVE, CABLE_ROUND_GROOVE = (_contact(surface) for surface in SURFACES)
CABLE_HELICAL_GROOVE = _contact(HELICAL_GROOVE)
