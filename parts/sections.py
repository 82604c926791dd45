"""Cross-sections of beams: areas, moments, torsion constants, shear factors and stresses.

A section is drawn in the y and z axes of the beam's triad (``direction=`` of `Model.beam` gives y); its sizes are named
along them.  Sources: Timoshenko and Goodier (1970) art. 109 for the torsion of a rectangle,
Cowper (1966) for the shear factors, Young and Budynas (2002) for thin open sections, Vlasov (1961) for warping.
"""

# ruff: noqa: N802 (the letters of mechanics: A, Iy, Iz, J)

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from flexel.base.arguments import number, positive
from flexel.base.errors import ModelError
from flexel.base.meaning import described, in_unit
from flexel.model.profiles import SectionForces, StressPoint

CATALAN = 0.915965594177219  # sum of (-1)^k / (2 k + 1)^2


@described
class Rectangle:
    """Solid rectangle; a leaf spring that deflects in y has a small `height` and a large `width`.

    Parameters
    ----------
    height, width : float
        Size along the section's y and z axes [m].
    """

    height: float = in_unit("m")
    width: float = in_unit("m")

    def __post_init__(self) -> None:
        check_sizes(self, self.__dataclass_fields__)

    @property
    def A(self) -> float:
        """Area [m²]."""
        return self.height * self.width

    @property
    def Iy(self) -> float:
        """Second moment of area about y [m⁴]."""
        return self.height * self.width**3 / 12

    @property
    def Iz(self) -> float:
        """Second moment of area about z [m⁴]."""
        return self.width * self.height**3 / 12

    @property
    def J(self) -> float:
        """Torsion constant [m⁴], from Saint-Venant's series."""
        s, l = sorted((self.height, self.width))
        n = np.arange(1.0, 2000.0, 2.0)
        series = float(np.sum(np.tanh(n * np.pi * l / (2 * s)) / n**5))
        return l * s**3 / 3 * (1 - 192 / np.pi**5 * s / l * series)

    @property
    def Iw(self) -> float:
        """Warping constant [m⁶], from Saint-Venant's series; height³ width³/144 if thin."""
        s, l = sorted((self.height, self.width))
        k = np.arange(1.0, 400.0, 2.0) * np.pi / s
        t = np.tanh(k * l / 2)
        series = 32 / (s * k**6) * (3 * t / k - l - l / 2 * (1 - t**2))
        return s**3 * l**3 / 144 + float(np.sum(series))

    @property
    def shear_centre(self) -> tuple[float, float]:
        """Position (y, z) of the shear centre, the centroid [m]."""
        return 0.0, 0.0

    def largest_warping(self) -> float:
        """Return the largest warping of the section per twist [m²]: at the corners if thin, else on the long faces."""
        s, l = sorted((self.height, self.width))
        k = np.arange(1.0, 400.0, 2.0)[:, None] * np.pi / s
        z = np.linspace(0.0, l / 2, 201)
        hyperbolic = (
            np.exp(k * (z - l / 2)) * (1 - np.exp(-2 * k * z)) / (1 + np.exp(-k * l))
        )  # sinh kz/cosh kl/2
        return float(np.max(np.abs(s / 2 * z - np.sum(8 / (s * k**3) * hyperbolic, axis=0))))

    def shear_factors(self, nu: float) -> tuple[float, float]:
        """Return 10 (1 + nu) / (12 + 11 nu) for both (Cowper 1966)."""
        nu = number(nu, "Rectangle", "Poisson's ratio")
        k = 10 * (1 + nu) / (12 + 11 * nu)
        return k, k

    def torsion_shear(self) -> tuple[float, float]:
        """Return shear stress per torque [1/m³] in the middle of the faces y = ± height/2 and z = ± width/2."""
        s, l = sorted((self.height, self.width))
        n = np.arange(1.0, 200.0, 2.0)
        x = n * np.pi * l / (2 * s)
        decay = np.exp(-x)
        on_long = s * (1 - 8 / np.pi**2 * float(np.sum(2 * decay / (1 + decay**2) / n**2)))
        rest = (-1.0) ** ((n - 1) / 2) * 2 * decay**2 / (1 + decay**2) / n**2  # 1 - tanh x
        on_short = 8 * s / np.pi**2 * (CATALAN - float(np.sum(rest)))
        # a face y = ± height/2 has the length `width`
        pair = (on_long, on_short) if self.width >= self.height else (on_short, on_long)
        return pair[0] / self.J, pair[1] / self.J

    def stresses(self, f: SectionForces) -> list[StressPoint]:
        """Return stresses of the corners, and of the faces' middles with torsion and parabolic shear 3 V / (2 A)."""
        check_forces(f, "Rectangle")
        axial = abs(f.N) / self.A
        by, bz = abs(f.My) * self.width / 2 / self.Iy, abs(f.Mz) * self.height / 2 / self.Iz
        ty, tz = self.torsion_shear()
        warping = abs(f.B) * self.largest_warping() / self.Iw if f.B else 0.0
        return [
            StressPoint("corner", axial + by + bz + warping, 0.0),
            StressPoint("face y", axial + bz, abs(f.T) * ty + 1.5 * abs(f.Vz) / self.A),
            StressPoint("face z", axial + by, abs(f.T) * tz + 1.5 * abs(f.Vy) / self.A),
        ]


