"""Tyres and rolling wheels with a crown: geometry, forces, laws, and a torus rolling as its own equations say."""

from typing import Any

import numpy as np
import pytest
from wheels import CALSPAN, MAGIC, MAGIC_ON, PARTS, SIDE, H, K, R, wheel

import flexel as fx
from flexel.base.quaternions import matrix


def moving(m: fx.Model, velocity: tuple[float, float, float], omega: tuple[float, float, float]) -> fx.State:
    """The wheel with a velocity of its centre and an angular velocity."""
    for axis, v, w in zip("xyz", velocity, omega, strict=True):
        m.initial(f"hub.{axis}", rate=v)
        m.initial(f"wheel.omega.w{axis}", rate=w)
    return m.build().initial


def test_a_leaning_wheel_is_measured_in_its_own_plane() -> None:
    lean, rho = 0.3, 0.05
    s = moving(wheel(fx.turn((1, 0, 0), lean), rho), (0, 0, 0), (0, 0, 0))
    assert s["tyre.camber"] == pytest.approx(lean, abs=1e-14)
    assert s["tyre.drop"] == pytest.approx(R - H, abs=1e-14)
    assert s["tyre.deflection"] == pytest.approx(R - rho - (H - rho) / np.cos(lean), abs=1e-14)


def test_the_contact_point_of_a_wheel_that_rolls_does_not_slide() -> None:
    s = moving(wheel(), (7.0, 0, 0), (0, 7.0 / H, 0))
    assert s.rate("tyre.forward") == pytest.approx(7.0)
    assert s.rate("tyre.rolling") == pytest.approx(7.0 / H)
    assert s.rate("tyre.longitudinal") == pytest.approx(0.0, abs=1e-13)
    tipping = moving(wheel(fx.turn((1, 0, 0), 0.2), 0.05), (0, 1.3, 0), (1.3 / H, 0, 0))
    contact = np.array([0, (H - 0.05) * np.tan(0.2), -H])  # from the centre: the tyre touches beside it
    assert tipping.rate("tyre.sideways") == pytest.approx(1.3)
    assert tipping.rate("tyre.lateral") == pytest.approx(
        1.3 + np.cross([1.3 / H, 0, 0], contact)[1], abs=1e-14
    )


def test_forces_act_on_the_contact_point() -> None:
    """A load in the plane of the wheel turns it about its contact point, one on its height does not turn it."""
    lean = 0.1
    for part, arm in (("deflection", H * np.tan(lean)), ("drop", 0.0)):
        m = wheel(fx.turn((1, 0, 0), lean), z=0.35)
        m.attach("vertical_tyre", [f"tyre.{part}"], stiffness=K, damping=0.0)
        s = m.build().initial
        force = 400.0 * (s.acceleration("hub.z") + 9.81)
        assert force > 0
        assert 6.0 * s.acceleration("wheel.omega.wx") == pytest.approx(arm * force, rel=1e-12, abs=1e-9)


def test_a_road_without_waves_is_the_plane() -> None:
    rng = np.random.default_rng(3)
    q = rng.normal(size=4)
    q /= np.linalg.norm(q)
    states = [
        moving(wheel(q, 0.04, road), (3.0, -1.0, 0.5), (2.0, 5.0, -1.0))
        for road in (None, fx.Waves(0.2, 5.0, start=100.0))
    ]
    for name in ("deflection", "drop", "camber"):
        assert states[0][f"tyre.{name}"] == pytest.approx(states[1][f"tyre.{name}"], abs=1e-15)
    for name in PARTS[2:]:
        assert states[0].rate(f"tyre.{name}") == pytest.approx(states[1].rate(f"tyre.{name}"), abs=1e-13)


