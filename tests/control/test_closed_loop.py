"""Linearized closed loops against python-control, SciPy and closed forms: continuous, and sampled with delays."""

from typing import Any

import numpy as np
import pytest
from controlled import MASS, Array, carriage, cart
from scipy.integrate import solve_ivp
from scipy.linalg import expm, solve_continuous_are

import flexel as fx

# the matrix of a linear loop is the same at all states
LINEAR = pytest.mark.filterwarnings("ignore:sampled. this is not a fixed point:flexel.UnsteadyWarning")


T = 0.02


def design() -> tuple[fx.Linearization, Array, Array, Array]:
    """The cart: its linearization, A, B, and the gains of a linear-quadratic regulator."""
    lin = cart().build().linearize()
    A, B, *_ = lin.state_space(["cart.x"])
    X = solve_continuous_are(A, B, np.diag([1.0, 1, 10, 10]), 0.1 * np.eye(1))
    return lin, A, B, 10 * B.T @ X


def largest_first(values: Any) -> Array:
    return np.asarray(sorted(np.abs(values), reverse=True))


def controlled(function: Any, **options: Any) -> fx.System:
    lin = design()[0]
    m = cart()
    m.controller(function, **{"inputs": lin.states, "outputs": ["cart.x"], **options})
    return m.build()


def test_gains_and_a_function_give_the_poles_of_the_design() -> None:
    _, A, B, K = design()
    known = np.sort_complex(np.linalg.eigvals(A - B @ K))
    for function in (K, lambda t, y: -K @ y):
        found = np.sort_complex(controlled(function).linearize().eigenvalues())
        assert found == pytest.approx(known, rel=1e-9)


def test_a_function_of_a_nonlinear_kind_is_differentiated() -> None:
    m = carriage()
    m.controller(
        lambda t, y: -5 * np.sin(y[0]) - np.tanh(3 * y[1]) + t, inputs=["A.x", "A.x'"], outputs=["A.x"]
    )
    lin = m.build().linearize()
    assert lin.K[0, 0] == pytest.approx(5 * np.cos(0.5), rel=1e-9)
    assert lin.C[0, 0] == pytest.approx(3.0, rel=1e-9)


def test_a_dynamic_controller_in_three_forms() -> None:
    """PID with a filtered derivative: a state-space system, a transfer function, and a function with rates."""
    control = pytest.importorskip("control", reason="pip install 'flexel[control]'")
    pid = control.tf([40.0, 60.0, 30.0], [0.05, 1.0, 0.0])
    system = control.ss(pid)
    A, B, C, D = (np.asarray(getattr(system, name)) for name in "ABCD")
    reference = {"A.x": 0.2}

    def own(t: float, y: Array, x: Array) -> tuple[Array, Array]:
        w = 0.2 - y
        return C @ x + D @ w, A @ x + B @ w

    systems = []
    for function, options in (
        (system, {"reference": reference}),
        (own, {"state": [0, 0]}),
        (pid, {"reference": reference}),
    ):
        m = carriage()
        m.controller(function, inputs=["A.x"], outputs=["A.x"], name="pid", **options)
        systems.append(m.build())
    plant = control.ss([[0, 1], [0, 0]], [[0], [1 / MASS]], [[1, 0]], 0)
    loop = control.feedback(plant * system)
    known = np.sort_complex(loop.poles())
    t = np.linspace(0, 2, 101)
    whole = control.forced_response(control.feedback(plant, system), t, np.zeros(101), X0=[0.3, 0, 0, 0])
    for s in systems:
        assert np.sort_complex(s.linearize(s.state_at({"A.x": 0.2})).eigenvalues()) == pytest.approx(
            known, rel=1e-9
        )
        for method, tolerance in (("DOP853", 1e-8), ("generalized-alpha", 1e-4)):
            motion = s.simulate(2, times=t, method=method)
            assert motion["A.x"] - 0.2 == pytest.approx(np.squeeze(whole.outputs), abs=tolerance)
            first = motion["pid.u"]
            assert first[0] == pytest.approx(-0.3 * D[0, 0], rel=1e-12)
            assert first == pytest.approx(2 * motion["A.x''"], abs=1e-9)


