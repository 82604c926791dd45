"""Beams that are folded back within one element: their deformations are those of a straight one, and they are named."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

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
        fx.RangeWarning, match=r"'b\d' is bent by 180°.* 100 % too small; use 12 elements in place of"
    ) as caught:
        rest = column(elements, factor).equilibrium(stable=True)
    assert len(caught) == 1
    places = np.array([rest.position(f"P{i}") for i in range(elements + 1)])
    steps = np.diff(places, axis=0)  # all elements lie in line, and some are folded back
    assert np.allclose(np.abs(steps), [1 / elements, 0.0], rtol=0, atol=0.01 / elements)
    assert np.any(steps[:, 0] < 0)


def end_of_rod(P: float) -> float:
    """Of the extensible elastica: EI theta'' = -P (1 + strain) sin theta, from its free end."""

    def clamped(end: float) -> tuple[float, float]:
        """Return the angle at the clamp, and the distance of the end from it, for an angle at the end."""

        def rates(_: float, y: np.ndarray) -> list[float]:
            stretch = 1 - P * np.cos(y[0]) / EA
            return [y[1], -P * stretch * np.sin(y[0]), stretch * np.cos(y[0])]

        y = solve_ivp(rates, (1, 0), (end, 0.0, 0.0), rtol=1e-11, atol=1e-13).y[:, -1]
        return float(y[0]), -float(y[2])

    return clamped(brentq(lambda end: clamped(end)[0], 2.5, np.pi - 1e-6))[1]


@pytest.mark.parametrize(("elements", "factor"), [(8, 12), (4, 5)])
def test_the_elements_that_the_warning_asks_for_find_the_elastica(elements: int, factor: float) -> None:
    """Beams at the clamp are still bent by 8°, and their moments 0.4 % too small."""
    count = 12 * elements
    rest = column(count, factor).equilibrium(stable=True)
    assert rest[f"P{count}.x"] == pytest.approx(end_of_rod(factor * np.pi**2 / 4), abs=1.5e-3)
