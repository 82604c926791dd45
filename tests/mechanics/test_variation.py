"""Coefficients that prescribed motions change: eigenvalues warn, and name what decides stability."""

import pickle
import warnings

import numpy as np
import pytest

import flexel as fx

G = 9.81


def on_a_support(amplitude: float) -> fx.System:
    """A pendulum of length one whose support moves up and down with twice its frequency."""
    m = fx.Model(gravity=(0, -G))
    m.point("A", (0, 0))
    m.fix("A.x")
    m.prescribe("A.y", fx.Harmonic(amplitude, 2 * np.sqrt(G), phase=np.pi / 2))
    m.angle("rod")
    m.point("B", (0, -1))
    m.beam("arm", "A", "rod", "B", rigid=True)
    m.point_mass("bob", "B", 1.0)
    return m.build()


def governor(speed: float) -> fx.System:
    """An arm on a mast that turns about the vertical at a prescribed speed, drawn where it stays."""
    m = fx.Model(gravity=(0, 0, -G))
    theta = np.arccos(G / speed**2) if speed**2 > G else 0.0
    m.point("O", (0, 0, 0), fixed=True)
    for name in ("mast", "arm"):
        m.frame(name)
    m.frame("ground", fixed=True)
    m.hinge("drive", "ground", "mast", axis=(0, 0, 1))
    m.hinge("pin", "mast", "arm", axis=(0, 1, 0), damping=0.1)
    m.point("B", (np.sin(theta), 0, -np.cos(theta)))
    m.beam("rod", "O", "arm", "B", rigid=True)
    m.point_mass("bob", "B", 1.0)
    m.prescribe("drive.angle", fx.Polynomial([0.0, speed]))
    return m.build()


def test_a_support_that_moves_makes_the_stable_pendulum_unstable_and_eigenvalues_say_so() -> None:
    """Mathieu's equation: the frozen eigenvalues are imaginary, the multiplier is 1.17."""
    system = on_a_support(0.05)
    lin = system.linearize()
    for ask in (lin.eigenvalues, lin.modes):
        with pytest.warns(fx.UnsteadyWarning, match=r"frozen coefficients.*multipliers") as warned:
            ask()
        assert warned[0].filename == __file__
    assert "coefficients" in str(system.summary())
    multipliers = system.periodic(period=np.pi / np.sqrt(G), harmonics=3).multipliers()
    assert abs(multipliers[0]) == pytest.approx(1.16987, abs=1e-5)


def test_a_motion_with_constant_coefficients_is_not_suspected() -> None:
    """The governor turns, and its equations do not change; so is a support that rests."""
    for system in (governor(5.0), on_a_support(0.0)):
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            values = system.linearize().eigenvalues()
        assert "coefficients" not in str(system.summary())
    assert values.imag.max() == pytest.approx(np.sqrt(G), rel=1e-9)


def test_equations_that_have_lost_their_system_are_not_judged() -> None:
    lin = pickle.loads(pickle.dumps(on_a_support(0.05).linearize()))
    assert lin.variation() == 0
    lin.eigenvalues()


def disc(names: bool) -> fx.System:
    """A disc of 0.3 m that rolls on the ground, with or without named angles of yaw, lean and roll."""
    m = fx.Model(gravity=(0, 0, -G))
    hub, touch, frame = m.point("hub", (0, 0, 0.3)), m.point("touch", (0, 0, 0)), m.frame("disc")
    m.wheel("wheel", hub, frame, touch, radius=0.3, axle=(0, 1, 0), normal=(0, 0, 1))
    m.body("body", hub, frame, mass=1.0, inertia=(0.0225, 0.045, 0.0225))
    if names:
        yaw, lean = m.frame("yawed"), m.frame("leaned")
        m.hinge("yaw", m.frame("ground", fixed=True), yaw, axis=(0, 0, 1))
        m.hinge("lean", yaw, lean, axis=(1, 0, 0))
        m.hinge("roll", lean, frame, axis=(0, 1, 0))
        m.independent("yaw.angle", "lean.angle", "roll.angle")
    return m.build()


