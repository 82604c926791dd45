"""How a row is timed: thread CPU time of many runs, and the accuracy of what was computed in them."""

from __future__ import annotations

import statistics
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from math import ceil
from typing import Any

import numpy as np

BUDGET = 3.0  # time to spend on a work [s]; one that needs longer is run twice
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


class Series:
    """The readings of some work, as many as fit in a budget.

    The first run, made here, also gives the accuracy. Its time counts only where the work needs longer than the
    budget; shorter work has run once, then, and what is set up at first use is not counted.
    """

    def __init__(self, work: Work, budget: float | None = None) -> None:
        """Run the work once, and find how often it is to be read; the budget [s] is `BUDGET` if it is not given."""
        budget = BUDGET if budget is None else budget
        self.work = work
        begin = work.clock()
        result = work.run()
        seconds = work.clock() - begin
        self.error = None if work.error is None else float(work.error(result))
        self.found = [seconds] if seconds > budget else []
        self.count, self.number = (1, 1) if self.found else plan(work, work.run, budget)

    def read(self) -> None:
        """Take one reading."""
        self.found.append(reading(self.work, self.work.run, self.number))

    def timing(self) -> Timing:
        """What the readings say."""
        idle = 0.0
        if self.work.idle is not None:
            count, number = plan(self.work, self.work.idle, BUDGET)
            idle = min(reading(self.work, self.work.idle, number) for _ in range(count))
        shortest, median = (
            (z - idle) / self.work.count for z in (min(self.found), statistics.median(self.found))
        )
        return Timing(shortest, median, len(self.found), self.error)


def measure(series: Sequence[Series]) -> list[Timing]:
    """Read several works in turn, so that what disturbs the machine disturbs all of them.

    Works with fewer readings are read at even distances between those of the others.
    """
    rounds = max(z.count for z in series)
    for i in range(rounds):
        for z in series:
            if (i + 1) * z.count // rounds > i * z.count // rounds:
                z.read()
    return [z.timing() for z in series]


def plan(work: Work, run: Callable[[], Any], budget: float) -> tuple[int, int]:
    """How many readings fit in the budget, and of how many runs each, so that reading the clock does not disturb."""
    once = min(reading(work, run, 1) for _ in range(2))
    number = max(1, ceil(BATCH / max(once, BATCH / 1e4)))
    return min(max(round(budget / max(once, BATCH)), FEWEST), MOST), number


def reading(work: Work, run: Callable[[], Any], number: int) -> float:
    """Seconds of one run, from `number` runs."""
    begin = work.clock()
    for _ in range(number):
        run()
    return (work.clock() - begin) / number


def yardstick() -> Timing:
    """LU factorization and solution of a 40 x 40 system in NumPy: a fixed piece of work to divide by."""
    A = np.random.default_rng(1).normal(size=(40, 40)) + 40 * np.eye(40)
    b = np.ones(40)
    return measure([Series(Work(lambda: np.linalg.solve(A, b)))])[0]
