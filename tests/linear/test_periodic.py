"""Periodic motion: exact solutions, Hill's and Mathieu's equations, nonlinear oscillators, and bad input."""

from typing import Any

import numpy as np
import pytest
from mechanisms import oscillator
from scipy.integrate import solve_ivp
from scipy.optimize import brentq
from scipy.special import mathieu_a, mathieu_b

import flexel as fx
from flexel.base.errors import FlexelError, LinearizationError
from flexel.linear import periodic
from flexel.linear.periodic import Coefficients


def mathieu(
    w0: float, eps: float, speed: float = 1.0, damping: float = 0.0, samples: int = 32
) -> Coefficients:
    """q'' + 2 damping w0 q' + w0² (1 + eps cos 2 speed t) q = cos(speed t) sampled over a turn."""
    phase = 2 * np.pi * np.arange(samples) / samples
    one = np.ones((samples, 1, 1))
    K = w0**2 * (1 + eps * np.cos(2 * phase))
    return Coefficients(speed, one, 2 * damping * w0 * one, K[:, None, None], np.cos(phase)[:, None], ("q",))


# -- series ---------------------------------------------------------------------------------------


@pytest.mark.parametrize("samples", [16, 17])
def test_fourier_coefficients_and_refinement_of_a_known_series(samples: int) -> None:
    t = 2 * np.pi * np.arange(samples) / samples
    found = periodic.cosine_sine(3 + 2 * np.cos(t) - 5 * np.sin(4 * t), 5)
    expected = np.zeros((6, 2))
    expected[0, 0], expected[1, 0], expected[4, 1] = 3, 2, -5
    assert found == pytest.approx(expected, abs=1e-14)
    fine = periodic.refined(np.cos(t) - np.sin(4 * t), 8)
    s = 2 * np.pi * np.arange(8 * samples) / (8 * samples)
    assert fine == pytest.approx(np.cos(s) - np.sin(4 * s), abs=1e-14)


# -- linear ---------------------------------------------------------------------------------------


def test_harmonic_balance_of_a_constant_system_is_its_frequency_response() -> None:
    w0, speed, damping = 3.0, 1.7, 0.1
    found = mathieu(w0, 0.0, speed, damping).harmonic_balance(2)
    response = 0.5 / (w0**2 - speed**2 + 2j * damping * w0 * speed)
    assert found.X[3, 0] == pytest.approx(response, rel=1e-13)
    assert found.neglected < 1e-15


def test_harmonic_balance_satisfies_the_equation_with_varying_stiffness() -> None:
    c = mathieu(1.9, 0.3, 1.0, 0.02, 64)
    q, qd, qdd = c.harmonic_balance(12).samples()
    left = qdd + c.C[:, 0] * qd + c.K[:, 0] * q
    assert np.max(np.abs(left - c.F)) < 1e-9


def test_the_error_estimate_shows_what_more_harmonics_find() -> None:
    c = mathieu(4.9, 0.4, 1.0, 0.02, 64)
    exact = c.harmonic_balance(14).samples()[0]
    for k in (3, 5, 7):
        found = c.harmonic_balance(k)
        off = np.max(np.abs(found.samples()[0] - exact))
        assert off / 30 < found.neglected < 30 * off


def test_multipliers_of_a_constant_system_are_those_of_its_eigenvalues() -> None:
    w0, damping = 2.3, 0.07
    s = w0 * (-damping + 1j * np.sqrt(1 - damping**2))
    expected = np.exp(2 * np.pi * np.array([s, s.conjugate()]))
    found = mathieu(w0, 0.0, 1.0, damping).floquet_multipliers()
    assert sorted(found, key=np.imag) == pytest.approx(sorted(expected, key=np.imag), abs=1e-9)


