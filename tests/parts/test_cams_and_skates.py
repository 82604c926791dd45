"""Cams with outlines by splines and skates on ice, against closed forms."""

import numpy as np
import pytest
from differences import numerical_matrices, numerical_state_matrix, worst
from scipy.interpolate import make_interp_spline

import flexel as fx
from flexel.parts.cams import PIECES, at_knots, control_values

R, E = 0.05, 0.02  # radius of an eccentric disc and how far its centre is off [m]


def eccentric(angle: float) -> float:
    """Distance of the rim of a disc from a point inside it."""
    return float(E * np.cos(angle) + np.sqrt(R**2 - (E * np.sin(angle)) ** 2))


def valve(planar: bool, outline: object = eccentric) -> fx.Model:
    """A cam that turns at one radian per second, and a follower that slides along y above it."""
    m = fx.Model(gravity=(0, 0) if planar else (0, 0, 0))
    third = () if planar else (0.0,)
    r0 = eccentric(np.pi / 2)
    m.rigid_body("cam", (0, 0, *third), mass=1.0, inertia=0.01 if planar else (0.01, 0.01, 0.01))
    m.rigid_body("follower", (0, 0.2, *third), mass=0.5, inertia=0.01 if planar else (0.01, 0.01, 0.01))
    m.revolute("shaft", "ground", "cam", at=(0, 0, *third), axis=None if planar else (0, 0, 1))
    m.prismatic("guide", "ground", "follower", axis=(0, 1, *third))
    axis = None if planar else (0, 0, 1)
    m.cam("lobe", "cam", "follower", (0, r0, *third), outline, axis=axis, start=(1, 0, *third))  # type: ignore[arg-type]
    return m


@pytest.mark.parametrize("planar", [True, False])
def test_a_follower_lifts_as_the_outline_says(planar: bool) -> None:
    """At the angles of the spline's knots its values are those of the function; between them they differ little."""
    m = valve(planar)
    s = m.build()
    assert s.counts["degrees_of_freedom"] == 1
    m.prescribe("shaft.angle", lambda t: -t)  # the angle of the follower in the cam is π/2 + t
    step = 2 * np.pi / PIECES
    motion = m.build().simulate(60 * step, samples=61)
    lift = motion["guide.along" if planar else "guide.axial"]
    expected = np.array([eccentric(np.pi / 2 + t) for t in motion.t]) - eccentric(np.pi / 2)
    assert lift == pytest.approx(expected, abs=1e-11)
    middle = m.build().simulate(0.5 * step)[-1]["guide.along" if planar else "guide.axial"]
    assert middle == pytest.approx(eccentric((np.pi + step) / 2) - eccentric(np.pi / 2), abs=1e-9)


def test_velocity_and_force_of_the_follower_are_those_of_its_spline() -> None:
    angles = np.linspace(0, 2 * np.pi, PIECES + 1)
    r = np.array([eccentric(angle) for angle in angles])
    r[-1] = r[0]
    spline = make_interp_spline(angles, r, k=5, bc_type="periodic")
    m = valve(True)
    m.prescribe("shaft.angle", lambda t: -2.0 * t)
    motion = m.build().simulate(2.0, samples=9)
    at = np.pi / 2 + 2.0 * motion.t
    wrapped = np.mod(at, 2 * np.pi)
    assert motion.rate("guide.along") == pytest.approx(2.0 * spline(wrapped, 1), abs=1e-10)
    acceleration = 4.0 * spline(wrapped, 2)
    assert motion.acceleration("guide.along") == pytest.approx(acceleration, abs=1e-9)
    # the stress of the gap is the pull along the radius: the cam pushes with minus this force
    assert motion.force("lobe.gap") == pytest.approx(-0.5 * acceleration, abs=1e-9)


def test_a_cam_is_linearized_as_it_moves() -> None:
    for planar in (True, False):
        m = valve(planar)
        m.initial("shaft.angle", 0.3, 2.0)
        m.spring("guide.along" if planar else "guide.axial", 40.0, 0.2, preload=1.0)
        s = m.build()
        lin = s.linearize()
        for own, numerical in zip((lin.M, lin.C, lin.K), numerical_matrices(s, s.initial), strict=True):
            assert worst(own, numerical) < 1e-6


def test_a_released_cam_pushes_by_contact_and_lets_go() -> None:
    m = valve(True)
    m.fix("cam_frame")
    m.attach("hertz", ["lobe.gap"], stiffness=1e5, exponent=1.0, dissipation=0.0)
    m.load("guide.along", -20.0)
    m.initial("guide.along", -1e-4)
    assert m.build().equilibrium()["guide.along"] == pytest.approx(-20.0 / 1e5, rel=1e-3)
    m.initial("guide.along", 0.01)
    assert m.build().initial.acceleration("guide.along") == pytest.approx(-40.0, rel=1e-12)


