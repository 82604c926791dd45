"""Lengths of a uniformly bent rod, for beams whose deformations are linear in the angle between their ends."""

from sympy import Expr, Rational


def shortening(square: Expr) -> Expr:
    """Return (1 - 2/phi sin(phi/2))/phi^2, which a uniform curvature takes from the length, as a function of phi^2.

    The chord of an arc of length l0 that turns by phi is l0 (1 - shortening phi^2).  Three terms of the series: an
    error of 4e-7 of the length at a quarter turn, of 1e-4 at half a turn.
    """
    return Rational(1, 24) - square * (Rational(1, 1920) - square * Rational(1, 322560))


def bow_stretch(shear: Expr, bow: Expr) -> Expr:
    """Return the length that a bow adds to the chord, over l0, to second order.

    Parameters
    ----------
    shear : Expr
        Shear number P of the plane of bending.
    bow : Expr
        Mean angle of the sections from the mean of the end sections; the shear angle is P times that.
    """
    return (Rational(3, 5) + shear) * bow**2
