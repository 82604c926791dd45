"""Generalized-alpha between the ends of its steps: events, states at any time, forces that no short step disturbs."""

import copy
import pickle

import numpy as np
import pytest

import flexel as fx
from flexel.base.arrays import Array
from flexel.integration import replay

METHOD = "generalized-alpha"
OPTIONS: list[dict[str, float]] = [{"rtol": 1e-7}, {"step": 2e-3}]


def pendulum() -> fx.System:
    """A rigid pendulum of 1 m and 1 kg that is released when it is level."""
    m = fx.Model(gravity=(0, 0, -9.81))
    m.point("A", (0, 0, 0), fixed=True)
    m.point("B", (1, 0, 0))
    m.fix("B.y")
    m.truss("rod", "A", "B")
    m.rigid("rod.elongation")
    m.point_mass("bob", "B", 1.0)
    return m.build()


def exact(system: fx.System) -> fx.Motion:
    return system.simulate(3.0, method="DOP853", rtol=1e-12, atol=1e-13, samples=2)


def steps_of(motion: fx.Motion) -> replay.Replay:
    (stretch,) = motion._segments
    assert isinstance(stretch, replay.Replayed)
    return stretch.replay


EVENTS = [
    fx.Event("lowest", lambda s: s["B.x"]),
    fx.Event("fast", lambda s: s.rate("B.z") + 2.0),
    fx.Event("loaded", lambda s: s.force("rod.elongation") - 20.0),
]


@pytest.mark.parametrize("options", OPTIONS)
def test_events_are_those_of_dop853(options: dict[str, float]) -> None:
    """Reference: DOP853 at 1e-12; the times differ by what the method is off by."""
    system = pendulum()
    right = system.simulate(3.0, method="DOP853", rtol=1e-12, atol=1e-13, events=EVENTS).events
    found = system.simulate(3.0, method=METHOD, events=EVENTS, **options).events
    assert [name for name, _ in found] == [name for name, _ in right]
    late = [one.t - other.t for (_, one), (_, other) in zip(found, right, strict=True)]
    assert np.abs(late).max() < 3e-4


@pytest.mark.parametrize("options", OPTIONS)
def test_a_terminal_event_ends_the_motion_and_another_goes_on_from_there(options: dict[str, float]) -> None:
    system = pendulum()
    low = fx.Event("low", lambda s: s["B.x"], terminal=True)
    first = system.simulate(3.0, method=METHOD, events=[low], **options)
    right = exact(system)
    assert first.message.startswith("stopped by event 'low'")
    end = first[-1]
    assert abs(end["B.x"]) < 1e-12 and first.t[-1] == end.t and end.t < 0.6
    assert end.force("rod.elongation") == pytest.approx(right.at(end.t).force("rod.elongation"), abs=0.02)
    rest = system.simulate(2.0, start=end, method=METHOD, events=[low], **options)
    assert rest.t[-1] == pytest.approx(1.775882, abs=3e-4)  # a motion from an event does not meet it again
    balance = first.energy_balance()
    assert len(balance["error"]) == len(first) and np.abs(balance["error"]).max() < 5e-3


@pytest.mark.parametrize("options", OPTIONS)
def test_forces_within_a_step_are_as_exact_as_at_its_ends(options: dict[str, float]) -> None:
    """A shorter step alone would disturb them, by 5 N of 20 at a hundredth of a step of 2 ms."""
    system = pendulum()
    right, motion = exact(system), system.simulate(3.0, method=METHOD, samples=7, **options)
    ends = np.array(steps_of(motion)._ends)
    starts, lengths = ends[5:-1:97], np.diff(ends)[5::97]

    def off(part: float) -> float:
        found = [motion.at(t) for t in starts + part * lengths]
        return max(abs(s.force("rod.elongation") - right.at(s.t).force("rod.elongation")) for s in found)

    at_ends = max(off(0.0), off(1.0))
    assert at_ends < 0.2
    assert all(off(part) < 1.5 * at_ends for part in (1e-3, 0.01, 0.1, 0.5, 0.9))


def test_stored_forces_between_constant_steps_are_as_exact_as_at_their_ends() -> None:
    """Times just after the ends of steps: forces were off by a quarter of the weight there."""
    system = pendulum()
    times = np.append(np.linspace(0.1, 2.9, 29) + 2e-5, 3.0)
    motion = system.simulate(3.0, method=METHOD, step=2e-3, times=times)
    right = exact(system)
    forces = [right.at(t).force("rod.elongation") for t in times]
    np.testing.assert_allclose(motion.force("rod.elongation"), forces, rtol=0, atol=0.01)


