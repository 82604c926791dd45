"""Data of the hoist: what is taken from the paper, and what had to be chosen because its text is damaged.

Paper: Cao, Du, Ma and Liu, "Dynamic Modelling of Hoisting Steel Wire Rope", ICMCA 2017.  Its text at hand lost every
digit 0 and 2, every letter e, its table and its figures.  From it are the layout (a drum, one fixed and two movable
sheaves, one rope), 56 elements with five points of contact each, and three phases: the load is applied, lifted with
increasing speed, and lifted at constant speed.  Its numbers have several readings, which the page of the hoist lists;
none of the data is chosen so that one of them comes out.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

WIRE_MODULUS = 2.1e11  # of steel [N/m²]


@dataclass(frozen=True)
class Hoist:
    """A hoist of four falls; SI units.

    Attributes
    ----------
    diameter : float
        Of the rope: 36 mm, class 6 x 36 with a steel core (EN 12385-4), breaking force 817 kN at grade 1770.
    EA : float
        E = 1.0e11 N/m² (ropes of this class: 0.9e11 to 1.1e11) times the metallic area 0.4045 d² = 524 mm².
    wire : float
        Diameter of the outer wires [m].
    EI : float
        Wires that slide on one another without friction: A d_wire²/16 times E of steel.  With ten times
        as much the rope stands off its sheaves under the first share of the load, which then falls further: the
        dynamic factor becomes 2.4.
    mass_per_length : float
        0.409 d² kg/m per cm² (catalogues of this class: 5.2 kg/m for 36 mm).
    sheave_radius : float
        To the bottom of the groove, D/d = 28 (ISO 16625, class M7, asks 25 with the drum 22.4).
    load : float
        42 t: tension 103 kN in each fall, a static strain of 0.002 and a seventh of the breaking force.
    damping_ratio : float
        Of the vibration of the load on the rope: 0.07, assumed, for a stranded rope whose wires rub on one another.
    efficiency : float
        Of one sheave: 0.98, on roller bearings; plain bearings have 0.95 to 0.96.
    depth : float
        Of the movable sheaves' axle below that of the drum at the start [m].
    speed : float
        Of the drum at the end of its acceleration [rad/s]: the load then rises by 52 mm/s.
    """

    diameter: float = 0.036
    EA: float = 1.0e11 * 0.4045 * 0.036**2
    wire: float = 0.036 / 20
    EI: float = WIRE_MODULUS * (0.4045 * 0.036**2) * (0.036 / 20) ** 2 / 16
    mass_per_length: float = 0.409e4 * 0.036**2
    sheave_radius: float = 0.5
    drum_radius: float = 0.5
    sheave_mass: float = 150.0
    load: float = 42000.0
    damping_ratio: float = 0.07
    efficiency: float = 0.98
    depth: float = 2.0
    speed: float = 0.4
    starts: float = 1.0
    constant: float = 2.0
    end: float = 3.0
    turns: float = 0.25
    anchor: float = 0.5
    first_load: float = 0.05
    elements: int = 56
    points: int = 5

    @property
    def rope_radius(self) -> float:
        """Outer radius of the rope [m]."""
        return self.diameter / 2

    @property
    def pitch(self) -> float:
        """Radius of the rope's centre line on drum and sheaves [m]."""
        return self.sheave_radius + self.rope_radius

    @property
    def weight(self) -> float:
        """Of the load [N]."""
        return self.load * 9.81

    def wire_stress(self, curvature: float) -> float:
        """Return the bending stress [N/m²] of an outer wire that slides on others: E d/2 times the curvature [1/m]."""
        return WIRE_MODULUS * self.wire / 2 * curvature

    @property
    def friction_radius(self) -> float:
        """Friction times radius f of a bearing [m] under both parts of a rope: η = (1 - f/R)/(1 + f/R)."""
        return self.pitch * (1 - self.efficiency) / (1 + self.efficiency)

    def angle(self, t: float) -> tuple[float, float, float]:
        """Return the angle of the drum, its rate and acceleration at a time; the ramp is smooth at both ends."""
        span = self.constant - self.starts
        u = float(np.clip((t - self.starts) / span, 0.0, 1.0))
        rate = self.speed * (10 * u**3 - 15 * u**4 + 6 * u**5)
        change = self.speed * (30 * u**2 - 60 * u**3 + 30 * u**4) / span
        angle = self.speed * span * (2.5 * u**4 - 3 * u**5 + u**6)
        return angle + self.speed * max(t - self.constant, 0.0), rate, change if 0 < u < 1 else 0.0


HOIST = Hoist()
# The same lift in 30 s, the other reading of the duration; and with sheaves whose efficiency the factor 1.3 would need.
LONG = replace(HOIST, starts=10.0, constant=20.0, end=30.0)
WORN = replace(HOIST, efficiency=0.83)
