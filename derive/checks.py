"""Checks of what is declared in ``flexel.derive.element``: names, symbols, degrees in the rates.

This room may import sympy only.
"""

import re
from collections.abc import Iterable

import sympy as sp
from sympy import Expr, Symbol

# Words that cannot be names in the generated C, and the names of the arguments of its functions.
_RESERVED = frozenset(
    "auto break case char const continue default do double else enum extern float for goto if inline int "
    "long register restrict return short signed sizeof static struct switch typedef union unsigned void "
    "volatile while real complex bool true false nblocks in out main".split()
)
_IDENTIFIER = re.compile(r"[A-Za-z][A-Za-z0-9_]*\Z")


def check_name(owner: str, name: str) -> None:
    """Raise ValueError for a name that C cannot have."""
    if not _IDENTIFIER.match(name) or name in _RESERVED:
        raise ValueError(f"{owner}: '{name}' cannot be a name in C; choose letters, digits and underscores")


def rate_degrees(expr: Expr, known: dict[Symbol, frozenset[int]]) -> frozenset[int]:
    """Degrees in the rates of the terms of an expression, found from its structure.

    Parameters
    ----------
    expr : Expr
    known : dict
        The degrees of every symbol that may occur.

    Returns
    -------
    frozenset of int
        Empty for zero; -1 among them stands for "not a polynomial".
    """
    if expr == 0:
        return frozenset()
    if isinstance(expr, Symbol):
        return known[expr]
    if not expr.args:
        return frozenset({0})
    parts = [rate_degrees(arg, known) for arg in expr.args if isinstance(arg, Expr)]
    if isinstance(expr, sp.Add):
        return frozenset().union(*parts)
    if isinstance(expr, sp.Mul):
        total = frozenset({0})
        for part in parts:
            total = frozenset(-1 if -1 in (i, j) else i + j for i in total for j in part)
        return total
    if isinstance(expr, sp.Pow) and expr.exp.is_Integer and int(expr.exp) > 0:
        total = frozenset({0})
        for _ in range(int(expr.exp)):
            total = frozenset(-1 if -1 in (i, j) else i + j for i in total for j in parts[0])
        return total
    constant = all(known.get(s, frozenset({0})) <= {0} for s in expr.free_symbols)
    return frozenset({0}) if constant else frozenset({-1})


def check_unique(owner: str, names: list[str]) -> None:
    """Raise ValueError for a name that is used twice."""
    for i, name in enumerate(names):
        if name in names[:i]:
            raise ValueError(f"{owner}: the name '{name}' is used twice; rename one")


def check_symbols(owner: str, what: str, expr: Expr, known: Iterable[Symbol]) -> None:
    """Raise ValueError for a symbol in an expression that is not known."""
    unknown = sorted(str(s) for s in expr.free_symbols - set(known))
    if unknown:
        raise ValueError(f"{owner}: {what} contains {', '.join(unknown)}: not a coordinate, parameter or let")
