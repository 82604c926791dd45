"""Round sections of beams: the circle and the tube.  Source: Cowper (1966) for the shear factors."""

# ruff: noqa: N802 (the letters of mechanics: A, Iy, Iz, J)

from __future__ import annotations

import numpy as np

from flexel.base.arguments import not_negative, number, positive
from flexel.base.errors import ModelError
from flexel.base.meaning import described, in_unit
from flexel.model.profiles import SectionForces, StressPoint
from flexel.parts.sections import check_forces


class _Round:
    """Common base of circle and tube."""

    @property
    def _diameters(self) -> tuple[float, float]:
        """Outer and inner one [m]."""
        raise NotImplementedError

    @property
    def A(self) -> float:
        """Area [m²]."""
        outer, inner = self._diameters
        return np.pi * (outer**2 - inner**2) / 4

    @property
    def Iy(self) -> float:
        """Second moment of area about y [m⁴]."""
        outer, inner = self._diameters
        return np.pi * (outer**4 - inner**4) / 64

    @property
    def Iz(self) -> float:
        """Second moment of area about z [m⁴]."""
        return self.Iy

    @property
    def J(self) -> float:
        """Torsion constant [m⁴]: the polar moment."""
        return 2 * self.Iy

    @property
    def Iw(self) -> float:
        """Warping constant [m⁶]: zero, round sections stay plane."""
        return 0.0

    @property
    def shear_centre(self) -> tuple[float, float]:
        """Position (y, z) of the shear centre, the centroid [m]."""
        return 0.0, 0.0

    def shear_factors(self, nu: float) -> tuple[float, float]:
        """Return 6 (1+nu) (1+m²)² / ((7+6nu) (1+m²)² + (20+12nu) m²) for both, m = inner/outer (Cowper 1966)."""
        nu = number(nu, type(self).__name__, "Poisson's ratio")
        outer, inner = self._diameters
        m2 = (inner / outer) ** 2
        k = 6 * (1 + nu) * (1 + m2) ** 2 / ((7 + 6 * nu) * (1 + m2) ** 2 + (20 + 12 * nu) * m2)
        return k, k

    def stresses(self, f: SectionForces) -> list[StressPoint]:
        """Return stresses of the outer fibre in the plane of bending, and with the largest shear at mid-depth."""
        check_forces(f, type(self).__name__)
        a, b = self._diameters
        axial, r = abs(f.N) / self.A, a / 2
        twist = abs(f.T) * r / self.J
        peak = 4 / 3 * (a * a + a * b + b * b) / (a * a + b * b)
        return [
            StressPoint("outer fibre", axial + np.hypot(f.My, f.Mz) * r / self.Iy, twist),
            StressPoint("neutral axis", axial, twist + peak * float(np.hypot(f.Vy, f.Vz)) / self.A),
        ]


@described
class Circle(_Round):
    """Solid circle.

    Parameters
    ----------
    diameter : float
        [m]
    """

    diameter: float = in_unit("m")

    def __post_init__(self) -> None:
        positive(self.diameter, "Circle", "diameter")

    @property
    def _diameters(self) -> tuple[float, float]:
        return self.diameter, 0.0


@described
class Tube(_Round):
    """Circular tube.

    Parameters
    ----------
    outer, inner : float
        Diameters [m].
    """

    outer: float = in_unit("m")
    inner: float = in_unit("m")

    def __post_init__(self) -> None:
        positive(self.outer, "Tube", "outer")
        if not_negative(self.inner, "Tube", "inner") >= self.outer:
            raise ModelError(f"Tube: inner {self.inner:g} is not less than outer {self.outer:g}; swap them")

    @property
    def diameter(self) -> float:
        """Outer diameter [m]."""
        return self.outer

    @property
    def _diameters(self) -> tuple[float, float]:
        return self.outer, self.inner
