"""Steps that are taken in a row in C are those that are taken one by one, to the last digit."""

from collections.abc import Callable

import numpy as np
import pytest

import flexel as fx
from flexel.examples.bicycle import bicycle, rolling
from flexel.integration.dop853 import Dop853
from flexel.integration.driver import LOOK_EVERY, Run
from flexel.integration.radau import Radau
from flexel.integration.step_method import InRow, StepMethod
from flexel.integration.watch import LOOK
from flexel.integration.watchdog import FIRST, WINDOW

SECONDS = 4.0


Model = tuple[fx.System, fx.State]  # and its start


def double_pendulum() -> Model:
    """Degrees of freedom reach their extremes, and others are chosen."""
    m = fx.Model(gravity=(0, 0, -9.81))
    m.point("O", (0, 0, 0), fixed=True)
    for number, (name, before) in enumerate((("P", "O"), ("Q", "P")), start=1):
        m.point(name, (float(number), 0, 0.1 * number))
        m.truss(f"bar {name}", before, name)
        m.point_mass(f"mass {name}", name, 1.0)
    system = m.build()
    return system, system.initial


def bouncing() -> Model:
    """Contacts end steps."""
    m = fx.Model(gravity=(0, -9.81))
    m.point("O", (0, 0), fixed=True)
    m.angle("ground", fixed=True)
    m.point("ball", (0, 0.1))
    m.fix("ball.x")
    m.point_mass("mass", "ball", 1.0)
    m.plane("floor", "O", "ground", normal=(0, 1))
    m.contact("touch", "ball", "floor", fx.Contact(1e4, exponent=1.0))
    system = m.build()
    return system, system.initial


def rolling_bicycle() -> Model:
    """It has kinematic coordinates."""
    system = bicycle()
    return system, rolling(system, 4.6, 0.5)


def thrown() -> Model:
    """A body turns freely."""
    m = fx.Model()
    m.body("body", m.point("P", (0, 0, 0)), m.frame("R"), mass=1.0, inertia=(1.0, 2.0, 3.0))
    w = m.angular_velocity("R")
    for name, rate in zip(("wx", "wy", "wz"), (0.3, 5.0, 0.5), strict=True):
        m.initial(f"{w}.{name}", rate=rate)
    system = m.build()
    return system, system.initial


def driven() -> Model:
    """A crank turns as a table says, and a load grows; there are knots."""
    m = fx.Model(gravity=(0, -9.81))
    m.point("O", (0, 0), fixed=True)
    m.angle("ground", fixed=True)
    m.hinge("motor", "ground", m.angle("crank"))
    m.beam("rod", "O", "crank", m.point("A", (1, 0)), mass_per_length=1.0)
    m.truss("rope", "A", m.point("B", (1, -1)), stiffness=500.0, damping=2.0)
    m.point_mass("mass", "B", 1.0)
    times = np.linspace(0, SECONDS, 9)
    m.prescribe("motor.angle", fx.Table(times, np.sin(times)))
    m.load("B.x", fx.Ramp(0.5, 1.7, 0.0, 3.0))
    system = m.build()
    return system, system.initial


def shaken() -> Model:
    """A stiff chain by Radau, and laws with internal states."""
    m = fx.Model(gravity=(0, -9.81))
    ends = [m.point("O", (0, 0), fixed=True), m.point("A", (1, 0)), m.point("B", (2, 0.1))]
    for i in (0, 1):
        m.truss(f"spring {i}", ends[i], ends[i + 1], stiffness=1e5, damping=100.0)
        m.point_mass(f"mass {i}", ends[i + 1], (0.01, 1.0)[i])
    system = m.build()
    return system, system.initial


def moved(model: Model, samples: int, method: str = "DOP853") -> fx.Motion:
    """Move a model."""
    system, start = model
    return system.simulate(SECONDS, start=start, method=method, samples=samples)


