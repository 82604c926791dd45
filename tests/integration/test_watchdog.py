"""A motion that runs away is stopped with a reason; one that is slow for a while is not."""

import numpy as np
import pytest

import flexel as fx


def runaway() -> fx.System:
    """A flexible arm in space whose motor pushes its tip away from the middle: each element is bent by 90 degrees."""
    m = fx.Model(gravity=(0, 0, -9.81))
    m.frame("ground", fixed=True)
    m.frame("hub")
    m.point("O", (0, 0, 0), fixed=True)
    m.hinge("motor", "ground", "hub", axis=(0, 0, 1))
    m.rotary_inertia("disc", "hub", 0.01 * np.eye(3))
    m.point("P", (0.5, 0, 0))
    m.point("tip", (1, 0, 0))
    stiff = {"EA": 1e5, "GJ": 1.0, "EIy": 1.0, "EIz": 1.0}
    line = {"mass_per_length": 0.2, "inertia_per_length": (1e-5, 1e-5, 1e-5), "damping": 1e-4}
    m.beam("inner", "O", "hub", "P", m.frame("R"), **stiff, **line)
    m.beam("outer", "P", "R", "tip", m.frame("end"), **stiff, **line)
    m.controller([[-1e4, -1e3]], inputs=["tip.y", "tip.y'"], outputs=["motor.angle"])
    m.initial("motor.angle", rate=0.1)
    return m.build()


@pytest.mark.long
def test_a_runaway_is_stopped_with_the_motion_so_far_and_what_moves_fastest() -> None:
    """It would take half an hour for changes of the degrees of freedom every few microseconds."""
    reason = pytest.raises(fx.DynamicsError, match=r"has all but stopped .* moves fastest")
    with reason as caught, pytest.warns(fx.StiffWarning, match="about .* steps"):
        runaway().simulate(10.0, method="DOP853", rtol=1e-6, samples=10001)
    motion = caught.value.motion
    assert motion.statistics["rechoices"] > 300
    assert motion.t[-1] > 0.01
    assert np.abs(motion.rate("motor.angle")).max() > 100


@pytest.mark.long
def test_a_runaway_in_coordinates_and_multipliers_is_stopped_too() -> None:
    """Its degrees of freedom do not change; its steps alone are too many."""
    with pytest.raises(fx.DynamicsError, match=r"has all but stopped"):
        runaway().simulate(100.0, method="generalized-alpha", first_step=1e-3, samples=2)


@pytest.mark.long
def test_a_short_fast_phase_does_not_stop_a_long_motion() -> None:
    """A load of high frequency acts for a while: thousands of steps that are much shorter, and the end is reached."""
    m = fx.Model(gravity=(0, 0))
    m.point("A", (0, 0))
    m.point_mass("mass", "A", 1.0)
    w, T = 1e5, 0.12
    m.load("A.x", lambda t: np.where(t < 1.0, 0.0, np.where(t < 1.0 + T, 1e6 * np.cos(w * (t - 1.0)), 0.0)))
    m.independent("A.x", "A.y")
    motion = m.build().simulate(1e3, method="DOP853", rtol=1e-8, samples=2)
    assert motion.statistics["steps"] > 6000
    v = 1e6 * np.sin(w * T) / w
    s = 1e6 * (1 - np.cos(w * T)) / w**2
    assert motion["A.x"][-1] == pytest.approx(s + v * (1e3 - 1.0 - T), rel=1e-6)
