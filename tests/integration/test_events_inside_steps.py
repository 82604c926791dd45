"""Events that come and go within one step."""

from typing import Any

import numpy as np
import pytest
from scipy.special import ellipk

import flexel as fx
from flexel.engine.contact_selection import every_gap
from flexel.integration.passed import Passages
from flexel.integration.touching import TouchingContacts
from flexel.model.snapshot import Snapshot

METHODS = ("DOP853", "Radau", "generalized-alpha", "auto")
HEIGHT = 4.0**2 / (2 * 9.81)  # of a throw at 4 m/s [m]


def thrown() -> fx.System:
    """A stone thrown up at 4 m/s."""
    m = fx.Model(gravity=(0, 0, -9.81))
    m.point("P", (0, 0, 0))
    m.point_mass("stone", "P", 0.5)
    m.initial("P.z", rate=4.0)
    return m.build()


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("above", [1e-2, 1e-6])
def test_a_ceiling_that_is_touched_briefly_ends_the_motion(method: str, above: float) -> None:
    """A throw passes HEIGHT - above for the first time at (v - sqrt(2 g above))/g; closed form."""
    ceiling = fx.Event("ceiling", lambda s: s["P.z"] - (HEIGHT - above), terminal=True)
    motion = thrown().simulate(0.9, method=method, events=[ceiling])
    assert "ceiling" in motion.message
    assert motion.t[-1] == pytest.approx((4.0 - np.sqrt(2 * 9.81 * above)) / 9.81, abs=1e-7)


def swinging() -> fx.System:
    """A pendulum of 1 m that starts at 0.5 rad from the vertical."""
    m = fx.Model(gravity=(0, -9.81))
    m.point("O", (0, 0), fixed=True)
    m.point("P", (np.sin(0.5), -np.cos(0.5)))
    m.truss("rod", "O", "P")
    m.point_mass("bob", "P", 1.0)
    return m.build()


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("width", [1e-2, 1e-5])
def test_every_passage_of_a_light_gate_is_seen(method: str, width: float) -> None:
    """A pendulum enters and leaves the gate once in each half of its period; its period is a closed form."""
    period = 2 * np.pi / np.sqrt(9.81) * float(ellipk(np.sin(0.25) ** 2)) / (np.pi / 2)
    gate = fx.Event("gate", lambda s: abs(s["P.x"]) - width / 2)
    motion = swinging().simulate(8.5 * period, method=method, rtol=1e-7, events=[gate])
    times = np.array([s.t for _, s in motion.events])
    assert times.size == 2 * 17
    middles = (times[::2] + times[1::2]) / 2
    assert middles == pytest.approx((np.arange(17) + 0.5) * period / 2, abs=1e-3)


@pytest.mark.parametrize("method", METHODS)
def test_far_from_zero_a_function_is_called_once_a_step(method: str) -> None:
    """Steps of 10 ms in a swing of 2 s: the function changes by less in one than it is away from zero."""
    calls: list[float] = []

    def far(state: fx.State) -> float:
        calls.append(state.t)
        return state["P.x"] - 0.6

    event = fx.Event("far", far)
    motion = swinging().simulate(4.0, method=method, max_step=0.01, samples=2, events=[event])
    assert motion.events == []
    steps = motion.statistics["steps"]
    assert (
        steps >= 400 and len(calls) < steps + 60
    )  # the first steps are looked into, and some steps afterwards


def test_a_gate_that_is_passed_just_after_a_kick_is_seen() -> None:
    """A prescribed point creeps, and passes the gate in the first step in which it is fast; closed form."""
    m = fx.Model(gravity=(0, 0))
    m.point("P", (0, 0))
    m.fix("P.y")
    m.prescribe("P.x", fx.Table([0, 1, 2], [0, 0.01, 100.01], kind="linear"))
    gate = fx.Event("gate", lambda s: abs(s["P.x"] - 2.5) - 0.05)
    motion = m.build().simulate(2.0, samples=41, events=[gate])
    times = [state.t for _, state in motion.events]
    assert times == pytest.approx([1.0244, 1.0254], abs=1e-12)


def above_a_bar(height: float, radius: float) -> fx.System:
    """A ball on a vertical guide above a bar; both have this radius."""
    m = fx.Model(gravity=(0, -9.81))
    m.point("axle", (0, 0), fixed=True)
    m.angle("R", fixed=True)
    m.sheave("bar", "axle", "R", radius=radius)
    m.point("ball", (1e-4, height))
    m.fix("ball.x")
    m.point_mass("mass", "ball", 1.0)
    m.contact("touch", "ball", "bar", fx.Contact(1e9, per="point"), radius=radius)
    return m.build()


