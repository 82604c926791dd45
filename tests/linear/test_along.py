"""Linearized equations along motions, against differences of the nonlinear equations, and bad input."""

from collections.abc import Callable

import mechanisms
import numpy as np
import pytest
from mechanisms import pendulum
from wheels import MAGIC, MAGIC_ON, K, wheel

import flexel as fx
from flexel.base.arrays import Array
from flexel.base.errors import LinearizationError, ModelError
from flexel.examples.bicycle import bicycle, kick, rolling
from flexel.examples.slider_crank import slider_crank
from flexel.linear.orbits import orbit

SIXTH = (1.5, -0.3, 1 / 30)  # weights of central differences of order 6, over 2 h
SPEED = 150.0  # of the crank [rad/s]


def crank() -> fx.Motion:
    """A crank at constant speed with an elastic rod: a prescribed motion, and deformations that vibrate."""
    return slider_crank(SPEED).simulate(0.02, samples=5, rtol=1e-10, method="DOP853")


def ride() -> fx.Motion:
    """A bicycle with rolling wheels, after a kick: kinematic coordinates."""
    system = bicycle()
    return system.simulate(1.0, start=kick(system, 4.5, 0.05)[0], samples=4)


def tyre() -> fx.Motion:
    """A wheel that rolls on a tyre whose slips relax: internal states of a law."""
    m = wheel(z=0.345)
    m.attach("magic_formula", MAGIC_ON, name="rubber", stiffness=K, damping=400.0, **MAGIC)
    m.initial("hub.x", rate=12.0)
    m.initial("hub.y", rate=0.4)
    m.initial("wheel.omega.wy", rate=34.0)
    return m.build().simulate(0.06, samples=4, rtol=1e-9)  # less than a quarter of a turn of half the angle


def differences(rates: Callable[[Array], Array], y: Array, least: float = 1e-2) -> Array:
    """Derivatives of a function at y; `least` is the smallest size of an entry."""
    columns = []
    for i in range(y.size):
        step = np.zeros(y.size)
        step[i] = 2e-3 * max(least, abs(y[i]))
        pairs = [rates(y + k * step) - rates(y - k * step) for k in (1, 2, 3)]
        columns.append(np.tensordot(SIXTH, pairs, axes=1) / (2 * step[i]))
    return np.column_stack(columns)


def nonlinear(system: fx.System, state: fx.State) -> Array:
    """Derivatives of the rates of (q_d', q_d, q_k, z) by differences of the equations of motion."""
    nd, nq = system.roles.nd, system.roles.nq

    def rates(y: Array) -> Array:
        system.warm(state)
        return system.rhs(state.t, y)

    y = np.concatenate([state.q, state.qd, state.z])
    order = np.r_[nq : nq + nd, 0:nq, nq + nd : y.size]
    return differences(rates, y)[np.ix_(order, order)]


# -- matrices -------------------------------------------------------------------------------------


@pytest.mark.parametrize("moving", [crank, ride, tyre])
def test_state_matrices_are_the_derivatives_of_the_nonlinear_equations(
    moving: Callable[[], fx.Motion],
) -> None:
    motion = moving()
    system = motion.system
    assert isinstance(system, fx.System)
    ltv = system.along(motion)
    assert not ltv.F.any() and len(ltv) == len(motion)
    for A, state in zip(ltv.state_matrices, motion, strict=True):
        expected = nonlinear(system, state)
        assert np.abs(A - expected).max() < 1e-8 * np.abs(expected).max()


@pytest.mark.parametrize("moving", [crank, ride, tyre])
def test_any_time_of_a_motion_has_its_own_matrices(moving: Callable[[], fx.Motion]) -> None:
    motion = moving()
    system = motion.system
    assert isinstance(system, fx.System)
    ltv, t = system.along(motion), float(0.3 * motion.t[1] + 0.7 * motion.t[2])
    expected = nonlinear(system, motion.at(t))
    lin = ltv.at(t)
    assert isinstance(lin, fx.Linearization) and lin.state.t == t
    assert np.abs(lin.state_matrix - expected).max() < 1e-8 * np.abs(expected).max()
    assert np.array_equal(ltv[2].state_matrix, ltv.state_matrices[2])


