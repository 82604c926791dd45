"""Straight ropes in motion: tension waves, loads that are suddenly applied, frequencies."""

from __future__ import annotations

from functools import cache

import numpy as np

import flexel as fx
from flexel.base.arrays import Array
from flexel.examples import rope_exact as exact
from flexel.examples import rope_models as models
from flexel.examples.rope_table import over_meshes
from flexel.parts.cable_results import cable_tension
from flexel.results.reproduction import Quantity

DAMPING_RATIOS = (0.0, 0.01, 0.02, 0.05, 0.1, 0.2)
HEAVY = (0.01, 2.0027447663037883), (0.1, 2.0308778818386233), (0.5, 2.103196887658231)
PULSE = (5, 10, 20)  # elements of each of two ropes, and a tenth of the steps in the passage of a wave
SERIES = "largest force at the top within 40 L/c, modal series of 300 modes"


def steps(system: fx.System, duration: float, h: float, radius: float = 0.9) -> fx.Motion:
    """Integrate with constant implicit steps, and keep all of them."""
    samples = round(duration / h) + 1
    return system.simulate(
        duration, method="generalized-alpha", samples=samples, step=h, spectral_radius=radius, progress=False
    )


@cache
def pulled(n: int) -> tuple[Array, Array, Array]:
    """Return times over the period, tip over 2 F L/EA, and support force over F, of a rope whose free end is pulled."""
    L, EA, mass, F = 10.0, 1e6, 1.0, 10.0
    m = models.straight(n, L, EA=EA, mass=mass)
    m.load(f"rope_p{n}.x", F)
    period = 4 * L / np.sqrt(EA / mass)
    motion = steps(m.build(), 1.5 * period, period / (20 * n))
    tip = (motion[f"rope_p{n}.x"] - L) * EA / (2 * F * L)
    return motion.t / period, tip, -motion["force:rope_p0.x"] / F


