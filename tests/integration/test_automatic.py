"""The method that `simulate` chooses by itself: implicit where what is fast does not move, or where that is cheap."""

from typing import Any

import numpy as np
import pytest
import sympy as sp

import flexel as fx
from flexel.integration.choose import automatic
from flexel.integration.methods import Options, tolerances_of
from flexel.integration.minimal import MinimalRun
from flexel.integration.step_method import StepMethod


def chosen(system: fx.System, duration: float) -> tuple[str, str]:
    """The method for a motion from the start, and why."""
    start = system.initial
    times = np.array([start.t, start.t + duration])

    def prepared(options: Options, kind: type[StepMethod]) -> MinimalRun:
        return MinimalRun(system, start, times, tolerances_of(system, options), (), True, kind)

    return automatic(system, start, duration, Options(), prepared)[:2]


def pendulum(angle: float = 0.3) -> fx.System:
    """A mass on a rigid rod of 1 m, released at an angle from the vertical [rad]."""
    m = fx.Model(gravity=(0, -9.81))
    O, A = m.point("O", (0, 0), fixed=True), m.point("A", (np.sin(angle), -np.cos(angle)))
    m.truss("rod", O, A)
    m.point_mass("mass", A, 1.0)
    return m.build()


def masses(
    stiffness: float, rates: tuple[float, float] = (1.0, 1.0), law: Any = None, load: Any = 0.0
) -> fx.System:
    """Two masses of 1 kg in a row on springs of 1 N/m and of the given stiffness [N/m], with rates [m/s]."""
    m = fx.Model()
    O, A, B = m.point("O", (0, 0), fixed=True), m.point("A", (1, 0)), m.point("B", (1.5, 0))
    m.fix("A.y", "B.y")
    m.truss("soft", O, A, stiffness=1.0)
    m.truss("hard", A, B, stiffness=stiffness)
    for name, point, rate in zip(("a", "b"), (A, B), rates, strict=True):
        m.point_mass(name, point, 1.0)
        m.initial(f"{point.name}.x", rate=rate)
    if law:
        m.law("soft.elongation", law)
    m.load("B.x", load)
    return m.build()


def test_a_motion_that_is_only_long_is_not_stiff() -> None:
    """A pendulum of about 3 rad/s for 12 000 s: every method must follow its 35 000 radians."""
    method, why = chosen(pendulum(), 12000.0)
    assert method == "DOP853"
    assert why.endswith(
        "max|eigenvalue|*duration = 3.5e+04 at t = 0 s, and excited modes turn through 3.5e+04 rad, not 100 times less"
    )


def test_a_small_vibration_that_is_all_that_moves_is_not_stiff() -> None:
    """0.1 µm at 1e4 rad/s, in a machine of 1 m."""
    m = fx.Model()
    O, P = m.point("O", (0, 0), fixed=True), m.point("P", (1, 0))
    m.fix("P.y")
    m.truss("spring", O, P, stiffness=1e8)
    m.point_mass("mass", P, 1.0)
    m.initial("P.x", rate=1e-3)
    assert chosen(m.build(), 20.0)[0] == "DOP853"


@pytest.mark.parametrize(
    ("rates", "method"),
    [((1.0, 1.0), "Radau"), ((1.0, 1.000001), "Radau"), ((1.0, -1.0), "DOP853")],
)
def test_a_motion_is_stiff_if_what_is_fast_rests(rates: tuple[float, float], method: str) -> None:
    """Masses that move together, with a vibration of 3e-11 of their motion, and against one another at 1.4e4 rad/s."""
    # Against one another: an amplitude of 7e-5 m beside no other motion.
    assert chosen(masses(1e8, rates), 4.0)[0] == method
    assert chosen(masses(1e8, rates), 0.01)[0] == "DOP853"


