"""Laws given by formulas: compiled with exact tangents, and verified as in `flexel.compile_law`.

The derivation (SymPy, flexel.derive) is imported only when a formula is given; the results are cached by
content, so that a formula is derived and verified once, and compiled once with all that differ in numbers only.
"""

from __future__ import annotations

import inspect
import warnings
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from flexel.base.arrays import Array
from flexel.base.callers import outside
from flexel.base.errors import CompilerError, ModelError, ModelWarning
from flexel.derive.spec import FORMULA_NUMBERS

# Half widths of the ranges over which a formula is examined, in the order of trial.
WIDTHS = (1.0, 0.1, 0.01, 10.0, 100.0)
PLACES = 400  # sample places in a range; zero is not among them
FEWEST = 20  # minimum number of neighbouring places where it is real and finite
RATES = (-1.3, 0.7)
SECONDS = (0.0, 1.0)  # the range of times over which a formula is examined
RANGED = ("e", "ed", "t")


@dataclass(frozen=True)
class Formula:
    """A compiled formula.

    Attributes
    ----------
    law : CompiledLaw
        Shared by all formulas that differ in their numbers only.
    parameters : dict of str to Array
        The numbers of this one.
    knots : tuple of float
        Times [s] at which it is not smooth.
    """

    law: Any
    parameters: dict[str, Array]
    knots: tuple[float, ...] = ()


def formula_law(
    owner: str,
    stress: Any,
    energy: Callable[..., Any] | None = None,
    ranges: Mapping[str, tuple[float, float]] | None = None,
) -> Formula:
    """Compile and verify σ = stress(e, ė, t) on one deformation.

    Parameters
    ----------
    owner : str
        For messages, such as ``law on 'strut.elongation'``.
    stress : callable(e), callable(e, ed) or callable(e, ed, t) -> sympy expression
    energy : callable(e) -> sympy expression, optional
        By default the integral of the terms without t from zero: in closed form, or by Gauss's rule over the range of
        e, or none, with a warning.
    ranges : mapping of str to (float, float), optional
        Where ``e``, ``ed`` and ``t`` lie; the law is verified there.

    Returns
    -------
    Formula

    Raises
    ------
    ModelError
        If the function does not return an expression of e, ed and t, jumps or has no value beyond an end of its pieces,
        the energy does not match it, or the verification fails.
    CompilerError
        If there is no C compiler.
    """
    from flexel.derive import TIME, symbol
    from flexel.derive.cache import CacheError
    from flexel.derive.check.joins import check_law_joins
    from flexel.derive.energy import kinks
    from flexel.derive.shared_object import CompilationError, CompilerMissingError

    e, ed = symbol("e"), symbol("ed")
    sigma = _formula(owner, "stress", of_all(stress), e, ed, TIME)
    limits = _limits(owner, sigma, ranges)
    try:
        check_law_joins(owner, sigma)
    except ValueError as error:
        raise ModelError(str(error)) from error
    try:
        if energy is not None:
            found = _verified(_declared(sigma, _formula(owner, "energy", energy, e)), limits)
        else:
            found = _with_an_energy(owner, sigma, limits)
        return replace(found, knots=kinks(sigma, TIME))
    except (CompilerMissingError, CompilationError, CacheError) as error:
        raise CompilerError(f"{owner}: {error}") from error
    except (ValueError, TypeError, NotImplementedError, KeyError, AttributeError) as error:
        text = str(error).removeprefix("law 'formula': ")
        raise ModelError(
            f"{owner}: {sigma} cannot be used ({text}); use elementary functions and Piecewise, or compile it with "
            "fx.compile_law"
        ) from error


def _declared(sigma: Any, stored: Any) -> Any:
    """Declare a formula with an energy."""
    from flexel.derive import Law, symbol

    e, ed = symbol("e"), symbol("ed")
    return Law(
        "formula", f"sigma = {sigma}", (), (e,), (ed,), (), (sigma,), (), stored, "formula of the user"
    )


def _limits(
    owner: str, sigma: Any, ranges: Mapping[str, tuple[float, float]] | None
) -> dict[str, tuple[float, float]]:
    """Return the ranges, checked; nothing for none."""
    import sympy

    from flexel.derive.verify.samples import check_ranges

    if ranges is None:
        return {}
    if not isinstance(ranges, Mapping) or (wrong := [name for name in ranges if name not in RANGED]):
        shown = repr(ranges) if not isinstance(ranges, Mapping) else f"'{wrong[0]}'"
        raise ModelError(
            f"{owner}: ranges of {shown}; give ranges={{'e': (lowest, highest)}}, or also for 'ed' or 't'"
        )
    try:
        check_ranges(_declared(sigma, sympy.S.Zero), ranges)
    except ValueError as error:
        text = str(error).removeprefix("'formula': ")
        raise ModelError(f"{owner}: {text}; give increasing, finite numbers") from error
    return {name: (float(low), float(high)) for name, (low, high) in ranges.items()}