def test_on_a_slope_the_force_on_the_height_is_normal_to_the_road() -> None:
    height, wavelength, x = 0.2, 5.0, 1.0
    slope = height * np.pi / wavelength * np.sin(2 * np.pi * x / wavelength)
    road = fx.Waves(height, wavelength)
    rise = height / 2 * (1 - np.cos(2 * np.pi * x / wavelength))
    m = wheel(road=road, x=x, z=rise + H)
    m.attach("vertical_tyre", ["tyre.drop"], stiffness=K, damping=0.0)
    s = m.build().initial
    assert s["tyre.grade"] == pytest.approx(slope / np.hypot(1, slope), rel=1e-12)  # ahead is along the slope
    force = 400.0 * np.array([s.acceleration(f"hub.{axis}") for axis in "xyz"]) + [0, 0, 400.0 * 9.81]
    assert force == pytest.approx(K * (R - H) * np.array([-slope, 0, 1]), rel=1e-11, abs=1e-9)


@pytest.mark.parametrize("heading", [0.0, 0.6])
def test_a_wheel_on_a_sine_road_vibrates_as_a_mass_on_a_spring(heading: float) -> None:
    """Driven over five waves, m z'' = k (R - z + road) - m g from rest, with the road (1 - cos W t) A/2."""
    A, wavelength, speed = 0.004, 5.0, 10.0
    rest = R - 400 * 9.81 / K
    road = fx.Waves(A, wavelength, count=5, heading=(np.cos(heading), np.sin(heading)))
    m = wheel(road=road, z=rest)
    m.attach("vertical_tyre", ["tyre.drop"], stiffness=K, damping=0.0)
    m.prescribe("hub.x", fx.Polynomial((0.0, speed)))
    m.fix("wheel", "hub.y")
    m.independent("hub.z")
    motion = m.build().simulate(2.0, rtol=1e-10, atol=1e-12)
    w, W, t = np.sqrt(K / 400), 2 * np.pi * speed * np.cos(heading) / wavelength, motion.t
    expected = A / 2 * (1 - np.cos(w * t) - w**2 / (w**2 - W**2) * (np.cos(W * t) - np.cos(w * t)))
    assert motion["hub.z"] - rest == pytest.approx(expected, abs=1e-9)


def test_a_wheel_that_bounces_leaves_the_road_and_keeps_its_energy() -> None:
    m = wheel(z=0.45)
    m.fix("wheel", "hub.x", "hub.y")
    m.attach("vertical_tyre", ["tyre.drop"], stiffness=K, damping=0.0)
    fall = np.sqrt(2 * (0.45 - R) / 9.81)
    w, v = np.sqrt(K / 400.0), np.sqrt(2 * 9.81 * (0.45 - R))
    contact = (
        2 * (np.pi - np.arctan(v * w / 9.81)) / w
    )  # m x'' = m g - k x from x = 0 at speed v, until x = 0 again
    motion = m.build().simulate(2 * fall + contact, rtol=1e-10)
    assert motion.force("tyre.drop").min() == 0.0
    assert motion[-1]["hub.z"] == pytest.approx(0.45, abs=1e-6)
    E = motion.energy["total"]
    assert np.ptp(E) < 1e-7 * E[0]


def side_force(
    load: float, alpha: float, camber: float, law: str = "calspan_tyre", **parameters: object
) -> tuple[float, float]:
    """Side force and moment of a tyre pressed by a load, at a slip angle and a camber."""
    depth = load / K
    m = wheel(fx.turn((1, 0, 0), camber), z=(R - depth) * np.cos(camber))
    m.attach(law, SIDE, stiffness=K, damping=0.0, **parameters)
    s = moving(m, (20.0, 20.0 * np.tan(alpha), 0), (0, 0, 0))
    assert s.force("tyre.deflection") == pytest.approx(load, rel=1e-9, abs=1e-6)
    return -s.force("tyre.lateral"), -s.force("tyre.spin")


def test_the_calspan_tyre_is_linear_at_first_and_slides_in_the_end() -> None:
    load = 3800.0
    C_alpha = 2625.0 + 14.47 * load * (1 - load / 12930.0)
    C_gamma = 2.29 * load * (1 - load / 18175.0)
    mu = 1.0274 * (-0.464e-4 * load + 1.216 + 2.18e-11 * load**2)
    small = 1e-6
    Fy, Mz = side_force(load, small, 0.0, **CALSPAN)
    assert Fy == pytest.approx(-C_alpha * small, rel=1e-5)
    assert Mz / Fy == pytest.approx(-0.171e-4 * load, rel=2e-5)
    assert side_force(load, 0.0, small, **CALSPAN)[0] == pytest.approx(-C_gamma * small, rel=1e-5)
    for alpha in (0.6, -1.2):
        assert side_force(load, alpha, 0.0, **CALSPAN)[0] == pytest.approx(
            -np.sign(alpha) * mu * load, rel=1e-12
        )