def test_a_stiff_motion_is_right() -> None:
    """Both masses on the soft spring: x = sin(ω t) / ω with ω² = 1/2; the hard one may change the period by 3e-9."""
    motion = masses(1e8).simulate(4.0, samples=5)
    assert (
        "Radau, chosen because it takes fewer evaluations than DOP853 at rtol = 1e-09; "
        "max|eigenvalue|*duration = 5.7e+04 at " in motion.message
    )
    omega = np.sqrt(0.5)
    np.testing.assert_allclose(motion["A.x"], 1 + np.sin(omega * motion.t) / omega, atol=1e-8)


def test_a_vibration_that_is_small_beside_the_motion_is_not_followed() -> None:
    """5e-7 of the rates at 1.4e4 rad/s, for 5.7e4 radians: the rates miss it, the positions miss 4e-11 m."""
    motion = masses(1e8, (1.0, 1.000001)).simulate(4.0, samples=9)
    assert motion.message.startswith(
        "reached the end (Radau, chosen because it takes fewer evaluations than DOP853"
    )
    assert motion.statistics["evaluations"] < 40_000  # DOP853: 700 000
    omega, rate = np.sqrt(0.5), 1.0000005  # of both masses on the soft spring
    np.testing.assert_allclose(motion["A.x"], 1 + rate * np.sin(omega * motion.t) / omega, atol=2e-8)
    np.testing.assert_allclose(motion["A.x'"], rate * np.cos(omega * motion.t), atol=1e-6)


def test_laws_that_call_functions_are_tried_as_others_are() -> None:
    """A function keeps nothing from call to call, so it may be called for times that are not those of the motion."""
    m = fx.Model()
    A, B = m.point("A", (1, 0)), m.point("B", (1.5, 0))
    m.fix("A.y", "B.y")
    m.truss("hard", A, B, stiffness=1e8)
    for point in (A, B):
        m.point_mass(f"mass {point.name}", point, 1.0)
        m.initial(f"{point.name}.x", rate=1.0)
    m.controller(function=lambda _, y: -0.5 * y[0], inputs=["A.x'"], outputs=["A.x"], name="c")
    system = m.build()
    assert chosen(system, 10.0)[0] == "Radau" and chosen(system, 0.1)[0] == "DOP853"
    motion = system.simulate(10.0, samples=5)
    np.testing.assert_allclose(motion["A.x'"], np.exp(-0.25 * motion.t), atol=1e-6)


def test_an_unstable_mode_at_rest_counts_as_moving() -> None:
    """A needle upright on its tip rests, but any disturbance grows by 3.1 1/s."""
    m = fx.Model(gravity=(0, -9.81))
    O, A = m.point("O", (0, 0), fixed=True), m.point("A", (0, 1))
    m.truss("needle", O, A)
    m.point_mass("mass", A, 1.0)
    assert chosen(m.build(), 20000.0)[0] == "DOP853"


def test_knots_of_tables_are_steps_of_every_method() -> None:
    """A load with 1600 knots in 4 s, at which Radau takes 35 000 evaluations and DOP853 at least ten times as many."""
    t = np.linspace(0, 4, 1601)
    road = fx.Table(t, np.sin(t), kind="linear")
    assert chosen(masses(1e8, load=road), 4.0)[0] == "Radau"
    assert chosen(masses(1e8), 4.0)[0] == "Radau"


@pytest.mark.long
def test_large_models_count_as_stiff_earlier() -> None:
    """A steel wire of 1 m with 180 degrees of freedom that starts to sag, beside one with 15; all of it vibrates."""

    def wire(count: int) -> fx.System:
        m = fx.Model(gravity=(0, 0, -9.81))
        last = m.point("O", (0, 0, 0), fixed=True)
        for i in range(count):
            point = m.point(f"P{i}", ((i + 1) / count, 0, 0))
            m.truss(f"t{i}", last, point, stiffness=3e4)
            m.point_mass(f"m{i}", point, 1.0 / count)
            last = point
        return m.build()

    def long(system: fx.System) -> float:
        """The duration in which the fastest mode turns by 1e4 rad."""
        return 1e4 / float(
            np.abs(np.linalg.eigvals(system._linearization(system.initial).state_matrix)).max()
        )

    small, large = wire(5), wire(60)
    assert chosen(small, long(small))[0] == "DOP853"
    method, why = chosen(large, long(large))
    assert method == "DOP853" and why.endswith("above 5e+03; Radau would not take fewer evaluations")


