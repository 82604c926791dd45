"""Motions of the bicycle to be saved, for tests."""

from typing import Any

import numpy as np

import flexel as fx
from flexel.examples.bicycle import bicycle, kick

SUFFIXES = [".npz", ".nc", ".mat", ".csv"]
ARRAYS = ("x", "v", "a", "e", "J", "stresses", "reactions", "z", "zd", "Phi_v")


def ride(duration: float, samples: int, **options: Any) -> fx.Motion:
    """A bicycle with rolling wheels at 4.5 m/s after a kick."""
    system = bicycle()
    return system.simulate(duration, start=kick(system, 4.5, 0.05)[0], samples=samples, **options)


def same(a: fx.State, b: fx.State) -> bool:
    """Whether two states are equal, bit for bit."""
    equal = all(np.array_equal(getattr(a, name), getattr(b, name)) for name in ARRAYS)
    return equal and (a.t, a.energy, a.drift, a.dissipated) == (b.t, b.energy, b.drift, b.dissipated)
