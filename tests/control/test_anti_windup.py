"""Anti-windup against loops written by hand: matrix exponentials for sampled controllers, SciPy for continuous ones."""

import copy
import pickle
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from controlled import MASS, Array, carriage, held_response
from scipy.integrate import solve_ivp
from scipy.signal import StateSpace

import flexel as fx

KP, KI, KD, N = 30.0, 40.0, 16.0, 50.0  # N/m, N/(m s), N s/m, 1/s
LIMIT, TO, T = 1.5, 1.5, 0.02  # N, m, s
LIMITS = (-LIMIT, LIMIT)


def pid(period: float | None) -> StateSpace:
    """PID with a filtered derivative: states are the integral part of the force, and the filter."""
    B, C, D = [[KI], [N]], [[1.0, -KD * N]], [[KP + KD * N]]
    if period is None:
        return StateSpace([[0, 0], [0, -N]], B, C, D)
    A = np.diag([1.0, 1 - N * period])
    return StateSpace(A, np.array(B) * period, C, D, dt=period)


def force(y: float, x: Array) -> float:
    """The output of the PID before it is limited."""
    return float(x[0] + KP * (TO - y) + KD * N * (TO - y - x[1]))


def rate(y: float, x: Array) -> Array:
    return np.array([KI * (TO - y), N * (TO - y - x[1])])


def limited(u: float) -> float:
    return min(max(u, -LIMIT), LIMIT)


def controlled(function: Any, **options: Any) -> fx.System:
    m = carriage()
    if not callable(function):
        options["reference"] = {"A.x": TO}
    m.controller(function, inputs=["A.x"], outputs=["A.x"], name="c", limits=LIMITS, **options)
    return m.build()


def by_hand(kind: str, strength: float) -> tuple[Array, Array, Array]:
    """Times, positions and forces of the sampled loop; the controller state is a variable of this loop."""
    x = np.zeros(2)

    def law(t: float, y: Array) -> float:
        u = force(y[0], x)
        change = T * rate(y[0], x)
        if kind == "clamp" and change[0] * (u - limited(u)) > 0:
            change[0] = 0.0
        if kind == "back":
            change[0] += strength * (limited(u) - u)
        x[:] += change
        return limited(u)

    t, found, u = held_response(law, T, 0.0, 6.0, np.array([0.5, 0.0]))
    return t, found[:, 0], u


def sampled_function(t: float, y: Array, x: Array) -> tuple[float, Array]:
    return force(float(y[0]), x), x + T * rate(float(y[0]), x)


CASES: dict[str, tuple[Any, Any, str, float]] = {  # what controls, anti-windup, and the same by hand
    "a system without": (pid(T), None, "none", 0.0),
    "a system with a time constant": (pid(T), 0.3, "back", T / 0.3),
    "a system with gains": (pid(T), [[0.12], [0.0]], "back", 0.12),
    "a system that clamps": (pid(T), "clamp", "clamp", 0.0),
    "a function with gains": (sampled_function, [[0.12], [0.0]], "back", 0.12),
}


@pytest.mark.parametrize("case", CASES)
def test_sampled_controllers_meet_a_loop_by_hand(case: str) -> None:
    function, given, kind, strength = CASES[case]
    options: dict[str, Any] = {} if kind == "none" else {"anti_windup": given}
    if callable(function):
        options |= {"state": [0, 0], "period": T}
    s = controlled(function, **options)
    t, x, u = by_hand(kind, strength)
    assert {-LIMIT, LIMIT} <= set(u.tolist())
    motion = s.simulate(6.0, times=t, method="DOP853")
    assert np.abs(motion["A.x"] - x).max() < 1e-10
    assert motion["c.u"] == pytest.approx(u, abs=1e-8)


