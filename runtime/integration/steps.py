"""Implicit integration of stiff models: step control and energy ledger."""

from __future__ import annotations

import math
from abc import abstractmethod
from dataclasses import dataclass, replace
from typing import ClassVar

import numpy as np

from flexel.base.arrays import Array
from flexel.base.errors import DynamicsError
from flexel.integration.alpha import Stepper
from flexel.integration.contact_watch import ContactWatch
from flexel.integration.driver import Run
from flexel.integration.ledger import Ledger
from flexel.mechanics import dynamics
from flexel.mechanics.balance import Balance, Saddle
from flexel.mechanics.core import Core
from flexel.mechanics.impulse import struck
from flexel.mechanics.inertia import InertiaError
from flexel.structure.moment import Moment
from flexel.structure.state import State

SHORTEST = 1e-10  # shortest step, over the duration
LOST = 0.01  # of the energy of a motion that its method may take out or add without a warning
DEEP = 0.1  # local error over a new contact's penetration above which the step is halved
STEADY = 1.3  # growth factor below which the step is kept: every change disturbs the multipliers
MOST_FALSE, MOST_HALVINGS = 8, 4  # step halvings because of spurious energy, and because of new contacts


@dataclass(frozen=True)
class Control:
    """Parameters of the step control.

    Attributes
    ----------
    tolerance : float
        Local error of coordinates and internal states over the size of the motion; infinite for steps of constant
        length.
    first, longest : float
        Steps [s].
    absolute : float
        Local error of the coordinates in their natural scales that is always allowed.
    """

    tolerance: float
    first: float
    longest: float
    absolute: float = 0.0


class ImplicitRun(Run):
    """An implicit integration over given times, with its energy ledger.

    Attributes
    ----------
    ledger : Ledger
    shortest : float
        Step [s] below which it cannot continue.
    """

    def __init__(self, saddle: Saddle, start: State, times: Array) -> None:
        super().__init__(saddle.system, start, times)
        self.saddle = saddle
        saddle.inside = self.knots.inside
        self.ledger = Ledger(saddle)
        self.result = replace(self.result, ledger=self.ledger.kept)
        self.shortest = SHORTEST * float(times[-1] - times[0])

    method: ClassVar[str]

    @abstractmethod
    def balance(self) -> Balance:
        """The balance of forces at the current time, in the workspace."""

    @property
    def instant(self) -> tuple[Moment, Array]:
        """Coordinates, rates and deformations at the current time, and internal states of laws."""
        state = self.present
        return Moment.of(state), state.z

    @property
    def present(self) -> State:
        """The complete state at the current time."""
        stored = self.result.states[-1]
        return stored if stored.t == self.t else self.saddle.state(self.balance())

    def begin(self) -> None:
        """Open the ledger."""
        self.balance()
        self.ledger.begin()

    def keep(self) -> None:
        """Store the current state, unless it is already stored."""
        if self.t > self.result.states.end:
            self.result.states.append(self.saddle.state(self.balance()))
            self.ledger.keep()

    def judge(self) -> str | None:
        """Whether the method has taken out, or added, more than a small part of the energy of the motion."""
        ledger = self.ledger
        if abs(ledger.share) <= LOST or not ledger.steps:
            return None
        step = (self.t - float(self.times[0])) / ledger.steps
        did = "taken out" if ledger.missing > 0 else "added"
        return (
            f"{self.method} has {did} {abs(ledger.missing):.2g} J, {abs(ledger.share):.0%} of the energy of the motion "
            f"(mean step {step:.2g} s); give a smaller rtol or step, or method='DOP853'"
        )

    def failure(self) -> DynamicsError:
        """The error of a step that cannot be taken."""
        return DynamicsError(
            f"implicit integration cannot continue at t = {self.t:g} s (step below {self.shortest:.2g} s): the motion "
            "is not smooth there, or a condition cannot be met; inspect the last state of the motion, change the "
            "model, and restart from there"
        )


