"""Periodic deformations: the period after which they repeat, and undeclared jumps.

The angle of atan2 jumps by 2 pi at its cut, where its second argument is negative. Whether the jump reaches a
deformation is determined by inserting numbers for the angle and
for the angle plus 2 pi; it must then be a whole number of the declared periods.
"""

import random
from collections.abc import Iterator, Mapping

import sympy as sp
from sympy import Expr, Symbol

from flexel.derive.declare.checks import check_symbols
from flexel.derive.declare.constants import Parameter
from flexel.derive.declare.deformations import Deformation
from flexel.derive.definition_errors import ElementError

Lets = tuple[tuple[Symbol, Expr], ...]
_ANGLE = Symbol("angle", real=True)
_DIGITS, _SAME = 30, 1e-12
_POINTS = 6
Term = tuple[float, tuple[tuple[str, int, int], ...]]


def check_period(owner: str, d: Deformation, let: Lets, parameters: tuple[Parameter, ...]) -> None:
    """Raise ElementError for a period that is not a sum of products, or a jump that is not a number of periods."""
    symbols = [s for p in parameters for s in p.symbols]
    if d.period is not None:
        check_symbols(owner, f"the period of '{d.name}'", sp.sympify(d.period), symbols)
        period_terms(d, parameters)
        if d.period == 0:
            return
    else:
        _check_quotients(owner, d, let, set(symbols))
    for angle, known in _angles(d.expr, let):
        if _never_negative(angle.args[1], dict(let)):
            continue
        found = list(_jumps(d, angle, known))
        wrong = [jump for jump, period in found if not _whole(jump, period)]
        if d.period is None and (wrong or not found):
            raise ElementError(
                f"{owner}: deformation '{d.name}' jumps where {angle} passes its cut; give Deformation(…, period=…), "
                "the jump for one turn (2*pi for an angle), or period=0 if it stays away from the cut"
            )
        if wrong:
            raise ElementError(
                f"{owner}: deformation '{d.name}' jumps by {float(abs(wrong[0])):.6g} at random values where {angle} "
                f"passes its cut; that is not a whole number of the period {d.period}: correct the period"
            )


def _check_quotients(owner: str, d: Deformation, let: Lets, constant: set[Symbol]) -> None:
    """Raise ElementError for the atan of a quotient whose divisor may change its sign."""
    needed, found = set(d.expr.free_symbols), d.expr.atoms(sp.atan)
    for s, value in reversed(let):
        if s in needed:
            needed |= value.free_symbols
            found |= value.atoms(sp.atan)
    for angle in sorted(found, key=sp.default_sort_key):
        y, x = sp.fraction(sp.together(angle.args[0]))
        if x.free_symbols - constant and not _never_negative(x, dict(let)):
            raise ElementError(
                f"{owner}: deformation '{d.name}' jumps where the divisor in {angle} is zero; write atan2({y}, {x}), "
                "and give period=…, or give period=0 if it stays away from there"
            )


def period_terms(d: Deformation, parameters: tuple[Parameter, ...]) -> tuple[Term, ...]:
    """Return the period as a sum of products; see `terms_of`."""
    return terms_of(sp.sympify(d.period or 0), parameters, f"deformation '{d.name}': the period")


def terms_of(expr: Expr, parameters: tuple[Parameter, ...], owner: str) -> tuple[Term, ...]:
    """Return a formula of parameters as a sum: of each term the number and the powers (parameter, component, exponent).

    Raises
    ------
    ElementError
        It is not a sum of products of integer powers of parameters.
    """
    where = {s: (p.name, i) for p in parameters for i, s in enumerate(p.symbols)}
    whole = sp.expand(expr)
    terms = []
    for term in sp.Add.make_args(whole) if whole != 0 else ():
        number, powers = sp.S.One, []
        for factor in sp.Mul.make_args(term):
            base, exponent = factor.as_base_exp()
            if factor.is_number:
                number *= factor
            elif base in where and exponent.is_Integer:
                powers.append((*where[base], int(exponent)))
            else:
                raise ElementError(
                    f"{owner} {expr} is not a sum of products of whole powers of parameters; give such a sum, with a "
                    "separate parameter for the rest"
                )
        terms.append((float(number), tuple(sorted(powers))))
    return tuple(sorted(terms, key=lambda term: (term[1], term[0])))


def _angles(expr: Expr, let: Lets) -> Iterator[tuple[Expr, Lets]]:
    """Yield every atan2 on which a formula depends, with the named intermediates."""
    needed, found = set(expr.free_symbols), expr.atoms(sp.atan2)
    for s, value in reversed(let):
        if s in needed:
            needed |= value.free_symbols
            found |= value.atoms(sp.atan2)
    for angle in sorted(found, key=sp.default_sort_key):
        yield angle, let


def _never_negative(expr: Expr, let: Mapping[Symbol, Expr]) -> bool:
    """Whether an expression is, by its form, nowhere negative."""
    if expr in let:
        return _never_negative(let[expr], let)
    if isinstance(expr, (sp.Add, sp.Mul)):
        return all(_never_negative(arg, let) for arg in expr.args)
    if isinstance(expr, sp.Pow) and expr.exp.is_Rational:
        return (
            expr.exp.q % 2 == 0
            or (expr.exp.q == 1 and expr.exp.p % 2 == 0)
            or _never_negative(expr.base, let)
        )
    return bool(isinstance(expr, (sp.exp, sp.Abs, sp.cosh)) or (expr.is_number and expr >= 0))


def _jumps(d: Deformation, angle: Expr, let: Lets) -> Iterator[tuple[Expr, Expr]]:
    """Yield the jumps of a deformation for a turn of the angle, and its periods, at random values of all symbols."""
    draw = random.Random(1)
    formulas = (d.expr, sp.sympify(d.period or 0), *(value for _, value in let))
    symbols = {s for expr in formulas for s in expr.free_symbols}
    plain = sorted(symbols - {s for s, _ in let}, key=str)
    for _ in range(_POINTS):
        values = {s: sp.Float(draw.uniform(0.5, 1.5), _DIGITS) for s in plain}
        start = sp.Float(draw.uniform(-3, 0), _DIGITS)
        ends = [_value(d.expr, angle, let, {**values, _ANGLE: end}) for end in (start, start + 2 * sp.pi)]
        if all(limit.is_number and limit.is_finite for limit in ends):
            yield ends[1] - ends[0], sp.sympify(d.period or 0).subs(values).evalf(_DIGITS)


def _value(expr: Expr, angle: Expr, let: Lets, values: Mapping[Symbol, Expr]) -> Expr:
    """Evaluate a formula in numbers, with one for the angle; intermediates are computed one after another."""
    known = dict(values)
    for s, value in let:
        known[s] = value.xreplace({angle: _ANGLE}).xreplace(known).evalf(_DIGITS)
    return expr.xreplace({angle: _ANGLE}).xreplace(known).evalf(_DIGITS)


def _whole(jump: Expr, period: Expr) -> bool:
    """Whether a jump is a whole number of periods; without a period it must be zero."""
    turns = sp.Integer(0) if period == 0 else sp.Integer(round(sp.re(jump / period)))
    return bool(abs(jump - turns * period) < _SAME * (1 + abs(jump)))
