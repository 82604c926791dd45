"""Piecewise formulas: a stress must have a value on both sides of the end of a piece, and must not jump there.

Checked on the ends that are linear in a symbol, in exact arithmetic at two small distances: a difference that stays
the same when the distance shrinks is a jump, one that shrinks too is a steep slope.
"""

from collections.abc import Iterator

import sympy as sp
from sympy import Expr, Rational, Symbol
from sympy.core.relational import Relational

NEAR, NEARER = 10**20, 10**40  # reciprocal distances from an end at which a jump is looked for
FAR = 10  # and at which the size of the stress is taken
ROUNDED = 1e-6  # largest jump, relative to the size of the stress around it: rounded data pass
DIGITS = 60


def check_branches(owner: str, sigma: Expr, symbols: tuple[Symbol, ...]) -> None:
    """Raise a ValueError for a formula that has no value beyond an end of its pieces, or jumps there."""
    exact = _exact(sigma)
    for s, place in _ends(exact, symbols):
        line, at = exact.subs({z: v for z, v in place.items() if z != s}), place[s]
        sides = [[_value(line, s, at, side, far) for side in (-1, 1)] for far in (NEAR, NEARER, FAR)]
        if any(z is None for z in sides[1]):
            raise ValueError(
                f"{owner}: {sigma} has no value on one side of {s} = {float(at):g}; give every case a piece, the last "
                "one with the condition True"
            )
        values = [[0j if z is None else z for z in pair] for pair in sides]
        if any(z.imag for pair in values for z in pair):
            continue  # at the end of a root's or a logarithm's range
        first, second = (abs(right - left) for left, right in values[:2])
        if second > max(ROUNDED * max(abs(z) for pair in values for z in pair), first / 2):
            raise ValueError(
                f"{owner}: {sigma} jumps at {s} = {float(at):g}; make the pieces join, or smooth the jump, such as by "
                "tanh(ed/v) in place of sign(ed)"
            )


def _exact(expr: Expr) -> Expr:
    """The formula with fractions for floating-point numbers, so that places beside an end compare exactly."""
    return expr.xreplace({z: Rational(z) for z in expr.atoms(sp.Float)})


def _ends(sigma: Expr, symbols: tuple[Symbol, ...]) -> Iterator[tuple[Symbol, dict[Symbol, Expr]]]:
    """Where pieces of the formula end: the symbol that passes the end, and the place of all symbols."""
    ends = [z.lhs - z.rhs for z in sigma.atoms(Relational)]
    ends += [z.args[0] for z in sigma.atoms(sp.sign, sp.Heaviside)]
    for end in sorted(set(ends), key=sp.default_sort_key):
        for s in symbols:
            others = {z: Rational(137 + 100 * i, 1000) for i, z in enumerate(symbols) if z != s}
            slope = end.diff(s).subs(others)
            if slope.is_number and slope != 0:
                at = -end.subs({**others, s: 0}) / slope
                yield s, {**others, s: at if at.is_Rational else Rational(sp.N(at, 2 * DIGITS))}


def _value(line: Expr, s: Symbol, at: Expr, side: int, distance: int) -> complex | None:
    """Value of a formula of one symbol beside a place; None where it has none."""
    found = line.subs(s, at + Rational(side, distance))
    value = sp.N(found, DIGITS)
    if value.is_infinite:
        return complex(float("inf"))
    return None if value is sp.nan else complex(value)
