"""Thin-walled sections of beams: U, L and closed profiles, with their shear centres and warping constants.

Areas and moments of U and L are computed from their rectangles; shear centres and warping constants, and everything
of a closed profile, from thin walls along their middle lines.  Sources: Vlasov (1961), Young and Budynas (2002).
"""

# ruff: noqa: N802 (the letters of mechanics: A, Iy, Iz, J, Iw)

from __future__ import annotations

import numpy as np

from flexel.base.arguments import number
from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.base.meaning import described, in_unit
from flexel.model.profiles import SectionForces, StressPoint
from flexel.parts.sections import Flanged, Rectangle, check_forces, check_sizes


def combined(
    section: UBeam | LBeam, f: SectionForces, thickness: float, largest_warping: float
) -> list[StressPoint]:
    """Return the outline's largest normal stress, torsional shear T t/J and 3/2 of the mean shear: a safe bound."""
    check_forces(f, type(section).__name__)
    y, z = section.outline.T
    bending = float(np.max(np.abs(f.My / section.Iy * z - f.Mz / section.Iz * y)))
    normal = abs(f.N) / section.A + bending + abs(f.B) * largest_warping / section.Iw
    shear = abs(f.T) * thickness / section.J + 1.5 * float(np.hypot(f.Vy, f.Vz)) / section.A
    return [StressPoint("outline", normal, shear)]


@described
class UBeam(Flanged):
    """U section (channel): web along y, two flanges along z, open towards positive z.

    Parameters
    ----------
    height, width : float
        Overall size along y, and of the flanges along z [m].
    flange, web : float
        Thicknesses [m].
    """

    def __post_init__(self) -> None:
        self._check("<")

    @property
    def _back(self) -> float:
        """Distance of the centroid from the back of the web [m]."""
        return (self.flange * self.width**2 + self._clear * self.web**2 / 2) / self.A

    @property
    def Iy(self) -> float:
        """Second moment of area about y [m⁴], the axis along the web."""
        about_back = (2 * self.flange * self.width**3 + self._clear * self.web**3) / 3
        return about_back - self.A * self._back**2

    @property
    def _walls(self) -> tuple[float, float, float]:
        """Middle lines of a flange and of the web, and distance of the shear centre behind the web's middle [m]."""
        b, h = self.width - self.web / 2, self.height - self.flange
        return b, h, 3 * b**2 * self.flange / (6 * b * self.flange + h * self.web)

    @property
    def shear_centre(self) -> tuple[float, float]:
        """Position (y, z) of the shear centre, from the centroid [m]: behind the web."""
        return 0.0, self.web / 2 - self._walls[2] - self._back

    @property
    def Iw(self) -> float:
        """Warping constant about the shear centre [m⁶]."""
        b, h, _ = self._walls
        flange, web = b * self.flange, h * self.web
        return flange * b**2 * h**2 / 12 * (3 * flange + 2 * web) / (6 * flange + web)

    def stresses(self, f: SectionForces) -> list[StressPoint]:
        """Return the largest normal and shear stress of the whole outline, combined conservatively."""
        b, h, e = self._walls
        return combined(self, f, max(self.flange, self.web), h / 2 * max(e, b - e))

    @property
    def outline(self) -> Array:
        """Corners (8, 2) from the centroid [m]."""
        h, inside, back = self.height / 2, self._clear / 2, -self._back
        tip, wall = back + self.width, back + self.web
        half = [(-h, back), (-h, tip), (-inside, tip), (-inside, wall)]
        return np.array(half + [(-y, z) for y, z in reversed(half)])