def test_the_sampled_regulator_is_that_of_python_control() -> None:
    control = pytest.importorskip("control", reason="pip install 'flexel[control]'")
    _, A, B, K = design()
    plant = control.c2d(control.ss(A, B, np.eye(4), 0), T, "zoh")
    lag = control.ss(0, 1, 1, 0, T)
    assert K.shape == (1, 4)
    for delay, line in ((0.0, plant), (T, plant * lag), (2 * T, plant * lag * lag)):
        known = largest_first(control.feedback(line, control.ss([], [], [], K, T)).poles())
        for function in (K, lambda t, y: -K @ y):
            loop = controlled(function, period=T, delay=delay).linearize().sampled()
            found = largest_first(loop.eigenvalues())
            assert found[: known.size] == pytest.approx(known, rel=1e-8)
            assert found[known.size :] == pytest.approx(0.0, abs=1e-6)
            assert loop.stable == bool(known[0] < 1) and loop.period == T


def test_an_observer_of_python_control_closes_the_sampled_loop() -> None:
    """Only positions are measured; the discrete controller has the period itself."""
    control = pytest.importorskip("control", reason="pip install 'flexel[control]'")
    _, A, B, _ = design()
    C = np.eye(4)[2:]
    plant = control.c2d(control.ss(A, B, C, 0), T, "zoh")
    Ad, Bd = np.asarray(plant.A), np.asarray(plant.B)
    K = np.asarray(control.dlqr(Ad, Bd, np.diag([1.0, 1, 10, 10]), 0.1)[0])
    L = np.asarray(control.dlqe(Ad, np.eye(4), C, 1e-2 * np.eye(4), 1e-4 * np.eye(2))[0])
    F = Ad @ L  # corrected, then predicted
    observer = control.ss(Ad - Bd @ K - F @ C, F, K, np.zeros((1, 2)), T)
    s = controlled(observer, inputs=["cart.x", "pivot.angle"], name="lqg")
    loop = s.linearize().sampled()
    known = largest_first(control.feedback(plant, observer).poles())
    assert largest_first(loop.eigenvalues())[:8] == pytest.approx(known, rel=1e-7)
    assert loop.stable and "lqg.x3" in loop.states
    motion = s.simulate(8.0, start=s.state_at({"pivot.angle": 0.05}))
    assert abs(motion["pivot.angle"][-1]) < 1e-3 < abs(motion["pivot.angle"]).max()


@pytest.mark.parametrize("part", [0.3, 0.75])
def test_a_delay_of_a_part_of_the_period(part: float) -> None:
    """x(k+1) = Φ(T) x(k) + Γ1 u(k-1) + Γ0 u(k), written with matrix exponentials."""
    _, A, B, K = design()
    M = np.block([[A, B], [np.zeros((1, 5))]])
    both, late = expm(M * T), expm(M * (1 - part) * T)
    G0 = late[:4, 4:]
    G1 = both[:4, 4:] - G0
    known = largest_first(np.linalg.eigvals(np.block([[both[:4, :4] - G0 @ K, G1], [-K, np.zeros((1, 1))]])))
    loop = controlled(K, period=T, delay=part * T).linearize().sampled()
    assert largest_first(loop.eigenvalues())[:5] == pytest.approx(known, rel=1e-8)


@LINEAR
@pytest.mark.parametrize("side", [0.999, 1.001])
def test_the_limits_of_the_gains_of_a_sampled_double_integrator(side: float) -> None:
    """By Jury's criterion it is stable for kp T/2 < kd < 2/T, gains per mass."""
    for kp, kd, stable in ((8.0, 8.0 * T / 2 * side, side > 1), (8.0, (2 / T) * side, side < 1)):
        m = carriage()
        m.controller([[MASS * kp, MASS * kd]], inputs=["A.x", "A.x'"], outputs=["A.x"], period=T)
        assert m.build().linearize().sampled().stable == stable


def test_a_speed_loop_is_stable_with_a_free_angle() -> None:
    """w(k+1) = w(k) (1 - k T/J): the angle enters no force, and a deviation of it remains; up to k = 2 J/T."""
    for gain, stable in ((5.0, True), (2.1 * 0.5 / T, False)):
        m = fx.Model()
        m.rigid_body("rotor", (0, 0), mass=1.0, inertia=0.5)
        m.revolute("shaft", "ground", "rotor", at=(0, 0))
        m.controller([[gain]], inputs=["shaft.angle'"], outputs=["shaft.angle"], period=T)
        loop = m.build().linearize().sampled()
        assert largest_first(loop.eigenvalues())[:2] == pytest.approx(
            sorted([1.0, abs(1 - gain * T / 0.5)])[::-1]
        )
        assert loop.stable == stable and loop.free == ("shaft.angle",)
        assert ("; stable, with 1 free motion: shaft.angle)" in repr(loop)) == stable


