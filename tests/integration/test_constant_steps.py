"""Constant steps of the generalized-alpha method: the same, whatever times are stored."""

from typing import Any

import numpy as np
import pytest
from mechanisms import slider, slider_crank

import flexel as fx

METHOD = "generalized-alpha"


def run(system: fx.System, duration: float, h: float, **options: Any) -> fx.Motion:
    return system.simulate(duration, method=METHOD, step=h, progress=False, **options)


@pytest.mark.parametrize("samples", [2, 7, 11, 101, 1001])
def test_the_steps_are_those_that_were_asked_for(samples: int) -> None:
    system = slider_crank("crank hinge.angle").build()
    motion = run(system, 0.5, 5e-3, samples=samples)
    assert motion.statistics["steps"] == 100
    assert motion.t == pytest.approx(np.linspace(0, 0.5, samples), abs=1e-15)
    end, few = motion[-1], run(system, 0.5, 5e-3, samples=2)[-1]
    assert end.x == pytest.approx(few.x, abs=1e-12)
    assert end.v == pytest.approx(few.v, abs=1e-10)


def test_a_duration_that_is_no_multiple_ends_with_a_shorter_step() -> None:
    motion = run(slider_crank("crank hinge.angle").build(), 0.1234, 5e-3, samples=5)
    assert motion.statistics["steps"] == 25
    assert motion.t[-1] == 0.1234


def test_states_between_steps_are_as_accurate_as_the_method() -> None:
    """Closed form of a vibration: the error between the steps is not larger than at their ends, and falls with h²."""
    m = slider(2.0)
    m.spring("strut.elongation", 200.0)
    system = m.build()
    start = system.state_at({"strut.elongation": 0.1})
    errors = []
    for h in (0.02, 0.01):
        motion = run(system, 1.0, h, samples=173, start=start, spectral_radius=1.0)
        assert motion.statistics["steps"] == round(1 / h)
        exact = 0.1 * np.cos(10 * motion.t)
        wrong = np.abs(motion["strut.elongation"] - exact)
        ends = run(system, 1.0, h, samples=round(1 / h) + 1, start=start, spectral_radius=1.0)
        at_ends = np.abs(ends["strut.elongation"] - 0.1 * np.cos(10 * ends.t))
        assert wrong.max() < 1.05 * at_ends.max()
        errors.append(wrong.max())
    assert errors[0] / errors[1] == pytest.approx(4.0, rel=0.05)


def test_the_energy_balance_is_that_of_the_steps_and_of_the_stored_states() -> None:
    m = slider(2.0)
    m.spring("strut.elongation", 200.0, 6.0)
    system = m.build()
    start = system.state_at({"strut.elongation": 0.1})
    many, few = (run(system, 1.0, 0.01, samples=n, start=start) for n in (357, 2))
    ends = [motion.energy_balance()["dissipated"][-1] for motion in (many, few)]
    assert ends[0] == pytest.approx(ends[1], rel=1e-12)
    balance = many.energy_balance()
    assert np.all(np.diff(balance["dissipated"]) > -1e-12)
    assert np.abs(balance["error"]).max() < 3e-3 * balance["dissipated"][-1]


def test_steps_end_at_a_knot_and_start_again_there() -> None:
    m = slider(2.0)
    m.spring("strut.elongation", 200.0, 6.0)
    m.load("A.x", fx.Table([0, 0.1234, 0.1234, 2], [0, 0, 5, 5], kind="linear"))
    system = m.build()
    ends = []
    for samples in (2, 9, 300):
        motion = run(system, 0.5, 0.01, samples=samples)
        assert motion.statistics["steps"] == 13 + 38
        ends.append(motion["strut.elongation"][-1])
    assert np.ptp(ends) < 1e-13
