"""Point mass and rigid body in the plane."""

from sympy import Matrix, cos, sin

from flexel.derive.declare import Element, Let, Output, Parameter, PlanarAngle, PlanarPoint
from flexel.derive.declare.rotation import HALF, dot
from flexel.derive.elements.picture_outputs import FRAME_DOC, frame
from flexel.derive.elements.shared_parameters import MASS, PLANAR_GRAVITY


def _planar_point_mass() -> Element:
    p = PlanarPoint("p")
    mass, g = MASS.symbol, PLANAR_GRAVITY.vector
    return Element(
        name="planar_point_mass",
        family="body",
        nodes=(p,),
        parameters=(MASS, PLANAR_GRAVITY),
        kinetic_energy=HALF * mass * dot(p.v, p.v),
        potential=-mass * dot(g, p.x),
        doc="T = mass v.v/2\nU = -mass gravity.x\nplace: x",
        source="textbook mechanics",
        outputs=(Output("place", "m", p.x, draws="mass"),),
    )


def _planar_body() -> Element:
    p, r = PlanarPoint("p"), PlanarAngle("r")
    offset = Parameter("c", 2, "m", "offset of the mass centre from p in body axes", ("x", "y"))
    inertia = Parameter("J", 1, "kg m^2", "moment of inertia about the mass centre")
    mass, g, c = MASS.symbol, PLANAR_GRAVITY.vector, offset.vector
    let = Let()
    co, si = let.scalar("cos_r", cos(r.x[0])), let.scalar("sin_r", sin(r.x[0]))
    b = let.vector("b", [co * c[0] - si * c[1], si * c[0] + co * c[1]])
    vc = let.vector("vc", p.v + Matrix([-b[1], b[0]]) * r.v[0])
    return Element(
        name="planar_body",
        family="body",
        picture="body",
        nodes=(p, r),
        parameters=(MASS, offset, inertia, PLANAR_GRAVITY),
        let=let.entries,
        kinetic_energy=HALF * (mass * dot(vc, vc) + inertia.symbol * r.v[0] ** 2),
        potential=-mass * dot(g, p.x + b),
        doc=(
            "b = R(angle) c,  vc = xdot + angledot (-b_y, b_x), velocity of the mass centre\n"
            "T = mass vc.vc/2 + J angledot^2/2\n"
            "U = -mass gravity.(x + b)\n"
            "centre: x + b" + FRAME_DOC.format(origin="x", axes="columns of R(angle)")
        ),
        source="textbook mechanics",
        outputs=(
            Output("centre", "m", p.x + b, draws="mass"),
            *frame(p.x, Matrix([co, si]), Matrix([-si, co])),
        ),
    )


PLANAR_POINT_MASS = _planar_point_mass()
PLANAR_BODY = _planar_body()