@pytest.mark.parametrize("height", np.linspace(0.5, 2.0, 8))
@pytest.mark.parametrize("method", ["generalized-alpha", "DOP853", "Radau", "auto"])
def test_no_ball_falls_through_a_thin_bar(method: str, height: float) -> None:
    """A ball on a vertical guide is thrown back by a bar of 10 mm; a contact cannot be passed."""
    motion = above_a_bar(height, 0.005).simulate(1.0, samples=11, method=method)
    assert motion["ball.y"].min() > 0
    assert motion.rate("ball.y").max() > 1.0  # it has been thrown back


@pytest.mark.parametrize("height", [0.6153846153846154, 0.773, 1.455, 1.591, 1.7692307692307694, 2.0])
@pytest.mark.parametrize("rtol", [1e-3, 1e-4])
@pytest.mark.parametrize("method", ["generalized-alpha", "DOP853", "Radau"])
@pytest.mark.filterwarnings("ignore::flexel.DampingWarning")  # of 1 to 3 %, at these tolerances
def test_nor_through_a_bar_that_is_thinner_than_the_tolerance(
    method: str, rtol: float, height: float
) -> None:
    """A bar of 2 mm under a fall of 2 m: the depth of the contact matters, 0.2 mm, not the size of the model."""
    motion = above_a_bar(height, 0.001).simulate(1.0, samples=11, method=method, rtol=rtol)
    assert motion["ball.y"].min() > 0
    total = motion.energy["total"]
    assert np.abs(total - total[0]).max() < 0.04 * 9.81 * height


def test_a_ball_that_comes_to_rest_behind_a_bar_has_passed_it() -> None:
    """A ball with 200 m/s, braked by 1e5 m/s², stops 0.2 m farther: once in front of the bar, once behind it.

    It touches the bar at x = -0.01 m, where x = -0.1 + 200 t - 5e4 t^2.
    """
    m = fx.Model(gravity=(0, 0))
    m.point("axle", (0, 0), fixed=True)
    m.angle("R", fixed=True)
    m.sheave("bar", "axle", "R", radius=0.005)
    m.point("ball", (-0.1, 0))
    m.point_mass("mass", "ball", 1.0)
    m.contact("touch", "ball", "bar", fx.Contact(1e9, per="point"), radius=0.005)
    m.independent("ball.x", "ball.y")
    system = m.build()
    tables, passages = system.evaluation.tables, Passages(system.evaluation)
    touching = TouchingContacts(tables, every_gap(tables), passages)

    def until(begin: float, speed: float) -> float:
        """Length of a step of 2 ms up to the contact, which begins at this place with this speed; or zero."""
        first, last = (
            Snapshot.of(system.state_at({"ball.x": x, "ball.y": 0.0}, {"ball.x": v, "ball.y": 0.0}, t=t))
            for t, x, v in ((0.0, begin, speed), (2e-3, begin + 0.2, 0.0))
        )
        end = system.evaluation.at(last.t, last.x, last.v, None, np.zeros(0), last.e)
        return touching.until(first, last, end)

    assert until(-0.1, 200.0) == pytest.approx((200 - np.sqrt(4e4 - 2e5 * 0.09)) / 1e5, rel=1e-9)
    assert until(-0.5, 200.0) == 0.0


def towards_a_bar() -> fx.System:
    """A mass on a spring that meets a bar of 4 mm with 6.6 m/s.

    Its 22 J do not compress the bar by 4 mm, for which 0.5*1e8*0.004**2 = 800 J are needed.
    """
    m = fx.Model(gravity=(0, 0))
    m.point("axle", (0, 0), fixed=True)
    m.angle("R", fixed=True)
    m.sheave("bar", "axle", "R", radius=0.002)
    m.point("far", (0, -20), fixed=True)
    m.point("ball", (0, -5))
    m.fix("ball.x")
    m.truss("spring", "far", "ball", stiffness=4.0)
    m.point_mass("mass", "ball", 1.0)
    m.contact("touch", "ball", "bar", fx.Contact(1e8, exponent=1.0, per="point"), radius=0.002)
    m.initial("ball.y", rate=12.0)
    return m.build()


@pytest.mark.parametrize("method", ["DOP853", "Radau", "generalized-alpha"])
@pytest.mark.parametrize("rtol", [1e-3, 1e-6, 1e-9])
def test_a_thin_bar_is_not_passed_in_a_long_step(method: str, rtol: float) -> None:
    """Steps of DOP853 were 2 m long."""
    motion = towards_a_bar().simulate(2.0, samples=21, method=method, rtol=rtol)
    assert motion["ball.y"].max() < 0
    assert motion.rate("ball.y").min() < -11.0
    assert motion.warnings == ()


