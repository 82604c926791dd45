"""The structure of a mechanism in text and numbers, and back: for files that are read without its model."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, replace
from typing import Any

import numpy as np

from flexel.base.arrays import Array
from flexel.base.units import force_unit, rate_unit
from flexel.declare.closed_profile import ClosedProfile
from flexel.declare.looks import Look
from flexel.declare.materials import Material, Profile
from flexel.declare.round_sections import Circle, Tube
from flexel.declare.sections import IBeam, Rectangle
from flexel.declare.thin_sections import LBeam, UBeam
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
from flexel.structure.instances import Instance, LawInstance
from flexel.structure.nodes import Node
from flexel.structure.structure import Structure, assemble_structure

SECTIONS = {z.__name__: z for z in (Circle, ClosedProfile, IBeam, LBeam, Rectangle, Tube, UBeam)}


def described(structure: Structure) -> dict[str, Any]:
    """Nodes, elements and laws in text and numbers."""
    return {
        "nodes": [
            {"name": z.name, "kind": z.kind, "x0": z.x0.tolist(), "fixed": z.fixed.tolist()}
            for z in structure.nodes
        ],
        "elements": [_element(z) for z in structure.instances],
        "laws": [
            {
                "name": z.name,
                "type": z.spec.name,
                "deformations": z.deformations,
                "slips": z.slips,
                "parameters": _numbers(z.parameters),
                "states": [(state.name, state.unit) for state in z.spec.states],
                "z0": z.z0,
            }
            for z in structure.laws
        ],
    }


def _element(z: Instance) -> dict[str, Any]:
    return {
        "name": z.name,
        "type": z.spec.name,
        "nodes": z.nodes,
        "ends": [(node.name, node.kind) for node in z.spec.nodes],
        "deformations": [_deformation(d) for d in z.spec.deformations],
        "family": z.spec.family,
        "picture": z.spec.picture,
        "slips": [(s.name, s.unit, s.free) for s in z.spec.slips],
        "parameters": _numbers(z.parameters),
        "mass_damping": z.mass_damping,
        "terms": None if z.terms is None else dict(z.terms),
        "profile": _profile(z.profile),
        "look": _look(z.look),
    }


def _deformation(d: DeformationSpec) -> tuple[object, ...]:
    return d.name, d.unit, d.free, [(term.factor, term.powers) for term in d.period], d.kind


def _deformation_spec(name: str, unit: str, free: bool, period: Any, kind: str) -> DeformationSpec:
    terms = tuple(TermSpec(factor, tuple((z, i, n) for z, i, n in powers)) for factor, powers in period)
    return DeformationSpec(name, unit, free, terms, kind)


def _profile(profile: object) -> dict[str, Any] | None:
    """Section and material of a beam; user-defined section classes are omitted: they are used only for pictures."""
    if not isinstance(profile, Profile) or type(profile.section) not in SECTIONS.values():
        return None
    section = profile.section
    return {
        "section": type(section).__name__,
        "sizes": asdict(section),  # type: ignore[call-overload]
        "material": asdict(profile.material),
    }


def _look(look: object) -> dict[str, Any] | None:
    """How an element is shown; user-defined section classes are omitted."""
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
    """The structure of a description: names, units and drawing data as they were, without compiled kernels."""
    nodes = [
        Node(z["name"], z["kind"], np.array(z["x0"], dtype=float), np.array(z["fixed"], dtype=bool))
        for z in description["nodes"]
    ]
    instances = []
    for z in description["elements"]:
        values = {name: np.array(value, dtype=float) for name, value in z["parameters"].items()}
        profile = z["profile"]
        if profile is not None:
            profile = Profile(
                SECTIONS[profile["section"]](**profile["sizes"]), Material(**profile["material"])
            )
        damping = float(z["mass_damping"])
        instances.append(
            Instance(
                z["name"],
                _spec(z, values),
                tuple(z["nodes"]),
                values,
                None,
                profile,
                damping,
                z.get("terms"),
                _look_of(z.get("look")),
            )
        )
    return assemble_structure(nodes, instances, [_law(z) for z in description["laws"]])


def _spec(z: Mapping[str, Any], values: Mapping[str, Array]) -> ElementSpec:
    """The built-in element of that type if it is still the same, otherwise one without kernels."""
    spec = ElementSpec(
        name=z["type"],
        digest="",
        doc="",
        source="",
        nodes=tuple(NodeSpec(*end) for end in z["ends"]),
        parameters=tuple(ParameterSpec(name, value.size, "", "") for name, value in values.items()),
        deformations=tuple(_deformation_spec(*d) for d in z["deformations"]),
        slips=tuple(SlipSpec(*s) for s in z["slips"]),
        kernels={},
        family=z["family"],
        picture=z["picture"],
    )
    known = ELEMENTS.get(spec.name)
    return known if known is not None and _outside(known) == _outside(spec) else spec


def _outside(spec: ElementSpec) -> tuple[object, ...]:
    """The part of an element that the structure of a result needs; its kinks matter in models only."""
    parameters = {(z.name, z.size) for z in spec.parameters}
    return spec.nodes, [replace(d, kinked=False) for d in spec.deformations], spec.slips, parameters


def _law(z: Mapping[str, Any]) -> LawInstance:
    values = {name: np.array(value, dtype=float) for name, value in z["parameters"].items()}
    parameters = tuple(ParameterSpec(name, value.size, "", "") for name, value in values.items())
    on, slips = tuple(z["deformations"]), tuple(z["slips"])
    states = tuple(InternalSpec(*state) for state in z["states"])
    spec = LawSpec(z["type"], "", "", len(on), len(slips), states, parameters, {})
    return LawInstance(z["name"], spec, on, slips, values, None, tuple(z["z0"]))


def quantity_units(structure: Structure) -> dict[str, tuple[str, ...]]:
    """Units of the values, rates, accelerations and forces of all quantities; slips have no value."""
    m, first = structure.m, structure.m + structure.k
    slips = [m <= i < first for i in range(len(structure.names))]
    pairs = list(zip(structure.units, slips, strict=True))
    return {
        "value": tuple("" if slip else unit for unit, slip in pairs),
        "rate": tuple(rate_unit(unit, 0 if slip else 1) for unit, slip in pairs),
        "acceleration": tuple(rate_unit(unit, 1 if slip else 2) for unit, slip in pairs),
        "force": tuple(force_unit(unit, slip) for unit, slip in pairs),
    }
