"""Inverse dynamics: prescribed motion gives driving forces and reactions; power and rotating frames."""

from pathlib import Path

import numpy as np
import pytest
from differences import Knob, pendulum, slope

import flexel as fx
from flexel.base.time_functions import Harmonic, Polynomial, Ramp
from flexel.base.time_tables import Table
from flexel.parts.model import Model

G = 9.81


def arm(lengths: tuple[float, float] = (0.6, 0.4)) -> Model:
    """A planar arm of two rods, masses 3 and 2 kg, in the vertical plane, built in space."""
    a, b = lengths
    m = Model(gravity=(0, 0, -G))
    O = m.point("O", (0, 0, 0), fixed=True)
    A, B = m.point("A", (a, 0, 0)), m.point("B", (a + b, 0, 0))
    R0, R1, R2 = m.frame("R0", fixed=True), m.frame("R1"), m.frame("R2")
    m.hinge("shoulder", R0, R1, axis=(0, -1, 0))
    m.hinge("elbow", R1, R2, axis=(0, -1, 0))
    m.beam("upper", O, R1, A, mass_per_length=3.0 / a)
    m.beam("lower", A, R2, B, mass_per_length=2.0 / b)
    return m


def moments(q: tuple, v: tuple, a: tuple, lengths: tuple[float, float] = (0.6, 0.4)) -> np.ndarray:
    """Closed-form driving moments of the two-link arm (angles from the horizontal, the second relative)."""
    l1, l2 = lengths
    m1, m2 = 3.0, 2.0
    J1, J2 = m1 * l1**2 / 3, m2 * l2**2 / 3
    k = m2 * l1 * l2 / 2
    c, s = np.cos(q[1]), np.sin(q[1])
    M = np.array([[J1 + m2 * l1**2 + J2 + 2 * k * c, J2 + k * c], [J2 + k * c, J2]])
    h = np.array([-k * s * (2 * v[0] * v[1] + v[1] ** 2), k * s * v[0] ** 2])
    g2 = m2 * G * l2 / 2 * np.cos(q[0] + q[1])
    g1 = (m1 / 2 + m2) * G * l1 * np.cos(q[0]) + g2
    return M @ np.array(a) + h + np.array([g1, g2])


def test_two_link_arm_needs_the_closed_form_moments() -> None:
    m = arm()
    first, second = Harmonic(0.9, 3.0, 0.2), Ramp(0.1, 0.9, 0.3, -1.4)
    m.prescribe("shoulder.angle", first)
    m.prescribe("elbow.angle", second)
    motion = m.build().simulate(1.2, samples=25)
    for state in motion:
        z1, z2 = first.rates(state.t), second.rates(state.t)
        expected = moments(*zip(z1, z2, strict=True))
        computed = [-state.force("shoulder.angle"), -state.force("elbow.angle")]
        assert np.max(np.abs(computed - expected)) < 1e-10


def test_driving_forces_drive_the_free_mechanism_through_the_same_motion() -> None:
    """Forward dynamics under the moments of the inverse problem reproduces the prescribed motion."""
    m = arm()
    first, second = Harmonic(0.9, 3.0), Harmonic(-0.5, 2.0)
    m.load("shoulder.angle", lambda t: float_of(t, first, second)[0])
    m.load("elbow.angle", lambda t: float_of(t, first, second)[1])
    m.independent("shoulder.angle", "elbow.angle")
    m.initial("shoulder.angle", rate=first.rates(0)[1])
    m.initial("elbow.angle", rate=second.rates(0)[1])
    motion = m.build().simulate(1.0, samples=11, rtol=1e-11, atol=1e-12)
    for state in motion:
        assert abs(state["shoulder.angle"] - first.rates(state.t)[0]) < 1e-8
        assert abs(state["elbow.angle"] - second.rates(state.t)[0]) < 1e-8


def float_of(t, first, second):  # noqa: ANN001, ANN201
    z1, z2 = first.rates(t), second.rates(t)
    return moments(*zip(z1, z2, strict=True))


def test_power_of_the_drives_is_the_rate_of_energy() -> None:
    """A spatial arm on skew axes; dE/dt is differentiated numerically from the states, the power is not."""
    m = pendulum(mass_per_length=2.0)
    B, R2 = m.point("B", (1.4, 0.5, 0.3)), m.frame("R2")
    m.hinge("elbow", "R1", R2, axis=(1, 1, 0.4))
    m.beam("arm", "A", R2, B, mass_per_length=1.0)
    m.body("hand", B, R2, mass=0.7, inertia=(0.2, 0.3, 0.4, 0.02, -0.03, 0.01), offset=(0.1, 0.2, -0.1))
    m.prescribe("pivot.angle", lambda t: 0.5 * np.sin(3 * t) + t**2)
    m.prescribe("elbow.angle", lambda t: np.exp(-t) * np.cos(4 * t))
    motion = m.build().simulate(1.0, samples=5)
    for state in motion[1:-1]:
        power = -sum(state.force(name) * state.rate(name) for name in ("pivot.angle", "elbow.angle"))
        energy = slope(lambda d, t=state.t: np.array(motion.at(t + d).energy.total), 1e-2)
        assert abs(power - energy) < 1e-8 * max(1.0, abs(power))


