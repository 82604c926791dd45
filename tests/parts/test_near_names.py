"""What a message suggests for a wrong name: what was probably meant, and nothing rather than a poor match."""

from typing import Any

import pytest
from mistakes import drawing, pendulum, plane

import flexel as fx
from flexel.base.near_names import near_names

KNOWN = ["crank.angle", "crank.bend1", "crank.bend2", "rod.angle", "A.x", "A.y", "B.x", "front.lateral"]
NEAR = {
    "crnk.angle": ["crank.angle"],
    "crank.angel": ["crank.angle"],
    "Crank.Angle": ["crank.angle"],
    "crank.bend": ["crank.bend1", "crank.bend2"],
    "crank_angle": ["crank.angle"],
    "frnt.lateal": ["front.lateral"],
    "crank": ["crank.angle", "crank.bend1", "crank.bend2"],
    "crnk": ["crank.angle", "crank.bend1", "crank.bend2"],
    "lateral": ["front.lateral"],
    "A.q": [],
    "C.x": [],
    "rear.lateral": [],
    "crank.lateral": [],
    "wheel": [],
    "Q": [],
    "": [],
}


@pytest.mark.parametrize(("name", "near"), NEAR.items())
def test_a_suggestion_is_what_was_meant_or_there_is_none(name: str, near: list[str]) -> None:
    assert near_names(name, [*KNOWN, *KNOWN]) == near


def touching() -> fx.Model:
    """A ball above a floor."""
    m = fx.Model(gravity=(0, 0, -9.81))
    m.point("O", (0, 0, 0), fixed=True)
    m.frame("R0", fixed=True)
    m.point("P", (0, 0, 0.1))
    m.frame("R")
    m.body("ball", "P", "R", mass=1.0, inertia=(1, 1, 1))
    m.plane("floor", "O", "R0")
    m.contact("touch", "P", "floor", fx.Contact(1e5, friction=0.3), frame="R", radius=0.1)
    return m


def rolling() -> fx.Model:
    """A wheel on a road, whose angular velocity nothing measures."""
    m = drawing()
    m.point("hub", (0, 0, 0.3))
    m.point("contact", (0, 0, 0))
    m.body("disc", "hub", "R1", mass=1.0, inertia=(1, 1, 1))
    m.wheel("front", "hub", "R1", "contact", radius=0.3, axle=(0, 1, 0))
    return m


def measured() -> fx.Model:
    """The same with the angular velocity in body axes."""
    m = rolling()
    m.angular_velocity("R1", body_axes=True)
    return m


SLIPS: dict[str, tuple[Any, str, str]] = {
    "contact": (touching, "tuch.gap", "did you mean touch.gap?"),
    "slip of a contact": (touching, "touch.slip", "'touch' has touch.gap, touch.x, touch.y"),
    "surface": (touching, "floor.gap", "known: touch.gap"),
    "slip of a wheel": (rolling, "front.lateal", "did you mean front.lateral?"),
    "angular velocity": (rolling, "R1.wx", "declare m.angular_velocity('R1') first"),
    "its slip": (rolling, "R1.omega.wy", "which makes the slips R1.omega.wx, R1.omega.wy, R1.omega.wz"),
    "in body axes": (rolling, "R1.body_omega.wy", "m.angular_velocity('R1', body_axes=True) first"),
    "measured in body axes": (measured, "R1.wx", "the components R1.body_omega.wx, R1.body_omega.wy"),
    "global, measured in body axes": (measured, "R1.omega.wx", "declared so far are R1.body_omega.wx,"),
    "angle": (plane, "R1.omega", "the angular velocity of 'R1' is the rate of 'R1.angle'"),
}


@pytest.mark.parametrize(("make", "name", "words"), SLIPS.values(), ids=SLIPS)
def test_the_wrong_name_of_a_slip_is_refused_with_the_right_one(make: Any, name: str, words: str) -> None:
    m = make()
    for call in (m.release, lambda name: m.initial(name, rate=1.0), lambda name: m.spring(name, damping=1.0)):
        with pytest.raises(fx.ModelError) as error:
            call(name)
        assert f"unknown name '{name}'; " in str(error.value)
        assert words in str(error.value)


def test_results_say_the_same() -> None:
    s = pendulum().build()
    for ask in (s.initial.rate, s.initial.force, s.simulate(0.01, samples=3).rate):
        with pytest.raises(fx.ModelError, match=r"declare m.angular_velocity\('R1'\) first"):
            ask("R1.omega.wx")


FIXED = {
    "pivot.angel": r"fix: unknown name 'pivot\.angel'; did you mean pivot\.angle\?",
    "pivot.bend1": r"'pivot' is an element; hold its deformations with m\.rigid\('pivot\.bend1'\)",
    "pivt": "fix: unknown node 'pivt'; known: O, A, R0, R1",
    "R1.lamda2": "node 'R1' has no coordinate 'lamda2'; it has lambda0, lambda1, lambda2, lambda3",
}


@pytest.mark.parametrize(("name", "words"), FIXED.items())
def test_what_cannot_be_fixed_is_refused_and_nothing_is_fixed(name: str, words: str) -> None:
    m = pendulum()
    with pytest.raises(fx.ModelError, match=words):
        m.fix("A.x", name)
    assert not m.nodes["A"].fixed.any()
    m.fix("A.x", "A.z")
    assert m.nodes["A"].fixed.tolist() == [True, False, True]


def test_a_slip_has_no_initial_value() -> None:
    m = rolling()
    with pytest.raises(
        fx.ModelError, match=r"initial 'front\.lateral': a slip has only a rate; give rate= alone"
    ):
        m.initial("front.lateral", 1.0)


def test_many_known_names_are_cut_off_visibly() -> None:
    m = fx.Model()
    for i in range(20):
        m.point(f"P{i}", (i, 0), fixed=True)
    with pytest.raises(fx.ModelError, match=r"known: P0, .*, P11, … \(20 in all\)"):
        m.fix("crank")
