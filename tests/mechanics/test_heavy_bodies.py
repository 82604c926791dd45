"""A light body joined to a much heavier one: its inertia is not lost by rounding."""

from collections.abc import Callable

import numpy as np
import pytest

import flexel as fx

FORCE = 3.0  # [m/s²] times the mass of the light body


def joined(heavy: float, light: float) -> fx.Model:
    """Two free bodies on a pin at the centre of the heavy one, with a force across the arm of 1 m of the light one."""
    m = fx.Model(gravity=(0, -9.81))
    m.rigid_body("a", (0, 0), mass=heavy, inertia=heavy)
    m.rigid_body("b", (1, 0), mass=light, inertia=light)
    m.revolute("j", "a", "b", at=(0, 0))
    m.load("b.y", FORCE * light)
    return m


def four_bodies(heavy: float, light: float) -> fx.Model:
    """The same beside a second pair of a heavy and a light body."""
    m = joined(heavy, light)
    m.rigid_body("c", (3, 0), mass=heavy, inertia=heavy)
    m.rigid_body("d", (4, 0), mass=light, inertia=light)
    m.revolute("k", "c", "d", at=(3, 0))
    return m


@pytest.mark.parametrize(
    ("heavy", "light"), [(1e20, 1e3), (1e25, 1.0), (1.0, 1e-20), (1e12, 1.0), (1e9, 1.0)]
)
@pytest.mark.parametrize("model", [joined, four_bodies])
def test_a_light_arm_turns_about_a_heavy_body(
    model: Callable[[float, float], fx.Model], heavy: float, light: float
) -> None:
    """Closed form: the arm's moment of inertia is twice its mass times the square of its length; the pin gives way."""
    s = model(heavy, light).build()
    expected = FORCE / (2.0 + light / heavy)
    assert s.initial.acceleration("b_frame.angle") == pytest.approx(expected, rel=1e-6)
    alone = (
        np.diag(np.linalg.cholesky(s.linearize(s.initial).M)).min() ** 2
    )  # the arm's inertia, the rest free
    assert alone == pytest.approx(light * (2.0 - light / (heavy + light)), rel=1e-6)


def test_coordinates_of_the_light_body_are_refused_with_the_remedy() -> None:
    m = joined(1e20, 1e3)
    m.independent("b.x", "b.y", "b_frame.angle", "j.angle")
    said = r"largest .e\+20.*lost in rounding errors of the largest.*coordinates of the heaviest bodies"
    with pytest.raises(fx.DynamicsError, match=said):
        _ = m.build().initial


@pytest.mark.parametrize("ratio", [1e20, 1e12, 1e3])
def test_a_light_arm_swings_on_a_heavy_body(ratio: float) -> None:
    """Closed form: without gravity the angular momentum about the mass centre keeps the arm's angular velocity."""
    m = fx.Model()
    m.rigid_body("a", (0, 0, 0), mass=ratio, inertia=(ratio, ratio, ratio))
    m.rigid_body("b", (1, 0, 0), mass=1.0, inertia=(1.0, 1.0, 1.0))
    m.revolute("j", "a", "b", at=(0, 0, 0), axis=(0, 0, 1))
    m.initial("j.angle", rate=1.0)
    motion = m.build().simulate(1.0, method="DOP853")
    assert motion["j.angle"][-1] == pytest.approx(1.0, abs=1e-8)
