"""Rotary inertia of an orientation node, in space and in the plane, and inertia of a warping node."""

from sympy import Matrix

from flexel.derive.declare import Element, Frame, Let, Node, Parameter, PlanarAngle, Warping
from flexel.derive.declare.rotation import HALF, body_angular_velocity, dot

TENSOR = Parameter(
    "J", 6, "kg m^2", "inertia tensor in body axes (tensor components)", ("xx", "yy", "zz", "xy", "xz", "yz")
)
OF_WARPING = Parameter(
    "J", 1, "kg m^4", "moment of inertia of warping: density times warping constant times length"
)
MOMENT = Parameter("J", 1, "kg m^2", "moment of inertia")


def _rotary_inertia() -> Element:
    r = Frame("r")
    xx, yy, zz, xy, xz, yz = TENSOR.symbols
    let = Let()
    w = let.vector("w", body_angular_velocity(r.x, r.v))
    return Element(
        name="rotary_inertia",
        family="body",
        nodes=(r,),
        parameters=(TENSOR,),
        let=let.entries,
        kinetic_energy=HALF * dot(w, Matrix([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]) * w),
        doc="w = 2 (conj(lambda) o lambdadot), angular velocity in body axes\nT = w.J w/2",
        source="Schwab and Meijaard 2006, DETC2006-99307",
    )


def _of_one_coordinate(
    name: str, family: str, node: Node, moment: Parameter, doc: str, source: str
) -> Element:
    """Return the inertia J of a node with one coordinate: T = J/2 times the square of its rate."""
    return Element(
        name=name,
        family=family,
        nodes=(node,),
        parameters=(moment,),
        kinetic_energy=HALF * moment.symbol * node.v[0] ** 2,
        doc=doc,
        source=source,
    )


ROTARY_INERTIA = _rotary_inertia()
PLANAR_ROTARY_INERTIA = _of_one_coordinate(
    "planar_rotary_inertia", "body", PlanarAngle("r"), MOMENT, "T = J angledot^2/2", "textbook mechanics"
)
WARPING_INERTIA = _of_one_coordinate(
    "warping_inertia",
    "",
    Warping("w"),
    OF_WARPING,
    "w: twist per length\nT = J wdot^2/2",
    "Vlasov 1961, Thin-walled elastic beams",
)
