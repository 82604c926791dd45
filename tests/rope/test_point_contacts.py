"""Points, balls and discs in contact with surfaces, against closed forms."""

from typing import Any

import numpy as np
import pytest

import flexel as fx
from flexel.examples.rope_exact import hertz

G, A, MASS = 9.81, 0.1, 2.0
STIFF = 1e7


def ground(gravity: Any = (0, 0, -G)) -> fx.Model:
    """A model with a fixed point O and a fixed orientation."""
    m = fx.Model(gravity=gravity)
    planar = len(gravity) == 2
    m.point("O", (0, 0) if planar else (0, 0, 0), fixed=True)
    (m.angle if planar else m.frame)("ground", fixed=True)
    return m


def add_ball(m: fx.Model, centre: Any, mass: float = MASS) -> None:
    """A uniform ball, or a disc in the plane."""
    m.point("ball", centre)
    if len(centre) == 2:
        m.angle("R")
        m.body("mass", "ball", "R", mass=mass, inertia=mass * A**2 / 2)
    else:
        m.frame("R")
        m.body("mass", "ball", "R", mass=mass, inertia=[0.4 * mass * A**2] * 3)


def depth(stiffness: float = STIFF, load: float = MASS * G) -> float:
    return float((load / stiffness) ** (2 / 3))


# --- normal force ---------------------------------------------------------------------------------------------


def dropped(contact: fx.Contact, speed: float, duration: float) -> fx.Motion:
    """A ball that hits a floor without gravity."""
    m = ground(gravity=(0, 0, 0))
    m.plane("floor", "O", "ground")
    add_ball(m, (0, 0, A))
    m.contact("touch", "ball", "floor", contact, frame="R", radius=A)
    m.initial("ball.z", rate=-speed)
    return m.build().simulate(duration, samples=4001, rtol=1e-10, atol=1e-13, progress=False)


def test_elastic_impact_has_the_depth_and_duration_of_hertz() -> None:
    speed = 0.5
    approach, duration = hertz(STIFF, MASS, speed)
    motion = dropped(fx.Contact(STIFF), speed, 1.2 * duration)
    gap, force = motion["touch.gap"], -motion.force("touch.gap")
    assert -gap.min() == pytest.approx(approach, rel=1e-6)
    assert force.max() == pytest.approx(STIFF * approach**1.5, rel=1e-6)
    last = int(np.flatnonzero(gap < 0)[-1])
    assert motion.t[last] - gap[last] / speed == pytest.approx(duration, rel=1e-6)
    assert np.all(force[last + 1 :] == 0)
    assert motion.rate("ball.z")[-1] == pytest.approx(speed, rel=1e-8)


def test_impact_with_dissipation_has_the_speed_of_hunt_and_crossley() -> None:
    """F(v) = v/a - ln(1 + a v)/a² is the same at both ends of the impact, for the speeds of approach v and -v'."""
    speed = 0.5
    contact = fx.Contact.restitution(STIFF, 0.8, speed)
    a = contact.dissipation
    motion = dropped(contact, speed, 1.3 * hertz(STIFF, MASS, speed)[1])

    def F(v: float) -> float:
        return float(v / a - np.log1p(a * v) / a**2)

    leaving = motion.rate("ball.z")[-1]
    assert F(-leaving) == pytest.approx(F(speed), rel=1e-7)
    assert 0.8 < leaving / speed < 0.9


def test_a_foot_off_the_point_of_its_body_carries_its_share() -> None:
    """A bar on a hinge with a foot at the distance x: N = m g c/x at rest, drawn pressed so that it is stiff."""
    m = ground()
    m.plane("floor", "O", "ground", normal=(0, 0, 1))
    m.point("P", (0, 0, A), fixed=True)
    m.frame("R")
    m.hinge("pivot", "ground", "R", axis=(0, 1, 0))
    m.body("bar", "P", "R", mass=MASS, inertia=(0.1, 0.1, 0.1), offset=(0.5, 0, 0))
    m.contact("foot", "P", "floor", fx.Contact(STIFF), frame="R", at=(0.8, 0.3, A - 1e-4), radius=A)
    rest = m.build().equilibrium()
    assert rest.force("foot.gap") == pytest.approx(-MASS * G * 0.5 / 0.8, rel=1e-4)
    assert rest["foot.gap"] == pytest.approx(-depth(load=MASS * G * 0.5 / 0.8), rel=1e-4)


