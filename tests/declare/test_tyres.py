"""Tyres and rolling wheels with a crown: geometry, forces, laws, and a torus rolling as its own equations say."""

from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import flexel as fx
from flexel.base.quaternions import matrix

R, H, K = 0.36, 0.35, 2e5
UP = np.array([0.0, 0.0, 1.0])
CALSPAN = {
    "A": (2625.0, 14.47, 12930.0, 2.29, 18175.0),
    "B": (-0.464e-4, 1.216, 2.18e-11),
    "SN": 1.0274,
    "AF": (-0.171e-4, 0.171e-4),
    "standstill": 0.1,
}
MAGIC = {
    "load0": 4000.0,
    "rolling_radius": 0.35,
    "friction": (1.0, -0.1),
    "slip_stiffness": 20.0,
    "cornering": (15.0, 2.0),
    "camber_stiffness": 0.5,
    "shape": (1.4, -0.5),
    "trail": (0.03, 8.0),
    "relaxation": (0.2, 0.4),
}
PARTS = ("deflection", "camber", "forward", "sideways", "rolling", "longitudinal", "lateral", "spin")
SIDE = [
    f"tyre.{z}" for z in PARTS if z not in ("rolling", "longitudinal")
]  # of the linear and the CALSPAN law
MAGIC_ON = [f"tyre.{z}" for z in PARTS if z != "sideways"]


def wheel(
    orientation: object = (1, 0, 0, 0), crown: float = 0.0, road: fx.Waves | None = None, **at: float
) -> fx.Model:
    """A free wheel with a tyre, its centre H above the road; its axle is its own y axis."""
    m = fx.Model(gravity=(0, 0, -9.81))
    m.point("hub", (at.get("x", 0.0), 0, at.get("z", H)))
    m.frame("wheel", orientation)
    m.body("mass", "hub", "wheel", mass=400.0, inertia=(6.0, 10.0, 6.0))
    axle = matrix(np.array(orientation, dtype=float))[:, 1]
    m.tyre("tyre", "hub", "wheel", radius=R, axle=axle, crown=crown, road=road)
    m.angular_velocity("wheel")
    return m


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
    force = 400.0 * np.array([s.acceleration(f"hub.{z}") for z in "xyz"]) + [0, 0, 400.0 * 9.81]
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
    free = sled(20.0, 20.0 / 0.35).build().simulate(0.2)
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
    side, braked = (abs(z.force("tyre.lateral")) for z in both)
    assert braked < 0.5 * side
    total = np.hypot(both[1].force("tyre.lateral"), both[1].force("tyre.longitudinal"))
    load = both[1].force("tyre.deflection")
    assert total < (1.0 - 0.1 * (load / 4000.0 - 1)) * load


# -- the torus ------------------------------------------------------------------------------------

MASS, RING, CROSS = 2.0, 0.08, 0.05  # inertias about and across the axle


def torus(crown: float, lean: float, rates: tuple[float, float, float]) -> fx.System:
    """A rolling wheel of radius 0.3 m with a crown; rates of yaw, lean and spin."""
    m = fx.Model(gravity=(0, 0, -9.81))
    ground, yawed, leaned, rolled = (m.frame(z, fixed=z == "ground") for z in ("ground", "Y", "L", "S"))
    m.point("hub", (0, 0, 0.3))
    m.point("contact", (0, 0, 0))
    m.hinge("yaw", ground, yawed, axis=(0, 0, 1))
    m.hinge("lean", yawed, leaned, axis=(1, 0, 0))
    m.hinge("roll", leaned, rolled, axis=(0, 1, 0))
    m.wheel("wheel", "hub", rolled, "contact", radius=0.3, axle=(0, 1, 0), crown=crown)
    m.body("body", "hub", rolled, mass=MASS, inertia=(CROSS, RING, CROSS))
    m.independent("yaw.angle", "lean.angle", "roll.angle")
    m.kinematic("contact.x", "contact.y")
    m.initial("lean.angle", lean, rate=rates[1])
    m.initial("yaw.angle", rate=rates[0])
    m.initial("roll.angle", rate=rates[2])
    return m.build()


