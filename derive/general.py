"""A law with its numbers as parameters, so that formulas that differ in numbers are one compiled law."""

from collections.abc import Iterator
from dataclasses import replace

import sympy as sp
from sympy import Basic, Expr, Symbol

from flexel.derive.declare import Law, Parameter, symbol
from flexel.derive.spec import FORMULA_NUMBERS


def general(law: Law) -> tuple[Law, tuple[float, ...]]:
    """Return the law with its numbers replaced by one parameter, and their values.

    Parameters
    ----------
    law : Law
        A law without parameters, internal states and named intermediates.

    Returns
    -------
    law : Law
        The same law itself where there is no number.
    values : tuple of float
        Exponents, -1, 0 and 1 belong to the structure of a formula; they remain in place.
    """
    found: list[float] = []
    sigma = tuple(_replaced(expr, found) for expr in law.sigma)
    energy = _replaced(law.energy, found)
    if not found:
        return law, ()
    parameter = Parameter(FORMULA_NUMBERS, len(found), "1", "numbers of the formula")
    by_place = dict(zip(map(_place, range(len(found))), parameter.symbols, strict=True))
    shape = replace(
        law,
        doc=f"{law.name} with its numbers as parameters",
        parameters=(parameter,),
        sigma=tuple(expr.xreplace(by_place) for expr in sigma),
        energy=energy.xreplace(by_place),
    )
    return shape, tuple(found)


def _place(number: int) -> Symbol:
    """Return the placeholder of a number until their count is known."""
    return symbol(f"number_at_{number}")


def _replaced(expr: Expr, found: list[float]) -> Expr:
    """Replace the numbers of an expression by symbols; their values are added to those found."""
    if expr.is_Number:
        if expr in (-1, 0, 1) or not expr.is_finite:
            return expr
        found.append(float(expr))
        return _place(len(found) - 1)
    if expr.is_Atom:
        return expr
    if expr.is_Pow:
        return sp.Pow(_replaced(expr.base, found), expr.exp)
    return expr.func(*(_replaced(part, found) for part in _ordered(expr)))


def _ordered(expr: Expr) -> Iterator[Basic]:
    """Sort the parts of an expression in an order that does not depend on its numbers."""
    if not (expr.is_Add or expr.is_Mul or isinstance(expr, (sp.Min, sp.Max))):
        return iter(expr.args)
    return iter(sorted(expr.args, key=lambda part: sp.default_sort_key(_masked(part))))


def _masked(expr: Basic) -> Basic:
    """Replace all numbers of an expression but exponents by one and the same symbol."""
    if isinstance(expr, sp.Number):
        return expr if expr in (-1, 0, 1) else symbol("number")
    if not expr.args:
        return expr
    if isinstance(expr, sp.Pow):
        return sp.Pow(_masked(expr.base), expr.exp, evaluate=False)
    return expr.func(*(_masked(part) for part in expr.args))