def test_values_at_equal_steps_are_met_whatever_their_number() -> None:
    for n in (6, 8, 12, 16, 24, 48):
        r = 0.05 + 0.01 * np.random.default_rng(n).uniform(size=n)
        found = at_knots(control_values(r, "cam"))
        assert found[:: PIECES // n] == pytest.approx(r, abs=1e-15)
        if n < PIECES:  # between them it is the periodic spline through them
            whole = make_interp_spline(np.arange(n + 1.0), np.append(r, r[0]), k=5, bc_type="periodic")
            assert found == pytest.approx(whole(np.arange(PIECES) * n / PIECES), abs=1e-13)


def test_implicit_steps_follow_cams_and_skates_too() -> None:
    m = valve(True)
    m.prescribe("shaft.angle", lambda t: -2.0 * t)
    motion = m.build().simulate(2.0, samples=21, method="generalized-alpha")
    at_rest = eccentric(np.pi / 2)
    angles = np.pi / 2 + 2.0 * motion.t
    expected = [eccentric(float(angle)) - at_rest for angle in angles]
    assert motion["guide.along"] == pytest.approx(expected, abs=1e-8)
    for planar in (True, False):
        m = sleigh(planar)
        m.initial("sled_frame.angle" if planar else "ice.angle", rate=3.0)
        m.initial("sled.y", rate=0.9)
        s = m.build()
        ends = [
            s.simulate(1.0, rtol=1e-8, method=method)[-1]["sled.x"]
            for method in ("DOP853", "generalized-alpha")
        ]
        assert ends[0] == pytest.approx(ends[1], abs=2e-5)


def test_outlines_that_are_none_are_refused_by_name() -> None:
    for outline, words in (
        ([0.1] * 7, r"has shape \(7,\); give 6, 8"),
        (lambda a: -1.0, "has the radius -1"),
    ):
        with pytest.raises(fx.ModelError, match=f"cam 'lobe': outline {words}"):
            valve(True, outline)


def sleigh(planar: bool) -> fx.Model:
    """Chaplygin's sleigh: the mass centre at a distance behind the blade."""
    third = () if planar else (0.0,)
    m = fx.Model(gravity=(0, 0) if planar else (0, 0, -9.81))
    m.rigid_body("sled", (0.3, 0, *third), mass=2.0, inertia=0.4 if planar else (0.4, 0.4, 0.4))
    m.skate("blade", "sled", at=(0, 0, *third), direction=(1, 0, *third))
    if not planar:
        m.planar_joint("ice", "ground", "sled", normal=(0, 0, 1))
        m.release("ice.axial")  # the blade keeps to the ice already
    return m


@pytest.mark.parametrize("planar", [True, False])
def test_the_sleigh_of_chaplygin_turns_until_it_runs_straight(planar: bool) -> None:
    """v' = a ω², (J + m a²) ω' = -m a v ω: v² + k² ω² stays, and ω falls as 1/cosh, v rises as tanh."""
    a, k = 0.3, np.sqrt(0.4 / 2.0 + 0.3**2)
    m = sleigh(planar)
    turn = "sled_frame.angle" if planar else "ice.angle"
    w0 = 3.0
    m.initial(turn, rate=w0)
    m.initial("sled.y", rate=a * w0)
    s = m.build()
    assert s.roles.nd == 2 and s.roles.nq - s.roles.nd == 1
    motion = s.simulate(2.0, samples=9, rtol=1e-12, atol=1e-13)
    grow = a * w0 / k * motion.t
    assert motion.rate(turn) == pytest.approx(w0 / np.cosh(grow), rel=1e-9)
    speed = k * w0 * np.tanh(grow)
    across = 2.0 * (speed * motion.rate(turn) + a * motion.acceleration(turn))  # of the mass centre
    assert np.abs(motion.force("blade.lateral")) == pytest.approx(np.abs(across), abs=1e-8)
    assert worst(s.linearize().state_matrix, numerical_state_matrix(s, s.initial)) < 1e-6


def test_a_blade_across_the_ice_is_refused() -> None:
    m = fx.Model()
    m.rigid_body("sled", (0, 0, 0), mass=1.0, inertia=(1, 1, 1))
    with pytest.raises(fx.ModelError, match="skate 'blade': its blade is normal to the ice"):
        m.skate("blade", "sled", at=(0, 0, 0), direction=(0, 0, 1))
