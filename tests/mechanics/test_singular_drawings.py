"""A drawing at a dead centre, or flat, is said to be one; too many constraints are still said to be too many."""

import numpy as np
import pytest

import flexel as fx


def parallelogram(angle: float, bars: int) -> fx.Model:
    """Two points joined to the ground by bars of 1 m at an angle, and to each other, perhaps more than once."""
    m = fx.Model()
    across = np.array([np.cos(angle), np.sin(angle)])
    for name, x in (("A", 0.0), ("B", 2.0)):
        m.point(f"{name}0", (x, 0), fixed=True)
        m.truss(f"bar {name}", f"{name}0", m.point(name, np.array([x, 0]) + across))
        m.point_mass(f"mass {name}", name, 1.0)
    for i in range(bars):
        m.truss(f"coupler {i}", "A", "B")
    return m


def test_a_flat_parallelogram_is_drawn_in_a_singular_position() -> None:
    with pytest.raises(
        fx.ConstraintError, match=r"drawing is in a singular position.*'coupler 0.elongation'.*a little aside"
    ):
        parallelogram(0.0, 1).build()
    said = str(parallelogram(0.0, 1).check())  # it advised to release a bar
    assert "a little aside" in said and "release" not in said and "over-constrained" not in said
    assert len(parallelogram(0.3, 1).build().dynamic) == 1


@pytest.mark.parametrize("angle", [0.3, 1.0])
def test_two_couplers_are_one_too_many(angle: float) -> None:
    with pytest.raises(fx.ConstraintError, match=r"over-constrained: 1 rigid.*release one of them"):
        parallelogram(angle, 2).build()
    said = str(parallelogram(angle, 2).check())
    assert "release" in said and "over-constrained" in said


def test_a_slider_that_is_driven_from_its_dead_centre() -> None:
    m = fx.Model()
    O, C, S = (m.point(n, x) for n, x in (("O", (0, 0)), ("C", (1, 0)), ("S", (3, 0))))
    m.fix("O", "S.y")
    m.beam("crank", O, m.angle("turn"), C, mass_per_length=1.0)
    m.truss("rod", C, S)
    m.prescribe("S.x", lambda t: 3 - t)
    with pytest.raises(
        fx.ConstraintError, match=r"singular position.*'rod.elongation', 'crank.along', 'S.x'"
    ):
        m.build()
