"""Prescribed motions that are given with their rates: rates that belong to another motion are refused."""

from collections.abc import Callable

import numpy as np
import pytest

import flexel as fx

Function = Callable[[float], float]


def driven(*triple: Function) -> fx.System:
    """A mass whose place is prescribed, and one that hangs on it by a spring."""
    m = fx.Model()
    P, Q = m.point("P", (0, 0)), m.point("Q", (5, 0))
    m.fix("P.y", "Q.y")
    m.prescribe("P.x", triple)
    m.truss("spring", P, Q, stiffness=1.0)
    m.point_mass("mass", Q, 1.0)
    return m.build()


def sine(omega: float) -> tuple[Function, Function, Function]:
    """A harmonic motion of 1 m with its rates."""
    return (
        lambda t: np.sin(omega * t),
        lambda t: omega * np.cos(omega * t),
        lambda t: -(omega**2) * np.sin(omega * t),
    )


@pytest.mark.parametrize("omega", [1e-3, 1.0, 1e3])
def test_rates_that_fit_are_accepted(omega: float) -> None:
    assert driven(*sine(omega)).simulate(5.0 / max(omega, 1.0), samples=3).t.size == 3


def test_smooth_rates_of_a_table_are_accepted() -> None:
    """Straight lines between values, with the rates of the smooth motion: 5 % off."""
    u, v, a = sine(1.0)
    t = np.linspace(-0.5, 5.5, 61)
    assert driven(lambda s: float(np.interp(s, t, np.sin(t))), v, a).simulate(5.0, samples=3).t.size == 3


@pytest.mark.parametrize(
    ("place", "wrong", "said"),
    [
        (1, lambda t: np.cos(t), r"'P\.x': the rate u' of its prescribed motion is .* differences give"),
        (1, lambda t: -2 * np.cos(2 * t), "the rate u'"),
        (1, lambda t: 0.0, "the rate u'"),
        (2, lambda t: 4 * np.sin(2 * t), "the second rate u''"),
        (2, lambda t: 0.0, "the second rate u''"),
    ],
)
@pytest.mark.parametrize("method", ["auto", "generalized-alpha"])
def test_rates_of_another_motion_are_refused(place: int, wrong: Function, said: str, method: str) -> None:
    """A factor that was forgotten, a wrong sign, no rate; before, the motion followed neither."""
    triple = list(sine(2.0))
    triple[place] = wrong
    system = driven(*triple)
    with pytest.raises(fx.ModelError, match=said):
        system.simulate(5.0, method=method)
