"""Functions of time with kinks and jumps: steps end at their knots, and rates that jump are an impulse."""

import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.interpolate import interp1d

import flexel as fx
from flexel.base.arrays import Array
from flexel.base.time_functions import TimeFunction, as_function, next_knot
from flexel.integration.time_scales import TimeScales

METHODS = ["DOP853", "generalized-alpha", "Radau"]
PULSES: dict[str, Any] = {
    "formula": lambda t: np.where((t > 7) & (t < 7.01), 100.0, 0.0),
    "branch": lambda t: 100.0 if 7 < t < 7.01 else 0.0 * t,
    "product": lambda t: 100 * np.heaviside(t - 7, 1.0) * np.heaviside(7.01 - t, 1.0),
    "steps": fx.Table([0, 7, 7.01], [0, 100, 0], kind="step"),
    "jumps": fx.Table([0, 7, 7, 7.01, 7.01, 10], [0, 0, 100, 100, 0, 0], kind="linear"),
}


def mass_on_a_line(load: Any) -> fx.System:
    m = fx.Model()
    m.point("A", (0, 0))
    m.fix("A.y")
    m.point_mass("k", "A", 2.0)
    m.load("A.x", load)
    return m.build()


def hung(motion: Any) -> fx.Model:
    """A pendulum of one metre whose pivot is moved sideways."""
    m = fx.Model(gravity=(0, -9.81))
    m.point("A", (0, 0))
    m.point("B", (0, -1))
    m.fix("A.y")
    m.truss("rod", "A", "B")
    m.rigid("rod.elongation")
    m.point_mass("bob", "B", 1.0)
    m.prescribe("A.x", motion)
    return m


@pytest.mark.parametrize("pulse", PULSES)
@pytest.mark.parametrize("method", METHODS)
def test_a_pulse_of_ten_milliseconds_is_not_stepped_over(method: str, pulse: str) -> None:
    """Closed form: 0.5 m/s from 7.005 s on; today's steps passed it."""
    motion = mass_on_a_line(PULSES[pulse]).simulate(10, method=method, samples=11)
    assert motion["A.x"][-1] == pytest.approx(100 * 0.01 / 2 * (10 - 7.005), rel=1e-9)


def test_the_default_method_sees_a_pulse() -> None:
    motion = mass_on_a_line(PULSES["formula"]).simulate(10)
    assert motion["A.x"][-1] == pytest.approx(0.5 * 2.995, rel=1e-9)


@pytest.mark.parametrize("method", METHODS)
def test_a_pivot_that_stops_suddenly_lets_its_pendulum_swing(method: str) -> None:
    """Closed form: the bob keeps 1 m/s, so that it rises by 1/(2 g)."""
    s = hung(lambda t: np.minimum(t, 0.5)).build()
    motion = s.simulate(1.2, start=s.state_at(rates={"B.x": 1.0}), method=method, samples=1201)
    highest = np.max(motion["B.y"])
    assert highest == pytest.approx(-1 + 1 / (2 * 9.81), abs=2e-6)


def test_the_impulse_does_the_work_that_the_pivot_gives() -> None:
    """The balance of energy of the implicit method, with a link that starts to move suddenly at 0.3 s."""
    m = hung(lambda t: np.maximum(0.0, 2 * (t - 0.3)))
    motion = m.build().simulate(0.6, method="generalized-alpha", rtol=1e-8)
    balance = motion.energy_balance()
    assert np.max(np.abs(balance["error"])) < 5e-6


