"""A point, or a disc fixed in a body, near a circle or a line on another body of the plane: gap and sliding velocity.

The planar counterparts of the cylinder and of the plane in ``point_contact``.
"""

from sympy import Matrix, cos, sin

from flexel.derive.declare import Element, Let, Parameter, PlanarAngle, PlanarPoint
from flexel.derive.elements.contact_surfaces import BALL, DRAWN, SPHERE_RADIUS
from flexel.derive.elements.picture_outputs import axes as axes_drawn
from flexel.derive.elements.picture_outputs import planar_axes
from flexel.derive.elements.planar_beam import ALPHA0
from flexel.derive.elements.planar_contact_surfaces import (
    PLANAR_OFFSET,
    PLANAR_ROLLING,
    PLANAR_SEEN,
    PLANAR_SURFACES,
    PlanarSurface,
    planar_contact_outputs,
    planar_seen,
)

PLANAR_CENTRE = Parameter("centre", 2, "m", "centre of the disc from p in the axes of its body", ("x", "y"))


def _planar_point(surface: PlanarSurface) -> Element:
    p, c, r = PlanarPoint("p"), PlanarPoint("c"), PlanarAngle("r")
    let = Let()
    touching, axes = planar_seen(let, (c, r), p.x, p.v, SPHERE_RADIUS.symbol)
    deformations, slips = surface.modes(let, touching, axes)
    return Element(
        name=f"planar_point_{surface.name}",
        family="contact",
        picture="contact",
        nodes=(p, c, r),
        parameters=(ALPHA0, PLANAR_OFFSET, *surface.parameters, SPHERE_RADIUS),
        let=let.entries,
        deformations=deformations,
        slips=slips,
        doc="x: place of p\n" + PLANAR_SEEN + surface.doc.format(a="sphere_radius", turn="") + DRAWN,
        source="planar counterpart of contact in space",
        outputs=planar_contact_outputs((c, r), p.x, (p,)),
    )


def _disc(surface: PlanarSurface) -> Element:
    p, b, c, r = PlanarPoint("p"), PlanarAngle("b"), PlanarPoint("c"), PlanarAngle("r")
    let = Let()
    co, si = let.scalar("cos_b", cos(b.x[0])), let.scalar("sin_b", sin(b.x[0]))
    right, up = PLANAR_CENTRE.vector
    arm = let.vector("centre_arm", [co * right - si * up, si * right + co * up])
    x, xd = p.x + arm, p.v + b.v[0] * Matrix([-arm[1], arm[0]])
    touching, axes = planar_seen(let, (c, r), x, xd, SPHERE_RADIUS.symbol, b.v[0])
    deformations, slips = surface.modes(let, touching, axes)
    return Element(
        name=f"planar_disc_{surface.name}",
        family="contact",
        picture="contact",
        nodes=(p, b, c, r),
        parameters=(PLANAR_CENTRE, ALPHA0, PLANAR_OFFSET, *surface.parameters, SPHERE_RADIUS),
        let=let.entries,
        deformations=deformations,
        slips=slips,
        doc=(
            "x = xp + R(angle_b) centre\n"
            + PLANAR_SEEN
            + PLANAR_ROLLING
            + surface.doc.format(a="sphere_radius", turn=surface.rolling)
            + DRAWN
            + BALL
        ),
        source="planar counterpart of contact in space",
        outputs=(*planar_contact_outputs((c, r), x, (p,)), axes_drawn(*planar_axes(b.x[0]), of="_ball")),
    )


PLANAR_POINT_CONTACTS = tuple(_planar_point(surface) for surface in PLANAR_SURFACES)
PLANAR_DISC_CONTACTS = tuple(_disc(surface) for surface in PLANAR_SURFACES)
