"""Triads of the spatial elements and directions of the planar ones, as named intermediates computed once."""

from sympy import Expr, Matrix, atan2, cos, sin

from flexel.derive.declare import Let, Node, Parameter
from flexel.derive.declare.rotation import product, triad

Triad = tuple[Matrix, Matrix, Matrix]


def named_quaternion(let: Let, node: Node, t: Parameter, end: str) -> Matrix:
    """Name the quaternion u of the element's triad at a frame, lambda o t, ``u_p`` for the end p."""
    return let.vector(f"u_{end}", product(node.x, t.vector))


def named_triad(let: Let, u: Matrix, end: str) -> Triad:
    """Name the columns of R(u) ``ex_p``, ``ey_p``, ``ez_p`` for the end p."""
    ex, ey, ez = triad(u)
    return let.vector(f"ex_{end}", ex), let.vector(f"ey_{end}", ey), let.vector(f"ez_{end}", ez)


def named_directions(let: Let, node: Node, alpha0: Parameter, end: str) -> tuple[Matrix, Matrix]:
    """Name the directions e_x and e_y of a planar element at an angle node, turned by alpha0."""
    angle = node.x[0] + alpha0.symbol
    c, s = let.scalar(f"cos_{end}", cos(angle)), let.scalar(f"sin_{end}", sin(angle))
    return Matrix([c, s]), Matrix([-s, c])


def line_angle(let: Let, d: Matrix, start: Expr) -> Expr:
    """Return the angle of the column d (2, 1) from the direction `start`, in (-pi, pi]."""
    c, s = let.scalar("cos_0", cos(start)), let.scalar("sin_0", sin(start))
    return atan2(c * d[1] - s * d[0], c * d[0] + s * d[1])