# --- friction -------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(("planar", "share"), [(False, 2 / 5), (True, 1 / 2)])
def test_a_sliding_ball_rolls_in_the_end(planar: bool, share: float) -> None:
    """Speed v0/(1 + k) for the inertia k m a², reached at k v0/((1 + k) mu g); until then it falls by mu g."""
    mu, v0 = 0.25, 2.0
    m = ground((0, -G) if planar else (0, 0, -G))
    m.plane("floor", "O", "ground", normal=(0, 1) if planar else (0, 0, 1))
    height = A - depth()
    add_ball(m, (0, height) if planar else (0, 0, height))
    m.contact("touch", "ball", "floor", fx.Contact(STIFF, friction=mu, slip_speed=1e-3), frame="R", radius=A)
    m.initial("ball.x", rate=v0)
    end = share / (1 + share) * v0 / (mu * G)
    motion = m.build().simulate(1.5 * end, samples=301, progress=False)
    speed, slip = motion.rate("ball.x"), motion.rate("touch.tangential" if planar else "touch.x")
    assert speed[-1] == pytest.approx(v0 / (1 + share), rel=1e-6)
    assert abs(slip[-1]) < 1e-9 * v0
    half = int(np.searchsorted(motion.t, end / 2))
    assert v0 - speed[half] == pytest.approx(mu * G * motion.t[half], rel=1e-5)
    sliding = motion.t[slip > 1e-2 * v0]
    assert sliding[-1] == pytest.approx(0.99 * end, rel=2e-2)
    friction = motion.force("touch.tangential" if planar else "touch.x")
    assert friction[half] == pytest.approx(mu * MASS * G, rel=1e-5)


def incline(contact: fx.Contact, angle: float) -> fx.Model:
    """A point mass at rest on an inclined plane, as deep as its weight presses it."""
    m = ground()
    n, down = np.array([np.sin(angle), 0, np.cos(angle)]), np.array([np.cos(angle), 0, -np.sin(angle)])
    m.plane("slope", "O", "ground", normal=n)
    m.point("P", -depth(load=MASS * G * np.cos(angle)) * n)
    m.point_mass("mass", "P", MASS)
    m.contact("touch", "P", "slope", contact)
    for name, rate in zip(("P.x", "P.z"), 0.5 * down[[0, 2]], strict=True):
        m.initial(name, rate=rate)
    return m


def test_a_point_slides_down_an_incline() -> None:
    angle, mu = 0.6, 0.3
    m = incline(fx.Contact(STIFF, friction=mu, slip_speed=1e-4), angle)
    motion = m.build().simulate(0.5, samples=11, progress=False)
    expected = 0.5 + G * (np.sin(angle) - mu * np.cos(angle)) * motion.t
    assert motion.rate("touch.x") == pytest.approx(expected, rel=1e-6)
    assert np.hypot(motion.rate("P.x"), motion.rate("P.z")) == pytest.approx(expected, rel=1e-6)


def test_bristles_hold_a_point_on_an_incline() -> None:
    """Below the angle of friction it comes to rest and stays; Coulomb's regularized friction would creep."""
    angle = 0.25
    contact = fx.Contact(STIFF, dissipation=1.0, friction=0.5, bristle_stiffness=1e4, bristle_damping=20.0)
    motion = incline(contact, angle).build().simulate(1.0, samples=11, progress=False)
    assert abs(motion.rate("touch.x")[-1]) < 1e-6
    assert motion.force("touch.x")[-1] == pytest.approx(MASS * G * np.sin(angle), rel=1e-4)
    assert motion["P.x"][-1] - motion["P.x"][-2] == pytest.approx(0.0, abs=1e-7)


