"""Symbols of declarations: real ones, so that equal names are equal symbols."""

from sympy import Symbol


def symbol(name: str) -> Symbol:
    """Return a real symbol, the only kind used in elements and laws (equal names are equal symbols)."""
    return Symbol(name, real=True)


TIME = symbol("t")
