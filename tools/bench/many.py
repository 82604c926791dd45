"""Times many variants of the bicycle at once: manoeuvre M1, root loci."""

from __future__ import annotations

import time

import numpy as np

import flexel as fx
from bench.bicycle import SPEEDS, apart, exact
from bench.timing import Work
from flexel.base.arrays import Array, ComplexArray
from flexel.examples import bicycle_data as data
from flexel.examples.bicycle import bicycle, rolling
from flexel.examples.stable_speeds import LEAN_STEER

MASS = "frame and rider.mass"
THREADS = 2
VARIANTS = 1000
FEW = np.linspace(0.0, 10.0, 20)  # speeds of the loci of many bicycles [m/s]


def _masses(system: fx.System) -> Array:
    """Return masses of rear frame and rider [kg], the first ones those of the benchmark."""
    own = float(system.parameters[MASS][0])
    return own + np.linspace(0.0, 30.0, VARIANTS)


def _rolling(speeds: Array) -> dict[str, Array]:
    """Return rates of straight running at some speeds [m/s]."""
    still = np.zeros_like(speeds)
    return {"rear hub.x": speeds, "lean.angle": still, "steer.angle": still}


def manoeuvres() -> Work:
    """Time manoeuvre M1 of 1000 bicycles with other riders, 5 s each, in two threads; wall time."""
    system = bicycle()
    start, masses = rolling(system, data.M1_SPEED, data.ROLL_RATE), _masses(system)

    def run() -> fx.Ensemble:
        return system.simulate_many(
            5.0,
            parameters={MASS: masses},
            start=start,
            outputs=["steer.angle"],
            samples=2,
            threads=THREADS,
            method="DOP853",
            rtol=1e-7,
            atol=1e-9,
        )

    def error(found: fx.Ensemble) -> float:
        return abs(float(found["steer.angle"][0, -1]) - data.M1_STEER_5S)

    return Work(run, error, clock=time.perf_counter)


def loci() -> Work:
    """Time steady motion, M, C, K and eigenvalues at 100 speeds, in one call."""
    system, rates = bicycle(), _rolling(SPEEDS)

    def run() -> ComplexArray:
        found = system.root_loci(rates=rates, of=LEAN_STEER, threads=1).linearizations.eigenvalues()
        return np.asarray(found[0])

    def error(found: ComplexArray) -> float:
        return max(apart(w, exact(float(v))) for w, v in zip(found, SPEEDS, strict=True))

    return Work(run, error)


def loci_of_many() -> Work:
    """Time the same at 20 speeds for 1000 bicycles with other riders, in two threads; wall time."""
    system, rates = bicycle(), _rolling(FEW)
    masses = _masses(system)

    def run() -> ComplexArray:
        found = system.root_loci(rates=rates, parameters={MASS: masses}, of=LEAN_STEER, threads=THREADS)
        return found.linearizations.eigenvalues()

    def error(found: ComplexArray) -> float:
        return max(apart(w, exact(float(v))) for w, v in zip(found[0], FEW, strict=True))

    return Work(run, error, clock=time.perf_counter)