@pytest.mark.parametrize("spin", [0.0, 3.0])
def test_a_ball_leaves_a_turning_cylinder_where_it_leaves_a_resting_one(spin: float) -> None:
    """Rolling from the top without slip: at cos θ = 10/17, the speed of the cylinder does not matter."""
    R, start, stiff = 1.0, 0.3, 1e9
    m = ground()
    m.frame("F")
    m.hinge("axle", "ground", "F", axis=(0, 1, 0))
    m.prescribe("axle.angle", lambda t: spin * t)
    m.sheave("drum", "O", "F", radius=R, axle=(0, 1, 0))
    centre = (R + A) * np.array([np.sin(start), 0, np.cos(start)])
    add_ball(m, centre * (1 - depth(stiff, MASS * G * np.cos(start)) / (R + A)))
    contact = fx.Contact(stiff, dissipation=1.0, friction=8.0, slip_speed=1e-3)
    m.contact("touch", "ball", "drum", contact, frame="R", radius=A)
    w = m.angular_velocity("R")
    m.initial(f"{w}.wy", rate=-spin * R / A)
    motion = m.build().simulate(1.2, samples=2401, progress=False)
    first = int(np.flatnonzero(motion["touch.gap"] > 0)[0])
    cosine = motion["ball.z"] / np.hypot(motion["ball.x"], motion["ball.z"])
    # the energy of rolling: v² = (10/7) g (R + a)(cos θ0 - cos θ), and N = m g cos θ - m v²/(R + a)
    normal = MASS * G * (17 * cosine - 10 * np.cos(start)) / 7
    early = normal > 0.2 * MASS * G
    assert motion.force("touch.gap")[early] == pytest.approx(-normal[early], abs=1e-4 * MASS * G)
    assert cosine[first] == pytest.approx(10 / 17 * np.cos(start), rel=5e-3)
    assert abs(motion.rate("touch.tangential")[early]).max() < 1e-3


def test_a_ball_in_a_v_groove_is_driven_at_the_height_of_its_contacts() -> None:
    """Between flanks of half the angle β its contacts are a sin β off its own axle: w a sin β = W (R + a - a sin β)."""
    opening, R, W = 1.0, 0.4, 2.0
    m = ground(gravity=(0, 0, 0))
    m.frame("F")
    m.hinge("axle", "ground", "F", axis=(0, 0, 1))
    m.prescribe("axle.angle", lambda t: W * t)
    m.sheave("sheave", "O", "F", radius=R, groove=fx.VGroove(opening))
    m.frame("R")
    m.point("ball", (R + A - 1e-4, 0, 0), fixed=True)
    m.body("mass", "ball", "R", mass=MASS, inertia=[0.4 * MASS * A**2] * 3)
    m.hinge("idler", "ground", "R", axis=(0, 0, 1))
    m.contact("touch", "ball", "sheave", fx.Contact(STIFF, friction=0.3), frame="R", radius=A)
    motion = m.build().simulate(2.0, samples=101, progress=False)
    lever = A * np.sin(opening / 2)
    assert motion.rate("idler.angle")[0] == 0
    assert motion.rate("idler.angle")[-1] == pytest.approx(-W * (R + A - 1e-4 - lever) / lever, rel=1e-6)
    for slip in ("tangential1", "tangential2", "across1", "across2"):
        assert abs(motion.rate(f"touch.{slip}")[-1]) < 1e-6
    assert motion.force("touch.gap1") == pytest.approx(motion.force("touch.gap2"))
    # each flank is pressed by the depth times sin β, and both start with full friction
    normal = STIFF * (1e-4 * np.sin(opening / 2)) ** 1.5
    assert -motion.force("touch.gap1")[0] == pytest.approx(normal, rel=1e-6)
    assert np.hypot(motion.force("touch.tangential1")[0], motion.force("touch.across1")[0]) == pytest.approx(
        0.3 * normal, rel=1e-3
    )
