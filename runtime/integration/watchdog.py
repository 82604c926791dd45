"""The watchdog of every motion: it ends one that has slowed down so much that it would not reach its end."""

from __future__ import annotations

from typing import Protocol

import numpy as np

from flexel.base.arrays import Array
from flexel.base.errors import DynamicsError
from flexel.model.snapshot import Snapshot
from flexel.model.structure import Structure

FIRST = 50  # steps from which the first pace is taken
WINDOW = 1000  # steps between two looks
WINDOWS = 5  # looks in a row that must find the same, where the degrees of freedom change
MORE = 30  # and where they do not: later steps of DOP853 are up to 1.6 times as many, since errors are shared
SLOWER = 10.0  # times, relative to the best pace so far: stiff models and long motions keep their pace
STEPS = 1e8  # that the rest of a motion may take
CHANGES = 3e5  # of the degrees of freedom that it may take


class Watched(Protocol):
    """What it observes of a motion, named as in `Run`."""

    times: Array
    taken: int

    @property
    def t(self) -> float:
        """Current time [s]."""

    @property
    def statistics(self) -> dict[str, int]:
        """Counts of operations."""

    @property
    def instant(self) -> tuple[Snapshot, Array]:
        """Coordinates and rates at the current time, and internal states."""


class Watchdog:
    """Compares the progress of a motion with its steps and its changes of the degrees of freedom.

    A motion that has slowed down for a moment, as at an impact, is not stopped: the slow pace must last for some
    thousand steps.

    Parameters
    ----------
    structure : Structure
        For the names in its error.
    """

    def __init__(self, structure: Structure) -> None:
        self._structure = structure
        self._slow = 0
        self._next = FIRST
        self._t: list[float] = []  # at the looks
        self._taken: list[int] = []
        self._changes: list[int] = []
        self._best = 0.0  # progress in a step [s]

    def look(self, run: Watched) -> None:
        """Look at a motion if it has taken enough steps since the last look.

        Raises
        ------
        DynamicsError
            If the rest of the motion would take too many steps or changes; says what moves fastest.
        """
        if run.taken < self._next:
            return
        self._next = run.taken + WINDOW
        self._t.append(run.t)
        self._taken.append(run.taken)
        self._changes.append(run.statistics.get("rechoices", 0))
        if len(self._t) == 1:
            self._best = (run.t - float(run.times[0])) / run.taken
        else:
            self._judge(run)

    def _judge(self, run: Watched) -> None:
        pace = (self._t[-1] - self._t[-2]) / (self._taken[-1] - self._taken[-2])
        slow = pace * SLOWER < self._best
        self._best = max(self._best, pace)
        self._slow = self._slow + 1 if slow else 0
        for looks in (WINDOWS, MORE):
            if self._slow < looks:
                return
            changes = self._changes[-1] - self._changes[-1 - looks]
            count = self._taken[-1] - self._taken[-1 - looks]
            covered = self._t[-1] - self._t[-1 - looks]
            rest = (float(run.times[-1]) - run.t) / covered
            if rest * changes > CHANGES or (looks == MORE and rest * count > STEPS):
                raise self._stopped(run, count, covered, changes, rest)

    def _stopped(self, run: Watched, count: int, covered: float, changes: int, rest: float) -> DynamicsError:
        """Return the error of a motion that is not continued."""
        at, s = run.instant[0], self._structure
        i = int(np.argmax(np.abs(at.v)))
        changed = f" and {changes} changes of the degrees of freedom" if changes else ""
        also = f" and {rest * changes:.1g} changes" if changes else ""
        error = DynamicsError(
            f"the motion has all but stopped at t = {run.t:g} s: the last {count} steps{changed} cover "
            f"{covered:.2g} s, {count * self._best / covered:.2g} times less than at its best pace, and the rest would "
            f"take about {rest * count:.1g} steps{also}; '{s.names[s.m + s.k + i]}' moves fastest, by {at.v[i]:.3g} in "
            "a second. Look for what adds energy (feedback of the wrong sign, negative damping), or continue "
            "from the last state of error.motion in shorter parts"
        )
        error.add_note(f"the motion was computed up to t = {run.t:g} s")
        return error
