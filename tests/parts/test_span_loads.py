"""Loads along beams and loads that follow a body: closed forms and exact tangents."""

import numpy as np
import pytest
from coarse import COARSE_MESH

import flexel as fx

EI, L = 2.0, 1.5


def cantilever(n: int, planar: bool, second_order: bool = True) -> fx.Model:
    m = fx.Model()
    at = (lambda x: (x, 0)) if planar else (lambda x: (x, 0, 0))
    stiffness = {"EA": 1e6, "EIz": EI} if planar else {"EA": 1e6, "EIy": EI, "EIz": EI, "GJ": EI}
    inertia = 0.01 if planar else (0.01, 0.01, 0.01)
    p = m.point("P0", at(0), fixed=True)
    r = m.angle("R0", fixed=True) if planar else m.frame("R0", fixed=True)
    for i in range(1, n + 1):
        q, s = m.point(f"P{i}", at(L * i / n)), m.angle(f"R{i}") if planar else m.frame(f"R{i}")
        m.beam(
            f"b{i}",
            p,
            r,
            q,
            s,
            mass_per_length=1.0,
            inertia_per_length=inertia,
            second_order=second_order,
            **stiffness,
        )
        p, r = q, s
    return m


@pytest.mark.parametrize("planar", [True, False])
@pytest.mark.parametrize("second_order", [True, False])
def test_one_element_under_an_even_load_bends_as_the_closed_form_says(
    planar: bool, second_order: bool
) -> None:
    q = 1e-5
    m = cantilever(1, planar, second_order)
    m.distributed_load("b1", (0, q) if planar else (0, q, 0))
    state = m.build().equilibrium()
    assert state["P1.y"] == pytest.approx(q * L**4 / (8 * EI), rel=1e-8)
    assert state.force("P0.y") == pytest.approx(-q * L, rel=1e-9)


@COARSE_MESH
def test_a_load_along_the_beam_equals_its_weight_in_any_motion() -> None:
    def motion(loaded: bool) -> fx.Motion:
        m = fx.Model(gravity=(0, 0, 0) if loaded else (0, 0, -9.81))
        ends = m.point("O", (0, 0, 0), fixed=True), m.point("A", (L, 0, 0))
        frames = m.frame("R0"), m.frame("R1")
        m.hinge("pivot", m.frame("G", fixed=True), frames[0], axis=(0, 1, 0))
        m.beam(
            "rod",
            ends[0],
            frames[0],
            ends[1],
            frames[1],
            EIy=EI,
            EIz=EI,
            GJ=1.0,
            EA=1e3,
            inertia_per_length=(0.01, 0.01, 0.01),
            mass_per_length=0.8,
        )
        if loaded:
            m.distributed_load("rod", (0, 0, lambda t: -0.8 * 9.81 + 0 * t))
        m.independent(
            "pivot.angle",
            *[f"rod.{mode}" for mode in ("elongation", "torsion", "bend1", "bend2", "bend3", "bend4")],
        )
        return m.build().simulate(0.3, samples=4)

    np.testing.assert_allclose(motion(True).position("A"), motion(False).position("A"), atol=1e-8)


@pytest.mark.parametrize("planar", [True, False])
def test_a_rigid_bar_carries_half_of_an_even_load_at_each_end(planar: bool) -> None:
    m = fx.Model()
    at = (lambda x: (x, 0)) if planar else (lambda x: (x, 0, 0))
    m.truss("bar", m.point("A", at(0), fixed=True), m.point("B", at(2.0)), mass_per_length=1.0)
    m.distributed_load("bar", (0, 3.0) if planar else (0, 3.0, 0))
    assert m.build().initial.force("A.y") == pytest.approx(-3.0 * 2 / 2 + 3.0 * 2 / 4, rel=1e-12)


@pytest.mark.parametrize("planar", [True, False])
def test_a_following_end_force_bends_a_beam_and_stays_normal_to_it(planar: bool) -> None:
    m = cantilever(4, planar)
    F = 1.0
    m.load("P4", (0, lambda t: F * t) if planar else (0, lambda t: F * t, 0), follower="R4")
    path = m.build().static_path(t_end=1.0)
    assert path.message == ""
    state = path[-1]
    angle = state["R4.angle"] if planar else 2 * np.arctan2(state["R4.lambda3"], state["R4.lambda0"])
    reaction = np.array([state.force("P0.x"), state.force("P0.y")])
    np.testing.assert_allclose(reaction, -F * np.array([-np.sin(angle), np.cos(angle)]), rtol=1e-8)


@COARSE_MESH
def test_a_following_force_has_an_exact_tangent() -> None:
    m = cantilever(2, planar=False)
    m.load("P2", (0.0, 1.0, 0.3), follower="R2")
    system = m.build()
    state = system.equilibrium()
    nearby = system.state_at(
        {name: value + 1e-3 for name, value in zip(system.dynamic, state.q, strict=True)}, start=state
    )
    K = system.linearize(nearby).K
    h = 1e-6
    for j in range(3):
        shift = np.eye(nearby.q.size)[j] * h
        zero = np.zeros(nearby.q.size)
        acc = np.array([nearby.acceleration(name) for name in system.dynamic])
        r = [system.residual(0.0, nearby.q + s, zero, acc, nearby) for s in (shift, -shift)]
        np.testing.assert_allclose((r[0] - r[1]) / (2 * h), K[:, j], atol=1e-7 * np.abs(K).max())


@pytest.mark.parametrize(
    ("mistake", "words"),
    [
        (lambda m: m.distributed_load("nobody", (0, 0, 1)), "distributed load on 'nobody': unknown element"),
        (lambda m: m.distributed_load("pivot", (0, 0, 1)), "has no span; load a beam"),
        (lambda m: m.distributed_load("rod", (0, 1)), "2 components given; it takes 3"),
        (lambda m: m.load("A", (1, 0, 0), follower=True), "write follower=frame"),
        (lambda m: m.load("A", (1, 0, 0), follower="nobody"), "unknown node 'nobody'"),
        (lambda m: m.load("R1", (1, 0, 0), follower="R1"), "write follower=True"),
    ],
)
def test_mistakes_are_named(mistake: object, words: str) -> None:
    m = fx.Model()
    r0, r1 = m.frame("R0", fixed=True), m.frame("R1")
    m.hinge("pivot", r0, r1, axis=(0, 1, 0))
    m.beam("rod", m.point("O", (0, 0, 0), fixed=True), r1, m.point("A", (1, 0, 0)), mass_per_length=1.0)
    with pytest.raises(fx.ModelError) as error:
        mistake(m)  # type: ignore[operator]
    assert words in str(error.value)
