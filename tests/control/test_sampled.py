"""Sampled controllers against an independent solution, interval by interval; motions that go on keep what was held."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from controlled import Array, carriage, held_response, lagging, spring_law

import flexel as fx

START = np.array([0.5, 0.3])
METHODS: dict[str, tuple[dict[str, Any], float]] = {  # options, and the largest difference
    "DOP853": ({}, 1e-12),
    "Radau": ({}, 1e-12),
    "generalized-alpha": ({"rtol": 1e-9}, 1e-9),
}
DELAYS = [0.0, 0.02, 0.05, 0.12]  # none, part of the period of 0.05 s, all of it, more than two


def controlled(**options: Any) -> fx.System:
    """The carriage with the proportional-derivative controller."""
    m = carriage()
    given: dict[str, Any] = {"inputs": ["A.x", "A.x'"], "outputs": ["A.x"], "name": "c", "period": 0.05}
    m.controller(**{"function": spring_law, **given, **options})
    return m.build()


def moving(s: fx.System) -> fx.State:
    return s.state_at(rates={"A.x": START[1]})


@pytest.mark.parametrize("delay", DELAYS)
@pytest.mark.parametrize("method", METHODS)
def test_every_method_meets_the_matrix_exponential(method: str, delay: float) -> None:
    options, tolerance = METHODS[method]
    s = controlled(delay=delay)
    t, x, u = held_response(lambda t, y: float(spring_law(t, y)), 0.05, delay, 1.5, START)
    motion = s.simulate(1.5, start=moving(s), times=t, method=method, **options)
    assert np.abs(motion["A.x"] - x[:, 0]).max() < tolerance
    assert np.abs(motion["A.x'"] - x[:, 1]).max() < 10 * tolerance
    assert motion["c.u"] == pytest.approx(u, abs=1e3 * tolerance)  # just before the instants
    assert motion.unit("c.u") == "N"


def test_between_the_instants_the_output_is_held_and_the_motion_is_a_parabola() -> None:
    s = controlled()
    t = np.linspace(0, 0.2, 81)
    motion = s.simulate(0.2, start=moving(s), times=t)
    k = np.ceil(t / 0.05 - 1e-9).astype(int) - 1
    first = np.array([motion["c.u"][k == i] for i in range(4)])
    assert np.all(first == first[:, :1]) and np.all(np.diff(first[:, 0]) != 0)
    assert motion.at(0.07)["c.u"] == motion.at(0.09)["c.u"] == motion["c.u"][30]
    assert motion["A.x''"][1:] == pytest.approx(motion["c.u"][1:] / 2, rel=1e-12)


def test_an_own_state_takes_the_place_of_a_rate() -> None:
    """The state is the last position: an independent loop keeps it in a variable."""
    s = controlled(function=lagging, inputs=["A.x"], state=[0.5])
    last = [0.5]

    def law(t: float, y: Array) -> float:
        u, (after,) = lagging(t, y[:1], np.array(last))
        last[:] = [after]
        return float(u)

    t, x, _ = held_response(law, 0.05, 0.0, 1.5, START)
    motion = s.simulate(1.5, start=moving(s), times=t)
    assert np.abs(motion["A.x"] - x[:, 0]).max() < 1e-12
    assert motion["c.x0"][2:] == pytest.approx(x[1:-1, 0], rel=1e-12)


@pytest.mark.parametrize("method", ["DOP853", "generalized-alpha"])
def test_saturation_meets_the_independent_solution(method: str) -> None:
    s = controlled(limits=(-3.0, 2.0), delay=0.02)
    t, x, u = held_response(lambda t, y: float(np.clip(spring_law(t, y), -3.0, 2.0)), 0.05, 0.02, 2.0, START)
    motion = s.simulate(2.0, start=moving(s), times=t, method=method)
    assert {-3.0, 2.0} < set(u.tolist())
    assert np.abs(motion["A.x"] - x[:, 0]).max() < 1e-9
    assert motion["c.u"] == pytest.approx(u, abs=1e-7)


@pytest.mark.parametrize("delay", DELAYS)
def test_a_motion_goes_on_from_any_of_its_states(delay: float, tmp_path: Path) -> None:
    """The end of a motion holds the outputs, those on their way and the own state; a file and another system too."""
    s = controlled(function=lagging, inputs=["A.x"], state=[0.5], delay=delay)
    whole = s.simulate(1.0, start=moving(s), times=np.arange(21) * 0.05)
    for k in (1, 6, 7, 13):
        rest = s.simulate(1.0 - 0.05 * k, start=whole[k], times=whole.t[k:])
        assert rest["A.x"] == pytest.approx(whole["A.x"][k:], abs=1e-12)
    saved = fx.load(s.simulate(0.33, start=moving(s)).save(tmp_path / "part.npz"))
    other = controlled(function=lagging, inputs=["A.x"], state=[0.5], delay=delay)
    rest = other.simulate(0.67, start=other.restore(saved), times=whole.t[7:])
    assert rest["A.x"] == pytest.approx(whole["A.x"][7:], abs=1e-9)
    assert rest["c.u"] == pytest.approx(whole["c.u"][7:], abs=1e-7)


def test_a_stepper_with_a_loop_by_hand_is_the_same() -> None:
    """Inputs that are set step by step; and a stepper of the controlled system, saved and restored on its way."""
    s = controlled()
    motion = s.simulate(1.0, start=moving(s), times=np.arange(21) * 0.05, rtol=1e-9)
    free = carriage().build()
    by_hand = free.stepper(0.05, inputs=["A.x"], outputs=["A.x", "A.x'"], start=moving(free), rtol=1e-9)
    y, found = by_hand.reset(), []
    for _ in range(20):
        y = by_hand.step([float(spring_law(0.0, y))])
        found.append(y[0])
    assert motion["A.x"][1:] == pytest.approx(np.array(found), abs=1e-12)

    s = controlled(function=lagging, inputs=["A.x"], state=[0.5], delay=0.12)
    whole = s.simulate(1.0, start=moving(s), times=np.arange(41) * 0.025)
    stepper = s.stepper(0.025, outputs=["A.x", "c.u"], start=moving(s), rtol=1e-9)
    for i in range(40):
        if i in (7, 12):
            saved = stepper.save()
            for _ in range(3):
                stepper.step()
            stepper.restore(saved)
        x, u = stepper.step()
        assert x == pytest.approx(whole["A.x"][i + 1], abs=1e-10)
        assert u == pytest.approx(whole["c.u"][i + 1], abs=1e-8)


def test_events_and_checkpoints_keep_the_controller(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from flexel.results.analyses import checkpoints

    s = controlled(function=lagging, inputs=["A.x"], state=[0.5], delay=0.12)
    t = np.arange(41) * 0.025
    whole = s.simulate(1.0, start=moving(s), times=t)
    there = fx.Event("there", lambda state: state["A.x"] - 0.35, terminal=True)
    first = s.simulate(1.0, start=moving(s), times=t, events=[there])
    stop = first[-1].t
    assert 0 < stop < 0.9 and first[-1]["A.x"] == pytest.approx(0.35, abs=1e-9)
    rest = s.simulate(1.0 - stop, start=first[-1], times=t[t > stop])
    assert rest["A.x"] == pytest.approx(whole["A.x"][t > stop], abs=1e-9)

    monkeypatch.setattr(checkpoints, "CHECKPOINT_INTERVAL_S", 0.0)
    count = []

    def breaking(t: float, y: Array, x: Array) -> tuple[Any, Any]:
        count.append(t)
        if len(count) == 9:
            raise KeyboardInterrupt
        return lagging(t, y, x)

    options: dict[str, Any] = {"inputs": ["A.x"], "state": [0.5], "delay": 0.12}
    broken = controlled(function=breaking, **options)
    with pytest.raises(fx.Interrupted) as caught:
        broken.simulate(1.0, start=moving(broken), times=t, checkpoint=tmp_path / "c.npz")
    part = caught.value.motion
    assert "interrupted" in part.message and part.t[-1] == pytest.approx(0.4)
    on = broken.simulate(1.0, start=moving(broken), times=t, checkpoint=tmp_path / "c.npz")
    assert "continued" in on.message
    assert on["A.x"] == pytest.approx(whole["A.x"], abs=1e-9)
    assert on["c.u"] == pytest.approx(whole["c.u"], abs=1e-7)
    other = controlled(function=lagging, inputs=["A.x"], state=[0.5], delay=0.1)
    with pytest.raises(fx.ModelError, match="belongs to another simulation"):
        other.simulate(1.0, start=moving(other), times=t, checkpoint=tmp_path / "c.npz")


def test_controllers_of_two_periods_measure_before_both_change() -> None:
    """The second one measures the output of the first one, as it was before their common instants."""
    m = carriage()
    m.point("B", (0, 1))
    m.fix("B.y")
    m.point_mass("other", "B", 1.0)
    m.independent("B.x")
    m.controller(spring_law, inputs=["A.x", "A.x'"], outputs=["A.x"], name="fast", period=0.05)
    m.controller(lambda t, y: 10 * y[0], inputs=["fast.u"], outputs=["B.x"], name="slow", period=0.1)
    s = m.build()
    motion = s.simulate(0.5, start=s.state_at(rates={"A.x": 0.3}), times=np.arange(11) * 0.05)
    fast, slow = motion["fast.u"], motion["slow.u"]
    assert slow[1] == 0.0 and np.array_equal(slow[3::2], 10 * fast[2:-1:2])


def test_stored_times_next_to_an_instant_count_as_it() -> None:
    """A time that differs by rounding is the instant itself: what goes on from there is not sampled twice."""
    s = controlled(function=lagging, inputs=["A.x"], state=[0.5])
    near = 0.3 + 4e-16
    assert near != 6 * 0.05
    whole = s.simulate(1.0, start=moving(s), times=[0.0, near, 1.0])
    rest = s.simulate(1.0 - near, start=whole[1], times=[1.0])
    assert rest["A.x"][-1] == pytest.approx(whole["A.x"][-1], abs=1e-12)
    part = s.simulate(near, start=moving(s), samples=2)
    assert part[-1]["c.u"] == pytest.approx(whole[1]["c.u"], abs=1e-12)
