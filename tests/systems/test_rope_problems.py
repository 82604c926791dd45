"""The rope problems beside their closed forms: rows, orders of convergence, data as published."""

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from flexel.examples import rope_drums as drums
from flexel.examples import rope_exact as exact
from flexel.examples import rope_hanging as hanging
from flexel.examples import rope_hoists as hoists
from flexel.examples import rope_pendulums as pendulums
from flexel.examples import rope_sheaves as sheaves
from flexel.examples import rope_swings as swings
from flexel.examples import rope_waves as waves
from flexel.results.reproduction import Quantity


@pytest.fixture(scope="module")
def benchmark(checkout: Path) -> dict[str, Any]:
    found: dict[str, Any] = json.loads((checkout / "tests/data/rope_analytic.json").read_text())
    return found


@pytest.fixture(scope="module")
def at_rest() -> list[Quantity]:
    """Rows of hanging ropes and chains."""
    return hanging.rows()


def failures(rows: list[Quantity]) -> list[str]:
    return [f"{row.name}: {row.error}" for row in rows if not row.ok]


def orders(rows: list[Quantity]) -> dict[str, Any]:
    return {row.name: row.more["order"] for row in rows if "order" in row.more}


def test_hanging_ropes_and_chains_converge_with_their_order(at_rest: list[Quantity]) -> None:
    assert failures(at_rest) == []
    found = orders(at_rest)
    assert [found[name] for name in ("catenary_error", "catenary_sag_error")] == pytest.approx(
        [4, 4], abs=0.05
    )
    assert found["hanging_frequencies_error"] == pytest.approx(2, abs=0.05)
    assert found["loaded_chain_frequencies_error"] > 2.5
    assert found["elastica_error"] == pytest.approx(4, abs=0.05)
    coarse, *_ = next(row.more["errors"] for row in at_rest if row.name == "wrapped_rope_error")
    assert coarse < 5e-3  # elements of 0.45 radii


@pytest.mark.long
def test_waves_and_sudden_loads_have_their_closed_forms() -> None:
    """A smooth pulse converges with the order of the steps, a jump of tension with less than one."""
    rows = waves.rows()
    assert failures(rows) == []
    found = orders(rows)
    assert found["wave_pulse_error"] == pytest.approx(2, abs=0.2)
    assert min(found[name] for name in ("wave_speed_error", "wave_reflection_error", "sudden_load_error")) > 2
    assert 0.6 < found["wave_tip_error"] < 1
    assert found["axial_frequencies_error"] > 5


@pytest.mark.slow
@pytest.mark.long
def test_pendulum_converges_and_a_swinging_rope_keeps_its_energy() -> None:
    rows = swings.rows()
    assert failures(rows) == []
    found = orders(rows)
    assert found["pendulum_error"] > 3
    assert found["pendulum_soft_change"] > 2


def test_reference_of_a_wrapping_pendulum_returns_after_the_period_of_its_energy() -> None:
    start, once = pendulums.HELD.start, pendulums.period(pendulums.HELD.start)
    path = pendulums.exact(pendulums.HELD, np.array([0, once / 2, once]))
    assert path[2] == pytest.approx(path[0], abs=1e-9)
    assert path[1, 0] < 0
    small = 2 * np.pi * np.sqrt(pendulums.FREE / pendulums.G)  # without the mass of the rope
    assert pendulums.period(0.01) == pytest.approx(small, rel=1e-3)
    assert once > 1.04 * pendulums.period(start / 100)


def test_reference_of_the_swinging_atwoods_machine_without_a_swing_is_the_cosh_law() -> None:
    case, t = pendulums.Swing(0.0, 0.5, mass=0.8, inertia=2e-3), np.linspace(0, 0.5, 6)
    rope, free, other = pendulums.ROPE, pendulums.FREE, pendulums.OTHER
    moved = pendulums.BOB + 0.8 + 2e-3 / 0.1**2 + rope * (free + other + 0.1 * np.pi)
    rate = np.sqrt(2 * rope * pendulums.G / moved)
    start = pendulums.G * (pendulums.BOB - 0.8 + rope * (free - other)) / moved
    fall = start * (np.cosh(rate * t) - 1) / rate**2
    assert -free - pendulums.exact(case, t)[:, 1] == pytest.approx(fall, abs=1e-9)


@pytest.mark.slow
@pytest.mark.long
def test_ropes_wrap_and_unwrap_a_sheave_as_lagranges_equations_say() -> None:
    rows = pendulums.rows()
    assert failures(rows) == []
    assert min(orders(rows).values()) > 2.5


