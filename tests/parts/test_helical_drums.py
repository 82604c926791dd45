"""Drums with helical grooves: laying, winding, pressure, fleet angle and friction of a rope in them."""

from typing import Any

import numpy as np
import pytest

import flexel as fx
from flexel.base.arrays import Array
from flexel.base.quaternions import matrix
from flexel.examples import rope_drums as drums
from flexel.parts.rope import Rope

R, A, LEAD = (
    0.2,
    0.01,
    0.03,
)  # radius of the rope's centre line on the drum, radius of the rope, lead of the groove [m]
PITCH = LEAD / (2 * np.pi)
PULL = 1000.0  # [N]
ROPE: dict[str, Any] = {"EA": 1e7, "EI": 1e-3, "mass_per_length": 1e-3, "damping": 1e-3}
CONTACT = fx.Contact(1e11, friction=0.3, slip_speed=1e-3, dissipation=10.0)
Q = matrix(np.array([0.5, -0.1, 0.7, 0.5]) / 1.0)  # a rotation
SHIFT = np.array([3.0, -2.0, 5.0])


def drum(
    m: fx.Model,
    turned: Array | None = None,
    *,
    start: Any = (0, 1, 0),
    lead: float = LEAD,
    shift: Any = (0, 0, 0),
) -> None:
    """A drum "D" about x at the origin, that turns by the angle "axle.angle"; or turned, then shifted."""
    T = np.eye(3) if turned is None else turned
    m.point("C", shift, fixed=True)
    m.frame("G", fixed=True)
    m.frame("F")
    m.hinge("axle", "G", "F", axis=T[:, 0])
    m.body("drum", "C", "F", mass=1, inertia=(1, 1, 1))
    groove = fx.HelicalGroove(1.08 * A, lead=lead, start=T @ start)
    m.sheave("D", "C", "F", radius=R - A, axle=T[:, 0], groove=groove)


def pulled(
    n: int = 60,
    *,
    turns: float = 2.0,
    span: float = 2.0,
    held: bool = True,
    refine: float = 1.0,
    **given: Any,
) -> tuple[fx.System, Rope]:
    """A rope that hangs from the drum, pulled down at its end "P" by a force, or held there."""
    m = fx.Model()
    turned, shift = given.get("turned"), np.asarray(given.get("shift", (0, 0, 0)))
    T = np.eye(3) if turned is None else turned
    drum(m, **given)
    m.rigid("axle.angle")
    end = m.point("P", shift + T @ (0, R, -span), fixed=held)
    rope = m.rope(
        "rope",
        [("D", -1), end],
        n,
        turns=turns,
        contact=CONTACT,
        radius=A,
        tension=PULL,
        refine=refine,
        **ROPE,
    )
    if not held:
        m.load(end, T @ (0, 0, -PULL))
    return m.build(), rope


# -- laying ---------------------------------------------------------------------------------------


@pytest.mark.parametrize("start", [(0, 1, 0), (0, -1, 1)])
@pytest.mark.parametrize("lead", [LEAD, -LEAD])
def test_dead_turns_lie_side_by_side_in_the_groove(lead: float, start: Any) -> None:
    system, rope = pulled(80, turns=3.0, lead=lead, start=start)
    places = drums.places(system.initial, rope)
    wound = places[:, 1] < R
    moved = lead / (2 * np.pi) * (places[wound, 2] - places[wound, 2][0])
    assert wound.sum() > 40
    assert places[wound, 0] - places[wound, 0][0] == pytest.approx(moved, abs=1e-12)
    assert abs(places[wound, 0][0] - places[wound, 0][-1]) == pytest.approx(3 * LEAD, rel=0.05)
    s, N = rope.contact_force(system.initial, "D")
    middle = (s > 0.5) & (s < 3.0)
    load = PULL * R / (R**2 + PITCH**2)
    weights = np.array([p.weight for p in rope.contacts["D"]])
    assert (N / weights)[middle] == pytest.approx(load, rel=0.02)


def test_length_of_a_path_in_a_helical_groove_is_that_of_the_helix_and_the_slanted_span() -> None:
    rope = pulled(80, turns=2.5, start=(0, -1, 0))[1]
    arc, span = rope.path.parts
    deep = R - arc.radius
    off = LEAD / 2  # the groove crosses the plane on the other side
    assert arc.length == pytest.approx(2.5 * np.hypot(2 * np.pi * (R - deep), LEAD), rel=1e-12)
    assert span.length == pytest.approx(np.sqrt(4.0 + off**2), rel=1e-4)
    assert rope.path.wraps == pytest.approx({"D": 5 * np.pi})
    assert rope.path.length == pytest.approx(arc.length + span.length)