def test_prescribed_coordinates_report_the_force_that_moves_them() -> None:
    """A mass carried along a path: m (ẍ + g)."""
    m = Model(gravity=(0, 0, -G))
    P = m.point("P", (0, 0, 0))
    m.point_mass("mass", P, 2.0)
    for axis, knob in zip("xyz", (Knob(0, 1, 2), Knob(0, -1, 0.5), Knob(0, 0, 3)), strict=True):
        m.prescribe(f"P.{axis}", knob)
    state = m.build().initial
    assert np.allclose([state.force(f"P.{axis}") for axis in "xyz"], [4.0, 1.0, 2 * (3 + G)], rtol=1e-14)


def test_hinge_carries_weight_and_centripetal_force() -> None:
    """A hanging rod swung at ω at its lowest point pulls with m g + m ω² L/2; at rest, with its weight."""
    for rate in (0.0, 4.0):
        m = pendulum(mass_per_length=2.0)
        m.initial("pivot.angle", np.pi / 2, rate=rate)
        state = m.build().initial
        assert abs(state.force("O.z") - 2.0 * (G + rate**2 / 2)) < 1e-12
        assert abs(state.force("O.x")) + abs(state.force("O.y")) < 1e-12


def test_clamp_carries_the_moment_of_the_weight() -> None:
    """A cantilever held by a prescribed hinge angle and rigid bending: m g L / 2 about the axis, force m g."""
    m = pendulum(mass_per_length=2.0)
    m.load("A", (0, 5.0, 0))
    m.load("R1", (0.7, 0, 0))
    m.prescribe("pivot.angle", 0.0)
    state = m.build().initial
    assert abs(-state.force("pivot.angle") + 2.0 * G / 2) < 1e-12  # the weight turns it about +y
    assert abs(state.force("O.y") + 5.0) < 1e-12
    # generalized stresses of the bending deformations are moments at zero bending: about z and about x
    bends = np.sort(np.abs([state.force("pivot.bend1"), state.force("pivot.bend2")]))
    assert np.max(np.abs(bends - [0.7, 5.0])) < 1e-12


def test_moments_fixed_in_space_and_following_the_body_turn_a_rotor_alike_about_a_fixed_axis() -> None:
    for follower in (False, True):
        m = Model()
        O = m.point("O", (0, 0, 0), fixed=True)
        R0, R1 = m.frame("R0", fixed=True), m.frame("R1")
        m.hinge("axle", R0, R1, axis=(0, 0, 1))
        m.body("rotor", O, R1, mass=1.0, inertia=(0.3, 0.4, 0.5))
        m.load(R1, (0, 0, 2.0), follower=follower)
        motion = m.build().simulate(3.0, samples=7)
        assert np.max(np.abs(motion["axle.angle"] - 2.0 * motion.t**2)) < 1e-10  # 18 rad: turns are kept
        assert np.max(np.abs(motion.rate("axle.angle") - 4.0 * motion.t)) < 1e-10


def test_follower_moment_on_a_free_body_stays_with_its_axes() -> None:
    """Euler's equations for a sphere: J ω̇ = M in body axes, so ω = M t / J there; a moment fixed in space likewise."""
    for follower in (False, True):
        m = Model()
        P, R = m.point("P", (0, 0, 0)), m.frame("R")
        m.body("sphere", P, R, mass=1.0, inertia=(0.5, 0.5, 0.5))
        m.load(R, (0.3, -0.2, 0.6), follower=follower)
        w = m.angular_velocity(R, body_axes=follower)
        m.initial(f"{w}.wx", rate=2.0)
        motion = m.build().simulate(2.0, samples=9, rtol=1e-11, atol=1e-12)
        omega = np.column_stack([motion.rate(f"{w}.w{axis}") for axis in "xyz"])
        start = np.array([2.0, 0, 0])
        if follower:
            # for a sphere the angular velocity obeys ω̇ = M/J in body axes as in fixed ones
            assert np.max(np.abs(omega - start - np.outer(motion.t, [0.6, -0.4, 1.2]))) < 1e-9
        else:
            assert np.max(np.abs(omega - start - np.outer(motion.t, [0.6, -0.4, 1.2]))) < 1e-9