def test_a_nominal_motion_leaves_forces_and_its_matrices_are_those_of_the_residual() -> None:
    """Bending is held while the crank turns; the residual is that of `System.residual`."""
    system, times = slider_crank(SPEED), np.linspace(0.0, 0.01, 4)
    ltv, nd = system.along(times=times), 4
    start, none = system.at_rest, np.zeros(nd)
    for i, t in enumerate(times):
        state = ltv[i].state

        def residual(y: Array, t: float = float(t), state: fx.State = state) -> Array:
            return system.residual(t, y[:nd], y[nd : 2 * nd], y[2 * nd :], state)

        rest = np.concatenate([start.q, none, none])
        by_rates = lambda rates: residual(np.concatenate([start.q, rates]))  # noqa: E731
        found = np.hstack([differences(residual, rest)[:, :nd], differences(by_rates, rest[nd:], 10.0)])
        for name, columns in (("K", found[:, :nd]), ("C", found[:, nd : 2 * nd]), ("M", found[:, 2 * nd :])):
            assert np.abs(getattr(ltv, name)[i] - columns).max() < 1e-9 * np.abs(columns).max()
        assert ltv.F[i] == pytest.approx(-residual(rest), rel=1e-10)
    assert np.abs(ltv.F).max() > 1e-3


def test_between_stored_states_of_an_implicit_motion_the_equations_hold() -> None:
    system = pendulum()
    exact = system.simulate(1.0, samples=41, rtol=1e-11, method="DOP853")
    stored = system.simulate(1.0, samples=41, method="generalized-alpha", rtol=1e-8)
    assert not stored.interpolates
    found = system.along(stored).at(0.634)
    assert found.state_matrix == pytest.approx(system.along(exact).at(0.634).state_matrix, rel=1e-4)
    assert found.state_matrix == pytest.approx(nonlinear(system, found.state), rel=1e-8, abs=1e-8)


def test_inputs_and_outputs_along_a_motion_are_those_of_each_linearization() -> None:
    motion = crank()
    system = motion.system
    assert isinstance(system, fx.System)
    inputs, outputs = ["crank.angle", "p1.x"], ["p1.y", "rod1.bend2'", "force:crank.angle"]
    found = system.along(motion).state_space(inputs, outputs)
    for stack, alone in zip(found, system.linearize(motion[3]).state_space(inputs, outputs), strict=True):
        assert np.array_equal(stack[3], alone)
    A = system.along(motion).state_space(times=[0.0123])[0]
    assert A == pytest.approx(system.linearize(motion.at(0.0123)).state_matrix[None], rel=1e-12)


def test_about_a_state_the_equations_are_constant() -> None:
    system = pendulum()
    ltv = system.along(system.initial)
    assert ltv.constant and len(ltv) == 1 and "constant" in repr(ltv)
    assert np.array_equal(ltv.at(77.0).state_matrix, system.linearize().state_matrix)


def test_a_period_repeats_the_matrices() -> None:
    period = 2 * np.pi / SPEED
    ltv = slider_crank(SPEED).along(times=np.linspace(0, period, 9), period=period)
    assert len(ltv) == 8 and "period" in repr(ltv)
    assert ltv.at(0.3 * period + 4 * period).K == pytest.approx(ltv.at(0.3 * period).K, rel=1e-9)


def test_coordinates_that_become_nearly_singular_are_named() -> None:
    """A crank that turns over, described by its slider."""
    system = mechanisms.slider_crank("B.x").build()
    motion = system.simulate(0.6, samples=200)
    with pytest.raises(
        LinearizationError, match=r"B\.x are nearly singular at t = 0\.\d+ s.*'crank hinge\.angle'"
    ):
        system.along(motion)


# -- small vibrations -----------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("moving", "kicked", "seen"), [(ride, "lean.angle'", "yaw.angle"), (tyre, "hub.y'", "hub.z'")]
)
def test_a_transient_is_the_derivative_of_the_motion_by_its_start(
    moving: Callable[[], fx.Motion], kicked: str, seen: str
) -> None:
    motion = moving()
    system, base, size = motion.system, kicked.rstrip("'"), 1e-3
    assert isinstance(system, fx.System)
    first = motion[0]
    rates = {name: first.rate(name) for name in system.dynamic}
    near = []
    for change in (size, -size, 2 * size, -2 * size):
        start = system.state_at(rates=rates | {base: rates[base] + change}, start=first)
        near.append(
            system.simulate(float(motion.t[-1]), start=start, times=motion.t, method="DOP853", rtol=1e-12)
        )
    small = system.along(motion).transient({kicked: 1.0}, tolerance=1e-9)
    for name in (base, kicked, seen, *system.structure.internal):
        values = [other[name] for other in near]
        expected = (8 * (values[0] - values[1]) - (values[2] - values[3])) / (12 * size)
        assert small[name] == pytest.approx(expected, abs=1e-6 * np.abs(expected).max())
    assert small.total(seen) == pytest.approx(motion[seen] + small[seen], abs=1e-9)


