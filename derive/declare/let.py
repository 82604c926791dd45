"""Named intermediates of a declaration."""

from collections.abc import Iterable

import sympy as sp
from sympy import Expr, Matrix, Symbol

from flexel.derive.declare.symbols import symbol


class Let:
    """Collects named intermediates: ``let.scalar("l", expr)`` notes l = expr and returns the symbol l.

    Vectors take the suffixes x, y, z (three components), x, y (two) or 0, 1, ... The names survive into the
    C.
    """

    def __init__(self) -> None:
        self._entries: list[tuple[Symbol, Expr]] = []

    def scalar(self, name: str, expr: Expr) -> Symbol:
        """Name one expression."""
        s = symbol(name)
        self._entries.append((s, sp.sympify(expr)))
        return s

    def vector(self, name: str, exprs: Iterable[Expr]) -> Matrix:
        """Name the components of a column."""
        values = list(exprs)
        suffixes = "xyz" if len(values) in (2, 3) else "0123456789"
        return Matrix([self.scalar(f"{name}_{suffixes[i]}", value) for i, value in enumerate(values)])

    @property
    def entries(self) -> tuple[tuple[Symbol, Expr], ...]:
        """The pairs (symbol, expression), in order."""
        return tuple(self._entries)
