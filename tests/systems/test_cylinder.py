"""A hydraulic cylinder that moves a boom, driven and free."""

import numpy as np
import pytest

from flexel.base.errors import PositionError
from flexel.examples import cylinder as example


def test_every_quantity_is_within_its_tolerance() -> None:
    report = example.reproduce()
    assert {row.name: row.error for row in report.quantities if not row.ok} == {}
    assert len(report.quantities) == 8


def test_the_closed_forms_are_those_of_the_triangle() -> None:
    """Derivatives of the angle by the elongation, and of its own rates by time, against differences."""
    h, e = 1e-5, np.linspace(-0.5, 0.4, 7)
    length = np.sqrt(2.0) + e
    assert np.hypot(np.cos(example.angle(e)), np.sin(example.angle(e)) + 1) == pytest.approx(
        length, rel=1e-14
    )
    slope, bend = example.lever(e)
    assert (example.angle(e + h) - example.angle(e - h)) / (2 * h) == pytest.approx(slope, rel=1e-8)
    assert (example.lever(e + h)[0] - example.lever(e - h)[0]) / (2 * h) == pytest.approx(bend, rel=1e-8)
    t = np.linspace(0.1, 1.1, 5)
    first, second = example.stroke_rates(t)
    assert (example.stroke(t + h) - example.stroke(t - h)) / (2 * h) == pytest.approx(first, rel=1e-8)
    assert (example.stroke_rates(t + h)[0] - example.stroke_rates(t - h)[0]) / (2 * h) == pytest.approx(
        second, rel=1e-8
    )


def test_the_elongation_is_the_only_degree_of_freedom() -> None:
    assert example.falling().dynamic == ("cylinder.elongation",)
    assert example.driven().dynamic == ()


def test_a_cylinder_cannot_be_driven_farther_than_the_boom_reaches() -> None:
    m = example.crane()
    m.prescribe("cylinder.elongation", lambda t: 0.5 * t)  # the boom points straight up at e = 2 - √2
    with pytest.raises(PositionError, match=r"cylinder\.elongation|hinge|position"):
        m.build().simulate(2.0)
