"""Checks of declarations: names, meanings, symbols, functions, degrees in the rates."""

import re
from collections.abc import Iterable

import sympy as sp
from sympy import Expr, Symbol
from sympy.core.relational import Relational
from sympy.functions.elementary.piecewise import ExprCondPair
from sympy.logic.boolalg import Boolean

from flexel.derive.declare.functions import FUNCTIONS, KINKED
from flexel.derive.definition_errors import ElementError

# Words that cannot be names in the generated C, and the names of the arguments of its functions.
_RESERVED = frozenset(
    "auto break case char const continue default do double else enum extern float for goto if inline int "
    "long register restrict return short signed sizeof static struct switch typedef union unsigned void "
    "volatile while real complex bool true false nblocks in out main".split()
)
# Names of arrays in the generated C, and what else is a name there.
ARRAYS = frozenset(
    "x v a p e ed s z t sigma tau De V g gs M h f U P zd Phi_x Psi_x Psi_v K R_x R_v J".split()
)
TAKEN = frozenset("in out j b real size_t sizeof int double const for pow exp log main".split())
_LONGEST = 40  # letters of a name, which become part of longer ones in C and of names of files
_IDENTIFIER = re.compile(r"[A-Za-z][A-Za-z0-9_]*\Z")

_ALGEBRA = (sp.Add, sp.Mul, sp.Pow, sp.Piecewise, ExprCondPair, Relational, Boolean)
_ATOMS = (Symbol, sp.Number, sp.NumberSymbol)
_NOT_REAL = (sp.nan, sp.oo, -sp.oo, sp.zoo, sp.I)


def check_name(owner: str, name: str) -> None:
    """Raise ElementError for a name that is invalid in C."""
    if not _IDENTIFIER.match(name):
        raise ElementError(
            f"{owner}: '{name}' is not a valid name in C; begin with a letter, and use letters, digits and underscores"
        )
    if name in _RESERVED:
        raise ElementError(
            f"{owner}: '{name}' is not a valid name: it is a word of C; choose another, such as '{name}_'"
        )
    if len(name) > _LONGEST:
        raise ElementError(
            f"{owner}: '{name[:20]}…' has {len(name)} letters; choose a name of at most {_LONGEST}"
        )


def check_array(owner: str, name: str) -> None:
    """Raise ElementError for a name that an output array cannot have in C alongside those of the kernels."""
    check_name(owner, name)
    if name in ARRAYS | TAKEN or name.startswith("real_") or (name[0] == "t" and name[1:].isdigit()):
        raise ElementError(f"{owner}: the output '{name}' has a name used in the C code; choose another")


def check_list(owner: str, what: str, given: object, kind: type) -> None:
    """Raise ElementError for anything but a list or tuple of objects of a kind."""
    wrong = (
        [value for value in given if not isinstance(value, kind)] if isinstance(given, Iterable) else [given]
    )
    if wrong:
        each = f" of {kind.__name__}" if kind is not object else ""
        raise ElementError(f"{owner}: {what} holds {wrong[0]!r}; give a tuple{each}, (…,) even for one")


def check_scalar(owner: str, what: str, expr: object) -> None:
    """Raise ElementError for anything but a scalar SymPy expression."""
    if not isinstance(expr, Expr):
        raise ElementError(
            f"{owner}: {what} is not a scalar expression but {type(expr).__name__}; write one SymPy expression, and "
            "declare each component of a vector separately"
        )


def rate_degrees(expr: Expr, known: dict[Symbol, frozenset[int]]) -> frozenset[int]:
    """Find the degrees in the rates of the terms of an expression, from its structure.

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
    """Raise ElementError for a name that is used twice."""
    for i, name in enumerate(names):
        if name in names[:i]:
            raise ElementError(f"{owner}: the name '{name}' is used twice; rename one")


def check_symbols(owner: str, what: str, expr: Expr, known: Iterable[Symbol]) -> None:
    """Raise ElementError for a symbol in an expression that is not known."""
    unknown = sorted(str(s) for s in expr.free_symbols - set(known))
    if unknown:
        raise ElementError(
            f"{owner}: {what} contains {', '.join(unknown)}: not a coordinate, parameter or let; declare a Parameter, "
            "and take symbols from node.x, node.v, parameter.symbol (one made by sympy.symbols is another symbol)"
        )


def check_text(owner: str, what: str, text: str) -> None:
    """Raise ElementError for a missing doc."""
    if not isinstance(text, str) or not text.strip():
        raise ElementError(f"{owner}: {what} has no doc; say in a few words what it means")


def check_functions(owner: str, what: str, expr: Expr) -> None:
    """Raise ElementError for a function that cannot be differentiated or compiled."""
    for part in sp.preorder_traversal(expr):
        if part in _NOT_REAL:
            raise ElementError(f"{owner}: {what} contains {part}: not real and finite; correct the formula")
        if not isinstance(part, (*_ALGEBRA, *_ATOMS, *KINKED, *FUNCTIONS)):
            known = ", ".join(sorted(FUNCTIONS.values()))
            raise ElementError(
                f"{owner}: {what} contains {part}: {type(part).__name__} cannot be differentiated and compiled; use "
                f"powers, sqrt, Piecewise, {known}"
            )