def orifice(e: Any, ed: Any) -> Any:
    """A force with the root of the rate: its slope at rest is infinite."""
    return sp.sign(ed) * sp.sqrt(sp.Abs(ed))


@pytest.mark.parametrize(("stiffness", "method"), [(1e8, "Radau"), (100.0, "DOP853")])
def test_a_start_that_cannot_be_linearized_is_judged_a_little_later(stiffness: float, method: str) -> None:
    system = masses(stiffness, (0.0, 0.0), orifice, 1.0)
    with pytest.raises(fx.FlexelError):
        system.linearize(system.initial)
    assert chosen(system, 20.0)[0] == method


@pytest.mark.parametrize(
    ("rates", "duration", "method", "most"),
    [((1.0, 1.0), 4.0, "Radau", 90), ((1.0, 0.9), 0.1, "DOP853", 400)],
)
def test_what_was_tried_goes_on(
    rates: tuple[float, float], duration: float, method: str, most: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The motion is that of the method that is chosen, to the last digit, and no step of it is taken twice."""
    calls: list[float] = []
    forward = MinimalRun.forward

    def counted(self: MinimalRun, most: int = 1) -> str | None:
        before, found = self.taken, forward(self, most)
        calls.append(self.taken - before)
        return found

    monkeypatch.setattr(MinimalRun, "forward", counted)
    system = masses(1e8, rates)
    motion = system.simulate(duration, samples=11)
    assert f"({method}, chosen because" in motion.message
    assert 30 <= sum(calls) - motion.statistics["steps"] <= most
    plain = system.simulate(duration, method=method, samples=11)
    assert motion.statistics == plain.statistics
    assert np.array_equal(motion.x, plain.x) and np.array_equal(motion.v, plain.v)


def test_an_event_may_end_the_motion_while_it_is_tried() -> None:
    """The masses move together for 2e-4 s: a tenth of a step of Radau in the long run."""
    system = masses(1e8)
    event = fx.Event("far", lambda state: state["A.x"] - 1.0002, terminal=True)
    motion = system.simulate(4.0, events=[event])
    assert motion.message.startswith("stopped by event 'far'")
    assert [(name, state.t) for name, state in motion.events] == [("far", pytest.approx(2e-4, rel=1e-6))]
    assert motion.t[-1] == pytest.approx(2e-4, rel=1e-6)


def test_ctrl_c_keeps_a_motion_that_is_tried(monkeypatch: pytest.MonkeyPatch) -> None:
    forward = MinimalRun.forward

    def interrupted(self: MinimalRun, most: int = 1) -> str | None:
        if self.name == "Radau" and self.taken == 40:
            raise KeyboardInterrupt
        return forward(self, most)

    monkeypatch.setattr(MinimalRun, "forward", interrupted)
    with pytest.raises(fx.Interrupted) as caught:
        masses(1e8).simulate(4.0)
    motion = caught.value.motion
    assert motion.message.startswith("interrupted at t = ") and 0 < motion.t[-1] < 4.0


def test_the_start_alone_is_a_motion_of_a_large_model_too() -> None:
    """With more than 300 degrees of freedom the trials of the methods decide: there is nothing to try."""
    m = fx.Model(gravity=(0, -9.81))
    last = m.point("O", (0, 0), fixed=True)
    for i in range(160):
        point = m.point(f"P{i}", (0.01 * (i + 1), 0))
        m.truss(f"rod{i}", last, point, stiffness=1e3)
        m.point_mass(f"mass{i}", point, 0.01)
        last = point
    system = m.build()
    assert len(system.dynamic) == 320
    motion = system.simulate(1.0, times=[0.0])
    assert len(motion) == 1 and "only the start is stored" in motion.message
