"""One call for all integrators: what each method takes, which one is chosen, and how a motion that fails ends."""

import inspect
from typing import Any

import numpy as np
import pytest

import flexel as fx
from flexel.apps.cli.run import METHODS
from flexel.integration import stiffness
from flexel.integration.methods import OPTIONS

GIVEN: dict[str, Any] = {  # an option with a value that a method which has it accepts
    "rtol": 1e-6,
    "atol": 1e-8,
    "first_step": 1e-3,
    "max_step": 0.05,
    "step": 0.01,
    "spectral_radius": 0.5,
    "newton": "modified",
    "events": [fx.Event("low", lambda state: state["P.x"] - 1.0)],
    "rechoose": False,
}


def oscillator(stiffness: float = 100.0, size: float = 1.0) -> fx.System:
    """A mass on a spring along x, drawn at its rest length, that moves at its size a second."""
    m = fx.Model()
    O, P = m.point("O", (0, 0), fixed=True), m.point("P", (size, 0))
    m.fix("P.y")
    m.truss("spring", O, P, stiffness=stiffness)
    m.point_mass("mass", P, 1.0)
    m.initial("P.x", rate=size)
    return m.build()


@pytest.mark.parametrize("method", OPTIONS)
@pytest.mark.parametrize("name", GIVEN)
def test_every_method_takes_its_options_and_refuses_those_of_others_by_name(method: str, name: str) -> None:
    system = oscillator()
    if name in OPTIONS[method]:
        motion = system.simulate(0.1, method=method, samples=3, **{name: GIVEN[name]})
        assert motion.t[-1] == pytest.approx(0.1)
        return
    with pytest.raises(fx.ModelError) as caught:
        system.simulate(0.1, method=method, **{name: GIVEN[name]})
    message = str(caught.value)
    assert message.startswith(f"simulate: {name} is not an option of method '{method}'")
    assert all(other in message for other in OPTIONS if name in OPTIONS[other])


def test_the_table_of_options_is_that_of_the_signature_and_of_the_command_line() -> None:
    """What applies to all methods is in the signature alone; an option that only "auto" sets is in none."""
    of_methods = set().union(*OPTIONS.values())
    assert of_methods == set(GIVEN)
    assert list(OPTIONS) == list(METHODS)
    signature = set(inspect.signature(fx.System.simulate).parameters)
    common = {"system", "duration", "start", "times", "samples", "method", "progress", "checkpoint"}
    assert signature - common == of_methods


@pytest.mark.parametrize("name", ["rtol", "atol", "first_step", "max_step"])
def test_a_constant_step_leaves_no_meaning_to_tolerances_and_limits(name: str) -> None:
    with pytest.raises(fx.ModelError, match=f"step is constant, so {name} would have no effect"):
        oscillator().simulate(0.1, method="generalized-alpha", step=0.01, **{name: GIVEN[name]})


def test_explicit_is_chosen_where_nothing_speaks_against_it() -> None:
    motion = oscillator().simulate(1.0)
    assert motion.message == (
        "reached the end (DOP853, chosen because max|eigenvalue|*duration = 10 at t = 0 s, at most 3e+04; "
        f"{motion.verdict})"
    )
    assert motion.dense


def test_what_lacks_inertia_is_integrated_implicitly_and_named_by_explicit_methods() -> None:
    """A point without mass between two springs; the mass beyond them swings as on one of half the stiffness."""
    m = fx.Model()
    O, P, Q = m.point("O", (0, 0), fixed=True), m.point("P", (1, 0)), m.point("Q", (2, 0))
    m.fix("P.y", "Q.y")
    m.truss("first", O, P, stiffness=100.0)
    m.truss("second", P, Q, stiffness=100.0)
    m.point_mass("mass", Q, 1.0)
    m.initial("Q.x", rate=0.1)
    m.initial("P.x", rate=0.05)
    system = m.build()
    motion = system.simulate(0.5, samples=6)
    assert "generalized-alpha, chosen because a degree of freedom has no inertia" in motion.message
    omega = np.sqrt(50.0)
    np.testing.assert_allclose(motion["Q.x"], 2 + 0.1 / omega * np.sin(omega * motion.t), atol=1e-4)
    np.testing.assert_allclose(motion["P.x"], 1 + 0.05 / omega * np.sin(omega * motion.t), atol=1e-4)
    with pytest.raises(fx.DynamicsError, match="'first.elongation' moves no mass"):
        system.simulate(0.5, method="DOP853")


@pytest.mark.parametrize(
    ("most", "why"),
    [
        (
            1000,
            "DOP853, chosen because 303 degrees of freedom, above 300; Radau would not take fewer evaluations",
        ),
        (302, "generalized-alpha, chosen because 303 degrees of freedom, above 302"),
    ],
)
def test_the_method_for_many_degrees_of_freedom_is_chosen_without_eigenvalues(
    monkeypatch: pytest.MonkeyPatch, most: int, why: str
) -> None:
    """By trials alone, or not at all."""
    monkeypatch.setattr(stiffness, "MANY", most)
    m = fx.Model(gravity=(0, 0, -9.81))
    for i in range(101):
        m.point_mass(f"mass{i}", m.point(f"P{i}", (i, 0, 0)), 1.0)
    system = m.build()
    monkeypatch.setattr(type(system), "linearize", None)
    motion = system.simulate(0.1, samples=3)
    assert motion.message == f"reached the end ({why}; {motion.verdict})"
    assert motion["P7.z"][-1] == pytest.approx(-9.81 * 0.1**2 / 2, rel=1e-6)