def test_sense_and_hand_decide_on_which_side_the_dead_turns_lie() -> None:
    found = {}
    for sense in (1, -1):
        for lead in (LEAD, -LEAD):
            m = fx.Model()
            drum(m, lead=lead, start=(0, -sense, 0))
            end = m.point("P", (0, -sense * R, -2.0))
            rope = m.rope("rope", [("D", sense), end], 60, turns=2, contact=CONTACT, radius=A, **ROPE)
            found[sense, lead] = rope.points[0].x0[0]
    assert found == pytest.approx({key: -key[0] * np.sign(key[1]) * 2 * LEAD for key in found}, abs=1e-6)


@pytest.mark.parametrize(
    "groove", [fx.RoundGroove(1.08 * A), fx.HelicalGroove(1.08 * A, lead=-LEAD, start=(0, 0, 1))]
)
def test_span_connects_the_grooves_of_drum_and_sheave(groove: fx.RoundGroove) -> None:
    """From a drum over a sheave to a point, and the places of all nodes fit the lengths between them."""
    m = fx.Model()
    drum(m, start=(0, -1, 1))
    m.point("S", (0, 2.0, 0.5), fixed=True)
    m.sheave("over", "S", "G", radius=R - A, axle=(1, 0, 0), groove=groove)
    end = m.point("P", (0, 2.0 + R, -1.0), fixed=True)
    rope = m.rope(
        "rope", [("D", -1), ("over", -1), end], 120, turns=2, contact=CONTACT, radius=A, tension=PULL, **ROPE
    )
    x = np.array([p.x0 for p in rope.points])
    chords = np.linalg.norm(np.diff(x, axis=0), axis=1)
    pieces = np.diff(rope.s) * (1 + PULL / ROPE["EA"])
    assert chords.max() <= pieces.max() * (1 + 1e-9)
    assert chords.min() > 0.99 * pieces.min()
    slopes = np.array([slope.x0 for slope in rope.slopes])
    along = np.sum(np.diff(x, axis=0) * (slopes[1:] + slopes[:-1]), axis=1) / (2 * chords)
    assert along == pytest.approx(1.0, rel=0.02)
    m.rigid("axle.angle")
    state = m.build().equilibrium()
    for name in ("D", "over"):
        pressed = rope.contact_force(state, name)[1]
        wrap = rope.path.wraps[name]
        assert pressed.sum() == pytest.approx(rope.tension(state)[1].mean() * wrap, rel=0.05)


# -- at rest --------------------------------------------------------------------------------------


def test_rope_at_rest_has_its_tension_everywhere_and_its_pressure_in_the_groove() -> None:
    system, rope = pulled(80, held=False)
    state = system.equilibrium()
    tension = rope.tension(state)[1]
    assert tension == pytest.approx(PULL, rel=0.01)
    s, N = rope.contact_force(state, "D")
    weights = np.array([p.weight for p in rope.contacts["D"]])
    middle = (s > 0.3) & (s < 2.2)
    assert (N / weights)[middle] == pytest.approx(PULL * R / (R**2 + PITCH**2), rel=0.02)
    assert float(rope.wrap_angle(state, "D")) == pytest.approx(4 * np.pi, abs=0.2)


def test_turned_and_shifted_model_gives_the_same() -> None:
    results = []
    for given in ({}, {"turned": Q, "shift": SHIFT}):
        system, rope = pulled(60, held=False, **given)
        state = system.equilibrium()
        places = np.array([state.position(p.name) for p in rope.points])
        if given:
            places = (places - SHIFT) @ Q
        results.append((rope.tension(state)[1], places))
    assert results[1][0] == pytest.approx(results[0][0], rel=1e-7)
    assert results[1][1] == pytest.approx(results[0][1], abs=1e-9)


@pytest.mark.parametrize("quarters", [1, -1])
def test_force_sideways_is_that_of_the_fleet_angle(quarters: int) -> None:
    """The groove holds the rope a quarter of the lead off the plane in which its end is held.

    Where the rope leaves the groove it lies aside of its middle: with a play p, the groove pushes back by T/(R p) per
    length and deviation, so that this decays within λ = sqrt(R p); for larger deviations it pushes a little more.
    """
    span, off, slope = 1.0, -quarters * LEAD / 4, -PITCH / R
    system, rope = pulled(120, turns=0.6, start=(0, 0, quarters), span=span, refine=10.0)
    state = system.equilibrium()
    aside = -(off / span + slope) / (1 / span + 1 / np.sqrt(R * 0.08 * A))
    fleet = (off + aside) / span * rope.tension(state)[1].mean()
    assert abs(aside) > 0.02 * abs(off)
    assert state.force("P.x") == pytest.approx(-fleet, rel=0.012)
    assert state.force("C.x") == pytest.approx(fleet, rel=0.012)


