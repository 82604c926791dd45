"""Angular velocity of a frame as three slips, in global axes and in a triad of the body.

They carry moments: the stress of a slip is the moment about its axis (a moment has no potential, a slip needs
none).
"""

from sympy import Matrix

from flexel.derive.declare import Element, Frame, Parameter, Slip
from flexel.derive.declare.rotation import angular_velocity, body_angular_velocity, product

T = Parameter("t", 4, "1", "unit quaternion from the body frame to the triad")


def _slips(w: Matrix) -> tuple[Slip, ...]:
    return tuple(Slip(name, "rad/s", w[i], free=True) for i, name in enumerate(("wx", "wy", "wz")))


def _rotation() -> Element:
    r = Frame("r")
    return Element(
        name="rotation",
        family="sensor",
        nodes=(r,),
        slips=_slips(angular_velocity(r.x, r.v)),
        doc="(wx, wy, wz) = 2 (lambdadot o conj(lambda)), angular velocity in global axes",
        source="Schwab and Meijaard 2006, DETC2006-99307",
    )


def _body_rotation() -> Element:
    r = Frame("r")
    u, ud = product(r.x, T.vector), product(r.v, T.vector)
    return Element(
        name="body_rotation",
        family="sensor",
        nodes=(r,),
        parameters=(T,),
        slips=_slips(body_angular_velocity(u, ud)),
        doc="u = lambda o t\n(wx, wy, wz) = 2 (conj(u) o udot), angular velocity in the axes of R(u)",
        source="Schwab and Meijaard 2006, DETC2006-99307",
    )


ROTATION = _rotation()
BODY_ROTATION = _body_rotation()