def test_foucault_plane_of_a_pendulum_on_a_turntable_stays_in_space() -> None:
    """A point mass on a universal joint does not feel the table turn: seen from it, the plane turns back by Ω t."""
    m, rate = Model(gravity=(0, 0, -G)), 0.8
    O, A = m.point("O", (0, 0, 0), fixed=True), m.point("A", (0, 0, -1))
    frames = [m.frame(name, fixed=name == "ground") for name in ("ground", "table", "cross", "rod frame")]
    for name, axis, p, q in zip(("turn", "pitch", "roll"), "zyx", frames[:-1], frames[1:], strict=True):
        m.hinge(name, p, q, axis=np.eye(3)["xyz".index(axis)])
    m.beam("rod", O, frames[-1], A)
    m.point_mass("bob", A, 1.0)
    m.prescribe("turn.angle", lambda t: rate * t)
    m.independent("pitch.angle", "roll.angle")
    m.initial("pitch.angle", -0.5)
    m.initial("A.x", rate=0.0)
    m.initial("A.y", rate=0.0)
    s = m.build()
    assert s.initial["A.x"] > 0.4
    motion = s.simulate(6.0, samples=61, rtol=1e-11, atol=1e-12)
    assert np.max(np.abs(motion.position("A")[:, 1])) < 1e-9  # it swings in the plane y = 0 in space
    plain = pendulum(gravity=G)
    plain.point_mass("bob", "A", 1.0)
    plain.initial("pivot.angle", np.pi / 2 - 0.5, rate=0.0)
    reference = plain.build().simulate(6.0, samples=61, rtol=1e-11, atol=1e-12)
    assert np.max(np.abs(motion.position("A") - reference.position("A"))) < 1e-9
    # small oscillations as the table sees them: ω₀ ± Ω
    rest = s.state_at({"pitch.angle": 0.0, "roll.angle": 0.0}, {"pitch.angle": 0.0, "roll.angle": 0.0})
    w = np.sort(s.linearize(rest).eigenvalues().imag)
    f = np.sqrt(G)
    assert np.max(np.abs(w - np.sort([f + rate, f - rate, rate - f, -rate - f]))) < 1e-11


def test_rotor_on_a_tilting_table_pushes_its_bearings_with_the_gyroscopic_moment() -> None:
    """Spin ω about x, table turning at Ω about z: the hinge across both carries J ω Ω."""
    m = Model()
    O = m.point("O", (0, 0, 0), fixed=True)
    ground, table, rotor = m.frame("ground", fixed=True), m.frame("table"), m.frame("rotor")
    m.hinge("table hinge", ground, table, axis=(0, 0, 1))
    m.hinge("spin", table, rotor, axis=(1, 0, 0))
    m.body("disc", O, rotor, mass=1.0, inertia=(0.2, 0.1, 0.1))
    m.prescribe("table hinge.angle", lambda t: 3.0 * t)
    m.prescribe("spin.angle", lambda t: 50.0 * t)
    state = m.build().initial
    assert abs(state.force("spin.angle")) + abs(state.force("table hinge.angle")) < 1e-12
    bends = [abs(state.force(f"spin.bend{i}")) for i in (1, 2)]
    assert abs(max(bends) - 0.2 * 50.0 * 3.0) < 1e-11
    assert min(bends) < 1e-11


def test_coarsely_sampled_prescribed_angles_keep_their_turns() -> None:
    m = pendulum(mass_per_length=1.0)
    m.prescribe("pivot.angle", lambda t: 40 * np.sin(t) + 3 * t**2)
    motion = m.build().simulate(6.0, samples=4)
    assert np.max(np.abs(motion["pivot.angle"] - (40 * np.sin(motion.t) + 3 * motion.t**2))) < 1e-11


@pytest.mark.parametrize("function", ["jet", "triple", "harmonic", "table"])
def test_the_same_motion_given_in_four_ways_needs_the_same_moment(function: str) -> None:
    u = Harmonic(0.5, 3.0, offset=0.1)
    t = np.linspace(-0.5, 2, 2001)
    given = {
        "jet": lambda t: 0.1 + 0.5 * np.sin(3 * t),
        "triple": (lambda t: u.rates(t)[0], lambda t: u.rates(t)[1], lambda t: u.rates(t)[2]),
        "harmonic": u,
        "table": Table(t, 0.1 + 0.5 * np.sin(3 * t)),
    }[function]
    m = pendulum(mass_per_length=2.0)
    m.prescribe("pivot.angle", given)
    motion = m.build().simulate(1.0, samples=5)
    theta = 0.1 + 0.5 * np.sin(3 * motion.t)
    moment = 2.0 / 3 * -4.5 * np.sin(3 * motion.t) - G * np.cos(theta)
    assert np.max(np.abs(-motion.force("pivot.angle") - moment)) < (1e-4 if function == "table" else 1e-12)


