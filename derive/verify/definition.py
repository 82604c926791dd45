"""The definition of an element or a law, evaluated as it is written, in many digits.

Nothing is differentiated here and nothing of ``flexel.derive.program`` is used: the SymPy expressions are
evaluated line by line. Arithmetic is done in Python's decimal numbers of 60 digits, which are several times
faster than mpmath's; functions other than the square root are mpmath's. This is what the compiled kernels are
judged against.
"""

from collections.abc import Callable, Iterable, Sequence
from decimal import Context, Decimal
from functools import cache, lru_cache
from typing import Any

import mpmath
import sympy as sp

from flexel.derive.declare import Element, Law

DIGITS = 60
CONTEXT = Context(prec=DIGITS)
KEPT = (
    1024  # values of a function: differences by one coordinate leave the others, and their sines, as they are
)
Number = Any  # Decimal, or a number of mpmath where a function of it is taken
Vector = list[Decimal]


def many_digits(values: Iterable[float]) -> Vector:
    """Convert floating-point numbers to exactly the same numbers with many digits."""
    return [Decimal(float(value)) for value in values]


def _in_decimals(function: Callable[..., Number]) -> Callable[..., Decimal]:
    """Convert a function of mpmath to a function of decimal numbers."""

    @lru_cache(maxsize=KEPT)
    def of_decimals(*arguments: Decimal) -> Decimal:
        with mpmath.workdps(DIGITS + 5):
            return Decimal(mpmath.nstr(function(*(mpmath.mpf(str(x)) for x in arguments)), DIGITS + 5))

    return of_decimals


@cache
def _literal(value: int | tuple[int, int, int, int]) -> Decimal:
    """Convert a number in an expression: an integer, or mpmath's sign, mantissa, exponent of two and bit count."""
    if isinstance(value, int):
        return Decimal(value)
    sign, mantissa, exponent, _ = value
    return CONTEXT.multiply(Decimal(-mantissa if sign else mantissa), CONTEXT.power(Decimal(2), exponent))


@cache
def _functions() -> dict[str, Any]:
    """Return the objects that the names in a printed expression refer to."""
    names: dict[str, Any] = {"sqrt": lambda x: Decimal(x).sqrt(), "mpf": _literal}
    for name, value in vars(mpmath).items():
        if isinstance(value, type(mpmath.pi)):
            names[name] = _in_decimals(lambda value=value: +value)()
        elif callable(value) and not isinstance(value, type):
            names.setdefault(name, _in_decimals(value))
    return names


def _compile(
    arguments: Sequence[sp.Symbol], expressions: Sequence[sp.Expr], let: Sequence[tuple[sp.Symbol, sp.Expr]]
) -> Callable[..., Vector]:
    """Return a Python function of the arguments for some expressions, by way of the named intermediates."""
    needed = set().union(*(expr.free_symbols for expr in expressions))
    used: list[tuple[sp.Symbol, sp.Expr]] = []
    for name, value in reversed(let):
        if name in needed:
            used.insert(0, (name, value))
            needed |= value.free_symbols

    def as_written(expressions: Sequence[sp.Expr]) -> tuple[Any, Any]:
        return used, expressions

    function = sp.lambdify(arguments, list(expressions), modules=[_functions(), "mpmath"], cse=as_written)
    return lambda *values: [Decimal(value) for value in function(*values)]


class Definition:
    """D(x), s(x, v), T(x, v), U(x) and the outputs of an element, as functions of columns of decimal numbers.

    To be used in the decimal context `CONTEXT`. The attribute `p` (np,) holds the parameters that they use.
    """

    def __init__(self, element: Element) -> None:
        x, v, p = list(element.x), list(element.v), list(element.parameter_symbols)
        let = element.let
        self.n, self.m, self.k = len(x), len(element.deformations), len(element.slips)
        self._deformations = _compile([*x, *p], [d.expr for d in element.deformations], let)
        self._slips = _compile([*x, *v, *p], [s.expr for s in element.slips], let)
        self._kinetic_energy = _compile([*x, *v, *p], [sp.sympify(element.kinetic_energy)], let)
        self._potential = _compile([*x, *p], [sp.sympify(element.potential)], let)
        reported = [expr for output in element.outputs for expr in output.exprs]
        self.reported = {output.name: output.shape for output in element.outputs}
        self._outputs = _compile([*x, *element.forces, *element.values, *element.stresses, *p], reported, let)
        self.p: Vector = []

    def D(self, x: Vector) -> Vector:  # noqa: N802 (the mathematics' letters)
        """Return the deformations, (m,)."""
        return self._deformations(*x, *self.p)

    def s(self, x: Vector, v: Vector) -> Vector:
        """Return the slips, (k,)."""
        return self._slips(*x, *v, *self.p)

    def T(self, x: Vector, v: Vector) -> Decimal:  # noqa: N802
        """Return the kinetic energy."""
        return self._kinetic_energy(*x, *v, *self.p)[0]

    def U(self, x: Vector) -> Decimal:  # noqa: N802
        """Return the potential of the body forces."""
        return self._potential(*x, *self.p)[0]

    def outputs(self, x: Vector, forces: Vector, e: Vector, stresses: Vector) -> Vector:
        """Return all components of all outputs, from nodal forces (n,), deformations (m,) and stresses (m + k,)."""
        return self._outputs(*x, *forces, *e, *stresses, *self.p)


class LawDefinition:
    """Stresses, rates of internal states and stored energy of a law, as functions of columns of decimal numbers.

    The attributes `p` (np,) and `t` (1,) hold the parameters and the time that they use.
    """

    def __init__(self, law: Law) -> None:
        answers = (*law.sigma, *law.tau, *(state.rate for state in law.states))
        self._answers = _compile(law.arguments, [sp.sympify(expr) for expr in answers], law.let)
        self._energy = _compile(law.arguments, [sp.sympify(law.energy)], law.let)
        self.p: Vector = []
        self.t: Vector = []

    def answers(self, inputs: Vector) -> Vector:
        """Return (sigma, tau, dz/dt), (m + k + nz,), as a function of (e, ed, s, z)."""
        return self._answers(*inputs, *self.t, *self.p)

    def energy(self, inputs: Vector) -> Decimal:
        """Return the stored energy as a function of (e, ed, s, z)."""
        return self._energy(*inputs, *self.t, *self.p)[0]
