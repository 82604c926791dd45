"""User-defined laws: a formula becomes a compiled law with exact tangents.

The derivation (SymPy, flexel.derive) is imported only when a formula is given; the results are cached by
content, so that a formula is derived and compiled once.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from flexel.base.errors import CompilerError, ModelError


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
        If the function does not give an expression of e and ed, jumps or has no value beyond an end of its pieces,
        or the energy does not belong to it.
    CompilerError
        If there is no C compiler.
    """
    import sympy

    from flexel.derive import Law, symbol
    from flexel.derive.check.branches import check_branches
    from flexel.derive.compile import CompilationError, CompilerMissingError, compile_law

    e, ed = symbol("e"), symbol("ed")
    sigma = _formula(name, "stress", stress, e, ed)
    try:
        check_branches(f"law on '{name}'", sigma, (e, ed))
    except ValueError as error:
        raise ModelError(str(error)) from error
    if energy is None:
        stored = sympy.integrate(sigma.subs(ed, 0), (e, 0, e))
        if not isinstance(stored, sympy.Expr) or stored.has(sympy.Integral, sympy.nan, sympy.oo, sympy.zoo):
            raise ModelError(f"law on '{name}': SymPy finds no stored energy; give it as energy=lambda e: …")
    else:
        stored = _formula(name, "energy", energy, e)
        _check_energy(name, sigma.subs(ed, 0), stored, e)
    try:
        return compile_law(
            Law("user", f"sigma = {sigma}", (), (e,), (ed,), (), (sigma,), (), stored, "formula of the user")
        )
    except (CompilerMissingError, CompilationError) as error:
        raise CompilerError(f"law on '{name}': {error}") from error
    except (ValueError, TypeError, NotImplementedError, KeyError, AttributeError) as error:
        raise ModelError(
            f"law on '{name}': {sigma} cannot be derived ({error}); use elementary functions and Piecewise"
        ) from error


def _formula(name: str, what: str, function: Callable[..., Any], *symbols: Any) -> Any:
    """Call the user's function with symbols: a finite real expression of these alone, or a ModelError."""
    import sympy

    owner = f"law on '{name}'"
    if not callable(function):
        raise ModelError(
            f"{owner}: {what} {function!r} is not a function; write lambda {_listed(symbols)}: …"
        )
    try:
        found = sympy.sympify(function(*symbols))
    except Exception as error:  # whatever a user's function does
        raise ModelError(
            f"{owner}: the {what} failed on the symbols {_listed(symbols)} ({error}); use SymPy functions "
            "(sympy.sin, sympy.Piecewise), not math or numpy ones"
        ) from error
    if not isinstance(found, sympy.Expr) or found.free_symbols - set(symbols):
        raise ModelError(
            f"{owner}: {what} {found} is not an expression of {_listed(symbols)} alone; insert the numbers"
        )
    if found.has(sympy.nan, sympy.oo, -sympy.oo, sympy.zoo, sympy.I):
        raise ModelError(f"{owner}: {what} {found} is not real and finite; correct the formula")
    return found


def _check_energy(name: str, sigma: Any, stored: Any, e: Any) -> None:
    """The derivative of the stored energy must be the stress at rest; compared at a few points."""
    slope = stored.diff(e)
    for point in (-0.731, -0.219, 0.137, 0.613):
        want, got = (complex(z.subs(e, point).evalf()) for z in (sigma, slope))
        if abs(want - got) > 1e-9 * max(abs(want), abs(got)):  # false for NaN: outside the domain
            raise ModelError(
                f"law on '{name}': the derivative of the energy, {slope}, is not the stress at rest, {sigma}; "
                "correct one of them"
            )


def _listed(symbols: tuple[Any, ...]) -> str:
    return ", ".join(str(z) for z in symbols)
