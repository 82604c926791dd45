"""Finds values that suggest a different unit, and parts without effect.

Every engineering material lies well within the limits.  A finding is a suspicion, not an error.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from flexel.base.shown import listed
from flexel.mechanics.findings import Finding
from flexel.model.instances import Instance
from flexel.model.lowering import Lowering
from flexel.model.profiles import SectionOfMaterial
from flexel.model.stress import SECTION_FORCES
from flexel.model.structure import Structure

SOFTEST, STIFFEST = 1e6, 2e12  # Young's modulus [Pa]: soft rubber, twice diamond
LIGHTEST, HEAVIEST = 10.0, 3e4  # density [kg/m³]: foam, beyond osmium
GRAVITY = 300.0  # [m/s²], above that of Jupiter and the sun; 9810 would be mm/s²
ROUND_DEGREES = 15  # of which round angles are multiples
MASS_UNIT = "kg"  # how the units of parameters begin that are masses, or masses per length
TURNS = 4 * np.pi  # an initial angle beyond two turns is probably in degrees
SLENDER = 1.0  # depth of a section over the size of the model
FOLLOWING = 1.0  # length of a cable's element over the radius of a circle
SHOWN = 2  # elements named in one finding
POINTS = ("point", "planar_point")
SHORT = 1e-6  # length of an element over the size of the model


def suspects(model: Lowering, structure: Structure, size: float) -> list[Finding]:
    """Find suspicious units and elements.

    Parameters
    ----------
    model : Lowering
    structure : Structure
        Its structure.
    size : float
        Extent of the model [m].
    """
    found: list[Suspicion] = []
    for instance in structure.instances:
        if isinstance(instance.profile, SectionOfMaterial):
            found += _profile(instance, instance.profile, size)
        found += _short(model, instance, size)
    found += _idle(model)
    return [*_gravity(model, structure), *_angles(model, structure), *_grouped(found), *_coarse(structure)]


@dataclass(frozen=True)
class Suspicion:
    """A suspicion about one element or node, and its wording for several that share it."""

    subject: str
    kind: str
    name: str
    text: str
    many: str = ""


def _grouped(found: list[Suspicion]) -> Iterator[Finding]:
    """Combine all elements or nodes of a kind that share a text in one finding."""
    groups: dict[tuple[str, str, str], list[Suspicion]] = {}
    for one in found:
        groups.setdefault((one.subject, one.kind, one.text), []).append(one)
    for (subject, kind, text), group in groups.items():
        names = listed([f"'{one.name}'" for one in group], SHOWN)
        message = f"{kind} {names}{text}" if len(group) == 1 else f"{kind}s {names}{group[0].many or text}"
        yield Finding("warning", subject, message)


def _units(message: str) -> Finding:
    return Finding("warning", "units", message)


def _has_mass(instance: Instance) -> bool:
    """Whether a parameter of an element that is a mass is not zero."""
    masses = [p.name for p in instance.spec.parameters if p.unit.startswith(MASS_UNIT)]
    return any(np.any(instance.parameters[name]) for name in masses)


def _gravity(model: Lowering, structure: Structure) -> Iterator[Finding]:
    g = float(np.linalg.norm(model.gravity))
    if g > GRAVITY:
        yield _units(f"gravity of {g:.4g} m/s² looks like mm/s²; lengths are in metres")
    points = [node.kind for node in structure.nodes if node.kind.endswith("point")]
    if g and not np.any(model.gravity[:2]) and all(kind == "planar_point" for kind in points):
        yield Finding(
            "warning",
            "loads",
            f"gravity along z does not act in a planar model, whose points are (x, y); give gravity=(0, {-g:.4g})",
        )
    heavy = [instance for instance in structure.instances if "gravity" in instance.parameters]
    if g and heavy and not any(map(_has_mass, heavy)):
        yield Finding(
            "warning", "loads", "gravity acts on no mass; give masses to bodies, points, beams or trusses"
        )


def _angles(model: Lowering, structure: Structure) -> Iterator[Finding]:
    units = dict(zip(structure.names, structure.units, strict=True))
    for name, value in model.values.items():
        if units.get(name) == "rad" and abs(value) > TURNS:
            yield _units(f"initial value {_in_degrees(name, value)}")


def in_degrees(name: str, unit: str, value: float) -> str:
    """Say that a value given for an angle of a state is probably in degrees: a round one within a turn of these.

    A wheel may have turned by any number of radians.
    """
    likely = unit == "rad" and TURNS < abs(value) <= 360 and value % ROUND_DEGREES == 0
    return _in_degrees(name, value) if likely else ""


def _in_degrees(name: str, value: float) -> str:
    return f"{value:.4g} rad of '{name}' looks like degrees; angles are in radians"


def _profile(beam: Instance, profile: SectionOfMaterial, size: float) -> Iterator[Suspicion]:
    E, rho = profile.material.E, profile.material.rho
    if not SOFTEST <= E <= STIFFEST:
        text = f": Young's modulus E = {E:.4g} Pa looks like another unit; steel has 210e9 Pa"
        yield Suspicion("units", "beam", beam.name, text)
    if rho and not LIGHTEST <= rho <= HEAVIEST:
        text = f": density {rho:.4g} kg/m³ looks like another unit; steel has 7850 kg/m³"
        yield Suspicion("units", "beam", beam.name, text)
    inertia = max(profile.section.Iy, profile.section.Iz)
    depth = 2 * float(np.sqrt(inertia / profile.section.A))
    if depth > SLENDER * size:  # an element of a wide leaf may be shorter than the leaf is wide
        text = (
            f": the section is {depth:.3g} m deep (twice the radius of gyration) in a model of {size:.3g} m; sections "
            "are also given in metres, and a beam is longer than it is deep"
        )
        yield Suspicion("units", "beam", beam.name, text)


def _length(model: Lowering, instance: Instance) -> float | None:
    """Return the distance between the ends of an element between two points, as drawn."""
    ends = [model.nodes[node].x0 for node in instance.nodes if model.nodes[node].kind in POINTS]
    return float(np.linalg.norm(ends[1] - ends[0])) if len(ends) == 2 else None


def _short(model: Lowering, instance: Instance, size: float) -> Iterator[Suspicion]:
    length, spec = _length(model, instance), instance.spec
    bar = all(node.kind in POINTS for node in spec.nodes)
    if length is not None and length < SHORT * size and (bar or spec.reports(*SECTION_FORCES)):
        text = f": only {length:.3g} m long in a model of {size:.3g} m; join the ends at one point"
        yield Suspicion("elements", instance.spec.family, instance.name, text)


def _coarse(structure: Structure) -> Iterator[Finding]:
    """Find cables whose elements are longer than the radius of a circle they may touch, one finding per circle."""
    longest: dict[str, tuple[float, float, str]] = {}
    for contact in structure.instances:
        if contact.spec.gaps and {"l0", "radius"} <= contact.parameters.keys():
            cable, _, circle = contact.name.rpartition("#")[0].rpartition("@")
            l0, radius = (float(contact.parameters[key][0]) for key in ("l0", "radius"))
            if l0 > FOLLOWING * radius * (1 + 1e-9):
                longest[circle] = max(longest.get(circle, (0.0, radius, "")), (l0, radius, cable))
    for circle, (l0, radius, cable) in longest.items():
        yield Finding(
            "warning",
            "mesh",
            f"'{cable}' of {l0:.4g} m cannot follow '{circle}', whose radius is {radius:.4g} m: an equilibrium may "
            "not be found; use elements of half the radius",
        )


def _idle(model: Lowering) -> Iterator[Suspicion]:
    used = {name for instance in model.instances.values() for name in instance.nodes}
    named = [name for instance in model.instances.values() for name in instance.terms or ()]
    measured = [name for controller in model.controllers for name in controller.inputs]
    used |= {name.partition(".")[0] for name in (*named, *model.motions, *measured)}
    for node in model.nodes.values():
        if node.name not in used and not np.all(node.fixed):
            yield Suspicion(
                "elements",
                node.kind,
                node.name,
                " belongs to no element; drop it, or connect it",
                " belong to no element; drop them, or connect them",
            )
