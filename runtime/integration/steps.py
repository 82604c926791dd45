"""Implicit integration of stiff models: step control and energy ledger."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from flexel.base.arrays import Array
from flexel.base.errors import DynamicsError
from flexel.integration.alpha import Stepper
from flexel.integration.driver import Run
from flexel.integration.ledger import Ledger
from flexel.integration.scheme import Point
from flexel.mechanics.balance import Balance, Saddle
from flexel.mechanics.core import Core
from flexel.structure.state import State

SHORTEST = 1e-10  # shortest step, over the duration
DEEP = 0.1  # local error over a new contact's penetration above which the step is halved
STEADY = 1.3  # growth factor below which the step is kept: every change disturbs the multipliers
MOST_FALSE, MOST_HALVINGS = 8, 4  # step halvings because of spurious energy, and because of new contacts


@dataclass(frozen=True)
class Control:
    """Parameters of the step control.

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


class ImplicitRun(Run):
    """An implicit integration over given times, with its energy ledger.

    Attributes
    ----------
    ledger : Ledger
    point : Point
        Current point.
    shortest : float
        Step [s] below which it cannot continue.
    """

    def __init__(self, saddle: Saddle, start: State, times: Array) -> None:
        super().__init__(start, times)
        self.saddle = saddle
        self.ledger = Ledger(saddle)
        self.result = replace(self.result, ledger=self.ledger.kept)
        self.point = Point.at(start, saddle.multipliers(start))
        self.shortest = SHORTEST * float(times[-1] - times[0])
        self._balance: Balance | None = None

    @property
    def t(self) -> float:
        """Current time of the motion."""
        return self.point.t

    def begin(self) -> None:
        """Open the ledger."""
        self.ledger.begin(self.point)

    def accept(self, point: Point, balance: Balance) -> None:
        """Continue from the end of a step."""
        h, until = point.t - self.point.t, self.until
        self.point, self._balance = point, balance
        self.ledger.add(balance, h)
        if point.t >= until:
            self.keep()

    def keep(self) -> None:
        """Store the current state, unless it is already stored."""
        states = self.result.states
        if self._balance is not None and self.t > states[-1].t:
            states.append(self.saddle.state(self._balance))
            self.ledger.keep()

    def failure(self) -> DynamicsError:
        """The error of a step that cannot be taken."""
        return DynamicsError(
            f"implicit integration cannot continue at t = {self.t:g} s (step below {self.shortest:.2g} s): the motion "
            "is not smooth there, or a condition cannot be met; inspect the last state of the motion, and start from "
            "there again after a change"
        )


class GeneralizedAlpha(ImplicitRun):
    """One run of the generalized-alpha method."""

    def __init__(
        self, system: Core, start: State, times: Array, radius: float, newton: str, control: Control
    ) -> None:
        self.stepper = Stepper(system, radius, newton, tolerance=control.tolerance)
        super().__init__(self.stepper, start, times)
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

    def advance(self) -> None:
        """One accepted step."""
        old, until = self.point, self.until
        gap = until - old.t
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
                raise self.failure()
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

    def _error(self, old: Point, new: Point, b: Balance, h: float) -> float:
        """Local error over the tolerance; infinite for a spurious solution, and if a new contact is too deep."""
        stepper = self.stepper
        if self._false < MOST_FALSE and self.ledger.spurious(b, h):
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
