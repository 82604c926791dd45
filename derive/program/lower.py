"""From SymPy expressions to rows of a `Program`.

Every subexpression is lowered once, arguments in the order of ``default_sort_key``, so that the rows do not
depend on hash seeds. Nothing here simplifies or differentiates.
"""

from collections.abc import Callable
from fractions import Fraction

import sympy as sp
from sympy import default_sort_key
from sympy.core.basic import Basic

from flexel.derive.declare.functions import FUNCTIONS
from flexel.derive.program.straight_line import Program

_DIGITS = 50


class LoweringError(ValueError):
    """An expression contains something that has no counterpart in a program."""


def exact(number: sp.Expr) -> Fraction:
    """Return the exact value of a rational or floating-point number, 50 digits of an irrational one."""
    if isinstance(number, sp.Rational):
        return Fraction(int(number.p), int(number.q))
    if isinstance(number, sp.Float):
        rational = sp.Rational(number)
        return Fraction(int(rational.p), int(rational.q))
    return Fraction(str(sp.N(number, _DIGITS)))


def _ordered(expr: Basic) -> list[Basic]:
    if isinstance(expr, (sp.Add, sp.Mul, sp.And, sp.Or, sp.Min, sp.Max)):
        return sorted(expr.args, key=default_sort_key)
    return list(expr.args)