def counted(monkeypatch: pytest.MonkeyPatch, kind: type[StepMethod] = Dop853) -> list[int]:
    """Return a list to which the lengths of rows are added."""
    found: list[int] = []
    own = kind.row

    def row(method: StepMethod, most: int, allowed: float) -> list[InRow]:
        steps = list(own(method, most, allowed))
        found.append(len(steps))
        return steps

    monkeypatch.setattr(kind, "row", row)
    return found


def one_by_one(method: StepMethod, most: int, allowed: float) -> list[InRow]:
    """Take no steps in a row."""
    return []


@pytest.mark.parametrize("samples", [2, 201])
@pytest.mark.parametrize("model", [double_pendulum, bouncing, rolling_bicycle, thrown, driven])
def test_steps_in_a_row_are_those_taken_one_by_one(
    model: Callable[[], Model], samples: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    own = model()
    rows = counted(monkeypatch)
    motion = moved(own, samples)
    assert sum(rows) > 0.6 * motion.statistics["steps"]
    monkeypatch.setattr(Dop853, "row", one_by_one)
    alone = moved(own, samples)
    assert motion.statistics == alone.statistics
    assert motion.message == alone.message
    for t in np.linspace(0.0, SECONDS, 41).tolist():
        np.testing.assert_array_equal(motion.at(t).x, alone.at(t).x)
        np.testing.assert_array_equal(motion.at(t).v, alone.at(t).v)


@pytest.mark.parametrize("model", [bouncing, driven, shaken, thrown])
def test_steps_of_radau_in_a_row_are_those_taken_one_by_one(
    model: Callable[[], Model], monkeypatch: pytest.MonkeyPatch
) -> None:
    """To the last digit while no trial of a row is made anew; then to rounding, whatever is stored."""
    own = model()
    rows = counted(monkeypatch, Radau)
    motion = moved(own, 201, "Radau")
    few = moved(own, 2, "Radau")
    np.testing.assert_array_equal(few[-1].x, motion[-1].x)
    assert sum(rows) > (1.0 if model is not thrown else 0.3) * motion.statistics["steps"]
    monkeypatch.setattr(Radau, "row", one_by_one)
    alone = moved(own, 201, "Radau")
    assert motion.statistics["steps"] == alone.statistics["steps"]
    assert motion.verdict == alone.verdict
    for t in np.linspace(0.0, SECONDS, 41).tolist():
        np.testing.assert_allclose(motion.at(t).x, alone.at(t).x, rtol=0, atol=1e-10)
        np.testing.assert_allclose(motion.at(t).v, alone.at(t).v, rtol=0, atol=1e-9)


def test_a_row_ends_where_a_motion_is_looked_at(monkeypatch: pytest.MonkeyPatch) -> None:
    """A look at every 50th step finds it, whatever the length of rows."""
    taken: list[int] = []
    own = Run.forward

    def forward(run: Run, most: int = 1) -> str | None:
        message = own(run, most)
        taken.append(run.taken)
        return message

    monkeypatch.setattr(Run, "forward", forward)
    assert not any(steps % LOOK_EVERY for steps in (FIRST, WINDOW, LOOK // 2))
    steps = moved(double_pendulum(), 2).statistics["steps"]
    assert set(range(LOOK_EVERY, steps, LOOK_EVERY)) <= set(taken)


def test_there_is_room_for_one_step_of_a_large_model(monkeypatch: pytest.MonkeyPatch) -> None:
    """Where a step needs all the room, rows have one step, and the motion is the same."""
    own = double_pendulum()
    motion = moved(own, 201)
    for module in ("in_row", "dop853_row"):
        monkeypatch.setattr(f"flexel.integration.{module}.ROOM", 1)
    rows = counted(monkeypatch)
    small = moved(own, 201)
    assert max(rows) == 1
    np.testing.assert_array_equal(small.at(SECONDS).x, motion.at(SECONDS).x)
    assert small.statistics == motion.statistics
