"""Gives forces and stresses in the end sections of beams at a state.

The forces are outputs of the element, see `derive/elements/section_outputs.py`.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Protocol

import numpy as np

from flexel.base.arguments import unknown
from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.model.instances import Instance
from flexel.model.profiles import SectionForces, SectionOfMaterial, StressPoint
from flexel.model.structure import Structure

SECTION_FORCES = ("force_p", "moment_p", "force_q", "moment_q")  # outputs of a beam


class ElementOutputs(Protocol):
    """A state, as far as forces in beams need it."""

    @property
    def structure(self) -> Structure:
        """Names and index maps."""

    def outputs(self, element: str) -> dict[str, Array]:
        """Return what an element reports, by name."""


@dataclass(frozen=True)
class BeamStress:
    """Largest stress in the end sections of a beam.

    Attributes
    ----------
    beam : str
    end : str
        "p" or "q": the end with the largest equivalent stress.
    forces : SectionForces
        Forces at that end.
    point : StressPoint
        Position in the section, normal and shear stress [Pa].
    strength : float or None
        Strength of the material [Pa].
    """

    beam: str
    end: str
    forces: SectionForces
    point: StressPoint
    strength: float | None

    @property
    def mises(self) -> float:
        """Equivalent stress of von Mises [Pa]."""
        return self.point.mises

    @property
    def safety(self) -> float | None:
        """Strength over equivalent stress; None without a strength."""
        return None if self.strength is None else self.strength / self.mises if self.mises else np.inf


def section_forces(state: ElementOutputs, beam: str) -> tuple[SectionForces, SectionForces]:
    """Return the forces in the sections at both ends of a beam; see `State.section_forces`."""
    found = state.outputs(_find(state, beam).name)
    return end_forces(found, "p"), end_forces(found, "q")


def end_forces(found: Mapping[str, Array], end: str) -> SectionForces:
    """Return the forces at the end "p" or "q" from a beam's outputs; in the plane there is one moment, about z."""
    N, Vy, Vz = np.append(found[f"force_{end}"], 0.0)[:3]
    T, My, Mz = np.append([0.0, 0.0], found[f"moment_{end}"])[-3:]
    B = found[f"bimoment_{end}"][0] if f"bimoment_{end}" in found else 0.0
    return SectionForces(*map(float, (N, Vy, Vz, T, My, Mz, B)))


def beam_stress(state: ElementOutputs, beam: str) -> BeamStress:
    """Return the largest equivalent stress in the end sections of a beam; see `State.stress`."""
    profile = _find(state, beam).profile
    if not isinstance(profile, SectionOfMaterial):
        raise ModelError(f"beam '{beam}' has no section, only stiffnesses; give it section= and material=")
    found = [
        BeamStress(beam, end, forces, point, profile.material.strength)
        for end, forces in zip("pq", section_forces(state, beam), strict=True)
        for point in profile.section.stresses(forces)
    ]
    return max(found, key=lambda stress: stress.mises)


def largest_stress(state: ElementOutputs) -> BeamStress:
    """Return the largest equivalent stress in all beams; see `State.largest_stress`."""
    beams = [
        instance.name
        for instance in state.structure.instances
        if instance.profile is not None and instance.spec.reports(*SECTION_FORCES)
    ]
    if not beams:
        raise ModelError("no beam has a section; give one to m.beam(…, section=, material=)")
    return max((beam_stress(state, name) for name in beams), key=lambda stress: stress.mises)


def _find(state: ElementOutputs, beam: str) -> Instance:
    """Return a beam that reports its section forces."""
    instances = state.structure.instances
    found = next((one for one in instances if isinstance(beam, str) and one.name == beam), None)
    if found is not None and found.spec.reports(*SECTION_FORCES):
        return found
    if found is not None and found.spec.arm:
        raise ModelError(
            f"beam '{beam}': the element '{found.spec.name}' reports no section forces; declare outputs force_p, "
            "moment_p, force_q and moment_q, as flexel.derive.elements.section_outputs does"
        )
    beams = [instance.name for instance in instances if instance.spec.reports(*SECTION_FORCES)]
    raise ModelError(unknown(str(beam), beams, "beam with two frames"))