@pytest.mark.parametrize("eps", [0.05, 0.137, 0.4])
def test_edges_of_the_first_zone_are_those_of_mathieu(eps: float) -> None:
    """At w0² = a and w0² eps = 2 q, on the curves a = a1(q), b1(q), a multiplier is ±1."""
    for characteristic in (mathieu_a, mathieu_b):
        a = 1.0
        for _ in range(100):
            a = float(characteristic(1, abs(a * eps / 2)))
        for factor, inside in ((0.999, characteristic is mathieu_a), (1.001, characteristic is mathieu_b)):
            largest = np.abs(mathieu(np.sqrt(a * factor), eps).floquet_multipliers()[0])
            assert (largest > 1 + 1e-6) == inside


def test_quasi_static_solution_divides_force_by_stiffness() -> None:
    c = mathieu(2.0, 0.3)
    assert c.quasi_static() == pytest.approx(c.F / c.K[:, 0], rel=1e-14)


def test_stiff_damped_modes_do_not_disturb_the_multipliers() -> None:
    """A mode with 1e5 times the stiffness, strongly damped: its multiplier is zero, the other is untouched."""
    c = mathieu(1.3, 0.2, 1.0, 0.05)
    two = np.zeros((c.samples, 2, 2))
    M, C, K = two + np.eye(2), two.copy(), two.copy()
    C[:, :1, :1], K[:, :1, :1], C[:, 1, 1], K[:, 1, 1] = c.C, c.K, 900.0, 1e5
    found = Coefficients(1.0, M, C, K, np.zeros((c.samples, 2)), ("a", "b")).floquet_multipliers()
    assert np.sort(np.abs(found[:2])) == pytest.approx(np.sort(np.abs(c.floquet_multipliers())), abs=1e-8)
    assert np.max(np.abs(found[2:])) < 1e-9


# -- nonlinear ------------------------------------------------------------------------------------


def test_a_linear_model_gives_the_same_linearized_and_nonlinear() -> None:
    speed = 0.6
    system = oscillator(speed)
    expected = 0.5 / (1 - speed**2 + 2j * 0.05 * speed)
    nominal = periodic.orbit(system, 2 * np.pi / speed, 16)
    assert nominal.coefficients.harmonic_balance(3).X[4, 0] == pytest.approx(expected, rel=1e-12)
    _, vibration = periodic.periodic_motion(system, 2 * np.pi / speed, 3)
    assert vibration.X[4, 0] == pytest.approx(expected, rel=1e-12)
    assert vibration.X[3, 0] == pytest.approx(10.0, rel=1e-12)


def test_the_nonlinear_motion_is_what_simulation_settles_to() -> None:
    speed = 0.8
    period = 2 * np.pi / speed
    system = oscillator(speed, zeta=0.2, cubic=0.5)
    motion, vibration = periodic.periodic_motion(system, period, 9)
    assert vibration.error < 1e-6
    run = system.simulate(12 * period, times=[0.0, *np.linspace(11 * period, 12 * period, 41)], rtol=1e-8)
    q = vibration.at(run.t[1:])[0][:, 0]
    assert np.max(np.abs(run["P.x"][1:] - q)) < 1e-5
    assert np.max(np.abs(motion.coefficients.F)) < 1e-4
    assert np.abs(motion.coefficients.floquet_multipliers()[0]) < 1


def test_a_hardening_resonance_is_followed_over_the_speed() -> None:
    """Amplitudes near the backbone ω² = 1 + 3/4 cubic a² on the upper branch."""
    found = periodic.nonlinear_range(
        lambda w: oscillator(w, zeta=0.02, cubic=0.05, push=0.1),
        np.linspace(0.8, 1.06, 13),
        5,
        lambda _, v: 2 * float(np.abs(v.X[6, 0])),
    )
    assert found.message == ""
    a = found.results[-1]
    assert 1 + 0.75 * 0.05 * a**2 == pytest.approx(1.06**2, abs=0.04)


# -- families of speeds ---------------------------------------------------------------------------