def test_a_tyre_off_the_road_has_no_force_and_beyond_its_data_goes_on() -> None:
    assert side_force(0.0, 0.1, 0.0, **CALSPAN) == (0.0, 0.0)
    load, alpha = 40000.0, 1.2
    mu = 1.0274 * (-0.464e-4 * 12930.0 + 1.216 + 2.18e-11 * 12930.0**2)
    slip = 2625.0 * alpha / (mu * load)
    expected = -mu * load * (slip - slip**2 / 3 + slip**3 / 27)
    assert side_force(load, alpha, 0.0, **CALSPAN)[0] == pytest.approx(expected, rel=1e-12)


@pytest.mark.parametrize("method", ["DOP853", "generalized-alpha"])
def test_a_motion_that_leaves_the_data_of_a_tyre_says_so_by_name(method: str) -> None:
    m = wheel(z=0.45)
    m.fix("wheel", "hub.x", "hub.y")
    m.attach("calspan_tyre", SIDE, stiffness=K, damping=0.0, **CALSPAN)
    system = m.build()
    weight, impact = 400 * 9.81, 400 * K * 2 * 9.81 * (0.45 - R)
    largest = weight + np.sqrt(weight**2 + impact)
    with pytest.warns(
        fx.RangeWarning, match=r"tyre\.deflection: (\d+) N at t = .* calspan_tyre end at 12930 N"
    ) as found:
        motion = system.simulate(0.25, method=method, samples=251, progress=False)
    assert int(str(found[0].message).split()[1]) == pytest.approx(largest, rel=1e-3)
    assert motion.force("tyre.deflection").max() == pytest.approx(largest, rel=1e-3)
    system.simulate(
        0.13, method=method, samples=14, progress=False
    )  # still falling: no warning, which would be an error


def test_a_tyre_that_stands_has_no_side_force() -> None:
    m = wheel(fx.turn((1, 0, 0), 0.05), z=0.35)
    m.attach("calspan_tyre", SIDE, stiffness=K, damping=0.0, **CALSPAN)
    s = m.build().initial
    assert s.force("tyre.deflection") > 0
    assert s.force("tyre.lateral") == 0.0


def test_the_linear_tyre() -> None:
    Fy, Mz = side_force(
        3000.0, 0.2, 0.0, "linear_tyre", cornering=4e4, camber_stiffness=7e3, trail=0.06, standstill=0.1
    )
    assert (Fy, Mz) == pytest.approx((-4e4 * 0.2, 0.06 * 4e4 * 0.2), rel=1e-12)


def sled(speed: float, spin: float, sideways: float = 0.0) -> fx.Model:
    """A wheel with a Magic Formula tyre on a body that only slides in x and z; its turning is prescribed."""
    m = fx.Model(gravity=(0, 0, -9.81))
    m.point("hub", (0, 0, R - 400 * 9.81 / K))
    for name, fixed in (("still", True), ("wheel", False)):
        m.frame(name, fixed=fixed)
    m.hinge("spin", "still", "wheel", axis=(0, 1, 0))
    m.body("mass", "hub", "wheel", mass=400.0, inertia=(6.0, 10.0, 6.0))
    m.tyre("tyre", "hub", "wheel", radius=R, axle=(0, 1, 0))
    m.attach("magic_formula", MAGIC_ON, name="rubber", stiffness=K, damping=0.0, **MAGIC)
    m.prescribe("spin.angle", fx.Polynomial((0.0, spin)))
    m.prescribe("hub.y", fx.Polynomial((0.0, sideways)))
    m.initial("hub.x", rate=speed)
    return m