@cache
def pulse(n: int, ratio: float = 4.0) -> tuple[Array, Array, Array]:
    """Return times over L/c, tension in the middle of a rope over Z₁ v, and the same by d'Alembert.

    One end of the rope is drawn at v sin²(π t/τ) for τ = L/c; at the other a second rope of `ratio` times the mass
    per length sends the share (Z₂ - Z₁)/(Z₂ + Z₁) back, with an impedance Z proportional to the mass's root.
    """
    L, EA, mass, v = 10.0, 1e6, 1.0, 1e-2
    c = np.sqrt(EA / mass)
    tau = L / c
    turn = 2 * np.pi / tau
    m = fx.Model()
    one = m.cable_line("one", [(0, 0), (L, 0)], n, EA=EA, EI=0.0, mass_per_length=mass)
    two = m.cable_line(
        "two", [(L, 0), (2 * L, 0)], n, start=one.points[-1], EA=EA, EI=0.0, mass_per_length=ratio * mass
    )
    nodes = (*one.points, *two.points[1:], *one.slopes, *two.slopes)
    m.fix(*(f"{node.name}.y" for node in nodes), two.points[-1])
    drawn = (
        lambda t: -v * (t / 2 - np.sin(turn * t) / (2 * turn)) if t < tau else -v * tau / 2,
        lambda t: -v * np.sin(turn * t / 2) ** 2 if t < tau else 0.0,
        lambda t: -v * turn / 2 * np.sin(turn * t) if t < tau else 0.0,
    )
    m.prescribe("one_p0.x", drawn)
    motion = steps(m.build(), 2.5 * tau, tau / (10 * n))
    found = [cable_tension(state, f"one{n // 2}") for state in motion]
    x = L / n * (n // 2 - 1) + found[0][0][-1]
    share = (np.sqrt(ratio) - 1) / (np.sqrt(ratio) + 1)

    def shape(since: Array) -> Array:
        return np.where((since > 0) & (since < tau), np.sin(turn * since / 2) ** 2, 0.0)

    given = shape(motion.t - x / c) + share * shape(motion.t - (2 * L - x) / c)
    return motion.t / tau, np.array([T[-1] for _, T in found]) / (np.sqrt(EA * mass) * v), given


@cache
def pulse_errors(n: int) -> tuple[float, float, float]:
    """Return errors of tension over its peak, of the wave's speed by its centroid, and of the share that comes back."""
    t, T, given = pulse(n)
    first = t < 1.5 - 0.25 / n  # the last Gauss point before the middle
    before, after = (float(T[part].sum()) for part in (first, ~first))
    arrival, exactly = (float((force[first] @ t[first]) / force[first].sum()) - 0.5 for force in (T, given))
    share = float(given[~first].sum() / given[first].sum())
    return float(abs(T - given).max()), abs(exactly / arrival - 1), abs(after / before / share - 1)


def sudden_load(
    payload: float, mass: float, n: int, duration: float, h: float, zeta: float = 0.0, F: float = 1.0
) -> tuple[Array, Array]:
    """Return force at the support and elongation over their static values, after a load is suddenly applied."""
    L, EA = 1.0, 1e4
    omega = np.sqrt(EA / L / payload)
    m = models.straight(n, L, payload=payload, EA=EA, mass=mass, damping=2 * zeta / omega)
    m.load(f"rope_p{n}.x", F)
    motion = steps(m.build(), duration, h)
    return -motion["force:rope_p0.x"] / F, (motion[f"rope_p{n}.x"] - L) * EA / (F * L)


def light_rope_factor(zeta: float, count: int) -> float:
    """Return the largest elongation over the static one, with some steps a period; the rope has 1e-6 of the payload."""
    period = 2 * np.pi * np.sqrt(1.0 / 1e4)
    return float(sudden_load(1.0, 1e-6, 1, 0.7 * period, period / count, zeta, F=0.1)[1].max())


def oscillator_factor(zeta: float) -> float:
    """Return the closed form of `light_rope_factor`."""
    return float(1 + np.exp(-np.pi * zeta / np.sqrt(1 - zeta**2)))


def heavy_rope_factor(share: float) -> float:
    """Return the largest force at the top over the load, of a rope with a share of the payload's mass."""
    passage = np.sqrt(share / 1e4)
    return float(sudden_load(1.0, share, 8, 40 * passage, passage / 20)[0].max())


def triangle_error(n: int) -> float:
    """Return the largest error of the pulled tip over its largest displacement."""
    t, tip, _ = pulled(n)
    return float(abs(tip - (1 - abs(1 - np.remainder(t, 1) * 2))).max())


def light_rope_error(count: int) -> float:
    """Return the largest relative error of the factors of a light rope, with a number of steps in a period."""
    found = np.array([light_rope_factor(ratio, count) for ratio in DAMPING_RATIOS])
    return float(abs(found / [oscillator_factor(ratio) for ratio in DAMPING_RATIOS] - 1).max())


def axial_frequencies(share: float, n: int) -> Array:
    """Return the three lowest frequencies along a rope with a share of its payload's mass, over sqrt(k/payload)."""
    system = models.straight(n, 1.0, payload=1.0 / share, EA=1.0, mass=1.0).build()
    return np.asarray([mode.omega for mode in system.vibrations(count=3)] / np.sqrt(share))


def axial_error(n: int) -> float:
    """Return the largest relative error of three frequencies of three ropes."""
    return max(
        float(abs(axial_frequencies(share, n) / exact.stretched_frequencies(share, 3) - 1).max())
        for share, _ in HEAVY
    )


def rows() -> list[Quantity]:
    """Compare waves, sudden loads, frequencies along the rope."""
    t, _, support = pulled(20)
    forces = [support[abs(t - share) < 0.1].mean() for share in (0.15, 0.5, 1.0, 1.5)]
    heavy = [heavy_rope_factor(share) for share, _ in HEAVY]
    shares = [share for share, _ in HEAVY]
    lowest = [float(axial_frequencies(share, 4)[0]) for share in shares]
    return [
        over_meshes("wave_speed_error", lambda n: pulse_errors(n)[1], PULSE, 2.5e-5, "sqrt(EA/rhoA), of a pulse"),
        over_meshes("wave_pulse_error", lambda n: pulse_errors(n)[0], PULSE, 1.5e-3, "d'Alembert, over the peak"),
        over_meshes("wave_reflection_error", lambda n: pulse_errors(n)[2], PULSE, 4e-4, "(Z2 - Z1)/(Z2 + Z1) = 1/3"),
        over_meshes("wave_tip_error", triangle_error, (10, 20, 40), 0.015, "pulled suddenly: triangle of period 4 L/c"),
        Quantity("wave_support_force", forces, (0.0, 2.0, 0.0, 2.0), 0.04, "F", "0 and 2 F in turn", {"elements": 20},
                 kind="closed form", tolerance_kind="absolute"),
        over_meshes("sudden_load_error", light_rope_error, (10, 20, 40), 1e-3,
                    "1 + exp(-pi zeta/sqrt(1 - zeta²)), zeta 0 to 0.2; steps in a period", 1),
        Quantity("sudden_load_factor", light_rope_factor(0.0, 40), 2.0, 3e-5, "", "2, undamped", {"elements": 1},
                 kind="closed form"),
        Quantity("sudden_load_heavy_rope", heavy, [factor for _, factor in HEAVY], 0.01, "", SERIES,
                 {"elements": 8, "rope_over_payload": shares}, kind="closed form"),
        over_meshes("axial_frequencies_error", axial_error, (4, 8, 16), 1.5e-7, "beta tan beta = rope over payload"),
        Quantity("axial_frequency", lowest, [1 / np.sqrt(1 + share / 3) for share in shares], 4e-3, "sqrt(k/M)",
                 "mass and spring with a third of the rope's mass", {"elements": 4, "rope_over_payload": shares},
                 kind="closed form"),
    ]  # fmt: skip
