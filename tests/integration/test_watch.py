"""A motion that `simulate` began by DOP853 goes on with Radau where that takes fewer evaluations, and back."""

import re
import warnings
from typing import Any

import numpy as np
import pytest

import flexel as fx
from flexel.integration import watch
from flexel.integration.attempts import Attempted
from flexel.integration.dop853 import Dop853
from flexel.integration.minimal import MinimalRun
from flexel.integration.radau import Radau
from flexel.integration.simulation import begun
from flexel.integration.step_method import StepMethod


def pressed(stiffness: float, damping: float, force: Any = 10.0) -> fx.System:
    """A mass of 1 kg that a force of 10 N holds against a stop at 0.3 m, and a spring of 10 N/m draws back with 3 N."""
    m = fx.Model()
    O, A = m.point("O", (0, 0), fixed=True), m.point("A", (1, 0))
    m.fix("A.y")
    m.point_mass("mass", A, 1.0)
    m.truss("spring", O, A, stiffness=10.0)
    m.load("A.x", force)
    m.stop("spring.elongation", 0.3, stiffness, damping)
    return m.build()


def rolling() -> fx.System:
    """A ball on a stiff floor, held by a soft spring: it slides at first."""
    m = fx.Model(gravity=(0, 0, -9.81))
    m.point("corner", (0, 0, 0), fixed=True)
    m.plane("floor", "corner", m.frame("ground", fixed=True), normal=(0, 0, 1))
    m.rigid_body("ball", (0, 0, 0.11), mass=1.0, inertia=(0.004,) * 3)
    contact = fx.Contact(1e9, dissipation=2.0, friction=0.3, slip_speed=1e-3)
    m.contact("touch", "ball", "floor", contact, frame="ball_frame", radius=0.1)
    m.spring("ball.x", 2.0)
    m.initial("ball.x", rate=1.0)
    return m.build()


def test_a_motion_that_becomes_stiff_goes_on_with_radau() -> None:
    """At rest on the stop DOP853 takes steps of 1e-5 s: more than four million in all."""
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        motion = pressed(1e9, 10.0).simulate(10.0, samples=11)
    assert "; Radau from t = 0." in motion.message
    assert (
        "on, since it takes fewer evaluations than DOP853 at rtol = 1e-09; energy balance within"
        in motion.message
    )
    assert motion.statistics["steps"] < 70_000
    assert motion["A.x"][-1] == pytest.approx(1.3 + 7.0 / (1e9 + 10.0), abs=1e-13)  # at rest


def test_the_rest_of_the_motion_is_as_exact_as_its_beginning() -> None:
    """A ball that slides, then rolls to and fro, against DOP853 at a tight tolerance."""
    times = np.linspace(0, 10, 21)
    system = rolling()
    motion = system.simulate(10.0, times=times)
    assert "; Radau from t = " in motion.message and "at rtol = 1e-09" in motion.message
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", fx.StiffWarning)
        exact = system.simulate(10.0, times=times, method="DOP853", rtol=1e-11)
    assert motion.statistics["evaluations"] < exact.statistics["evaluations"] / 2
    for name in ("ball.x", "ball.x'"):
        np.testing.assert_allclose(motion[name], exact[name], atol=2e-8)


def test_it_goes_back_to_dop853_where_the_motion_becomes_lively(monkeypatch: pytest.MonkeyPatch) -> None:
    """A mass that is held against a stop for 3 s, and then shaken in the air at 60 rad/s."""
    monkeypatch.setattr(watch, "LOOK", 200)
    monkeypatch.setattr(watch, "LONG", 400)

    def shaken(t: float) -> float:
        return 10.0 if t < 3.0 else -2.0 + 20.0 * float(np.sin(60.0 * t))

    system = pressed(1e7, 1e2, shaken)
    motion = system.simulate(20.0, samples=61)
    changes = re.findall("(Radau|DOP853) from t = ([0-9.]+) s on", motion.message)
    (first, begun), (last, back) = changes[0], changes[-1]
    assert (first, last) == ("Radau", "DOP853")
    assert float(begun) < 1.0 and float(back) > 3.0
    exact = system.simulate(20.0, samples=61, method="DOP853", rtol=1e-10)
    np.testing.assert_allclose(motion["A.x"], exact["A.x"], atol=1e-7)


