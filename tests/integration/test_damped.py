"""What generalized-alpha damps is small, or a warning names it; its steps follow every state that it integrates."""

from pathlib import Path

import numpy as np
import pytest

import flexel as fx
from flexel.derive import Internal, Law, Parameter, symbol
from flexel.derive.compiled import CompiledLaw
from flexel.derive.user_definitions import compile_law

METHOD = "generalized-alpha"
E, ED, U, V, C = (symbol(name) for name in ("e", "ed", "u", "v", "c"))


pytestmark = pytest.mark.usefixtures("cache")


def law(name: str, parameter: Parameter, stress: object, *states: Internal) -> CompiledLaw:
    return compile_law(
        Law(name, name, (parameter,), (E,), (ED,), (), (stress,), (), 0 * E, "closed form", states=states)
    )


def bar(m: fx.Model) -> None:
    """A bar from the ground to the mass, for laws."""
    m.point("O", (0, 0), fixed=True)
    m.truss("bar", "O", "A")


def slider(stiffness: float, start: float) -> fx.Model:
    """A unit mass on a spring to the ground along x, drawn at 0.1 m and displaced."""
    m = fx.Model()
    m.point("A", (0.1, 0))
    m.fix("A.y")
    m.point_mass("mass", "A", 1.0)
    m.spring("A.x", stiffness)
    m.initial("A.x", 0.1 + start)
    return m


def test_a_vibration_much_smaller_than_the_machine_is_kept() -> None:
    """0.1 um of 0.1 m at 30 rad/s for 20 s, in closed form."""
    motion = slider(900.0, 1e-7).build().simulate(20.0, method=METHOD)
    np.testing.assert_allclose(motion["A.x"] - 0.1, 1e-7 * np.cos(30 * motion.t), atol=1e-8)


def unstable(growth: float) -> fx.System:
    """The slider with a frequency of 30 rad/s on a damper that feeds it."""
    D = Parameter("D", 1, "N s/m", "damping")
    m = slider(900.0, 1e-7)
    bar(m)
    m.law(["bar.elongation"], law("damper", D, D.symbol * ED), name="feeder", D=-2 * growth)
    return m.build()


def test_a_slightly_unstable_vibration_grows() -> None:
    """A damper that feeds it with 0.5/s: the amplitude after 10 s is 15 um, not zero."""
    motion = unstable(0.5).simulate(10.0, method=METHOD)
    omega = np.sqrt(900.0 - 0.25)
    t = motion.t
    exact = 1e-7 * np.exp(0.5 * t) * (np.cos(omega * t) - 0.5 / omega * np.sin(omega * t))
    np.testing.assert_allclose(motion["A.x"] - 0.1, exact, atol=0.05 * np.abs(exact).max())


def test_an_unstable_vibration_that_long_steps_hold_at_rest_is_named() -> None:
    with pytest.warns(fx.DampingWarning, match=r"generalized-alpha has removed .* J, .*mean step 0.2 s"):
        motion = unstable(0.5).simulate(10.0, method=METHOD, step=0.2, samples=51)
    assert np.abs(motion["A.x"][-1] - 0.1) < 1e-7  # 15 um in truth


@pytest.mark.parametrize(("step", "warned"), [(0.08, True), (0.0005, False)])
def test_a_free_rotor_that_long_steps_slow_down_is_named(step: float, warned: bool, tmp_path: Path) -> None:
    """A warning names the method, the energy that it took out, and the step."""
    m = fx.Model()
    m.point("O", (0, 0, 0))
    m.frame("R")
    m.body("rotor", "O", "R", mass=1.0, inertia=(1.0, 1.0, 1.0))
    m.initial("R.lambda3", rate=5.0)  # half the angular velocity
    system = m.build()
    if not warned:
        motion = system.simulate(2.0, method=METHOD, step=step)
        assert motion.warnings == ()
        return
    with pytest.warns(fx.DampingWarning, match=r"generalized-alpha has removed \d+ J, \d+% .*mean step 0.0"):
        motion = system.simulate(40.0, method=METHOD, step=step)
    kinetic = motion.energy_balance()["kinetic"]
    assert kinetic[-1] < 0.2 * kinetic[0]
    assert len(motion.warnings) == 1
    assert "smaller rtol or step" in motion.warnings[0]
    assert motion.warnings[0] in motion.message
    motion.save(tmp_path / "motion.npz")
    assert fx.load(tmp_path / "motion.npz").warnings == motion.warnings


def pusher(gain: float, frequency: float) -> fx.System:
    """A free mass that a law pushes with gain u^2, where its states u, v turn with a frequency."""
    W = Parameter("W", 1, "rad/s", "frequency")
    turning = Internal("u", "1", W.symbol * V), Internal("v", "1", -W.symbol * U)
    m = fx.Model()
    m.point("O", (0, 0), fixed=True)
    m.point("A", (0.1, 0))
    m.fix("A.y")
    m.truss("bar", "O", "A")
    m.point_mass("mass", "A", 1.0)
    m.law(
        ["bar.elongation"],
        law("pusher", W, -gain * U**2, *turning),
        name="push",
        W=frequency,
        initial={"u": 1.0},
    )
    return m.build()


def test_fast_states_of_a_law_push_a_mass_all_the_way() -> None:
    """States at 2000 rad/s; their mean square is a half."""
    motion = pusher(1.0, 2000.0).simulate(0.2, method=METHOD)
    assert motion["A.x"][-1] - 0.1 == pytest.approx(0.2**2 / 4, rel=2e-3)


def test_the_error_of_a_law_s_states_follows_the_tolerance() -> None:
    """Two states that turn beside a mass at rest, and a lag of 50 ms behind a vibration of 0.1 m, in closed form."""
    turned, lagged = [], []
    T = Parameter("T", 1, "s", "lag")
    lag = law("relaxation", T, 0 * E, Internal("c", "m", (E - C) / T.symbol))
    for rtol in (1e-3, 1e-5, 1e-6):
        motion = pusher(0.0, 20.0).simulate(2.0, method=METHOD, rtol=rtol)
        found = np.array([state.z[0] for state in motion])
        turned.append(np.abs(found - np.cos(20 * motion.t)).max())
        m = slider(1.0, 0.1)
        bar(m)
        m.law(["bar.elongation"], lag, name="lag", T=0.05)
        motion = m.build().simulate(2.0, method=METHOD, rtol=rtol)
        t, w = motion.t, 0.05
        exact = 0.1 / (1 + w**2) * (np.cos(t) + w * np.sin(t) - np.exp(-t / w))
        lagged.append(np.abs(np.array([state.z[0] for state in motion]) - exact).max())
    for errors in (turned, lagged):
        assert errors[1] < 0.2 * errors[0]
        assert errors[2] < 0.4 * errors[1]
    # 40 radians gather the local errors of their steps, which number about rtol^(-1/3) a radian
    for rtol, error in zip((1e-3, 1e-5, 1e-6), turned, strict=True):
        assert error < 40 * rtol ** (2 / 3)
    for rtol, error in zip((1e-3, 1e-5, 1e-6), lagged, strict=True):
        assert error < 0.1 * 2 * rtol ** (2 / 3)
