"""Motions by the generalized-alpha method, with their energy balance."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from flexel.base.arrays import Array
from flexel.base.errors import DynamicsError
from flexel.integration.alpha import AlphaStepper
from flexel.integration.alpha_attempts import NEAR, AlphaAttempts, Control
from flexel.integration.attempts import search
from flexel.integration.balance import Balance
from flexel.integration.between import between
from flexel.integration.driver import Run, ended_by
from flexel.integration.energy_balance import EnergyBalance
from flexel.integration.events import Event
from flexel.integration.imbalance import AT_REST, Imbalance
from flexel.integration.outcome import Integration
from flexel.integration.replay import Replay, Replayed
from flexel.integration.touching import TouchingContacts, abrupt_gaps
from flexel.mechanics import dynamics
from flexel.mechanics.impulse import struck
from flexel.mechanics.inertia import InertiaError
from flexel.model.snapshot import Snapshot
from flexel.model.state import State
from flexel.system import CoreSystem

SHORTEST = 1e-10  # shortest step, over the duration
LOST = 0.01  # of the energy of a motion that its method may take out or add without a warning


class GeneralizedAlpha(Run):
    """One run of the generalized-alpha method, with its energy balance.

    Attributes
    ----------
    stepper : AlphaStepper
    now : Snapshot
        The current point of the motion; only its time, if it is not compared, see `AlphaAttempts`.
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
        if not control.constant:
            self.stepper.expect(start, duration, control.tolerance, control.absolute)
        tables, gaps = stepper.work.tables, self.passed.rows
        self._touching = TouchingContacts(tables, abrupt_gaps(tables, gaps), self.passed, sees_inside=False)
        compared = self._touching.look.any
        self._attempts = AlphaAttempts(stepper, self.energy_balance, control, gaps, compared)
        self._steps = self._cuts = 0
        self.now = Snapshot.of(start)
        self._anchor, self._multiple = start.t, 0  # from where constant steps are counted

    @property
    def t(self) -> float:
        """Current time of the motion."""
        return self.stepper.t

    @property
    def step(self) -> float | None:
        """The length of the next step [s]."""
        return self._attempts.wish

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
        self.now = struck(kinematics, Snapshot(self.t, x, v, e, np.zeros_like(e)), self.knots.inside(self.t))
        old["v"][:] = self.now.v
        self.renew()
        self.balance()
        self.energy_balance.strike()

    @property
    def statistics(self) -> dict[str, int]:
        """Counts of what was done."""
        c = self.stepper.numbers
        return {
            "steps": self._steps,
            "rejected": self._attempts.rejected + self._cuts,
            "halved at contact": self._attempts.at_contact,
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
        attempts, begun, constant = self._attempts, self.t, self.control.constant
        attempts.aim(self._goal(), self.shortest)
        cut = np.inf if constant else self.shortest  # constant steps are taken as they are given
        found = search(attempts, self._touching, self.now, cut, _none)
        if found.last is None:
            raise self.failure()
        attempts.accept()
        self._steps += 1
        self._cuts += found.cuts
        end = found.last.t
        terminal = self._met(end) if self.events else None
        if found.cuts:
            self._looks.forget()  # forces have a kink at its end
        if terminal is not None:
            end = terminal[1].t
            self._shorten(end - begun)
        if constant:
            end = self._keep_within(end, end - begun)
        self.replay.add(end, self.knots.interval)
        self.stepper.accept(end)
        if constant or not found.whole:
            self.passed.look([(self.now, found.last)])
        self.now = found.last if end == found.last.t else replace(found.last, t=end)
        self.energy_balance.add(end - begun)
        if terminal is not None:
            return self._end_at(*terminal)
        if self.t >= self.until:
            self.keep()
            self._keep_close()
        return None

    def _keep_close(self) -> None:
        """Store the state just stored at the next times too, if no step leads from here to these."""
        while self.more_times and self.until - self.t < self.shortest:
            self.result.states.append(replace(self.result.states[-1], t=self.until))
            self.energy_balance.keep()

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
        self.now = Snapshot.of(state)
        self.replay.part()
        self.result.states.append(state)
        self.energy_balance.keep()
        return ended_by(event)

    def _goal(self) -> float:
        """When the next step ends at the latest [s]: where a state is stored, but for constant steps at their ends."""
        if not self.control.constant:
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


def _none() -> bool:
    """Whether other degrees of freedom are better: the method takes steps in all coordinates."""
    return False
