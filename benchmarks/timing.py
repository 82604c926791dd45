"""What all benchmarks share: the best time of several, and a row of the table.

Times depend on the machine and on what else it does; `yardstick` is a fixed piece of NumPy work to divide by, so that
figures of different days can be compared as ratios.
"""

import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np


@dataclass(frozen=True)
class Row:
    """A figure: seconds measured, the figure to reach, and the one to aim at (None: no budget)."""

    name: str
    seconds: float
    reach: float | None = None
    aim: float | None = None


def best(work: Callable[[], Any], repeat: int = 5, number: int = 1) -> float:
    """Shortest time [s] of one call, among `repeat` runs of `number` calls."""
    work()
    found = []
    for _ in range(repeat):
        start = time.perf_counter()
        for _ in range(number):
            work()
        found.append((time.perf_counter() - start) / number)
    return min(found)


def yardstick() -> float:
    """Seconds for the LU factorization and solution of a 40 x 40 system in NumPy."""
    A = np.random.default_rng(1).normal(size=(40, 40)) + 40 * np.eye(40)
    b = np.ones(40)
    return best(lambda: np.linalg.solve(A, b), repeat=7, number=300)
