"""Compliant tyre on a smooth road: its deflection, its camber and its velocities, for laws to act on.

Nothing here is a force. Unlike the rigid wheel it has no contact node: the contact point lies where the plane of
the wheel meets the road, straight below the axle. A law may read one velocity (the centre's, for the slip angle) and
put its force on another (the contact point's, for the moment arm).
"""

from dataclasses import dataclass

import sympy as sp
from sympy import Expr, Matrix, Piecewise, Rational, cos, pi, sin, sqrt

from flexel.derive.declare import Deformation, Element, Frame, Let, Node, Parameter, Point, Slip
from flexel.derive.declare.rotation import angular_velocity, combination, cross, dot, norm, triad
from flexel.derive.elements.picture_outputs import FRAME_DOC, frame
from flexel.derive.elements.wheel import AXLE, CROWN, HEIGHT, NORMAL

RADIUS = Parameter("radius", 1, "m", "radius of the unloaded tyre")
AMPLITUDE = Parameter("amplitude", 1, "m", "height of the waves of the road, trough to crest")
WAVELENGTH = Parameter("wavelength", 1, "m", "length of one wave")
START = Parameter("start", 1, "m", "where the first wave begins, along the heading of the waves")
WAVES = Parameter("waves", 1, "1", "how many waves there are; flat before and behind")
HEADING = Parameter("heading", 2, "1", "horizontal unit vector along which the road rises", ("x", "y"))
ROLL_AXLES = (
    Parameter("axle_p", 3, "1", "unit vector along the axle of p in its body axes", ("x", "y", "z")),
    Parameter("axle_q", 3, "1", "unit vector along the axle of q in its body axes", ("x", "y", "z")),
)

_DOC = (
    "w wheel centre, a = R(lambda) axle, n = normal of the road below w, h = distance of w from the tangent plane\n"
    "an = |a x n|,  ex = a x n/an forward,  ey = n x ex sideways\n"
    "length = (h - crown)/an in the plane of the wheel\n"
    "r = -length (n - (a.n) a)/an - crown n, from the centre to the contact point\n"
    "deflection = R - crown - ({distance} - crown)/an;  drop = R - {distance};  camber = atan2(a.n, an)\n"
    "omega = 2 (lambdadot o conj(lambda)),  vc = xdot_w + omega x r, the material point in contact\n"
    "forward = ex.xdot_w,  sideways = ey.xdot_w,  rolling = omega.a,\n"
    "longitudinal = ex.vc,  lateral = ey.vc,  spin = omega.n"
)


@dataclass(frozen=True)
class Road:
    """The road below a wheel centre: unit normal, distance to the tangent plane, distance that `drop` counts."""

    parameters: tuple[Parameter, ...]
    n: Matrix
    h: Expr
    distance: Expr
    doc: str
    slope: Matrix | None = None


def _plane(w: Node) -> Road:
    """Return the plane normal.x = height."""
    h = dot(NORMAL.vector, w.x) - HEIGHT.symbol
    return Road((NORMAL, HEIGHT), NORMAL.vector, h, h, _DOC.format(distance="h"))


def _waves(let: Let, w: Node) -> Road:
    """Return the road z(x, y) of one or more cosine waves, flat elsewhere.

    It is once continuously differentiable at the two ends, with a step of the curvature there, and smooth elsewhere.
    """
    wavelength, amplitude = WAVELENGTH.symbol, AMPLITUDE.symbol
    along = let.scalar("along", dot(HEADING.vector, Matrix(w.x[:2])) - START.symbol)
    on = sp.And(along > 0, along < WAVES.symbol * wavelength)
    phase = let.scalar("phase", Piecewise((2 * pi * along / wavelength, on), (0, True)))
    z = let.scalar("z", HEIGHT.symbol + amplitude * Rational(1, 2) * (1 - cos(phase)))
    rise = let.scalar("rise", amplitude * pi / wavelength * sin(phase))
    slope = rise * HEADING.vector
    nz = let.scalar("nz", 1 / sqrt(1 + dot(slope, slope)))
    n = let.vector("n", [-nz * slope[0], -nz * slope[1], nz])
    above = let.scalar("above", w.x[2] - z)
    doc = (
        "road: z = height + amplitude (1 - cos(2 pi s/wavelength))/2 with s = heading.(x, y) - start between 0 and\n"
        "waves wavelength, z = height elsewhere (C1 at the ends, smooth between);  z up\n"
        "the springs count the vertical distance, so that their force is normal to the road\n"
        + _DOC.format(distance="(w_z - z)")
        + "\ngrade = slope of the road along ex, rise for horizontal length times |horizontal part of ex|"
    )
    parameters = (HEIGHT, AMPLITUDE, WAVELENGTH, START, WAVES, HEADING)
    return Road(parameters, n, above * nz, above, doc, slope)


