"""A point of a planar cable near a circle or a line on a moving, rotating body: gap and sliding velocity.

The planar counterparts of the cylinder and of the plane in ``rope_contact``.
"""

from flexel.derive.declare import Element, Let, PlanarAngle, PlanarPoint, PlanarSlope
from flexel.derive.elements.arc_point import ARC_POINT, arc_point
from flexel.derive.elements.contact_surfaces import DRAWN
from flexel.derive.elements.planar_beam import ALPHA0
from flexel.derive.elements.planar_contact_surfaces import (
    PLANAR_OFFSET,
    PLANAR_SEEN,
    PLANAR_SURFACES,
    PlanarSurface,
    planar_contact_outputs,
    planar_seen,
)
from flexel.derive.elements.rope_contact import ROPE_RADIUS, XI
from flexel.derive.elements.shared_parameters import L0


def _planar_contact(surface: PlanarSurface) -> Element:
    p, dp, q, dq = PlanarPoint("p"), PlanarSlope("dp"), PlanarPoint("q"), PlanarSlope("dq")
    c, r = PlanarPoint("c"), PlanarAngle("r")
    let = Let()
    cable = (p, dp, q, dq)
    x, xd = arc_point(let, cable, XI.symbol)
    touching, axes = planar_seen(let, (c, r), x, xd, ROPE_RADIUS.symbol)
    deformations, slips = surface.modes(let, touching, axes)
    return Element(
        name=f"planar_cable_{surface.name}",
        family="contact",
        picture="contact",
        nodes=(*cable, c, r),
        parameters=(L0, XI, ALPHA0, PLANAR_OFFSET, *surface.parameters, ROPE_RADIUS),
        let=let.entries,
        deformations=deformations,
        slips=slips,
        doc=ARC_POINT + PLANAR_SEEN + surface.doc.format(a="rope_radius", turn="") + DRAWN,
        source="planar counterpart of contact in space",
        outputs=planar_contact_outputs((c, r), x, (p, q)),
    )


PLANAR_CABLE_CIRCLE, PLANAR_CABLE_LINE = (_planar_contact(surface) for surface in PLANAR_SURFACES)
