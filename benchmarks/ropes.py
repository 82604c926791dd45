"""Ropes of spatial cables by implicit steps: a falling rope, Atwood's machine, the hoist."""

from __future__ import annotations

import numpy as np

import flexel as fx
from flexel.base.arrays import Array
from flexel.benchmarks.timing import Work
from flexel.examples import hoist_model
from flexel.examples.hoist import balance_error, lift
from flexel.examples.rope_models import atwood

STEP = 1e-3  # of the falling rope [s]
FALL = 0.38048267  # of the mass A in 1 s, from 2000, 4000 and 8000 equal steps, extrapolated [m]

Run = tuple[fx.Motion, dict[str, Array]]


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


def cables() -> Work:
    """One second of a rope of 56 cables, full Newton iteration, with 101 states and the energy balance."""
    system = rope(56)

    def run() -> Run:
        motion = system.simulate(
            1.0, method="generalized-alpha", step=STEP, samples=101, newton="full", progress=False
        )
        return motion, motion.energy_balance()

    def error(found: Run) -> float:
        balance = found[1]
        return float(np.abs(balance["error"]).max() / balance["kinetic"].max())

    return Work(run, error)


def sheave() -> Work:
    """One second of Atwood's machine, 56 cables with 5 points of contact each, in some 240 steps."""
    machine, _ = atwood(56, 2.5, 2.0, inertia=0.02, mass=1.0, EA=1e5, stiffness=1e8)

    def run() -> fx.Motion:
        return machine.simulate(1.0, method="generalized-alpha", rtol=5e-3, samples=11, progress=False)

    def error(motion: fx.Motion) -> float:
        y = motion["A.y"]
        return float(abs((y[0] - y[-1]) / FALL - 1))

    return Work(run, error)


def hoist() -> Work:
    """The 30 s of `flexel reproduce hoist`, from the laid rope on."""
    model = hoist_model.hoist()
    return Work(lambda: lift(model, model.data.end), balance_error)
