"""User-defined laws: a formula becomes a compiled law with exact tangents.

The derivation (SymPy, flexel.derive) is imported only when a formula is given; the results are cached by
content, so that a formula is derived and compiled once.  Imports the errors.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from flexel.errors import ModelError


def formula_law(name: str, stress: Callable[..., Any], energy: Callable[..., Any] | None) -> Any:
    """Compile σ = stress(e, ė) on one deformation.

    Parameters
    ----------
    name : str
        The deformation, for messages.
    stress : callable(e, ed) -> sympy expression
    energy : callable(e) -> sympy expression, optional

    Returns
    -------
    flexel.derive.compile.Compiled
        Specification and address of the kernels.

    Raises
    ------
    ModelError
        If the function does not give an expression of e and ed.
    """
    import sympy

    from flexel.derive.compile import compile_law
    from flexel.derive.element import Law, symbol

    e, ed = symbol("e"), symbol("ed")
    try:
        sigma = sympy.sympify(stress(e, ed))
    except TypeError as error:
        raise ModelError(
            f"law on '{name}': the formula failed on symbols ({error}); use SymPy functions (sympy.sin, "
            "sympy.Piecewise), not math or numpy ones"
        ) from error
    if not isinstance(sigma, sympy.Expr) or sigma.free_symbols - {e, ed}:
        raise ModelError(
            f"law on '{name}': {sigma} is not an expression of e and its rate alone; insert the numbers"
        )
    stored = sympy.sympify(energy(e)) if energy else sympy.integrate(sigma.subs(ed, 0), (e, 0, e))
    if not isinstance(stored, sympy.Expr) or stored.has(sympy.Integral):
        raise ModelError(f"law on '{name}': SymPy finds no stored energy; give it as energy=lambda e: …")
    return compile_law(
        Law("user", f"sigma = {sigma}", (), (e,), (ed,), (), (sigma,), (), stored, "formula of the user")
    )
