"""No motion steps onto another branch: a sample of the campaign, events, dense output, and motions that must end."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest
import references
import sympy as sp
from branch_case import Case, run, verdict
from branch_families import case
from references import Constrained
from scipy.optimize import brentq

import flexel as fx
from flexel.base.arrays import Array
from flexel.derive import Deformation, Element, Frame, Parameter, Point

SAMPLE = [
    ("double", 0), ("double", 1), ("double", 4), ("triple", 1), ("triple", 0), ("four-bar", 1), ("four-bar", 2),
    ("change-point", 0), ("change-point", 1), ("change-point", 2), ("change-point", 10), ("parallelogram", 0),
    ("slider-crank", 0), ("slider-crank", 1),
    ("spatial", 1), ("spatial", 2), ("ball", 0), ("rssr", 1), ("wheel", 2), ("cardan", 0), ("driven", 0),
    ("driven", 1), ("rotor", 2), ("screw", 0),
]  # fmt: skip


@pytest.mark.parametrize(("family", "number"), SAMPLE)
@pytest.mark.parametrize("rtol", [1e-9, 1e-3])
def test_a_motion_in_bad_coordinates_stays_on_its_branch(family: str, number: int, rtol: float) -> None:
    found = verdict(case(family, number), "DOP853", rtol)
    assert not found.fails, str(found)


POOR = [
    ("double", 56),
    ("double", 106),
    ("double", 1097),
    ("triple", 1018),
    ("ball", 6),
    ("ball", 14),
    ("rssr", 1010),
]


@pytest.mark.parametrize(("family", "number"), POOR)
def test_an_error_of_bad_coordinates_is_not_enlarged_in_the_rates(family: str, number: int) -> None:
    """A step ended near their extreme: y was within the tolerance, and rates were off by 150 times as much."""
    found = verdict(case(family, number), "DOP853", 1e-3)
    assert not found.fails, str(found)


@pytest.mark.parametrize("number", [1005, 5014, 5128, 5180, 5185])
@pytest.mark.parametrize("rtol", [1e-3, 1e-5])
def test_a_bifurcation_is_crossed_in_a_gap_of_the_stages(number: int, rtol: float) -> None:
    """Stages close to the flat position are lost to rounding; shorter steps come only closer."""
    found = case("parallelogram", number)
    for coordinates in (found.bad, found.good):
        motion = run(found, coordinates, rtol=rtol, atol=1e-5, method="DOP853")
        assert found.error(motion) < 0.1
        assert motion.statistics["evaluations"] < 650  # the path across it is exact to 1e-7 at any tolerance


@pytest.mark.parametrize("atol", [1e-7, 1e-9, 1e-10, 1e-11])
@pytest.mark.parametrize("samples", [2, 201])
def test_the_pendulum_that_jumped_keeps_its_energy(atol: float, samples: int) -> None:
    """In P0.y and P1.x it gained 160 % and reported that it reached the end."""
    pendulum = case("double", 0)
    motion = pendulum.built(("P0.y", "P1.x")).simulate(1.0, rtol=1e-9, atol=atol, samples=samples)
    assert motion.message.startswith("reached the end")
    assert np.ptp(motion.energy["total"]) < 1e-4
    assert pendulum.error(motion) < 1e-4


REGULAR = [
    ("double", 3), ("triple", 1), ("four-bar", 2), ("parallelogram", 1), ("slider-crank", 1), ("spatial", 1),
    ("ball", 1), ("rssr", 1), ("wheel", 0), ("cardan", 0), ("driven", 0), ("driven", 1), ("rotor", 0), ("screw", 0),
]  # fmt: skip


@pytest.mark.parametrize(("family", "number"), REGULAR)
def test_the_references_are_the_motions_in_good_coordinates(family: str, number: int) -> None:
    found = case(family, number)
    assert found.error(run(found, found.good, method="DOP853", rtol=1e-10)) < 1e-6


@pytest.mark.parametrize(("family", "good"), [("rssr", "input.angle"), ("spatial", "")])
def test_the_reference_over_all_coordinates_keeps_energy_and_constraints(family: str, good: str) -> None:
    found = case(family, 1)
    reference = Constrained(found.built(found.good))
    y = reference.follow(0.3)
    assert reference.energy(y(0.3)) == pytest.approx(reference.energy(y(0.0)), abs=1e-10)
    assert y(0.3) == pytest.approx(reference.project(y(0.3)), abs=1e-10)


@pytest.mark.parametrize("number", [0, 5, 11])
@pytest.mark.long
def test_the_reference_past_a_change_point_is_sharp(number: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """No coordinates are good there; with steps for 1e-10 it is the same."""
    found = case("change-point", number)
    times = np.linspace(0, found.duration, 11)
    fine = found.motion(times)
    monkeypatch.setattr(references, "RTOL", 1e-10)
    assert found.exact()(times) == pytest.approx(fine, abs=1e-7)


# -- within steps -----------------------------------------------------------------------------

WITHIN = [("double", 0), ("double", 1), ("triple", 0), ("four-bar", 1), ("slider-crank", 1), ("rssr", 1)]


def crossings(found: Case, row: int, level: float) -> list[float]:
    """Times at which a quantity of the true motion passes a level."""

    def off(t: float) -> float:
        return float(found.motion(np.array([t]))[row, 0] - level)

    grid = np.linspace(0.0, found.duration, 2001)
    values = found.motion(grid)[row] - level
    passed = np.flatnonzero(values[:-1] * values[1:] < 0)
    return [float(brentq(off, grid[i], grid[i + 1], xtol=1e-13)) for i in passed]


@pytest.mark.parametrize(("family", "number"), WITHIN)
def test_events_within_steps_are_those_of_the_true_motion(family: str, number: int) -> None:
    """Of every quantity that is compared, where it passes the middle of its range."""
    found = case(family, number)
    values = found.motion(np.linspace(0.0, found.duration, 201))
    moving = [i for i in range(len(found.names)) if np.ptp(values[i]) > 0.05][:6]
    levels = {i: float(np.mean([values[i].min(), values[i].max()])) for i in moving}
    events = [
        fx.Event(found.names[i], lambda s, name=found.names[i], level=level: s[name] - level)  # type: ignore[misc]
        for i, level in levels.items()
    ]
    motion = run(found, found.bad, method="DOP853", rtol=1e-9, atol=1e-9, events=events)
    assert motion.events
    for i, level in levels.items():
        times = [state.t for name, state in motion.events if name == found.names[i]]
        assert times == pytest.approx(crossings(found, i, level), abs=1e-6), found.names[i]
    states = [state for _, state in motion.events]
    true = found.motion(np.array([state.t for state in states]))
    assert np.array([[state[name] for name in found.names] for state in states]).T == pytest.approx(
        true, abs=1e-5
    )


@pytest.mark.parametrize(("family", "number"), WITHIN)
def test_states_between_steps_are_on_the_right_branch(family: str, number: int) -> None:
    """Many samples in each step, and `Motion.at` at times of its own."""
    found = case(family, number)
    system = found.built(found.bad)
    motion = system.simulate(found.duration, method="DOP853", rtol=1e-9, atol=1e-9, samples=301)
    assert found.error(motion) < 1e-4
    times: Array = np.random.default_rng(1).uniform(0, found.duration, 20)
    states = [motion.at(float(t)) for t in times]
    values = np.array([[state[name] for name in found.names] for state in states]).T
    assert values == pytest.approx(found.motion(times), abs=1e-4)


# -- motions that must end --------------------------------------------------------------------


@pytest.mark.parametrize("coordinates", [("P0.y", "P1.x"), ("P0.y", "R1.angle"), ("R0.angle", "P1.x")])
def test_coordinates_that_are_kept_through_their_extreme_are_named(coordinates: tuple[str, str]) -> None:
    """Where the user forbids another choice, the motion ends there; up to there it is right."""
    pendulum = case("double", 0)
    with pytest.raises(fx.FlexelError) as caught:
        pendulum.built(coordinates).simulate(2.0, method="DOP853", rechoose=False)
    assert [name for name in coordinates if name not in str(caught.value)] == []
    assert pendulum.error([state for state in caught.value.motion if state.t <= pendulum.duration]) < 1e-3


@pytest.fixture
def cache(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))


def cut_screw() -> Any:
    """A screw whose angle jumps by a turn where atan2 has its cut; period=0 wrongly says that it stays away from it."""
    p, r, h = Point("p"), Frame("r"), Parameter("h", 1, "m", "advance per radian")
    advance = p.x[0] - h.symbol * 2 * sp.atan2(r.x[1], r.x[0])
    element = Element(
        "cut_screw", (p, r), (h,), (), (Deformation("advance", "m", advance, period=0),), doc="x - h angle"
    )
    return fx.compile_element(element)


@pytest.mark.usefixtures("cache")
def test_a_deformation_that_jumps_ends_the_motion_and_is_named() -> None:
    screw = cut_screw()
    for advance in (0.1, 0.01, 0.001):
        m = fx.Model()
        m.point("P", (0, 0, 0))
        m.fix("P.y", "P.z")
        m.hinge("guide", m.frame("ground", fixed=True), m.frame("R"), axis=(1, 0, 0))
        m.body("nut", "P", "R", mass=3.0, inertia=(0.002, 0.002, 0.002))
        m.element("screw", screw, "P", "R", h=advance)
        m.independent("guide.angle")
        m.initial("guide.angle", rate=20.0)
        with pytest.raises(fx.FlexelError, match=r"screw\.advance") as caught:
            m.build().simulate(1.0, method="DOP853")
        assert "singular" not in str(caught.value)
