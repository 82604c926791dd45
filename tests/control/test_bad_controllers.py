"""Controllers that cannot work: what the message names, and when; and what travels to other processes."""

import copy
import pickle
from typing import Any

import numpy as np
import pytest
from controlled import Array, carriage, cart, lagging, spring_law
from scipy.signal import StateSpace

import flexel as fx

# the matrix of a linear loop is the same at all states
LINEAR = pytest.mark.filterwarnings("ignore:sampled. this is not a fixed point:flexel.UnsteadyWarning")


GIVEN: dict[str, Any] = {"inputs": ["A.x", "A.x'"], "outputs": ["A.x"], "name": "c"}


def refused(match: str, function: Any = spring_law, **options: Any) -> None:
    """A declaration that is refused, and leaves the model as it was."""
    m = carriage()
    before = len(m.laws), len(m.nodes), len(m.instances)
    with pytest.raises(fx.ModelError, match=match):
        m.controller(function, **{**GIVEN, **options})
    assert (len(m.laws), len(m.nodes), len(m.instances), m.controllers) == (*before, [])


def test_names_are_checked_where_they_are_given() -> None:
    refused(r"controller 'c': input: unknown name 'A\.xx'; did you mean A\.x", inputs=["A.xx"])
    refused(r"controller 'c': output: unknown name 'B\.x'; known: A\.x", outputs=["B.x"])
    refused(r"controller 'c': output: unknown name 'B\.x'", outputs=["B.x"], period=0.1)
    refused(r"'A\.y' is fixed and cannot move", outputs=["A.y"])
    refused("inputs .*; name one or more, each once", inputs=[])
    refused("outputs .*; name one or more, each once", outputs=["A.x", "A.x"])
    refused(
        "measures values and rates, but 'A.x''' depends on its own force; give it a period", inputs=["A.x''"]
    )
    refused("'A.x' is not a list of names", inputs="A.x")
    refused("a name is text without dots", name="a.b")
    refused("this name is taken", name="A")
    m = carriage()
    m.controller(spring_law, **GIVEN, period=0.1)
    with pytest.raises(fx.ModelError, match="this name is taken; choose another with name="):
        m.controller(spring_law, **GIVEN, period=0.1)
    m = carriage()
    m.controller(spring_law, **{**GIVEN, "inputs": ["A.x'''", "A.x"]}, period=0.1)
    with pytest.raises(fx.ModelError, match="controller 'c': input .*only first and second rates exist"):
        m.build()


def test_sizes_and_settings() -> None:
    refused(r"gains of shape \(2, 2\); give \(1, 2\), a row for each output", np.eye(2))
    refused(
        "the system has 1 inputs and 1 outputs; it is connected to 2 inputs and 1 outputs",
        StateSpace(-1, 1, 1, 0),
    )
    refused("state .* has shape", StateSpace(-1.0, [[1.0, 0]], 1.0, [[0, 0]]), state=[1, 2])
    refused("gains have no state", [[1.0, 2.0]], state=[0.0])
    refused("a function contains its reference", reference={"A.x": 1.0})
    refused("the reference 'A.z' is not an input; the inputs are A.x, A.x'", [[1, 2]], reference={"A.z": 1.0})
    refused("a continuous controller has no delay; give a period", delay=0.1)
    refused("delay -1 is negative", period=0.1, delay=-1.0)
    refused("period 0 is not positive", period=0.0)
    refused("2000 outputs would be delayed at once", period=1e-3, delay=2.0)
    refused("limits 3; give a pair", limits=3, period=0.1)
    refused("the lower one must be less", limits=(1, -1), period=0.1)
    refused("limits contain 'low'; give a number", limits=("low", 1), period=0.1)
    refused("None is not a controller; give a function of", None)
    refused("'pid' is not a controller", "pid")
    refused(
        "states; a continuous one may have at most 100: reduce its order",
        lambda t, y, x: (0.0, x),
        state=np.zeros(101),
    )
    discrete = StateSpace(0.5, [[1.0, 0]], 1.0, [[0, 0]], dt=0.1)
    refused("period 0.2 s, but the system has 0.1 s", discrete, period=0.2)
    refused("discrete and has no period", StateSpace(0.5, [[1.0, 0]], 1.0, [[0, 0]], dt=True))
    refused("is continuous, but a period is given", StateSpace(-1.0, [[1.0, 0]], 1.0, [[0, 0]]), period=0.1)


