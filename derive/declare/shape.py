"""Shape functions of the beams, and their exact integrals over the length.

Everything is a rational function of the shear number P (12 EI / (k G A l0^2)
of the plane of bending) that is computed once, exactly, from the shape functions themselves.
"""

from functools import cache

import sympy as sp
from sympy import Expr, Matrix, Rational, Symbol
from sympy.integrals.quadrature import gauss_legendre

from flexel.derive.declare.rotation import dot

_XI = Symbol("xi")
_P = Symbol("P")

# Consistent mass of the cubic Hermite interpolation on (r_p, l0 r'_p, r_q, l0 r'_q), over rhoA l0.
HERMITE_MASS = Matrix([[156, 22, 54, -13], [22, 4, 13, -3], [54, 13, 156, -22], [-13, -3, -22, 4]]) / 420


def shear_number(EI: Expr, GA: Expr, l0: Expr) -> Expr:
    """Return the shear number P of a plane of bending; zero where the section does not shear."""
    return 12 * EI / (GA * l0**2)


@cache
def rotary_gram() -> tuple[tuple[Expr, ...], ...]:
    """Return the Gram matrix of the section's rotation, times (1 + P)^2, as polynomials in P (symbol `P`).

    The rotation is [6 xi (1 - xi) c + (1 - 4 xi + 3 xi^2 + P (1 - xi)) w_p + (3 xi^2 - 2 xi + P xi) w_q]/(1 +
    P) with c the rate of the chord's direction and w_p, w_q the angular velocities of the ends (Timoshenko
    beam with the cubic interpolation that is exact for end loads; Przemieniecki 1968).
    """
    xi, shear = _XI, _P
    shapes = (
        6 * xi * (1 - xi),
        1 - 4 * xi + 3 * xi**2 + shear * (1 - xi),
        3 * xi**2 - 2 * xi + shear * xi,
    )
    return tuple(tuple(sp.Poly(_mean(a * b), shear).as_expr() for b in shapes) for a in shapes)


def _mean(polynomial: Expr) -> Expr:
    """Integrate over xi from 0 to 1, term by term: the general integration takes a second."""
    return sum((c / (power + 1) for (power,), c in sp.Poly(polynomial, _XI).terms()), sp.Integer(0))


def rotary_energy(shear: Expr, chord: Expr, wp: Expr, wq: Expr) -> Expr:
    """Return the mean square of the section's angular velocity about a transverse axis, ``∫ w(xi)^2 dxi``.

    Parameters
    ----------
    shear : Expr
        Shear number P of the plane of bending.
    chord : Expr
        Angular velocity of the chord about the axis, so with the present distance of the ends.
    wp, wq : Expr
        Angular velocities of the ends about the axis.
    """
    w = (chord, wp, wq)
    gram = [[sp.horner(g) if g.has(_P) else g for g in row] for row in rotary_gram()]
    terms = [gram[i][i] * w[i] ** 2 for i in range(3)]
    terms += [2 * gram[i][j] * w[i] * w[j] for i in range(3) for j in range(i + 1, 3)]
    return sp.Add(*terms).xreplace({_P: shear}) / (1 + shear) ** 2


def linear_energy(vp: Matrix, vq: Matrix) -> Expr:
    """Return the mean square of a linearly interpolated vector, times 3: vp.vp + vp.vq + vq.vq."""
    return dot(vp, vp) + dot(vp, vq) + dot(vq, vq)


def hermite_energy(columns: tuple[Matrix, Matrix, Matrix, Matrix]) -> Expr:
    """Return the mean square of a cubically interpolated vector given by (r_p, l0 r'_p, r_q, l0 r'_q)."""
    terms = []
    for i in range(4):
        terms.append(HERMITE_MASS[i, i] * dot(columns[i], columns[i]))
        terms += [2 * HERMITE_MASS[i, j] * dot(columns[i], columns[j]) for j in range(i + 1, 4)]
    return sp.Add(*terms)


def hermite_mean(xp: Matrix, slope_p: Matrix, xq: Matrix, slope_q: Matrix) -> Matrix:
    """Return the mean of a cubically interpolated vector; the slopes are multiplied by the length."""
    return (xp + xq) / 2 + (slope_p - slope_q) * Rational(1, 12)


def hermite_slopes(d: Matrix, slope_p: Matrix, slope_q: Matrix, l0: Expr, xi: Expr) -> tuple[Matrix, Matrix]:
    """Return the first two derivatives by arc length, at the fraction xi of l0, of a cubic curve from p to q = p + d.

    Parameters
    ----------
    d : Matrix
        Difference of the end positions.
    slope_p, slope_q : Matrix
        Derivatives by arc length at the ends.
    """
    chord = d / l0
    first = 6 * xi * (1 - xi) * chord + (1 - xi) * (1 - 3 * xi) * slope_p + xi * (3 * xi - 2) * slope_q
    second = ((6 - 12 * xi) * chord + (6 * xi - 4) * slope_p + (6 * xi - 2) * slope_q) / l0
    return first, second


def hermite_weights(xi: Expr, l0: Expr) -> tuple[Expr, Expr, Expr, Expr]:
    """Return the factors of (r_p, r'_p, r_q, r'_q) in the position at the fraction xi of a cubic curve of length l0."""
    rest = 1 - xi
    return rest**2 * (1 + 2 * xi), l0 * xi * rest**2, xi**2 * (3 - 2 * xi), -l0 * xi**2 * rest


def hermite_points(p: Matrix, slope_p: Matrix, q: Matrix, slope_q: Matrix, l0: Expr, places: int) -> Matrix:
    """Return points (places, 3) at equal steps on a cubic curve of length l0, from its ends and slopes by length."""
    rows = []
    for i in range(places):
        weights = hermite_weights(Rational(i, places - 1), l0)
        columns = zip(weights, (p, slope_p, q, slope_q), strict=True)
        rows.append(sum((weight * column for weight, column in columns), sp.zeros(*p.shape)).T)
    return Matrix.vstack(*rows)


@cache
def gauss_points(count: int) -> tuple[Expr, ...]:
    """Return the points of Gauss's quadrature on (0, 1), ascending, to 50 digits."""
    places, _ = gauss_legendre(count, 50)
    return tuple((1 + place) / 2 for place in places)
