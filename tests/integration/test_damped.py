"""What generalized-alpha takes out of a motion is small, or told."""

import numpy as np
import pytest

import flexel as fx


def slider(stiffness: float, start: float) -> fx.System:
    """A unit mass on a spring to the ground along x, drawn at 0.1 m and displaced."""
    m = fx.Model()
    m.point("A", (0.1, 0))
    m.fix("A.y")
    m.point_mass("mass", "A", 1.0)
    m.spring("A.x", stiffness)
    m.initial("A.x", 0.1 + start)
    return m.build()


def test_a_vibration_much_smaller_than_the_machine_keeps_its_amplitude() -> None:
    motion = slider(1e4, 1e-7).simulate(1.0, method="generalized-alpha", samples=401)
    assert np.abs(motion["A.x"][-40:] - 0.1).max() == pytest.approx(1e-7, rel=0.03)


def test_a_rotor_that_long_steps_slow_down_is_told() -> None:
    m = fx.Model()
    O, R0, R = m.point("O", (0, 0, 0), fixed=True), m.frame("R0", fixed=True), m.frame("R")
    m.hinge("h", R0, R, axis=(0, 0, 1))
    m.body("rotor", O, R, mass=1.0, inertia=(1.0, 1.0, 1.0))
    m.initial("h.angle", rate=10.0)
    with pytest.warns(fx.DampingWarning, match=r"generalized-alpha has taken out .* J, .*mean step"):
        motion = m.build().simulate(2.0, method="generalized-alpha", step=0.052, spectral_radius=0.0)
    assert len(motion.warnings) == 1