def failing(t: float, y: Array) -> float:
    """A function that fails after a while."""
    if t > 0.24:
        raise ZeroDivisionError("no brakes")
    return -y[0]


def running(function: Any, **options: Any) -> str:
    """The message of a simulation that fails."""
    m = carriage()
    m.controller(function, **{**GIVEN, **options})
    with pytest.raises(fx.ModelError) as caught:
        m.build().simulate(1.0, **({"method": "DOP853"} if "method" not in options else {}))
    return str(caught.value)


@pytest.mark.parametrize("period", [0.05, None])
def test_a_function_that_fails_is_named_with_the_time(period: float | None) -> None:
    message = running(failing, period=period)
    assert "controller 'c' at t = 0.2" in message and "ZeroDivisionError: no brakes" in message
    assert "called with (t, y)" in message
    assert "the function returned array([1., 2.]); it must return 1 finite number" in running(
        lambda t, y: np.array([1.0, 2.0]), period=period
    )
    assert "returned nan; it must return 1 finite number" in running(lambda t, y: np.nan, period=period)
    assert "returned None" in running(lambda t, y: None, period=period)
    assert "it must return two values, (outputs, state)" in running(
        lambda t, y, x: 1.0, state=[0.0], period=period
    )
    assert "the function returned the state" in running(
        lambda t, y, x: (1.0, [1, 2]), state=[0.0], period=period
    )
    assert "called with (t, y)" in running(lambda t: 1.0, period=period)


@pytest.mark.parametrize("method", ["DOP853", "Radau", "generalized-alpha"])
def test_every_method_names_a_continuous_function_that_fails(method: str) -> None:
    m = carriage()
    m.controller(failing, **GIVEN)
    s = m.build()
    with pytest.raises(fx.ModelError, match=r"controller 'c' at t = 0\.2\d* s: the function failed"):
        s.simulate(1.0, method=method)
    s = s.restore(s.initial) and s  # it can be used again
    assert s.simulate(0.1, method=method).t[-1] == 0.1


def test_an_interrupt_within_a_continuous_function_ends_the_motion() -> None:
    """Ctrl-C while C calls the function: the motion up to there is kept."""
    count = []

    def slow(t: float, y: Array) -> float:
        count.append(t)
        if len(count) == 300:
            raise KeyboardInterrupt
        return -20 * y[0]

    m = carriage()
    m.controller(slow, **GIVEN)
    with pytest.raises(fx.Interrupted) as caught:
        m.build().simulate(5.0, method="DOP853", times=np.linspace(0, 5, 51))
    motion = caught.value.motion
    assert motion.message.startswith("interrupted at t =") and 0 < motion.t[-1] < 5
    assert motion["A.x"][:-1] == pytest.approx(0.5 * np.cos(np.sqrt(10) * motion.t[:-1]), abs=1e-7)


def test_a_system_without_states_is_its_gains() -> None:
    control = pytest.importorskip("control", reason="pip install 'flexel[control]'")
    for period in (None, 0.05):
        found = []
        for function in (control.ss([], [], [], [[30.0, 8.0]], period or 0), [[30.0, 8.0]]):
            m = carriage()
            m.controller(function, **GIVEN, period=period)
            found.append(m.build().simulate(1.0, method="DOP853")["A.x"])
        assert np.array_equal(*found)


@LINEAR
def test_what_is_not_smooth_has_no_linearization() -> None:
    for function in (lambda t, y: -3 * np.sign(y[0] - 0.5), lambda t, y: -abs(y[0] - 0.5)):
        m = carriage()
        m.controller(function, **GIVEN)
        with pytest.raises(
            fx.LinearizationError, match=r"controller 'c': the function is not smooth .*over input 0"
        ):
            m.build().linearize()
    for function in (lambda t, y: -100 * y[0], [[100.0, 0.0]]):
        for period in (None, 0.1):
            m = carriage()
            m.controller(function, **GIVEN, limits=(-1, 1), period=period)
            s = m.build()
            with pytest.raises(fx.LinearizationError, match="its output on 'A.x' is at its limit"):
                s.linearize().sampled() if period else s.linearize()
            free = s.linearize(s.state_at({"A.x": 1e-3}))
            assert free.sampled().stable is not None if period else free.K[0, 0] == pytest.approx(100.0)
    lin = carriage().build().linearize()
    with pytest.raises(fx.LinearizationError, match="no controller has a period"):
        lin.sampled()


