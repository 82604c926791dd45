"""Where a law given by a formula begins and ceases to act: the kinks of its stress, at which steps end."""

from collections.abc import Iterator, Sequence
from dataclasses import replace

import sympy as sp
from sympy import Expr

from flexel.derive.declare import Law
from flexel.derive.declare.law import begin_terms
from flexel.derive.definition_errors import ElementError
from flexel.derive.energy import margins

NEAR = 1e-7  # distance from a kink at which slopes are compared
BEND = 1e-5  # difference of slopes on both sides, relative to their size, from which a formula has a kink
PLACES = (0.137, -0.731)  # of the deformation or its rate, along a line of kinks


def with_begins(law: Law, values: Sequence[float]) -> Law:
    """Return a law of one deformation with the kinks of its stress that are linear in the deformation and its rate.

    Parameters
    ----------
    law : Law
    values : sequence of float
        Of its parameters.
    """
    numbers = dict(zip(law.parameter_symbols, map(sp.Float, values), strict=True))
    found = [
        margin for margin in margins(law.sigma[0]) if _is_linear(law, margin) and _bends(law, margin, numbers)
    ]
    return replace(law, begins=tuple(sorted(found, key=sp.default_sort_key)))


def _is_linear(law: Law, margin: Expr) -> bool:
    """Whether `Law.begins` may hold it."""
    if not margin.free_symbols <= {*law.e, *law.ed, *law.parameter_symbols}:
        return False
    try:
        begin_terms(law, margin)
    except (ElementError, sp.PolynomialError):
        return False
    return True


def _bends(law: Law, margin: Expr, numbers: dict[sp.Symbol, sp.Float]) -> bool:
    """Whether the slope of the stress jumps where a margin is zero."""
    return any(_jumps(*pair) for pair in _slopes(law, margin.subs(numbers), numbers))


def _slopes(law: Law, margin: Expr, numbers: dict[sp.Symbol, sp.Float]) -> Iterator[tuple[Expr, Expr]]:
    """Yield slopes of the stress on both sides of a line of kinks, at some of its places."""
    e, ed, sigma = law.e[0], law.ed[0], law.sigma[0].subs(numbers)
    across, along = (e, ed) if margin.diff(e) != 0 else (ed, e)
    for place in PLACES:
        line = margin.subs(along, place)
        at = -line.subs(across, 0) / line.diff(across)
        for slope in (sigma.diff(across), sigma.diff(along)):
            yield tuple(sp.N(slope.subs({along: place, across: at + side * NEAR})) for side in (-1, 1))


def _jumps(left: Expr, right: Expr) -> bool:
    """Whether two slopes differ by more than over a small distance."""
    if not (left.is_Float or left.is_zero) or not (right.is_Float or right.is_zero):
        return False
    return bool(abs(left - right) > BEND * (abs(left) + abs(right)))
