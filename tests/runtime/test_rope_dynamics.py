"""Cables in motion: tension waves, suddenly applied loads, the falling flexible pendulum, energy."""

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import flexel as fx
from flexel.examples import rope_waves as waves

FOLDER = Path(__file__).parents[1] / "data"
DATA = json.loads((FOLDER / "rope_analytic.json").read_text())
PENDULUM = json.loads((FOLDER / "flexible_pendulum.json").read_text())


def test_suddenly_pulled_end_moves_in_a_triangular_wave_and_the_support_sees_0_and_2F() -> None:
    """The wave runs at c = sqrt(EA/rhoA): first news at the support after L/c, period 4 L/c, amplitude 2 F L/EA."""
    t, tip, support = waves.pulled(20)
    assert tip == pytest.approx(1 - abs(1 - np.remainder(t, 1) * 2), abs=0.02)
    for share, force in ((0.15, 0.0), (0.5, 2.0), (1.0, 0.0), (1.5, 2.0)):
        assert support[abs(t - share) < 0.1].mean() == pytest.approx(force, abs=0.03)


@pytest.mark.parametrize("ratio", [0.25, 4.0])
def test_tension_pulse_is_reflected_by_another_rope(ratio: float) -> None:
    """A pulled end sends a wave T = Z v; at a rope of impedance Z₂ the part (Z₂ - Z₁)/(Z₂ + Z₁) comes back."""
    before, after = waves.reflected(ratio)
    R = (np.sqrt(ratio) - 1) / (np.sqrt(ratio) + 1)
    assert before == pytest.approx(1, rel=0.01)
    assert after == pytest.approx(1 + R, rel=0.02)


def test_sudden_load_on_a_light_rope_has_the_factor_of_the_oscillator() -> None:
    """Factor 1 + exp(-pi zeta/sqrt(1 - zeta²)), two without damping."""
    table = {row["zeta"]: row["DLF"] for row in DATA["sudden_load_massless_rope"]["table"]}
    assert tuple(table) == waves.DAMPING_RATIOS
    for zeta, factor in table.items():
        assert waves.oscillator_factor(zeta) == pytest.approx(factor, rel=1e-12)
        assert waves.light_rope_factor(zeta) == pytest.approx(factor, rel=1e-3)
    period = 2 * np.pi * np.sqrt(1.0 / 1e4)
    assert waves.sudden_load(1.0, 1e-6, 1, 0.7 * period, period / 200)[0].max() == pytest.approx(
        2.0, rel=1e-3
    )


def test_sudden_load_on_a_rope_with_mass() -> None:
    """Largest tension at the top within 40 passages of the wave, from the series of 300 modes."""
    rows = DATA["rope_with_mass_and_payload"]["rows"][:3]
    assert [(row["mu"], row["DLF_top_40L_over_c"]) for row in rows] == list(waves.HEAVY)
    for share, factor in waves.HEAVY:
        assert waves.heavy_rope_factor(share) == pytest.approx(factor, rel=0.01)


def pendulum(case: dict[str, Any], n: int) -> fx.System:
    data = PENDULUM["data"]
    m = fx.Model(gravity=(0, -data["g"]))
    given = {"EA": case["EA"], "EI": case["EI"], "mass_per_length": data["rho"] * data["A"]}
    rope = m.cable_line("rod", [(0, 0), (data["L"], 0)], n, **given)
    m.fix(rope.points[0])
    return m.build()


@pytest.mark.parametrize("case", PENDULUM["cases"][1:], ids=lambda case: f"E{case['E']:g}")
def test_falling_flexible_pendulum(case: dict[str, Any]) -> None:
    """Tip history of the planar pendulum of the literature, against a solution by assumed modes."""
    rows = [row for row in case["reference"] if row["t"] <= 1.0]
    n = 8
    motion = waves.steps(pendulum(case, n), rows[-1]["t"], 1e-3)
    tip = np.array([state.position(f"rod_p{n}") for state in motion])[::50]
    exact = np.array([row["tip"] for row in rows])
    length = PENDULUM["data"]["L"]
    assert np.linalg.norm(tip - exact, axis=1).max() < 0.002 * length


def test_energy_is_kept_without_damping() -> None:
    """A rope that swings freely in space, integrated to 1e-10 a step: kinetic, potential and strain energy together."""
    m = fx.Model(gravity=(0, 0, -9.81))
    rope = m.cable_line("rope", [(0, 0, 0), (1, 0, 0)], 2, EA=5e2, EI=0.05, mass_per_length=0.4)
    m.fix(rope.points[0])
    m.initial("rope_p2.y", rate=1.0)
    m.independent(*(f"{z.name}.{c}" for z in (*rope.points[1:], *rope.slopes) for c in "xyz"))
    motion = m.build().simulate(0.2, samples=21, rtol=1e-10, atol=1e-12, progress=False)
    energy = np.array([state.energy.total for state in motion])
    kinetic = max(state.energy.kinetic for state in motion)
    assert abs(energy - energy[0]).max() < 1e-8 * kinetic
    assert kinetic > 0.3