def test_a_rate_that_nothing_resists_is_not_stable() -> None:
    """It is the angle that may be free: a mass that drifts leaves its place."""
    m = fx.Model()
    m.rigid_body("rotor", (0, 0), mass=1.0, inertia=0.5)
    m.revolute("shaft", "ground", "rotor", at=(0, 0))
    m.controller([[0.0]], inputs=["shaft.angle'"], outputs=["shaft.angle"], period=T)
    loop = m.build().linearize().sampled()
    assert not loop.stable and loop.free == ("shaft.angle",)


def test_what_a_sampled_loop_measures_may_be_an_acceleration() -> None:
    """Acceleration just before the instant: u(k) = -(M/2) a, a = u(k-1)/M, so that u halves and changes its sign."""
    m = carriage()
    m.controller([[MASS / 2]], inputs=["A.x''"], outputs=["A.x"], period=T, name="c")
    s = m.build()
    assert largest_first(s.linearize().sampled().eigenvalues()) == pytest.approx([1, 1, 0.5], abs=1e-7)
    start = s.state_at({"c.u": 8.0})
    motion = s.simulate(5 * T, start=start, samples=6)
    assert motion["c.u"] == pytest.approx([8, -4, 2, -1, 0.5, -0.25], rel=1e-12)


def test_saturation_of_a_continuous_controller() -> None:
    """A kink within the motion: against solve_ivp, both for gains and for a function."""
    found = solve_ivp(
        lambda t, x: [x[1], np.clip(-30 * x[0] - 8 * x[1], -3, 2) / MASS],
        (0, 3),
        [0.5, 0.3],
        rtol=1e-11,
        atol=1e-12,
    )
    for function in ([[30.0, 8.0]], lambda t, y: -30 * y[0] - 8 * y[1]):
        m = carriage()
        m.controller(function, inputs=["A.x", "A.x'"], outputs=["A.x"], limits=(-3, 2))
        s = m.build()
        motion = s.simulate(3, start=s.state_at(rates={"A.x": 0.3}), times=[0.0, 3.0])
        assert motion["A.x"][-1] == pytest.approx(found.y[0, -1], abs=1e-8)
        assert motion["controller.u"][0] == -3.0


def test_statics_with_a_controller() -> None:
    """A smooth one takes part as a spring does; a sampled one holds its outputs."""
    m = carriage()
    m.load("A.x", 6.0)
    m.controller(lambda t, y: -10 * np.sinh(y[0]), inputs=["A.x"], outputs=["A.x"])
    assert m.build().equilibrium()["A.x"] == pytest.approx(np.arcsinh(0.6), abs=1e-10)
    m = carriage()
    m.spring("A.x", 20.0)
    m.controller([[1.0]], inputs=["A.x"], outputs=["A.x"], period=0.1, name="c")
    s = m.build()
    assert s.equilibrium()["A.x"] == pytest.approx(0.5, abs=1e-12)
    held = s.equilibrium(s.state_at({"c.u": 4.0}))
    assert held["A.x"] == pytest.approx(0.7, abs=1e-12) and held["c.u"] == 4.0


def test_a_sampled_loop_is_linearized_where_it_repeats() -> None:
    """A sampled output that hardens as a spring: at rest where 10 x + 40 x³ = 2."""
    m = carriage()
    m.controller(lambda t, y: 2 - 10 * y[0] - 40 * y[0] ** 3 - 5 * y[1], inputs=["A.x", "A.x'"], outputs=["A.x"],
                 period=0.01, name="c")  # fmt: skip
    s = m.build()
    with pytest.warns(
        fx.UnsteadyWarning, match=r"sampled: .* because controller 'c' would change 'c.u' from 0 to"
    ):
        s.linearize().sampled()
    settled = s.simulate(30.0, samples=2)[-1]
    root = np.roots([40.0, 0.0, 10.0, -2.0])
    place = float(root[np.isreal(root)].real[0])
    assert settled["A.x"] == pytest.approx(place, abs=1e-6)
    poles = s.linearize(settled).sampled().eigenvalues()
    slope = 10 + 120 * place**2
    loop = np.array([[1, 0.01], [0, 1]]) - np.array([[0.01**2 / 2], [0.01]]) @ [[slope, 5.0]] / MASS
    np.testing.assert_allclose(
        np.sort_complex(poles[:2]), np.sort_complex(np.linalg.eigvals(loop)), rtol=1e-6
    )