def test_a_family_through_three_speeds_holds_at_any_other() -> None:
    def crank(speed: float) -> periodic.Orbit:
        m = fx.Model()
        m.point("O", (0, 0), fixed=True)
        m.point("A", (0.2, 0))
        m.point("B", (0.9, 0))
        for name in ("g", "a", "b"):
            m.angle(name, fixed=name == "g")
        m.hinge("motor", "g", "a")
        m.beam("arm", "O", "a", "A")
        m.hinge("joint", "a", "b", stiffness=3.0, damping=0.1)
        m.beam("bar", "A", "b", "B", mass_per_length=2.0)
        m.prescribe("motor.angle", lambda t: speed * t)
        m.load("B.y", -1.0)
        return periodic.orbit(m.build(), 2 * np.pi / speed, 24)

    family = periodic.SpeedFamily.through([crank(w) for w in (1.0, 2.0, 4.0)])
    found, expected = family.at(7.0), crank(7.0).coefficients
    for name in ("M", "C", "K", "F"):
        assert getattr(found, name) == pytest.approx(getattr(expected, name), abs=1e-11 * 49)


# -- bad input ------------------------------------------------------------------------------------


def test_too_few_harmonics_for_the_accuracy_say_what_was_reached() -> None:
    c = mathieu(4.9, 0.4, 1.0, 0.02, 64)
    with pytest.raises(
        LinearizationError, match="3 harmonics .* neglect about .* take more harmonics"
    ) as caught:
        c.harmonic_balance(3, accuracy=1e-5)
    reached = caught.value.reached  # type: ignore[attr-defined]
    assert reached.error > 1e-5
    assert c.harmonic_balance(14, accuracy=1e-5).harmonics == 14
    system = oscillator(0.8, zeta=0.2, cubic=0.5)
    with pytest.raises(LinearizationError, match="take more harmonics"):
        periodic.periodic_motion(system, 2 * np.pi / 0.8, 3, accuracy=1e-6)


def test_too_few_samples_are_named() -> None:
    with pytest.raises(LinearizationError, match="8 harmonics need 33 samples"):
        mathieu(2.0, 0.1).harmonic_balance(8)
    with pytest.raises(LinearizationError, match="take more samples"):
        periodic.cosine_sine(np.zeros(8), 4)


def test_a_range_with_a_resonance_without_damping_stops_there_and_keeps_the_rest() -> None:
    speeds = [0.7, 0.8, 1.0, 1.25]
    with pytest.warns(fx.IncompleteWarning, match="stopped at 1 rad/s"):
        found = periodic.speed_range(lambda w: mathieu(1.0, 0.0, w).harmonic_balance(3), speeds)
    assert len(found.results) == 2
    assert list(found.speeds) == speeds[:2]
    assert found.message.startswith(
        "stopped at 1 rad/s: harmonic balance at 1 rad/s is singular: a resonance"
    )


def test_a_range_with_standstill_stops_there() -> None:
    for go in (
        lambda: periodic.nonlinear_range(oscillator, [0.2, 0.1, 0.0], 3, lambda _, v: v.error),
        lambda: periodic.speed_range(
            lambda w: periodic.orbit(oscillator(w), 2 * np.pi / w if w else np.inf, 8), [0.1, 0.0]
        ),
    ):
        with pytest.warns(fx.IncompleteWarning, match="stopped at 0 rad/s"):
            found = go()
        assert found.message.startswith("stopped at 0 rad/s")
        assert len(found.results) == found.speeds.size > 0


def amplitudes(speeds: np.ndarray) -> periodic.SpeedRange[float]:
    """Largest harmonic of a hardening oscillator, whose resonance bends over to higher speeds."""
    return periodic.nonlinear_range(
        lambda w: oscillator(w, zeta=0.01, cubic=0.2, push=0.1),
        speeds,
        5,
        lambda _, v: float(np.abs(v.X[v.harmonics + 1 :]).max()),
    )


