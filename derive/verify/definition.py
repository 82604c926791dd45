"""The definition of an element or a law, evaluated as it is written, in many digits.

Nothing is differentiated here and nothing of ``flexel.derive.program`` is used: the SymPy expressions are
handed to mpmath line by line. This is what the compiled kernels are judged against.
"""

from collections.abc import Callable, Iterable, Sequence
from typing import Any

import mpmath
import sympy as sp

from flexel.derive.element import Element, Law

DIGITS = 60
Number = Any  # an mpmath number; mpmath has no types
Vector = list[Number]


def many_digits(values: Iterable[float]) -> Vector:
    """Floating-point numbers as exactly the same numbers of mpmath."""
    return [mpmath.mpf(float(value)) for value in values]


def _compile(
    arguments: Sequence[sp.Symbol], expressions: Sequence[sp.Expr], let: Sequence[tuple[sp.Symbol, sp.Expr]]
) -> Callable[..., Vector]:
    """Python function of the arguments for some expressions, by way of the named intermediates."""
    needed = set().union(*(expr.free_symbols for expr in expressions))
    used: list[tuple[sp.Symbol, sp.Expr]] = []
    for name, value in reversed(let):
        if name in needed:
            used.insert(0, (name, value))
            needed |= value.free_symbols

    def as_written(expressions: Sequence[sp.Expr]) -> tuple[Any, Any]:
        return used, expressions

    function = sp.lambdify(arguments, list(expressions), modules="mpmath", cse=as_written)
    return lambda *values: [mpmath.mpf(value) for value in function(*values)]


class Definition:
    """D(x), s(x, v), T(x, v) and U(x) of an element, as functions of columns of mpmath numbers.

    The attribute `p` (np,) holds the parameters that they use.
    """

    def __init__(self, element: Element) -> None:
        x, v, p = list(element.x), list(element.v), list(element.parameter_symbols)
        let = element.let
        self.n, self.m, self.k = len(x), len(element.deformations), len(element.slips)
        self._deformations = _compile([*x, *p], [d.expr for d in element.deformations], let)
        self._slips = _compile([*x, *v, *p], [s.expr for s in element.slips], let)
        self._kinetic_energy = _compile([*x, *v, *p], [sp.sympify(element.kinetic_energy)], let)
        self._potential = _compile([*x, *p], [sp.sympify(element.potential)], let)
        self.p: Vector = []

    def D(self, x: Vector) -> Vector:  # noqa: N802 (the mathematics' letters)
        """Deformations, (m,)."""
        return self._deformations(*x, *self.p)

    def s(self, x: Vector, v: Vector) -> Vector:
        """Slips, (k,)."""
        return self._slips(*x, *v, *self.p)

    def T(self, x: Vector, v: Vector) -> Number:  # noqa: N802
        """Kinetic energy."""
        return self._kinetic_energy(*x, *v, *self.p)[0]

    def U(self, x: Vector) -> Number:  # noqa: N802
        """Potential of the body forces."""
        return self._potential(*x, *self.p)[0]


class LawDefinition:
    """Stresses and stored energy of a law, as functions of columns of mpmath numbers."""

    def __init__(self, law: Law) -> None:
        arguments = [*law.e, *law.ed, *law.s, *law.parameter_symbols]
        self._stresses = _compile(arguments, [sp.sympify(expr) for expr in (*law.sigma, *law.tau)], ())
        self._energy = _compile(arguments, [sp.sympify(law.energy)], ())
        self.p: Vector = []

    def stresses(self, inputs: Vector) -> Vector:
        """(sigma, tau), (m + k,), of (e, ed, s)."""
        return self._stresses(*inputs, *self.p)

    def energy(self, inputs: Vector) -> Number:
        """Stored energy of (e, ed, s)."""
        return self._energy(*inputs, *self.p)[0]
