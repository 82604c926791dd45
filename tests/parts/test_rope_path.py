"""Paths of taut ropes: tangents, senses and lengths against closed forms."""

import numpy as np
import pytest

import flexel as fx
from flexel.parts.rope_path import PathCircle, taut_path


def circle(name: str, x: float, y: float, radius: float, sense: int = 0, turns: float = 0.0) -> PathCircle:
    return PathCircle(name, np.array([x, y]), radius, sense, turns)


def test_open_belt_has_the_length_of_the_closed_form() -> None:
    """A rope that arrives along one side of a belt, and leaves the second pulley at a right angle to that."""
    r1, r2, c = 0.3, 0.1, 1.0
    places = [
        circle("A", -1.0, -r1, 0),
        circle("P", 0, 0, r1, 1),
        circle("Q", c, 0, r2, 1),
        circle("B", c + r2, 2.0, 0),
    ]
    path = taut_path("belt", places)
    beta, straight = np.arcsin((r1 - r2) / c), np.sqrt(c**2 - (r1 - r2) ** 2)
    assert path.wraps == pytest.approx({"P": beta, "Q": np.pi / 2 - beta}, rel=1e-12)
    assert path.parts[2].length == pytest.approx(straight, rel=1e-14)
    assert path.length == pytest.approx(1 + r1 * beta + straight + r2 * (np.pi / 2 - beta) + 2, rel=1e-14)
    assert path.at(np.array([path.length]))[0][0] == pytest.approx([c + r2, 2.0], abs=1e-14)


def test_crossed_belt_has_the_length_of_the_closed_form() -> None:
    r1, r2, c = 0.3, 0.1, 1.0
    places = [
        circle("A", -1.0, -r1, 0),
        circle("P", 0, 0, r1, 1),
        circle("Q", c, 0, r2, -1),
        circle("B", 2.0, r2, 0),
    ]
    path = taut_path("belt", places)
    straights = [part.length for part in path.parts if part.sense == 0]
    assert straights[1] == pytest.approx(np.sqrt(c**2 - (r1 + r2) ** 2), rel=1e-14)
    beta = np.arcsin((r1 + r2) / c)
    assert path.wraps == pytest.approx({"P": beta, "Q": beta}, rel=1e-12)


def test_path_is_smooth_and_keeps_the_radius() -> None:
    """Tangents are continuous, have unit length, and are the derivative of the places."""
    places = [
        circle("A", -1, -2, 0),
        circle("P", 0, 0, 0.3),
        circle("Q", 1.2, 0.2, 0.2),
        circle("B", 2, 1.5, 0),
    ]
    path = taut_path("rope", places)
    s = np.linspace(0, path.length, 4001)
    x, tangent = path.at(s)
    assert np.linalg.norm(tangent, axis=1) == pytest.approx(np.ones(s.size), abs=1e-14)
    assert np.abs(np.diff(tangent, axis=0)).max() < 1.01 * (s[1] - s[0]) / 0.2
    middle = (tangent[1:] + tangent[:-1]) / 2
    jump = (s[1] - s[0]) / (8 * 0.2)  # error of the mean of two tangents where the curvature jumps to 1/0.2
    assert np.diff(x, axis=0) / (s[1] - s[0]) == pytest.approx(middle, abs=jump)
    for name, begin, end in path.spans():
        centre = next(place for place in places if place.name == name)
        there = path.at(np.linspace(begin, end, 9))[0]
        assert np.linalg.norm(there - centre.centre, axis=1) == pytest.approx(
            np.full(9, centre.radius), rel=1e-12
        )


def test_senses_that_are_not_given_are_those_of_the_shortest_path() -> None:
    def length(first: int, second: int) -> float:
        places = [circle("A", -1, 0, 0), circle("P", 0, 0.5, 0.2, first), circle("Q", 1, -0.5, 0.2, second)]
        return taut_path("rope", [*places, circle("B", 2, 0, 0)]).length

    lengths = [length(p, q) for p in (1, -1) for q in (1, -1)]
    assert length(0, 0) == min(lengths)
    assert max(lengths) > 1.1 * min(lengths)


def test_dead_turns_lie_on_the_drum_before_the_first_straight_part() -> None:
    path = taut_path("rope", [circle("drum", 0, 0, 0.5, -1, turns=2.5), circle("B", 0.5, -3, 0)])
    assert path.wraps == pytest.approx({"drum": 5 * np.pi})
    assert path.length == pytest.approx(5 * np.pi * 0.5 + 3)


def test_sheave_that_the_rope_only_touches_has_no_arc() -> None:
    path = taut_path("rope", [circle("A", -1, 0.2, 0), circle("P", 0, 0, 0.2, -1), circle("B", 1, 0.2, 0)])
    assert path.length == pytest.approx(2.0, rel=1e-12)


@pytest.mark.parametrize(
    ("places", "message"),
    [
        ([circle("A", 0, 0, 0)], "has 1 entry"),
        ([circle("P", 0, 0, 0.5, 1), circle("Q", 0.6, 0, 0.4, -1)], "'P' and 'Q' overlap"),
        (
            [
                circle("A", -1, 0, 0),
                circle("P", 0, 1, 0.2, -1),
                circle("Q", 0, -1, 0.2, 1),
                circle("S", 0, 0, 0.3, 1),
            ],
            "'S' overlap|run through 'S'",
        ),
        (
            [circle("A", -1, 0, 0), *(circle(f"S{i}", i, 0, 0.1) for i in range(13))],
            "the sense of wrap of 13",
        ),
    ],
)
def test_paths_that_cannot_be_are_refused_by_name(places: list[PathCircle], message: str) -> None:
    with pytest.raises(fx.ModelError, match=message):
        taut_path("rope", places)