def loaded_joint(method: str) -> tuple[fx.Motion, np.ndarray]:
    """A wheel on a driven hinge with a spring, a damper, friction and a load; and the moment of its motor [N m]."""
    m = Model()
    m.rigid_body("wheel", (0, 0), mass=1.0, inertia=0.2)
    m.revolute("j", "ground", "wheel", at=(0, 0), stiffness=2.0, damping=0.3, friction=(0.5, 1e-3))
    m.load("j.angle", 4.0)
    m.prescribe("j.angle", Polynomial([0.0, 10.0, 0.5]))
    motion = m.build().simulate(1.0, samples=11, method=method)
    t = motion.t
    return motion, 0.2 + 2.0 * (10 * t + 0.5 * t**2) + 0.3 * (10 + t) + 0.5 - 4.0


@pytest.mark.parametrize("method", ["auto", "generalized-alpha"])
def test_a_drive_is_what_its_motor_supplies(method: str, tmp_path: Path) -> None:
    """Without the springs, dampers, friction and loads in its joint, which `force` has too; also from a file."""
    motion, moment = loaded_joint(method)
    assert motion.drive("j.angle") == pytest.approx(moment, rel=1e-8)
    assert motion.force("j.angle") == pytest.approx(np.full(11, -0.2), abs=1e-8)
    for name in ("motion.npz", "motion.nc"):
        assert fx.load(motion.save(tmp_path / name)).drive("j.angle") == pytest.approx(moment, rel=1e-8)
    power = motion[-1].dissipated
    assert power == pytest.approx((0.3 * 11.0 + 0.5) * 11.0, rel=1e-8)


def on_path(*, loaded: bool) -> fx.Motion:
    """A two-link arm whose tip goes round, perhaps with a spring, a damper and friction in its joints."""
    m = Model(gravity=(0, -G))
    shoulder, wrist, tip = (
        m.point(n, x) for n, x in (("S", (0, 0)), ("W", (0.36, 0.48)), ("T", (0.76, 0.48)))
    )
    m.fix("S")
    ground, upper, fore = m.angle("ground", fixed=True), m.angle("upper"), m.angle("fore")
    m.hinge("first", ground, upper)
    m.hinge("second", upper, fore)
    m.beam("one", shoulder, upper, wrist, mass_per_length=5)
    m.beam("two", wrist, fore, tip, mass_per_length=5)
    if loaded:
        m.spring("first.angle", 5.0, 0.7)
        m.friction("second.angle", 3.0, 1e-3)
    motors = ("first.angle", "second.angle")
    m.prescribe("T.x", lambda t: 0.66 + 0.1 * np.cos(2 * np.pi * t), actuators=motors)
    m.prescribe("T.y", lambda t: 0.48 + 0.1 * np.sin(2 * np.pi * t), actuators=motors)
    return m.build().simulate(1.0, samples=8)


def test_actuators_supply_what_acts_in_their_joints() -> None:
    """The moments for a path, and those of a damper, a spring and friction in the same joints."""
    plain, loaded = on_path(loaded=False), on_path(loaded=True)
    more = 5.0 * loaded["first.angle"] + 0.7 * loaded["first.angle'"]
    assert loaded.drive("first.angle") - plain.drive("first.angle") == pytest.approx(more, abs=1e-8)
    assert loaded.force("first.angle") == pytest.approx(plain.force("first.angle"), abs=1e-8)
    slides = np.sign(loaded["second.angle'"])
    assert loaded.drive("second.angle") - plain.drive("second.angle") == pytest.approx(3.0 * slides, abs=1e-3)
    with pytest.raises(
        fx.ModelError, match=r"drive: nothing drives 'one\.along'.*first\.angle, second\.angle"
    ):
        plain.drive("one.along")


def test_what_is_held_is_driven_and_nothing_else() -> None:
    m = arm()
    m.rigid("shoulder.angle")
    m.load("elbow.angle", 0.5)
    system = m.build()
    held = system.equilibrium(hold=["elbow.angle"])
    assert held.drive("elbow.angle") == pytest.approx(2.0 * G * 0.2 - 0.5, rel=1e-9)
    for name in ("shoulder.angle", "upper.along", "B.x"):
        with pytest.raises(
            fx.ModelError, match=f"nothing drives '{name}'; prescribed quantities and actuators: none"
        ):
            held.drive(name)