def test_a_locked_wheel_is_braked_by_friction() -> None:
    s = sled(20.0, 0.0).build()
    motion = s.simulate(1.0, rtol=1e-8)
    kappa = motion[-1]["rubber.kappa"]
    assert kappa == pytest.approx(-1.0, abs=1e-6)
    load, mu = 400 * 9.81, 1.0 - 0.1 * (400 * 9.81 / 4000.0 - 1)
    slip = 20.0 / mu
    b = slip / 1.4
    brake = mu * load * np.sin(1.4 * np.arctan(b + 0.5 * (b - np.arctan(b))))
    assert motion[-1].acceleration("hub.x") == pytest.approx(-brake / 400.0, rel=1e-5)
    assert brake < mu * load


def test_a_rolling_wheel_is_not_braked_and_slip_builds_up_over_the_relaxation_length() -> None:
    free = sled(20.0, 20.0 / 0.35).build().simulate(0.2, atol=1e-13)
    assert np.abs(free.acceleration("hub.x")).max() < 1e-9
    side = 0.02 * 20.0
    motion = sled(20.0, 20.0 / 0.35, side).build().simulate(0.1, rtol=1e-10)
    travelled = motion["hub.x"]
    assert motion["rubber.tan_alpha"] == pytest.approx(0.02 * (1 - np.exp(-travelled / 0.4)), abs=1e-6)


@pytest.mark.parametrize("crown", [0.0, 0.08])
def test_a_wheel_that_leans_over_its_contact_point_does_not_slip(crown: float) -> None:
    """The centre moves sideways with the lean rate, the contact point does not: there is no slip angle to build up."""
    rate, speed = 1.3, 20.0
    m = wheel(crown=crown)
    m.attach("magic_formula", MAGIC_ON, name="rubber", stiffness=K, damping=0.0, **MAGIC)
    s = moving(m, (speed, -rate * H, 0), (rate, speed / MAGIC["rolling_radius"], 0))  # type: ignore[operator]
    assert s.rate("tyre.sideways") == pytest.approx(-rate * H)
    assert s.rate("tyre.lateral") == pytest.approx(0.0, abs=1e-12)
    assert s.zd == pytest.approx([0.0, 0.0], abs=1e-9)


def test_longitudinal_force_takes_from_the_side_force() -> None:
    both = [sled(20.0, spin, 1.0).build().simulate(0.3)[-1] for spin in (20.0 / 0.35, 10.0)]
    side, braked = (abs(state.force("tyre.lateral")) for state in both)
    assert braked < 0.5 * side
    total = np.hypot(both[1].force("tyre.lateral"), both[1].force("tyre.longitudinal"))
    load = both[1].force("tyre.deflection")
    assert total < (1.0 - 0.1 * (load / 4000.0 - 1)) * load


def test_a_tyre_takes_its_law_in_one_call() -> None:
    """The same forces as with the quantities in the law's order, by its arguments, and in the call of the tyre."""
    found, lean = [], fx.turn((1, 0, 0), 0.1)
    for way in ("order", "names", "tyre"):
        m = fx.Model(gravity=(0, 0, -9.81))
        m.point("hub", (0, 0, H))
        m.frame("wheel", lean)
        m.body("body", "hub", "wheel", mass=20.0, inertia=(0.5, 0.9, 0.5))
        law = MAGIC | {"stiffness": K, "damping": 50.0}
        own: dict[str, Any] = {"law": "magic_formula", **law} if way == "tyre" else {}
        m.tyre("tyre", "hub", "wheel", radius=R, axle=matrix(lean)[:, 1], **own)
        if way == "order":
            m.attach("magic_formula", MAGIC_ON, **law)
        elif way == "names":
            m.attach("magic_formula", {name.partition(".")[2]: name for name in reversed(MAGIC_ON)}, **law)
        m.angular_velocity("wheel")
        found.append(moving(m, (7.0, 0.5, 0), (0, 20.0, 0)))
    for state in found[1:]:
        np.testing.assert_array_equal(state.a, found[0].a)
    assert np.abs(found[0].a).max() > 1.0
    assert tuple(found[0].structure.internal) == ("tyre.kappa", "tyre.tan_alpha")