def test_a_function_that_clamps_holds_its_own_state() -> None:
    """The controller is proportional-integral with a measured rate; its only state is the integral."""

    def pi(t: float, y: Array, x: Array) -> tuple[float, Array]:
        error = TO - y[0]
        return KP * error - KD * y[1] + x[0], x + T * KI * error

    x = np.zeros(1)

    def law(t: float, y: Array) -> float:
        u, new = pi(t, y, x)
        if (new[0] - x[0]) * (u - limited(u)) <= 0:
            x[:] = new
        return limited(u)

    t, found, _ = held_response(law, T, 0.0, 6.0, np.array([0.5, 0.0]))
    m = carriage()
    m.controller(pi, inputs=["A.x", "A.x'"], outputs=["A.x"], name="c", period=T, limits=LIMITS,
                 anti_windup="clamp", state=[0])  # fmt: skip
    motion = m.build().simulate(6.0, times=t, method="DOP853")
    assert np.abs(motion["A.x"] - found[:, 0]).max() < 1e-10
    assert motion["c.x0"][1] == motion["c.x0"][10] == 0.0 < motion["c.x0"][-1] ** 2


def continuous(strength: float) -> Array:
    """Positions of the loop with solve_ivp at times 0, 0.05, …, 6 s."""

    def slopes(t: float, y: Array) -> list[float]:
        u = force(y[0], y[2:])
        integral, filtered = rate(y[0], y[2:])
        return [y[1], limited(u) / MASS, integral + strength * (limited(u) - u), filtered]

    times = np.linspace(0, 6, 121)
    found = solve_ivp(slopes, (0, 6), [0.5, 0, 0, 0], t_eval=times, rtol=1e-11, atol=1e-12, max_step=0.01)
    return np.asarray(found.y[0])


def continuous_function(t: float, y: Array, x: Array) -> tuple[float, Array]:
    return force(float(y[0]), x), rate(float(y[0]), x)


def test_continuous_controllers_meet_scipy() -> None:
    """The implicit method needs a short step: it controls the error of coordinates, not of the controller's states."""
    known, times = continuous(1 / 0.3), np.linspace(0, 6, 121)
    short: dict[str, Any] = {"method": "generalized-alpha", "step": 1e-3}
    function = {"anti_windup": [[1 / 0.3], [0.0]], "state": [0, 0]}
    for given, options, how, tolerance in (
        (pid(None), {"anti_windup": 0.3}, {"method": "DOP853"}, 1e-7),
        (pid(None), {"anti_windup": 0.3}, short, 1e-4),
        (continuous_function, function, {"method": "DOP853"}, 1e-7),
    ):
        motion = controlled(given, **options).simulate(6.0, times=times, **how)
        assert np.abs(motion["A.x"] - known).max() < tolerance


def test_a_step_response_overshoots_less() -> None:
    """By more than a metre without, as the integral part has grown while the force was at its limit."""
    for period, ways in ((T, (0.3, "clamp")), (None, (0.3,))):
        without, *others = (
            controlled(pid(period), **({} if way is None else {"anti_windup": way})).simulate(20.0)["A.x"]
            for way in (None, *ways)
        )
        assert without.max() - TO > 0.5
        for x in others:
            assert 0 < x.max() - TO < 0.25 * (without.max() - TO)
            assert x[-1] == pytest.approx(TO, abs=1e-3)


def test_within_the_limits_nothing_changes() -> None:
    at = {"A.x": TO}
    for period, ways in ((T, (0.3, "clamp", [[5.0], [3.0]])), (None, (0.3, [[5.0], [3.0]]))):
        plain = controlled(pid(period))
        for way in ways:
            s = controlled(pid(period), anti_windup=way)
            pair = [system.linearize(system.state_at(at)) for system in (plain, s)]
            found = [(lin.sampled() if period else lin).eigenvalues() for lin in pair]
            assert found[0] == pytest.approx(found[1], abs=1e-12)
            assert s.simulate(0.5, start=s.state_at({"A.x": TO - 0.001}))["A.x"] == pytest.approx(
                plain.simulate(0.5, start=plain.state_at({"A.x": TO - 0.001}))["A.x"], abs=1e-12
            )


