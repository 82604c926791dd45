"""Controlled mechanisms, and independent solutions of sampled loops, for tests."""

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import expm

import flexel as fx

Array = NDArray[np.float64]
MASS = 2.0


def carriage() -> fx.Model:
    """A mass of 2 kg on a straight guide, drawn at 0.5 m: a double integrator."""
    m = fx.Model()
    m.point("A", (0.5, 0))
    m.fix("A.y")
    m.point_mass("body", "A", MASS)
    m.independent("A.x")
    return m


def cart() -> fx.Model:
    """A cart of 3 kg with a rod of 1 kg and 1 m that stands on it."""
    m = fx.Model(gravity=(0, -9.81))
    m.point("cart", (0, 0))
    m.fix("cart.y")
    m.point("top", (0, 1))
    m.angle("ground", fixed=True)
    m.angle("rod")
    m.hinge("pivot", "ground", "rod")
    m.beam("pole", "cart", "rod", "top", mass_per_length=1)
    m.point_mass("cart mass", "cart", 3.0)
    m.independent("cart.x", "pivot.angle")
    return m


def spring_law(t: float, y: Array) -> Any:
    """A proportional-derivative controller of the carriage, towards 0.2 m."""
    return -30 * (y[0] - 0.2) - 8 * y[1]


def lagging(t: float, y: Array, x: Array) -> tuple[Any, Any]:
    """A controller with a state of its own: the last position takes the place of the rate."""
    return -30 * (y[0] - 0.2) - 80 * (y[0] - x[0]), y[:1]


def held_response(
    law: Callable[[float, Array], float], period: float, delay: float, end: float, start: Array
) -> tuple[Array, Array, Array]:
    """Times, states (nt, 2) and forces (nt,) of the carriage at all instants: a matrix exponential for each interval.

    A force in the list becomes valid when its time has come; nothing here is flexel's.
    """
    M = np.zeros((3, 3))
    M[0, 1], M[1, 2] = 1.0, 1 / MASS
    count = int(round(end / period)) + 1
    instants = {round(i * period, 12): True for i in range(count)}
    changes = {round(i * period + delay, 12): False for i in range(count)}
    moments = [moment for moment in sorted(changes | instants) if moment <= end + 1e-12]
    x, u = np.array(start, dtype=float), 0.0
    coming: list[tuple[float, float]] = []
    times, states, forces = [0.0], [x], [u]
    for a, b in zip(moments[:-1], moments[1:], strict=True):
        if a in instants:
            coming.append((round(a + delay, 12), law(a, x)))
        while coming and coming[0][0] <= a + 1e-12:
            u = coming.pop(0)[1]
        x = (expm(M * (b - a)) @ np.array([*x, u]))[:2]
        times.append(b)
        states.append(x)
        forces.append(u)
    return np.array(times), np.array(states), np.array(forces)
