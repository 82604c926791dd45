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
    assert lin.variation(np.array([3j])) == 0
    lin.eigenvalues()
