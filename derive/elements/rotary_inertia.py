"""Rotary inertia of an orientation node, in space and in the plane."""

from sympy import Matrix

from flexel.derive.declare import Element, Frame, Let, Parameter, PlanarAngle
from flexel.derive.declare.rotation import HALF, body_angular_velocity, dot

TENSOR = Parameter(
    "J", 6, "kg m^2", "inertia tensor in body axes (tensor components)", ("xx", "yy", "zz", "xy", "xz", "yz")
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


def _planar_rotary_inertia() -> Element:
    r = PlanarAngle("r")
    return Element(
        name="planar_rotary_inertia",
        family="body",
        nodes=(r,),
        parameters=(MOMENT,),
        kinetic_energy=HALF * MOMENT.symbol * r.v[0] ** 2,
        doc="T = J angledot^2/2",
        source="textbook mechanics",
    )


ROTARY_INERTIA = _rotary_inertia()
PLANAR_ROTARY_INERTIA = _planar_rotary_inertia()
