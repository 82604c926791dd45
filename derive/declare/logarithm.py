"""Logarithm of a relative rotation: its rotation vector, and half of the rotation, without a formula 0/0.

Rotations are Gibbs vectors tan(angle/2) n: that of half a rotation is (vector part)/(scalar part + norm) of the
quaternion with the scalar part that is not negative, the same for any multiple of the quaternion.
"""

from sympy import Expr, Matrix, Mul, Piecewise, Rational, sqrt

from flexel.derive.declare.let import Let
from flexel.derive.declare.rotation import cross, dot, norm

_TERMS = 12  # of the arc tangent: the first one left out is 6e-19 of the angle at half a turn
_HALVINGS = 2  # of half the rotation


def rotation_vector(let: Let, q: Matrix) -> tuple[Matrix, Matrix, Expr]:
    """Return the rotation vector of a quaternion, for angles below half a turn, and half of the rotation.

    The angle is halved by tan(a/2) = tan(a)/(1 + sqrt(1 + tan(a)^2)) until at most pi/16 remains, where the series of
    the arc tangent is exact to rounding, with its derivatives, at zero too.

    Returns
    -------
    vector : Matrix (3, 1)
        angle n [rad], the same for q and -q.
    half, square : Matrix (3, 1), Expr
        Gibbs vector of half the rotation, and its square.
    """
    sign = let.scalar("sign", Piecewise((-1, q[0] < 0), (1, True)))
    divisor = let.scalar("halving", sign * q[0] + norm(q))
    half = let.vector("half", [sign * q[i] / divisor for i in (1, 2, 3)])
    first = square = let.scalar("square", dot(half, half))
    divisors = []
    for i in range(_HALVINGS):
        divisors.append(let.scalar(f"halving_{i}", 1 + sqrt(1 + square)))
        square = let.scalar(f"square_{i}", square / divisors[-1] ** 2)
    series: Expr = Rational(0)
    for k in reversed(range(_TERMS)):
        series = Rational((-1) ** k, 2 * k + 1) + square * series
    factor = let.scalar("angle", 2 ** (_HALVINGS + 2) * series / Mul(*divisors))
    return let.vector("turn", factor * half), half, first


def turned_back(gibbs: Matrix, square: Expr, a: Matrix) -> Matrix:
    """Turn the column a (3, 1) back by the rotation with a Gibbs vector."""
    once = cross(gibbs, a)
    return a + (cross(gibbs, once) - once) * 2 / (1 + square)
