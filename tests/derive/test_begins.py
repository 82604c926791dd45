"""Kinks of formulas: where steps end, found in the formula itself."""

import pytest
import sympy as sp
from sympy import Expr

from flexel.derive.begins import with_begins
from flexel.derive.declare import TIME, Law, symbol
from flexel.derive.general import general

E, ED = symbol("e"), symbol("ed")


def law(stress: Expr) -> Law:
    return Law("formula", "a formula", (), (E,), (ED,), (), (stress,), ())


@pytest.mark.parametrize(
    ("stress", "at"),
    [
        (1e4 * sp.Max(0, E - 0.3), [E - 0.3]),
        (sp.Piecewise((1e5 * (E + 0.9), E < -0.9), (0, True)), [E + 0.9]),
        (-1e5 * sp.Max(-E, 0) ** sp.Rational(3, 2), [E]),
        (50.0 * sp.Abs(ED - 0.2), [ED - 0.2]),
        (sp.Max(0, 200.0 * E + 3.0 * ED), [200.0 * E + 3.0 * ED]),
        (1e3 * (sp.Max(0, E - 0.1) - sp.Max(0, -E - 0.1)), [E - 0.1, E + 0.1]),
        (1e3 * E + 20.0 * E**3, []),
        (sp.Piecewise((3.0 * E, E < 0.5), (1.5 + 3.0 * (E - 0.5), True)), []),  # the pieces are one line
        (sp.Max(0, E**2 - 0.25), []),  # not linear
        (sp.Max(0, E - sp.sin(TIME)), []),  # changes with time
    ],
)
def test_kinks_of_a_formula_are_found(stress: Expr, at: list[Expr]) -> None:
    """With its numbers as parameters, and as they are; up to a factor."""
    shape, values = general(law(stress))
    numbers = dict(zip(shape.parameter_symbols, values, strict=True))
    for found in (with_begins(shape, values), with_begins(law(stress), ())):
        lines = [line.subs(numbers) for line in found.begins]
        assert len(lines) == len(at)
        assert all(any(sp.simplify(line / wanted).is_number for wanted in at) for line in lines)