def test_a_method_that_is_named_stays(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(watch, "LOOK", 100)
    monkeypatch.setattr(watch, "LONG", 200)
    with pytest.warns(fx.StiffWarning, match="omit method, so that a faster one is chosen$"):
        motion = rolling().simulate(0.5, method="DOP853")
    assert "Radau" not in motion.message


def test_trials_change_nothing_of_the_motion(monkeypatch: pytest.MonkeyPatch) -> None:
    """A chain of three links that swings by 180°, which is cheaper by DOP853: four looks at it."""
    m = fx.Model(gravity=(0, -9.81))
    line = m.chain("chain", [(0, 0), (1, 0)], 3, mass_per_length=1.0)
    m.fix(line.points[0])
    system = m.build()
    plain = system.simulate(5.0, samples=31, method="DOP853")
    monkeypatch.setattr(watch, "LOOK", 50)
    monkeypatch.setattr(watch, "LONG", 50)
    looks: list[float] = []
    change = watch.Watch._change

    def counted(self: watch.Watch, run: Any, *args: Any) -> None:
        looks.append(run.t)
        change(self, run, *args)

    monkeypatch.setattr(watch.Watch, "_change", counted)
    motion = system.simulate(5.0, samples=31)
    assert len(looks) >= 3 and "Radau" not in motion.message
    assert motion.statistics == plain.statistics
    assert np.array_equal(motion.x, plain.x) and np.array_equal(motion.v, plain.v)


@pytest.mark.parametrize(("first", "second"), [("DOP853", Radau), ("Radau", Dop853)])
def test_a_method_begins_beyond_a_knot(first: str, second: type[StepMethod]) -> None:
    """The last step before the change ends at a knot of the force."""
    t = np.linspace(0, 2, 101)
    system = pressed(1e4, 1.0, fx.Table(t, 10.0 + 0.1 * (-1.0) ** np.arange(101), kind="linear"))
    run = begun(system, 2.0, method=first, samples=11).run
    assert isinstance(run, MinimalRun)
    while run.t < min(0.9, run.knots.end):
        run.forward()
    assert run.stop == run.t
    run.use(second, run.tolerances)
    motion = fx.Motion(system, run.rest(False))
    exact = system.simulate(2.0, samples=11, method="DOP853", rtol=1e-11)
    np.testing.assert_allclose(motion["A.x"], exact["A.x"], atol=1e-8)


def test_variants_go_on_with_radau_as_single_motions_do(monkeypatch: pytest.MonkeyPatch) -> None:
    """One variant leaves its lane, where it has come to rest on the stop; the other swings on in it."""
    monkeypatch.setattr(watch, "LOOK", 200)
    monkeypatch.setattr(watch, "LONG", 400)
    system, times = pressed(1e7, 1e2), np.linspace(0, 20, 21)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        many = system.simulate_many(
            20.0, parameters={"spring.stiffness": [10.0, 100.0]}, times=times, outputs=["A.x"], threads=1
        )
        alone = [
            system.with_parameters({"spring.stiffness": k}).simulate(20.0, times=times) for k in (10.0, 100.0)
        ]
    assert ["; Radau from t = " in motion.message for motion in alone] == [True, False]
    for row, motion in enumerate(alone):
        np.testing.assert_allclose(many["A.x"][row], motion["A.x"], atol=1e-8)
        assert many.statistics[row]["steps"] == pytest.approx(motion.statistics["steps"], rel=0.1)


def test_variants_are_warned_of_once(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(watch, "LOOK", 100)
    monkeypatch.setattr(watch, "LONG", 200)
    with pytest.warns(
        fx.StiffWarning, match="simulate_many: 2 of 2 variants, number 0 first: DOP853"
    ) as said:
        rolling().simulate_many(
            0.5, initial={"ball.x'": [0.5, 1.0]}, outputs=["ball.x"], method="DOP853", threads=1
        )
    assert len(said) == 1


def too_short(kind: type[StepMethod], after: float, monkeypatch: pytest.MonkeyPatch) -> None:
    """Let the steps of a method become too short at a time [s]."""
    attempt = kind.attempt

    def stopped(method: StepMethod) -> Attempted:
        return Attempted.SHORT if method.course.t >= after else attempt(method)

    monkeypatch.setattr(kind, "attempt", stopped)
    monkeypatch.setattr(kind, "rows", False)


def test_it_goes_on_by_the_other_method_where_steps_become_too_short(monkeypatch: pytest.MonkeyPatch) -> None:
    system = pressed(1e4, 10.0)
    exact = system.simulate(2.0, samples=41)
    too_short(Dop853, 0.7, monkeypatch)
    motion = system.simulate(2.0, samples=41)
    assert re.search(
        "Radau from t = 0[.]7[0-9]* s on, since the steps of DOP853 became too short", motion.message
    )
    np.testing.assert_allclose(motion["A.x"], exact["A.x"], atol=1e-8)
    with pytest.raises(fx.DynamicsError, match="the steps have become too short at t = 0.7"):
        system.simulate(2.0, samples=41, method="DOP853")
    too_short(Radau, 0.7, monkeypatch)
    with pytest.raises(fx.DynamicsError, match="too short"):
        system.simulate(2.0, samples=41)
