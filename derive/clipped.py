"""Powers of numbers that may be negative: real formulas set their base to zero there."""

from dataclasses import replace

import sympy as sp
from sympy import Expr, Symbol

from flexel.derive.declare import Law


def clipped(expr: Expr, symbols: set[Symbol], above: int = 0) -> Expr:
    """Set to zero the negative bases, of some symbols, of powers that are no whole number and larger than a number."""
    return expr.replace(
        lambda part: (
            part.is_Pow
            and part.exp.is_Rational
            and not part.exp.is_Integer
            and part.exp > above
            and bool(part.base.free_symbols & symbols)
        ),
        lambda part: sp.Max(part.base, 0) ** part.exp,
    )


def with_clipped_pieces(law: Law) -> Law:
    """Clip the powers in the pieces of a law's formulas, which the derivatives evaluate beyond these pieces too.

    A slope there would be zero times no number; powers of one or less have no slope at zero, and stay.
    """
    symbols = {
        *law.e,
        *law.ed,
        *law.s,
        *(s for p in law.parameters for s in p.symbols),
        *(s for s, _ in law.let),
    }

    def pieces(expr: Expr) -> Expr:
        return sp.sympify(expr).replace(
            lambda part: isinstance(part, sp.Piecewise),
            lambda part: sp.Piecewise(
                *((clipped(value, symbols, 1), condition) for value, condition in part.args)
            ),
        )

    return replace(
        law,
        sigma=tuple(map(pieces, law.sigma)),
        tau=tuple(map(pieces, law.tau)),
        energy=pieces(law.energy),
        let=tuple((symbol, pieces(value)) for symbol, value in law.let),
    )
