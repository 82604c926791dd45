"""Straight ropes in motion: tension waves, loads that are suddenly applied, and the energy of a rope that swings.

Imports numpy and flexel.
"""

from __future__ import annotations

import numpy as np

import flexel as fx
from flexel.cables import cable_tension
from flexel.examples import rope_models as models
from flexel.report import Quantity
from flexel.structure import Array

DAMPING_RATIOS = (0.0, 0.01, 0.02, 0.05, 0.1, 0.2)
HEAVY = (0.01, 2.0027447663037883), (0.1, 2.0308778818386233), (0.5, 2.103196887658231)
SERIES = "largest force at the top within 40 L/c, modal series of 300 modes"


def steps(system: fx.System, duration: float, h: float, radius: float = 0.9) -> fx.Motion:
    """Integrate with constant implicit steps, and keep all of them."""
    samples = round(duration / h) + 1
    return system.simulate_stiff(duration, samples=samples, step=h, radius=radius, progress=False)


def pulled(n: int) -> tuple[Array, Array, Array]:
    """Times over the period, tip over 2 F L/EA and force of the support over F, of a rope whose free end is pulled."""
    L, EA, mass, F = 10.0, 1e6, 1.0, 10.0
    m = models.straight(n, L, EA=EA, mass=mass)
    m.load(f"rope_p{n}.x", F)
    period = 4 * L / np.sqrt(EA / mass)
    motion = steps(m.build(), 1.5 * period, period / 400)
    tip = (motion[f"rope_p{n}.x"] - L) * EA / (2 * F * L)
    return motion.t / period, tip, -motion["force:rope_p0.x"] / F


def reflected(ratio: float, n: int = 20) -> tuple[float, float]:
    """Tension over Z₁ v in a rope whose end is drawn at v, before and after the wave comes back from a second rope.

    The second rope has `ratio` times the mass; its impedance Z is sqrt(ratio) times as large.
    """
    L, EA, mass, v = 10.0, 1e6, 1.0, 1e-2
    m = fx.Model()
    one = m.cable_line("one", [(0, 0), (L, 0)], n, EA=EA, EI=0.0, mass_per_length=mass)
    two = m.cable_line(
        "two", [(L, 0), (2 * L, 0)], n, start=one.points[-1], EA=EA, EI=0.0, mass_per_length=ratio * mass
    )
    nodes = (*one.points, *two.points[1:], *one.slopes, *two.slopes)
    m.fix(*(f"{z.name}.y" for z in nodes), two.points[-1])
    m.prescribe("one_p0.x", lambda t: -v * t)
    c = np.sqrt(EA / mass)
    motion = steps(m.build(), 2 * L / c, L / c / 200)
    middle = np.array([cable_tension(state, f"one{n // 2}")[1][-1] for state in motion])
    middle /= np.sqrt(EA * mass) * v
    t = motion.t * c / L
    return float(middle[(t > 0.7) & (t < 1.2)].mean()), float(middle[(t > 1.65) & (t < 1.95)].mean())


def sudden_load(
    payload: float, mass: float, n: int, duration: float, h: float, zeta: float = 0.0
) -> tuple[Array, Array]:
    """Force at the support and elongation over their static values, after a load is suddenly applied."""
    L, EA, F = 1.0, 1e4, 1.0
    omega = np.sqrt(EA / L / payload)
    m = models.straight(n, L, payload=payload, EA=EA, mass=mass, damping=2 * zeta / omega)
    m.load(f"rope_p{n}.x", F)
    motion = steps(m.build(), duration, h)
    return -motion["force:rope_p0.x"] / F, (motion[f"rope_p{n}.x"] - L) * EA / (F * L)


def light_rope_factor(zeta: float) -> float:
    """Largest elongation over the static one; the rope has a millionth of the payload."""
    period = 2 * np.pi * np.sqrt(1.0 / 1e4)
    return float(sudden_load(1.0, 1e-6, 1, 0.7 * period, period / 200, zeta)[1].max())


def oscillator_factor(zeta: float) -> float:
    """Closed form of `light_rope_factor`."""
    return float(1 + np.exp(-np.pi * zeta / np.sqrt(1 - zeta**2)))


def heavy_rope_factor(share: float) -> float:
    """Largest force at the top over the load, of a rope with a share of the payload's mass."""
    passage = np.sqrt(share / 1e4)
    return float(sudden_load(1.0, share, 8, 40 * passage, passage / 20)[0].max())


def swing_error(steps_taken: int, h: float = 5e-4) -> float:
    """Largest energy that does not add up over the largest kinetic energy, of a rope that falls and swings freely."""
    motion = models.swinging(2).simulate_stiff(
        steps_taken * h, samples=101, step=h, radius=1.0, progress=False
    )
    balance = motion.energy_balance()
    return float(np.abs(balance["error"]).max() / balance["kinetic"].max())


def rows() -> list[Quantity]:
    """Waves, sudden loads, energy."""
    t, tip, support = pulled(20)
    triangle = 1 - abs(1 - np.remainder(t, 1) * 2)
    windows = [abs(t - share) < 0.1 for share in (0.15, 0.5, 1.0, 1.5)]
    forces = [support[z].mean() for z in windows]
    light = [light_rope_factor(z) for z in DAMPING_RATIOS]
    heavy = [heavy_rope_factor(z) for z, _ in HEAVY]
    return [
        Quantity("wave_tip_error", float(abs(tip - triangle).max()), 0.0, 0.02, "", "triangle of period 4 L/c", {"elements": 20}),
        Quantity("wave_support_force", forces, (0.0, 2.0, 0.0, 2.0), 0.015, "F", "0 and 2 F in turn", {"elements": 20}),
        Quantity("wave_reflection", reflected(4.0), (1.0, 4 / 3), 0.01, "Z1 v", "1 + (Z2 - Z1)/(Z2 + Z1), Z2 = 2 Z1", {"elements": 40}),
        Quantity("sudden_load", light, [oscillator_factor(z) for z in DAMPING_RATIOS], 1e-3, "",
                 "1 + exp(-pi zeta/sqrt(1 - zeta²))", {"elements": 1, "zeta": list(DAMPING_RATIOS)}),
        Quantity("sudden_load_heavy_rope", heavy, [z for _, z in HEAVY], 0.01, "", SERIES,
                 {"elements": 8, "rope_over_payload": [z for z, _ in HEAVY]}),
        Quantity("swing_energy_error", swing_error(10_000), 0.0, 1e-3, "", "no damping, 10 000 steps, radius 1",
                 {"elements": 2, "step": 5e-4}),
    ]  # fmt: skip
