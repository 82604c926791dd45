"""Cam: the centre of a follower's roller stays on the pitch curve, a periodic spline in polar coordinates."""

from math import comb, factorial

from sympy import Expr, Matrix, Piecewise, Rational, atan2, pi, sqrt

from flexel.derive.declare import (
    Deformation,
    Element,
    Frame,
    Let,
    Node,
    Parameter,
    PlanarAngle,
    PlanarPoint,
    Point,
)
from flexel.derive.declare.rotation import components, dot
from flexel.derive.elements.parameters import TP
from flexel.derive.elements.planar_beam import ALPHA0
from flexel.derive.elements.triads import named_directions, named_quaternion, named_triad

PIECES, DEGREE = 48, 5
CONTROL = Parameter(
    "control",
    PIECES,
    "m",
    "control values of the periodic spline of degree five, its knots at equal steps of the angle",
    tuple(str(k) for k in range(PIECES)),
)
_DOC = (
    "(a, b) = components of xq - xp on {axes}, r = sqrt(a^2 + b^2), theta = atan2(b, a)\n"
    "u = 48 theta/(2 pi), between i and i + 1; t = u - i\n"
    "outline = sum over j = 0 ... 5 of control[(i + j - 2) mod 48] B_j(t), uniform B-splines of degree five\n"
    "gap = r - outline"
)


def basis(t: Expr) -> list[Expr]:
    """The six uniform B-splines of degree five that are not zero on a piece, t from 0 to 1 along it."""
    n = DEGREE + 1
    return [
        sum(
            ((-1) ** k * comb(n, k) * (t + DEGREE - j - k) ** DEGREE for k in range(DEGREE - j + 1)),
            Rational(0),
        )
        / factorial(DEGREE)
        for j in range(n)
    ]


def outline(let: Let, theta: Expr) -> Expr:
    """Value of the periodic spline at an angle from -pi to pi."""
    u = let.scalar("u", theta * PIECES / (2 * pi))
    first = -(PIECES // 2)
    pieces = range(first, first + PIECES)

    def chosen(values: list[Expr]) -> Expr:
        """The value that belongs to the piece in which u lies."""
        pairs = [(value, u < i + 1) for i, value in zip(pieces, values, strict=True)]
        return Piecewise(*pairs[:-1], (values[-1], True))

    t = let.scalar("t", u - chosen([Rational(i) for i in pieces]))
    controls = [
        let.scalar(f"c{j}", chosen([CONTROL.symbols[(i + j - 2) % PIECES] for i in pieces]))
        for j in range(DEGREE + 1)
    ]
    return sum((c * b for c, b in zip(controls, basis(t), strict=True)), Rational(0))


def _element(
    name: str, nodes: tuple[Node, ...], axes: str, let: Let, place: Matrix, turn: Parameter
) -> Element:
    """A cam from the components of the roller's place in its plane, in body axes."""
    a, b = let.scalar("a", place[0]), let.scalar("b", place[1])
    radius = let.scalar("outline", outline(let, let.scalar("theta", atan2(b, a))))
    return Element(
        name=name,
        picture="cam",
        nodes=nodes,
        parameters=(turn, CONTROL),
        let=let.entries,
        deformations=(Deformation("gap", "m", sqrt(a * a + b * b) - radius, period=0, kind="gap"),),
        doc=_DOC.format(axes=axes),
        source="pitch curve of a radial cam; de Boor 1978, A Practical Guide to Splines",
    )


def _cam() -> Element:
    nodes = p, rp, q = Point("p"), Frame("rp"), Point("q")
    let = Let()
    axes = named_triad(let, named_quaternion(let, rp, TP, "p"), "p")
    place = components(axes, let.vector("d", q.x - p.x))
    return _element("roller_cam", nodes, "ex, ey, columns of R(lambda_p o tp)", let, place, TP)


def _planar_cam() -> Element:
    nodes = p, rp, q = PlanarPoint("p"), PlanarAngle("rp"), PlanarPoint("q")
    let = Let()
    ex, ey = named_directions(let, rp, ALPHA0, "p")
    d = let.vector("d", q.x - p.x)
    return _element(
        "planar_roller_cam", nodes, "ex, ey (angle_p + alpha0)", let, Matrix([dot(ex, d), dot(ey, d)]), ALPHA0
    )


ROLLER_CAM = _cam()
PLANAR_ROLLER_CAM = _planar_cam()
