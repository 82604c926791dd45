"""Viscous slips: a wheel that slides and spins up."""

import numpy as np

from flexel.parts.model import Model


def rolling(release: bool, drag: float | None) -> Model:
    """A wheel upright on a road, free in its slips or not."""
    m = Model(gravity=(0, 0, -9.81))
    m.point("hub", (0, 0, 0.3))
    m.point("contact", (0, 0, 0))
    m.frame("R")
    m.wheel("w", "hub", "R", "contact", radius=0.3, axle=(0, 1, 0))
    m.body("disc", "hub", "R", mass=2.0, inertia=(0.05, 0.09, 0.05))
    if release:
        m.release("w.longitudinal", "w.lateral")
    if drag is not None:
        m.spring("w.longitudinal", damping=drag)
    return m


def test_viscous_slip_spins_a_sliding_wheel_up() -> None:
    """Sliding at first, the wheel takes up its rolling speed with the rate c (1/m + r²/I)."""
    c, mass, I, r, v0 = 4.0, 2.0, 0.09, 0.3, 3.0
    m = rolling(True, c)
    m.initial("hub.x", rate=v0)
    m.initial("R.lambda2", rate=0.0)
    s = m.build()
    motion = s.simulate(0.5, samples=11, rtol=1e-10, atol=1e-12)
    slip = motion.rate("w.longitudinal")
    rate = c * (1 / mass + r**2 / I)
    assert np.max(np.abs(np.abs(slip) - v0 * np.exp(-rate * motion.t))) < 1e-8
    assert np.max(np.abs(motion.force("w.longitudinal") - c * slip)) < 1e-9
    end = v0 / (1 + I / (mass * r**2))  # of pure rolling, from the angular momentum about the contact
    left = v0 * np.exp(-rate * 0.5)
    assert abs(motion[-1].rate("hub.x") - (end + left / (mass * (1 / mass + r**2 / I)))) < 1e-8
    power = motion.energy["total"]
    assert np.all(np.diff(power) < 0)


def test_viscous_slip_appears_in_the_linearized_damping() -> None:
    c = 4.0
    m = rolling(True, c)
    m.initial("hub.x", rate=1.0)
    s = m.build()
    lin = s.linearize(s.initial)
    w = np.linalg.eigvals(lin.state_matrix)  # of the rates alone: it slows down
    expected = -c * (1 / 2.0 + 0.3**2 / 0.09)
    assert np.min(np.abs(w - expected)) < 1e-6