@pytest.mark.slow
@pytest.mark.long
def test_capstan_has_eulers_ratio_for_all_wraps_and_frictions_of_the_table(benchmark: dict[str, Any]) -> None:
    table = {(row["mu"], row["phi_deg"]): row["ratio"] for row in benchmark["capstan"]["table"]}
    assert set(table) == {(mu, wrap) for mu in sheaves.FRICTIONS for wrap in sheaves.WRAPS}
    rows = sheaves.capstan()
    assert failures(rows) == []


def test_atwoods_machine_falls_as_its_closed_form_says(benchmark: dict[str, Any]) -> None:
    data, t = benchmark["atwood_pulley_inertia"], np.array([1e-3])
    given = {key: data["data"][key] for key in ("m1", "m2")} | {
        "inertia": data["data"]["I"],
        "radius": data["data"]["R"],
    }
    massless = exact.atwood_fall(t, rope=1e-9, length=1.0, **given)
    assert massless == pytest.approx(data["a"] * t**2 / 2, rel=1e-6)
    rows = sheaves.atwood()
    assert failures(rows) == []
    assert min(orders(rows).values()) > 2.8


def test_ropes_of_atwoods_machine_have_different_tensions(benchmark: dict[str, Any]) -> None:
    motion, rope = sheaves.atwood_motion(28, 0.01)
    data = benchmark["atwood_pulley_inertia"]
    window = motion[15:]
    ends = rope.tension(window)[1][:, [0, -1]].mean(axis=0)
    assert ends == pytest.approx([data["T1"], data["T2"]], rel=0.02)
    assert rope.wrap_angle(motion[-1], "S") == pytest.approx(np.pi, abs=2 * np.pi / 28)


def test_impact_has_hertzs_approach_and_duration(benchmark: dict[str, Any]) -> None:
    data = benchmark["hertz_bounce"]
    assert sheaves.BALL == {
        "stiffness": data["data"]["K"],
        "mass": data["data"]["m"],
        "speed": data["data"]["v"],
    }
    assert exact.hertz(**sheaves.BALL) == pytest.approx((data["delta_max"], data["t_contact"]), rel=1e-12)
    rows = sheaves.hertz()
    assert failures(rows) == []
    assert list(orders(rows).values()) == pytest.approx([2, 2], abs=0.1)


def test_impact_without_dissipation_gives_the_speed_back() -> None:
    assert sheaves.impact(400)[2][-1] == pytest.approx(1.0, abs=1e-6)


def test_hoist_with_one_dof_is_that_of_the_table(benchmark: dict[str, Any]) -> None:
    rows = benchmark["hoist_reduced_1dof"]["reference"]
    t, x, tension = (np.array([row[key] for row in rows]) for key in ("t", "x", "T_over_mg"))
    depth, pull = hoists.reduced(t, stretched=False)
    assert depth == pytest.approx(x, abs=1e-7)
    assert pull == pytest.approx(tension, abs=1e-4)


@pytest.mark.slow
@pytest.mark.long
def test_winding_hoist_lifts_as_with_one_dof() -> None:
    """What remains on fine meshes is the creep of the rope on the drum, which one degree of freedom has not."""
    rows = hoists.hoist()
    assert failures(rows) == []
    assert min(orders(rows).values()) > 0


@pytest.mark.slow
@pytest.mark.long
def test_tackle_has_the_advantage_the_speed_ratio_and_the_efficiency_of_its_falls() -> None:
    rows = hoists.tackle()
    assert failures(rows) == []
    assert min(orders(rows).values()) > 1


def test_rope_slides_off_an_edge_as_the_closed_form_says() -> None:
    rows = hoists.edge()
    assert failures(rows) == []
    assert orders(rows)["sliding_rope_error"] > 2


@pytest.mark.parametrize("lead", [drums.LEAD, -drums.LEAD])
@pytest.mark.long
def test_winch_lifts_by_the_length_of_the_helix_and_moves_its_rope_by_the_lead(lead: float) -> None:
    found, given = drums.lift(lead)
    assert found == pytest.approx(given, rel=5e-5)
    assert drums.groove_error(lead) < 1e-3
    motion, rope = drums.wound(lead)
    before, after = (drums.places(motion[i], rope)[-8:-1, 0].mean() for i in (0, -1))
    assert after - before == pytest.approx(drums.TURNS * -lead, rel=0.3)  # it swings a little
    assert [row.name for row in drums.rows() if not row.ok] == []


@pytest.mark.slow
@pytest.mark.long
def test_figures_are_written(at_rest: list[Quantity], tmp_path: Path) -> None:
    pytest.importorskip("matplotlib", reason="pictures need matplotlib: pip install 'flexel[plot]'")
    from flexel.examples.rope_figures import pictures

    for file in pictures(at_rest, tmp_path):
        assert file.stat().st_size > 10_000