def test_the_vibration_of_a_nominal_motion_is_near_the_nonlinear_one() -> None:
    """Largest difference of the deflection in the first turn, over the length of the rod; itself 1.5e-2."""
    system, times = slider_crank(SPEED), np.linspace(0.0, 0.04, 41)
    small = system.along(times=times).transient(tolerance=1e-6)
    full = system.simulate(0.04, times=times, method="DOP853", rtol=1e-8)
    off = np.abs(small["rod1.bend1"] - full["rod1.bend1"]).max()
    assert off < 0.04 * np.abs(full["rod1.bend1"]).max()
    with pytest.raises(LinearizationError, match="forces that drive the nominal motion"):
        small["force:rod1.bend1"]


def test_loads_and_prescribed_accelerations_drive_small_motions() -> None:
    """About a pendulum at rest: the closed form of a step of the moment on it."""
    system = pendulum()
    rest = system.equilibrium()
    small = system.along(rest).transient(inputs={"pivot.angle": 0.2}, times=np.linspace(0, 2, 9))
    omega = np.sqrt(1.5 * 9.81)
    expected = 0.2 / (9.81 / 2) * (1 - np.cos(omega * small.t))
    assert small["pivot.angle"] == pytest.approx(expected, abs=1e-8)


# -- periodic motions -----------------------------------------------------------------------------


def test_multipliers_and_harmonic_balance_are_those_of_the_orbit() -> None:
    period = 2 * np.pi / SPEED
    system = slider_crank(SPEED)
    ltv, c = (
        system.along(times=np.linspace(0, period, 5), period=period),
        orbit(system, period, 36).coefficients,
    )
    assert ltv.harmonic_balance(8).X == pytest.approx(c.harmonic_balance(8).X, abs=1e-12)
    expected = c.floquet_multipliers()
    assert np.abs(ltv.multipliers(1e-9)) == pytest.approx(np.abs(expected), abs=1e-8)
    assert np.abs(ltv.coefficients(36).floquet_multipliers()) == pytest.approx(np.abs(expected), abs=1e-8)


def test_a_rolling_bicycle_under_a_harmonic_moment_has_its_frequency_response() -> None:
    system = bicycle()
    state = rolling(system, 4.6, 0.0)
    frequency = 0.8
    ltv = system.along(state, period=1 / frequency)
    found = ltv.harmonic_balance(2, inputs={"steer.angle": lambda t: np.cos(2 * np.pi * frequency * t)})
    outputs = ["lean.angle", "steer.angle"]
    response = system.linearize(state).frequency_response("steer.angle", outputs, [frequency]).values[0, :, 0]
    names = found.coefficients.names
    harmonic = 2 * found.X[3, [names.index(name) for name in outputs]]
    assert harmonic * np.exp(-2j * np.pi * frequency * state.t) == pytest.approx(response, rel=1e-8)
    lin = system.linearize(state)
    moduli = np.sort(np.abs(np.exp(np.linalg.eigvals(lin.state_matrix) / frequency)))
    assert np.sort(np.abs(ltv.multipliers())) == pytest.approx(moduli, abs=1e-5)  # of defective ones


# -- bad input ------------------------------------------------------------------------------------


def test_what_is_not_a_motion_is_named() -> None:
    system, other = pendulum(), pendulum()
    motion = system.simulate(1.0, samples=3)
    for call, words in (
        (lambda: system.along(), "give a motion, a state, or the times"),
        (lambda: system.along("motion"), "str is not a motion"),
        (lambda: system.along(motion, times=[0, 1]), "has its own times"),
        (lambda: system.along(times=[1.0, 0.0]), "increasing"),
        (lambda: other.along(motion), "belongs to another model"),
        (lambda: other.along(system.initial), "belongs to another model"),
        (lambda: system.along(motion, period=-1.0), "not positive"),
        (lambda: system.along(motion).transient({"pivot": 1.0}), "pivot"),
    ):
        with pytest.raises(ModelError, match=words):
            call()


def test_times_and_inputs_that_do_not_exist_are_named() -> None:
    system = slider_crank(SPEED)
    ltv = system.along(system.simulate(0.01, samples=3))
    for call, words in (
        (lambda: ltv.at(0.02), r"0\.02 s lies outside the motion"),
        (lambda: ltv[3], "sample 3; there are 3"),
        (lambda: ltv.state_space(["displacement:crank.angle"]), "rates of the matrices"),
        (lambda: system.along(system.simulate(0.01, samples=3), period=1.0), "shorter than its period"),
        (lambda: ltv.multipliers(), "has no period"),
        (lambda: ltv.harmonic_balance(3), "has no period"),
        (lambda: ltv.transient(times=[0.0]), "two increasing times"),
        (lambda: bicycle().along(times=[0.0, 1.0]), r"rear contact\.x.* cannot be held"),
    ):
        with pytest.raises(LinearizationError, match=words):
            call()
