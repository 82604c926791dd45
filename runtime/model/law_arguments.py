"""Checks of the arguments and numbers of a law, before it becomes part of a model."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from flexel.base.arguments import array, names, numbers, unknown
from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.derive.spec import LawSpec
from flexel.model.signs import check_signs


def check_arguments(owner: str, spec: LawSpec, on: Sequence[str], kinds: Sequence[str]) -> None:
    """Check that a law acts on as many deformations, then slips, as it has, each once."""
    m, k = spec.deformations, spec.slips
    if len(on) != m + k or len(set(on)) < len(on):
        raise ModelError(
            f"{owner}: {len(on)} names; give {m} deformations, then {k} slips, each once{listed_arguments(spec)}"
        )
    for wrong in [name for name, kind in zip(on[:m], kinds[:m], strict=True) if kind != "deformation"]:
        raise ModelError(f"{owner}: '{wrong}' is not a deformation; springs and formulas act on these")
    for wrong in [name for name, kind in zip(on[m:], kinds[m:], strict=True) if kind != "slip"]:
        raise ModelError(f"{owner}: '{wrong}' is not a slip; use m.spring(…, damping=…) on deformations")


def check_units(owner: str, spec: LawSpec, on: Sequence[str], units: Sequence[str]) -> None:
    """Check that the units of the quantities are those of the arguments, where the law states them."""
    for argument, name, unit in zip(spec.arguments, on, units, strict=False):
        if not argument.fits(unit):
            raise ModelError(
                f"{owner}: '{name}' is in {unit}, which does not fit argument {argument}; give them in this order"
                f"{listed_arguments(spec)}"
            )


def parameters_of_law(owner: str, spec: LawSpec, given: Mapping[str, Any]) -> dict[str, Array]:
    """Return numbers for each of the law's parameters, with sizes and signs checked."""
    known = [parameter.name for parameter in spec.parameters]
    for wrong in [name for name in given if name not in known]:
        raise ModelError(f"{owner}: {unknown(wrong, known, 'parameter')}")
    if missing := [f"{p.name} [{p.unit}] ({p.doc})" for p in spec.parameters if p.name not in given]:
        raise ModelError(f"{owner}: parameters are missing: {', '.join(missing)}")
    values = {}
    for parameter in spec.parameters:
        value = array(given[parameter.name], owner, f"parameter {parameter.name}").reshape(-1)
        if value.size != parameter.size:
            raise ModelError(
                f"{owner}: parameter {parameter.name} has {value.size} numbers; it needs {parameter.size}"
            )
        values[parameter.name] = value
    check_signs(spec.parameters, values, owner)
    return values


def initial_states(owner: str, spec: LawSpec, given: Mapping[str, float] | None) -> tuple[float, ...]:
    """Return the initial values of a law's internal states; zero where none is given."""
    start = numbers(given, owner, "initial value")
    states = [state.name for state in spec.states]
    for wrong in [name for name in start if name not in states]:
        raise ModelError(f"{owner}: {unknown(wrong, states, 'internal state')}")
    return tuple(start.get(name, 0.0) for name in states)


def in_order(owner: str, spec: LawSpec, on: Sequence[str] | Mapping[str, str]) -> tuple[str, ...]:
    """Return the quantities on which a law acts in the law's order, where its arguments give them."""
    if not isinstance(on, Mapping):
        return names(on, owner)
    known = [argument.name for argument in spec.arguments]
    for wrong in [name for name in on if name not in known]:
        raise ModelError(f"{owner}: {unknown(str(wrong), known, 'argument')}")
    if missing := [str(argument) for argument in spec.arguments if argument.name not in on]:
        raise ModelError(f"{owner}: arguments are missing: {', '.join(missing)}; name a quantity for each")
    return names([on[name] for name in known], owner)


def label_of(on: Sequence[str]) -> str:
    """Return the element on which a law of several quantities acts, otherwise their names, joined."""
    elements = {name.rpartition(".")[0] for name in on}
    return elements.pop() if len(on) > 1 and len(elements) == 1 else " ".join(on)


def listed_arguments(spec: LawSpec) -> str:
    """List the arguments of a law with their units, for a message; return an empty text if it states none."""
    return (
        f": {', '.join(map(str, spec.arguments))}"
        if any(argument.unit for argument in spec.arguments)
        else ""
    )
