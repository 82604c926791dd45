"""The bicycle gives the published numbers."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import flexel as fx
from flexel.examples import bicycle as example
from flexel.examples import bicycle_data as data
from flexel.examples import bicycle_file
from flexel.examples.published import published
from flexel.examples.stable_speeds import LEAN_STEER
from flexel.results.reproduction import Quantity

NAMES = {
    "Browserins": "Browser with instruments",
    "Yellowrev": "Yellow, fork reversed",
    "Rigid": "Rigid rider bicycle",
}


# From the benchmark collection: Meijaard et al. (2007), computed with 22 digits; IFToMM manoeuvre M1.
@pytest.fixture(scope="module")
def whipple() -> dict[str, Any]:
    return published("bicycle_whipple")


@pytest.fixture(scope="module")
def m1() -> dict[str, Any]:
    return published("bicycle_manoeuvre_M1")


@pytest.fixture(scope="module")
def results() -> example.BicycleResults:
    return example.analyse()


@pytest.fixture(scope="module")
def system(results: example.BicycleResults) -> fx.System:
    return results.system


@pytest.fixture(scope="module")
def rows(results: example.BicycleResults) -> Mapping[str, Quantity]:
    parts = (example.counts, example.linear, example.manoeuvre, example.kicks)
    return {row.name: row for part in parts for row in part(results)} | {
        row.name: row for row in bicycle_file.of_the_file()
    }


def floats(matrix: Any) -> Any:
    return np.array(matrix, dtype=float)


def test_measured_bicycles_are_those_of_the_file(whipple: dict[str, Any]) -> None:
    """All but the moments of inertia about the axle, which are moved where no body could have them."""
    bikes = {
        NAMES.get(name, name): bike for name, bike in whipple["measured_bikes"].items() if name != "Benchmark"
    }
    for name, bike in bikes.items():
        for key, value in data.MEASURED[name].items():
            changed = key in ("IByy", "IHyy")
            assert value == pytest.approx(bike["params"][key], rel=0.15 if changed else 0, abs=0)


# -- the numbers ----------------------------------------------------------------------------------


@pytest.mark.long
def test_the_report_has_every_name_of_the_list(rows: Mapping[str, Quantity]) -> None:
    wanted = "M C1 K0 K2 eigenvalues weave_speed capsize_speed M1_steer_5s M1_energy_drift kick_3.5 kick_4.5 kick_6.3"
    assert {
        *wanted.split(),
        "degrees_of_freedom",
        "kinematic_coordinates",
        "coordinates",
        "deformations",
    } <= set(rows)


def test_every_quantity_is_within_its_tolerance(rows: Mapping[str, Quantity]) -> None:
    assert {name: row.error for name, row in rows.items() if not row.ok} == {}


def test_three_dofs_and_four_kinematic_coordinates(system: fx.System) -> None:
    """Two wheels, two beams, six hinges: counted, not assumed."""
    kinds = [instance.spec.name for instance in system.structure.instances]
    assert [kinds.count(kind) for kind in ("wheel", "beam3", "hinge")] == [2, 2, 6]
    assert system.counts["degrees_of_freedom"] == 3
    assert system.counts["kinematic_coordinates"] == 4


def test_matrices_agree_with_22_digits(results: example.BicycleResults, whipple: dict[str, Any]) -> None:
    for name, exact in whipple["computed_matrices"].items():
        difference = np.max(np.abs(results.matrices[name] - floats(exact)))
        assert difference < 1e-13 * np.max(np.abs(floats(exact)))


def test_eigenvalues_do_not_depend_on_where_the_bicycle_is(system: fx.System) -> None:
    """A steady motion elsewhere on the road and in another direction has the same eigenvalues."""
    start = example.rolling(system, 5.0)
    turned = system.state_at(
        {"yaw.angle": 0.8, "rear contact.x": 3.0, "rear contact.y": -2.0, "rear spin.angle": -4.0},
        rates={"lean.angle": 0.0, "steer.angle": 0.0, "rear spin.angle": start.rate("rear spin.angle")},
    )
    found = system.linearize(turned).reduced(LEAN_STEER).eigenvalues()
    assert np.max(np.abs(found - np.array(data.EIGENVALUES[5]))) < 1e-9


def test_the_bicycle_stands_still_too(system: fx.System) -> None:
    """At speed zero the eigenvalues are two real pairs of opposite sign."""
    w = example.lean_steer(system, 0.0).eigenvalues()
    assert np.max(np.abs(w.imag)) < 1e-12
    assert np.allclose(np.sort(w.real), -np.sort(w.real)[::-1], rtol=1e-12)


def test_steady_motion_near_capsize_is_found_from_a_leaning_start(system: fx.System) -> None:
    """Whatever is found is steady: upright, or a turn in which lean, steer and speed stay as they are."""
    state = example.steady(system, 6.0, lean=0.02, steer=-0.03)
    assert max(abs(state.acceleration(name)) for name in system.dynamic) < 1e-9
    assert state.drift < 1e-12


def test_stable_ranges_of_measured_bicycles(results: example.BicycleResults) -> None:
    for name, (weave, capsize) in results.measured.items():
        expected = data.MEASURED_SPEEDS[name]
        assert weave == pytest.approx(expected["weave"], rel=1e-9)
        assert (capsize is None) == (expected["capsize"] is None)
        assert capsize is None or capsize == pytest.approx(expected["capsize"], rel=1e-9)


def test_inertia_about_the_axle_does_not_enter_the_linear_equations() -> None:
    """Which is why the measured IByy and IHyy may be moved."""
    usual = example.lean_steer(example.bicycle(), 4.5)
    other = example.lean_steer(example.bicycle({**data.BENCHMARK, "IByy": 9.0, "IHyy": 0.056}), 4.5)
    for a, b in ((usual.M, other.M), (usual.C, other.C), (usual.K, other.K)):
        assert np.max(np.abs(a - b)) < 1e-12 * np.max(np.abs(a))


def test_manoeuvre_m1_follows_the_whole_reference(
    results: example.BicycleResults, m1: dict[str, Any]
) -> None:
    """Angles, rates, hub positions, pitch and energies at every stored time."""
    for row in m1["maneuvers"][0]["rows"]:
        state = results.m1.at(row["t"])
        found = [state["lean.angle"], state["steer.angle"], state["yaw.angle"], state["pitch.angle"]]
        found += [state.rate("lean.angle"), state.rate("steer.angle"), example.forward_speed(state)]
        found += [*state.position("rear hub"), *state.position("front hub")]
        keys = (
            "roll",
            "steer",
            "yaw",
            "pitch",
            "roll_rate_about_heading",
            "steer_rate",
            "rear_hub_velocity_body_x",
        )
        expected = [*(row[k] for k in keys), *row["rear_hub"], *row["front_hub"]]
        assert np.max(np.abs(np.array(found) - np.array(expected))) < 1e-9
        assert state.energy.kinetic == pytest.approx(row["T"], rel=1e-11)
        assert state.energy.potential == pytest.approx(row["V"], rel=1e-11)


def test_energy_drift_falls_with_the_tolerance(system: fx.System) -> None:
    coarse, fine = (example.energy_drift(example.kick(system, 3.5, 3.0, rtol=rtol)) for rtol in (1e-6, 1e-9))
    assert fine < 1e-2 * coarse
    assert coarse < 1e-4


def test_kicks_grow_decay_and_capsize(results: example.BicycleResults) -> None:
    """Below the weave speed the swing grows, in the stable range it dies out, above capsize the lean creeps up."""
    lean = {v: np.abs(motion["lean.angle"]) for v, motion in results.kicks.items()}
    first, last = slice(0, 80), slice(-80, None)
    assert lean[3.5][last].max() > 3 * lean[3.5][first].max()
    assert lean[4.5][last].max() < 0.3 * lean[4.5][first].max()
    assert np.all(np.diff(lean[6.3][last]) > 0)


def test_the_file_of_2003_differs_from_its_page(rows: Mapping[str, Quantity]) -> None:
    """What the seeds say of it: 0.75, 4.42 and 5.99 m/s; with the rider of the comment 0.92, 4.32 and 5.99."""
    assert rows["bike3_speeds"].computed == pytest.approx([0.75, 4.42, 5.99], abs=5e-3)
    assert rows["bike3_speeds_comment"].computed == pytest.approx([0.92, 4.32, 5.99], abs=5e-3)
    assert rows["bike3_speeds"].more["page"] == [0.9, 4.1, 5.7]


def test_the_file_of_2003_is_read_as_it_stands() -> None:
    file = fx.read_spacar(Path(bicycle_file.__file__).parent / "data" / "bike3.dat")
    assert file.system.dynamic == ("hinge6.angle", "hinge14.angle")
    assert file.system.initial.rate("hinge11.angle") == pytest.approx(30.0)


def test_a_bicycle_that_is_nowhere_stable_says_so() -> None:
    points = {name: 0.0 if name.startswith("I") else value for name, value in data.BENCHMARK.items()}
    with pytest.raises(fx.LinearizationError, match="stable at no speed up to 12 m/s: its weave grows"):
        example.stable_range(example.bicycle(points))
    with pytest.raises(fx.LinearizationError, match="stable at no speed up to 4 m/s"):
        example.stable_range(example.bicycle(), fastest=4.0)
    low = {**data.BENCHMARK, "zH": -0.25}
    with pytest.raises(fx.LinearizationError, match="grows up to 7.008 m/s, and another of its modes beyond"):
        example.stable_range(example.bicycle(low))
