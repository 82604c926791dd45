"""A point, or a sphere fixed in a body, near the surface of another moving, rotating body: gap and sliding velocities.

A point node alone has no rotation: it slides as its centre does, by the rule of ropes, whatever its radius. A sphere
fixed in a body turns with it: it slides with its material point at the contact.
"""

from flexel.derive.declare import Element, Frame, Let, Parameter, Point
from flexel.derive.declare.rotation import angular_velocity, combination, triad, triad_rate
from flexel.derive.elements.contact_surfaces import (
    BALL,
    DRAWN,
    OFFSET,
    ROLLING,
    SEEN,
    SPHERE_RADIUS,
    SURFACES,
    SurfaceKind,
    T,
    contact_outputs,
    seen,
)
from flexel.derive.elements.picture_outputs import axes

CENTRE = Parameter("centre", 3, "m", "centre of the sphere from p in the axes of its body", ("x", "y", "z"))


def _point(surface: SurfaceKind) -> Element:
    p, c, r = Point("p"), Point("c"), Frame("r")
    let = Let()
    deformations, slips = surface.modes(let, seen(let, (c, r), p.x, p.v, SPHERE_RADIUS.symbol))
    return Element(
        name=f"point_{surface.name}",
        family="contact",
        picture="contact",
        nodes=(p, c, r),
        parameters=(T, OFFSET, *surface.parameters, SPHERE_RADIUS),
        let=let.entries,
        deformations=deformations,
        slips=slips,
        doc="x: place of p\n" + SEEN + surface.doc.format(a="sphere_radius", b="point") + DRAWN,
        source="textbook mechanics",
        outputs=contact_outputs((c, r), p.x, (p,)),
    )


def _sphere(surface: SurfaceKind) -> Element:
    p, b, c, r = Point("p"), Frame("b"), Point("c"), Frame("r")
    let = Let()
    x = p.x + combination(triad(b.x), CENTRE.vector)
    xd = p.v + combination(triad_rate(b.x, b.v), CENTRE.vector)
    turning = let.vector("turning", angular_velocity(b.x, b.v))
    deformations, slips = surface.modes(let, seen(let, (c, r), x, xd, SPHERE_RADIUS.symbol, turning))
    return Element(
        name=f"sphere_{surface.name}",
        family="contact",
        picture="contact",
        nodes=(p, b, c, r),
        parameters=(CENTRE, T, OFFSET, *surface.parameters, SPHERE_RADIUS),
        let=let.entries,
        deformations=deformations,
        slips=slips,
        doc=(
            "x = xp + R(lambda_b) centre\n"
            + SEEN
            + ROLLING
            + surface.doc.format(a="sphere_radius", b="sphere")
            + DRAWN
            + BALL
        ),
        source="textbook mechanics",
        outputs=(*contact_outputs((c, r), x, (p,)), axes(*triad(b.x), of="_ball")),
    )


POINT_CONTACTS = tuple(_point(surface) for surface in SURFACES)
SPHERE_CONTACTS = tuple(_sphere(surface) for surface in SURFACES)
