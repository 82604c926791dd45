"""Beams that are folded back within one element: their deformations are those of a straight one, and they are named."""

import numpy as np
import pytest

import flexel as fx

SHORTENED = -0.632  # end of the column under twelve times its buckling load, by elliptic integrals (elastica)


def column(elements: int, factor: float, **options: str) -> fx.System:
    """A cantilever column of length, stiffness and buckling load / (π²/4) one, under a multiple of that load."""
    m = fx.Model()
    for i in range(elements + 1):
        m.point(f"P{i}", (i / elements, 0), fixed=i == 0)
        m.angle(f"R{i}", fixed=i == 0)
    for i in range(elements):
        m.beam(f"b{i}", f"P{i}", f"R{i}", f"P{i + 1}", f"R{i + 1}", EA=1e4, EIz=1.0, **options)
    m.load(f"P{elements}.x", -factor * np.pi**2 / 4)
    return m.build()


@pytest.mark.parametrize(("elements", "factor"), [(8, 12), (4, 5)])
def test_an_equilibrium_with_a_folded_element_is_named(elements: int, factor: float) -> None:
    """The deformations of an element that is turned by half a turn vanish, and its equilibrium looks stable."""
    with pytest.warns(fx.RangeWarning, match=r"'b\d' is folded back.*turned by \d+°.*use \d+ elements in place of"):
        rest = column(elements, factor).equilibrium(stable=True)
    assert rest[f"P{elements}.x"] == pytest.approx(-1.0, abs=0.01)