# -- friction -------------------------------------------------------------------------------------


@pytest.mark.parametrize("lead", [LEAD, -LEAD])
def test_rope_that_slides_in_a_helical_groove_has_eulers_ratio(lead: float) -> None:
    """Over an angle φ about the axle the rope turns by φ cos γ."""
    m, wrap, mu, pitch, straight = fx.Model(), 3 * np.pi, 0.2, lead / (2 * np.pi), 0.3
    drum(m, lead=lead)
    m.rigid("axle.angle")
    slant = float(np.hypot(R, pitch))

    def place(angle: float) -> Array:
        return np.array([pitch * angle, R * np.cos(angle), R * np.sin(angle)])

    def along(angle: float) -> Array:
        return np.array([pitch, -R * np.sin(angle), R * np.cos(angle)]) / slant

    total = 2 * straight + wrap * slant

    def curve(u: float) -> Array:
        s = u * total - straight
        angle = min(max(s / slant, 0.0), wrap)
        return place(angle) + (s - angle * slant) * along(angle)

    line = m.cable_line("rope", curve, 64, **ROPE | {"EA": 1e5, "EI": 1e-6, "mass_per_length": 0.01})
    contact = fx.Contact(1e9, friction=mu, slip_speed=1e-3, dissipation=10.0)
    m.rope_contact(line, "D", contact, radius=A)
    m.load(line.points[0], -along(0.0))
    end, u, speed, rise = line.points[-1], along(wrap), 0.5, 0.02
    for i, axis in enumerate("xyz"):
        x, v = float(end.x0[i]), speed * float(u[i])
        m.prescribe(f"{end.name}.{axis}", (
            lambda t, x=x, v=v: x + v * (t - rise * (1 - np.exp(-t / rise))),
            lambda t, v=v: v * (1 - np.exp(-t / rise)),
            lambda t, v=v: v / rise * np.exp(-t / rise),
        ))  # fmt: skip
    motion = m.build().simulate(
        0.2, method="generalized-alpha", step=1e-3, spectral_radius=0.0, samples=3, progress=False
    )
    pull = np.array([motion[-1].force(f"{end.name}.{axis}") for axis in "xyz"]) @ u
    assert pull == pytest.approx(np.exp(mu * wrap * R / slant), rel=0.01)


# -- bad input ------------------------------------------------------------------------------------


def test_bad_helical_grooves_are_refused() -> None:
    with pytest.raises(fx.ModelError, match="lead of its groove is zero"):
        drum(fx.Model(), lead=0.0)
    with pytest.raises(fx.ModelError, match=r"lead.*not a number|lead"):
        drum(fx.Model(), lead=float("nan"))
    with pytest.raises(fx.ModelError, match="parallel to the axis"):
        drum(fx.Model(), start=(1, 0, 0))
    with pytest.raises(TypeError, match="lead"):
        fx.HelicalGroove(0.0108)  # type: ignore[call-arg]


def test_lead_below_the_diameter_of_the_rope_is_refused() -> None:
    with pytest.raises(
        fx.ModelError, match=r"lead of 0.019 m is smaller than the diameter of the rope, 0.02 m"
    ):
        pulled(60, lead=0.019)
    with pytest.raises(fx.ModelError, match="turns would overlap"):
        pulled(60, lead=-0.019)


def test_belt_in_a_helical_groove_is_refused() -> None:
    m = fx.Model()
    drum(m)
    m.point("S", (0, 2.0, 0.5), fixed=True)
    m.sheave("other", "S", "G", radius=R - A, axle=(1, 0, 0))
    with pytest.raises(fx.ModelError, match="helical groove of 'D' would move it sideways"):
        m.rope("belt", ["D", "other"], 120, closed=True, contact=CONTACT, radius=A, **ROPE)


def test_drum_without_turns_is_refused() -> None:
    with pytest.raises(fx.ModelError, match="no turns in the helical groove of 'D'"):
        pulled(60, turns=0.0)


def test_fleet_angle_that_presses_the_rope_over_a_ridge_is_refused() -> None:
    with pytest.raises(fx.ModelError, match="whose ridges it touches"):
        pulled(60, lead=0.06, start=(0, -1, 0.1), span=0.05)