def driven() -> fx.System:
    """A mass on a spring whose foot is kicked, under a load that jumps."""
    m = fx.Model(gravity=(0, 0))
    m.point("foot", (0, 0))
    m.point("mass", (1, 0))
    m.fix("foot.y", "mass.y")
    m.prescribe("foot.x", fx.Table([0, 1, 2, 4], [0, 0, 0.5, 0.5], kind="linear"))
    m.truss("spring", "foot", "mass", stiffness=100.0, damping=0.5)
    m.point_mass("block", "mass", 1.0)
    m.load("mass.x", fx.Table([0, 0.5, 3], [0, 5, -5], kind="step"))
    return m.build()


@pytest.mark.parametrize("options", OPTIONS)
def test_states_at_any_time_also_around_jumps(options: dict[str, float]) -> None:
    """At random times, in any order; reference: DOP853 at its defaults."""
    system = driven()
    motion, right = (
        system.simulate(4.0, method=METHOD, samples=5, **options),
        system.simulate(4.0, method="DOP853"),
    )
    assert motion.dense
    times = np.random.default_rng(4).uniform(0, 4, 40)
    for t in (*times, 0.0, 0.5, 1.0, 2.0, 4.0):
        found, wanted = motion.at(t), right.at(t)
        assert found.t == t
        assert found["mass.x"] == pytest.approx(wanted["mass.x"], abs=2e-4)
        assert found.rate("mass.x") == pytest.approx(wanted.rate("mass.x"), abs=3e-3)


@pytest.mark.parametrize("options", OPTIONS)
def test_states_at_any_time_also_beyond_knots_where_nothing_jumps(options: dict[str, float]) -> None:
    """A base that is moved by a cubic table, in many more pieces than there are points; reference: DOP853."""
    m = fx.Model(gravity=(0, 0))
    m.point("foot", (0, 0))
    m.point("mass", (1, 0))
    m.fix("foot.y", "mass.y")
    m.prescribe("foot.x", fx.Table(t := np.linspace(0, 2, 81), 0.1 * np.sin(3 * t)))
    m.truss("spring", "foot", "mass", stiffness=100.0)
    m.point_mass("block", "mass", 1.0)
    system = m.build()
    motion, right = (
        system.simulate(2.0, samples=3, method=METHOD, **options),
        system.simulate(2.0, samples=3, method="DOP853"),
    )
    for t in np.random.default_rng(6).uniform(0, 2, 40):
        assert motion.at(t)["foot.x"] == pytest.approx(right.at(t)["foot.x"], abs=1e-12)
        assert motion.at(t)["mass.x"] == pytest.approx(right.at(t)["mass.x"], abs=2e-4)


def test_a_copy_and_a_pickle_give_the_same_states() -> None:
    motion = driven().simulate(2.5, method=METHOD, samples=3)
    wanted = [motion.at(t)["mass.x"] for t in (2.2, 0.3, 1.3)]
    for other in (copy.deepcopy(motion), pickle.loads(pickle.dumps(motion))):
        assert [other.at(t)["mass.x"] for t in (2.2, 0.3, 1.3)] == pytest.approx(wanted, abs=1e-10)


def test_few_points_are_kept() -> None:
    motion = driven().simulate(4.0, method=METHOD, step=1e-3, samples=2)
    steps = steps_of(motion)
    assert steps.number == 4000 and len(steps._points) <= 4000 / replay.SPACING + 10


@pytest.mark.parametrize("options", OPTIONS)
def test_states_between_the_instants_of_a_sampled_controller(options: dict[str, float]) -> None:
    """Its force is constant between its instants: a parabola from each to the next; reference: DOP853."""
    m = fx.Model(gravity=(0, 0))
    m.point("P", (1, 0))
    m.fix("P.y")
    m.point_mass("block", "P", 1.0)

    def law(t: float, y: Array) -> Array:
        return np.array([-4.0 * y[0] - y[1]])

    m.controller(function=law, inputs=["P.x", "P.x'"], outputs=["P.x"], name="c", period=0.1)
    system = m.build()
    motion, right = (
        system.simulate(2.0, method=METHOD, samples=2, **options),
        system.simulate(2.0, method="DOP853"),
    )
    for t in np.linspace(0.03, 1.97, 23):
        assert motion.at(t)["P.x"] == pytest.approx(right.at(t)["P.x"], abs=2e-4)
