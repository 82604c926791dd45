"""Motions that are small beside the machine are as exact as large ones, and rest takes few steps."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from test_internal_states import LAG, maxwell
from test_internal_states import oscillator as creeping

import flexel as fx

W = 30.0  # of the oscillator [rad/s]
SMALL = "this motion is small beside the model: coordinates are rounded to .* rates cannot be known to rtol = 1e-09"

pytestmark = [
    pytest.mark.filterwarnings("ignore:.*this motion is small beside the model"),
    pytest.mark.usefixtures("cache"),
]


def slider(start: float, place: float = 0.1, damping: float = 0.0) -> fx.Model:
    """A unit mass on a spring to the ground along x, drawn at a place and displaced."""
    m = fx.Model()
    m.point("A", (place, 0))
    m.fix("A.y")
    m.point_mass("mass", "A", 1.0)
    m.spring("A.x", W**2, damping=damping)
    m.initial("A.x", place + start)
    return m


def error(motion: fx.Motion, amplitude: float, place: float = 0.1) -> float:
    """Of the free vibration, relative to its amplitude."""
    exact = amplitude * np.cos(W * motion.t)
    return float(np.max(np.abs(motion["A.x"] - place - exact)) / amplitude)


@pytest.mark.parametrize(("amplitude", "allowed"), [(0.1, 5e-8), (1e-4, 5e-8), (1e-6, 2e-7), (1e-8, 1e-5)])
@pytest.mark.parametrize("place", [0.1, 1.0])
def test_a_vibration_is_as_exact_as_a_large_one_up_to_rounding(
    amplitude: float, allowed: float, place: float
) -> None:
    """95 periods; 9.3e-6 and 7e-4 of the last two amplitudes were lost with tolerances of the machine's size."""
    motion = slider(amplitude, place).build().simulate(20.0, samples=101, method="DOP853")
    assert error(motion, amplitude, place) < allowed


@pytest.mark.parametrize(
    ("amplitude", "rtol", "allowed"),
    [(0.1, 1e-6, 2e-6), (1e-8, 1e-6, 2e-6), (1e-4, 1e-9, 1e-8), (1e-6, 1e-9, 1e-8)],
)
def test_radau_is_as_exact_in_a_small_vibration(amplitude: float, rtol: float, allowed: float) -> None:
    """Five periods; with tolerances of the machine's size 5e-5 of 1e-8 m and 1e-6 of 1e-6 m were lost."""
    motion = slider(amplitude).build().simulate(1.0, samples=101, method="Radau", rtol=rtol)
    assert error(motion, amplitude) < allowed


def test_a_small_motion_far_from_the_origin_says_that_rounding_limits_it() -> None:
    with pytest.warns(
        fx.AuditWarning, match="far from the origin, coordinates are rounded to .* rtol = 1e-09"
    ):
        motion = slider(1e-5, 2e5).build().simulate(2.0, samples=101, method="DOP853")
    assert 1e-8 < error(motion, 1e-5, 2e5)
    assert not slider(0.1, 2e5).build().simulate(2.0, samples=101, method="DOP853").warnings


def test_a_motion_whose_steps_are_rounded_says_so() -> None:
    with pytest.warns(fx.AuditWarning, match=SMALL):
        slider(1e-8, 1.0).build().simulate(1.0, method="DOP853")
    assert slider(1e-5, 1.0).build().simulate(1.0, method="DOP853").warnings == ()


def test_errors_of_many_steps_do_not_add_up() -> None:
    """240 periods: tolerances that are the same in every step lose 6e-8, three times what `rtol` promises."""
    motion = slider(0.1).build().simulate(50.0, samples=101, method="DOP853")
    assert motion.statistics["steps"] > 2000
    assert error(motion, 0.1) < 1e-8


def test_an_absolute_tolerance_that_is_given_is_absolute() -> None:
    with pytest.warns(fx.AuditWarning, match="energy balance of DOP853 fails by"):
        motion = slider(1e-6).build().simulate(20.0, samples=101, method="DOP853", atol=1e-10)
    assert 1e-6 < error(motion, 1e-6) < 1e-4


def upright(start: float) -> fx.System:
    """A pendulum, displaced from where it stands on its head."""
    m = fx.Model(gravity=(0, -9.81))
    m.point("O", (0, 0), fixed=True)
    m.point_mass("bob", m.point("A", (0, 1)), 1.0)
    m.truss("rod", "O", "A")
    m.initial("A.x", start)
    return m.build()


def test_a_motion_that_grows_from_a_small_start_keeps_its_digits() -> None:
    """A pendulum falls from 1e-8 rad: errors of the start grow a million times (7.7e-5 before)."""
    motion = upright(1e-8).simulate(6.0, samples=61, method="DOP853")
    found = solve_ivp(
        lambda _, y: (y[1], 9.81 * np.sin(y[0])),
        (0, 6),
        (np.arcsin(1e-8), 0),
        method="DOP853",
        rtol=1e-13,
        atol=1e-22,
        t_eval=motion.t,
    )
    assert np.max(np.abs(motion["A.x"] - np.sin(found.y[0]))) < 2e-8


def test_internal_states_of_laws_are_as_exact_as_large_ones() -> None:
    """The creep of a Maxwell element that is stretched by 1e-8 m, relative to its own amplitude (5e-3 before)."""
    amplitude, w = 1e-8, 5 * LAG
    m = creeping(maxwell())
    m.prescribe("A.x", lambda t: 1 + amplitude * np.sin(5 * t))
    motion = m.build().simulate(3.0, samples=31, method="DOP853")
    t = motion.t
    exact = amplitude / (1 + w * w) * (np.sin(5 * t) - w * np.cos(5 * t) + w * np.exp(-t / LAG))
    assert np.max(np.abs(motion["damper.creep"] - exact)) < 5e-6 * amplitude