def test_copies_and_checkpoints_keep_it(tmp_path: Path) -> None:
    """A checkpoint is of one anti-windup, and of one set of matrices."""
    file = tmp_path / "part.npz"
    s = controlled(pid(T), anti_windup=0.3)
    motion = s.simulate(1.0, samples=5, checkpoint=file)
    for other in (pickle.loads(pickle.dumps(s)), copy.deepcopy(s)):
        assert np.array_equal(other.simulate(1.0, samples=5)["A.x"], motion["A.x"])
    twice = pid(T)
    twice.D *= 2
    for function, way in ((pid(T), 0.4), (pid(T), "clamp"), (pid(T), None), (twice, 0.3)):
        with pytest.raises(fx.ModelError, match="belongs to another simulation"):
            controlled(function, anti_windup=way).simulate(1.0, samples=5, checkpoint=file)


def test_each_of_several_outputs_is_clamped_by_itself() -> None:
    """Two integrators, written in other coordinates: the one of the output that is at its limit stops."""
    m = carriage()
    m.point("B", (0, 1))
    m.fix("B.y")
    m.point_mass("other", "B", 1e6)
    m.independent("B.x")
    Q = np.array([[1.0, 2.0], [-3.0, 1.0]])
    P = np.linalg.inv(Q)
    system = StateSpace(np.eye(2), Q * 0.1, P, np.zeros((2, 2)), dt=0.1)
    m.controller(system, inputs=["A.x", "B.x"], outputs=["B.x", "A.x"], name="c", reference={"A.x": 1.0, "B.x": 1.0},
                 limits=([-0.3, -np.inf], [0.3, np.inf]), anti_windup="clamp", state=Q @ [0.28, 0.0])  # fmt: skip
    motion = m.build().simulate(1.5, times=np.linspace(0, 1.5, 16))
    parts = P @ [motion["c.x0"], motion["c.x1"]]
    assert parts[0, 1:] == pytest.approx(0.28 + 0.05, abs=1e-12)  # one step over the limit, and no further
    assert parts[1, -1] == pytest.approx(0.1 * np.sum(1 - motion["B.x"][:-1]), abs=1e-4)
    assert motion["c.u0"].max() == 0.3 and motion["c.u1"].max() > 1.3


def test_what_cannot_be_is_refused() -> None:
    lagged = StateSpace(-1.0, 1.0, 1.0, 0.0)
    chain = StateSpace([[0, 1], [0, 0]], [[0], [1]], [[1, 1]], 0)
    unseen = StateSpace([[0, 0], [0, -1]], [[1], [1]], [[0, 1]], 0)
    gains = "give gains"
    for function, options, match in (
        ([[1.0]], {"anti_windup": 0.1}, "no state that could wind up"),
        (pid(None), {"anti_windup": 0.1, "limits": None}, "without limits nothing winds up; give limits="),
        (pid(None), {"anti_windup": "clamp"}, "'clamp' is for sampled controllers; for a continuous one give a time"),
        (pid(T), {"anti_windup": "clam"}, r"give a time constant \[s\], gains .*, or 'clamp'"),
        (pid(T), {"anti_windup": 0.01}, "time constant 0.01 s is less than the period 0.02 s"),
        (pid(T), {"anti_windup": -1}, "time constant -1 is not positive"),
        (pid(T), {"anti_windup": [[1, 2]]}, r"gains of shape \(1, 2\); give \(2, 1\), a row for each state"),
        (pid(T), {"anti_windup": {"a": 1}}, "not numeric"),
        (lagged, {"anti_windup": 0.1}, rf"no integrator \(a pole at 0\); {gains}"),
        (chain, {"anti_windup": 0.1}, rf"integrators in series; {gains}"),
        (unseen, {"anti_windup": 0.1}, "no output depends on an integrator"),
        (sampled_function, {"anti_windup": 0.1, "state": [0, 0], "period": T}, "for a function give gains"),
    ):  # fmt: skip
        m = carriage()
        given: dict[str, Any] = {"limits": LIMITS, **options}
        with pytest.raises(fx.ModelError, match=match):
            m.controller(function, inputs=["A.x"], outputs=["A.x"], name="c", **given)
        assert not m.controllers
