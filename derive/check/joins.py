"""Piecewise formulas: they must have a value on both sides of the end of a piece, and must not jump there.

Checked on the ends that are linear in a symbol, in exact arithmetic at two small distances: a difference that stays
the same when the distance shrinks is a jump, one that shrinks too is a steep slope.
"""

from collections.abc import Iterator

import sympy as sp
from sympy import Expr, Rational, Symbol
from sympy.core.relational import Relational

NEAR, NEARER = 10**20, 10**40  # reciprocal distances from an end at which a jump is looked for
FAR = 10  # and at which the size of the formula is taken
ROUNDED = 1e-6  # largest jump of a law, relative to the size of the stress around it: rounded data pass
EXACT = 1e-15  # of an element, which is differentiated three times
DIGITS = 60


def check_law_joins(owner: str, sigma: Expr) -> None:
    """Raise a ValueError for a stress that has no value beyond an end of its pieces, or jumps there."""
    for s, end, line, at in _ends(sigma):
        if _jumps(f"{owner}: {sigma}", line, s, end, at, ROUNDED):
            raise ValueError(
                f"{owner}: {sigma} jumps at {s} = {float(at):g}; make the pieces join, or smooth the jump, for "
                "example with tanh(ed/v) instead of sign(ed)"
            )


def check_element_joins(owner: str, what: str, expr: Expr) -> None:
    """Raise a ValueError for a Piecewise whose value or slope jumps where one piece ends and another begins."""
    for pieces in sorted(expr.atoms(sp.Piecewise), key=sp.default_sort_key):
        for s, end, line, at in _ends(pieces):
            if any(
                _jumps(f"{owner}: {what}: {pieces}", function, s, end, at, EXACT)
                for function in (line, line.diff(s))
            ):
                raise ValueError(
                    f"{owner}: {what}: the pieces of {pieces} do not join smoothly where {end} = 0; make value and "
                    "slope equal there"
                )


def _ends(expr: Expr) -> Iterator[tuple[Symbol, Expr, Expr, Expr]]:
    """Yield where a formula's pieces end: the symbol passing the end, the end, the symbol's formula, and its value."""
    exact = expr.xreplace(
        {number: Rational(number) for number in expr.atoms(sp.Float)}
    )  # places beside an end compare exactly
    symbols = sorted(exact.free_symbols, key=str)
    ends = [relation.lhs - relation.rhs for relation in exact.atoms(Relational)]
    ends += [function.args[0] for function in exact.atoms(sp.sign, sp.Heaviside)]
    for end in sorted(set(ends), key=sp.default_sort_key):
        for s in symbols:
            others = {
                symbol: Rational(137 + 100 * i, 1000) for i, symbol in enumerate(symbols) if symbol != s
            }
            slope = end.diff(s).subs(others)
            if slope.is_number and slope != 0:
                at = -end.subs({**others, s: 0}) / slope
                yield s, end, exact.subs(others), at if at.is_Rational else Rational(sp.N(at, 2 * DIGITS))


def _jumps(what: str, line: Expr, s: Symbol, end: Expr, at: Expr, allowed: float) -> bool:
    """Whether a formula of one symbol jumps at a place; raises a ValueError where it has no value beside it."""
    sides = [[_value(line, s, at, side, far) for side in (-1, 1)] for far in (NEAR, NEARER, FAR)]
    if any(side is None for side in sides[1]):
        where = f"{s} = {float(at):g}" if end.free_symbols == {s} else f"{end} = 0"
        raise ValueError(
            f"{what} has no value on one side of {where}; give every case a piece, the last one with the condition True"
        )
    values = [[0j if value is None else value for value in pair] for pair in sides]
    if any(value.imag for pair in values for value in pair):
        return False  # at the end of a root's or a logarithm's range
    first, second = (abs(right - left) for left, right in values[:2])
    return second > max(allowed * max(abs(value) for pair in values for value in pair), first / 2)


def _value(line: Expr, s: Symbol, at: Expr, side: int, distance: int) -> complex | None:
    """Return the value of a formula of one symbol next to a point; None where it has none."""
    value = sp.N(line.subs(s, at + Rational(side, distance)), DIGITS)
    if value.is_infinite:
        return complex(float("inf"))
    return None if value is sp.nan else complex(value)
