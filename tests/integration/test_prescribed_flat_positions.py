"""Mechanisms whose every motion is prescribed keep their branch through flat positions, wherever states are stored."""

import numpy as np
import pytest

import flexel as fx

SAMPLES = (2, 3, 5, 9, 12, 33, 200, 201)


def parallelogram() -> fx.System:
    """Its crank turns once; it is flat at t = 0.25 and 0.75 s."""
    m = fx.Model()
    A, B = m.point("A", (0, 0), fixed=True), m.point("B", (2, 0), fixed=True)
    C, D = m.point("C", (0, 1)), m.point("D", (2, 1))
    m.beam("crank", A, m.angle("turn"), C, mass_per_length=1.0)
    m.truss("coupler", C, D, mass_per_length=1.0)
    m.truss("rocker", B, D, mass_per_length=1.0)
    m.prescribe("turn.angle", lambda t: 2 * np.pi * t)
    return m.build()


@pytest.mark.parametrize("samples", SAMPLES)
def test_a_parallelogram_stays_one(samples: int) -> None:
    motion = parallelogram().simulate(1.0, samples=samples)
    assert motion.warnings == ()
    assert motion["D.x"] - 2 == pytest.approx(motion["C.x"], abs=1e-10)
    assert motion["D.y'"] == pytest.approx(motion["C.y'"], abs=1e-8)
    within = [motion.at(t) for t in (0.2, 0.24, 0.2500001, 0.3, 0.75, 0.81)]
    assert [s["D.x"] - s["C.x"] for s in within] == pytest.approx([2.0] * 6, abs=1e-10)


@pytest.mark.parametrize("samples", SAMPLES)
def test_a_slider_crank_with_equal_lengths(samples: int) -> None:
    """The slider passes the axis of the crank: S.x = 2 cos(angle)."""
    m = fx.Model()
    O, C, S = (m.point(n, x) for n, x in (("O", (0, 0)), ("C", (0.8, 0.6)), ("S", (1.6, 0))))
    m.fix("O", "S.y")
    m.beam("crank", O, m.angle("turn"), C, mass_per_length=1.0)
    m.truss("rod", C, S)
    m.point_mass("slider", S, 1.0)
    m.prescribe("turn.angle", lambda t: 2 * np.pi * t)
    motion = m.build().simulate(1.0, samples=samples)
    angle = np.arctan2(0.6, 0.8) + 2 * np.pi * motion.t
    assert motion["S.x"] == pytest.approx(2 * np.cos(angle), abs=1e-10)
    assert motion["S.x'"] == pytest.approx(-4 * np.pi * np.sin(angle), abs=1e-8)


@pytest.mark.parametrize("samples", (3, 21, 201))
def test_an_arm_that_its_path_stretches(samples: int) -> None:
    """Stretched at t = 1 s: its joints turn on, at 1/√2 rad/s there, and their torques are bounded."""
    m = fx.Model()
    m.point("O", (0, 0), fixed=True)
    ground, upper, lower = m.angle("ground", fixed=True), m.angle("a"), m.angle("b")
    m.hinge("first", ground, upper)
    m.hinge("second", upper, lower)
    m.beam("upper", "O", upper, m.point("W", (0.75, np.sqrt(1 - 0.75**2))), mass_per_length=1.0)
    m.beam("lower", "W", lower, m.point("T", (1.5, 0)), mass_per_length=1.0)
    joints = ("first.angle", "second.angle")
    m.prescribe("T.x", lambda t: 2 - (t - 1) ** 2 / 2, actuators=joints)
    m.prescribe("T.y", fx.Polynomial([0.0]), actuators=joints)
    motion = m.build().simulate(2.0, samples=samples)
    middle = motion.t.size // 2
    assert motion["first.angle'"][middle] == pytest.approx(-np.sqrt(0.5), abs=1e-8)
    assert motion["first.angle"][-1] == pytest.approx(
        -motion["first.angle"][0] + 2 * motion["a.angle"][middle], abs=1e-9
    )
    assert np.abs(motion.drive("first.angle")).max() < 0.2
    assert abs(motion.drive("second.angle")[middle]) < 0.2


@pytest.mark.parametrize("loops", [1, 2, 3, 5])
def test_parallelograms_in_series_at_any_speed_and_with_any_states(loops: int) -> None:
    """All loops are flat at the same time; speeds, starts and numbers of states are drawn."""
    random = np.random.default_rng(loops)
    for _ in range(6):
        speed, start, samples = random.uniform(-15, 15), random.uniform(0.2, 2.9), int(random.integers(2, 60))
        m = fx.Model()
        m.angle("turn")
        for i in range(loops + 1):
            m.point(f"G{i}", (i, 0), fixed=True)
            m.point(f"A{i}", (i + np.cos(start), np.sin(start)))
            if i:
                m.truss(f"crank {i}", f"G{i}", f"A{i}", mass_per_length=1.0)
                m.truss(f"coupler {i}", f"A{i - 1}", f"A{i}", mass_per_length=1.0)
        m.beam("driven", "G0", "turn", "A0", mass_per_length=1.0)
        m.prescribe("turn.angle", fx.Polynomial([0.0, speed]))
        motion = m.build().simulate(2.0, samples=samples)
        for i in range(loops + 1):
            assert motion[f"A{i}.x"] - i == pytest.approx(np.cos(start + speed * motion.t), abs=1e-9)