def test_a_mass_on_a_law_with_states_is_as_exact_as_with_a_large_motion() -> None:
    """Its coordinates and the creep, from 1e-7 m and from 0.1 m: the equations are linear."""
    found = []
    for amplitude in (0.1, 1e-7):
        m = creeping(maxwell())
        m.initial("A.x", 1 + amplitude)
        motion = m.build().simulate(3.0, samples=31, method="DOP853")
        found.append(np.array([motion["A.x"] - 1, motion["damper.creep"]]) / amplitude)
    np.testing.assert_allclose(found[1], found[0], atol=1e-7)


@pytest.mark.long
def test_rest_takes_few_steps() -> None:
    """Exactly at rest, and at an equilibrium that rounding disturbs."""
    motion = slider(0.0).build().simulate(100.0, samples=2, method="DOP853")
    assert motion.statistics["steps"] < 15 and np.array_equal(motion["A.x"], [0.1, 0.1])
    m = fx.Model(gravity=(0, -9.81))
    m.point("O", (0, 0), fixed=True)
    for i, name in enumerate("AB"):
        m.point_mass(f"bob {name}", m.point(name, (0.3 * (i + 1), -0.7 * (i + 1))), 1.0)
    m.truss("upper", "O", "A", stiffness=1e5)
    m.truss("lower", "A", "B", stiffness=1e5)
    system = m.build()
    motion = system.simulate(10.0, start=system.equilibrium(), samples=101, method="DOP853")
    assert np.ptp(motion["B.x"]) < 1e-12
    disturbed = system.simulate(10.0, samples=2, method="DOP853")
    assert motion.statistics["evaluations"] < disturbed.statistics["evaluations"]


def test_a_motion_that_decays_to_nothing_costs_no_more_than_before() -> None:
    """A damped mass, whose amplitude is exp(-300) of its first one at the end: steps are bound by stability."""
    system = slider(0.01, damping=6.0).build()
    relative, absolute = (
        system.simulate(100.0, samples=2, method="DOP853", **options).statistics["evaluations"]
        for options in ({}, {"atol": 1e-11})
    )
    assert relative < 1.05 * absolute


def test_a_motion_that_is_excited_later_is_as_exact() -> None:
    """A mass at rest for 5 s, then a smooth push that moves it by 1e-8 m, in closed form."""
    m = slider(0.0)
    m.load("A.x", lambda t: 1e-8 * W**2 * max(t - 5, 0.0) ** 3)
    motion = m.build().simulate(6.0, samples=61, method="DOP853", max_step=0.1)
    s = np.maximum(motion.t - 5, 0.0)
    exact = 1e-8 * (s**3 - 6 * s / W**2 + 6 * np.sin(W * s) / W**3)
    assert np.max(np.abs(motion["A.x"] - 0.1 - exact)) < 1e-14


def test_variants_that_go_abreast_have_the_digits_of_each_alone() -> None:
    """Small motions with internal states, in lanes."""
    m = creeping(maxwell())
    m.initial("A.x", 1 + 1e-7)
    system = m.build()
    found = system.simulate_many(
        2.0,
        parameters={"mass.mass": np.linspace(1, 3, 10)},
        outputs=["damper.creep"],
        samples=21,
        method="DOP853",
    )
    for i in range(len(found)):
        motion = found.motion(i)
        assert np.array_equal(found["damper.creep"][i], motion["damper.creep"])
        assert found.statistics[i] == motion.statistics


def beside_a_damper() -> fx.System:
    """A mass on a spring that vibrates, and a heavier one behind a stiff damper that creeps by a hundredth as much."""
    m = fx.Model(gravity=(2, -5))
    m.point("O", (0, 0), fixed=True)
    for name, x, mass, before in (("A", 0.5, 1.0, "O"), ("B", 1.0, 4.0, "A")):
        m.point(name, (x, 0))
        m.fix(f"{name}.y")
        m.point_mass(f"mass {name}", name, mass)
        m.truss(f"link {name}", before, name)
    m.spring("link A.elongation", 1000.0)
    m.spring("link B.elongation", 1.0, damping=1e-4)
    m.point("wall", (1.27, 0.3), fixed=True)
    m.truss("damper", "B", "wall")
    m.spring("damper.elongation", damping=1e4)
    m.initial("link A.elongation", rate=-4.0)
    m.initial("link B.elongation", rate=4.73)
    return m.build()


@pytest.mark.parametrize("rtol", [1e-6, 1e-9])
def test_what_moves_little_beside_others_is_exact_relative_to_its_own_range(rtol: float) -> None:
    """2.3e-7 of the damper's range at 1e-9 before: its end is a sum of two degrees of freedom that move far."""
    system = beside_a_damper()
    motion, exact = (
        system.simulate(0.2, samples=41, method="DOP853", progress=False, **options)
        for options in ({"rtol": rtol}, {"rtol": 1e-12, "atol": 1e-16})
    )
    for name in ("B.x", "damper.elongation", "link A.elongation"):
        assert np.ptp(exact[name]) > 0
        assert np.abs(motion[name] - exact[name]).max() < 20 * rtol * np.ptp(exact[name])


def test_what_moves_little_has_the_same_steps_in_lanes() -> None:
    found = beside_a_damper().simulate_many(
        0.2,
        parameters={"mass A.mass": np.linspace(1, 3, 9)},
        outputs=["damper.elongation"],
        samples=5,
        method="DOP853",
    )
    for i in range(len(found)):
        motion = found.motion(i)
        assert np.array_equal(found["damper.elongation"][i], motion["damper.elongation"])
        assert found.statistics[i] == motion.statistics
