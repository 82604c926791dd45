"""Variants that go abreast in lanes: to the bit what each of them does alone, also where one leaves its lane."""

from collections import Counter
from collections.abc import Callable

import mechanisms
import moving
import numpy as np
import pytest
from coarse import COARSE_MESH

import flexel as fx
from flexel.examples import bicycle_data as data
from flexel.examples.bicycle import bicycle, rolling
from flexel.integration.imbalance import Imbalance
from flexel.integration.lane_motions import STOPPED, LaneMotions
from flexel.integration.minimal import MinimalRun
from flexel.results.analyses import variant_lanes as motions


@pytest.fixture
def seen(monkeypatch: pytest.MonkeyPatch) -> Counter[str]:
    """How often a motion enters a lane, and how often a lane stops before an unusual step."""
    found: Counter[str] = Counter()
    enter, look = LaneMotions.enter, LaneMotions.look

    def entered(self: LaneMotions, *given: object) -> None:
        found["entered"] += 1
        enter(self, *given)  # type: ignore[arg-type]

    def looked(self: LaneMotions, lane: int) -> bool:
        found["stopped"] += int(self._lanes.doing[lane] == STOPPED)
        return look(self, lane)

    monkeypatch.setattr(LaneMotions, "enter", entered)
    monkeypatch.setattr(LaneMotions, "look", looked)
    return found


def compare(found: fx.Ensemble) -> None:
    """Every variant has the digits, the counts and the message that it has alone."""
    for i in range(len(found)):
        if i in found.failed:
            with pytest.raises(fx.FlexelError) as alone:
                found.motion(i)
            assert found.failed[i] == str(alone.value)
            continue
        motion = found.motion(i)
        for name in found.names:
            assert np.array_equal(found[name][i], motion[name]), (i, name)
        assert found.statistics[i] == motion.statistics


def heavier(system: fx.System, name: str, count: int = 10) -> dict[str, np.ndarray]:
    return {name: float(system.parameters[name][0]) * np.linspace(1.0, 3.0, count)}


# What stays in its lane, and what takes steps alone: near extremes of degrees of freedom, with other ones, where pivots
# are no longer sound. With kinematic coordinates, laws, loads, contacts, and a mass matrix that varies.
CASES: dict[str, tuple[Callable[[], fx.Model | fx.System], str, bool]] = {
    "pendulum": (mechanisms.pendulum, "rod.rhoA", False),
    "top": (mechanisms.heavy_top, "body.mass", True),
    "disc": (lambda: mechanisms.disc(1.2, (0.3, 1.0, 5.0)), "disc.mass", True),
    "double_pendulum": (moving.double_pendulum, "rod.rhoA", False),
    "flexible_arm": (moving.flexible_arm, "arm.rhoA", False),
    "tumbling": (moving.tumbling, "body.mass", True),
    "planar": (moving.planar, "link.rhoA", True),
    "touching": (moving.touching, "top.mass", False),
    "loop": (moving.loop, "crank bar.rhoA", True),
}


@pytest.fixture
def balances(monkeypatch: pytest.MonkeyPatch) -> list[Imbalance]:
    """The energy balance of each motion that has ended."""
    found: list[Imbalance] = []
    own = MinimalRun.imbalance

    def noted(self: MinimalRun) -> Imbalance:
        found.append(own(self))
        return found[-1]

    monkeypatch.setattr(MinimalRun, "imbalance", noted)
    return found


@COARSE_MESH
@pytest.mark.parametrize("name", CASES)
def test_lanes_have_the_digits_of_variants_alone(
    name: str, seen: Counter[str], balances: list[Imbalance]
) -> None:
    model, parameter, stops = CASES[name]
    built = model()
    s = built if isinstance(built, fx.System) else built.build()
    q = s.dynamic[0]
    found = s.simulate_many(
        1.0,
        parameters=heavier(s, parameter),
        initial={f"{q}'": np.linspace(0.3, 3.0, 10)},
        outputs=[*s.dynamic, f"{q}'", f"{q}''"],
        samples=5,
        method="DOP853",
        threads=1,
    )
    assert not found.failed and seen["entered"] >= 10
    assert not stops or seen["stopped"] > 0
    assert len({run["steps"] for run in found.statistics}) > 1
    abreast = balances.copy()
    balances.clear()
    compare(found)
    assert len(abreast) == 10 and all(0 < balance.moved < np.inf and not balance.fails for balance in abreast)
    assert set(balances) == set(abreast)


