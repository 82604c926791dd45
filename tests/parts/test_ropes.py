"""Ropes over sheaves: results, initial configuration, and errors."""

from typing import Any

import numpy as np
import pytest

import flexel as fx
from flexel.parts.rope import Rope

R, THIN, T = 0.1, 1e-3, 50.0
CONTACT = fx.Contact(1e10, dissipation=10.0)


def over_a_sheave(
    n: int = 28, turning: float = 0.0, contact: fx.Contact = CONTACT, **change: Any
) -> tuple[fx.Model, Rope]:
    """A weightless rope under tension over half a sheave, its ends held; the sheave turns at a rate."""
    m = fx.Model()
    m.point("C", (0, 0), fixed=True)
    m.angle("G", fixed=True)
    m.angle("F")
    m.hinge("axle", "G", "F")
    m.prescribe("axle.angle", lambda t: turning * t)
    m.sheave("S", "C", "F", radius=R)
    A, B = m.point("A", (-R - THIN, -0.4)), m.point("B", (R + THIN, -0.4))
    m.fix(A, B)
    given: dict[str, Any] = {
        "contact": contact, "radius": THIN, "tension": T, "EA": 1e5, "EI": 1e-5, "mass_per_length": 0.01,
        "damping": 1e-3,
    }  # fmt: skip
    return m, m.rope("rope", [A, "S", B], n, **(given | change))


@pytest.fixture(scope="module")
def resting() -> tuple[fx.State, Rope]:
    m, rope = over_a_sheave()
    return m.build().equilibrium(), rope


def test_taut_rope_is_laid_nearly_in_equilibrium(resting: tuple[fx.State, Rope]) -> None:
    """Points move by less than a thousandth of an element from where they were laid, and the tension stays."""
    state, rope = resting
    moved = [np.linalg.norm(state.position(point.name) - point.x0) for point in rope.points]
    assert max(moved) < 1e-3 * float(np.diff(rope.s).max())
    assert rope.tension(state)[1].mean() == pytest.approx(T, rel=0.02)


def test_tension_of_a_smooth_rope_is_uniform(resting: tuple[fx.State, Rope]) -> None:
    """At every point that is reported, on and off the sheave."""
    state, rope = resting
    s, tension = rope.tension(state)
    assert s.shape == tension.shape == (3 * 28,)
    assert np.all(np.diff(s) > 0)
    assert tension[[0, -1]] == pytest.approx(tension[0], rel=1e-6)
    assert tension == pytest.approx(np.full(s.size, tension[0]), rel=0.01)


def test_contact_forces_hold_both_ends(resting: tuple[fx.State, Rope]) -> None:
    """They are T/R per length: their sum is T times the wrap angle, and the support of the axle carries 2 T."""
    state, rope = resting
    s, N = rope.contact_force(state, "S")
    assert s.shape == N.shape == (5 * 28,)
    assert N.min() >= 0
    end = rope.tension(state)[1][0]
    assert rope.resultant(state, "S") == pytest.approx(np.pi * end, rel=0.01)
    assert np.hypot(state.force("C.x"), state.force("C.y")) == pytest.approx(2 * end, rel=1e-6)


def test_wrap_angle_is_that_of_the_path(resting: tuple[fx.State, Rope]) -> None:
    state, rope = resting
    element = float(np.diff(rope.s).max()) / R
    assert rope.path.wraps["S"] == pytest.approx(np.pi, abs=1e-3)
    assert rope.wrap_angle(state, "S") == pytest.approx(np.pi, abs=element / 2)


def test_slip_is_the_speed_of_the_sheave_under_a_rope_that_rests() -> None:
    """Both are compared at the rope's centre line, where its friction acts too."""
    m, rope = over_a_sheave(turning=2.0)
    state = m.build().initial
    s, slip = rope.slip(state, "S")
    touching = rope.contact_force(state, "S")[1] > 0
    assert touching.sum() > 20
    assert abs(slip[touching]) == pytest.approx(np.full(touching.sum(), 2.0 * (R + THIN)), rel=1e-3)
    assert np.all(slip[~touching] == 0)
    assert s.shape == slip.shape


def test_results_over_several_states_have_a_row_for_each(resting: tuple[fx.State, Rope]) -> None:
    state, rope = resting
    states = [state, state, state]
    assert rope.tension(states)[1].shape == (3, 3 * 28)
    assert rope.contact_force(states, "S")[1].shape == (3, 5 * 28)
    assert rope.resultant(states, "S").shape == (3,)


