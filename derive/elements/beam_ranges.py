"""The ranges in which beams are valid, and their shear angle.

The deformations of the classic beams are sines of angles times the length.  An end moment that turns the ends by phi
is EI sin phi/l0 in place of EI phi/l0, a torsional moment GJ sin 2 phi/(2 l0) in place of GJ phi/l0, and a bending
moment is too small by a fraction sin^2 gamma at a shear angle gamma, since curvature is measured times its cosine.
The angles themselves are measured here: a sine is also that of the supplement, and a beam that is folded back has the
deformations of a straight one.  The rotation vector of the logarithmic beams jumps after half a turn.
Source: Jonker and Meijaard 2013, Int. J. Non-Linear Mech. 53, for the deformations; this project, docs/beams.md.
"""

from collections.abc import Sequence

from sympy import Expr, Matrix, Max, atan2, pi, sin, sqrt

from flexel.derive.declare import Deformation, Output, ValidRange
from flexel.derive.declare.rotation import HALF, cross, dot
from flexel.derive.elements.shared_parameters import L0

DEGREES = 180 / pi
BENT = 15.0  # angle within one element [°] at which moments have errors of 1 % (bending) and 4.5 % (torsion)
SHEARED = 5.73  # shear angle [°], 0.1 rad, at which a bending moment is 1 % too small
TURNED = 150.0  # angle within one element in logarithmic rotations [°]
_REMEDY = "use {count} elements in place of each, or rotations='logarithmic'"


def shear_angle(pairs: Sequence[tuple[Deformation, Deformation, Expr]]) -> Output:
    """Return the angle of shear of the sections, from both bends in each plane and its shear number."""
    square = sum(
        (number / (1 + number) * (first.expr - second.expr) / (2 * L0.symbol)) ** 2
        for first, second, number in pairs
    )
    return Output("shear_angle", "rad", sqrt(square))


def classic_ranges(
    chord: Matrix, first: Sequence[Matrix], last: Sequence[Matrix], shear: Output
) -> tuple[ValidRange, ...]:
    """Return the ranges of bending, of twist in space, and of shear.

    Parameters
    ----------
    chord : Matrix
        Direction from p to q.
    first, last : sequence of Matrix
        Directions of the element at p and at q, that of the axis first.
    shear : Output
        The shear angle.
    """
    bend = _between(first[0], chord) + _between(last[0], chord)
    found = [_of_moments("bend", "is bent", bend, _missing(bend))]
    if len(first) > 2:
        s = HALF * (dot(first[2], last[1]) - dot(first[1], last[2]))
        c = HALF * (dot(first[1], last[1]) + dot(first[2], last[2]))
        twist = atan2(sqrt(s**2), c)
        found.append(_of_moments("twist", "is twisted", twist, _missing(2 * twist)))
    (gamma,) = shear.exprs
    beyond = (
        "is sheared by {value:.1f}°{where}: its moments are about {digits} % too small, whatever the number of "
        "elements; use rotations='logarithmic'"
    )
    values = Matrix([DEGREES * gamma, 100 * sin(gamma) ** 2])
    found.append(ValidRange("shear_range", "°", values, limit=SHEARED, beyond=beyond))
    return tuple(found)


def logarithmic_range(modes: Sequence[Deformation]) -> ValidRange:
    """Return the range of the rotation between the ends, whose components times l0 are sums of deformations."""
    _, torsion, *bends = (mode.value for mode in modes)
    turn = [torsion, bends[0] + bends[1], bends[2] + bends[3]]
    angle = DEGREES * sqrt(sum(part**2 for part in turn)) / L0.symbol
    beyond = (
        "has ends that are turned by {value:.0f}° relative to one another{where}; this may be {error:.0f}° the other "
        "way, since only angles below 180° are known within one element: use two elements in place of each"
    )
    return ValidRange("turn_range", "°", Matrix([angle, 360 - angle]), limit=TURNED, beyond=beyond)


def _of_moments(name: str, what: str, angle: Expr, missing: Expr) -> ValidRange:
    """Return the range of an angle [rad] by which moments are too small."""
    beyond = f"{what} by {{value:.0f}}°{{where}}: its moments are about {{digits}} % too small; {_REMEDY}"
    values = Matrix([DEGREES * angle, 100 * missing])
    return ValidRange(f"{name}_range", "°", values, limit=BENT, beyond=beyond)


def _between(a: Matrix, b: Matrix) -> Expr:
    """Return the angle between two unit vectors, from zero to half a turn."""
    across = [a[0] * b[1] - a[1] * b[0]] if len(a) == 2 else list(cross(a, b))
    return atan2(sqrt(sum(part**2 for part in across)), dot(a, b))


def _missing(angle: Expr) -> Expr:
    """Return the fraction by which the sine of an angle is smaller than the angle."""
    return (angle - sin(angle)) / Max(angle, 1e-9)
