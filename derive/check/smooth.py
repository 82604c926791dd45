"""Smoothness checks: an element is differentiated three times, so that its functions have no kinks and no jumps."""

import random

import sympy as sp
from sympy import Expr, Symbol
from sympy.core.relational import Relational

from flexel.derive.declare.functions import KINKED


def check_smooth(owner: str, what: str, expr: Expr) -> None:
    """Raise ValueError for a function with a kink: an element is differentiated three times, a law once."""
    for part in sp.preorder_traversal(expr):
        if isinstance(part, KINKED):
            raise ValueError(
                f"{owner}: {what} contains {part}: it has a kink, and derivatives up to the third are needed; use "
                "sqrt(x**2 + eps**2), a Piecewise whose pieces join smoothly, or a law (for contact and friction)"
            )


def check_joins(owner: str, what: str, expr: Expr) -> None:
    """Raise ValueError for a Piecewise whose value or slope jumps where one piece ends and another begins.

    Checked at random points on the ends that are linear in some symbol, on both sides of them in 50 digits.
    """
    points = random.Random(1)
    for pieces in sorted(expr.atoms(sp.Piecewise), key=sp.default_sort_key):
        for relation in sorted(pieces.atoms(Relational), key=sp.default_sort_key):
            end = relation.lhs - relation.rhs
            for s in sorted(end.free_symbols, key=str):
                if end.diff(s, 2) != 0:
                    continue
                place = {z: sp.Float(points.uniform(0.5, 1.5), 50) for z in pieces.free_symbols - {s}}
                slope, offset = (sp.N(z.subs(place), 50) for z in (end.diff(s), end.subs(s, 0)))
                if slope != 0 and any(
                    _jumps(z.subs(place), s, -offset / slope) for z in (pieces, pieces.diff(s))
                ):
                    raise ValueError(
                        f"{owner}: {what}: the pieces of {pieces} do not join smoothly where {end} = 0; make value and "
                        "slope equal there"
                    )


def _jumps(expr: Expr, s: Symbol, at: Expr) -> bool:
    """Whether an expression of one symbol jumps there."""
    step = sp.Float(10, 50) ** -25
    left, right = (sp.N(expr.subs(s, at + side * step), 50) for side in (-1, 1))
    return bool(abs(left - right) > 1e-15 * (1 + abs(left)))