def test_nor_is_it_by_motions_side_by_side() -> None:
    """To the last bit as alone."""
    system, speeds = towards_a_bar(), np.linspace(11.0, 13.0, 8)
    found = system.simulate_many(
        2.0, initial={"ball.y'": speeds}, samples=21, method="DOP853", outputs=["ball.y"], progress=False
    )
    for i, speed in enumerate(speeds):
        alone = system.simulate(
            2.0, start=system.state_at(rates={"ball.y": speed}), samples=21, method="DOP853", progress=False
        )
        np.testing.assert_array_equal(found["ball.y"][i], alone["ball.y"])
    assert found["ball.y"].max() < 0


@pytest.mark.parametrize("method", ["DOP853", "Radau", "generalized-alpha", "auto"])
def test_a_short_pulse_gives_its_whole_momentum(method: str) -> None:
    """A mass at rest takes up the integral of the force over time, 1 N s; closed form."""
    m = fx.Model(gravity=(0, 0))
    m.point("P", (0, 0))
    m.point_mass("mass", "P", 2.0)
    m.load("P.x", lambda t: np.where((t > 7.0) & (t < 7.01), 100.0, 0.0))
    motion = m.build().simulate(10.0, samples=3, method=method)
    assert motion.rate("P.x")[-1] == pytest.approx(0.5, rel=1e-4)


def level(angle: bool) -> fx.System:
    """Two rods without mass in a row, drawn level, with a mass at each end; the upper one with an angle, or without."""
    m = fx.Model(gravity=(0, -9.81))
    m.point("O", (0, 0), fixed=True)
    m.point("A", (1, 0))
    m.point("B", (2, 0))
    if angle:
        m.angle("turn")
        m.beam("upper", "O", "turn", "A")
        m.independent("turn.angle", "B.y")
    else:
        m.truss("upper", "O", "A")
    m.truss("lower", "A", "B")
    m.point_mass("mass A", "A", 1.0)
    m.point_mass("mass B", "B", 1.0)
    return m.build()


@pytest.mark.parametrize("beyond", [0.0, 1e-9, 1e-3])
def test_an_event_where_the_coordinates_of_the_start_are_singular(beyond: float) -> None:
    """Heights are the degrees of freedom; then the upper rod passes below its pivot, where they are singular.

    The state there is that of a motion in the angle of the rod, and the motion goes on from it.
    """
    rods, by_angle = level(angle=False), level(angle=True)
    assert rods.simulate(0.1, progress=False).dofs == ("A.y", "B.y")
    below = fx.Event("below", lambda state: state["A.x"] - beyond, terminal=True)
    end = rods.simulate(5, events=[below], rtol=1e-9, progress=False)[-1]
    assert abs(end["A.x"] - beyond) < 1e-12
    exact = by_angle.simulate(end.t, rtol=1e-11, progress=False)[-1]
    for name in ("A.x", "A.y", "B.x", "B.y"):
        assert end.acceleration(name) == pytest.approx(exact.acceleration(name), abs=1e-5), name
    assert end.force("lower.elongation") == pytest.approx(exact.force("lower.elongation"), abs=1e-5)
    on = rods.simulate(0.2, start=end, progress=False)[-1]
    there = by_angle.simulate(on.t, rtol=1e-11, progress=False)[-1]
    assert np.allclose(on.position("B"), there.position("B"), rtol=0, atol=1e-5)


@pytest.mark.parametrize("method", ["DOP853", "generalized-alpha"])
def test_a_condition_is_an_event_where_it_begins_or_ceases_to_hold(method: str) -> None:
    """The pendulum passes its lowest point, and comes back: a condition is no number between zero and one."""
    m = fx.Model(gravity=(0, -9.81))
    O, A = m.point("O", (0, 0), fixed=True), m.point("A", (1, 0))
    m.truss("rod", O, A)
    m.point_mass("mass", A, 1.0)
    system = m.build()

    def times(function: Any, direction: int = 0) -> list[float]:
        found = system.simulate(3.0, events=[fx.Event("left", function, direction=direction)], method=method)
        return [state.t for _, state in found.events]

    passages = times(lambda state: state["A.x"])
    assert len(passages) == 3
    assert times(lambda state: state["A.x"] < 0) == pytest.approx(passages, abs=1e-9)
    assert times(lambda state: state["A.x"] < 0, 1) == pytest.approx(passages[::2], abs=1e-9)


def test_a_motion_that_goes_on_from_an_event_has_not_missed_it() -> None:
    """Where it was located, its function may have the sign from before."""
    m = fx.Model(gravity=(0, -9.81))
    m.point_mass("mass", m.point("A", (0, 1)), 1.0)
    system = m.build()
    for height in np.linspace(0.05, 0.95, 19):
        events = [fx.Event("low", lambda s, height=height: s["A.y"] - height, terminal=True)]
        first = system.simulate(2.0, events=events)
        second = system.simulate(1.0, start=first[-1], events=events)
        assert len(first.events) == 1 and not second.events and second.warnings == ()
