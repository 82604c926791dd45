"""Beams that are folded back within one element: their deformations are those of a straight one, and they are named."""

import numpy as np
import pytest
from scipy.optimize import brentq
from scipy.special import ellipe, ellipk

import flexel as fx

EA = 1e4  # [N]


def column(elements: int, factor: float) -> fx.System:
    """A cantilever column of length, stiffness and buckling load / (π²/4) one, under a multiple of that load."""
    m = fx.Model()
    for i in range(elements + 1):
        m.point(f"P{i}", (i / elements, 0), fixed=i == 0)
        m.angle(f"R{i}", fixed=i == 0)
    for i in range(elements):
        m.beam(f"b{i}", f"P{i}", f"R{i}", f"P{i + 1}", f"R{i + 1}", EA=EA, EIz=1.0)
    m.load(f"P{elements}.x", -factor * np.pi**2 / 4)
    return m.build()


@pytest.mark.parametrize(("elements", "factor"), [(8, 12), (4, 5)])
def test_an_equilibrium_with_a_folded_element_is_named(elements: int, factor: float) -> None:
    """The deformations of an element that is turned by half a turn vanish, and its equilibrium looks stable."""
    with pytest.warns(
        fx.RangeWarning, match=r"'b\d' is folded back, by 180°.*use 12 elements in place of"
    ) as caught:
        rest = column(elements, factor).equilibrium(stable=True)
    assert len(caught) == 1
    assert rest[f"P{elements}.x"] == pytest.approx(-1.0, abs=0.01)


@pytest.mark.parametrize(("elements", "factor"), [(8, 12), (4, 5)])
def test_the_elements_that_the_warning_asks_for_find_the_elastica(elements: int, factor: float) -> None:
    """Its end, by complete elliptic integrals: K(k) = π/2 √factor, x = 2 E(k)/K(k) - 1 (Euler 1744)."""
    K = np.pi / 2 * np.sqrt(factor)
    m = brentq(lambda m: ellipk(m) - K, 0.1, 1 - 1e-12)
    count = 12 * elements
    rest = column(count, factor).equilibrium(stable=True)
    shortened = factor * np.pi**2 / 4 / EA  # along its axis, at most
    assert rest[f"P{count}.x"] == pytest.approx(2 * ellipe(m) / K - 1, abs=shortened + 2e-4)
