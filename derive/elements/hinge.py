"""Hinge between two frames."""

from sympy import Matrix, atan2, pi

from flexel.derive.declare import Deformation, Element, Frame, Let
from flexel.derive.declare.rotation import conjugate, dot, product
from flexel.derive.elements.picture_outputs import axes
from flexel.derive.elements.shared_parameters import TP, TQ
from flexel.derive.elements.triads import Triad, named_quaternion, named_triad

HINGE_DOC = (
    "triads ex, ey, ez: columns of R(u_p), u_p = lambda_p o tp, and R(u_q), u_q = lambda_q o tq\n"
    "c = conj(u_p) o u_q\n"
    "angle = 2 atan2(c1, c0), period 2 pi\n"
    "bend1 = ez_p.ex_q,  bend2 = -ey_p.ex_q"
)


def hinge_deformations(let: Let, u_p: Matrix, u_q: Matrix, p: Triad, q: Triad) -> tuple[Deformation, ...]:
    """Return the angle about e_x and the two bendings of a hinge.

    Parameters
    ----------
    let : Let
        Receives the intermediates.
    u_p, u_q : Matrix, (4, 1)
        Quaternions of the triads at the two nodes.
    p, q : Triad
        The triads.
    """
    c = product(conjugate(u_p), u_q)
    c0, c1 = let.scalar("c0", c[0]), let.scalar("c1", c[1])
    return (
        Deformation("angle", "rad", 2 * atan2(c1, c0), free=True, period=2 * pi),
        Deformation("bend1", "1", dot(p[2], q[0])),
        Deformation("bend2", "1", -dot(p[1], q[0])),
    )


def _hinge() -> Element:
    p, q = Frame("p"), Frame("q")
    let = Let()
    u_p, u_q = named_quaternion(let, p, TP, "p"), named_quaternion(let, q, TQ, "q")
    triads = named_triad(let, u_p, "p"), named_triad(let, u_q, "q")
    deformations = hinge_deformations(let, u_p, u_q, *triads)
    return Element(
        name="hinge",
        family="hinge",
        picture="hinge",
        nodes=(p, q),
        parameters=(TP, TQ),
        let=let.entries,
        deformations=deformations,
        doc=HINGE_DOC + "\naxes: ex_p, ey_p, ez_p in rows",
        source="van der Werff and Jonker 1984; SPACAR95 manual (Schwab and Meijaard 2000), HINGE",
        outputs=(axes(*triads[0]),),
    )


HINGE = _hinge()
