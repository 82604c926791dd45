"""Load paths of shallow arches: many folds, and other equilibria close by."""

import numpy as np
import pytest
from coarse import COARSE_MESH

import flexel as fx
from flexel.mechanics.arclength import Arcs
from flexel.statics import load_path

ELEMENTS = 16
SPAN, EI = 1.0, 1.0


def arch(rise: float, slenderness: float, moment: float) -> fx.System:
    """A hinged arch in the shape of half a sine; a small moment at its crown keeps curves from crossing."""
    m = fx.Model(gravity=(0.0, 0.0))
    for i, x in enumerate(np.linspace(0, SPAN, ELEMENTS + 1)):
        m.point(f"p{i}", (x, rise * np.sin(np.pi * x / SPAN)), fixed=i in (0, ELEMENTS))
        m.angle(f"a{i}")
    for i in range(ELEMENTS):
        m.beam(f"b{i}", f"p{i}", f"a{i}", f"p{i + 1}", f"a{i + 1}", EA=EI * slenderness**2, EIz=EI)
    middle = ELEMENTS // 2
    m.load(f"p{middle}.y", lambda t: -t)
    m.load(f"a{middle}.angle", lambda t: -moment * t)
    return m.build()


def limits(path: fx.Motion) -> np.ndarray:
    """Loads at the folds, in order."""
    t = path.t
    turns = np.diff(t)[:-1] * np.diff(t)[1:] < 0
    return t[1:-1][turns]


@COARSE_MESH
@pytest.mark.parametrize(
    ("rise", "slenderness", "load"), [(0.05, 1000.0, 360.0), (0.1, 300.0, 660.0), (0.05, 300.0, 360.0)]
)
def test_a_path_passes_every_fold_in_long_steps_as_in_short_ones(
    rise: float, slenderness: float, load: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Reference: the same equations in steps ten times shorter (own)."""
    s = arch(rise, slenderness, 0.01)
    path = s.static_path(t_end=load)
    assert path.message == ""
    monkeypatch.setattr(load_path, "ARCS", Arcs(first=0.05, largest=0.05, smallest=1e-7, steps=6000))
    fine = s.static_path(t_end=load)
    assert limits(path).size == limits(fine).size
    np.testing.assert_allclose(limits(path), limits(fine), rtol=0, atol=0.02 * np.abs(limits(fine)).max())
    assert path["p8.y"][-1] == pytest.approx(fine["p8.y"][-1], rel=1e-9)


@COARSE_MESH
@pytest.mark.long
def test_a_symmetric_arch_stays_symmetric_where_curves_cross() -> None:
    path = arch(0.1, 300.0, 0.0).static_path(t_end=660.0)
    assert path.message == ""
    np.testing.assert_allclose(path["p4.y"], path["p12.y"], atol=1e-9)
    skew = arch(0.1, 300.0, 1e-9).static_path(t_end=660.0)
    assert skew["p8.y"][-1] == pytest.approx(path["p8.y"][-1], rel=1e-6)  # with the same end, by another way
