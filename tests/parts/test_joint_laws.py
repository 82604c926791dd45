"""Friction, stops and play of joints against closed forms."""

import numpy as np
import pytest
from differences import numerical_matrices, worst

import flexel as fx


def sled(**options: object) -> fx.Model:
    """A block of 2 kg on a guide along x."""
    m = fx.Model(gravity=(0, 0))
    m.rigid_body("block", (0, 0), mass=2.0, inertia=0.1)
    m.prismatic("guide", "ground", "block", axis=(1, 0), **options)  # type: ignore[arg-type]
    return m


def slowed(v: float, speed: float) -> float:
    """Integral of sqrt(v² + speed²)/v: its change is -limit/mass times the time."""
    root = np.hypot(v, speed)
    return float(root - speed * np.arcsinh(speed / v))


def test_friction_slows_a_block_as_its_integral_says() -> None:
    limit, speed = 3.0, 0.2
    m = sled(friction=(limit, speed))
    m.initial("guide.along", rate=4.0)
    motion = m.build().simulate(3.5, samples=8, rtol=1e-12, atol=1e-13)
    left = np.array([slowed(v, speed) for v in motion.rate("guide.along")])
    assert left[0] - left == pytest.approx(limit / 2.0 * motion.t, abs=1e-9)
    assert motion.rate("guide.along")[-1] < speed


def test_a_block_on_a_slope_reaches_the_speed_at_which_friction_carries_it() -> None:
    """F = limit v/sqrt(v² + speed²): below the limit it creeps, at v = speed F/sqrt(limit² - F²)."""
    m = sled(friction=(5.0, 0.01))
    m.load("block.x", 3.0)
    motion = m.build().simulate(1.0, rtol=1e-11, atol=1e-13)
    assert motion.rate("guide.along")[-1] == pytest.approx(0.01 * 3 / 4, rel=1e-9)


def test_friction_acts_on_slips_and_on_coordinates_too() -> None:
    limit, speed = 3.0, 0.2
    m = fx.Model(gravity=(0, 0))
    m.rigid_body("sled", (0, 0), mass=2.0, inertia=0.1)
    m.skate("blade", "sled", at=(0, 0), direction=(1, 0))
    m.friction("blade.forward", limit, speed)
    m.initial("sled.x", rate=4.0)
    m.point("P", (0, 0))
    m.point_mass("mass", "P", 2.0)
    m.friction("P.x", limit, speed)
    m.initial("P.x", rate=4.0)
    end = m.build().simulate(3.5, rtol=1e-12, atol=1e-13)[-1]
    for name in ("sled.x", "P.x"):
        assert slowed(4.0, speed) - slowed(end.rate(name), speed) == pytest.approx(
            limit / 2.0 * 3.5, abs=1e-9
        )


def test_a_block_flies_and_bounces_between_two_stops() -> None:
    """Half a swing of sqrt(k/m) at each stop, free flight between: after a period it is where it was."""
    low, high, k, v = -0.3, 0.5, 800.0, 2.0
    period = 2 * ((high - low) / v + np.pi * np.sqrt(2.0 / k))
    m = sled(stops=(low, high, k))
    m.initial("guide.along", rate=v)
    end = m.build().simulate(2 * period, rtol=1e-11, atol=1e-12, max_step=1e-3)[-1]
    assert end["guide.along"] == pytest.approx(0.0, abs=1e-7)
    assert end.rate("guide.along") == pytest.approx(v, abs=1e-9)


def test_stops_carry_a_load_on_either_side() -> None:
    for force in (4.0, -4.0):
        m = sled(stops=(-0.3, 0.5, 800.0), damping=1.0)
        m.load("guide.along", force)
        m.initial("guide.along", 0.6 if force > 0 else -0.4)
        rest = m.build().equilibrium()
        assert rest["guide.along"] == pytest.approx((0.5 if force > 0 else -0.3) + force / 800.0, rel=1e-12)


