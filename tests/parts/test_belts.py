"""Closed belts: how they are laid, and the torque that they carry with tension, creep and slip of their closed form."""

from typing import Any

import numpy as np
import pytest

import flexel as fx
from flexel.examples import rope_belts as belts

R, SPAN = 0.1, 0.5


def pulleys(space: bool = False, radii: tuple[float, float] = (R, R)) -> fx.Model:
    m, size = fx.Model(), 3 if space else 2
    for name, x, radius in (("A", 0.0, radii[0]), ("B", SPAN, radii[1])):
        m.point(name, (x, 0.0, 0.0)[:size], fixed=True)
        (m.frame if space else m.angle)(f"F{name}", fixed=True)
        groove = fx.RoundGroove(1.05e-3) if space else None
        m.sheave(f"S{name}", name, f"F{name}", radius=radius - 1e-3, groove=groove)
    return m


def laid(m: fx.Model, path: Any = ("SA", "SB"), n: int = 48, **change: Any) -> fx.Rope:
    given: dict[str, Any] = {"EA": 1e4, "EI": 1e-4, "mass_per_length": 0.1, "radius": 1e-3}
    return m.rope("belt", list(path), n, closed=True, **({"contact": fx.Contact(1e12)} | given | change))


@pytest.mark.parametrize("space", [False, True])
def test_a_belt_is_as_long_as_its_path_and_has_no_ends(space: bool) -> None:
    m = pulleys(space)
    rope = laid(m, tension=50.0)
    assert (len(rope.elements), len(rope.points), len(rope.slopes), rope.s.size) == (48, 48, 48, 49)
    assert rope.path.length == pytest.approx(2 * SPAN + 2 * np.pi * R, rel=1e-5)
    assert rope.path.wraps == pytest.approx({"SA": np.pi, "SB": np.pi})
    state = m.build().equilibrium()
    assert rope.tension(state)[1] == pytest.approx(np.full(3 * 48, 50.0), rel=0.02)
    assert rope.wrap_angle([state, state], "SA") == pytest.approx([np.pi, np.pi], abs=0.25)
    assert rope.resultant(state, "SB") == pytest.approx(50 * np.pi, rel=0.03)


def test_an_open_and_a_crossed_belt_have_the_lengths_of_their_closed_forms() -> None:
    radii = (0.1, 0.05)
    for senses, offset in (((1, 1), radii[0] - radii[1]), ((1, -1), radii[0] + radii[1])):
        m = pulleys(radii=radii)
        rope = laid(m, [("SA", senses[0]), ("SB", senses[1])])
        beta = np.arcsin(offset / SPAN)
        arcs = (np.pi + 2 * beta) * radii[0] + (np.pi + 2 * beta * senses[1] * -1) * radii[1]
        assert rope.path.length == pytest.approx(2 * SPAN * np.cos(beta) + arcs, rel=1e-12)


def test_a_length_gives_the_tension() -> None:
    length = (2 * SPAN + 2 * np.pi * R) / 1.002
    assert laid(pulleys(), length=length, contact=fx.Contact(1e17)).tension0 == pytest.approx(20.0, rel=1e-4)


def test_a_belt_around_three_pulleys_touches_all() -> None:
    m = pulleys()
    m.point("C", (SPAN / 2, 0.4), fixed=True)
    m.sheave("SC", "C", "FA", radius=0.05)
    rope = laid(m, ["SA", "SB", "SC"], 60)
    assert sum(rope.path.wraps.values()) == pytest.approx(2 * np.pi)
    m.build()


@pytest.mark.parametrize(
    ("path", "message"),
    [
        (["SA"], "not a list of two or more"),
        (["SA", "A"], "'A'"),
        (["SA", "nothing"], "nothing"),
        (["SA", "SA"], "overlap"),
    ],
)
def test_paths_that_cannot_be_closed_are_refused(path: list[str], message: str) -> None:
    m = pulleys()
    with pytest.raises(fx.ModelError, match=message):
        laid(m, path)


def test_a_closed_belt_has_no_dead_turns() -> None:
    with pytest.raises(fx.ModelError, match="turns 1 need a drum"):
        laid(pulleys(), turns=1)


@pytest.mark.long
def test_creep_and_tensions_of_a_coarse_belt_are_those_of_the_closed_form_to_its_order() -> None:
    creep, tension = belts.errors(belts.MESHES[0])
    assert creep < 0.1
    assert tension < 0.01


@pytest.mark.campaign
def test_creep_tension_torque_and_slip_are_those_of_the_closed_form() -> None:
    rows = belts.rows()
    assert [f"{row.name}: {row.error}" for row in rows if not row.ok] == []
    orders = [row.more["order"] for row in rows if "order" in row.more]
    assert min(orders) > 1.5