def test_an_oblique_impulse_keeps_the_momentum_that_the_constraints_leave() -> None:
    """Closed form: a rod at 45° to the jump of its pivot takes only the share of it along the rod."""
    m = fx.Model()
    m.point("A", (0, 0))
    m.point("B", (1, -1))
    m.fix("A.y")
    m.truss("rod", "A", "B")
    m.rigid("rod.elongation")
    m.point_mass("bob", "B", 3.0)
    m.prescribe("A.x", lambda t: np.maximum(0.0, t - 0.1))
    motion = m.build().simulate(0.1 + 1e-6, times=[0.0, 0.1 + 1e-6], method="DOP853")
    assert [motion[-1].rate("B.x"), motion[-1].rate("B.y")] == pytest.approx([0.5, -0.5], abs=1e-5)


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("samples", [2, 11, 60, 401])
def test_an_impulse_does_not_depend_on_what_is_stored(method: str, samples: int) -> None:
    """With stored states close before the jump its directions were those of the last of them: 3 % of the rates off."""
    table = fx.Table([0, 0.4, 2], [0, 0.3, 0.3], kind="linear")
    m = fx.Model(gravity=(0, -9.81))
    m.point("A", (0, 0))
    m.point("B", (1, -1))
    m.fix("A.y")
    m.truss("rod", "A", "B")
    m.rigid("rod.elongation")
    m.point_mass("bob", "B", 3.0)
    m.prescribe("A.x", table)
    m.initial("B.x", rate=4.0)
    motion = m.build().simulate(0.8, samples=samples, method=method, rtol=1e-9)

    def swing(_: float, y: Array) -> list[float]:
        return [y[1], -9.81 / np.sqrt(2) * np.sin(y[0])]

    # The angle of the rod, about A that moves at 0.75 m/s; the impulse acts along the rod.
    before = solve_ivp(swing, (0, 0.4), [np.pi / 4, 4.0 - 0.75], rtol=1e-12, atol=1e-12).y[:, -1]
    after = before + [0, 0.75 * np.cos(before[0]) / np.sqrt(2)]
    end = solve_ivp(swing, (0.4, 0.8), after, rtol=1e-12, atol=1e-12).y[0, -1]
    assert motion[-1]["B.x"] == pytest.approx(0.3 + np.sqrt(2) * np.sin(end), abs=1e-6)


@pytest.mark.parametrize("method", METHODS)
def test_a_prescribed_jump_is_refused_by_name(method: str) -> None:
    s = hung(lambda t: np.where(t > 0.25, 0.1, 0.0)).build()
    with pytest.raises(
        fx.DynamicsError, match=r"'A.x' is prescribed to jump from 0 to 0.1 at t = 0.25 s.*fx.Ramp"
    ):
        s.simulate(1, method=method)


def test_a_table_of_steps_is_refused_where_it_would_move_a_part() -> None:
    with pytest.raises(fx.ModelError, match=r"prescribe 'A.x'.*steps jumps.*fx.Ramp"):
        hung(fx.Table([0, 1], [0, 1], kind="step"))


def test_a_rough_road_costs_few_rejected_steps() -> None:
    """A table with corners: every knot ends a step, so that hardly any step is refused (half of them before)."""
    rng = np.random.default_rng(3)
    t = np.linspace(0, 5, 251)
    for kind in ("cubic", "linear"):
        m = hung(fx.Table(t, 1e-3 * rng.standard_normal(t.size).cumsum(), kind=kind))
        counts = m.build().simulate(5, method="DOP853", samples=2).statistics
        assert counts["rejected"] < 0.1 * counts["steps"]


def test_knots_of_a_spline_through_a_smooth_function_are_not_seen() -> None:
    t = np.linspace(0, 10, 2001)
    assert fx.Table(t, np.sin(t)).knots.size == 0
    assert fx.Table(t, np.abs(np.sin(t))).knots.size > 0


@pytest.mark.parametrize("kind", ["cubic", "linear", "step"])
def test_tables_have_the_rates_of_their_pieces(kind: str) -> None:
    """Against differences within the pieces, and against NumPy's interpolation."""
    t, u = np.array([0.0, 0.4, 1.0, 1.7, 2.0, 3.0]), np.array([1.0, -2.0, 0.5, 0.5, 3.0, 2.0])
    table, h = fx.Table(t, u, kind=kind), 1e-4
    for s in (0.1, 0.7, 1.3, 1.85, 2.6):
        before, (value, rate, second), after = (table.rates(s + d) for d in (-h, 0.0, h))
        assert rate == pytest.approx((after[0] - before[0]) / (2 * h), abs=1e-6)
        assert second == pytest.approx((after[1] - before[1]) / (2 * h), abs=1e-6)
        if kind == "linear":
            assert value == pytest.approx(np.interp(s, t, u), rel=1e-14)
    assert [table.rates(s)[0] for s in t[:-1]] == pytest.approx(u[:-1], abs=1e-14)


