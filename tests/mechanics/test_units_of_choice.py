"""Which degrees of freedom are chosen does not depend on the unit of length."""

from collections.abc import Callable

import numpy as np
import pytest

import flexel as fx

METRE = {"mm": 1e3, "m": 1.0, "km": 1e-3}


def chain(metre: float) -> fx.Model:
    """Three bodies that are joined by hinges and slide on the ground."""
    m = fx.Model()
    places = metre * np.array([(0.0, 0.0), (0.7, 0.2), (1.1, 0.9), (1.6, 0.4)])
    points = [m.point(f"P{i}", tuple(place)) for i, place in enumerate(places)]
    for i, angle in enumerate([m.angle(f"R{i}") for i in range(3)]):
        m.body_point(f"link{i}", points[i], angle, points[i + 1])
        m.body(f"body{i}", points[i], angle, mass=1.0 + i, inertia=0.1 * metre**2)
        if i:
            m.hinge(f"h{i}", f"R{i - 1}", angle)
    m.fix("P0.y")
    return m


def rope(metre: float) -> fx.Model:
    """A hanging rope of three elements, with curvatures per length."""
    m = fx.Model()
    nodes = [(m.point(f"P{i}", (0, 0, -0.4 * i * metre)), m.slope(f"d{i}", (0, 0, -1))) for i in range(4)]
    m.fix("P0")
    for i, (one, other) in enumerate(zip(nodes, nodes[1:], strict=False)):
        given = {"EA": 5e3 * metre, "EI": 2.0 * metre**3, "mass_per_length": 0.3 / metre}
        m.cable(f"c{i}", *one, *other, 0.4 * metre, **given)
    return m


def arms(metre: float) -> fx.Model:
    """A chain of 120 arms in space, a large model, whose degrees of freedom are chosen part by part."""
    m, rng = fx.Model(), np.random.default_rng(3)
    m.point("P0", (0, 0, 0), fixed=True)
    m.frame("R0", fixed=True)
    for i in range(1, 121):
        m.frame(f"R{i}")
        m.point(f"P{i}", tuple(0.1 * metre * i * np.array([1.0, 0.1 * (i % 3), 0.05 * (i % 2)])))
        m.hinge(f"h{i}", f"R{i - 1}", f"R{i}", axis=tuple(rng.normal(size=3)))
        m.body_point(f"a{i}", f"P{i - 1}", f"R{i}", f"P{i}")
        m.body(f"b{i}", f"P{i}", f"R{i}", mass=1.0, inertia=(0.01 * metre**2,) * 3)
    return m


@pytest.mark.parametrize("model", [chain, rope, arms])
def test_the_choice_is_the_same_in_any_unit(model: Callable[[float], fx.Model]) -> None:
    found = {unit: model(metre).build().dynamic for unit, metre in METRE.items()}
    assert found["mm"] == found["m"] == found["km"]
