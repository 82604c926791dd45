"""Cables in motion beside the data as published: tension waves, sudden loads, the falling flexible pendulum, energy."""

import json
from pathlib import Path

import numpy as np
import pytest

import flexel as fx
from flexel.examples import rope_models
from flexel.examples import rope_swings as swings
from flexel.examples import rope_waves as waves
from flexel.examples.published import published

FOLDER = Path(__file__).parents[1] / "data"
DATA = json.loads((FOLDER / "rope_analytic.json").read_text())
PENDULUM = published("flexible_pendulum")


def test_tension_pulse_is_reflected_by_a_lighter_rope_with_the_other_sign() -> None:
    """(Z₂ - Z₁)/(Z₂ + Z₁) = -1/3 of it comes back."""
    t, T, exact = waves.pulse(20, 0.25)
    assert exact.min() == pytest.approx(-1 / 3, abs=1e-3)
    assert abs(T - exact).max() < 2e-3
    assert T[t > 1.6].min() == pytest.approx(-1 / 3, abs=1e-3)


def test_factors_of_sudden_loads_are_those_of_the_tables() -> None:
    table = {row["zeta"]: row["DLF"] for row in DATA["sudden_load_massless_rope"]["table"]}
    assert tuple(table) == waves.DAMPING_RATIOS
    assert [waves.oscillator_factor(ratio) for ratio in table] == pytest.approx(
        list(table.values()), rel=1e-12
    )
    rows = DATA["rope_with_mass_and_payload"]["rows"][:3]
    assert [(row["mu"], row["DLF_top_40L_over_c"]) for row in rows] == list(waves.HEAVY)


def test_force_of_a_light_rope_is_twice_the_sudden_load() -> None:
    period = 2 * np.pi * np.sqrt(1.0 / 1e4)
    force, _ = waves.sudden_load(1.0, 1e-6, 1, 0.7 * period, period / 200)
    assert force.max() == pytest.approx(2.0, rel=1e-3)


def test_pendulum_has_the_gravity_of_the_table() -> None:
    assert PENDULUM["data"]["g"] == rope_models.G


def test_softer_pendulum_follows_the_assumed_modes_as_closely_as_these_converge() -> None:
    case = PENDULUM["cases"][2]
    assert swings.pendulum_error(8, case["E"]) < 2 * case["mode_convergence"]


def test_energy_is_kept_without_damping() -> None:
    """A rope that swings freely in space, integrated to 1e-10 a step: kinetic, potential and strain energy together."""
    m = fx.Model(gravity=(0, 0, -9.81))
    rope = m.cable_line("rope", [(0, 0, 0), (1, 0, 0)], 2, EA=5e2, EI=0.05, mass_per_length=0.4)
    m.fix(rope.points[0])
    m.initial("rope_p2.y", rate=1.0)
    m.independent(*(f"{node.name}.{c}" for node in (*rope.points[1:], *rope.slopes) for c in "xyz"))
    motion = m.build().simulate(0.2, samples=21, rtol=1e-10, atol=1e-12, progress=False)
    energy = np.array([state.energy.total for state in motion])
    kinetic = max(state.energy.kinetic for state in motion)
    assert abs(energy - energy[0]).max() < 1e-8 * kinetic
    assert kinetic > 0.3


def test_gaps_of_grooves_are_not_chosen_as_degrees_of_freedom() -> None:
    """Outside a groove its gap has a kink in the middle: a rope that is drawn there could not move from it."""
    m = fx.Model(gravity=(0, 0, -9.81))
    m.point("axle", (0, 0, 0), fixed=True)
    m.frame("ground", fixed=True)
    m.frame("wheel")
    m.hinge("bearing", "ground", "wheel", axis=(0, 1, 0))
    m.body("rim", "axle", "wheel", mass=1.0, inertia=(0.07, 0.07, 0.07))
    groove = fx.RoundGroove(5.5e-3, 0.8)
    m.sheave("sheave", "axle", "wheel", radius=0.2, axle=(0, 1, 0), groove=groove)
    for name, x in (("A", -0.2), ("B", 0.2)):
        m.point(name, (x, 0, -0.2))
        m.point_mass(f"mass {name}", name, 1.0)
    contact = fx.Contact(2.5e5)
    data = {"radius": 5e-3, "tension": 9.81, "EA": 450.0, "EI": 0.3, "mass_per_length": 0.9}
    m.rope("rope", ["A", ("sheave", 1), "B"], 12, contact=contact, **data)
    s = m.build()
    assert not [name for name in s.dynamic if name.endswith(".gap")]
    motion = s.simulate(0.01, method="DOP853", rtol=1e-8, progress=False)
    assert motion.message == f"reached the end ({motion.verdict})"