def test_stops_lose_energy_when_they_are_struck_from_either_side() -> None:
    lost = []
    for rate in (2.0, -2.0):
        m = sled(stops=(-0.4, 0.4, 800.0, 0.3))
        m.initial("guide.along", rate=rate)
        lost.append(abs(m.build().simulate(0.5, rtol=1e-10)[-1].rate("guide.along")))
    assert lost[0] == pytest.approx(lost[1], rel=1e-8) and lost[0] < 1.8


def loose(planar: bool, gap: float = 0.002, stiffness: float = 5e4, **options: float) -> fx.Model:
    """A disc of 2 kg on a pin with play, held against turning over by the joint."""
    m = fx.Model(gravity=(0, 0) if planar else (0, 0, 0))
    m.rigid_body(
        "disc", (0, 0) if planar else (0, 0, 0), mass=2.0, inertia=0.1 if planar else (0.1, 0.1, 0.1)
    )
    m.revolute(
        "pin", "ground", "disc", at=(0, 0) if planar else (0, 0, 0), axis=None if planar else (0, 0, 1)
    )
    m.clearance("pin", gap, stiffness, **options)
    return m


@pytest.mark.parametrize("planar", [True, False])
def test_a_pin_with_play_rests_beyond_its_gap(planar: bool) -> None:
    m = loose(planar)
    assert m.build().counts["degrees_of_freedom"] == 3
    m.load("disc.x", 30.0)
    m.load("disc.y", -40.0)
    reach = 0.002 + 50.0 / 5e4
    m.initial("disc.x", 0.5 * reach)
    m.initial("disc.y", -0.8 * reach)
    rest = m.build().initial
    assert rest["disc.x"] == pytest.approx(0.5 * reach)
    m.initial("disc.x", 0.6 * reach)
    rest = m.build().initial
    assert rest.acceleration("disc.x") == pytest.approx(0.0, abs=1e-9)
    assert rest.acceleration("disc.y") == pytest.approx(0.0, abs=1e-9)


def test_a_pin_rattles_across_its_play_with_the_period_of_flight_and_contact() -> None:
    v, w = 0.2, np.sqrt(5e4 / 2.0)
    period = 2 * (2 * 0.002 / v + np.pi / w)
    m = loose(True)
    m.initial("disc.x", rate=v)
    end = m.build().simulate(period, rtol=1e-11, atol=1e-13)[-1]
    assert end["disc.x"] == pytest.approx(0.0, abs=1e-8)
    assert end.rate("disc.x") == pytest.approx(v, abs=1e-9)


def test_a_loaded_pin_with_play_rubs() -> None:
    """The moment is friction_radius times the load; it stops a disc that turns, linearized as it moves."""
    m = loose(True, 0.2, 250.0, friction_radius=0.004, slip_speed=0.1, damping=0.3)
    m.load("disc.y", -50.0)
    m.initial("disc.y", -0.2 - 50.0 / 250.0)
    m.initial("disc.x", rate=0.3)
    m.initial("pin.angle", rate=3.0)
    s = m.build()
    w = 3.0 / np.hypot(3.0, 0.1)
    assert s.initial.acceleration("pin.angle") == pytest.approx(-0.004 * 50.0 * w / 0.1, rel=1e-9)
    lin = s.linearize()
    for own, numerical in zip((lin.M, lin.C, lin.K), numerical_matrices(s, s.initial), strict=True):
        assert worst(own, numerical) < 1e-6


def test_wrong_numbers_are_refused_by_name() -> None:
    m = sled()
    with pytest.raises(fx.ModelError, match=r"limits on 'guide.along': low 1 is not below high 0"):
        m.limits("guide.along", 1.0, 0.0, 10.0)
    with pytest.raises(fx.ModelError, match=r"friction on 'guide.along': speed 0 is not positive"):
        m.friction("guide.along", 1.0, 0.0)
    with pytest.raises(fx.ModelError, match=r"clearance of 'block_body': it is not a joint with a pin"):
        m.clearance("block_body", 0.1, 1.0)
    with pytest.raises(
        fx.ModelError, match=r"joint 'z': stops 3 are not numbers; give \(low, high, stiffness\)"
    ):
        m.prismatic("z", "ground", "block", axis=(1, 0), stops=3)  # type: ignore[arg-type]
    assert "z" not in m.instances


