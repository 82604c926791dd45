"""Functions of time that vary quickly for a short time, and loads that take a plain number."""

import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from scipy.interpolate import PchipInterpolator

import flexel as fx
from flexel.base.time_functions import Harmonic, TimeFunction, as_function
from flexel.integration.time_scales import TimeScales

METHODS = {"DOP853": 1e-7, "Radau": 1e-7, "generalized-alpha": 2e-4, "auto": 1e-7}


def pushed(load: Any) -> fx.System:
    """A mass of 10 kg at rest, and a load on it."""
    m = fx.Model(gravity=(0, 0))
    m.point("P", (0, 0))
    m.point_mass("mass", "P", 10.0)
    m.load("P.x", load)
    return m.build()


@pytest.mark.parametrize("width", [3e-3, 3e-4])
@pytest.mark.parametrize("method", METHODS)
def test_a_smooth_pulse_gives_its_whole_momentum(method: str, width: float) -> None:
    """100 N for some milliseconds within 8 s: its integral is a closed form."""
    system = pushed(lambda t: 100 * np.exp(-(((t - 7) / width) ** 2)))
    found = system.simulate(8.0, samples=3, method=method).rate("P.x")[-1]
    assert found == pytest.approx(100 * width * np.sqrt(np.pi) / 10, rel=METHODS[method])


@pytest.mark.parametrize("method", METHODS)
def test_a_bump_of_a_base_leaves_a_vibration(method: str) -> None:
    """Its amplitude is ω times the Fourier transform of the bump at ω, a closed form."""
    height, width, omega = 0.1, 0.01, 20.0
    m = fx.Model(gravity=(0, 0))
    m.point("base", (0, 0))
    m.fix("base.y")
    m.point_mass("mass", m.point("P", (1, 0)), 2.0)
    m.fix("P.y")
    m.truss("spring", "base", "P")
    m.spring("spring.elongation", 2.0 * omega**2)
    m.prescribe("base.x", lambda t: height * np.exp(-(((t - 5) / width) ** 2)))
    end = m.build().simulate(6.0, samples=3, method=method)[-1]
    amplitude = math.hypot(end["P.x"] - 1, end.rate("P.x") / omega)
    expected = omega * height * width * math.sqrt(math.pi) * math.exp(-((omega * width / 2) ** 2))
    assert amplitude == pytest.approx(expected, rel=10 * METHODS[method])


TABLE = PchipInterpolator([0.0, 1.0, 2.0], [1.0, 3.0, 1.0])
PLAIN: dict[str, tuple[Callable[[float], float], float]] = {  # the load, and its integral over two seconds
    "math.exp": (lambda t: math.exp(-t), 1 - math.exp(-2)),
    "float": (lambda t: float(t) ** 2, 8 / 3),
    "condition": (lambda t: 1.0 if float(t) < 0.5 else 3.0, 5.0),
    "interpolator": (lambda t: float(TABLE(float(t))), float(TABLE.integrate(0, 2))),
    "list": (lambda t: [1.0, 4.0, 9.0][int(t)], 5.0),
}


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("kind", PLAIN)
def test_a_load_may_take_a_plain_number(kind: str, method: str) -> None:
    """It needs no derivatives; where it jumps is then not known, and steps are short there."""
    load, momentum = PLAIN[kind]
    found = pushed(load).simulate(2.0, samples=3, method=method).rate("P.x")[-1]
    assert found == pytest.approx(momentum / 10, rel=METHODS[method])


def test_a_load_that_takes_a_plain_number_works_in_statics() -> None:
    m = fx.Model(gravity=(0, 0))
    m.point_mass("mass", m.point("P", (0, 0)), 1.0)
    m.fix("P.y")
    m.spring("P.x", 4.0)
    m.load("P.x", lambda t: math.sin(t))
    system = m.build()
    assert system.equilibrium(t=0.5)["P.x"] == pytest.approx(math.sin(0.5) / 4, rel=1e-12)
    path = system.static_path(t_end=1.5)
    assert path["P.x"] == pytest.approx(np.sin(path.t) / 4, rel=1e-9)


