"""Cables in motion: tension waves, suddenly applied loads, the falling flexible pendulum, energy."""

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import flexel as fx
from flexel.cables import cable_tension

FOLDER = Path(__file__).parents[1] / "data"
DATA = json.loads((FOLDER / "rope_analytic.json").read_text())
PENDULUM = json.loads((FOLDER / "flexible_pendulum.json").read_text())


def steps(system: fx.System, duration: float, h: float) -> fx.Motion:
    """Integrate with constant implicit steps: the tolerance is so loose that it never shortens one."""
    samples = round(duration / h) + 1
    return system.simulate_stiff(
        duration, samples=samples, tolerance=1e9, first_step=h, max_step=h, radius=0.9, progress=False
    )


def straight(
    n: int, L: float, *, payload: float = 0.0, EA: float, mass: float, damping: float = 0.0
) -> fx.Model:
    """A cable along x, fixed at its first end, that can move along x only."""
    m = fx.Model()
    rope = m.cable_line("rope", [(0, 0), (L, 0)], n, EA=EA, EI=0.0, mass_per_length=mass, damping=damping)
    m.fix(rope.points[0], *(f"{z.name}.y" for z in (*rope.points[1:], *rope.slopes)))
    if payload:
        m.point_mass("payload", rope.points[-1], payload)
    return m


def test_suddenly_pulled_end_moves_in_a_triangular_wave_and_the_support_sees_0_and_2F() -> None:
    """The wave runs at c = sqrt(EA/rhoA): first news at the support after L/c, period 4 L/c, amplitude 2 F L/EA."""
    n, L, EA, mass, F = 20, 10.0, 1e6, 1.0, 10.0
    m = straight(n, L, EA=EA, mass=mass)
    m.load(f"rope_p{n}.x", F)
    T = 4 * L / np.sqrt(EA / mass)
    motion = steps(m.build(), 1.5 * T, T / 400)
    tip = motion[f"rope_p{n}.x"] - L
    top = 2 * F * L / EA
    triangle = top * (1 - abs(1 - np.remainder(motion.t / T, 1) * 2))
    assert tip == pytest.approx(triangle, abs=0.02 * top)
    support = np.array([-state.force("rope_p0.x") for state in motion])
    for share, force in ((0.15, 0.0), (0.5, 2 * F), (1.0, 0.0), (1.5, 2 * F)):
        window = abs(motion.t / T - share) < 0.1
        assert support[window].mean() == pytest.approx(force, abs=0.03 * F)


def test_tension_pulse_is_reflected_by_a_heavier_rope() -> None:
    """A pulled end sends a wave T = Z v; at a rope of impedance Z₂ the part (Z₂ - Z₁)/(Z₂ + Z₁) comes back."""
    L, EA, mass, v = 10.0, 1e6, 1.0, 1e-2
    n, ratio = 20, 4.0  # the second rope has four times the mass: Z₂ = 2 Z₁, c₂ = c₁/2
    m = fx.Model()
    one = m.cable_line("one", [(0, 0), (L, 0)], n, EA=EA, EI=0.0, mass_per_length=mass)
    two = m.cable_line(
        "two", [(L, 0), (2 * L, 0)], n, start=one.points[-1], EA=EA, EI=0.0, mass_per_length=4 * mass
    )
    nodes = (*one.points, *two.points[1:], *one.slopes, *two.slopes)
    m.fix(*(f"{z.name}.y" for z in nodes))
    m.fix(two.points[-1])
    c = np.sqrt(EA / mass)
    m.prescribe("one_p0.x", lambda t: -v * t)
    motion = steps(m.build(), 2 * L / c, L / c / 200)
    Z1 = np.sqrt(EA * mass)
    R = (np.sqrt(ratio) - 1) / (np.sqrt(ratio) + 1)
    probe = np.array(
        [cable_tension(state, "one10")[1][-1] for state in motion]
    )  # near the middle of the first rope
    before = probe[(motion.t * c / L > 0.7) & (motion.t * c / L < 1.2)].mean()
    after = probe[(motion.t * c / L > 1.65) & (motion.t * c / L < 1.95)].mean()
    assert before == pytest.approx(Z1 * v, rel=0.01)
    assert after == pytest.approx(Z1 * v * (1 + R), rel=0.01)


def loaded(
    payload: float, mass: float, n: int, duration: float, h: float, zeta: float = 0.0
) -> tuple[np.ndarray, np.ndarray]:
    """Tension at the support and elongation over their static values, after a load is suddenly applied."""
    L, EA, F = 1.0, 1e4, 1.0
    omega = np.sqrt(EA / L / payload)
    m = straight(n, L, payload=payload, EA=EA, mass=mass, damping=2 * zeta / omega)
    m.load(f"rope_p{n}.x", F)
    motion = steps(m.build(), duration, h)
    return np.array([-state.force("rope_p0.x") for state in motion]) / F, (
        motion[f"rope_p{n}.x"] - L
    ) * EA / (F * L)


@pytest.mark.parametrize(
    "row", DATA["sudden_load_massless_rope"]["table"], ids=lambda row: f"zeta{row['zeta']}"
)
def test_sudden_load_on_a_light_rope_has_the_factor_of_the_oscillator(row: dict[str, Any]) -> None:
    """Factor 1 + exp(-pi zeta/sqrt(1 - zeta²)), two without damping; the rope has a millionth of the payload."""
    period = 2 * np.pi * np.sqrt(1.0 / 1e4)
    tension, elongation = loaded(1.0, 1e-6, 1, 0.7 * period, period / 200, row["zeta"])
    assert elongation.max() == pytest.approx(row["DLF"], rel=1e-3)
    if row["zeta"] == 0:
        assert tension.max() == pytest.approx(2.0, rel=1e-3)


@pytest.mark.parametrize(
    "row", DATA["rope_with_mass_and_payload"]["rows"][:3], ids=lambda row: f"mu{row['mu']}"
)
def test_sudden_load_on_a_rope_with_mass(row: dict[str, Any]) -> None:
    """Largest tension at the top within 40 passages of the wave, from the series of 300 modes."""
    passage = np.sqrt(row["mu"] / 1e4)
    found = loaded(1.0, row["mu"], 8, 40 * passage, passage / 20)[0].max()
    assert found == pytest.approx(row["DLF_top_40L_over_c"], rel=0.01)


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
    motion = steps(pendulum(case, n), rows[-1]["t"], 1e-3)
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