@described
class Flanged:
    """Common base of sections of a web along y and two equal flanges along z."""

    height: float = in_unit("m")
    width: float = in_unit("m")
    flange: float = in_unit("m")
    web: float = in_unit("m")

    @property
    def A(self) -> float:
        """Area [m²]."""
        return 2 * self.width * self.flange + self._clear * self.web

    @property
    def _clear(self) -> float:
        """Height of the web between the flanges [m]."""
        return self.height - 2 * self.flange

    @property
    def Iz(self) -> float:
        """Second moment of area about z [m⁴], the axis along the flanges."""
        return (self.width * self.height**3 - (self.width - self.web) * self._clear**3) / 12

    @property
    def J(self) -> float:
        """Torsion constant [m⁴]: the sum over the three rectangles."""
        return 2 * Rectangle(self.flange, self.width).J + Rectangle(self.web, self._clear).J

    def shear_factors(self, nu: float) -> tuple[float, float]:
        """Return web over area in y, 5/6 of the flanges over area in z (engineering approximations)."""
        number(nu, type(self).__name__, "Poisson's ratio")
        return self._clear * self.web / self.A, 5 / 3 * self.width * self.flange / self.A

    def _check(self, limit: str) -> None:
        """Check the sizes; the web is "<" or "<=" as thick as the section is wide."""
        check_sizes(self, self.__dataclass_fields__)
        fits = self.web < self.width or (limit == "<=" and self.web == self.width)
        if 2 * self.flange >= self.height or not fits:
            raise ModelError(
                f"{type(self).__name__}: flanges of {self.flange:g} and a web of {self.web:g} do not fit into "
                f"{self.height:g} by {self.width:g}; give 2 flange < height and web {limit} width"
            )


@described
class IBeam(Flanged):
    """I section: web along y, two flanges along z; torsion as a thin open section, warping free.

    Parameters
    ----------
    height, width : float
        Overall size along y, and width of the flanges along z [m].
    flange, web : float
        Thicknesses [m].
    """

    def __post_init__(self) -> None:
        self._check("<=")

    @property
    def Iy(self) -> float:
        """Second moment of area about y [m⁴], the weak axis."""
        return (2 * self.flange * self.width**3 + self._clear * self.web**3) / 12

    @property
    def Iw(self) -> float:
        """Warping constant [m⁶]: flange width³ (distance of the flanges' middles)²/24, thin-walled."""
        return self.flange * self.width**3 * (self.height - self.flange) ** 2 / 24

    @property
    def shear_centre(self) -> tuple[float, float]:
        """Position (y, z) of the shear centre, the centroid [m]."""
        return 0.0, 0.0

    def stresses(self, f: SectionForces) -> list[StressPoint]:
        """Return stresses of flange tips and web; torsional shear T t / J is added, conservatively."""
        check_forces(f, "IBeam")
        axial, twist = abs(f.N) / self.A, abs(f.T) / self.J
        bending = abs(f.My) * self.width / 2 / self.Iy + abs(f.Mz) * self.height / 2 / self.Iz
        flange = abs(f.Vz) * 0.75 / (self.width * self.flange)
        bending += abs(f.B) * self.width * (self.height - self.flange) / 4 / self.Iw
        return [
            StressPoint("flange tip", axial + bending, twist * self.flange),
            StressPoint(
                "flange", axial + abs(f.Mz) * self.height / 2 / self.Iz, twist * self.flange + flange
            ),
            StressPoint("web", axial, twist * self.web + 1.5 * abs(f.Vy) / (self._clear * self.web)),
        ]


def check_forces(given: object, owner: str) -> None:
    """Raise a ModelError unless these are the forces of a section."""
    if not isinstance(given, SectionForces):
        raise ModelError(f"{owner}: {given!r:.60} are not the forces of a section; give fx.SectionForces(…)")


def check_sizes(section: object, names: Iterable[str]) -> None:
    """Refuse sizes of a section that are not positive."""
    owner = type(section).__name__
    for name in names:
        positive(getattr(section, name), owner, name)
