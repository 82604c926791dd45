"""Controllers of high order, and sampled ones of different periods, against python-control and simulated motions."""

from typing import Any

import numpy as np
import pytest
from controlled import MASS, Array, carriage, lagging

import flexel as fx

# the matrix of a linear loop is the same at all states
LINEAR = pytest.mark.filterwarnings("ignore:sampled. this is not a fixed point:flexel.UnsteadyWarning")


ORDER = 40


def high_order() -> tuple[Array, Array, Array, Array]:
    """A lead compensator and resonant parts from 3 to 60 rad/s, in other coordinates so that no entry is zero."""
    A, B, C = np.zeros((ORDER, ORDER)), np.ones((ORDER, 1)), np.zeros((1, ORDER))
    A[0, 0], C[0, 0] = -20.0, -200.0
    A[-1, -1], C[0, -1] = -3.0, 2.0
    for i, w in enumerate(np.linspace(3, 60, ORDER // 2 - 1)):
        k = 1 + 2 * i
        A[k : k + 2, k : k + 2] = [[-0.2 * w, w], [-w, -0.2 * w]]
        C[0, k] = 0.05 * w
    Q = np.linalg.qr(np.random.default_rng(3).normal(size=A.shape))[0]
    return Q @ A @ Q.T, Q @ B, C @ Q.T, np.array([[20.0]])


def test_forty_own_states_are_those_of_python_control() -> None:
    """Poles and motion of the closed loop; as a system and as a function, with an explicit and an implicit method."""
    control = pytest.importorskip("control", reason="pip install 'flexel[control]'")
    A, B, C, D = high_order()
    plant = control.ss([[0, 1], [0, 0]], [[0], [1 / MASS]], [[1, 0]], 0)
    loop = control.feedback(plant, control.ss(A, B, C, D))
    poles = np.sort_complex(loop.poles())
    assert poles.real.max() < 0
    t = np.linspace(0, 3, 301)
    known = control.forced_response(loop, t, np.zeros(t.size), X0=[0.5, *np.zeros(ORDER + 1)])
    for function, options, methods in (
        (control.ss(A, B, C, D), {}, {"DOP853": 1e-8, "generalized-alpha": 1e-3}),
        (lambda t, y, x: (C @ x - D @ y, A @ x - B @ y), {"state": np.zeros(ORDER)}, {"DOP853": 1e-8}),
    ):
        m = carriage()
        m.controller(function, inputs=["A.x"], outputs=["A.x"], name="c", **options)
        s = m.build()
        found = np.sort_complex(s.linearize(s.state_at({"A.x": 0.0})).eigenvalues())
        assert found == pytest.approx(poles, rel=1e-7)
        for method, tolerance in methods.items():
            motion = s.simulate(3.0, times=t, method=method)
            assert np.abs(motion["A.x"] - np.squeeze(known.outputs)).max() < tolerance


def two_rates(**options: Any) -> fx.System:
    """A fast inner loop with delay for the rate, and a slow outer loop with an own state."""
    m = carriage()
    m.point("B", (0, 1))
    m.fix("B.y")
    m.point_mass("other", "B", 1.0)
    m.independent("B.x")
    fast: dict[str, Any] = {"period": 0.02, "delay": 0.013, **options.get("fast", {})}
    slow: dict[str, Any] = {"period": 0.05, "delay": 0.06, **options.get("slow", {})}
    m.controller([[8.0, 12.0]], inputs=["A.x'", "A.x"], outputs=["A.x"], name="fast", **fast)
    m.controller(lagging, inputs=["B.x"], outputs=["B.x"], name="slow", state=[0.0], **slow)
    m.controller([[3.0, 0.01]], inputs=["B.x'", "fast.u"], outputs=["B.x"], name="third", period=0.1)
    return m.build()


@LINEAR
def test_a_loop_of_several_periods_is_that_of_simulated_motions() -> None:
    """All is linear: deviations of each state, a tenth of a second later, are the columns of the matrix."""
    s = two_rates()
    loop = s.linearize().sampled()
    assert loop.period == pytest.approx(0.1, rel=1e-15)
    rates = {name.removesuffix("'") for name in loop.states if name.endswith("'")}

    def end(name: str | None) -> Array:
        given = dict.fromkeys([name for name in loop.states if not name.endswith("'")], 0.1)
        speeds = dict.fromkeys(rates, 0.1)
        if name is not None:
            (speeds if name.endswith("'") else given)[name.removesuffix("'")] += 1.0
        motion = s.simulate(0.1, start=s.state_at(given, rates=speeds), samples=2, method="DOP853")
        return np.array([motion[name][-1] for name in loop.states])

    columns = [end(name) - end(None) for name in loop.states]
    assert loop.state_matrix == pytest.approx(np.array(columns).T, abs=1e-9)


@LINEAR
def test_stability_of_two_periods_is_that_of_motions() -> None:
    """With a longer delay of the slow loop the motion grows, by the largest eigenvalue in each common period."""
    for delay, stable in ((0.06, True), (0.2, False)):
        s = two_rates(slow={"delay": delay})
        loop = s.linearize().sampled()
        assert loop.stable == stable
        largest = abs(loop.eigenvalues()[0])
        motion = s.simulate(12.0, times=np.linspace(0, 12, 121), start=s.state_at({"B.x": 0.3}))
        size = np.abs(motion["B.x"] - (0.2 if stable else 0.0))
        late, early = size[90:].max(), size[30:60].max()
        assert (late < early) == stable == (largest < 1)


@LINEAR
def test_periods_without_a_common_multiple_are_named() -> None:
    for period in (0.02 * np.sqrt(2), 0.02 * 997 / 991):
        s = two_rates(slow={"period": period, "delay": 0.0})
        with pytest.raises(
            fx.LinearizationError, match=r"'fast' 0.02 s, 'slow' 0.0\d+ s.*no common multiple"
        ):
            s.linearize().sampled()
    assert two_rates(slow={"period": 0.02 / 3}).linearize().sampled().period == pytest.approx(0.1, rel=1e-12)
