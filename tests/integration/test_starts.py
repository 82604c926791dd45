"""How a motion starts where a prescribed motion already has a velocity."""

import logging
from typing import Any

import numpy as np
import pytest

import flexel as fx
from flexel.base.arrays import Array

METHODS = ["DOP853", "Radau", "generalized-alpha", "auto"]
SPEED, OMEGA = 0.1, 10.0  # of the drive [m/s]; of the mass on its spring [rad/s]


def towed(named: bool = False, rate: float | None = None) -> fx.System:
    """A mass of 1 kg on a spring of 100 N/m, whose other end is moved at a constant speed."""
    m = fx.Model()
    m.point("A", (0, 0))
    m.point("B", (1, 0))
    m.fix("A.y", "B.y")
    m.truss("spring", "A", "B", stiffness=OMEGA**2)
    m.point_mass("block", "B", 1.0)
    m.prescribe("A.x", fx.Table([0, 10], [0, 10 * SPEED], kind="linear"))
    if named:
        m.independent("B.x")
    if rate is not None:
        m.initial("B.x", rate=rate)
    return m.build()


def place(t: Array, rate: float) -> Array:
    """Of the mass, in closed form, that starts at this rate."""
    return 1 + SPEED * t + (rate - SPEED) * np.sin(OMEGA * t) / OMEGA


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("named", [False, True])
def test_from_rest_the_drive_jumps_and_a_spring_gives_no_impulse(method: str, named: bool) -> None:
    """Whichever degree of freedom is chosen: with the stretch of the spring, the mass jumped with the drive."""
    system = towed(named)
    motion = system.simulate(1.0, start=system.at_rest, samples=21, method=method)
    error = 3e-5 if method == "generalized-alpha" else 1e-9
    assert motion["B.x"] == pytest.approx(place(motion.t, 0.0), abs=error)
    assert motion[0].rate("A.x") == 0.0 and motion[1].rate("A.x") == pytest.approx(SPEED)


@pytest.mark.parametrize("method", METHODS)
def test_a_rigid_rod_takes_the_mass_with_it(method: str) -> None:
    """The drive gives it its speed at once, and the energy balance counts from there."""
    m = fx.Model(gravity=(0, -9.81))
    m.point("A", (0, 0))
    m.point("B", (0, -1))
    m.fix("A.x")
    m.truss("rod", "A", "B")
    m.rigid("rod.elongation")
    m.point_mass("bob", "B", 1.0)
    m.prescribe("A.y", lambda t: SPEED * t)
    system = m.build()
    motion = system.simulate(1.0, start=system.at_rest, samples=5, method=method)
    assert motion["B.y"] == pytest.approx(-1 + SPEED * motion.t, abs=1e-9)
    assert not motion.warnings


@pytest.mark.parametrize("named", [False, True])
def test_without_a_given_start_the_machine_already_runs(named: bool) -> None:
    motion = towed(named).simulate(1.0, samples=11)
    assert motion["B.x"] == pytest.approx(1 + SPEED * motion.t, abs=1e-12)


@pytest.mark.parametrize("named", [False, True])
def test_a_given_rate_is_that_of_the_start(named: bool) -> None:
    motion = towed(named, rate=0.3).simulate(1.0, samples=11)
    assert motion["B.x"] == pytest.approx(place(motion.t, 0.3), abs=1e-9)


def test_both_are_logged(caplog: pytest.LogCaptureFixture) -> None:
    caplog.set_level(logging.INFO, "flexel")
    system = towed(named=True, rate=0.3)
    assert "at t = 0 s: B.x' = 0.3" in caplog.text
    system.simulate(0.1, start=system.at_rest, samples=2)
    assert "prescribed rates jump, since the start does not have them" in caplog.text


def test_a_ramp_that_begins_at_the_start_does_not_jump(caplog: pytest.LogCaptureFixture) -> None:
    caplog.set_level(logging.INFO, "flexel")
    m = fx.Model()
    m.point("A", (0, 0))
    m.fix("A.y")
    m.point_mass("block", "A", 1.0)
    m.prescribe("A.x", fx.Ramp(0, 1, 0, 1))
    m.point("B", (1, 0))
    m.fix("B.y")
    m.truss("spring", "A", "B", stiffness=100.0)
    m.point_mass("other", "B", 1.0)
    m.build().simulate(0.1, samples=2)
    assert "jump" not in caplog.text


@pytest.mark.parametrize(
    "drive",
    [
        lambda t: t,
        lambda t: abs(t),
        lambda t: np.where(t > 0, t, 0),
        lambda t: np.maximum(t, 0),
        lambda t: t if t > 0 else 0 * t,
        fx.Table([-1, 0, 2], [0, 0, 2], kind="linear"),
    ],
)
def test_a_drive_with_a_kink_at_the_start_has_its_rate_just_after(drive: Any) -> None:
    """Equal for t ≥ 0: the machine runs as a whole; it was hit by the drive where the formula has a kink at t = 0."""
    m = fx.Model()
    m.truss("t", m.point("w", (0, 0)), m.point("b", (10, 0)), stiffness=4.0)
    m.fix("w.y", "b.y")
    m.point_mass("mass", "b", 1.0)
    m.prescribe("w.x", drive)
    system = m.build()
    assert system.initial.t == 0.0 and system.initial.rate("w.x") == pytest.approx(1.0, abs=1e-12)
    assert system.initial.rate("b.x") == pytest.approx(1.0, abs=1e-12)
    assert system.simulate(1.0)["b.x"][-1] == pytest.approx(11.0, abs=1e-9)


def test_friction_on_a_moving_belt_stretches_no_spring_at_the_start() -> None:
    """The block started with half the speed of the belt: the friction law counted like the spring."""
    m = fx.Model()
    m.rigid_body("belt", (0, 0), mass=1.0, inertia=1.0)
    m.prismatic("guide", "ground", "belt", axis=(1, 0))
    m.rigid_body("block", (0, 1), mass=1.0, inertia=1.0)
    m.prismatic("slide", "belt", "block", axis=(1, 0), friction=(5.0, 1e-3))
    m.spring("block.x", 100.0)
    m.prescribe("guide.along", lambda t: 0.1 * t)
    assert m.build().initial.rate("block.x") == pytest.approx(0.0, abs=1e-12)