def test_analyses_without_a_meaning_for_samples_say_so() -> None:
    m = carriage()
    m.controller([[1.0, 1.0]], **GIVEN, period=0.1)
    s = m.build()
    for call in (s.linearize().eigenvalues, s.linearize().modes, s.steady, s.linearize_many):
        with pytest.raises(fx.LinearizationError, match=r"controller 'c' is sampled \(period 0.1 s\)"):
            call()


def test_copies_and_pickles_carry_the_controller_or_name_it() -> None:
    for options in ({"period": 0.05, "delay": 0.07}, {}):
        m = carriage()
        m.controller(lagging, **{**GIVEN, "inputs": ["A.x"]}, state=[0.5], **options)
        known = m.build().simulate(0.5)["A.x"]
        for other in (copy.deepcopy(m), pickle.loads(pickle.dumps(m))):
            assert np.array_equal(other.build().simulate(0.5)["A.x"], known)
        s = pickle.loads(pickle.dumps(m.build()))
        motion = pickle.loads(pickle.dumps(s.simulate(0.5)))
        assert np.array_equal(motion["A.x"], known) and motion["c.u"].shape == known.shape
        m = carriage()
        m.controller(lambda t, y: 0.0, **GIVEN, **options)
        with pytest.raises(fx.ModelError, match="controller 'c': .* cannot be pickled"):
            pickle.dumps(m)


def test_variants_side_by_side_are_those_alone() -> None:
    m = cart()
    m.controller(lambda t, y: 60 * y[0] + 12 * y[1], inputs=["pivot.angle", "pivot.angle'"], outputs=["cart.x"],
                 period=0.02, delay=0.03, name="c")  # fmt: skip
    s = m.build()
    many = s.simulate_many(
        0.5, parameters={"cart mass.mass": [2.0, 3.0, 4.0]}, initial={"pivot.angle": [0.1, 0.2, 0.3]},
        outputs=["cart.x", "c.u"], samples=11, threads=2,
    )  # fmt: skip
    assert not many.failed
    alone = s.with_parameters({"cart mass.mass": 2.0})
    motion = alone.simulate(0.5, start=alone.state_at({"pivot.angle": 0.1}), samples=11, method="DOP853")
    assert many["cart.x"][0] == pytest.approx(motion["cart.x"], abs=1e-12)
    assert many["c.u"][0] == pytest.approx(motion["c.u"], abs=1e-9)


def test_where_every_motion_is_prescribed_a_controller_takes_part_in_the_driving_force() -> None:
    """It samples what is prescribed; an own state of a continuous one is integrated along."""

    def driven(function: Any, **options: Any) -> fx.System:
        m = fx.Model()
        m.point("A", (0.5, 0))
        m.fix("A.y")
        m.point_mass("body", "A", 2.0)
        m.prescribe("A.x", lambda t: 0.5 + 0.1 * np.sin(t))
        m.controller(function, **{**GIVEN, "inputs": ["A.x"], **options})
        return m.build()

    motion = driven(lambda t, y: -y[0], period=0.1).simulate(1.0, samples=11)
    known = -(0.5 + 0.1 * np.sin(0.1 * np.arange(10)))
    assert motion["c.u"][1:] == pytest.approx(known, abs=1e-12)
    inertia = -2.0 * 0.1 * np.sin(motion.t)
    assert motion["force:A.x"] == pytest.approx(inertia - motion["c.u"], abs=1e-12)
    assert motion.at(0.55)["c.u"] == motion["c.u"][6]
    motion = driven(lambda t, y, x: (y[0], y), state=[0.0]).simulate(1.0)
    assert motion["c.x0"][-1] == pytest.approx(0.5 + 0.1 * (1 - np.cos(1.0)), abs=1e-9)


def test_gains_are_parameters_of_their_controller() -> None:
    m = cart()
    m.controller([[14.0, 80.0]], inputs=["pivot.angle'", "pivot.angle"], outputs=["cart.x"], name="c")
    s = m.build()
    own = [name for name in s.parameters if name.startswith("c.")]
    assert "cart mass.mass" in s.parameters and own == ["c.function", "c.delay"]
    assert s.with_parameters({"c.function": [[7.0, 40.0]]}).parameters["c.function"].tolist() == [7.0, 40.0]
    with pytest.raises(fx.ModelError, match="unknown parameter 'c.damping'"):
        s.with_parameters({"c.damping": [1.0, 2.0]})
