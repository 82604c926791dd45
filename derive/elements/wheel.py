"""Rigid wheel rolling on a plane: a knife edge, or with a round crown."""

from sympy import Expr, Matrix

from flexel.derive.declare import Deformation, Element, Frame, Let, Parameter, Point, Slip
from flexel.derive.declare.rotation import angular_velocity, combination, cross, dot, norm, triad
from flexel.derive.elements.picture_outputs import FRAME_DOC, force, frame

RADIUS = Parameter("radius", 1, "m", "radius of the rim")
AXLE = Parameter("axle", 3, "1", "unit vector along the axle in body axes", ("x", "y", "z"))
NORMAL = Parameter("normal", 3, "1", "unit normal of the road", ("x", "y", "z"))
HEIGHT = Parameter("height", 1, "m", "distance of the road from the origin along its normal")
CROWN = Parameter("crown", 1, "m", "radius of the cross section of the tyre, a circle")


def _slips(let: Let, wheel: tuple[Matrix, Matrix, Matrix], arm: Matrix, ra: Matrix) -> tuple[Slip, ...]:
    """Return the slips from the hub's velocity, Euler parameters and their rates, the arm to the contact, and r x a."""
    hub_v, lam, lam_v = wheel
    n = NORMAL.vector
    omega = let.vector("omega", angular_velocity(lam, lam_v))
    vc = let.vector("vc", hub_v + cross(omega, arm))
    across = let.vector("across", cross(n, ra))

    def along(direction: Matrix, name: str) -> Expr:
        return dot(direction, vc) / let.scalar(name, norm(direction))

    return (
        Slip("longitudinal", "m/s", along(ra, "ra_length")),
        Slip("lateral", "m/s", along(across, "across_length")),
        Slip("spin", "rad/s", dot(omega, n), free=True),
    )


def _rolling(name: str, crown: Parameter | None, doc: str, source: str) -> Element:
    """Return a wheel whose contact point lies below its rim, or below the centre of the tube of its tyre."""
    w, body, c = Point("w"), Frame("r"), Point("c")
    n, let = NORMAL.vector, Let()
    a = let.vector("a", combination(triad(body.x), AXLE.vector))
    arm = let.vector("arm" if crown else "d", c.x - w.x)
    r = let.vector("d", arm + crown.symbol * n) if crown else arm
    rim = let.scalar("rim", RADIUS.symbol - crown.symbol) if crown else RADIUS.symbol
    ra = let.vector("ra", cross(r, a))
    slips = _slips(let, (w.v, body.x, body.v), arm, ra)
    return Element(
        name=name,
        family="wheel",
        picture="wheel",
        nodes=(w, body, c),
        parameters=(RADIUS, *([crown] if crown else []), AXLE, NORMAL, HEIGHT),
        let=let.entries,
        deformations=(
            Deformation("radius", "m", (dot(r, r) - rim**2) / (2 * rim)),
            Deformation("plane", "m", dot(a, r)),
            Deformation("surface", "m", dot(n, c.x) - HEIGHT.symbol, kind="touch"),
            Deformation("lowest", "m", dot(n, ra)),
        ),
        slips=slips,
        doc=(
            doc
            + "\nforce: of the road on hub and contact point"
            + FRAME_DOC.format(origin="xw", axes="columns of R(lambda)")
        ),
        source=source,
        outputs=(force(w, c), *frame(w.x, *triad(body.x))),
    )


_SLIPS = "longitudinal = ra.vc/|ra|,  lateral = (n x ra).vc/|n x ra|,  spin = omega.n"

WHEEL = _rolling(
    "wheel",
    None,
    "w hub, c contact point, d = xc - xw, a = R(lambda) axle, n = normal, ra = d x a\n"
    "radius = (d.d - R^2)/(2 R),  plane = a.d,  surface = n.xc - height,  lowest = n.ra\n"
    "omega = 2 (lambdadot o conj(lambda)),  vc = xdot_w + omega x d, the material point in contact\n"
    + _SLIPS,
    "Meijaard, Papadopoulos, Ruina and Schwab 2007, Proc. R. Soc. A 463:1955, supplement, WHEEL",
)
TOROIDAL_WHEEL = _rolling(
    "toroidal_wheel",
    CROWN,
    "w hub, c contact point, d = xc + crown n - xw from the hub to the centre of the tube above the contact,\n"
    "a = R(lambda) axle, n = normal, ra = d x a, rim = R - crown\n"
    "radius = (d.d - rim^2)/(2 rim),  plane = a.d,  surface = n.xc - height,  lowest = n.ra\n"
    "omega = 2 (lambdadot o conj(lambda)),  vc = xdot_w + omega x (xc - xw), the material point in contact\n"
    + _SLIPS,
    "Schwab and Meijaard 1999, ASME DETC99/VIB-8223 (wheel element); the crown lifts the contact off the rim's circle",
)
