"""Thin-walled closed section of a beam: one cell with straight walls, such as a rectangular hollow section.

Source: Vlasov (1961) and Bredt's shear flow, which the warping of a closed section takes into account.
"""

# ruff: noqa: N802 (the letters of mechanics: A, Iy, Iz, J, Iw)

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property
from typing import Any

import numpy as np

from flexel.base.arguments import array, number
from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.base.meaning import described, in_unit
from flexel.model.profiles import SectionForces, StressPoint
from flexel.parts.sections import check_forces

TURNED = 1e-9  # product of inertia over the polar moment, still taken as zero


@described
class ClosedProfile:
    """Closed section with thin straight walls, symmetric or turned so that y and z are its principal axes.

    Parameters
    ----------
    corners : sequence (k, 2)
        Positions (y, z) of the corners of the walls' middle line in order [m], from any origin.
    thickness : float or sequence (k,)
        Thickness of all walls, or of each, from its corner to the next [m].

    Examples
    --------
    A rectangular hollow section of 100 mm by 50 mm with walls of 3 mm:

    >>> import flexel as fx
    >>> box = fx.ClosedProfile([(0, 0), (0.097, 0), (0.097, 0.047), (0, 0.047)], 0.003)
    >>> print(f"{box.A:.4g} m2, {box.Iw:.3g} m6")
    0.000864 m2, 4.51e-11 m6
    """

    corners: Sequence[Sequence[float]] | Array = in_unit("m")
    thickness: float | Sequence[float] | Array = in_unit("m")

    def __post_init__(self) -> None:
        owner = "ClosedProfile"
        corners = array(self.corners, owner, "corners")
        if corners.ndim != 2 or corners.shape[1] != 2 or len(corners) < 3:
            raise ModelError(
                f"{owner}: corners have the shape {corners.shape}; give three or more pairs (y, z)"
            )
        t = array(self.thickness, owner, "thickness")
        if t.shape not in ((), (len(corners),)) or np.any(t <= 0):
            raise ModelError(
                f"{owner}: thickness {self.thickness!r:.60} is not one positive number, or one for each of the "
                f"{len(corners)} walls"
            )
        object.__setattr__(self, "corners", tuple(map(tuple, corners.tolist())))
        object.__setattr__(self, "thickness", tuple(np.broadcast_to(t, len(corners)).tolist()))
        if np.any(self._lengths == 0) or abs(self._cell) <= 1e-9 * np.sum(self._lengths) ** 2:
            raise ModelError(
                f"{owner}: its walls enclose no area; give different corners, in order around the cell"
            )
        y, z = self._places.T
        product = self._integral(y, z)
        if abs(product) > TURNED * (self.Iy + self.Iz):
            side = 1.0 if self.Iy >= self.Iz else -1.0
            angle = np.degrees(np.arctan2(2 * product * side, abs(self.Iy - self.Iz)) / 2)
            raise ModelError(
                f"{owner}: y and z are not principal axes; turn the corners about x by {angle:g} degrees"
            )

    @cached_property
    def _lengths(self) -> Array:
        """Lengths (k,) of the walls."""
        corners = np.array(self.corners)
        return np.asarray(np.linalg.norm(np.roll(corners, -1, axis=0) - corners, axis=1))

    @cached_property
    def _areas(self) -> Array:
        """Areas (k,) of the walls."""
        return np.asarray(self._lengths * np.array(self.thickness))

    @cached_property
    def _places(self) -> Array:
        """Corners (k, 2) from the centroid."""
        corners = np.array(self.corners)
        middles = (corners + np.roll(corners, -1, axis=0)) / 2
        return np.asarray(corners - self._areas @ middles / self.A)

    @cached_property
    def _swept(self) -> Array:
        """Twice the area (k,) that a line from the centroid to the wall sweeps along each wall."""
        (y, z), (y1, z1) = self._places.T, np.roll(self._places, -1, axis=0).T
        return np.asarray(y * z1 - z * y1)

    @property
    def _cell(self) -> float:
        """Enclosed area, positive if the corners go round from y to z."""
        return float(np.sum(self._swept)) / 2

    def _integral(self, f: Array, g: Array) -> float:
        """Integrate over the walls the product of two quantities (k,) that are linear between the corners."""
        f1, g1 = np.roll(f, -1), np.roll(g, -1)
        return float(self._areas @ (2 * f * g + f * g1 + f1 * g + 2 * f1 * g1)) / 6

    @property
    def _round(self) -> float:
        """Integral of 1/thickness around the cell."""
        return float(np.sum(self._lengths / np.array(self.thickness)))

    @property
    def A(self) -> float:
        """Area [m²]."""
        return float(np.sum(self._areas))

    @property
    def Iy(self) -> float:
        """Second moment of area about y [m⁴]."""
        return self._integral(self._places[:, 1], self._places[:, 1])

    @property
    def Iz(self) -> float:
        """Second moment of area about z [m⁴]."""
        return self._integral(self._places[:, 0], self._places[:, 0])

    @property
    def J(self) -> float:
        """Torsion constant [m⁴] after Bredt: 4 (cell area)² / ∮ ds/t."""
        return 4 * self._cell**2 / self._round

    @cached_property
    def _warping(self) -> tuple[float, float, Array]:
        """Shear centre (y, z), and warping per twist (k,) [m²] of the corners about it, zero on average."""
        flow = 2 * self._cell / self._round * self._lengths / np.array(self.thickness)
        about_centroid = np.append(0.0, np.cumsum(self._swept - flow)[:-1])
        one, (y, z) = np.ones(len(about_centroid)), self._places.T
        about_centroid = about_centroid - self._integral(about_centroid, one) / self.A
        at_y = self._integral(about_centroid, z) / self.Iy
        at_z = -self._integral(about_centroid, y) / self.Iz
        return at_y, at_z, about_centroid - at_y * z + at_z * y

    @property
    def shear_centre(self) -> tuple[float, float]:
        """Position (y, z) of the shear centre, from the centroid [m]."""
        return self._warping[:2]

    @property
    def Iw(self) -> float:
        """Warping constant about the shear centre [m⁶]; zero where the warping is below rounding."""
        w = self._warping[2]
        iw = self._integral(w, w)
        return iw if iw > 1e-18 * self._cell**2 * self.A else 0.0

    def shear_factors(self, nu: float) -> tuple[float, float]:
        """Return 5/6 of the walls' areas, projected on y and z, over the area (engineering approximation)."""
        number(nu, "ClosedProfile", "Poisson's ratio")
        along = (np.roll(self._places, -1, axis=0) - self._places) / self._lengths[:, None]
        in_y, in_z = 5 / 6 * (self._areas @ along**2) / self.A
        return float(in_y), float(in_z)

    def stresses(self, f: SectionForces) -> list[StressPoint]:
        """Return the corners' largest normal stress; Bredt's flow in the thinnest wall and 3/2 of the mean shear."""
        check_forces(f, "ClosedProfile")
        y, z = self._places.T
        bending = f.My / self.Iy * z - f.Mz / self.Iz * y
        warping = f.B / self.Iw * self._warping[2] if f.B else 0.0
        normal = float(np.max(np.abs(f.N / self.A + bending + warping)))
        bredt = abs(f.T) / (2 * abs(self._cell) * float(np.min(self.thickness)))
        return [StressPoint("corner", normal, bredt + 1.5 * float(np.hypot(f.Vy, f.Vz)) / self.A)]

    @property
    def outline(self) -> Array:
        """Corners (k, 2) of the middle line from the centroid [m]."""
        return self._places

    def __getstate__(self) -> dict[str, Any]:
        """Return only what was given: the rest is computed again."""
        return {"corners": self.corners, "thickness": self.thickness}
