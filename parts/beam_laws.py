"""Elastic laws of a beam: one for each mode, or pair of modes, that its stiffnesses make flexible."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from flexel.base.arguments import LARGEST
from flexel.generated.table import LAWS

# [N] shear stiffness of a beam that does not shear; its shear number is zero to the last digit
NO_SHEAR = LARGEST
STIFFNESSES = ("EA", "GJ", "EIy", "EIz", "GAy", "GAz", "EIw")


@dataclass(frozen=True)
class BeamLaw:
    """An elastic law of a beam.

    Attributes
    ----------
    law : str
        Its name in the table of laws.
    modes : tuple of str
        The deformations on which it acts.
    renamed : mapping of str to str
        Names of its parameters in the beam, where they differ.
    """

    law: str
    modes: tuple[str, ...]
    renamed: Mapping[str, str] = field(default_factory=dict)

    @property
    def called(self) -> dict[str, str]:
        """Names of all of its parameters in the beam."""
        own = [parameter.name for parameter in LAWS[self.law].parameters]
        return {name: self.renamed.get(name, name) for name in own}


def _bending(modes: tuple[str, ...], EI: str, GA: str, curvature: str, shears: bool) -> BeamLaw:
    names = {"EI": EI, "GA": GA, "initial_curvature": curvature}
    return BeamLaw("beam_shear_bending" if shears else "beam_bending", modes, names)


def beam_laws(given: Mapping[str, float], planar: bool) -> list[BeamLaw]:
    """Return the laws of a beam with some of the stiffnesses in `STIFFNESSES`; its other modes are rigid."""
    found = []
    if "EA" in given:
        found.append(BeamLaw("beam_extension", ("elongation",)))
    if "GJ" in given:
        found.append(BeamLaw("beam_torsion", ("torsion",), {"initial_twist": "initial_curvature[0]"}))
    if "EIy" in given:
        found.append(_bending(("bend1", "bend2"), "EIy", "GAz", "initial_curvature[1]", "GAz" in given))
    if "EIz" in given:
        modes = ("bend1", "bend2") if planar else ("bend3", "bend4")
        curvature = "initial_curvature" if planar else "initial_curvature[2]"
        found.append(_bending(modes, "EIz", "GAy", curvature, "GAy" in given))
    if "EIw" in given:
        found.append(BeamLaw("beam_bimoment", ("warp1", "warp2")))
    return found


def element_stiffnesses(given: Mapping[str, float]) -> dict[str, float]:
    """Return EIy, EIz, GAy and GAz of the beam's element, by which the inertia of its sections is distributed."""
    stiffnesses = {key: given.get(key, 0.0) for key in ("EIy", "EIz")}
    return stiffnesses | {key: given.get(key, NO_SHEAR) for key in ("GAy", "GAz")}
