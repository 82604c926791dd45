"""No memory is lost: evaluations, steps and builds without end use the memory of the first ones again."""

import gc
import sys
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest
from memory import memory_in_use
from wheels import MAGIC, MAGIC_ON, H, K, wheel

import flexel as fx
from flexel.examples.bicycle import bicycle

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="asks glibc")
EVALUATIONS, BUILDS = 100_000, 1000
SLACK = 0.1  # MB, of caches that grow a little


def pendulum(mass: float) -> fx.System:
    """A double pendulum, of rods with other masses each time."""
    m = fx.Model(gravity=(0, -9.81))
    last = m.point("O", (0, 0), fixed=True)
    for i in range(2):
        end = m.point(f"P{i}", (0.5 * (i + 1), 0.0))
        m.beam(f"b{i}", last, m.angle(f"R{i}"), end, mass_per_length=mass)
        last = end
    return m.build()


def tyred() -> fx.System:
    """A wheel whose tyre has internal states."""
    m = wheel(z=H)
    m.attach("magic_formula", MAGIC_ON, name="rubber", stiffness=K, damping=0.0, **MAGIC)
    m.initial("hub.x", rate=10.0)
    return m.build()


@pytest.mark.parametrize("make", [bicycle, tyred])
@pytest.mark.long
def test_100_000_evaluations_lose_nothing(make: Callable[[], fx.System]) -> None:
    """Positions, velocities and accelerations; a leak of one number each would be 0.8 MB."""
    system = make()
    start = system.initial
    y = np.concatenate([start.q, start.qd, start.z])

    def evaluate(count: int) -> float:
        for i in range(count):
            system.rhs(start.t + 1e-9 * i, y)
        return memory_in_use()

    before = evaluate(EVALUATIONS // 20)
    assert evaluate(EVALUATIONS) < before + SLACK / 2


@pytest.mark.parametrize("builds", [BUILDS // 4, pytest.param(BUILDS, marks=pytest.mark.campaign)])
@pytest.mark.long
def test_many_builds_lose_nothing(builds: int) -> None:
    """Models, tables, workspaces, factors and linearizations are all given back."""

    def build(count: int) -> float:
        for i in range(count):
            system = pendulum(1.0 + 1e-3 * i)
            system.rhs(0.0, np.concatenate([system.initial.q, system.initial.qd]))
            if i % 50 == 0:
                system.linearize()
                gc.collect()  # systems have cycles
        return memory_in_use()

    before = build(builds // 5)
    assert build(builds) < before + 2 * SLACK * max(builds / BUILDS, 0.5)


def test_matrices_of_threads_are_given_back() -> None:
    """Each thread has a workspace with factors of its own, which end with it."""
    system = bicycle()
    y = np.concatenate([system.initial.q, system.initial.qd, system.initial.z])

    def threads(count: int) -> float:
        for _ in range(count):
            with ThreadPoolExecutor(4) as pool:
                list(pool.map(lambda _: system.rhs(0.0, y), range(8)))
        return memory_in_use()

    before = threads(25)
    assert threads(100) < before + SLACK
