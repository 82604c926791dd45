"""The radius at which a rope touches is that of its section."""

from typing import Any

import pytest

import flexel as fx

WIRE: dict[str, Any] = {"section": fx.WireRope(0.02), "material": "wire rope", "tension": 10.0}


def over_a_sheave(**given: Any) -> fx.Rope:
    """A rope over the upper half of a planar sheave of radius 0.1."""
    m = fx.Model()
    m.sheave("S", m.point("C", (0, 0), fixed=True), m.angle("F", fixed=True), radius=0.1)
    A, B = m.point("A", (-0.11, -0.2)), m.point("B", (0.11, -0.2))
    return m.rope("r", [A, "S", B], 14, contact=fx.Contact(1e9), **given)


def test_the_radius_of_a_rope_is_that_of_its_section() -> None:
    rope = over_a_sheave(**WIRE)
    assert rope.radius == 0.01
    assert over_a_sheave(**WIRE, radius=0.01).radius == 0.01  # said twice, and the same
    bar = over_a_sheave(section=fx.Circle(0.02), material="steel", tension=10.0)
    assert bar.radius == 0.01


@pytest.mark.parametrize(
    ("given", "message"),
    [
        (
            {**WIRE, "radius": 0.02},
            "rope 'r': radius 0.02 m contradicts the radius of the rope's section, 0.01 m; leave",
        ),
        ({"EA": 1e6, "EI": 0.0}, "rope 'r': its radius is not known; give radius=…, or a section with"),
        ({**WIRE, "section": fx.Rectangle(0.02, 0.02)}, "rope 'r': its radius is not known"),
    ],
)
def test_a_radius_that_is_missing_or_contradicts_the_section_is_refused(
    given: dict[str, Any], message: str
) -> None:
    with pytest.raises(fx.ModelError, match=message):
        over_a_sheave(**given)


def test_a_line_of_cables_touches_at_the_radius_of_its_section() -> None:
    m = fx.Model()
    m.plane("floor", m.point("C", (0, 0), fixed=True), m.angle("F", fixed=True), (0, 1))
    section = {"section": fx.WireRope(0.02), "material": "wire rope"}
    line = m.cable_line("r", [(0, 0.5), (1, 0.5)], 2, **section)
    touching = m.rope_contact(line, "floor", fx.Contact(1e8, points=1))
    assert [m.instances[contact.element].parameters["rope_radius"][0] for contact in touching] == [0.01, 0.01]
    bare = m.cable_line("s", [(0, 0.7), (1, 0.7)], 2, EA=1.0, EI=0.0)
    with pytest.raises(fx.ModelError, match="contact of 's' with 'floor': its radius is not known"):
        m.rope_contact(bare, "floor", fx.Contact(1e8))