def test_a_vibration_up_to_an_event_is_followed() -> None:
    system = oscillator(stiffness=1e8)
    event = fx.Event("passage", lambda state: state["P.x"] - 1.0, terminal=True)
    motion = system.simulate(4.0, events=[event])
    assert motion.message.startswith(
        "stopped by event 'passage' (DOP853, chosen because max|eigenvalue|*duration = 4e+04"
    )
    assert motion.t[-1] == pytest.approx(np.pi / 1e4, rel=1e-3)


def test_a_prescribed_motion_is_followed_with_its_events() -> None:
    m = fx.Model()
    m.point_mass("mass", m.point("P", (0.0, 0.0)), 1.0)
    m.fix("P.y")
    m.prescribe("P.x", lambda t: t * t)
    system = m.build()
    motion = system.simulate(1.0, samples=5)
    assert motion.message == "reached the end (not integrated: every motion is prescribed)"
    event = fx.Event("quarter", lambda state: state["P.x"] - 0.25, terminal=True)
    stopped = system.simulate(1.0, samples=5, events=[event])
    assert stopped.t[-1] == pytest.approx(0.5, abs=1e-12)
    assert stopped.events[0][0] == "quarter"


@pytest.mark.parametrize("method", ["DOP853", "Radau", "generalized-alpha"])
def test_a_motion_that_cannot_go_on_raises_with_what_was_computed(method: str) -> None:
    """A rod whose end is drawn beyond its length, beside a mass that flies freely."""
    m = fx.Model()
    O, A = m.point("O", (0, 0), fixed=True), m.point("A", (1, 0))
    m.truss("rod", O, A)
    m.point_mass("mass", A, 1.0)
    m.prescribe("A.y", lambda t: t)
    m.point_mass("other", m.point("B", (3.0, 0.0)), 1.0)
    m.initial("B.x", rate=1.0)
    system = m.build()
    with pytest.raises((fx.DynamicsError, fx.PositionError)) as caught:
        system.simulate(2.0, method=method, samples=201, progress=False)
    motion = caught.value.motion
    assert motion is not None
    assert 0.5 < motion.t[-1] <= 1.0 + 1e-9
    assert motion.message.startswith(str(caught.value))
    assert motion["B.x"][-1] == pytest.approx(3.0 + motion.t[-1], rel=1e-5)


def test_a_motion_that_fails_under_a_chosen_method_says_which_it_was() -> None:
    m = fx.Model()
    m.point_mass("mass", m.point("P", (0.0, 0.0)), 1.0)
    m.load("P.x", fx.Table([0.0, 0.1, 0.2, 0.3], [0.0, 1.0, 1.0, 1.0]))
    with pytest.raises(fx.ModelError, match="outside") as caught:
        m.build().simulate(0.5)
    assert "DOP853, chosen because" in caught.value.motion.message


@pytest.mark.parametrize("method", ["DOP853", "generalized-alpha"])
def test_tolerances_scale_with_the_model(method: str) -> None:
    """A model a thousand times as large takes the same steps, also where the absolute tolerance rules."""
    options: dict[str, Any] = (
        {"samples": 3, "rtol": 1e-12, "atol": 1e-6} if method == "DOP853" else {"atol": 1e-6}
    )
    small, large = (oscillator(size=size).simulate(1.0, method=method, **options) for size in (1.0, 1000.0))
    assert small.statistics["steps"] == large.statistics["steps"]
    np.testing.assert_allclose(1000 * small["P.x"], large["P.x"], rtol=1e-9)
    loose = oscillator(size=1000.0).simulate(1.0, method=method, **(options | {"atol": 1e-4}))
    assert loose.statistics["steps"] < large.statistics["steps"]


def test_each_variable_may_have_its_absolute_tolerance() -> None:
    system = oscillator(size=1000.0)
    one, each = (
        system.simulate(1.0, method="DOP853", samples=3, atol=atol, rechoose=False)
        for atol in (1e-9, [1e-9, 1e-9])
    )
    assert np.array_equal(one.x, each.x)
    for wrong, words in (([1e-9], "has shape"), ([1e-9, -1.0], "too small")):
        with pytest.raises(fx.ModelError, match=words):
            system.simulate(1.0, method="DOP853", atol=wrong, rechoose=False)
    with pytest.raises(fx.ModelError, match="rechoose=False"):
        system.simulate(1.0, atol=[1e-9, 1e-9])


def test_a_first_step_is_taken_where_it_is_given() -> None:
    motion = oscillator().simulate(1.0, method="DOP853", first_step=1e-4, samples=2)
    assert motion._segments[0].t1 == pytest.approx(1e-4)