def test_a_table_of_steps_holds_its_last_value() -> None:
    assert fx.Table([0, 1], [2, 5], kind="step").rates(50.0) == (5, 0, 0)


FUNCTIONS: dict[str, tuple[Callable[[Any], Any], float, float]] = {  # function, time, next knot
    "minimum": (lambda t: np.minimum(t, 1), 0.5, 1.0),
    "maximum": (lambda t: np.maximum(2 * t, 1), 0.2, 0.5),
    "passed": (lambda t: np.minimum(t, 1), 1.5, math.inf),
    "abs": (lambda t: abs(t - 2), 0.0, 2.0),
    "clip": (lambda t: np.clip(t, 1, 2), 1.5, 2.0),
    "interp": (lambda t: np.interp(t, [0, 1, 3], [0, 5, 3]), 1.5, 3.0),
    "floor": (lambda t: np.floor(3 * t), 0.5, 2 / 3),
    "mod": (lambda t: np.mod(t, 0.3), 0.4, 0.6),
    "%": (lambda t: 1.0 if t % 0.5 < 0.25 else 0.0, 0.6, 0.75),
    "//": (lambda t: t // 0.3, 0.4, 0.6),
    "int": (lambda t: [0.0, 1.0, 5.0][int(t)], 0.4, 1.0),
    "math.floor": (lambda t: math.floor(2 * t), 0.6, 1.0),
    "math.ceil": (lambda t: math.ceil(2 * t), 0.6, 1.0),
    "round": (lambda t: round(t, 1), 0.12, 0.15),
    "np.round": (lambda t: np.round(t), 0.6, 1.5),
    "np.rint": (lambda t: np.rint(t), 0.6, 1.5),
    "np.trunc": (lambda t: np.trunc(t), 0.6, 1.0),
    "square wave": (lambda t: np.sign(np.sin(t)), 3.0, math.pi),
    "quadratic": (lambda t: np.where(t**2 > 2, 1.0, 0.0), 1.0, math.sqrt(2)),
    "smooth": (lambda t: np.sin(t), 0.0, math.inf),
}


@pytest.mark.parametrize("name", FUNCTIONS)
def test_the_next_knot_follows_from_what_a_function_compares(name: str) -> None:
    function, t, knot = FUNCTIONS[name]
    assert next_knot(as_function(function, name), t) == pytest.approx(knot, rel=1e-12)


def test_interpolation_by_numpy_is_a_function_of_time() -> None:
    motion = mass_on_a_line(lambda t: np.interp(t, [0, 1, 2], [0, 4, 0])).simulate(2, samples=3)
    assert motion["A.x"] == pytest.approx([0, 1 / 3, 2.0], rel=1e-9, abs=1e-12)


def test_a_motion_continues_from_a_knot_with_the_same_digits() -> None:
    s = mass_on_a_line(PULSES["formula"])
    whole = s.simulate(10, method="DOP853", samples=11)
    half = s.simulate(7, method="DOP853", samples=8)
    rest = s.simulate(3, start=half[-1], method="DOP853", samples=4)
    assert rest["A.x"][-1] == pytest.approx(whole["A.x"][-1], rel=1e-13)


def loaded_pendulum(knot: float) -> fx.System:
    """A pendulum with a load that grows up to a knot [s]."""
    m = fx.Model(gravity=(0, -9.81))
    m.truss("rod", m.point("O", (0, 0), fixed=True), m.point("A", (1, 0)))
    m.point_mass("bob", "A", 1.0)
    m.load("A.x", fx.Ramp(0, knot, 0, 5.0))
    return m.build()


@pytest.mark.parametrize("method", ["DOP853", "Radau", "generalized-alpha"])
@pytest.mark.parametrize("aside", [-1, 0, 1])
def test_a_stored_time_that_rounding_separates_from_a_knot(method: str, aside: int) -> None:
    """No step of 1e-16 s leads from one to the other; generalized-alpha could not continue there."""
    times = np.linspace(0, 2, 21)
    system = loaded_pendulum(float(np.nextafter(times[7], aside * np.inf)) if aside else float(times[7]))
    motion = system.simulate(2.0, times=times, method=method, rtol=1e-6)
    assert np.array_equal(motion.t, times)
    exact = system.simulate(2.0, times=times, method="DOP853", rtol=1e-12)
    assert motion["A.x"] == pytest.approx(exact["A.x"], abs=1e-3)


def test_stored_times_that_are_next_to_each_other() -> None:
    times = [0.0, 0.3, float(np.nextafter(0.3, 1)), 0.3 + 1e-13, 1.0, 1.0 + 1e-12, 2.0]
    motion = loaded_pendulum(0.7).simulate(2.0, times=times, method="generalized-alpha", rtol=1e-4)
    assert motion.t.tolist() == times
    assert np.ptp(motion["A.x"][1:4]) < 1e-12 and np.ptp(motion["A.x"][4:6]) < 1e-11


def modulated(t: float) -> float:
    """A signal of 10 Hz whose width varies; it compares plain numbers, and does not say where it jumps."""
    return 1.0 if (float(t) * 10) % 1.0 < 0.5 + 0.3 * math.sin(2 * float(t)) else 0.0


def held_samples(t: float) -> float:
    """Measured samples, each held until the next."""
    return float(HELD(float(t)))


HELD = interp1d(
    [0.0, 0.3, 0.77, 1.2, 1.9], [0.0, 2.0, -1.0, 0.5, 0.0], kind="previous", fill_value="extrapolate"
)
MODULATED = float(np.mean([modulated(t) for t in (np.arange(200_000) + 0.5) / 100_000])) * 2.0


@pytest.mark.parametrize("method", METHODS)
def test_jumps_of_a_function_that_compares_numbers_are_found(method: str) -> None:
    """Generalized-alpha missed 2.4 % of the momentum, and all but DOP853 said that energy was lost."""
    motion = mass_on_a_line(modulated).simulate(2.0, method=method)
    assert motion["A.x'"][-1] == pytest.approx(MODULATED / 2.0, abs=1e-5)  # of the sum above
    assert not motion.warnings
    motion = mass_on_a_line(held_samples).simulate(2.0, method=method)
    momentum = 2.0 * 0.47 - 1.0 * 0.43 + 0.5 * 0.7
    assert motion["A.x'"][-1] == pytest.approx(momentum / 2.0, rel=1e-9)
    assert not motion.warnings


def test_jumps_are_found_to_rounding_and_nothing_else_is() -> None:
    rng = np.random.default_rng(0)
    own: TimeFunction = as_function(lambda t: float(np.floor(float(t) * 3.7) % 5), "test")
    found = TimeScales([own], 0.0, 10.0).jumps
    assert np.max(np.abs(found - np.arange(1, 38) / 3.7)) < 1e-14
    for smooth in (
        lambda t: math.tanh((float(t) - 3) / 1e-6),
        lambda t: abs(math.sin(float(t))),
        lambda t: math.sqrt(abs(float(t) - 4)),
        lambda t: rng.normal(),
    ):
        none: TimeFunction = as_function(smooth, "test")
        assert not TimeScales([none], 0.0, 10.0).jumps.size


def test_a_prescribed_jump_that_only_numbers_show_is_refused() -> None:
    with pytest.raises(fx.DynamicsError, match=r"'A\.x' is prescribed to jump from 0 to 0\.1 at t = 0\.5"):
        hung((lambda t: 0.1 * (float(t) > 0.5), lambda t: 0.0, lambda t: 0.0)).build().simulate(1.0)