def test_a_function_is_not_asked_for_more_than_the_motion_needs() -> None:
    """One that fails later may be given for a motion that an event ends before."""

    def load(t: float) -> float:
        if float(t) > 0.5:
            raise ValueError("no value")
        return 1.0

    end = fx.Event("end", lambda state: state.t - 0.3, terminal=True)
    motion = pushed(load).simulate(1.0, samples=3, method="DOP853", max_step=0.05, events=[end])
    assert motion.t[-1] == pytest.approx(0.3)
    with pytest.raises(fx.ModelError, match=r"load on 'P\.x': the function failed at t = 0\.5"):
        pushed(load).simulate(1.0, samples=3, method="DOP853", max_step=0.05)


def longest(function: Any, t: float, duration: float = 10.0) -> float:
    """The longest step [s] from a time of a motion."""
    own: TimeFunction = as_function(function, "test")
    return TimeScales([own], 0.0, duration).until(t) - t


def test_steps_follow_vibrations_and_nothing_slower() -> None:
    for omega in (2.0, 20.0, 200.0):
        assert 1.5 < omega * longest(lambda t, w=omega: np.sin(w * t), 4.0) < 6.0, omega
    for slow in (
        lambda t: 3.0 + 0 * t,
        lambda t: 1e9 + 1e-8 * np.sin(t),
        lambda t: t**3,
        Harmonic(1.0, 200.0),
    ):
        assert longest(slow, 4.0) > 1.0


def test_steps_end_before_a_pulse_and_are_short_within_it() -> None:
    def pulse(t: Any) -> Any:
        return 5.0 * t + np.exp(-(((t - 7) / 0.01) ** 2))

    assert 2.9 < longest(pulse, 4.0) < 3.0
    assert 0.01 < longest(pulse, 6.99) < 0.05
    assert longest(pulse, 7.2) > 0.5


def test_knots_that_are_known_shorten_no_step() -> None:
    """Steps end there anyhow."""
    times, values = np.linspace(0, 10, 41), np.tile([0.0, 1.0], 21)[:41]
    assert longest(lambda t: np.interp(t, times, values), 4.01) > 1.0
    assert longest(lambda t: np.where((t > 4.5) & (t < 4.6), 1.0, 0.0), 4.0) > 1.0


def amplitude(**options: Any) -> float:
    """Of a mass on a spring after a pulse of its base, a cubic that waves around zero before, but not at knots."""
    times = np.linspace(0, 20, 2001)
    pulse = np.where(abs(times - 7.05) < 0.05, 0.1 * np.cos((times - 7.05) * np.pi / 0.1) ** 4, 0.0)
    m = fx.Model()
    for name, x in (("A", 0.0), ("B", 1.0)):
        m.point(name, (x, 0))
        m.fix(f"{name}.y")
    m.point_mass("b", "B", 1.0)
    m.truss("t", "A", "B")
    m.spring("t.elongation", 100.0)
    m.prescribe("A.x", fx.Table(times, pulse))
    end = m.build().simulate(20.0, samples=2, **options)[-1]
    return math.hypot(end["B.x"] - 1, end.rate("B.x") / 10)


AFTER_A_PULSE = 0.0371264463385  # by DOP853 and Radau at tight tolerances


@pytest.mark.parametrize("method", METHODS)
def test_a_table_that_begins_to_wave_between_its_knots_is_followed(method: str) -> None:
    """Generalized-alpha stopped at 7 s: it had expected nothing to move."""
    assert amplitude(method=method) == pytest.approx(AFTER_A_PULSE, rel=METHODS[method])


def test_knots_end_no_motion_at_a_tight_tolerance() -> None:
    """DOP853 stopped at 7.05 s, since it evaluated rates beside the knots."""
    found = amplitude(method="DOP853", rtol=1e-12, atol=1e-14)
    assert found == pytest.approx(AFTER_A_PULSE, rel=1e-10)
