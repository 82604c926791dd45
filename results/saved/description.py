"""Converts the structure of a mechanism to text and numbers and back, for files that are read without its model."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, replace
from typing import Any

import numpy as np

from flexel.base.arrays import Array
from flexel.base.units import force_unit, rate_unit
from flexel.derive.spec import (
    DeformationSpec,
    ElementSpec,
    InternalSpec,
    LawSpec,
    NodeSpec,
    ParameterSpec,
    SlipSpec,
    TermSpec,
)
from flexel.generated.table import ELEMENTS
from flexel.model.instances import Instance, LawInstance
from flexel.model.node import Node
from flexel.model.structure import Structure, assemble_structure
from flexel.parts.closed_profile import ClosedProfile
from flexel.parts.looks import Look
from flexel.parts.materials import Material, Profile
from flexel.parts.round_sections import Circle, Tube
from flexel.parts.sections import IBeam, Rectangle
from flexel.parts.thin_sections import LBeam, UBeam

SECTIONS = {
    section.__name__: section for section in (Circle, ClosedProfile, IBeam, LBeam, Rectangle, Tube, UBeam)
}


def described(structure: Structure) -> dict[str, Any]:
    """Describe nodes, elements and laws in text and numbers."""
    return {
        "nodes": [
            {"name": node.name, "kind": node.kind, "x0": node.x0.tolist(), "fixed": node.fixed.tolist()}
            for node in structure.nodes
        ],
        "elements": [_element(instance) for instance in structure.instances],
        "laws": [
            {
                "name": law.name,
                "type": law.spec.name,
                "deformations": law.deformations,
                "slips": law.slips,
                "parameters": _numbers(law.parameters),
                "states": [(state.name, state.unit) for state in law.spec.states],
                "z0": law.z0,
            }
            for law in structure.laws
        ],
    }


def _element(instance: Instance) -> dict[str, Any]:
    return {
        "name": instance.name,
        "type": instance.spec.name,
        "nodes": instance.nodes,
        "ends": [(node.name, node.kind) for node in instance.spec.nodes],
        "deformations": [_deformation(d) for d in instance.spec.deformations],
        "family": instance.spec.family,
        "picture": instance.spec.picture,
        "slips": [(s.name, s.unit, s.free) for s in instance.spec.slips],
        "parameters": _numbers(instance.parameters),
        "mass_damping": instance.mass_damping,
        "terms": None if instance.terms is None else dict(instance.terms),
        "profile": _profile(instance.profile),
        "look": _look(instance.look),
    }


def _deformation(d: DeformationSpec) -> tuple[object, ...]:
    return d.name, d.unit, d.free, [(term.factor, term.powers) for term in d.period], d.kind


def _deformation_spec(name: str, unit: str, free: bool, period: Any, kind: str) -> DeformationSpec:
    terms = tuple(TermSpec(factor, tuple((name, i, n) for name, i, n in powers)) for factor, powers in period)
    return DeformationSpec(name, unit, free, terms, kind)


def _profile(profile: object) -> dict[str, Any] | None:
    """Describe section and material of a beam; user-defined section classes are omitted: only pictures use them."""
    if not isinstance(profile, Profile) or type(profile.section) not in SECTIONS.values():
        return None
    section = profile.section
    return {
        "section": type(section).__name__,
        "sizes": asdict(section),  # type: ignore[call-overload]
        "material": asdict(profile.material),
    }


def _look(look: object) -> dict[str, Any] | None:
    """Describe how an element is shown; user-defined section classes are omitted."""
    if not isinstance(look, Look):
        return None
    known = type(look.section) in SECTIONS.values()
    section = {"section": type(look.section).__name__, "sizes": asdict(look.section)} if known else None  # type: ignore[call-overload]
    return {"drawn": section, "colour": look.colour, "opacity": look.opacity, "hidden": look.hidden}


def _look_of(given: dict[str, Any] | None) -> Look | None:
    if given is None:
        return None
    drawn = given["drawn"]
    section = None if drawn is None else SECTIONS[drawn["section"]](**drawn["sizes"])
    return Look(section, given["colour"], given["opacity"], given["hidden"])


def _numbers(parameters: Mapping[str, Array]) -> dict[str, Any]:
    return {name: np.asarray(value, dtype=float).tolist() for name, value in parameters.items()}


def structure_of(description: Mapping[str, Any]) -> Structure:
    """Rebuild the structure of a description: original names, units and drawing data, without compiled kernels."""
    nodes = [
        Node(
            node["name"], node["kind"], np.array(node["x0"], dtype=float), np.array(node["fixed"], dtype=bool)
        )
        for node in description["nodes"]
    ]
    instances = []
    for element in description["elements"]:
        values = {name: np.array(value, dtype=float) for name, value in element["parameters"].items()}
        profile = element["profile"]
        if profile is not None:
            profile = Profile(
                SECTIONS[profile["section"]](**profile["sizes"]), Material(**profile["material"])
            )
        damping = float(element["mass_damping"])
        instances.append(
            Instance(
                element["name"],
                _spec(element, values),
                tuple(element["nodes"]),
                values,
                None,
                profile,
                damping,
                element.get("terms"),
                _look_of(element.get("look")),
            )
        )
    return assemble_structure(nodes, instances, [_law(law) for law in description["laws"]])


def _spec(stored: Mapping[str, Any], values: Mapping[str, Array]) -> ElementSpec:
    """Return the built-in element of that type if it is unchanged, otherwise one without kernels."""
    spec = ElementSpec(
        name=stored["type"],
        digest="",
        doc="",
        source="",
        nodes=tuple(NodeSpec(*end) for end in stored["ends"]),
        parameters=tuple(ParameterSpec(name, value.size, "", "") for name, value in values.items()),
        deformations=tuple(_deformation_spec(*d) for d in stored["deformations"]),
        slips=tuple(SlipSpec(*s) for s in stored["slips"]),
        kernels={},
        family=stored["family"],
        picture=stored["picture"],
    )
    known = ELEMENTS.get(spec.name)
    return known if known is not None and _outside(known) == _outside(spec) else spec


def _outside(spec: ElementSpec) -> tuple[object, ...]:
    """Return the part of an element that the structure of a result needs; its kinks matter only in models."""
    parameters = {(parameter.name, parameter.size) for parameter in spec.parameters}
    return spec.nodes, [replace(d, kinked=False) for d in spec.deformations], spec.slips, parameters


def _law(stored: Mapping[str, Any]) -> LawInstance:
    values = {name: np.array(value, dtype=float) for name, value in stored["parameters"].items()}
    parameters = tuple(ParameterSpec(name, value.size, "", "") for name, value in values.items())
    on, slips = tuple(stored["deformations"]), tuple(stored["slips"])
    states = tuple(InternalSpec(*state) for state in stored["states"])
    spec = LawSpec(stored["type"], "", "", len(on), len(slips), states, parameters, {})
    return LawInstance(stored["name"], spec, on, slips, values, None, tuple(stored["z0"]))


def quantity_units(structure: Structure) -> dict[str, tuple[str, ...]]:
    """Return the units of values, rates, accelerations and forces of all quantities; slips have no value."""
    m, first = structure.m, structure.m + structure.k
    slips = [m <= i < first for i in range(len(structure.names))]
    pairs = list(zip(structure.units, slips, strict=True))
    return {
        "value": tuple("" if slip else unit for unit, slip in pairs),
        "rate": tuple(rate_unit(unit, 0 if slip else 1) for unit, slip in pairs),
        "acceleration": tuple(rate_unit(unit, 1 if slip else 2) for unit, slip in pairs),
        "force": tuple(force_unit(unit, slip) for unit, slip in pairs),
    }
