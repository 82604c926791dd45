"""Functions for tests of sweeps, in a module of their own: workers find them by name.

Annotations are not evaluated: a worker that needs no model does not import it.
"""

from __future__ import annotations

import os
import signal
import time
from typing import Any

import numpy as np

import flexel as fx


def pendulum(length: float = 0.5, mass: float = 2.0) -> fx.Model:
    """A rod that hangs from a hinge."""
    m = fx.Model(gravity=(0, 0, -9.81))
    m.frame("ground", fixed=True)
    m.frame("rod")
    m.point("pivot", (0, 0, 0), fixed=True)
    m.hinge("hinge", "ground", "rod", axis=(0, 1, 0))
    across = mass * length**2 / 12
    m.body("body", "pivot", "rod", mass=mass, inertia=(across, across, 1e-6), offset=(0, 0, -length / 2))
    return m


def swing(system: fx.System) -> dict[str, Any]:
    """Frequency at rest, and where the rod is during a second."""
    motion = system.simulate(1.0, start=system.state_at({"hinge.angle": 0.3}), samples=5)
    eigenvalues = system.linearize().eigenvalues()
    return {
        "omega": float(abs(eigenvalues.imag).max()),
        "angle": motion["hinge.angle"],
        "eigenvalues": eigenvalues,
    }


def plain(a: float, b: float = 1.0) -> dict[str, float]:
    """No model: a sweep passes it on."""
    return {"a": a, "b": b}


def numbers(point: dict[str, float]) -> dict[str, Any]:
    """A number and an array, without any work."""
    return {"sum": point["a"] + point["b"], "powers": np.array([point["a"] ** i for i in range(3)])}


def slow(point: dict[str, float]) -> dict[str, Any]:
    """The same, after some milliseconds."""
    time.sleep(0.02)
    return numbers(point)


def deadly(a: float, b: float = 1.0) -> dict[str, float]:
    """Kills its process where a is 3."""
    if a == 3.0:
        os.kill(os.getpid(), signal.SIGKILL)
    return {"a": a, "b": b}


def lethal(a: float) -> dict[str, float]:
    """Kills its process everywhere."""
    os.kill(os.getpid(), signal.SIGKILL)
    return {"a": a}


def picky(a: float, b: float = 1.0) -> dict[str, float]:
    """Refuses negative values."""
    if a < 0:
        raise ValueError(f"no {a}")
    return {"a": a, "b": b}
