"""The point of a cable that touches a surface, on a curve that follows an arc, and its velocity.

The cubic between two nodes of an arc lies inside it when its slopes have the length of the stretch: by 60 µm for
elements of half a radius of 0.5 m, where a rope is pressed 200 µm into its groove. With slopes that are longer by
tan(θ/4)/(θ/4), where θ is the angle between them, the cubic meets the arc in its middle too, and is off it by a
multiple of θ⁶.
"""

from sympy import Expr, Matrix, Rational

from flexel.derive.declare import Let, Node
from flexel.derive.declare.rotation import dot
from flexel.derive.declare.shape import hermite_weights
from flexel.derive.elements.shared_parameters import L0

ARC_POINT = (
    "x: point at the fraction xi of the cubic curve through p and q with the slopes h dp and h dq,\n"
    "h = 1 + D/48 + 13 D^2/5760, D = |dq - dp|^2: tan(theta/4)/(theta/4) for the angle theta between unit slopes\n"
)


def arc_point(let: Let, nodes: tuple[Node, Node, Node, Node], xi: Expr) -> tuple[Matrix, Matrix]:
    """Return the position x of the point at the fraction xi of the cable p, dp, q, dq, and its rate."""
    p, dp, q, dq = nodes
    weights = [let.scalar(f"n{i}", w) for i, w in enumerate(hermite_weights(xi, L0.symbol))]
    turn = let.vector("turn", dq.x - dp.x)
    square = let.scalar("square_turn", dot(turn, turn))
    longer = let.scalar("longer", 1 + square / 48 + square**2 * Rational(13, 5760))
    handles = let.vector("handles", weights[1] * dp.x + weights[3] * dq.x)
    handle_rates = weights[1] * dp.v + weights[3] * dq.v
    rate: Expr = (Rational(1, 24) + square * Rational(13, 1440)) * dot(turn, dq.v - dp.v)
    x = weights[0] * p.x + weights[2] * q.x + longer * handles
    return x, weights[0] * p.v + weights[2] * q.v + longer * handle_rates + let.scalar("rate", rate) * handles
