"""Laws given by formulas: compiled with exact tangents, and verified as `flexel.compile_law` does.

The derivation (SymPy, flexel.derive) is imported only when a formula is given; the results are cached by
content, so that a formula is derived, compiled and verified once.
"""

from __future__ import annotations

import inspect
from collections.abc import Callable
from typing import Any

import numpy as np

from flexel.base.errors import CompilerError, ModelError

# Half widths of the ranges over which a formula is examined, in the order of trial.
WIDTHS = (1.0, 0.1, 0.01, 10.0, 100.0)
PLACES = 400  # sample places in a range; zero is not among them
FEWEST = 20  # minimum number of neighbouring places where it is real and finite
RATES = (-1.3, 0.7)


def formula_law(owner: str, stress: Any, energy: Callable[..., Any] | None = None) -> Any:
    """Compile and verify σ = stress(e, ė) on one deformation.

    Parameters
    ----------
    owner : str
        For messages, such as ``law on 'strut.elongation'``.
    stress : callable(e) or callable(e, ed) -> sympy expression
    energy : callable(e) -> sympy expression, optional

    Returns
    -------
    flexel.derive.compile.CompiledLaw
        Specification and kernels.

    Raises
    ------
    ModelError
        If the function does not return an expression of e and ed, jumps or has no value beyond an end of its pieces,
        the energy does not match it, or the verification fails.
    CompilerError
        If there is no C compiler.
    """
    import sympy

    from flexel.derive import Law, symbol
    from flexel.derive.cache import CacheError
    from flexel.derive.check.joins import check_law_joins
    from flexel.derive.shared_object import CompilationError, CompilerMissingError

    e, ed = symbol("e"), symbol("ed")
    sigma = _formula(owner, "stress", of_both(stress), e, ed)
    try:
        check_law_joins(owner, sigma)
    except ValueError as error:
        raise ModelError(str(error)) from error
    if energy is None:
        stored = sympy.integrate(sigma.subs(ed, 0), (e, 0, e))
        if not isinstance(stored, sympy.Expr) or stored.has(sympy.Integral, sympy.nan, sympy.oo, sympy.zoo):
            raise ModelError(f"{owner}: SymPy finds no stored energy; give it as energy=lambda e: …")
    else:
        stored = _formula(owner, "energy", energy, e)
    try:
        law = Law(
            "formula", f"sigma = {sigma}", (), (e,), (ed,), (), (sigma,), (), stored, "formula of the user"
        )
        return _verified(law)
    except (CompilerMissingError, CompilationError, CacheError) as error:
        raise CompilerError(f"{owner}: {error}") from error
    except (ValueError, TypeError, NotImplementedError, KeyError, AttributeError) as error:
        text = str(error).removeprefix("law 'formula': ")
        raise ModelError(
            f"{owner}: {sigma} cannot be used ({text}); use elementary functions and Piecewise, or compile it with "
            "fx.compile_law"
        ) from error


def of_both(stress: Any) -> Any:
    """The stress as a function of e and ed, where it is one of e alone."""
    try:
        parameters = inspect.signature(stress).parameters.values()
    except (TypeError, ValueError):
        return stress  # reported below, from what it returns
    asked = [
        z
        for z in parameters
        if z.default is z.empty and z.kind in (z.POSITIONAL_ONLY, z.POSITIONAL_OR_KEYWORD)
    ]
    variadic = any(z.kind is z.VAR_POSITIONAL for z in parameters)
    return (lambda e, ed: stress(e)) if len(asked) == 1 and not variadic else stress


def _verified(law: Any) -> Any:
    """The compiled law, verified over the first of the widths where it is real and numerically accurate."""
    from flexel.derive.accept import VerificationError, accepted_law

    *first, last = [z for z in (_real(law, width) for width in WIDTHS) if z] or [(-1.0, 1.0)]
    for between in first:
        try:
            return accepted_law(law, {"e": between})
        except VerificationError:  # such as numerical differences of a high power over a wide range
            continue
    return accepted_law(law, {"e": last})


def _real(law: Any, width: float) -> tuple[float, float] | None:
    """The longest part of (-width, width) where stress, tangents and energy are real and finite; None for none."""
    import sympy

    (e, ed), sigma = (law.e[0], law.ed[0]), law.sigma[0]
    places = (np.arange(PLACES) + 0.5) * (2 * width / PLACES) - width
    with np.errstate(all="ignore"):
        try:
            f = sympy.lambdify(
                (e, ed), [sigma, sigma.diff(e), sigma.diff(ed), law.energy], ["numpy", "scipy"]
            )
            values = [np.broadcast_to(z, places.shape) for rate in RATES for z in f(places, rate)]
            fine = np.all([np.isreal(z) & np.isfinite(z) for z in values], axis=0)
        except (TypeError, ValueError, NameError, AttributeError, KeyError, NotImplementedError):
            return None  # a function unknown to NumPy: the derivation reports what is wrong
    ends = np.flatnonzero(np.diff(np.concatenate([[0], fine, [0]])))
    first, last = max(zip(ends[::2], ends[1::2] - 1, strict=True), key=np.ptp, default=(0, 0))
    return (float(places[first + 1]), float(places[last - 1])) if last - first >= FEWEST else None


def _formula(owner: str, what: str, function: Any, *symbols: Any) -> Any:
    """Call the user's function with symbols: a finite real expression of these alone, or a ModelError."""
    import sympy

    if not callable(function):
        raise ModelError(
            f"{owner}: {what} {function!r} is not a function; write lambda {_listed(symbols)}: …"
        )
    try:
        found = sympy.sympify(function(*symbols))
    except Exception as error:  # a user's function may raise anything
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


def _listed(symbols: tuple[Any, ...]) -> str:
    return ", ".join(str(z) for z in symbols)