def free_body(names: bool) -> fx.System:
    """A body that turns freely about its centre."""
    m = fx.Model()
    m.rigid_body("body", (0, 0, 0), mass=1.0, inertia=(1.0, 2.0, 3.0))
    m.fix("body")
    if names:
        m.cardan_chain("x", "y", "z", body="body", axes="xyz")
        m.independent("x.angle", "y.angle", "z.angle")
    else:
        m.angular_velocity("body_frame")
    return m.build()


def test_a_disc_that_rolls_steadily_has_constant_coefficients_in_its_angles_only() -> None:
    """Upright, λ² = 4g/5r - 12/5 (v/r)² (Schwab and Meijaard); simulated, it stays upright."""
    plain, named = disc(False), disc(True)
    lin = plain.linearize(plain.steady(plain.state_at(rates={"hub.x": 1.5})))
    with pytest.warns(
        fx.UnsteadyWarning, match=r"the motion of hub.x.* changes the coefficients.*yaw, lean and roll"
    ):
        lin.eigenvalues()
    with pytest.warns(fx.UnsteadyWarning, match=r"root_loci: the motion of hub.x"):
        plain.root_loci(rates={"hub.x": np.array([0.5, 1.5])})
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        values = named.linearize(named.steady(named.state_at(rates={"roll.angle": 5.0}))).eigenvalues()
        named.root_loci(rates={"roll.angle": np.array([1.0, 5.0])})
    assert np.abs(values).max() == pytest.approx(np.sqrt(12 / 5 * 25 - 4 * G / 1.5), rel=1e-9)


def test_a_body_that_spins_about_a_principal_axis_is_steady_in_its_angles_only() -> None:
    """Euler: 2 √((3-1)(2-1)/(2·3)) rad/s about the axis of least inertia, beside the spin itself."""
    plain, named = free_body(False), free_body(True)
    lin = plain.linearize(plain.state_at(rates={"body_frame.omega.wx": 2.0}))
    with pytest.warns(
        fx.UnsteadyWarning, match=r"nothing accelerates at this instant, but body_frame\.lambda1 cannot"
    ):
        lin.modes()
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        values = named.linearize(named.state_at(rates={"x.angle": 2.0})).eigenvalues()
    assert np.sort(values.imag)[-2:] == pytest.approx([2 / np.sqrt(3), 2.0], rel=1e-9)


def test_the_lowest_point_of_a_swing_is_no_steady_motion() -> None:
    m = fx.Model(gravity=(0, -G))
    O, B = m.point("O", (0, 0), fixed=True), m.point("B", (0, -1))
    m.truss("rod", O, B)
    m.point_mass("bob", B, 1.0)
    system = m.build()
    with pytest.warns(fx.UnsteadyWarning, match=r"B\.x cannot keep the rate"):
        system.linearize(system.state_at(rates={"B.x": 1.0})).eigenvalues()
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        system.linearize().eigenvalues()


def test_what_floats_through_space_is_steady() -> None:
    """A stiff spring between two masses that fly with 0.01 m/s: rounding errors of its stiffness are no force."""
    m = fx.Model()
    A, B = m.point("A", (0, 0, 0)), m.point("B", (1, 0.3, 0.2))
    m.truss("spring", A, B, stiffness=1e9)
    for point in (A, B):
        m.point_mass(f"mass of {point.name}", point, 1.0)
    system = m.build()
    flying = {f"{point}.{axis}": 0.01 * (i + 1) for point in "AB" for i, axis in enumerate("xyz")}
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        system.linearize(system.state_at(rates=flying)).eigenvalues()


def test_what_is_prescribed_altogether_has_no_eigenvalues() -> None:
    m = fx.Model()
    A = m.point("A", (1, 0))
    m.fix("A.y")
    m.point_mass("mass", A, 1.0)
    m.prescribe("A.x", fx.Polynomial([1.0, 2.0]))
    lin = m.build().linearize()
    assert not lin.eigenvalues().size and not lin.modes() and lin.variation() == 0.0