def test_pivots_that_are_not_sound_are_ordered_anew_alone(seen: Counter[str]) -> None:
    s = bicycle()
    found = s.simulate_many(
        5.0,
        parameters={"frame and rider.mass": np.linspace(85.0, 115.0, 12)},
        start=rolling(s, data.M1_SPEED, data.ROLL_RATE),
        outputs=["steer.angle", "lean.angle''"],
        samples=3,
        method="DOP853",
        rtol=1e-7,
        atol=1e-9,
        threads=1,
    )
    assert seen["stopped"] > 0 and abs(found["steer.angle"][0, -1] - data.M1_STEER_5S) < 1e-6
    compare(found)


@pytest.mark.parametrize("threads", [1, 2, 3])
def test_failed_variants_are_kept_apart_in_any_number_of_threads(threads: int, seen: Counter[str]) -> None:
    """The lane of a variant that fails goes on with another one, whose digits do not change."""
    s = mechanisms.pendulum()
    masses, rates = np.linspace(1.0, 2.0, 21), np.linspace(-3.0, 3.0, 21)
    masses[[2, 3, 13]] = -1.0
    with pytest.warns(fx.IncompleteWarning, match="3 of 21"):
        found = s.simulate_many(
            1.0, parameters={"rod.rhoA": masses}, initial={"pivot.angle'": rates}, threads=threads, samples=4
        )
    assert sorted(found.failed) == [2, 3, 13] and "negative mass" in found.failed[13]
    assert seen["entered"] == 18 + seen["stopped"] and np.isnan(found["pivot.angle"][3]).all()
    compare(found)


def test_motions_that_depend_on_time_go_alone(seen: Counter[str]) -> None:
    """Loads that change and prescribed motions are evaluated by Python; Radau has no lanes."""
    m = fx.Model()
    m.point("A", (0, 0))
    m.point_mass("bob", "A", 1.0)
    m.spring("A.x", 3.0)
    m.load("A", (fx.Harmonic(1.0, 2.0), 0.0))
    m.independent("A.x", "A.y")
    s = m.build()
    for method in ("DOP853", "Radau"):
        found = s.simulate_many(
            0.5, parameters={"bob.mass": [1.0, 2.0, 3.0]}, samples=3, method=method, threads=1
        )
        compare(found)
    assert not seen


def test_an_interrupt_keeps_the_motions_that_are_done(monkeypatch: pytest.MonkeyPatch) -> None:
    begin = motions._Slots.begin

    def interrupted(self: motions._Slots, lane: int, i: int) -> bool:
        if i == 12:
            raise KeyboardInterrupt
        return begin(self, lane, i)

    monkeypatch.setattr(motions._Slots, "begin", interrupted)
    s = mechanisms.pendulum()
    with pytest.warns(fx.IncompleteWarning, match="of 14 .*interrupted"):
        found = s.simulate_many(1.0, parameters=heavier(s, "rod.rhoA", 14), threads=1, samples=3)
    done = [i for i in range(14) if i not in found.failed]
    assert 1 <= len(done) <= 11 and all("interrupted" in message for message in found.failed.values())
    assert np.isfinite(found["pivot.angle"][done]).all()


def test_a_motion_in_a_lane_warns_of_what_it_warns_alone(seen: Counter[str]) -> None:
    """A vibration of 10 nm in a model of 1 m, from rest: coordinates are rounded to 2e-7 of a step."""
    m = fx.Model()
    O, A = m.point("O", (0, 0), fixed=True), m.point("A", (1, 0))
    m.fix("A.y")
    m.truss("spring", O, A, stiffness=1.0)
    m.point_mass("mass", A, 1.0)
    m.initial("spring.elongation", 1e-8)
    system, masses = m.build(), np.linspace(1.0, 1.2, 8)
    with pytest.warns(fx.AuditWarning, match="small beside the model"):
        system.simulate(1.0, method="DOP853", samples=5)
    with pytest.warns(fx.AuditWarning, match="8 of 8 variants, number 0 first: .* small beside the model"):
        system.simulate_many(
            1.0, parameters={"mass.mass": masses}, outputs=["A.x"], method="DOP853", samples=5, threads=1
        )
    assert seen["entered"] == 8
