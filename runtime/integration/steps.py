"""Runs of the generalized-alpha method: step control and energy balance."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from flexel.base.arrays import Array
from flexel.base.errors import DynamicsError
from flexel.engine.step_control import StepControl
from flexel.integration.alpha import AlphaStepper
from flexel.integration.balance import Balance
from flexel.integration.between import between
from flexel.integration.contact_watch import DEEP, ContactWatch
from flexel.integration.driver import Run, ended_by
from flexel.integration.energy_balance import EnergyBalance
from flexel.integration.events import Event
from flexel.integration.imbalance import AT_REST, Imbalance
from flexel.integration.outcome import Integration
from flexel.integration.replay import Replay, Replayed
from flexel.mechanics import dynamics
from flexel.mechanics.impulse import struck
from flexel.mechanics.inertia import InertiaError
from flexel.model.snapshot import Snapshot
from flexel.model.state import State
from flexel.system import CoreSystem

SHORTEST = 1e-10  # shortest step, over the duration
LOST = 0.01  # of the energy of a motion that its method may take out or add without a warning
NEAR = 1e-6  # distance of a time from the end of a step, relative to it, that is rounding
CONTROL = StepControl(order=3, most=2.0, steady=1.3)  # every change of the step disturbs the multipliers
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


class GeneralizedAlpha(Run):
    """One run of the generalized-alpha method, with its energy balance.

    Attributes
    ----------
    stepper : AlphaStepper
    replay : Replay
        Takes its steps again, for the states within them.
    energy_balance : EnergyBalance
    shortest : float
        Step [s] below which it cannot continue.
    """

    name = "generalized-alpha"

    def __init__(
        self,
        system: CoreSystem,
        start: State,
        times: Array,
        stepper: AlphaStepper,
        control: Control,
        events: Sequence[Event] = (),
    ) -> None:
        self.stepper = stepper
        stepper.begin(start)
        super().__init__(system, start, times, events)
        self.stepper.inside = self.knots.inside
        self.replay = Replay(stepper)
        self.energy_balance = EnergyBalance(self.stepper)
        self.result = replace(self.result, energy_terms=self.energy_balance.terms)
        duration = float(times[-1] - times[0])
        self.shortest = SHORTEST * duration
        self.control = control
        if math.isfinite(control.tolerance):
            self.stepper.expect(start, duration, control.tolerance, control.absolute)
        self._watch = ContactWatch(self.stepper.work, math.isinf(control.tolerance))
        self._unwatched = self.passed.any and not self._watch.any
        self._begun: Snapshot | None = None  # the current point, if contacts are not watched
        self._steps = self._rejected = self._at_contact = self._halvings = self._false = 0
        self._wish = min(control.first, control.longest)
        self._refused = (0.0, 0.0)  # length and error of a trial that was refused for its internal states
        self._constant = math.isinf(
            control.tolerance
        )  # steps then end at multiples of their length from here on
        self._anchor, self._multiple = start.t, 0

    @property
    def t(self) -> float:
        """Current time of the motion."""
        return self.stepper.t

    @property
    def step(self) -> float | None:
        """The length of the next step [s]."""
        return self._wish

    @property
    def instant(self) -> tuple[Snapshot, Array]:
        """Coordinates, rates and deformations at the current time, and internal states of laws."""
        state = self.present
        return Snapshot.of(state), state.z

    @property
    def present(self) -> State:
        """The complete state at the current time."""
        stored = self.result.states[-1]
        return stored if stored.t == self.t else self.stepper.state(self.balance())

    def begin(self) -> None:
        """Start the energy balance, and take over prescribed rates that the start does not have."""
        self.balance()
        self.energy_balance.begin()
        if self.begins_with_jump():
            self.strike()

    def keep(self) -> None:
        """Store the current state, unless it is already stored."""
        if self.t > self.result.states.end:
            self.result.states.append(self.stepper.state(self.balance()))
            self.energy_balance.keep()

    def kept(self, message: str) -> Integration:
        """Return the results so far, with the states at any time until now."""
        begin = float(self.times[0])
        self.result.segments[:] = [self._replayed(begin, self.t)] if self.t > begin else []
        return super().kept(message)

    def go_on(self, until: float) -> None:
        """Continue to another time, from a motion that has ended; what was stored before is dropped."""
        super().go_on(until)
        self.replay = Replay(self.stepper)

    def renew(self) -> None:
        """Compute accelerations with the changed loads; leave them if a degree of freedom has no inertia."""
        old, state = self.stepper.stepping.old, self.result.states[-1]
        self._begun = None
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
        self.replay.part()

    def jump(self, z: Array) -> None:
        """Continue from here with other internal states."""
        self.stepper.stepping.old["z"][:] = z
        self.replay.part()
        self.renew()
        self.balance()
        self.energy_balance.renew()

    def strike(self) -> None:
        """Continue from here with the rates just after an impulse."""
        super().strike()
        self.replay.part()
        old = self.stepper.stepping.old
        kinematics = self.stepper.system.kinematics_of(self.result.states[-1].roles)
        x, v, e = (old[name].copy() for name in ("x", "v", "e"))
        before = Snapshot(self.t, x, v, e, np.zeros_like(e))
        old["v"][:] = struck(kinematics, before, self.knots.inside(self.t)).v
        self.renew()
        self.balance()
        self.energy_balance.strike()

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
        """Return the balance of forces at the current time, in the workspace."""
        return self.stepper.current()

    def judge(self) -> str | None:
        """Whether the method has taken out, or added, more than a small part of the energy of the motion."""
        balance = self.energy_balance
        if abs(balance.share) <= LOST or not balance.steps:
            return None
        step = (self.t - float(self.times[0])) / balance.steps
        did = "removed" if balance.missing > 0 else "added"
        return (
            f"{self.name} has {did} {abs(balance.missing):.2g} J, {abs(balance.share):.0%} of the energy of the "
            f"motion (mean step {step:.2g} s); give a smaller rtol or step, or method='DOP853'"
        )

    def imbalance(self) -> Imbalance:
        """Return the error of the energy balance; `judge` reports what is lost beyond a small part."""
        balance = self.energy_balance
        moved = balance.moved
        if moved <= AT_REST * (moved + balance.size):
            return Imbalance(0.0, 0.0, 0.0, self.t)
        return Imbalance(abs(balance.missing), moved, np.inf, self.t)

    def failure(self) -> DynamicsError:
        """Return the error of a step that cannot be taken."""
        return DynamicsError(
            f"implicit integration cannot continue at t = {self.t:g} s (step below {self.shortest:.2g} s): the motion "
            "is not smooth there, or a condition cannot be met; inspect the last state of the motion, change the "
            "model, and restart from there"
        )

    def advance(self) -> str | None:
        """Take one accepted step, or that up to a terminal event within it."""
        stepper, now, until = self.stepper, self.t, self._goal()
        if self._watch.any:
            self._watch.note(self.balance().a)
        first = self._start() if self._unwatched else None
        step = self._found(until - now)
        end = now + step
        if abs(end - until) < NEAR * step:
            end = until
        terminal = self._met(end) if self.events else None
        if terminal is not None:
            end = terminal[1].t
            self._shorten(end - now)
        if self._constant:
            end = self._keep_within(end, end - now)
        self.replay.add(end, self.knots.interval)
        stepper.accept(end)
        if first is not None:
            self._begun = self._moment()
            self.passed.look([(first, self._begun)])
        self.energy_balance.add(end - now)
        if terminal is not None:
            return self._end_at(*terminal)
        if self.t >= self.until:
            self.keep()
        return None

    def _found(self, gap: float) -> float:
        """Find a step that divides a gap [s], or a shorter one; return its length, and wish for that of the next."""
        parts = max(math.ceil(gap / min(self._wish, self.control.longest) * (1 - 1e-9)), 1)
        step = asked = gap / parts
        while (error := self._error(step)) > 1.0:
            self._rejected += 1
            step *= CONTROL.shorter(error)
            if step < self.shortest:
                raise self.failure()
        self._steps += 1
        self._refused = (0.0, 0.0)
        allowed = step * CONTROL.longer(error)
        self._wish = max(allowed, self._wish) if step == asked else allowed
        if step == asked:
            self._halvings, self._false = max(self._halvings - 1, 0), max(self._false - 1, 0)
        return step

    def _replayed(self, t0: float, t1: float) -> Replayed:
        """Return a stretch of the motion, or its present step, with the states within it."""
        return Replayed(t0, t1, self.stepper.system.kinematics, self.replay)

    def _met(self, end: float) -> tuple[Event, State] | None:
        """Report the events within the step that was found; return a terminal one, with the state there."""
        step = self._replayed(self.t, end)
        return self.report_events(step, lambda: self.stepper.state(self.stepper.found(end)))

    def _shorten(self, h: float) -> None:
        """Take a step of length h [s] in place of the one that was found: a terminal event lies there."""
        if not self.stepper.step(h):
            raise self.failure()
        self.energy_balance.look()

    def _end_at(self, event: Event, state: State) -> str:
        """End the motion at a terminal event, with its state; return the message."""
        self.stepper.begin(state)
        self.replay.part()
        self.result.states.append(state)
        self.energy_balance.keep()
        return ended_by(event)

    def _goal(self) -> float:
        """When the next step ends at the latest [s]: where a state is stored, but for constant steps at their ends."""
        if not self._constant:
            return min(self.until, self.latest)
        stop = self.stop
        h = self.control.longest
        if self._anchor + self._multiple * h <= self.t + NEAR * h:
            self._multiple += 1
        goal = self._anchor + self._multiple * h
        if goal < stop - NEAR * h:
            return goal
        self._anchor, self._multiple = stop, 0
        return stop

    def _keep_within(self, end: float, step: float) -> float:
        """Store the states whose times lie within a step that was found; return its end, or a stored time there."""
        while self.until < end - NEAR * step:
            self.result.states.append(between(self.replay, self.energy_balance, self.t, self.until))
        return self.until if self.until < end + NEAR * step else end

    def _start(self) -> Snapshot:
        """Return the current point, from the last step if it is known."""
        if self._begun is None:
            self.balance()
            self._begun = self._moment()
        return self._begun

    def _moment(self) -> Snapshot:
        """Return the point in the workspace, at the current time."""
        x, v, e, w = (getattr(self.stepper.work, name).copy() for name in ("x", "v", "e", "w"))
        return Snapshot(self.t, x, v, e, w[: e.size])

    def _error(self, h: float) -> float:
        """Local error of a step over the tolerance; infinite if the step is not found or is rejected: for a spurious
        solution, or if a new contact is too deep.
        """
        stepper, balance = self.stepper, self.energy_balance
        if not stepper.step(h):
            stepper.check_inertia()
            return math.inf
        balance.look()
        if self._false < MOST_FALSE and balance.spurious(h):
            self._false += 1
            return math.inf
        if self._watch.any and (self._watch.skipped(h) or self._watch.rough(lambda: stepper.local_errors(h))):
            self._at_contact += 1
            return math.inf
        if self._halvings < MOST_HALVINGS:
            begun = balance.new_penetration()
            if begun and stepper.numbers.local_size > DEEP * begun:
                self._halvings += 1
                self._at_contact += 1
                return math.inf
        coordinates = float(stepper.numbers.local_error) / self.control.tolerance
        return max(coordinates, self._error_of_states(h)) if coordinates <= 1.0 else coordinates

    def _error_of_states(self, h: float) -> float:
        """Return the same of the internal states; a rate that jumps in the step, as when a bristle slides, passes.

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
