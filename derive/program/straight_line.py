"""Straight-line programs: a hash-consed graph of short rows.

A `Program` is a growing list of rows, each one operation on earlier rows. Equal rows are the same row, so
that common subexpressions merge when they are made; small identities (x + 0, 1 x, a + (-b), ...) are applied
on the way and constants stay exact fractions until they are printed. Lowering from SymPy is in ``lower``,
differentiation in ``differentiate``.
"""

import math
from collections.abc import Iterable
from fractions import Fraction

from flexel.derive.program.graph import Graph, TapeRow

ONE = Fraction(1)
_MINUS = Fraction(-1)

# Odd functions hand a sign through, even ones swallow it.
_ODD = frozenset({"sin", "tan", "asin", "atan", "tanh", "sinh"})
_EVEN = frozenset({"cos", "abs", "cosh"})
_COMPARE = {"lt": Fraction.__lt__, "le": Fraction.__le__, "eq": Fraction.__eq__}


def _times(a: Fraction, b: Fraction) -> Fraction:
    """Multiply; most factors are one, and exact products are slow."""
    if a is ONE:
        return b
    return a if b is ONE else a * b


class Program(Graph):
    """A straight-line program that is built row by row; a row is known by its number.

    Notes
    -----
    Normal form: the arguments of sums and products are in the order of their numbers, a constant factor is
    positive, comes first and is pulled out of products, and signs are pulled out of products and odd functions.
    A quotient is a product with a reciprocal (``inv``), so that one division serves all quotients with the same
    denominator.
    """

    # -- arithmetic

    def split(self, a: int) -> tuple[Fraction, int]:
        """Write a row as factor times row, the factor a constant."""
        factor = ONE
        row = self.rows[a]
        if row.op == "neg":
            factor, a = _MINUS, row.args[0]
            row = self.rows[a]
        if row.op == "mul":
            value = self.constant(row.args[0])
            if value is not None:
                return _times(factor, value), row.args[1]
        return factor, a

    def scale(self, factor: Fraction, a: int) -> int:
        """Multiply a row by a constant."""
        inner, base = self.split(a)
        factor = _times(factor, inner)
        value = self.constant(base)
        if value is not None:
            return self.const(factor * value)
        if factor == 0:
            return self.zero
        if factor < 0:
            return self.row("neg", (self.scale(-factor, base),))
        return base if factor == 1 else self.row("mul", (self.const(factor), base))

    def neg(self, a: int) -> int:
        """Return -a."""
        row = self.rows[a]
        if row.op == "sub":
            known = self._index.get(TapeRow("sub", (row.args[1], row.args[0])))
            if known is not None:
                return known
        return self.scale(-ONE, a)

    def add(self, a: int, b: int) -> int:
        """Return a + b."""
        if a == self.zero or b == self.zero:
            return b if a == self.zero else a
        va, vb = self.constant(a), self.constant(b)
        if va is not None and vb is not None:
            return self.const(va + vb)
        (fa, ra), (fb, rb) = self.split(a), self.split(b)
        if ra == rb:
            return self.scale(fa + fb, ra)
        nega, negb = self._opposite(a), self._opposite(b)
        if nega is not None and negb is not None:
            return self.neg(self.add(nega, negb))
        if negb is not None:
            return self._difference(a, negb)
        if nega is not None:
            return self._difference(b, nega)
        return self.row("add", (a, b) if a < b else (b, a))

    def sub(self, a: int, b: int) -> int:
        """Return a - b."""
        return self.add(a, self.neg(b))

    def _opposite(self, a: int) -> int | None:
        """Return the row that this one is the negative of, or None."""
        row = self.rows[a]
        if row.op == "neg":
            return row.args[0]
        if row.op == "const" and isinstance(row.value, Fraction) and row.value < 0:
            return self.const(-row.value)
        return None

    def _difference(self, a: int, b: int) -> int:
        known = self._index.get(TapeRow("sub", (b, a)))
        return self.row("sub", (a, b)) if known is None else self.row("neg", (known,))

    def mul(self, a: int, b: int) -> int:
        """Return a b."""
        (fa, ra), (fb, rb) = self.split(a), self.split(b)
        factor = _times(fa, fb)
        va, vb = self.constant(ra), self.constant(rb)
        if va is not None:
            return self.scale(factor * va, rb)
        if vb is not None:
            return self.scale(factor * vb, ra)
        rowa, rowb = self.rows[ra], self.rows[rb]
        if (rowa.op == "inv" and rowa.args[0] == rb) or (rowb.op == "inv" and rowb.args[0] == ra):
            return self.const(factor)
        if ra == rb and rowa.op == "sqrt":
            return self.scale(factor, rowa.args[0])
        result = self.row("mul", (ra, rb) if ra < rb else (rb, ra))
        return result if factor is ONE else self.scale(factor, result)

    def inv(self, a: int) -> int:
        """Return 1 / a."""
        factor, base = self.split(a)
        value = self.constant(base)
        if value is not None:
            if value == 0:
                raise ZeroDivisionError("a constant denominator is zero; check the expression")
            return self.const(1 / (factor * value))
        if self.rows[base].op == "inv":
            return self.scale(1 / factor, self.rows[base].args[0])
        return self.scale(1 / factor, self.row("inv", (base,)))

    def div(self, a: int, b: int) -> int:
        """Return a / b."""
        return self.mul(a, self.inv(b))

    def power(self, a: int, exponent: int) -> int:
        """Raise a to an integer power, as products."""
        if exponent < 0:
            a, exponent = self.inv(a), -exponent
        result, square = self.one, a
        while exponent:
            if exponent & 1:
                result = self.mul(result, square)
            exponent >>= 1
            if exponent:
                square = self.mul(square, square)
        return result

    def sum(self, terms: Iterable[int]) -> int:
        """Add up from left to right, starting with a term that is not a negative one."""
        positive: list[int] = []
        negative: list[int] = []
        for term in terms:
            (positive if self._opposite(term) is None else negative).append(term)
        total = self.zero
        for term in positive + negative:
            total = self.add(total, term)
        return total

    # -- functions, conditions

    def call(self, op: str, *args: int) -> int:
        """Call an elementary function."""
        a = args[0]
        value = self.constant(a)
        if op == "sqrt":
            return self._sqrt(a, value)
        if value is not None and len(args) == 1:
            if value == 0 and op in _ODD:
                return self.zero
            if value == 0 and op in ("cos", "exp", "cosh"):
                return self.one
            if op == "abs":
                return self.const(abs(value))
        opposite = self._opposite(a)
        if opposite is not None and op in _ODD:
            return self.neg(self.call(op, opposite))
        if opposite is not None and op in _EVEN:
            return self.call(op, opposite)
        if op in ("min", "max"):
            if args[0] == args[1]:
                return a
            args = (min(args), max(args))
        return self.row(op, args)

    def _sqrt(self, a: int, value: Fraction | None) -> int:
        if value is not None and value >= 0:
            n, d = math.isqrt(value.numerator), math.isqrt(value.denominator)
            if n * n == value.numerator and d * d == value.denominator:
                return self.const(Fraction(n, d))
        return self.row("sqrt", (a,))

    def compare(self, op: str, a: int, b: int) -> int:
        """Return the condition a < b (lt), a <= b (le) or a = b (eq); constant conditions are the constants 0 and 1."""
        va, vb = self.constant(a), self.constant(b)
        if va is not None and vb is not None:
            return self.const(int(_COMPARE[op](va, vb)))
        if a == b:
            return self.const(int(op != "lt"))
        return self.row(op, (min(a, b), max(a, b)) if op == "eq" else (a, b))

    def logic(self, op: str, *conditions: int) -> int:
        """Join conditions by ``and`` or ``or``, or reverse one by ``not``."""
        if op == "not":
            value = self.constant(conditions[0])
            return self.row("not", conditions) if value is None else self.const(1 - value)
        absorbing = self.const(int(op == "or"))
        rest = [c for c in dict.fromkeys(conditions) if self.constant(c) is None]
        if absorbing in conditions:
            return absorbing
        if not rest:
            return self.const(int(op == "and"))
        result = rest[0]
        for condition in rest[1:]:
            result = self.row(op, (result, condition))
        return result

    def select(self, condition: int, yes: int, no: int) -> int:
        """Return yes where the condition holds, else no."""
        value = self.constant(condition)
        if value is not None:
            return yes if value != 0 else no
        return yes if yes == no else self.row("select", (condition, yes, no))
