"""Cam with a flat-faced follower: where their normals agree, the face is at the value of the support function.

The support function h of a convex outline is the distance of its tangent from the centre, over the angle of the
tangent's normal; the outline is the envelope of these tangents, and touches each at the distance h' along it.
"""

from sympy import Expr, Matrix, S, atan2, sqrt

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
from flexel.derive.declare.rotation import dot
from flexel.derive.elements.parameters import TP, TQ
from flexel.derive.elements.planar_beam import ALPHA0, ALPHAQ0
from flexel.derive.elements.roller_cam import CONTROL, outline
from flexel.derive.elements.triads import named_directions, named_quaternion, named_triad

_DOC = (
    "n: normal of the face, {normal};  (a, b) = components of n on {axes}\n"
    "psi = atan2(b, a), u = 48 psi/(2 pi), between i and i + 1; t = u - i\n"
    "h = sum over j = 0 ... 5 of control[(i + j - 2) mod 48] B_j(t), uniform B-splines of degree five\n"
    "gap = n.(xq - xp) - h{lean}"
)


def _element(
    name: str,
    nodes: tuple[Node, ...],
    turns: tuple[Parameter, Parameter],
    let: Let,
    normal: tuple[Expr, Expr],
    distance: Expr,
    doc: str,
    lean: Expr = S.One,
) -> Element:
    """A cam from the components of the face's normal in its plane, and the distance of the face from the centre.

    `lean` is the size of these components: one where the normal lies in the plane of the cam.
    """
    a, b = (let.scalar(z, value) for z, value in zip("ab", normal, strict=True))
    h = let.scalar("h", outline(let, let.scalar("psi", atan2(b, a))))
    return Element(
        name=name,
        picture="flat cam",
        nodes=nodes,
        parameters=(*turns, CONTROL),
        let=let.entries,
        deformations=(Deformation("gap", "m", distance - h * lean, period=0, kind="gap"),),
        doc=doc,
        source="support function of a convex cam; de Boor 1978, A Practical Guide to Splines",
    )


def _cam() -> Element:
    nodes = p, rp, q, rq = Point("p"), Frame("rp"), Point("q"), Frame("rq")
    let = Let()
    ex, ey, _ = named_triad(let, named_quaternion(let, rp, TP, "p"), "p")
    n: Matrix = named_triad(let, named_quaternion(let, rq, TQ, "q"), "q")[0]
    a, b = let.scalar("na", dot(ex, n)), let.scalar("nb", dot(ey, n))
    w = let.scalar("w", sqrt(a * a + b * b))
    doc = _DOC.format(
        normal="first column of R(lambda_q o tq)",
        axes="ex, ey, columns of R(lambda_p o tp)",
        lean=" sqrt(a^2 + b^2)",
    )
    return _element("flat_cam", nodes, (TP, TQ), let, (a, b), dot(n, let.vector("d", q.x - p.x)), doc, w)


def _planar_cam() -> Element:
    nodes = p, rp, q, rq = PlanarPoint("p"), PlanarAngle("rp"), PlanarPoint("q"), PlanarAngle("rq")
    let = Let()
    ex, ey = named_directions(let, rp, ALPHA0, "p")
    n, _ = named_directions(let, rq, ALPHAQ0, "q")
    distance = dot(n, let.vector("d", q.x - p.x))
    doc = _DOC.format(normal="direction angle_q + alphaq0", axes="ex, ey (angle_p + alpha0)", lean="")
    return _element("planar_flat_cam", nodes, (ALPHA0, ALPHAQ0), let, (dot(ex, n), dot(ey, n)), distance, doc)


FLAT_CAM = _cam()
PLANAR_FLAT_CAM = _planar_cam()
