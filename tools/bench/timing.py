"""Times a row: thread CPU time of many runs, and the accuracy of the computed result."""

from __future__ import annotations

import statistics
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from math import ceil
from typing import Any

import numpy as np

BUDGET = 3.0  # time to spend on a work [s]; work that takes longer is run twice
BATCH = 1e-3  # shortest time between two readings of the clock, which takes about 0.3 µs [s]
FEWEST, MOST = 5, 2000  # readings


@dataclass(frozen=True)
class Work:
    """The timed work of a row.

    Attributes
    ----------
    run : function
        The work, once.
    error : function, optional
        Accuracy of the result of a run, against a reference.
    count : int
        Number of items in one run, such as evaluations: the time is divided by it.
    idle : function, optional
        An empty run, whose time is subtracted.
    clock : function
        Clock of CPU time [s].
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

    The first run, made here, also gives the accuracy. Its time counts only if the work takes longer than the
    budget; shorter work has then run once, and preparations at first use are not counted.
    """

    def __init__(self, work: Work, budget: float | None = None) -> None:
        """Run the work once, and find how many readings to take; the budget [s] is `BUDGET` by default."""
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
        """Return the timing of the readings."""
        idle = 0.0
        if self.work.idle is not None:
            count, number = plan(self.work, self.work.idle, BUDGET)
            idle = min(reading(self.work, self.work.idle, number) for _ in range(count))
        shortest, median = (
            (seconds - idle) / self.work.count for seconds in (min(self.found), statistics.median(self.found))
        )
        return Timing(shortest, median, len(self.found), self.error)


def measure(series: Sequence[Series]) -> list[Timing]:
    """Read several works in turn, so that disturbances of the machine affect all of them.

    Works with fewer readings are read at even distances between those of the others.
    """
    rounds = max(item.count for item in series)
    for i in range(rounds):
        for item in series:
            if (i + 1) * item.count // rounds > i * item.count // rounds:
                item.read()
    return [item.timing() for item in series]


def plan(work: Work, run: Callable[[], Any], budget: float) -> tuple[int, int]:
    """Return how many readings fit in the budget, and the runs in each, so that reading the clock does not disturb."""
    once = min(reading(work, run, 1) for _ in range(2))
    number = max(1, ceil(BATCH / max(once, BATCH / 1e4)))
    return min(max(round(budget / max(once, BATCH)), FEWEST), MOST), number


def reading(work: Work, run: Callable[[], Any], number: int) -> float:
    """Return the seconds of one run, from `number` runs."""
    begin = work.clock()
    for _ in range(number):
        run()
    return (work.clock() - begin) / number


def yardstick() -> Timing:
    """Time LU factorization and solution of a 40 x 40 system in NumPy: a fixed unit of work."""
    A = np.random.default_rng(1).normal(size=(40, 40)) + 40 * np.eye(40)
    b = np.ones(40)
    return measure([Series(Work(lambda: np.linalg.solve(A, b)))])[0]
