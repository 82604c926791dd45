"""Materials, and the profile of a beam: a section of a material."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from flexel.base.arguments import not_negative, number, positive, unknown
from flexel.base.errors import ModelError
from flexel.base.meaning import described, in_unit
from flexel.model.profiles import Section


@described
class Material:
    """Linear elastic, isotropic material.

    Parameters
    ----------
    E : float
        Young's modulus [Pa].
    rho : float
        Density [kg/m³]; 0 for a beam without mass.
    nu, G : float, optional
        Poisson's ratio or shear modulus [Pa]; one of them.
    strength : float, optional
        Yield stress [Pa].
    """

    E: float = in_unit("Pa")
    rho: float = in_unit("kg/m³", default=0.0)
    nu: float | None = in_unit("-", default=None)
    G: float | None = in_unit("Pa", default=None)
    strength: float | None = in_unit("Pa", default=None)

    def __post_init__(self) -> None:
        positive(self.E, "Material", "E")
        not_negative(self.rho, "Material", "rho")
        if (self.nu is None) == (self.G is None):
            raise ModelError("Material: give either nu or G; the other follows from E = 2 G (1 + nu)")
        if self.strength is not None:
            positive(self.strength, "Material", "strength")
        if self.G is not None:
            positive(self.G, "Material", "G")
        if self.nu is not None:
            number(self.nu, "Material", "nu")
        if not -1 < self.poisson <= 0.5:
            raise ModelError(
                f"Material: Poisson's ratio {self.poisson:g} is not between -1 and 1/2; correct nu, E or G"
            )

    @property
    def poisson(self) -> float:
        """Poisson's ratio."""
        return self.nu if self.nu is not None else self.E / (2 * (self.G or np.nan)) - 1

    @property
    def shear_modulus(self) -> float:
        """Shear modulus [Pa]."""
        return self.G if self.G is not None else self.E / (2 * (1 + self.poisson))


# Typical values at room temperature; prefer a data sheet for the specific alloy and temper.
MATERIALS = {
    "steel": Material(E=210e9, rho=7850.0, nu=0.3),
    "stainless steel": Material(E=193e9, rho=8000.0, nu=0.29),  # AISI 304
    "spring steel": Material(E=206e9, rho=7850.0, nu=0.3, strength=1100e6),  # cold-rolled strip, hardened
    "aluminium": Material(E=71.7e9, rho=2810.0, nu=0.33, strength=503e6),  # 7075-T6
    "titanium": Material(E=113.8e9, rho=4430.0, nu=0.342, strength=880e6),  # Ti-6Al-4V, annealed
    # A stranded rope as a whole, on its metallic area: modulus of a used 6 x 36 rope, mass of the lay and the grease.
    "wire rope": Material(E=100e9, rho=8900.0, nu=0.3, strength=1770e6),
    "beryllium copper": Material(E=128e9, rho=8250.0, nu=0.3, strength=1100e6),  # C17200, aged
}


def material_of(material: Material | str, owner: str) -> Material:
    """Return the material, or the one with that name."""
    if isinstance(material, Material):
        return material
    if not isinstance(material, str):
        raise ModelError(
            f"{owner}: {material!r} is not a material; give a Material or one of {', '.join(MATERIALS)}"
        )
    if material not in MATERIALS:
        raise ModelError(f"{owner}: {unknown(material, MATERIALS, 'material')}")
    return MATERIALS[material]


@dataclass(frozen=True)
class Profile:
    """A section of a material, of which a beam is made."""

    section: Section
    material: Material

    def stiffness(self) -> dict[str, float]:
        """Return EA, GJ, EIy, EIz, GAy, GAz as `Model.beam` takes them; GA with the shear factors."""
        s, E, G = self.section, self.material.E, self.material.shear_modulus
        ky, kz = s.shear_factors(self.material.poisson)
        return {
            "EA": E * s.A,
            "GJ": G * s.J,
            "EIy": E * s.Iy,
            "EIz": E * s.Iz,
            "GAy": ky * G * s.A,
            "GAz": kz * G * s.A,
        }

    def mass(self) -> tuple[float, tuple[float, float, float]]:
        """Return mass per length [kg/m] and rotary inertia per length about x, y, z [kg m]."""
        s, rho = self.section, self.material.rho
        return rho * s.A, (rho * (s.Iy + s.Iz), rho * s.Iy, rho * s.Iz)


def profile_of(section: object, material: Material | str | None, owner: str) -> Profile:
    """Return section and material together, both checked."""
    if not isinstance(section, Section):
        raise ModelError(
            f"{owner}: {section!r} is not a section; give Rectangle, Circle, Tube or IBeam, or an object with their "
            "properties"
        )
    if material is None:
        raise ModelError(
            f"{owner}: a section needs a material; give one of {', '.join(MATERIALS)}, or Material(…)"
        )
    return Profile(section, material_of(material, owner))
