"""Explicit steps end where a contact begins and ends, so that its force is smooth within each of them."""

import numpy as np
import pytest

import flexel as fx

HEIGHT, STIFFNESS, G = 0.1, 1e4, 9.81  # [m], [N/m], [m/s²]; the mass is 1 kg


def dropped() -> fx.System:
    """A mass above a floor that is a linear spring."""
    m = fx.Model(gravity=(0, -G))
    m.point("O", (0, 0), fixed=True)
    m.angle("ground", fixed=True)
    m.plane("floor", "O", "ground", normal=(0, 1))
    m.point("ball", (0, HEIGHT))
    m.fix("ball.x")
    m.point_mass("mass", "ball", 1.0)
    m.contact("touch", "ball", "floor", fx.Contact(STIFFNESS, exponent=1.0))
    return m.build()


def bounced(t: float) -> float:
    """Height of the mass: free fall, and half vibrations about the depth at which it would rest."""
    omega, rest = np.sqrt(STIFFNESS), G / STIFFNESS
    speed, fall = np.sqrt(2 * G * HEIGHT), np.sqrt(2 * HEIGHT / G)
    touch = (np.pi + 2 * np.arctan(rest * omega / speed)) / omega
    t = (t + fall) % (2 * fall + touch)  # from the upward start of a flight
    if t < 2 * fall:
        return float(speed * t - G * t**2 / 2)
    s = omega * (t - 2 * fall)
    return float(rest * (np.cos(s) - 1) - speed / omega * np.sin(s))


@pytest.mark.parametrize("rtol", [1e-6, 1e-9])
def test_bounces_keep_to_the_tolerance(rtol: float) -> None:
    """Ten bounces on a linear spring, against the closed form: 20 rtol of the range."""
    motion = dropped().simulate(3.0, rtol=rtol, method="DOP853")
    error = np.abs(motion["ball.y"] - [bounced(t) for t in motion.t])
    assert (motion["touch.gap"] < 0).any()
    assert error.max() < 20 * rtol * np.ptp(motion["ball.y"])