def test_bristles_hold_a_rope_that_is_pulled_less_than_the_capstan_allows() -> None:
    """Ends that are pulled by 50 and 60 N on a drum at rest (allowed: up to 50 exp(0.3 π) = 128 N) come to rest."""
    m = fx.Model()
    m.point("C", (0, 0), fixed=True)
    m.angle("F", fixed=True)
    m.sheave("S", "C", "F", radius=R)
    A, B = m.point("A", (-R - THIN, -0.2)), m.point("B", (R + THIN, -0.2))
    contact = fx.Contact(1e10, friction=0.3, bristle_stiffness=3e3, bristle_damping=1.0, dissipation=10.0)
    m.rope("rope", [A, "S", B], 16, contact=contact, radius=THIN, tension=T, EA=1e5, EI=1e-5,
           mass_per_length=0.01, damping=1e-3)  # fmt: skip
    m.load(A, (0, -T))
    m.load(B, (0, -1.2 * T))
    motion = m.build().simulate(
        0.6, method="generalized-alpha", samples=7, rtol=1e-2, atol=1e-4, spectral_radius=0.0, progress=False
    )
    assert motion["A.y"][-1] == pytest.approx(motion["A.y"][-3], abs=1e-6)
    assert abs(motion["A.y"][-1] + 0.2) < 1e-3


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"n": 6}, "cannot follow a sheave of radius 0.1 m; it needs at least 12 elements, or 23 for"),
        ({"n": 0}, "number of elements 0"),
        ({"EA": -1.0}, "EA -1 is not positive"),
        ({"EI": -1.0}, "EI -1 is negative"),
        ({"EA": None}, "EA or a section is missing"),
        ({"tension": None, "length": 2.0}, "% longer than its path, so it hangs slack"),
        ({"length": 1.0}, "both length and tension"),
        ({"tension": -1.0}, "tension -1 is negative"),
        ({"radius": -1.0}, "radius -1 is negative"),
        ({"also": ["T"]}, "unknown sheave or plane 'T'"),
    ],
)
def test_wrong_ropes_are_refused_by_name(change: dict[str, Any], message: str) -> None:
    with pytest.raises(fx.ModelError, match=message):
        over_a_sheave(**change)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"stiffness": -1.0}, "stiffness -1 is not positive"),
        ({"exponent": 0.5}, "exponent 0.5 is below 1"),
        ({"friction": -0.1}, "friction -0.1 is negative"),
        ({"points": 0}, "number of points 0"),
        ({"bristle_stiffness": 1.0}, "friction 0 is not positive"),
    ],
)
def test_wrong_contacts_are_refused_by_name(change: dict[str, Any], message: str) -> None:
    with pytest.raises(fx.ModelError, match=message):
        fx.Contact(**({"stiffness": 1.0} | change))


def test_path_through_a_sheave_is_refused_by_name() -> None:
    m = fx.Model()
    still = m.angle("still", fixed=True)
    for name, x, y in (("P", 0, 0.3), ("Q", 1, 0.3), ("between", 0.5, 0.4)):
        m.sheave(name, m.point(name, (x, y), fixed=True), still, radius=R)
    A, B = m.point("A", (-R, -1)), m.point("B", (1 + R, -1))
    with pytest.raises(fx.ModelError, match="the rope would run through 'between'"):
        m.rope(
            "rope",
            [A, ("P", -1), ("Q", -1), ("between", -1), B],
            60,
            contact=CONTACT,
            radius=THIN,
            EA=1.0,
            EI=1.0,
        )


def test_unknown_sheave_of_a_result_is_named(resting: tuple[fx.State, Rope]) -> None:
    state, rope = resting
    with pytest.raises(fx.ModelError, match="rope 'rope': no contact with 'T'; it has S"):
        rope.contact_force(state, "T")


@pytest.mark.long
def test_motion_that_cannot_go_on_is_kept_and_can_be_started_from_again() -> None:
    """Ends that are drawn apart without bound: the axle's load grows beyond all numbers; the motion stays."""
    m, _ = over_a_sheave()
    m.load("rope_p10.x", lambda t: 1e-3 / (0.01 - t) ** 2)
    system = m.build()
    with pytest.raises(fx.DynamicsError, match="cannot continue") as caught:
        system.simulate(0.02, method="generalized-alpha", samples=21, progress=False)
    motion = caught.value.motion
    assert 0.005 < motion.t[-1] < 0.0101
    assert np.all(np.isfinite(motion[-1].x))
    again = system.simulate(1e-4, method="generalized-alpha", start=motion[3], samples=3, progress=False)
    assert again.t[0] == motion[3].t
    assert again.t[-1] == pytest.approx(motion[3].t + 1e-4)
