"""Section and material of a beam as the core sees them: forces, stresses, and the interface of a profile."""

# ruff: noqa: N802 (the letters of mechanics: A, Iy, Iz, J)

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol, runtime_checkable

import numpy as np

from flexel.base.arguments import number


@dataclass(frozen=True)
class SectionForces:
    """Internal forces in one end section of a beam, in the section's axes.

    Attributes
    ----------
    N, Vy, Vz : float
        Axial force, positive in tension, and shear forces [N].
    T, My, Mz : float
        Torque and bending moments [N m].
    B : float
        Bimoment E Iw times the change of the twist per length [N m²], of a beam with warping; it does work on the
        twist per length.
    """

    N: float = 0.0
    Vy: float = 0.0
    Vz: float = 0.0
    T: float = 0.0
    My: float = 0.0
    Mz: float = 0.0
    B: float = 0.0

    def __post_init__(self) -> None:
        for name in self.__dataclass_fields__:
            number(getattr(self, name), "SectionForces", name)


@dataclass(frozen=True)
class StressPoint:
    """Stress at one point of a section [Pa]: largest normal and shear stress there, both as absolute values."""

    place: str
    normal: float
    shear: float

    @property
    def mises(self) -> float:
        """Equivalent stress of von Mises [Pa]."""
        return float(np.hypot(self.normal, np.sqrt(3.0) * self.shear))


@runtime_checkable
class Section(Protocol):
    """Interface of a section; any object with these attributes can be used."""

    @property
    def A(self) -> float:
        """Area [m²]."""

    @property
    def Iy(self) -> float:
        """Second moment of area about y [m⁴]: bending with deflection in z."""

    @property
    def Iz(self) -> float:
        """Second moment of area about z [m⁴]: bending with deflection in y."""

    @property
    def J(self) -> float:
        """Torsion constant [m⁴] (Saint-Venant: warping free)."""

    def shear_factors(self, nu: float) -> tuple[float, float]:
        """Return the shear factors k of deflection in y and in z, at Poisson's ratio nu."""

    def stresses(self, f: SectionForces) -> list[StressPoint]:
        """Return the stresses at the points where one of the forces has the largest effect."""


class Elastic(Protocol):
    """Interface of a material."""

    @property
    def E(self) -> float:
        """Young's modulus [Pa]."""

    @property
    def rho(self) -> float:
        """Density [kg/m³]."""

    @property
    def strength(self) -> float | None:
        """Yield stress [Pa]."""


@runtime_checkable
class SectionOfMaterial(Protocol):
    """Interface of a profile: a section of a material."""

    @property
    def section(self) -> Section:
        """Its section."""

    @property
    def material(self) -> Elastic:
        """Its material."""
