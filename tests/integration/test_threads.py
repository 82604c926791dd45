"""One system in many threads: every digit is that of computing one thing after another."""

import sys
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from threading import Barrier

import numpy as np
import pytest
from longer import longer
from mechanisms import slider_crank
from wheels import MAGIC, MAGIC_ON, H, K, wheel

import flexel as fx
from flexel.examples.bicycle import bicycle, kick
from flexel.examples.vehicle import vehicle
from flexel.examples.vehicle_runs import rounded_ramp

pytestmark = pytest.mark.filterwarnings(
    "ignore::flexel.base.errors.UnsteadyWarning"
)  # digits are compared, no modes
THREADS = 8
Task = Callable[[fx.System], bytes]


@pytest.fixture(autouse=True)
def impatient() -> Iterator[None]:
    """Threads that take turns often."""
    usual = sys.getswitchinterval()
    sys.setswitchinterval(1e-5)
    yield
    sys.setswitchinterval(usual)


def rolling() -> fx.System:
    """The bicycle, with rolling conditions."""
    return bicycle()


def turning() -> fx.System:
    """A slider-crank mechanism whose degree of freedom is changed at its dead centres."""
    return slider_crank("B.x").build()


def hanging() -> fx.System:
    """A rope of three cables, released from the horizontal."""
    m = fx.Model(gravity=(0, 0, -9.81))
    for i in range(4):
        m.point(f"P{i}", (0.5 * i, 0, 0), fixed=i == 0)
        m.slope(f"S{i}", (1, 0, 0))
    for i in range(3):
        ends = f"P{i}", f"S{i}", f"P{i + 1}", f"S{i + 1}"
        m.cable(f"c{i}", *ends, EA=500.0, EI=2.0, mass_per_length=0.5, damping=0.01, bending_damping=0.01)
    return m.build()


def steered() -> fx.System:
    """A vehicle with a driven rack."""
    return vehicle(20.0, rack=rounded_ramp())


def slipping() -> fx.System:
    """A wheel that slips; the slips of its tyre lag, and are internal states of its law."""
    m = wheel(z=H)
    m.attach("magic_formula", MAGIC_ON, name="rubber", stiffness=K, damping=0.0, **MAGIC)
    for name, rate in (("hub.x", 10.0), ("hub.y", 0.5)):
        m.initial(name, rate=rate)
    return m.build()


SYSTEMS = {model.__name__: model for model in (rolling, turning, hanging, steered, slipping)}
START = {"rolling": lambda s: kick(s, 4.5, 0.05)[0]}
DURATION = {"rolling": 0.3, "turning": 0.4, "hanging": 0.05, "steered": 0.1, "slipping": 0.1}


def digits(state: fx.State) -> bytes:
    """All numbers of a state."""
    arrays = state.x, state.v, state.a, state.e, state.z, state.zd, state.stresses, state.reactions
    return b"".join(array.tobytes() for array in arrays)


def simulated(name: str, method: str) -> Task:
    """The states of a motion."""

    def run(system: fx.System) -> bytes:
        start = START[name](system) if name in START else None
        motion = system.simulate(DURATION[name], start=start, samples=4, method=method, progress=False)
        between = digits(motion.at(0.37 * motion.t[-1])) if motion.dense else b""
        return b"".join(map(digits, motion)) + between

    return run


def linearized(system: fx.System) -> bytes:
    """The matrices of a linearization, and eigenvalues."""
    lin = system.linearize()
    arrays = lin.M, lin.C, lin.K, lin.A_k, lin.B_k, lin.Z, lin.Z_v, lin.Z_q, lin.Z_z, lin.eigenvalues()
    return b"".join(array.tobytes() for array in arrays)


def evaluated(system: fx.System) -> bytes:
    """A right-hand side that starts from the initial state."""
    start = system.initial
    system.warm(start)
    return system.rhs(start.t, np.concatenate([start.q, start.qd, start.z])).tobytes()


METHODS = ["DOP853", "generalized-alpha"]


@pytest.mark.parametrize("name", longer(SYSTEMS, "turning", "hanging", "steered"))
def test_threads_compute_the_same_digits_as_one_after_another(name: str) -> None:
    """Each thread has another order of tasks; the system, its tables included, is new to all of them."""
    tasks = {method: simulated(name, method) for method in METHODS} | {
        "linearize": linearized,
        "rhs": evaluated,
    }
    alone = SYSTEMS[name]()
    expected = {key: task(alone) for key, task in tasks.items()}
    system, begin, keys = SYSTEMS[name](), Barrier(THREADS), list(tasks)

    def work(number: int) -> dict[str, bytes]:
        begin.wait()
        own = keys[number % len(keys) :] + keys[: number % len(keys)]
        return {key: tasks[key](system) for key in own}

    with ThreadPoolExecutor(THREADS) as pool:
        found = list(pool.map(work, range(THREADS)))
    wrong = {(i, key) for i, results in enumerate(found) for key in keys if results[key] != expected[key]}
    assert wrong == set()


@pytest.mark.parametrize("name", SYSTEMS)
def test_what_was_computed_before_changes_no_digit(name: str) -> None:
    tasks = {method: simulated(name, method) for method in METHODS} | {
        "linearize": linearized,
        "rhs": evaluated,
    }
    system, keys = SYSTEMS[name](), list(tasks)
    first = {key: tasks[key](system) for key in keys}
    again = {key: tasks[key](system) for key in keys[::-1]}
    assert {key for key in keys if first[key] != again[key]} == set()


def test_400_linearizations_from_threads_are_one() -> None:
    system, alone = vehicle(20.0), linearized(vehicle(20.0))
    with ThreadPoolExecutor(THREADS) as pool:
        assert set(pool.map(lambda _: linearized(system), range(400))) == {alone}
