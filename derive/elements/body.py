"""Point mass and rigid body in space."""

from sympy import Matrix

from flexel.derive.declare import Element, Frame, Let, Output, Parameter, Point
from flexel.derive.declare.rotation import HALF, body_angular_velocity, combination, dot, triad, triad_rate
from flexel.derive.elements.picture_outputs import FRAME_DOC, frame
from flexel.derive.elements.shared_parameters import GRAVITY, MASS


def _point_mass() -> Element:
    p = Point("p")
    mass, g = MASS.symbol, GRAVITY.vector
    return Element(
        name="point_mass",
        family="body",
        nodes=(p,),
        parameters=(MASS, GRAVITY),
        kinetic_energy=HALF * mass * dot(p.v, p.v),
        potential=-mass * dot(g, p.x),
        doc="T = mass v.v/2\nU = -mass gravity.x\nplace: x",
        source="textbook mechanics",
        outputs=(Output("place", "m", p.x, draws="mass"),),
    )


def _body() -> Element:
    p, r = Point("p"), Frame("r")
    offset = Parameter("c", 3, "m", "offset of the mass centre from p in body axes", ("x", "y", "z"))
    tensor = Parameter(
        "J",
        6,
        "kg m^2",
        "inertia tensor about the mass centre in body axes (tensor components)",
        ("xx", "yy", "zz", "xy", "xz", "yz"),
    )
    mass, g = MASS.symbol, GRAVITY.vector
    xx, yy, zz, xy, xz, yz = tensor.symbols
    inertia = Matrix([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
    let = Let()
    w = let.vector("w", body_angular_velocity(r.x, r.v))
    vc = let.vector("vc", p.v + combination(triad_rate(r.x, r.v), offset.vector))
    centre = p.x + combination(triad(r.x), offset.vector)
    return Element(
        name="body",
        family="body",
        picture="body",
        nodes=(p, r),
        parameters=(MASS, offset, tensor, GRAVITY),
        let=let.entries,
        kinetic_energy=HALF * (mass * dot(vc, vc) + dot(w, inertia * w)),
        potential=-mass * dot(g, centre),
        doc=(
            "vc = xdot + d(R(lambda) c)/dt, velocity of the mass centre\n"
            "w = 2 (conj(lambda) o lambdadot), angular velocity in body axes\n"
            "T = mass vc.vc/2 + w.J w/2\n"
            "U = -mass gravity.(x + R(lambda) c)\n"
            "centre: x + R(lambda) c" + FRAME_DOC.format(origin="x", axes="columns of R(lambda)")
        ),
        source="Schwab and Meijaard 2006, DETC2006-99307",
        outputs=(Output("centre", "m", centre, draws="mass"), *frame(p.x, *triad(r.x))),
    )


POINT_MASS = _point_mass()
BODY = _body()
