"""Rigid knife-edge wheel rolling on a plane."""

from sympy import Expr, Matrix

from flexel.derive.element import Deformation, Element, Frame, Let, Parameter, Point, Slip
from flexel.derive.rotation import angular_velocity, combination, cross, dot, norm, triad

RADIUS = Parameter("radius", 1, "m", "radius of the rim")
AXLE = Parameter("axle", 3, "1", "unit vector along the axle in body axes", ("x", "y", "z"))
NORMAL = Parameter("normal", 3, "1", "unit normal of the road", ("x", "y", "z"))
HEIGHT = Parameter("height", 1, "m", "distance of the road from the origin along its normal")


def _slips(let: Let, wheel: tuple[Matrix, Matrix, Matrix], r: Matrix, ra: Matrix) -> tuple[Slip, ...]:
    """Slips from the velocity of the hub, the Euler parameters and their rates, r and r x a."""
    hub_v, lam, lam_v = wheel
    n = NORMAL.vector
    omega = let.vector("omega", angular_velocity(lam, lam_v))
    vc = let.vector("vc", hub_v + cross(omega, r))
    across = let.vector("across", cross(n, ra))

    def along(direction: Matrix, name: str) -> Expr:
        return dot(direction, vc) / let.scalar(name, norm(direction))

    return (
        Slip("longitudinal", "m/s", along(ra, "ra_length")),
        Slip("lateral", "m/s", along(across, "across_length")),
        Slip("spin", "rad/s", dot(omega, n), free=True),
    )


def _wheel() -> Element:
    w, frame, c = Point("w"), Frame("r"), Point("c")
    radius, n = RADIUS.symbol, NORMAL.vector
    let = Let()
    a = let.vector("a", combination(triad(frame.x), AXLE.vector))
    r = let.vector("d", c.x - w.x)
    ra = let.vector("ra", cross(r, a))
    slips = _slips(let, (w.v, frame.x, frame.v), r, ra)
    return Element(
        name="wheel",
        nodes=(w, frame, c),
        parameters=(RADIUS, AXLE, NORMAL, HEIGHT),
        let=let.entries,
        deformations=(
            Deformation("radius", "m", (dot(r, r) - radius**2) / (2 * radius)),
            Deformation("plane", "m", dot(a, r)),
            Deformation("surface", "m", dot(n, c.x) - HEIGHT.symbol),
            Deformation("lowest", "m", dot(n, ra)),
        ),
        slips=slips,
        doc=(
            "w hub, c contact point, d = xc - xw, a = R(lambda) axle, n = normal, ra = d x a\n"
            "radius = (d.d - R^2)/(2 R),  plane = a.d,  surface = n.xc - height,  lowest = n.ra\n"
            "omega = 2 (lambdadot o conj(lambda)),  vc = xdot_w + omega x d, the material point in contact\n"
            "longitudinal = ra.vc/|ra|,  lateral = (n x ra).vc/|n x ra|,  spin = omega.n"
        ),
        source="Meijaard, Papadopoulos, Ruina and Schwab 2007, Proc. R. Soc. A 463:1955, supplement, WHEEL",
    )


WHEEL = _wheel()
