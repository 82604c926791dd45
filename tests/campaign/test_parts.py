"""The campaign's own pieces: the oracle against closed forms, what a wrong twin leads to, printed programs."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

import flexel as fx
from campaign import parts_bodies
from campaign.algebra import about
from campaign.case import Case, declared, drawn_nodes
from campaign.changes import Change, changed
from campaign.families import FAMILIES
from campaign.grammar_ropes import AXLE, FLANKS, HARDER, RADIUS, STIFFNESS, TENSIONS, THICK
from campaign.oracle import Oracle, along, jacobian
from campaign.parts import twins_of
from campaign.run import run
from campaign.verdict import judged
from flexel.base.arrays import Array

LENGTH, MASS = 0.8, 2.0
PENDULUM = Case(
    "pendulum",
    (0.0, -9.81),
    (
        declared("point", "O", (0.0, 0.0), fixed=True),
        declared("point", "P", (LENGTH, 0.0)),
        declared("truss", "rod", "O", "P"),
        declared("point_mass", "m", "P", MASS),
    ),
    rates=(1.5,),
)


def oracle(case: Case) -> Oracle:
    return Oracle(drawn_nodes(case), twins_of(case))


def test_the_oracle_has_the_accelerations_and_the_reaction_of_a_pendulum() -> None:
    speed = 1.5
    x, v = oracle(PENDULUM).drawn, np.array([0.0, 0.0, 0.0, speed])
    answer = oracle(PENDULUM).solve(x, v, {}, 0.0)
    assert answer.a == pytest.approx({"P.x": -(speed**2) / LENGTH, "P.y": -9.81}, rel=1e-12)
    assert answer.reactions == pytest.approx({"O.x": -MASS * speed**2 / LENGTH, "O.y": 0.0}, abs=1e-12)
    assert (answer.dynamic, answer.kinematic, answer.redundant) == (1, 0, 0)


def test_the_oracle_counts_redundant_constraints_and_knows_singular_positions() -> None:
    twice = PENDULUM.having(declared("truss", "again", "O", "P"))
    still = np.zeros(4)
    assert oracle(twice).solve(oracle(twice).drawn, still, {}, 0.0).redundant == 1
    places = {"O": (0.0, 0.0), "A": (1.0, 0.0), "B": (2.0, 1e-7)}
    parts = [
        declared("point", name, x, **({} if name == "A" else {"fixed": True})) for name, x in places.items()
    ]
    flat = (
        *parts,
        declared("truss", "a", "O", "A"),
        declared("truss", "b", "A", "B"),
        declared("point_mass", "m", "A", 1.0),
    )
    case = Case("flat", (0.0, 0.0), flat)
    assert oracle(case).solve(oracle(case).drawn, np.zeros(6), {}, 0.0).singular


def test_the_oracle_sees_that_a_flat_position_is_passed() -> None:
    """A parallelogram is flat where its cranks are parallel to its coupler, at the angle 0.1; others are not."""
    crank, coupler = 0.4, np.array([np.cos(0.1), np.sin(0.1)])
    parts = [
        declared("point", "O", (0.0, 0.0), fixed=True),
        declared("point", "D", tuple(coupler), fixed=True),
    ]
    parts += [declared("point", name, (crank, 0.0)) for name in "BC"]
    rods = [declared("truss", "".join(ends), *ends) for ends in ("OB", "DC", "BC")]
    own = oracle(Case("parallelogram", (0.0, 0.0), (*parts, *rods)))

    def at(angle: float) -> Array:
        B = crank * np.array([np.cos(angle), np.sin(angle)])
        return np.concatenate([np.zeros(2), coupler, B, B + coupler])

    assert own.passes_flat(at(0.05), at(0.15)) and own.passes_flat(at(0.15), at(0.05))
    assert not own.passes_flat(at(-0.2), at(0.05)) and not own.passes_flat(at(0.15), at(0.5))


def test_derivatives_in_the_complex_plane_have_the_error_of_rounding() -> None:
    x, v = np.array([0.3, -0.8]), np.array([2.0, 1.0])

    def f(y: Array) -> Array:
        return np.array([np.sin(y[0]) * np.exp(y[1])])

    slope = np.array([[np.cos(0.3), np.sin(0.3)]]) * np.exp(-0.8)
    np.testing.assert_allclose(jacobian(f, x), slope, rtol=1e-15)
    first, second = along(lambda y, t: f(y) + t**2, x, v, 0.5)
    np.testing.assert_allclose(first, slope @ v + 1.0, rtol=1e-12)
    curve = (-np.sin(0.3) * 4 + 2 * np.cos(0.3) * 2 + np.sin(0.3)) * np.exp(-0.8) + 2
    np.testing.assert_allclose(second, [curve], rtol=1e-11)


def test_a_wrong_twin_fails_and_is_shrunk_to_a_short_program(monkeypatch: pytest.MonkeyPatch) -> None:
    """Accelerations differ; what flexel compares with itself still holds."""

    def heavier(self: Any, x: Array) -> Array:
        return -1.001 * self.mass * (self.gravity[0] * x[0] + self.gravity[1] * x[1])

    monkeypatch.setattr(parts_bodies.PointMass, "potential", heavier)
    failed = {name for name, _, _ in judged(PENDULUM).failures}
    assert "accelerations" in failed and not failed & {"turned and shifted", "linearization", "mirrored"}
    found = run(20, 1, {"planar truss": FAMILIES["planar truss"]})
    (failure,) = [failure for failure in found["failures"] if failure["property"] == "accelerations"]
    assert failure["program"].count("m.point_mass") == 1


def test_a_refused_model_fails_unless_it_is_singular() -> None:
    broken = PENDULUM.having(declared("independent", "P.x"))  # the extreme of P.x: the rod is drawn along x
    assert [name for name, _, _ in judged(broken).failures] == ["build"]


def test_a_refused_position_fails_unless_the_model_turns_back_before_it(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    beyond = replace(PENDULUM, offsets=(2 * LENGTH,))
    assert not judged(beyond).failures
    assert judged(beyond).skipped == {"build": "refused by flexel, and beyond where the model turns back"}
    within, state_at = replace(PENDULUM, offsets=(0.5 * LENGTH,)), fx.System.state_at

    def refusing(self: fx.System, values: Any, *others: Any) -> fx.State:
        if max(map(abs, values.values())) > 0.4 * LENGTH:
            raise fx.PositionError("refused")
        return state_at(self, values, *others)

    assert not judged(within).failures
    monkeypatch.setattr(fx.System, "state_at", refusing)
    assert [name for name, _, _ in judged(within).failures] == ["build"]


@pytest.mark.parametrize("case", [PENDULUM.having(declared("load", "P", (fx.Harmonic(3.0, 2.0), 1.0)))])
def test_the_printed_program_makes_the_model(case: Case) -> None:
    names: dict[str, Any] = {}
    exec(case.program(), names)
    start = case.start(case.model().build())
    np.testing.assert_array_equal(names["state"].a, start.a)
    assert start.rate("P.y") != 0


def test_a_change_and_its_opposite_leave_a_model_as_it_was() -> None:
    turn = about(np.array([0.0, 0.0, 1.0]), 0.4)
    there = Change(turn=tuple(turn.tolist()), length=2.0, mass=3.0, time=0.5)
    back = Change(turn=tuple((turn * (1, -1, -1, -1)).tolist()), length=0.5, mass=1 / 3, time=2.0)
    again = changed(changed(PENDULUM, there), back)
    np.testing.assert_allclose(again.gravity, PENDULUM.gravity, atol=1e-12)
    np.testing.assert_allclose(again.parts[1].position, (LENGTH, 0.0), atol=1e-12)
    assert again.parts[3].mass == pytest.approx(MASS)


def test_the_softest_contact_carries_the_tightest_rope() -> None:
    """`Model.rope` refuses a rope that is pressed into a sheave by half the radius."""
    for exponent in (1.0, 1.5, 2.0):
        least = min(FLANKS), max(TENSIONS), min(STIFFNESS) * (HARDER if exponent > 1.5 else 1.0)
        m = fx.Model(gravity=(0, 0, -9.81))
        m.sheave(
            "sheave",
            m.point("C", (0, 0, 0), fixed=True),
            m.frame("S"),
            radius=RADIUS,
            axle=AXLE,
            groove=fx.VGroove(least[0]),
        )
        m.point("A", (-RADIUS, 0, -0.3)), m.point("B", (RADIUS, 0, -0.3))
        contact = fx.Contact(least[2], exponent=exponent)
        options = {"contact": contact, "radius": THICK, "tension": least[1]}
        assert m.rope(
            "rope", ["A", ("sheave", 1), "B"], 8, EA=200, EI=0.05, mass_per_length=0.3, **options
        ).contacts