def loose_ball(gap: float = 0.002, stiffness: float = 5e4, **options: float) -> fx.Model:
    """A body of 2 kg on a ball with play at its mass centre, in a socket of the ground."""
    m = fx.Model()
    m.rigid_body("bob", (0, 0, 0), mass=2.0, inertia=(0.1, 0.1, 0.1))
    m.spherical("ball", "ground", "bob", at=(0, 0, 0))
    m.clearance("ball", gap, stiffness, **options)
    return m


def test_a_ball_with_play_rests_beyond_its_gap_in_the_direction_of_the_load() -> None:
    assert loose_ball().build().counts["degrees_of_freedom"] == 6
    m, reach = loose_ball(), 0.002 + 70.0 / 5e4
    for axis, share in zip("xyz", (2 / 7, 3 / 7, -6 / 7), strict=True):
        m.load(f"bob.{axis}", 70.0 * share)
        m.initial(f"bob.{axis}", share * reach)
    rest = m.build().initial
    assert [rest.acceleration(f"bob.{axis}") for axis in "xyz"] == pytest.approx([0, 0, 0], abs=1e-9)


def test_a_ball_rattles_in_its_socket_and_loses_what_its_law_says() -> None:
    v, w = 0.2, np.sqrt(5e4 / 2.0)
    period = 2 * (2 * 0.002 / v + np.pi / w)
    m = loose_ball()
    for axis, share in zip("xyz", (2 / 7, 3 / 7, -6 / 7), strict=True):
        m.initial(f"bob.{axis}", rate=v * share)
    end = m.build().simulate(period, rtol=1e-11, atol=1e-13)[-1]
    assert end.position("bob") == pytest.approx([0, 0, 0], abs=1e-8)
    assert end.rate("bob.z") == pytest.approx(-6 / 7 * v, abs=1e-9)
    m = loose_ball(damping=1.0)
    m.initial("bob.x", rate=v)
    s = m.build()
    assert s.simulate(period, rtol=1e-10)[-1].rate("bob.x") < 0.95 * v


def test_a_ball_with_play_is_linearized_as_it_moves() -> None:
    m = loose_ball(0.2, 250.0, damping=0.3)
    for axis, value in zip("xyz", (0.1, 0.2, -0.2), strict=True):
        m.initial(f"bob.{axis}", value, rate=0.1)
    s = m.build()
    lin = s.linearize()
    for own, numerical in zip((lin.M, lin.C, lin.K), numerical_matrices(s, s.initial), strict=True):
        assert worst(own, numerical) < 1e-6


@pytest.mark.parametrize("planar", [True, False])
@pytest.mark.parametrize("kind", ["weld", "prismatic"])
def test_a_joint_that_does_not_turn_takes_no_play(kind: str, planar: bool) -> None:
    m, origin, inertia = fx.Model(), (0, 0, 0)[: 2 + (not planar)], 0.1 if planar else (0.1, 0.1, 0.1)
    m.rigid_body("block", origin, mass=2.0, inertia=inertia)
    if kind == "weld":
        m.weld("j", "ground", "block")
    else:
        m.prismatic("j", "ground", "block", axis=(1, 0, 0)[: 2 + (not planar)])
    laws = len(m.laws)
    with pytest.raises(
        fx.ModelError,
        match=r"clearance of 'j': it does not turn \('j\.angle' is rigid\), .*; use m\.revolute",
    ):
        m.clearance("j", 0.002, 5e4)
    assert len(m.laws) == laws


def test_a_ball_takes_no_friction_and_an_arm_no_play() -> None:
    with pytest.raises(fx.ModelError, match="clearance of 'ball': a ball has no angle for the friction"):
        loose_ball(friction_radius=0.01)
    m = loose_ball()
    m.point("tip", (1, 0, 0))
    m.beam("arm", "bob", "bob_frame", "tip", rigid=True)
    with pytest.raises(fx.ModelError, match="clearance of 'arm': it is not a joint with a pin or a ball"):
        m.clearance("arm", 0.002, 5e4)
