"""Implicit integration of stiff models: steps, their control, the energy ledger, and what is kept."""

from __future__ import annotations

import sys
from dataclasses import dataclass

import numpy as np
from tqdm import tqdm

from flexel.base.arrays import Array
from flexel.integration.alpha import Point, Stepper
from flexel.integration.explicit import Integration
from flexel.integration.ledger import Ledger
from flexel.mechanics.balance import Balance, Saddle
from flexel.mechanics.core import Core
from flexel.structure.state import State

SHORTEST = 1e-10  # of the duration
DEEP = 0.1  # of a new contact's penetration: a larger local error halves the step
STEADY = 1.3  # growth of the step below which it stays as it is: every change disturbs the multipliers
MOST_FALSE, MOST_HALVINGS = 8, 4  # on account of solutions with energy from nowhere, and of new contacts


@dataclass(frozen=True)
class Control:
    """How the steps are chosen.

    Attributes
    ----------
    tolerance : float
        Local error of the coordinates in their natural scales; infinite for steps of constant length.
    first, longest : float
        Steps [s].
    """

    tolerance: float
    first: float
    longest: float


class Run:
    """An implicit integration over given times: progress, what is kept, and how it ends.

    Attributes
    ----------
    states : list of State
    ledger : Ledger
    point : Point
        Where it stands.
    """

    def __init__(self, saddle: Saddle, start: State) -> None:
        self.saddle = saddle
        self.ledger = Ledger(saddle)
        self.states = [start]
        self.point = Point.at(start, saddle.multipliers(start))
        self.shortest = 0.0
        self._balance: Balance | None = None

    @property
    def statistics(self) -> dict[str, int]:
        """Counts of what was done."""
        raise NotImplementedError

    def advance(self, until: float) -> bool:
        """Take one step towards a time and `accept` it; False if that is not possible."""
        raise NotImplementedError

    def accept(self, point: Point, balance: Balance) -> None:
        """Go on from the end of a step."""
        h = point.t - self.point.t
        self.point, self._balance = point, balance
        self.ledger.add(balance, h)

    def run(self, times: Array, progress: bool | None) -> Integration:
        """Integrate over the stored times; an interrupt (Ctrl-C) or a step that fails keeps what was computed."""
        begin, span = self.point.t, float(times[-1] - times[0])
        self.shortest = SHORTEST * span
        message, complete = "reached the end", True
        self.ledger.begin(self.point)
        show = sys.stderr.isatty() if progress is None else progress
        bar = tqdm(total=span, disable=not show, unit="s", leave=False)
        bar.bar_format = "{l_bar}{bar}| {n:.3g}/{total:.3g} s [{elapsed}<{remaining}]"
        try:
            for t in times[1:]:
                while self.point.t < t and complete:
                    complete = self.advance(float(t))
                    bar.update(self.point.t - begin - float(bar.n))
                self._keep()
                if not complete:
                    message = self._failure()
                    break
        except KeyboardInterrupt:
            self._keep()
            message = f"interrupted at t = {self.states[-1].t:g} s; the motion up to there is kept"
        finally:
            bar.close()
        return Integration(self.states, [], [], self.statistics, message, self.ledger.kept, complete)

    def kept(self, message: str) -> Integration:
        """What has been computed, up to the last step, where an error ends the motion."""
        self._keep()
        return Integration(self.states, [], [], self.statistics, message, self.ledger.kept, False)

    def _keep(self) -> None:
        """Store the present state, if it is a new one."""
        if self._balance is not None and self.point.t > self.states[-1].t:
            self.states.append(self.saddle.state(self._balance))
            self.ledger.keep()

    def _failure(self) -> str:
        return (
            f"implicit integration cannot go on at t = {self.point.t:g} s (step below {self.shortest:.2g} s): the "
            "motion is not smooth there, or a condition cannot be met; look at the last state of the motion, and start "
            "from there again after a change"
        )


class GeneralizedAlpha(Run):
    """One run of the generalized-alpha method."""

    def __init__(self, system: Core, start: State, radius: float, newton: str, control: Control) -> None:
        self.stepper = Stepper(system, radius, newton, tolerance=control.tolerance)
        super().__init__(self.stepper, start)
        self.control = control
        self._steps = self._rejected = self._at_contact = self._halvings = self._false = 0
        self._wish = min(control.first, control.longest)

    @property
    def statistics(self) -> dict[str, int]:
        """Counts of what was done."""
        s = self.stepper
        return {
            "steps": self._steps,
            "rejected": self._rejected,
            "halved at contact": self._at_contact,
            "evaluations": s.evaluations,
            "iterations": s.iterations,
            "factorizations": s.factorizations,
            "rechoices": 0,
        }

    def advance(self, until: float) -> bool:
        """One accepted step; False if even the shortest does not converge."""
        old, gap = self.point, until - self.point.t
        parts = max(float(np.ceil(gap / min(self._wish, self.control.longest) * (1 - 1e-9))), 1.0)
        step = asked = gap / parts
        while True:
            found = self.stepper.solve(old, step)
            error = np.inf if found is None else self._error(old, *found, step)
            if found is not None and error <= 1.0:
                break
            self._rejected += 1
            step *= 0.5 if np.isinf(error) else max(0.2, 0.9 * error ** (-1 / 3))
            if step < self.shortest:
                return False
        point, balance = found
        self._steps += 1
        growth = min(2.0, 0.9 * max(error, 1e-6) ** (-1 / 3))
        allowed = step * (1.0 if 1.0 < growth < STEADY else growth)
        self._wish = max(allowed, self._wish) if step == asked else allowed
        if step == asked:
            self._halvings, self._false = max(self._halvings - 1, 0), max(self._false - 1, 0)
        if abs(point.t - until) < 1e-6 * step:
            point.t = until
        self.accept(point, balance)
        return True

    def _error(self, old: Point, new: Point, b: Balance, h: float) -> float:
        """Local error over the tolerance; infinite for a false solution, and where a contact has begun too deeply."""
        stepper = self.stepper
        if self._false < MOST_FALSE and self.ledger.conjured(b, h):
            self._false += 1
            return np.inf
        error = stepper.error_of(old, new, h)
        if self._halvings < MOST_HALVINGS:
            begun = self.ledger.new_penetration(b)
            if begun and float(np.abs(error).max(initial=0.0)) > DEEP * begun:
                self._halvings += 1
                self._at_contact += 1
                return np.inf
        return float(np.abs(error / stepper.x_scale).max(initial=0.0)) / self.control.tolerance