def newton_euler(crown: float, a: np.ndarray, omega: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Rates of the axle and the angular velocity of a rolling torus, by the momenta about its centre."""
    rim = 0.3 - crown

    def arm(axle: np.ndarray) -> np.ndarray:
        inward = UP - (axle @ UP) * axle
        return -rim * inward / np.linalg.norm(inward) - crown * UP

    ad, h = np.cross(omega, a), 1e-6
    c, cd = arm(a), (arm(a + h * ad) - arm(a - h * ad)) / (2 * h)
    # centre: v = -omega x c, so v' = c x omega' - omega x c';  force F = m (v' + g up);  moment c x F
    given = MASS * (-np.cross(omega, cd) + 9.81 * UP)
    spin = (RING - CROSS) * (omega @ a)
    A = np.zeros((3, 3))
    for i, unit in enumerate(np.eye(3)):
        A[:, i] = CROSS * unit + (RING - CROSS) * (unit @ a) * a - np.cross(c, MASS * np.cross(c, unit))
    rhs = np.cross(c, given) - spin * ad - (RING - CROSS) * (omega @ ad) * a
    return ad, np.linalg.solve(A, rhs)


@pytest.mark.parametrize("crown", [0.02, 0.15, 0.27])
def test_a_torus_rolls_as_newton_and_euler_say(crown: float) -> None:
    system = torus(crown, 0.35, (0.4, -0.3, 9.0))
    motion = system.simulate(1.5, rtol=1e-11, atol=1e-12, times=np.linspace(0, 1.5, 16))
    axle = np.array([matrix(state.position("S"))[:, 1] for state in motion])
    R0 = matrix(motion[0].position("L"))
    omega = np.array([0, 0, 0.4]) + np.array([-0.3, 0, 0]) + 9.0 * R0[:, 1]

    def rhs(_: float, y: np.ndarray) -> np.ndarray:
        return np.concatenate(newton_euler(crown, y[:3], y[3:]))

    y0 = np.concatenate([R0[:, 1], omega])
    found = solve_ivp(rhs, (0, 1.5), y0, t_eval=motion.t, rtol=1e-11, atol=1e-12)
    assert np.abs(axle - found.y[:3].T).max() < 1e-8
    assert np.ptp(motion.energy["total"]) < 1e-9 * motion[0].energy.total


def test_a_crown_of_nothing_is_the_knife_edge() -> None:
    thin = torus(1e-9, 0.35, (0.4, -0.3, 9.0)).initial
    sharp = torus(0.0, 0.35, (0.4, -0.3, 9.0)).initial
    for name in ("yaw.angle", "lean.angle", "roll.angle"):
        assert thin.acceleration(name) == pytest.approx(sharp.acceleration(name), rel=1e-7)


def test_wheels_that_cannot_be_are_refused_by_name() -> None:
    m = fx.Model()
    m.point("hub", (0, 0, R))
    m.point("contact", (0, 0, 0))
    m.frame("wheel")
    with pytest.raises(fx.ModelError, match=r"tyre 'A': its axle .* normal to the road.*tilt it"):
        m.tyre("A", "hub", "wheel", radius=R, axle=(0, 0, 1))
    with pytest.raises(fx.ModelError, match=r"wheel 'B': crown 0.4 m reaches to the axle"):
        m.wheel("B", "hub", "wheel", "contact", radius=R, axle=(0, 1, 0), crown=0.4)
    with pytest.raises(fx.ModelError, match=r"tyre 'C': a plane and waves are both given"):
        m.tyre("C", "hub", "wheel", radius=R, axle=(0, 1, 0), height=0.1, road=fx.Waves(0.1, 5.0))
    with pytest.raises(fx.ModelError, match=r"tyre 'D': wavelength -1 is not positive"):
        m.tyre("D", "hub", "wheel", radius=R, axle=(0, 1, 0), road=fx.Waves(0.1, -1.0))
    with pytest.raises(fx.ModelError, match=r"tyre 'E': count of waves 0.5 is not whole.*give a whole"):
        m.tyre("E", "hub", "wheel", radius=R, axle=(0, 1, 0), road=fx.Waves(0.1, 5.0, count=0.5))
    for normal in (None, 1.0):
        with pytest.raises(fx.ModelError, match=r"tyre 'F': road normal .*; give"):
            m.tyre("F", "hub", "wheel", radius=R, axle=(0, 1, 0), normal=normal, road=fx.Waves(0.1, 5.0))


@pytest.mark.parametrize(
    ("road", "below"),
    [
        ({"height": R + 0.1}, "0.1"),
        ({"normal": (0, 0, -1)}, "0.36"),
        ({"road": fx.Waves(1.0, 4.0, start=-2.0)}, "0.64"),
    ],
)
def test_a_tyre_whose_hub_lies_below_the_road_is_refused(road: dict[str, Any], below: str) -> None:
    m = fx.Model()
    m.point("hub", (0, 0, R))
    m.frame("wheel")
    with pytest.raises(fx.ModelError, match=f"tyre 'A': its hub lies {below} m below the road.*put it above"):
        m.tyre("A", "hub", "wheel", radius=R, axle=(0, 1, 0), **road)


@pytest.mark.parametrize("left", [("hub",), None, "hub"])
def test_an_axle_slip_between_anything_but_two_wheels_is_refused(left: Any) -> None:
    m = fx.Model()
    m.point("hub", (0, 0, R))
    m.frame("wheel")
    with pytest.raises(fx.ModelError, match=r"axle slip 'A': left .* is not a hub and its frame; give"):
        m.axle_slip("A", left, ("hub", "wheel"), axle=(0, 1, 0))


@pytest.mark.parametrize(
    ("law", "change", "message"),
    [
        ("vertical_tyre", {"stiffness": -1e5}, "stiffness -100000 is negative"),
        ("vertical_tyre", {"damping": -1.0}, "damping -1 is negative"),
        ("linear_tyre", {"standstill": -1.0}, "standstill -1 is not positive"),
        ("linear_tyre", {"cornering": -1.0}, "cornering -1 is negative"),
        ("calspan_tyre", {"A": (2625.0, 14.47, 0.0, 2.29, 18175.0)}, "A, entry 3, 0 is not positive"),
        ("calspan_tyre", {"A": (2625.0, 14.47, 12930.0, 2.29, 0.0)}, "A, entry 5, is zero"),
        ("calspan_tyre", {"SN": 0.0}, "SN 0 is not positive"),
        ("magic_formula", {"relaxation": (0, 0)}, "relaxation, entry 1, 0 is not positive"),
        ("magic_formula", {"cornering": (12, 0)}, "cornering, entry 2, 0 is not positive"),
        ("magic_formula", {"load0": -4000.0}, "load0 -4000 is not positive"),
    ],
)
def test_parameters_of_tyres_without_physical_sense_are_refused(
    law: str, change: dict[str, Any], message: str
) -> None:
    linear = {"cornering": 1e4, "camber_stiffness": 0.0, "trail": 0.0, "standstill": 0.1}
    own: dict[str, Any] = {
        "vertical_tyre": {},
        "linear_tyre": linear,
        "calspan_tyre": CALSPAN,
        "magic_formula": MAGIC,
    }
    on = {"vertical_tyre": ["tyre.deflection"], "magic_formula": MAGIC_ON}.get(law, SIDE)
    values = {"stiffness": K, "damping": 0.0, **own[law], **change}
    with pytest.raises(fx.ModelError, match=f"law '{law}' on 'tyre.deflection'.*: parameter {message}"):
        wheel().attach(law, on, **values)
