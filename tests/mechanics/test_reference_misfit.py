"""Drawings that contradict rigid conditions are said at `build`, with what is moved; what is meant is not."""

import warnings

import numpy as np
import pytest

import flexel as fx


def wheel(height: float, size: float = 1.0) -> fx.Model:
    """A wheel of radius 0.4 whose hub is drawn at a height, all lengths times `size`."""
    m = fx.Model(gravity=(0, 0, -9.81))
    m.point("hub", (0, 0, height * size))
    m.frame("rim")
    m.point("contact", (0, 0, 0))
    m.wheel("w", "hub", "rim", "contact", radius=0.4 * size, axle=(0, 1, 0))
    m.body("tyre", "hub", "rim", mass=2.0, inertia=np.eye(3) * size**2)
    return m


@pytest.mark.parametrize("size", [1e-3, 1.0, 1e3])
def test_a_hub_drawn_too_high_is_named_with_its_way(size: float) -> None:
    with pytest.warns(fx.AssemblyWarning, match="'w.radius' is .* the assembly moves 'hub.z' by") as said:
        system = wheel(0.9, size).build()
    assert f"by {-0.5 * size:.4g} m" in str(said[0].message)
    assert system.at_rest["hub.z"] == pytest.approx(0.4 * size, rel=1e-9)


def test_the_warning_points_at_the_line_that_builds() -> None:
    with pytest.warns(fx.AssemblyWarning) as said:
        wheel(0.9).build()
    assert said[0].filename == __file__


@pytest.mark.parametrize(("off", "warned"), [(1e-8, False), (1e-5, True)])
def test_rounded_decimals_count_as_exact(off: float, warned: bool) -> None:
    with warnings.catch_warnings(record=True) as said:
        warnings.simplefilter("always")
        wheel(0.4 + off).build()
    assert [warning.category for warning in said] == [fx.AssemblyWarning] * warned


def four_bar() -> fx.Model:
    m = fx.Model()
    m.point("O", (0, 0), fixed=True)
    m.point("A", (0, 0.1))
    m.point("B", (0.4, 0.25))
    m.point("C", (0.45, 0), fixed=True)
    for name, ends in {"crank": "OA", "coupler": "AB", "rocker": "CB"}.items():
        m.angle(name)
        m.beam(f"{name} bar", ends[0], name, ends[1], mass_per_length=1)
    return m


def test_motions_by_initial_values_and_prescribed_ones_are_meant() -> None:
    """Warnings are errors here."""
    m = four_bar()
    m.independent("crank.angle")
    m.initial("crank.angle", 0.3)
    assert m.build().at_rest["A.x"] == pytest.approx(-0.1 * np.sin(0.3))
    m = four_bar()
    m.prescribe("crank.angle", lambda t: 0.3 + t)
    assert m.build().at_rest["A.x"] == pytest.approx(-0.1 * np.sin(0.3))


def test_only_what_the_drawing_causes_is_reported_beside_initial_values() -> None:
    m = wheel(0.5)
    m.initial("contact.x", 3.0)
    with pytest.warns(fx.AssemblyWarning) as said:
        m.build()
    assert "'hub.z' by -0.1 m" in str(said[0].message)
    assert "contact.x" not in str(said[0].message)