class ProgramLowering:
    """Lowers expressions into one program; remembers what it has lowered.

    Parameters
    ----------
    program : Program
    inputs : dict of Symbol to int
        Rows of the symbols that may occur; `let` adds to them.
    """

    def __init__(self, program: Program, inputs: dict[sp.Symbol, int]) -> None:
        self.program = program
        self._known: dict[Basic, int] = dict(inputs)

    def let(self, symbol: sp.Symbol, expr: sp.Expr) -> int:
        """Lower a named intermediate; its name stays with the row."""
        return self.name(symbol, self.lower(expr))

    def name(self, symbol: sp.Symbol, number: int) -> int:
        """Let a symbol stand for a row, which takes its name."""
        self._known[symbol] = number
        if self.program.rows[number].op not in ("const", "input", "neg"):
            self.program.names.setdefault(number, symbol.name)
        return number

    def lower(self, expr: Basic) -> int:
        """Return the row of an expression.

        Raises
        ------
        LoweringError
            An unknown symbol or function.
        """
        known = self._known
        stack: list[tuple[Basic, bool]] = [(sp.sympify(expr), False)]
        while stack:
            item, ready = stack.pop()
            if item in known:
                continue
            if ready:
                known[item] = self._combine(item, [known[arg] for arg in _ordered(item) if arg in known])
                continue
            stack.append((item, True))
            stack.extend((arg, False) for arg in reversed(self._operands(item)))
        return known[sp.sympify(expr)]

    def _operands(self, expr: Basic) -> list[Basic]:
        """Return the subexpressions that must be lowered before this one."""
        if isinstance(expr, sp.Piecewise):
            return [part for pair in expr.args for part in pair.args]
        if isinstance(expr, sp.Pow):
            exponent = expr.exp
            return [expr.base] if isinstance(exponent, sp.Rational) else [expr.base, exponent]
        return _ordered(expr)

    def _combine(self, expr: Basic, args: list[int]) -> int:
        p = self.program
        if isinstance(expr, sp.Expr) and expr.is_number and not expr.args:
            return p.const(exact(expr))
        if isinstance(expr, sp.Add):
            return self._sum(args)
        if isinstance(expr, sp.Mul):
            return self._product(args)
        if isinstance(expr, sp.Pow):
            return self._power(expr)
        if type(expr) in FUNCTIONS:
            return p.call(FUNCTIONS[type(expr)], *args)
        if isinstance(expr, (sp.Min, sp.Max)):
            op = "min" if isinstance(expr, sp.Min) else "max"
            result = args[0]
            for arg in args[1:]:
                result = p.call(op, result, arg)
            return result
        return self._conditional(expr, args)

    def _product(self, args: list[int]) -> int:
        """Multiply the product of the constants by the product of the others."""
        p = self.program
        parts = [p.one, p.one]
        for arg in args:
            changing = not p.is_constant(arg)
            parts[changing] = p.mul(parts[changing], arg)
        return p.mul(*parts)

    def _sum(self, args: list[int]) -> int:
        """Add up, with the constant factors that several terms share taken out of them."""
        p = self.program
        groups: dict[int, dict[Fraction, list[int]]] = {}
        for arg in args:
            number, row = p.split(arg)
            op, factors, _ = p.rows[row]
            constants = [factor for factor in factors if op == "mul" and p.is_constant(factor)]
            constant, rest = p.one, row
            if len(constants) == 1:
                constant = constants[0]
                rest = factors[1] if constant == factors[0] else factors[0]
            term = p.scale(Fraction(-1 if number < 0 else 1), rest)
            groups.setdefault(constant, {}).setdefault(abs(number), []).append(term)
        return p.sum(
            p.mul(constant, p.sum(p.scale(number, p.sum(terms)) for number, terms in by_number.items()))
            for constant, by_number in groups.items()
        )

    def _power(self, expr: sp.Pow) -> int:
        p, base, exponent = self.program, self._known[expr.base], expr.exp
        if not isinstance(exponent, sp.Rational):
            return p.call("pow", base, self._known[exponent])
        if exponent.q == 1:
            return p.power(base, int(exponent.p))
        # where the base stays at zero, as of a gap that is open, the derivative of a root would be 0 times infinity
        stays = exponent > 1 and expr.base.has(sp.Max, sp.Min, sp.Piecewise)
        if exponent.q == 2 and not stays:
            root = p.call("sqrt", base)
            whole = (int(exponent.p) - (1 if exponent.p > 0 else -1)) // 2
            return p.mul(p.power(base, whole), root if exponent.p > 0 else p.inv(root))
        return p.call("pow", base, p.const(exact(exponent)))

    def _conditional(self, expr: Basic, args: list[int]) -> int:
        p = self.program
        if expr in (sp.true, sp.false):
            return p.const(int(expr == sp.true))
        if isinstance(expr, sp.Piecewise):
            return self._piecewise(expr)
        if isinstance(expr, sp.sign):
            negative = p.select(p.compare("lt", args[0], p.zero), p.const(-1), p.zero)
            return p.select(p.compare("lt", p.zero, args[0]), p.one, negative)
        if isinstance(expr, sp.Heaviside):
            at_zero = p.select(p.compare("eq", args[0], p.zero), args[1], p.one)
            return p.select(p.compare("lt", args[0], p.zero), p.zero, at_zero)
        compare: dict[type[Basic], Callable[[], int]] = {
            sp.StrictLessThan: lambda: p.compare("lt", args[0], args[1]),
            sp.StrictGreaterThan: lambda: p.compare("lt", args[1], args[0]),
            sp.LessThan: lambda: p.compare("le", args[0], args[1]),
            sp.GreaterThan: lambda: p.compare("le", args[1], args[0]),
            sp.Equality: lambda: p.compare("eq", args[0], args[1]),
            sp.Unequality: lambda: p.logic("not", p.compare("eq", args[0], args[1])),
            sp.And: lambda: p.logic("and", *args),
            sp.Or: lambda: p.logic("or", *args),
            sp.Not: lambda: p.logic("not", args[0]),
            sp.ITE: lambda: p.logic(
                "or",
                p.logic("and", args[0], args[1]),
                p.logic("and", p.logic("not", args[0]), args[2]),
            ),
        }
        for kind, build in compare.items():
            if isinstance(expr, kind):
                return build()
        what = f"symbol '{expr}'" if isinstance(expr, sp.Symbol) else f"function '{type(expr).__name__}'"
        raise LoweringError(
            f"{what} cannot be compiled; known functions: {', '.join(sorted(FUNCTIONS.values()))}"
        )

    def _piecewise(self, expr: sp.Piecewise) -> int:
        p = self.program
        pairs = [(self._known[pair.args[0]], self._known[pair.args[1]]) for pair in expr.args]
        if p.constant(pairs[-1][1]) != 1:
            raise LoweringError(
                f"'{expr}' has no value where none of its conditions holds; end it with (…, True)"
            )
        result = pairs[-1][0]
        for value, condition in reversed(pairs[:-1]):
            result = p.select(condition, value, result)
        return result
