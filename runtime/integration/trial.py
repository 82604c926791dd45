"""Some steps of a motion, to estimate the cost of all of it; the motion can then go on from there."""

from __future__ import annotations

from bisect import bisect_right
from typing import NamedTuple

import numpy as np

from flexel.base.errors import FlexelError
from flexel.engine.covered import FULL
from flexel.integration.minimal import MinimalRun

ROW = 10  # steps at most between two entries
STEPS = 60  # of a trial at least
LATER = 30  # of one with the tolerances of later steps
LAST, SHARE = 20, 0.1  # least number of steps that are taken as typical, and their share of a trial
TYPICAL = (7 / 8) ** 8  # of all steps: there the length of steps that shrink as n^(-1/8) has its mean
FALLS = 0.8  # of the estimate as the trial is twice as long, below which the motion begins with a transient


class Budget(NamedTuple):
    """Evaluations that a trial takes in any case, and the most of them while a transient dies out."""

    least: float
    most: float


class Trial:
    """A motion as it begins.

    Parameters
    ----------
    run : MinimalRun
        That has not begun.
    """

    def __init__(self, run: MinimalRun) -> None:
        self.run, self._end = run, float(run.times[-1])
        self._taken, self._times, self._counts = [0], [run.t], [0]
        run.once()

    @property
    def ended(self) -> bool:
        """Whether the motion is at its end."""
        return self.run.at_end

    @property
    def count(self) -> int:
        """Evaluations so far."""
        return self._counts[-1]

    @property
    def taken(self) -> int:
        """Steps so far."""
        return self._taken[-1]

    def go_on(self, steps: int, evaluations: float = 0.0) -> None:
        """Go on until it has taken so many steps and evaluations, or has ended."""
        while not self.ended and (self.taken < steps or self.count < evaluations):
            before = self.run.taken
            self.run.watched(min(ROW, steps - self.taken) if self.taken < steps else ROW)
            self._taken.append(self.taken + self.run.taken - before)
            self._times.append(self.run.t)
            self._counts.append(self.run.statistics["evaluations"])

    @property
    def steps(self) -> float:
        """Steps of the whole motion if it goes on as in the last ones."""
        return self.taken + self._left

    def evaluations(self, more: float = 0.0) -> float:
        """Estimate the evaluations of the whole motion, each step of which costs `more` than it evaluates."""
        if self.ended:
            return self.count + self.taken * more
        each = (self.count - self._counts[self._since]) / (self.taken - self._taken[self._since])
        return self.count + self._left * each + self.steps * more

    @property
    def evenly(self) -> float:
        """The same for a motion that is under way: all of its steps are typical."""
        begin = self._times[0]
        return self.count * (1.0 if self.ended else (self._end - begin) / (self.run.t - begin))

    @property
    def _left(self) -> float:
        """Steps up to the end."""
        if self.ended:
            return 0.0
        since = self._since
        steps, time = self.taken - self._taken[since], self.run.t - self._times[since]
        return float(steps * (self._end - self.run.t) / time)

    @property
    def _since(self) -> int:
        """Number of the entry from which on steps are taken as typical."""
        typical = min(max(LAST, int(SHARE * self.taken)), self.taken)
        return max(bisect_right(self._taken, self.taken - typical) - 1, 0)


def explicit_evaluations(run: MinimalRun) -> float:
    """Estimate the evaluations of a motion by DOP853, whose tolerances are smaller for later steps; see `Covered`.

    Infinite where the trial fails.

    Parameters
    ----------
    run : MinimalRun
        That has not begun; it can go on afterwards.
    """
    try:
        trial = Trial(run)
        trial.go_on(STEPS)
        later = TYPICAL * trial.steps
        if trial.ended or later <= FULL:
            return trial.evaluations()
        ahead = Trial(run.as_after(later))
        ahead.go_on(LATER)
        return trial.count + ahead.evenly
    except FlexelError:
        return np.inf


def implicit_evaluations(run: MinimalRun, more: float, budget: Budget, wanted: float) -> float:
    """Estimate the same for an implicit method.

    Parameters
    ----------
    run : MinimalRun
        That has not begun; it can go on afterwards.
    more : float
        Evaluations that cost as much as the linear algebra of a step.
    budget : Budget
    wanted : float
        Evaluations that the motion may take: with fewer a transient need not be waited for.
    """
    try:
        trial = Trial(run)
        trial.go_on(STEPS // 2, budget.least / 2)
        before = trial.evaluations(more)
        trial.go_on(STEPS, budget.least)
        found = trial.evaluations(more)
        while wanted <= found < FALLS * before and trial.count < budget.most and not trial.ended:
            trial.go_on(0, min(2 * trial.count, budget.most))
            before, found = found, trial.evaluations(more)
        return found
    except FlexelError:
        return np.inf
