"""Section of a stranded wire rope: metallic area, and bending of wires that slide on one another."""

# ruff: noqa: N802 (the letters of mechanics: A, Iy, Iz, J)

from __future__ import annotations

import numpy as np

from flexel.base.arguments import number, positive
from flexel.base.errors import ModelError
from flexel.base.meaning import described, in_unit
from flexel.model.profiles import SectionForces, StressPoint
from flexel.parts.sections import check_forces


@described
class WireRope:
    """Round stranded rope; its area is that of the metal.

    Parameters
    ----------
    diameter : float
        Nominal outer diameter [m].
    fill_factor : float
        Metallic area over the area of the circumscribed circle: 0.586 for 6 x 36 with a steel core, 0.500 with a fibre
        core (EN 12385-4).
    wire_diameter : float, optional
        Diameter of the outer wires [m], 1/20 of the rope's by default.

    Notes
    -----
    Bending: wires without friction between them, I = A d²/16 with the wire's diameter d, a lower bound.  A
    tightly stretched rope is up to about ten times stiffer; give EI to `Model.cable` where that matters.
    """

    diameter: float = in_unit("m")
    fill_factor: float = in_unit("-", default=0.586)
    wire_diameter: float | None = in_unit("m", default=None)

    def __post_init__(self) -> None:
        positive(self.diameter, "WireRope", "diameter")
        positive(self.fill_factor, "WireRope", "fill_factor")
        if self.fill_factor > 1:
            raise ModelError(
                f"WireRope: fill_factor {self.fill_factor:g} exceeds 1; it is the metallic fraction, about 0.55"
            )
        if self.wire_diameter is not None:
            positive(self.wire_diameter, "WireRope", "wire_diameter")
        if not 0 < self.wire <= self.diameter:
            raise ModelError(
                f"WireRope: wire_diameter {self.wire:g} is not between 0 and the rope's {self.diameter:g}; correct it"
            )

    @property
    def wire(self) -> float:
        """Diameter of a wire [m]."""
        return self.diameter / 20 if self.wire_diameter is None else self.wire_diameter

    @property
    def A(self) -> float:
        """Metallic area [m²]."""
        return self.fill_factor * np.pi * self.diameter**2 / 4

    @property
    def Iy(self) -> float:
        """Second moment of area of all wires, each about its own axis [m⁴]."""
        return self.A * self.wire**2 / 16

    @property
    def Iz(self) -> float:
        """As `Iy`."""
        return self.Iy

    @property
    def J(self) -> float:
        """Polar second moment of all wires, each about its own axis [m⁴]."""
        return 2 * self.Iy

    def shear_factors(self, nu: float) -> tuple[float, float]:
        """Return the shear factors of round wires (Cowper 1966)."""
        nu = number(nu, "WireRope", "Poisson's ratio")
        k = 6 * (1 + nu) / (7 + 6 * nu)
        return k, k

    def stresses(self, f: SectionForces) -> list[StressPoint]:
        """Return stresses in a wire: tension, bending of the wire about its axis, torsion and transverse shear."""
        check_forces(f, "WireRope")
        c = self.wire / 2
        normal = abs(f.N) / self.A + float(np.hypot(f.My, f.Mz)) * c / self.Iy
        shear = abs(f.T) * c / self.J + 4 * float(np.hypot(f.Vy, f.Vz)) / (3 * self.A)
        return [StressPoint("outer fibre of a wire", normal, shear)]
