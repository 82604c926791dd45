"""Cam: the centre of a follower's roller stays on the pitch curve, a periodic spline in polar coordinates."""

from math import comb, factorial

from sympy import Expr, Matrix, Piecewise, Rational, Symbol, atan2, cos, diff, pi, sin, sqrt

from flexel.derive.declare import (
    Deformation,
    Element,
    Frame,
    Let,
    Node,
    Output,
    Parameter,
    PlanarAngle,
    PlanarPoint,
    Point,
)
from flexel.derive.declare.rotation import dot
from flexel.derive.elements.picture_outputs import FRAME, FRAME_DOC, frame
from flexel.derive.elements.planar_beam import ALPHA0
from flexel.derive.elements.shared_parameters import TP
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
    "gap = r - outline\n"
    "profile: places outline (cos theta, sin theta) at the knots;  mark: from the centre to its start"
)


def basis(t: Expr) -> list[Expr]:
    """Return the six uniform B-splines of degree five that are not zero on a piece, t from 0 to 1 along it."""
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
    """Return the value of the periodic spline at an angle from -pi to pi."""
    u = let.scalar("u", theta * PIECES / (2 * pi))
    first = -(PIECES // 2)
    pieces = range(first, first + PIECES)

    def chosen(values: list[Expr]) -> Expr:
        """Choose the value of the piece in which u lies."""
        pairs = [(value, u < i + 1) for i, value in zip(pieces, values, strict=True)]
        return Piecewise(*pairs[:-1], (values[-1], True))

    t = let.scalar("t", u - chosen([Rational(i) for i in pieces]))
    controls = [
        let.scalar(f"c{j}", chosen([CONTROL.symbols[(i + j - 2) % PIECES] for i in pieces]))
        for j in range(DEGREE + 1)
    ]
    return sum((c * b for c, b in zip(controls, basis(t), strict=True)), Rational(0))


def at_knots(order: int = 0) -> list[Expr]:
    """Return the values of the periodic spline at its knots, from the angle zero on, or derivatives by the angle."""
    t = Symbol("t")
    weights = [diff(b, t, order).subs(t, 0) for b in basis(t)]
    return [
        (PIECES / (2 * pi)) ** order
        * sum((w * CONTROL.symbols[(k + j - 2) % PIECES] for j, w in enumerate(weights)), Rational(0))
        for k in range(PIECES)
    ]


def drawn_profile(
    size: int, carrier: tuple[str, str], along: list[Expr], across: list[Expr] | None = None
) -> tuple[Output, Output]:
    """Declare the closed profile of a cam, and the line to its start that shows the rotation, in the axes of the cam.

    Parameters
    ----------
    size : int
        Number of coordinates of a place.
    carrier : tuple of str
        Names of the outputs that are the frame of the cam.
    along, across : list of Expr
        Components of the places on the direction of each knot's angle, and on the normal to it (zero by default).
    """
    places = []
    for k in range(PIECES):
        c, s = cos(2 * pi * k / PIECES).evalf(20), sin(2 * pi * k / PIECES).evalf(20)
        a, b = along[k], across[k] if across else 0
        places.append(Matrix([a * c - b * s, a * s + b * c, 0][:size]))
    ring = Matrix.hstack(*places, places[0]).T
    mark = Matrix.hstack(0 * places[0], places[0]).T
    return (
        Output("profile", "m", ring, draws="rim", carrier=carrier),
        Output("mark", "m", mark, draws="valve", carrier=carrier),
    )


def _element(
    name: str, nodes: tuple[Node, ...], named: str, let: Let, axes: tuple[Matrix, ...], turn: Parameter
) -> Element:
    """Return a cam from the axes of its outline, the first two in its plane."""
    p, _, q = nodes
    d = let.vector("d", q.x - p.x)
    place = [dot(axis, d) for axis in axes[:2]]
    a, b = let.scalar("a", place[0]), let.scalar("b", place[1])
    radius = let.scalar("outline", outline(let, let.scalar("theta", atan2(b, a))))
    return Element(
        name=name,
        nodes=nodes,
        parameters=(turn, CONTROL),
        let=let.entries,
        deformations=(Deformation("gap", "m", sqrt(a * a + b * b) - radius, period=0, kind="gap"),),
        doc=_DOC.format(axes=named) + FRAME_DOC.format(origin="xp", axes=named),
        source="pitch curve of a radial cam; de Boor 1978, A Practical Guide to Splines",
        outputs=(*drawn_profile(p.size, FRAME, at_knots()), *frame(p.x, *axes)),
    )


def _cam() -> Element:
    nodes = _, rp, _ = Point("p"), Frame("rp"), Point("q")
    let = Let()
    axes = named_triad(let, named_quaternion(let, rp, TP, "p"), "p")
    return _element("roller_cam", nodes, "ex, ey, columns of R(lambda_p o tp)", let, axes, TP)


def _planar_cam() -> Element:
    nodes = _, rp, _ = PlanarPoint("p"), PlanarAngle("rp"), PlanarPoint("q")
    let = Let()
    axes = named_directions(let, rp, ALPHA0, "p")
    return _element("planar_roller_cam", nodes, "ex, ey (angle_p + alpha0)", let, axes, ALPHA0)


ROLLER_CAM = _cam()
PLANAR_ROLLER_CAM = _planar_cam()
