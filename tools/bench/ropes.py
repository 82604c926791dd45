"""Times ropes of spatial cables by implicit steps: a falling rope, Atwood's machine, the hoist."""

from __future__ import annotations

import numpy as np

import flexel as fx
from bench.timing import Work
from flexel.base.arrays import Array
from flexel.examples import hoist_model
from flexel.examples.hoist import LONG_STEP, balance_error, lift
from flexel.examples.hoist_data import LONG
from flexel.examples.rope_models import G, atwood, let_go

STEP = 1e-3  # of the falling ropes [s]
ELEMENT, EA, EI, MASS = 0.1, 1e6, 50.0, 1.0  # length of a cable [m], stiffness [N], [N m²], mass [kg/m]
PLACE = (
    1.52852,
    0.0,
    -5.358377,
)  # of the free end of 56 cables after 1 s, from steps of 200, 100 and 50 µs [m]
RELEASE = 0.05  # time before the fixed end affects the free end [s]
FALL = 0.38048267  # of the mass A in 1 s, from 2000, 4000 and 8000 equal steps, extrapolated [m]

Run = tuple[fx.Motion, dict[str, Array]]


def rope(n: int) -> fx.System:
    """Build a rope of n cables, held at one end and released from the horizontal."""
    return let_go(n, ELEMENT, EA=EA, EI=EI, mass=MASS)


def free_end(motion: fx.Motion, n: int) -> Array:
    """Return the position (3,) [m] of the last point of n cables when the motion ends."""
    return np.array([motion[f"p{n}.{axis}"][-1] for axis in "xyz"])


def place_error(place: Array) -> float:
    """Return the distance of the free end of 56 cables from its reference after 1 s, over the length of the rope."""
    return float(np.linalg.norm(place - PLACE) / (56 * ELEMENT))


def release_error(place: Array) -> float:
    """Return the error of the fall in `RELEASE`, in which the free end falls as without a rope."""
    return float(abs(2 * place[2] / (-G * RELEASE**2) - 1))


def cables() -> Work:
    """Time one second of a rope of 56 cables, full Newton iteration, with 101 states and the energy balance."""
    system = rope(56)

    def run() -> Run:
        motion = system.simulate(
            1.0, method="generalized-alpha", step=STEP, samples=101, newton="full", progress=False
        )
        return motion, motion.energy_balance()

    return Work(run, lambda found: place_error(free_end(found[0], 56)))


def release(n: int) -> Work:
    """Time the first 50 steps of a rope of n cables."""
    system = rope(n)

    def run() -> fx.Motion:
        return system.simulate(RELEASE, method="generalized-alpha", step=STEP, samples=2, progress=False)

    return Work(run, lambda motion: release_error(free_end(motion, n)))


def sheave() -> Work:
    """Time one second of Atwood's machine, 56 cables with 5 points of contact each, in about 240 steps."""
    machine, _ = atwood(56, 2.5, 2.0, inertia=0.02, mass=1.0, EA=1e5, stiffness=1e8)

    def run() -> fx.Motion:
        return machine.simulate(1.0, method="generalized-alpha", rtol=5e-3, samples=11, progress=False)

    def error(motion: fx.Motion) -> float:
        y = motion["A.y"]
        return float(abs((y[0] - y[-1]) / FALL - 1))

    return Work(run, error)


def hoist() -> Work:
    """Time the 30 s variant of `flexel reproduce hoist`, starting with the laid rope."""
    model = hoist_model.hoist(LONG)
    return Work(lambda: lift(model, model.data.end, LONG_STEP), balance_error)
