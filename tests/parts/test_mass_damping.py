"""Mass-proportional damping: closed forms, and tangents against the residual."""

import numpy as np
import pytest

import flexel as fx

RATE = 0.7


def test_a_stone_that_is_thrown_slows_down_exponentially() -> None:
    m = fx.Model(gravity=(0, 0, -9.81))
    m.point_mass("stone", m.point("A", (0, 0, 0)), 2.0)
    m.mass_damping("stone", RATE)
    m.initial("A.x", rate=3.0)
    motion = m.build().simulate(2.0, samples=9)
    np.testing.assert_allclose(motion["A.x"], 3 / RATE * (1 - np.exp(-RATE * motion.t)), atol=1e-9)
    fall = 9.81 / RATE
    np.testing.assert_allclose(motion.rate("A.z"), -fall * (1 - np.exp(-RATE * motion.t)), atol=1e-9)


def arm() -> fx.Model:
    m = fx.Model(gravity=(0, 0, -9.81))
    o, a = m.point("O", (0, 0, 0), fixed=True), m.point("A", (0.8, 0, 0.1))
    r0, r1, r2 = m.frame("R0", fixed=True), m.frame("R1"), m.frame("R2")
    m.hinge("pivot", r0, r1, axis=(0, 1, 0))
    inertia = (0.01, 0.02, 0.03)
    m.beam("rod", o, r1, a, r2, EIy=2.0, EIz=3.0, GJ=1.0, mass_per_length=0.5, inertia_per_length=inertia)
    m.body("tip", a, r2, mass=0.3, inertia=(0.01, 0.02, 0.015), offset=(0.1, 0.05, 0))
    m.mass_damping("rod", RATE)
    m.independent("pivot.angle", "rod.torsion", "rod.bend1", "rod.bend2", "rod.bend3", "rod.bend4")
    return m


def test_damping_of_all_masses_makes_c_a_multiple_of_m() -> None:
    m = arm()
    m.mass_damping("tip", RATE)
    lin = m.build().linearize()
    np.testing.assert_allclose(lin.C, RATE * lin.M, atol=1e-12 * np.abs(lin.M).max())


def test_the_tangents_are_those_of_the_residual_in_motion() -> None:
    system = arm().build()
    rng = np.random.default_rng(4)
    q, qd = 0.05 * rng.normal(size=6), rng.normal(size=6)
    state = system.state_at(
        dict(zip(system.dynamic, q, strict=True)), dict(zip(system.dynamic, qd, strict=True))
    )
    lin = system.linearize(state)
    qdd = np.array([state.acceleration(name) for name in system.dynamic])
    h = 1e-5
    for j in range(6):
        s = np.eye(6)[j] * h
        by_q = [system.residual(0.0, q + steps * s, qd, qdd, state) for steps in (2, 1, -1, -2)]
        by_qd = [system.residual(0.0, q, qd + steps * s, qdd, state) for steps in (2, 1, -1, -2)]
        for r, column in ((by_q, lin.K[:, j]), (by_qd, lin.C[:, j])):
            slope = (-r[0] + 8 * r[1] - 8 * r[2] + r[3]) / (12 * h)
            np.testing.assert_allclose(slope, column, atol=1e-8 * np.abs(lin.K).max())


@pytest.mark.parametrize(
    ("element", "rate", "words"),
    [("rods", 1.0, "did you mean rod"), ("pivot", 1.0, "has no mass"), ("rod", -1.0, "negative")],
)
def test_mistakes_are_named(element: str, rate: float, words: str) -> None:
    with pytest.raises(fx.ModelError, match=f"mass_damping of '{element}'.*{words}"):
        arm().mass_damping(element, rate)
