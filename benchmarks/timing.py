"""How a row is timed: thread CPU time of many runs, and the accuracy of what was computed in them."""

from __future__ import annotations

import statistics
import time
from collections.abc import Callable
from dataclasses import dataclass
from math import ceil
from typing import Any

import numpy as np

BUDGET = 3.0  # time to spend on a row [s]; one that needs longer is run twice
BATCH = 1e-3  # shortest time between two readings of the clock, which takes some 0.3 µs itself [s]
FEWEST, MOST = 5, 2000  # readings


@dataclass(frozen=True)
class Work:
    """What a row times.

    Attributes
    ----------
    run : function
        The work, once.
    error : function, optional
        Accuracy of what a run returns, against a reference.
    count : int
        What one run contains, such as evaluations: the time is divided by it.
    idle : function, optional
        A run with nothing to do, whose time is subtracted.
    clock : function
        CPU time [s] of what runs.
    """

    run: Callable[[], Any]
    error: Callable[[Any], float] | None = None
    count: int = 1
    idle: Callable[[], Any] | None = None
    clock: Callable[[], float] = time.thread_time


@dataclass(frozen=True)
class Timing:
    """Shortest and median time [s] of `readings`, and the accuracy of the result (None: no reference)."""

    shortest: float
    median: float
    readings: int
    error: float | None


def measure(work: Work) -> Timing:
    """Time some work, as often as fits in the budget.

    The first run also gives the accuracy. Its time counts only where the work needs longer than the budget; shorter
    work has run once, then, and what is set up at first use is not counted.
    """
    begin = work.clock()
    result = work.run()
    seconds = work.clock() - begin
    error = None if work.error is None else float(work.error(result))
    del result
    found = [seconds, *readings(work, work.run, 1, 1)] if seconds > BUDGET else repeated(work, work.run)
    idle = min(repeated(work, work.idle)) if work.idle is not None else 0.0
    shortest, median = (value - idle for value in (min(found), statistics.median(found)))
    return Timing(shortest / work.count, median / work.count, len(found), error)


def repeated(work: Work, run: Callable[[], Any]) -> list[float]:
    """Seconds of one run, read as often as fits in the budget, in batches that a reading does not disturb."""
    once = min(readings(work, run, 2, 1))
    number = max(1, ceil(BATCH / max(once, BATCH / 1e4)))
    return readings(work, run, min(max(round(BUDGET / max(once, BATCH)), FEWEST), MOST), number)


def readings(work: Work, run: Callable[[], Any], count: int, number: int) -> list[float]:
    """Seconds of one run, `count` times, each from `number` runs."""
    found = []
    for _ in range(count):
        begin = work.clock()
        for _ in range(number):
            run()
        found.append((work.clock() - begin) / number)
    return found


def yardstick() -> Timing:
    """LU factorization and solution of a 40 x 40 system in NumPy: a fixed piece of work to divide by."""
    A = np.random.default_rng(1).normal(size=(40, 40)) + 40 * np.eye(40)
    b = np.ones(40)
    return measure(Work(lambda: np.linalg.solve(A, b)))
