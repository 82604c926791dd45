"""The energy that a stress of one deformation stores: its integral from zero, in closed form or by Gauss's rule."""

from collections.abc import Iterator
from itertools import combinations, pairwise

import numpy as np
import sympy as sp
from sympy import Expr, Symbol
from sympy.core.relational import Relational

from flexel.derive.clipped import clipped
from flexel.derive.declare.functions import FUNCTIONS, KINKED

PLACES = 64  # of each width, at which a closed form is compared with the stress: even, so not at zero
SLOPE = 1e-6  # relative error of its slope
MOSTLY = 0.9  # part of the places at which the slope must be right: not at kinks
POINTS = 16  # of Gauss's rule, between two kinks
_KNOWN = (*FUNCTIONS, *KINKED, sp.Piecewise)


def closed_form(stress: Expr, e: Symbol) -> Expr | None:
    """Integrate from zero to e with rational numbers; None where SymPy finds nothing that can be compiled."""
    exact = stress.replace(lambda part: part.is_Float, lambda part: sp.Rational(repr(float(part))))
    # the other methods of SymPy take minutes for some formulas, and find functions that have no kernel
    try:
        found = sp.integrate(exact, (e, 0, e), meijerg=False, heurisch=False)
    except (NotImplementedError, sp.PolynomialError):
        return None
    if not isinstance(found, Expr):
        return None
    found = found.rewrite([sp.asinh, sp.acosh, sp.atanh], sp.log)
    if found.has(sp.Integral, sp.nan, sp.oo, sp.zoo, sp.I) or found.atoms(sp.Function) - found.atoms(*_KNOWN):
        return None
    # a difference of two nearly equal terms becomes one fraction, which keeps its digits
    one_fraction = found.is_rational_function(e) and not found.is_polynomial(e)
    return sp.factor(sp.together(found)) if one_fraction else real_everywhere(exact, found, e)


def real_everywhere(stress: Expr, stored: Expr, e: Symbol) -> Expr | None:
    """Return a closed form that has a value wherever the stress has one; None if it cannot be made to.

    SymPy writes the integral of a spring that acts on one side only, such as max(0, e - a)^1.5, with powers of negative
    numbers on the other side, which cancel as complex numbers but not as real ones: there the base is set to zero.
    """
    positive = clipped(stored, {e})
    if positive == stored:
        return stored
    return next((form for form in (stored, positive) if _is_integral(stress, form, e)), None)


def _is_integral(stress: Expr, stored: Expr, e: Symbol) -> bool:
    """Whether a stored energy has a value, and the stress as slope, wherever that has a value in some places."""
    if stored.free_symbols - {e}:
        return True  # its parameters have no values here
    width = max((2 * abs(place) for place in kinks(stress, e)), default=0.0)
    places = np.unique(np.outer((0.01, 1.0, max(width, 1.0)), np.linspace(-1, 1, PLACES)))
    with np.errstate(all="ignore"):
        values = [sp.lambdify(e, form, "numpy") for form in (stress, stored, stored.diff(e))]
        # one by one: not every SymPy writes the largest of two for arrays
        sigma, U, slope = np.array([[float(value(place)) for place in places] for value in values])
    known = np.isfinite(sigma)
    exact = np.isclose(slope, sigma, rtol=SLOPE, atol=SLOPE * np.abs(sigma[known]).max(initial=0.0))
    return bool(np.all(np.isfinite(U[known])) and np.mean(exact[known]) > MOSTLY)


def by_gauss(stress: Expr, e: Symbol, low: float, high: float) -> Expr:
    """Integrate from zero to e by Gauss's rule between zero, the kinks and the ends of (low, high)."""
    inner = [place for place in kinks(stress, e) if low < place < high]
    edges = sorted({0.0, low, high, *inner})
    total: Expr = sp.S.Zero
    for left, right in pairwise(edges):
        start, end = (left, right) if left >= 0 else (right, left)
        total += _rule(stress, e, start, end)
    return total


def kinks(expr: Expr, e: Symbol) -> tuple[float, ...]:
    """Return the points where pieces of a formula end, of those linear in e; some more where pieces are nested."""
    found = set()
    for margin in margins(expr):
        slope = margin.diff(e)
        if slope.is_number and slope.is_real and slope != 0:
            place = sp.N(-margin.subs(e, 0) / slope)
            if place.is_Float:
                found.add(float(place))
    return tuple(sorted(found))


def margins(expr: Expr) -> set[Expr]:
    """Return the expressions that change sign where a formula has a kink, without kinks of their own."""
    return {branch for nested in _margins(expr) for branch in _branches(nested)}


def _margins(expr: Expr) -> Iterator[Expr]:
    """Return the expressions that change sign where a formula has a kink."""
    for part in expr.atoms(Relational):
        yield part.lhs - part.rhs
    for part in expr.atoms(*KINKED):
        if isinstance(part, (sp.Min, sp.Max)):
            yield from (first - second for first, second in combinations(part.args, 2))
        else:
            yield part.args[0]


def _branches(expr: Expr) -> Iterator[Expr]:
    """Yield a formula with each kinked function in it replaced by one of its pieces, in all combinations."""
    inner = next(iter(sorted(expr.atoms(*KINKED, sp.Piecewise), key=sp.default_sort_key)), None)
    if inner is None:
        yield expr
        return
    if isinstance(inner, sp.Piecewise):
        pieces = [piece for piece, _ in inner.args]
    elif isinstance(inner, (sp.Min, sp.Max)):
        pieces = list(inner.args)
    else:
        size = inner.args[0] if isinstance(inner, sp.Abs) else sp.S.One
        pieces = [size, -size]
    for piece in pieces:
        yield from _branches(expr.xreplace({inner: piece}))


def _rule(stress: Expr, e: Symbol, start: float, end: float) -> Expr:
    """Integrate numerically over the part from zero to e that lies between two points, the first nearer to zero."""
    low, high = min(start, end), max(start, end)
    span = sp.Min(sp.Max(e, sp.Float(low)), sp.Float(high)) - sp.Float(start)
    places, weights = np.polynomial.legendre.leggauss(POINTS)
    terms = (
        sp.Float(float(weight) / 2)
        * stress.subs(e, sp.Float(start) + sp.Float((1 + float(place)) / 2) * span)
        for place, weight in zip(places, weights, strict=True)
    )
    return span * sp.Add(*terms)
