"""Ropes of spatial cables: implicit steps with full and modified Newton iteration, a rope on a
sheave, and how they grow with the rope.
"""

from collections.abc import Callable
from functools import partial

from timing import Row, best

import flexel as fx
from flexel.examples.rope_models import atwood

H = 1e-3  # step [s]


def rope(n: int, element: float = 0.1) -> fx.System:
    """A rope of n cables, held at one end and released from the horizontal."""
    m = fx.Model(gravity=(0, 0, -9.81))
    for i in range(n + 1):
        m.point(f"p{i}", (element * i, 0, 0), fixed=i == 0)
        m.slope(f"d{i}", (1, 0, 0))
    for i in range(n):
        ends = (f"p{i}", f"d{i}", f"p{i + 1}", f"d{i + 1}")
        m.cable(f"c{i}", *ends, EA=1e6, EI=50.0, mass_per_length=1.0)
    return m.build()


def moved(system: fx.System, duration: float, newton: str = "full") -> Callable[[], object]:
    """Work that integrates a motion."""
    return lambda: system.simulate(
        duration, method="generalized-alpha", step=H, samples=2, newton=newton, progress=False
    )


def fall(machine: fx.System) -> object:
    """One second of Atwood's machine in some 240 steps, with the fall of 2000 steps to 1e-5."""
    return machine.simulate(1.0, method="generalized-alpha", rtol=5e-3, samples=11, progress=False)


def measure() -> list[Row]:
    """The figures of this file."""
    system = rope(56)
    rows = [
        Row(f"rope of 56 cables, 1 s, h = 1 ms, {z} Newton", best(moved(system, 1.0, z), repeat=2), 1.5, 0.35)
        for z in ("full", "modified")
    ]
    machine, _ = atwood(56, 2.5, 2.0, inertia=0.02, mass=1.0, stiffness=1e8)
    rows.append(
        Row(
            "rope over a sheave, 56 cables of 5 points, 1 s", best(partial(fall, machine), repeat=2), 1.4, 0.5
        )
    )
    for n in (125, 500, 2000):
        rows.append(Row(f"rope of {n} cables: build", best(partial(rope, n), repeat=1)))
        seconds = best(moved(rope(n), 20 * H), repeat=2)
        rows.append(Row(f"rope of {n} cables: a step, per cable", seconds / 20 / n))
    return rows