def test_a_range_that_climbs_a_fold_stops_at_its_top_and_says_so() -> None:
    with pytest.warns(fx.IncompleteWarning, match="stopped at 1.6 rad/s: no periodic motion found"):
        found = amplitudes(np.linspace(0.9, 2.4, 16))
    assert found.speeds[-1] == pytest.approx(1.5)
    assert np.all(np.diff(found.results) > 0)


def test_a_range_in_long_steps_goes_round_a_fold_on_the_lower_branch() -> None:
    found = amplitudes(np.linspace(0.9, 2.4, 6))
    assert found.message == ""
    assert np.all(np.diff(found.results) < 0)


def test_positions_out_of_reach_are_named() -> None:
    m = fx.Model()
    m.point("O", (0, 0), fixed=True)
    m.point("A", (0.5, 0))
    m.point("B", (0.8, 0))
    for name in ("g", "a", "b"):
        m.angle(name, fixed=name == "g")
    m.hinge("motor", "g", "a")
    m.beam("arm", "O", "a", "A")
    m.beam("bar", "A", "b", "B", mass_per_length=1.0)
    m.fix("B.y")
    m.prescribe("motor.angle", lambda t: t)
    with pytest.raises(FlexelError):
        periodic.orbit(m.build(), 2 * np.pi, 24)


def test_an_upright_pendulum_at_the_edge_of_its_stability_has_a_motion_with_a_multiplier_of_one() -> None:
    """Kapitza's pendulum; the edge from its linear equation, integrated by SciPy."""
    length, gravity, omega = 1.0, 9.81, 60.0
    period = 2 * np.pi / omega

    def trace(amplitude: float) -> float:
        def rates(t: float, y: np.ndarray) -> list[float]:
            return [y[1], (gravity - amplitude * omega**2 * np.cos(omega * t)) / length * y[0]]

        ends = [solve_ivp(rates, (0, period), y, rtol=1e-12, atol=1e-14).y[:, -1] for y in np.eye(2)]
        return ends[0][0] + ends[1][1]

    edge = float(brentq(lambda amplitude: trace(amplitude) - 2, 0.05, 0.1, xtol=1e-14))
    m = fx.Model(gravity=(0, -gravity))
    m.point("pivot", (0, 0))
    m.point("bob", (0, length))
    m.angle("rod")
    m.fix("pivot.x")
    m.prescribe("pivot.y", lambda t: edge * np.cos(omega * t))
    m.beam("link", "pivot", "rod", "bob")
    m.point_mass("mass", "bob", 1.0)
    m.independent("rod.angle")
    motion = m.build().periodic(period=period, harmonics=4)
    np.testing.assert_allclose(
        np.abs(motion.multipliers()), 1.0, atol=1e-5
    )  # a double one: the root of rounding


@pytest.mark.parametrize(
    ("load", "motion", "named"),
    [
        (fx.Harmonic(0.1, 0.3), None, "the load on 'B.x'"),
        (0.0, fx.Harmonic(0.1, 0.3), "the prescribed motion of 'A.x'"),
    ],
)
def test_a_period_that_a_drive_does_not_have_is_refused_by_name(load: Any, motion: Any, named: str) -> None:
    m = fx.Model()
    A, B = m.point("A", (0, 0), fixed=motion is None), m.point("B", (1, 0))
    m.fix("B.y")
    m.truss("spring", A, B, stiffness=2.0)
    m.point_mass("mass", B, 1.0)
    m.load("B.x", load)
    if motion is not None:
        m.fix("A.y")
        m.prescribe("A.x", motion)
    system = m.build()
    for wrong in (0.25, 0.2, 0.6):
        with pytest.raises(LinearizationError, match=f"periodic: {named} does not have the period"):
            system.periodic(period=2 * np.pi / wrong, harmonics=3)
    for right in (0.3, 0.15):  # one period, and two
        found = system.periodic(period=2 * np.pi / right, harmonics=3)
        assert found["B.x"].max() - 1 == pytest.approx(
            (1.0 if motion is None else 2.0) * 0.1 / (2.0 - 0.09), rel=0.05
        )
