"""The hoist: its rope at rest, the load applied at once, and what is known of both in closed form."""

from dataclasses import replace

import numpy as np
import pytest

from flexel.examples import hoist
from flexel.examples.hoist_data import HOIST
from flexel.examples.hoist_model import SHEAVES


@pytest.fixture(scope="module")
def applied() -> hoist.Results:
    """The first half second."""
    return hoist.simulate(end=0.5)


def test_the_rope_hangs_in_four_equal_falls_before_the_load_comes(applied: hoist.Results) -> None:
    start = applied.model.start
    T0 = HOIST.first_load * HOIST.weight / 4
    blocks = 2 * HOIST.sheave_mass * 9.81 / 4  # the movable sheaves hang on the rope, too
    assert applied.tension[0] == pytest.approx(T0 + blocks, rel=0.02)
    for name in SHEAVES:
        assert abs(start.force(f"{name} bearing.angle")) < 1e-3 * T0 * HOIST.pitch  # no sheave had to be held
    assert np.abs(start.v).max() == 0


def test_elements_can_follow_the_sheaves_and_are_as_many_as_in_the_paper() -> None:
    assert HOIST.elements >= 56
    assert hoist.free_length() / HOIST.elements <= HOIST.sheave_radius / 2


def test_a_load_applied_at_once_gives_the_dynamic_factor_of_its_damping(applied: hoist.Results) -> None:
    peak = applied.tension.max() / (HOIST.weight / 4)
    assert peak == pytest.approx(hoist.dynamic_factor(), rel=0.03)
    assert hoist.measured_frequency(applied) == pytest.approx(hoist.frequency_with_rope(), rel=0.02)


def test_energy_is_accounted_for(applied: hoist.Results) -> None:
    balance = applied.motion.energy_balance()
    moved = np.abs(balance["potential"] - balance["potential"][0]).max()
    assert np.abs(balance["error"]).max() < 0.02 * moved


def test_the_drums_speed_is_smooth_and_ends_at_its_value() -> None:
    t = np.linspace(9.9, 20.1, 2001)
    angle, rate, change = np.array([HOIST.angle(float(z)) for z in t]).T
    h = t[1] - t[0]
    assert np.gradient(angle, h)[1:-1] == pytest.approx(rate[1:-1], abs=1e-6)
    assert np.gradient(rate, h)[1:-1] == pytest.approx(change[1:-1], abs=1e-5)
    assert rate[-1] == HOIST.speed


def test_the_factor_of_hoisting_is_that_of_the_sheaves_losses() -> None:
    assert hoist.hoisting_factor(replace(HOIST, efficiency=1.0)) == 1.0
    assert hoist.hoisting_factor() == pytest.approx(1.29, abs=0.005)  # the paper: about 1.3
