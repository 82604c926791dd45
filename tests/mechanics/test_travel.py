"""Positions far from the start: whatever the constraints admit is reached, on the same branch."""

import math

import numpy as np
import pytest

import flexel as fx


def test_a_free_mass_goes_anywhere() -> None:
    m = fx.Model()
    m.point("a", (0, 0))
    m.point_mass("k", "a", 1.0)
    s = m.build()
    for distance in (100.0, -1e6):
        assert s.state_at({"a.x": distance})["a.x"] == pytest.approx(distance, rel=1e-14)


@pytest.mark.parametrize("length", [6.0, 1000.0])
def test_a_bar_follows_the_end_that_is_moved(length: float) -> None:
    """A bar of one metre, one end given: the other end keeps its distance and its side."""
    m = fx.Model()
    m.point("a", (0, 0))
    m.point("b", (1, 0))
    m.truss("bar", "a", "b")
    m.rigid("bar.elongation")
    for end in "ab":
        m.point_mass(f"mass {end}", end, 1.0)
    m.independent("a.x", "a.y", "b.y")
    state = m.build().state_at({"a.x": length})
    assert [state[name] for name in ("b.x", "b.y")] == pytest.approx([length + 1, 0], abs=1e-12 * length)


def test_a_wheel_turns_by_many_radians() -> None:
    """Two hundred radians about its axle, and back: the frame is that of the angle without its whole turns."""
    m = fx.Model()
    m.point("hub", (0, 0, 0), fixed=True)
    m.frame("ground", fixed=True)
    m.frame("wheel")
    m.hinge("axle", "ground", "wheel", axis=(0, 0, 1))
    m.body("rim", "hub", "wheel", mass=1.0, inertia=(1.0, 1.0, 2.0))
    s = m.build()
    state = s.state_at({"axle.angle": 200.0})
    assert state["axle.angle"] == 200.0
    turned = 2 * math.atan2(state["wheel.lambda3"], state["wheel.lambda0"])
    assert math.cos(turned - 200.0) == pytest.approx(1.0, abs=1e-12)
    assert s.state_at({"axle.angle": 0.0}, start=state)["wheel.lambda3"] == pytest.approx(0.0, abs=1e-12)


def test_a_crank_of_a_four_bar_stays_on_its_branch() -> None:
    """Five turns of the crank bring the rocker back to where it was, not to its mirror image."""
    m = fx.Model()
    for name, place in (("O", (0, 0)), ("C", (3, 0))):
        m.point(name, place, fixed=True)
    m.point("A", (0, 1))
    m.point("B", (3, 2.5))
    m.angle("ground", fixed=True)
    m.angle("crank")
    m.hinge("shaft", "ground", "crank")
    m.beam("arm", "O", "crank", "A", rigid=True)
    for name, p, q in (("coupler", "A", "B"), ("rocker", "B", "C")):
        m.truss(name, p, q)
        m.rigid(f"{name}.elongation")
    m.point_mass("mass", "B", 1.0)
    m.point_mass("other", "A", 1.0)
    m.independent("shaft.angle")
    s = m.build()
    found = s.state_at({"shaft.angle": 10 * np.pi})
    assert [found[name] for name in ("B.x", "B.y")] == pytest.approx([3, 2.5], abs=1e-9)


def test_a_position_out_of_reach_is_named() -> None:
    m = fx.Model()
    m.point("O", (0, 0), fixed=True)
    m.point("a", (0.6, 0.8))
    m.truss("bar", "O", "a")
    m.rigid("bar.elongation")
    m.point_mass("mass", "a", 1.0)
    m.independent("a.x")
    with pytest.raises(
        fx.PositionError, match=r"cannot be reached.*'bar.elongation'|cannot be reached.*'a.x'"
    ):
        m.build().state_at({"a.x": 1.5})
