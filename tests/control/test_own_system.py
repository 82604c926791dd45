"""Functions of the user that use the system they belong to, within its own evaluations."""

from typing import Any

import numpy as np
import pytest

import flexel as fx


def swung(method: str, used: str, period: float | None = None) -> float:
    """The end of a motion of a pendulum with a controller and a load, one of which uses a state of the system."""
    box: dict[str, Any] = {}

    def use(by: str) -> None:
        if by == used and box:
            assert box["start"].J.any()  # evaluates the position of another state

    def controller(t: float, y: Any) -> Any:
        use("controller")
        return -1.0 * y

    def load(t: Any) -> Any:
        use("load")
        return np.sin(t)

    m = fx.Model(gravity=(0, -9.81))
    m.point("O", (0, 0), fixed=True)
    m.point("A", (0.3, -0.9))
    m.truss("rod", "O", "A")
    m.point_mass("mass", "A", 1.0)
    m.controller(controller, inputs=["A.x"], outputs=["A.x"], name="c", period=period)
    m.load("A.y", load)
    system = m.build()
    box["start"] = system.initial
    return float(system.simulate(1.0, samples=3, method=method)["A.x"][-1])


@pytest.mark.parametrize("method", ["DOP853", "Radau", "generalized-alpha"])
@pytest.mark.parametrize("period", [None, 0.1])
def test_controllers_and_loads_may_use_their_system(method: str, period: float | None) -> None:
    """The evaluation that called them goes on with its own position: before, the pendulum did not move."""
    expected = swung(method, "nothing", period)
    assert abs(expected - 0.3) > 0.1
    assert swung(method, "controller", period) == expected
    assert swung(method, "load", period) == expected


USES = ("nothing", "controller", "load", "prescribed", "event")


def carried(method: str, used: str, period: float | None) -> tuple[list[float], int]:
    """A motion of a driven pendulum, one of whose functions simulates and linearizes the system; how often it did."""
    box: dict[str, Any] = {"calls": 0, "used": 0, "busy": False}

    def use(by: str) -> None:
        if by != used or "system" not in box or box["busy"]:
            return
        box["calls"] += 1
        if box["calls"] % 7 != 1 or box["used"] >= 2:
            return
        box["busy"] = True  # what it calls there calls it again
        system = box["system"]
        other = system.state_at({"rod.elongation": 0.2})
        system.simulate(0.02, start=other, method=method, samples=3, progress=False)
        system.linearize(other)
        system.rhs(0.1, np.full(4 + system.structure.nz, 0.1))
        box["busy"] = False
        box["used"] += 1

    def controller(t: float, y: Any) -> Any:
        use("controller")
        return -1.0 * y

    def load(t: Any) -> Any:
        use("load")
        return np.sin(t)

    def drive(t: Any) -> Any:
        use("prescribed")
        return 0.1 * np.sin(2 * t)

    def low(state: fx.State) -> float:
        use("event")
        return state["A.x"] - 0.25

    m = fx.Model(gravity=(0, -9.81))
    m.point("O", (0, 0))
    m.fix("O.y")
    m.prescribe("O.x", drive)
    m.point("A", (0.3, -0.9))
    m.truss("rod", "O", "A", stiffness=400.0, damping=1.0)
    m.point_mass("mass", "A", 1.0)
    m.controller(controller, inputs=["A.x"], outputs=["A.x"], name="c", period=period)
    m.load("A.y", load)
    box["system"] = system = m.build()
    box["calls"] = box["used"] = 0
    events = {} if method == "generalized-alpha" else {"events": [fx.Event("low", low)]}
    motion = system.simulate(0.2, samples=3, method=method, progress=False, **events)
    ends = [found.t for _, found in motion.events]
    return [*motion["A.x"].tolist(), *motion["A.y'"].tolist(), *ends], box["used"]


@pytest.mark.parametrize(
    ("method", "period"),
    [
        ("DOP853", None),
        ("DOP853", 0.05),
        pytest.param("Radau", 0.05, marks=pytest.mark.long),
        pytest.param("Radau", None, marks=pytest.mark.long),
        ("generalized-alpha", None),
        ("generalized-alpha", 0.05),
    ],
)
def test_functions_may_simulate_and_linearize_their_system_within_a_motion(
    method: str, period: float | None
) -> None:
    """To the bit: each level of calls has a workspace of its own, and steps keep what they need elsewhere."""
    expected, _ = carried(method, "nothing", period)
    for used in USES[1:]:
        if (method, used) == ("generalized-alpha", "event"):
            continue  # it has no events
        found, times = carried(method, used, period)
        assert times, used
        assert found == expected, used


def test_a_function_that_evaluates_what_calls_it_is_named() -> None:
    box: dict[str, fx.System] = {}
    m = fx.Model()
    m.point_mass("mass", m.point("A", (0, 0)), 1.0)
    m.fix("A.y")

    def controller(t: float, y: Any) -> Any:
        if box:
            box["system"].rhs(t, np.array([y[0], 0.0]))
        return -1.0 * y

    m.controller(controller, inputs=["A.x"], outputs=["A.x"], name="c")
    box["system"] = m.build()
    with pytest.raises(fx.ModelError, match=r"endlessly evaluates the system that calls it"):
        box["system"].simulate(1.0)


def test_a_right_hand_side_raises_what_a_controller_raises() -> None:
    """Before, the accelerations were not numbers, and the next call raised."""

    def broken(t: float, y: Any) -> Any:
        if t > 0:
            raise ValueError("no value")
        return -1.0 * y

    m = fx.Model()
    m.point_mass("mass", m.point("A", (0, 0)), 1.0)
    m.fix("A.y")
    m.controller(broken, inputs=["A.x"], outputs=["A.x"], name="c")
    system = m.build()
    with pytest.raises(fx.ModelError, match=r"controller 'c' at t = 1 s: the function failed \(.*no value"):
        system.rhs(1.0, np.array([1.0, 0.0]))
    assert system.rhs(0.0, np.array([1.0, 0.0])).tolist() == [0.0, -1.0]
