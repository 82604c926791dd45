"""Powers of numbers that may be negative or zero: real formulas, whose derivatives are numbers there."""

from dataclasses import replace

import sympy as sp
from sympy import Expr, Symbol

from flexel.derive.declare import Law


def clipped(expr: Expr, symbols: set[Symbol], above: int = 0) -> Expr:
    """Set to zero the negative bases, of some symbols, of powers that are no whole number and larger than a number."""
    return expr.replace(
        lambda part: (
            part.is_Pow
            and part.exp.is_number
            and part.exp > above
            and part.exp != int(part.exp)
            and bool(part.base.free_symbols & symbols)
        ),
        lambda part: sp.Max(part.base, 0) ** part.exp,
    )


def joined(expr: Expr) -> Expr:
    """Join products such as x |x|^(1/2) into one power of |x|, with the sign of x where it is odd.

    At zero, their slope by the rule of products would be zero times infinity.
    """
    return expr.replace(lambda part: part.is_Mul, _joined_product)


def _joined_product(product: Expr) -> Expr:
    for power in product.args:
        base, exponent = power.as_base_exp()
        if not (isinstance(base, sp.Abs) and exponent.is_number and exponent < 1 and not exponent.is_integer):
            continue
        rest = product / power
        factors = rest.as_powers_dict()
        for x in (base.args[0], -base.args[0]):
            odd = sp.sympify(factors.get(x, 0))
            if odd.is_Integer and odd > 0 and odd + exponent > 0:
                sign = sp.sign(x) if odd % 2 else 1
                return joined(rest / x**odd) * sign * base ** (odd + exponent)
    return product


def with_real_powers(law: Law) -> Law:
    """Join the powers in a law's formulas, and clip those in pieces, which derivatives evaluate beyond these too.

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
        return joined(sp.sympify(expr)).replace(
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