@described
class LBeam:
    """L section (angle) of uniform thickness; its y and z axes are the principal ones, y the weak one.

    Parameters
    ----------
    height, width : float
        Overall sizes of the legs [m].
    thickness : float
        [m]
    """

    height: float = in_unit("m")
    width: float = in_unit("m")
    thickness: float = in_unit("m")

    def __post_init__(self) -> None:
        check_sizes(self, self.__dataclass_fields__)
        if self.thickness >= min(self.height, self.width):
            raise ModelError(
                f"LBeam: a thickness of {self.thickness:g} does not fit legs of {self.height:g} and {self.width:g}; "
                "give a smaller one"
            )

    @property
    def A(self) -> float:
        """Area [m²]."""
        return (self.height + self.width - self.thickness) * self.thickness

    @property
    def _centroid(self) -> Array:
        """Centroid (2,) from the outer corner [m], along the legs `height` and `width`."""
        h, b, t = self.height, self.width, self.thickness
        return np.array([h**2 * t + (b - t) * t**2, h * t**2 + (b**2 - t**2) * t]) / (2 * self.A)

    @property
    def _moments(self) -> Array:
        """Integrals (2, 2) of the products of the coordinates along the legs, from the centroid [m⁴]."""
        h, b, t = self.height, self.width, self.thickness
        uu, vv = h**3 * t / 3 + (b - t) * t**3 / 3, h * t**3 / 3 + (b**3 - t**3) * t / 3
        uv = h**2 * t**2 / 4 + (b**2 - t**2) * t**2 / 4
        c = self._centroid
        return np.array([[uu, uv], [uv, vv]]) - self.A * np.outer(c, c)

    @property
    def angle(self) -> float:
        """Angle from the leg `height` to the y axis [rad], positive towards the leg `width`, within ±π/2."""
        ((uu, uv), (_, vv)) = self._moments
        # y is the direction with the largest integral of y²
        return float(np.arctan2(2 * uv, uu - vv)) / 2

    @property
    def Iy(self) -> float:
        """Smaller principal second moment of area [m⁴], about y."""
        return float(np.linalg.eigvalsh(self._moments)[0])

    @property
    def Iz(self) -> float:
        """Larger principal second moment of area [m⁴], about z."""
        return float(np.linalg.eigvalsh(self._moments)[1])

    @property
    def J(self) -> float:
        """Torsion constant [m⁴]: the sum over the two rectangles."""
        t = self.thickness
        return Rectangle(t, self.height).J + Rectangle(t, self.width - t).J

    def _turned(self, legs: Array) -> Array:
        """Return points (k, 2) along the legs from the outer corner, in the principal axes from the centroid."""
        c, s = np.cos(self.angle), np.sin(self.angle)
        return np.asarray((legs - self._centroid) @ np.array([[c, -s], [s, c]]))

    @property
    def shear_centre(self) -> tuple[float, float]:
        """Position (y, z) of the shear centre, from the centroid [m]: where the legs' middle lines meet."""
        y, z = self._turned(np.full((1, 2), self.thickness / 2))[0]
        return float(y), float(z)

    @property
    def Iw(self) -> float:
        """Warping constant about the shear centre [m⁶], from the warping across the thickness alone."""
        t = self.thickness
        return t**3 / 36 * ((self.height - t / 2) ** 3 + (self.width - t / 2) ** 3)

    def shear_factors(self, nu: float) -> tuple[float, float]:
        """Return 5/6 of the legs over area, turned to the principal axes (engineering approximation)."""
        number(nu, "LBeam", "Poisson's ratio")
        c2 = np.cos(self.angle) ** 2
        share = (self.height - self.thickness / 2) / (self.height + self.width - self.thickness)
        in_y = float(share * c2 + (1 - share) * (1 - c2))
        return 5 / 6 * in_y, 5 / 6 * (1 - in_y)

    def stresses(self, f: SectionForces) -> list[StressPoint]:
        """Return the largest normal and shear stress of the whole outline, combined conservatively."""
        leg = max(self.height, self.width) - self.thickness / 2
        return combined(self, f, self.thickness, leg * self.thickness / 2)

    @property
    def outline(self) -> Array:
        """Corners (6, 2) from the centroid [m]."""
        h, b, t = self.height, self.width, self.thickness
        return self._turned(np.array([(0, 0), (h, 0), (h, t), (t, t), (t, b), (0, b)]))