def _tyre(name: str, road: Road, let: Let, w: Node, body: Node) -> Element:
    n = road.n
    a = let.vector("a", combination(triad(body.x), AXLE.vector))
    h = let.scalar("height_above", road.h)
    lean = let.scalar("lean", dot(a, n))
    ahead = let.vector("ahead", cross(a, n))
    an = let.scalar("an", norm(ahead))
    ex = let.vector("ex", ahead / an)
    ey = let.vector("ey", cross(n, ex))
    crown = CROWN.symbol
    length = let.scalar("length", (h - crown) / an)
    r = let.vector("d", -length / an * (n - lean * a) - crown * n)
    omega = let.vector("omega", angular_velocity(body.x, body.v))
    vc = let.vector("vc", w.v + cross(omega, r))
    deformations = [
        Deformation("deflection", "m", RADIUS.symbol - crown - (road.distance - crown) / an, free=True),
        Deformation("drop", "m", RADIUS.symbol - road.distance, free=True),
        Deformation("camber", "rad", sp.atan2(lean, an), free=True),
    ]
    if road.slope is not None:
        grade = road.slope[0] * ex[0] + road.slope[1] * ex[1]
        deformations.append(Deformation("grade", "1", grade, free=True))
    return Element(
        name=name,
        family="tyre",
        picture="tyre",
        nodes=(w, body),
        parameters=(RADIUS, CROWN, AXLE, *road.parameters),
        let=let.entries,
        deformations=tuple(deformations),
        slips=(
            Slip("forward", "m/s", dot(ex, w.v), free=True),
            Slip("sideways", "m/s", dot(ey, w.v), free=True),
            Slip("rolling", "rad/s", dot(omega, a), free=True),
            Slip("longitudinal", "m/s", dot(ex, vc), free=True),
            Slip("lateral", "m/s", dot(ey, vc), free=True),
            Slip("spin", "rad/s", dot(omega, n), free=True),
        ),
        doc=road.doc + FRAME_DOC.format(origin="w", axes="columns of R(lambda)"),
        source="Frik, Leister, Schwartz 1993, Vehicle System Dynamics 22 suppl. (frames and slip angle of the wheel)",
        outputs=frame(w.x, *triad(body.x)),
    )


def _flat() -> Element:
    w = Point("w")
    return _tyre("tyre", _plane(w), Let(), w, Frame("r"))


def _on_road() -> Element:
    w, let = Point("w"), Let()
    return _tyre("tyre_on_road", _waves(let, w), let, w, Frame("r"))


def _axle_slip() -> Element:
    """Return the mean of the lateral velocities of two wheels where they touch a plane road."""
    ends = (Point("p"), Frame("rp")), (Point("q"), Frame("rq"))
    let, n = Let(), NORMAL.vector
    lateral: list[Expr] = []
    for (w, body), axle in zip(ends, ROLL_AXLES, strict=True):
        end = w.name
        a = let.vector(f"a_{end}", combination(triad(body.x), axle.vector))
        h, lean = dot(n, w.x) - HEIGHT.symbol, let.scalar(f"lean_{end}", dot(a, n))
        ahead = let.vector(f"ahead_{end}", cross(a, n))
        an = let.scalar(f"an_{end}", norm(ahead))
        ey = let.vector(f"ey_{end}", cross(n, ahead) / an)
        r = let.vector(f"d_{end}", -h / an**2 * (n - lean * a))
        omega = let.vector(f"omega_{end}", angular_velocity(body.x, body.v))
        lateral.append(dot(ey, w.v + cross(omega, r)))
    return Element(
        name="axle_slip",
        family="tyre",
        nodes=tuple(node for end in ends for node in end),
        parameters=(*ROLL_AXLES, NORMAL, HEIGHT),
        let=let.entries,
        slips=(Slip("lateral", "m/s", Rational(1, 2) * (lateral[0] + lateral[1])),),
        doc=(
            "lateral = mean of ey.vc of the two wheels, each as in the element tyre; zero: an axle that rolls without\n"
            "slipping sideways in the mean"
        ),
        source="Schwab, talk on SPACAR (zero lateral slip of the road vehicle)",
    )


TYRE = _flat()
TYRE_ON_ROAD = _on_road()
AXLE_SLIP = _axle_slip()