class GeneralizedAlpha(ImplicitRun):
    """One run of the generalized-alpha method."""

    method = "generalized-alpha"

    def __init__(
        self, system: Core, start: State, times: Array, radius: float, newton: str, control: Control
    ) -> None:
        self.stepper = Stepper(system, start, radius, newton, control.tolerance)
        super().__init__(self.stepper, start, times)
        self.control = control
        if math.isfinite(control.tolerance):
            self.stepper.expect(start, float(times[-1] - times[0]), control.tolerance, control.absolute)
        self._watch = ContactWatch(
            self.stepper.work, (control.tolerance + control.absolute) * self.stepper.length
        )
        self._steps = self._rejected = self._at_contact = self._halvings = self._false = 0
        self._wish = min(control.first, control.longest)
        self._refused = (0.0, 0.0)  # length and error of a trial that was refused for its internal states

    @property
    def t(self) -> float:
        """Current time of the motion."""
        return self.stepper.t

    @property
    def step(self) -> float | None:
        """The length of the next step [s]."""
        return self._wish

    def renew(self) -> None:
        """Accelerations with the loads that have changed; unchanged if a degree of freedom has no inertia."""
        old, state = self.stepper.stepping.old, self.result.states[-1]
        kinematics = self.stepper.system.kinematics_of(state.roles)
        now = self.t
        try:
            found = dynamics.complete(
                kinematics, self.knots.inside(now), *(old[name].copy() for name in ("x", "v", "e", "z"))
            )
        except InertiaError:
            return
        self.stepper.begin(found)
        self.stepper.t = now

    def jump(self, z: Array) -> None:
        """Continue from here with other internal states."""
        self.stepper.stepping.old["z"][:] = z
        self.renew()
        self.balance()
        self.ledger.renew()

    def strike(self) -> None:
        """Continue from here with the rates just after an impulse."""
        old = self.stepper.stepping.old
        kinematics = self.stepper.system.kinematics_of(self.result.states[-1].roles)
        x, v, e = (old[name].copy() for name in ("x", "v", "e"))
        before = Moment(self.t, x, v, e, np.zeros_like(e))
        old["v"][:] = struck(kinematics, before, self.knots.inside(self.t)).v
        self.renew()
        self.balance()
        self.ledger.strike()

    @property
    def statistics(self) -> dict[str, int]:
        """Counts of what was done."""
        c = self.stepper.numbers
        return {
            "steps": self._steps,
            "rejected": self._rejected,
            "halved at contact": self._at_contact,
            "evaluations": c.evaluations,
            "iterations": c.iterations,
            "factorizations": c.factorizations,
            "rechoices": 0,
        }

    def balance(self) -> Balance:
        """The balance of forces at the current time, in the workspace."""
        return self.stepper.current()

    def advance(self) -> None:
        """One accepted step."""
        stepper, now, until = self.stepper, self.t, min(self.until, self.stop)
        gap = until - now
        if self._watch.any:
            self._watch.note(self.balance().a)
        parts = max(math.ceil(gap / min(self._wish, self.control.longest) * (1 - 1e-9)), 1)
        step = asked = gap / parts
        while (error := self._error(step)) > 1.0:
            self._rejected += 1
            step *= 0.5 if math.isinf(error) else max(0.2, 0.9 * error ** (-1 / 3))
            if step < self.shortest:
                raise self.failure()
        self._steps += 1
        self._refused = (0.0, 0.0)
        growth = min(2.0, 0.9 * max(error, 1e-6) ** (-1 / 3))
        allowed = step * (1.0 if 1.0 < growth < STEADY else growth)
        self._wish = max(allowed, self._wish) if step == asked else allowed
        if step == asked:
            self._halvings, self._false = max(self._halvings - 1, 0), max(self._false - 1, 0)
        end = now + step
        reached = abs(end - until) < 1e-6 * step
        stepper.accept(until if reached else end)
        self.ledger.add(step)
        if self.t >= self.until:
            self.keep()

    def _error(self, h: float) -> float:
        """Local error of a step over the tolerance; infinite if the step is not found or is rejected: for a spurious
        solution, or if a new contact is too deep.
        """
        stepper, ledger = self.stepper, self.ledger
        if not stepper.step(h):
            stepper.check_inertia()
            return math.inf
        ledger.look()
        if self._false < MOST_FALSE and ledger.spurious(h, stepper.balancing.struct.scale):
            self._false += 1
            return math.inf
        if self._watch.any and self._watch.skipped(h):
            self._at_contact += 1
            return math.inf
        if self._halvings < MOST_HALVINGS:
            begun = ledger.new_penetration()
            if begun and stepper.numbers.local_size > DEEP * begun:
                self._halvings += 1
                self._at_contact += 1
                return math.inf
        coordinates = float(stepper.numbers.local_error) / self.control.tolerance
        return max(coordinates, self._error_of_states(h)) if coordinates <= 1.0 else coordinates

    def _error_of_states(self, h: float) -> float:
        """The same of the internal states; a rate that jumps in the step, as of a bristle that begins to slide, passes.

        The error of a smooth rate falls with the third power of the step, and with the second in the first step of a
        motion, that of a jump with the first. Shorter steps would not find the jump.
        """
        error = float(self.stepper.numbers.state_error) / self.control.tolerance
        if error <= 1.0:
            return error
        before, larger = self._refused
        jump = h < before and error > larger * (h / before) ** 1.5
        self._refused = (h, error)
        return 1.0 if jump else error
