"""The hoist in a few lines: a drum, two movable sheaves at the load's block, a fixed sheave between them, one rope.

The rope runs from the drum down to the first movable sheave, up to the fixed one, down to the second movable one and up
to its anchor: four falls, all in one plane.  The block is guided, so that it cannot tilt.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial

import numpy as np

import flexel as fx
from flexel.derive.compiled import CompiledElement, CompiledLaw
from flexel.examples.hoist_data import HOIST, Hoist

Pages = tuple[CompiledElement | None, CompiledLaw | None]
SHEAVES = ("lower 1", "upper", "lower 2")
BEARING_STIFFNESS, BEARING_DAMPING = 2e9, 2e5  # radial [N/m, N s/m]
TURNING = 0.01  # speed [rad/s] at which 71 % of a bearing's friction acts
CONTACT = fx.Contact(7e10, exponent=1.5, dissipation=1.0, friction=0.12, slip_speed=2e-3)
BEFORE = 1e-6  # [s]: how long before t = 0 the motion starts
GROOVE = fx.RoundGroove(0.53 * HOIST.diameter)  # ISO 16625: 0.53 to 0.55 of the rope's diameter


@dataclass(frozen=True)
class HoistModel:
    """The built hoist and its rope, at rest under the first share of the load just before t = 0."""

    data: Hoist
    system: fx.System
    rope: fx.Rope
    start: fx.State


def free_length(data: Hoist = HOIST) -> float:
    """Return the length of rope between the drum and the anchor: four falls and three half turns [m]."""
    return 4 * data.depth + data.anchor + 3 * np.pi * data.pitch


def axial_frequency(data: Hoist = HOIST) -> float:
    """Return the frequency of the load on a rope without mass: sqrt(n² EA/(L M)) with n = 4 falls [rad/s]."""
    return float(np.sqrt(16 * data.EA / (free_length(data) * data.load)))


def hoist(data: Hoist = HOIST, pages: Pages = (None, None)) -> HoistModel:
    """Build the hoist with its rope laid under the first share of the load; the rest is applied at once at t = 0.

    Its rope may have another element and law than the built-in ones: `pages`.
    """
    m, R = fx.Model(gravity=(0, -9.81, 0)), data.pitch
    m.frame("ground", fixed=True)
    m.point("drum axle", (-2 * R, 0, 0), fixed=True)
    m.frame("drum")
    m.hinge("drive", "ground", "drum", axis=(0, 0, 1))
    m.prescribe("drive.angle", tuple(partial(_turned, data, i) for i in range(3)))
    m.sheave("drum", "drum axle", "drum", radius=data.drum_radius)
    m.point("block", (2 * R, -data.depth, 0))
    m.fix("block.x", "block.z")
    m.point_mass("load", "block", data.load)
    share = 1 - data.first_load
    m.load("block.y", (partial(_carried, share * data.weight), _nothing, _nothing))
    m.point("frame", (2 * R, 0, 0), fixed=True)
    for name, carrier, x, y in zip(
        SHEAVES, ("block", "frame", "block"), (0, 2 * R, 4 * R), (-data.depth, 0, -data.depth), strict=True
    ):
        _sheave(m, data, name, carrier, (x, y, 0))
    m.point("anchor", (5 * R, data.anchor, 0), fixed=True)
    rope = m.rope(
        "rope",
        ["drum", *SHEAVES, "anchor"],
        data.elements,
        contact=CONTACT,
        radius=data.rope_radius,
        tension=data.first_load * data.weight / 4,
        turns=data.turns,
        EA=data.EA,
        EI=data.EI,
        mass_per_length=data.mass_per_length,
        damping=2 * data.damping_ratio / axial_frequency(data),
        element=pages[0],
        law=pages[1],
    )
    system = m.build(t=-BEFORE)
    start = system.equilibrium(hold=[f"{name} bearing.angle" for name in SHEAVES])
    return HoistModel(data, system, rope, start)


def _turned(data: Hoist, order: int, t: float) -> float:
    """Return the drum's angle, its rate or its acceleration."""
    return data.angle(t)[order]


def _carried(force: float, t: float) -> float:
    """Return a force that acts only before the start."""
    return force if t < 0 else 0.0


def _nothing(_: float) -> float:
    """Return the rate of a constant, zero."""
    return 0.0


def _sheave(m: fx.Model, data: Hoist, name: str, carrier: str, place: tuple[float, float, float]) -> None:
    """Add a sheave on a bearing with friction, in the block or the frame."""
    m.point(f"{name} axle", place)
    m.frame(name)
    inertia = data.sheave_mass * data.sheave_radius**2 * np.array([0.4, 0.4, 0.7])
    m.body(f"{name} body", f"{name} axle", name, mass=data.sheave_mass, inertia=inertia)
    m.bearing(f"{name} bearing", carrier, "ground", f"{name} axle", name, axis=(0, 0, 1))
    m.attach(
        "journal",
        [f"{name} bearing.{mode}" for mode in ("radial1", "radial2", "angle")],
        stiffness=BEARING_STIFFNESS,
        damping=BEARING_DAMPING,
        friction_radius=data.friction_radius,
        slip_speed=TURNING,
    )
    m.sheave(name, f"{name} axle", name, radius=data.sheave_radius, groove=GROOVE)
