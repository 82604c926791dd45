"""Smoothness check: an element is differentiated three times, so that its functions have no kinks."""

import sympy as sp
from sympy import Expr

from flexel.derive.declare.functions import KINKED


def check_smooth(owner: str, what: str, expr: Expr) -> None:
    """Raise ValueError for a function with a kink: an element is differentiated three times, a law once."""
    for part in sp.preorder_traversal(expr):
        if isinstance(part, KINKED):
            raise ValueError(
                f"{owner}: {what} contains {part}: it has a kink, and derivatives up to the third are needed; use "
                "sqrt(x**2 + eps**2), a Piecewise whose pieces join smoothly, or a law (for contact and friction)"
            )