def _with_an_energy(owner: str, sigma: Any, limits: dict[str, tuple[float, float]]) -> Formula:
    """Compile the law with the first of its energies that passes: closed form, Gauss's rule, none."""
    import sympy

    from flexel.derive import symbol
    from flexel.derive.energy import by_gauss, closed_form

    at_rest = _without_time(sigma.subs(symbol("ed"), 0))
    if not at_rest.subs(symbol("e"), 0).is_finite:
        raise ModelError(
            f"{owner}: {sigma} has no finite value at e = 0, from which its energy is measured; give "
            "energy=lambda e: …"
        )
    tried = [closed_form(at_rest, symbol("e"))]
    if "e" in limits:
        tried.append(by_gauss(at_rest, symbol("e"), *limits["e"]))
    for stored in tried:
        if stored is None:
            continue
        try:
            return _verified(_declared(sigma, stored), limits)
        except ValueError:  # its digits, or its functions: the next one may do
            continue
    bare = _verified(_declared(sigma, sympy.S.Zero), limits)  # raises what is wrong with the formula itself
    remedy = "give energy=lambda e: …" + ("" if "e" in limits else ", or ranges={'e': (lowest, highest)}")
    warnings.warn(
        f"{owner}: no stored energy of {sigma} was found; results count its work as dissipated: {remedy}",
        ModelWarning,
        stacklevel=outside(),
    )
    return bare


def _without_time(stress: Any) -> Any:
    """Return the terms of a stress that do not depend on time: these store energy, the others do work."""
    from flexel.derive import TIME

    if TIME not in stress.free_symbols:
        return stress
    return stress.expand().as_independent(TIME, as_Add=True)[0]


def of_all(stress: Any) -> Any:
    """Return the stress as a function of e, ed and t, where it is one of e, or of e and ed."""
    try:
        parameters = inspect.signature(stress).parameters.values()
    except (TypeError, ValueError):
        return stress  # reported below, from what it returns
    asked = [
        item
        for item in parameters
        if item.default is item.empty and item.kind in (item.POSITIONAL_ONLY, item.POSITIONAL_OR_KEYWORD)
    ]
    variadic = any(item.kind is item.VAR_POSITIONAL for item in parameters)
    if len(asked) == 1 and not variadic:
        return lambda e, ed, t: stress(e)
    return stress if len(asked) == 3 else lambda e, ed, t: stress(e, ed)


def _verified(law: Any, limits: dict[str, tuple[float, float]]) -> Formula:
    """Compile and verify the law in its limits, or over the first width where it is real and accurate."""
    from flexel.derive import TIME
    from flexel.derive.definition_errors import VerificationError
    from flexel.derive.energy import kinks

    if TIME in law.sigma[0].free_symbols:
        limits = {"t": SECONDS, **limits}
    forms = _forms(law)
    if "e" in limits:
        return _accepted(forms, limits)
    # the formula is examined on both sides of its kinks
    farthest = max((2 * abs(place) for place in kinks(law.sigma[0], law.e[0])), default=0.0)
    widths = (farthest, *WIDTHS) if farthest > WIDTHS[0] else WIDTHS
    failed: VerificationError | None = None
    for width in widths:
        if (between := _real(law, width, limits.get("t", SECONDS))) is not None:
            try:
                return _accepted(forms, {**limits, "e": between})
            except VerificationError as error:  # such as differences of a high power over a wide range
                failed = error
    if failed is not None:
        raise failed
    return _accepted(forms, {**limits, "e": (-1.0, 1.0)})


def _forms(law: Any) -> list[tuple[Any, tuple[float, ...]]]:
    """Return a law with its numbers as parameters and their values, if it has any, and as it is; with their kinks."""
    from flexel.derive.begins import with_begins
    from flexel.derive.general import general

    shape, values = general(law)
    shape = with_begins(shape, values)
    if not values:
        return [(shape, ())]
    numbers = dict(zip(shape.parameter_symbols, values, strict=True))
    fixed = replace(law, begins=tuple(line.subs(numbers) for line in shape.begins))
    return [(shape, values), (fixed, ())]


def _accepted(forms: list[tuple[Any, tuple[float, ...]]], limits: dict[str, tuple[float, float]]) -> Formula:
    """Compile and verify a law with its numbers as parameters, or with fixed numbers where that fails."""
    from flexel.derive.accept import accepted_law

    *with_numbers, (law, _) = forms
    for shape, values in with_numbers:
        fixed = {symbol.name: (z, z) for symbol, z in zip(shape.parameter_symbols, values, strict=True)}
        try:
            return Formula(accepted_law(shape, {**limits, **fixed}), {FORMULA_NUMBERS: np.array(values)})
        except (
            ValueError
        ):  # such as a base that must be a number: what is wrong with the law itself is found below
            pass
    return Formula(accepted_law(law, limits), {})


def _real(law: Any, width: float, times: tuple[float, float]) -> tuple[float, float] | None:
    """Return the longest part of (-width, width) where stress, tangents and energy are finite; None for none."""
    import sympy

    from flexel.derive import TIME

    (e, ed), sigma = (law.e[0], law.ed[0]), law.sigma[0]
    places = (np.arange(PLACES) + 0.5) * (2 * width / PLACES) - width
    with np.errstate(all="ignore"):
        try:
            f = sympy.lambdify(
                (e, ed, TIME), [sigma, sigma.diff(e), sigma.diff(ed), law.energy], ["numpy", "scipy"]
            )
            values = [
                np.broadcast_to(found, places.shape)
                for rate in RATES
                for t in np.linspace(*times, 5)[1:-1].tolist()
                for found in f(places, rate, t)
            ]
            fine = np.all([np.isreal(value) & np.isfinite(value) for value in values], axis=0)
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
    return ", ".join(map(str, symbols))
