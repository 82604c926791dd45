"""Cam with a flat-faced follower: where their normals agree, the face is at the value of the support function.

The support function h of a convex outline is the distance of its tangent from the centre, over the angle of the
tangent's normal; the outline is the envelope of these tangents, and touches each at the distance h' along it.
"""

from sympy import Abs, Expr, Matrix, Max, Rational, S, atan2, sqrt, zeros

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
from flexel.derive.elements.picture_outputs import frame
from flexel.derive.elements.planar_beam import ALPHA0, ALPHAQ0
from flexel.derive.elements.roller_cam import CONTROL, at_knots, drawn_profile, outline
from flexel.derive.elements.shared_parameters import TP, TQ
from flexel.derive.elements.triads import named_directions, named_quaternion, named_triad

_DOC = (
    "n: normal of the face, {normal};  (a, b) = components of n on {axes}\n"
    "psi = atan2(b, a), u = 48 psi/(2 pi), between i and i + 1; t = u - i\n"
    "h = sum over j = 0 ... 5 of control[(i + j - 2) mod 48] B_j(t), uniform B-splines of degree five\n"
    "gap = n.(xq - xp) - h{lean}\n"
    "profile: places h (cos psi, sin psi) + h' (-sin psi, cos psi) at the knots;  mark: from the centre to its start\n"
    "face: line across n, to both sides 1.2 times as far as the contact travels\n"
    "origin_p: xp, axes_p: {axes} in rows: the frame that carries profile and mark\n"
    "origin_q: xq, axes_q: n and the directions across it in rows: the frame that carries the face"
)
FACE = Rational(6, 5)  # half the length of a face as drawn, relative to the largest distance h' along it


def _drawn(p: Node, q: Node, cam: tuple[Matrix, ...], follower: tuple[Matrix, ...]) -> tuple[Output, ...]:
    """The outline of the cam, the envelope of its tangents; the face; and the frames that carry them."""
    slopes, across = at_knots(1), zeros(p.size, 1)
    # not evaluated: to find out that none of them is always the largest, SymPy needs half a minute
    across[1] = FACE * Max(*(Abs(slope) for slope in slopes), evaluate=False)
    face = Matrix.hstack(-across, across).T
    return (
        *drawn_profile(p.size, ("origin_p", "axes_p"), at_knots(), slopes),
        Output("face", "m", face, draws="rim", carrier=("origin_q", "axes_q")),
        *frame(p.x, *cam, of="_p"),
        *frame(q.x, *follower, of="_q"),
    )


def _element(
    name: str,
    nodes: tuple[Node, ...],
    turns: tuple[Parameter, Parameter],
    let: Let,
    axes: tuple[tuple[Matrix, ...], tuple[Matrix, ...]],
    normal: tuple[Expr, Expr],
    doc: str,
    lean: Expr = S.One,
) -> Element:
    """Return a cam from its axes, those of the follower, and the components of the face's normal in its plane.

    `lean` is the size of these components: one where the normal lies in the plane of the cam.
    """
    p, _, q, _ = nodes
    distance = dot(axes[1][0], let.vector("d", q.x - p.x))
    a, b = (let.scalar(letter, value) for letter, value in zip("ab", normal, strict=True))
    h = let.scalar("h", outline(let, let.scalar("psi", atan2(b, a))))
    return Element(
        name=name,
        nodes=nodes,
        parameters=(*turns, CONTROL),
        let=let.entries,
        deformations=(Deformation("gap", "m", distance - h * lean, period=0, kind="gap"),),
        doc=doc,
        source="support function of a convex cam; de Boor 1978, A Practical Guide to Splines",
        outputs=_drawn(p, q, *axes),
    )


def _cam() -> Element:
    nodes = _, rp, _, rq = Point("p"), Frame("rp"), Point("q"), Frame("rq")
    let = Let()
    cam = named_triad(let, named_quaternion(let, rp, TP, "p"), "p")
    follower = named_triad(let, named_quaternion(let, rq, TQ, "q"), "q")
    a, b = (
        let.scalar(f"n{letter}", dot(axis, follower[0])) for letter, axis in zip("ab", cam[:2], strict=True)
    )
    w = let.scalar("w", sqrt(a * a + b * b))
    doc = _DOC.format(
        normal="first column of R(lambda_q o tq)",
        axes="ex, ey, columns of R(lambda_p o tp)",
        lean=" sqrt(a^2 + b^2)",
    )
    return _element("flat_cam", nodes, (TP, TQ), let, (cam, follower), (a, b), doc, w)


def _planar_cam() -> Element:
    nodes = _, rp, _, rq = PlanarPoint("p"), PlanarAngle("rp"), PlanarPoint("q"), PlanarAngle("rq")
    let = Let()
    ex, ey = named_directions(let, rp, ALPHA0, "p")
    follower = named_directions(let, rq, ALPHAQ0, "q")
    doc = _DOC.format(normal="direction angle_q + alphaq0", axes="ex, ey (angle_p + alpha0)", lean="")
    normal = dot(ex, follower[0]), dot(ey, follower[0])
    return _element("planar_flat_cam", nodes, (ALPHA0, ALPHAQ0), let, ((ex, ey), follower), normal, doc)


FLAT_CAM = _cam()
PLANAR_FLAT_CAM = _planar_cam()
