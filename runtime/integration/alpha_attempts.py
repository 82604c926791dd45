"""Trials of steps of the generalized-alpha method, their errors, and the lengths that follow from them."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from flexel.base.arrays import Index
from flexel.engine.contact_selection import every_gap
from flexel.engine.step_control import StepControl
from flexel.engine.workspace import Workspace
from flexel.integration.alpha import AlphaStepper
from flexel.integration.attempts import Attempted, Attempts
from flexel.integration.energy_balance import EnergyBalance
from flexel.model.snapshot import Snapshot

NEAR = 1e-6  # distance of a time from the end of a step, relative to it, that is rounding
CONTROL = StepControl(order=3, most=2.0, steady=1.3)  # every change of the step disturbs the multipliers
DEEP = 0.03  # error of a gap, relative to the depth of its contact, above which a step is shortened
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

    @cached_property
    def constant(self) -> bool:
        """Whether the steps have a constant length."""
        return math.isinf(self.tolerance)


class AlphaAttempts(Attempts):
    """Trials of steps.

    Parameters
    ----------
    stepper : AlphaStepper
    balance : EnergyBalance
        That of the motion.
    control : Control
    gaps : ndarray of int
        Those whose depth each step must resolve.
    compared : bool
        Whether the ends of steps are compared, so that their points are copied.

    Attributes
    ----------
    wish : float
        Length of the next step [s].
    rejected, at_contact : int
        Trials that were refused, and of these the ones because of contacts.
    """

    def __init__(
        self, stepper: AlphaStepper, balance: EnergyBalance, control: Control, gaps: Index, compared: bool
    ) -> None:
        self.stepper, self.balance, self.control, self._compared = stepper, balance, control, compared
        self._gaps, self._contacts = gaps, bool(every_gap(stepper.work.tables).size)
        self.wish = min(control.first, control.longest)
        self.rejected = self.at_contact = self._halvings = self._false = 0
        self._refused = (0.0, 0.0)  # length and error of a trial that was refused for its internal states
        self._end = self._shortest = self._asked = self._h = self._next = 0.0
        self._error, self._cut = 0.0, False

    def aim(self, end: float, shortest: float) -> None:
        """Prepare a step that divides the time up to another one [s], or a shorter one."""
        gap = end - self.stepper.t
        parts = max(math.ceil(gap / min(self.wish, self.control.longest) * (1 - 1e-9)), 1)
        self._end, self._shortest, self._cut = end, shortest, False
        self._asked = self._h = gap / parts

    def attempt(self) -> Attempted:
        """Try the step that is prepared."""
        self._error = self._of(self._h)
        if self._error > 1.0:
            self.rejected += 1
            return Attempted.UNUSABLE
        if not self._cut:
            allowed = self._h * CONTROL.longer(self._error)
            self._next = max(allowed, self.wish) if self._h == self._asked else allowed
        return Attempted.FOUND

    def refuse(self, changed: bool) -> Attempted:
        """Prepare a shorter step."""
        self._h *= CONTROL.shorter(self._error)
        self._cut = False
        return Attempted.SHORT if self._h < self._shortest else Attempted.AGAIN

    def end(self) -> Snapshot:
        """Return the point at the end of the step that was found."""
        end, work = self.stepper.t + self._h, self.stepper.work
        t = self._end if abs(end - self._end) < NEAR * self._h else end
        if not self._compared:
            return Snapshot(t, work.x, work.v, work.e, work.w)
        return Snapshot(t, work.x.copy(), work.v.copy(), work.e.copy(), work.w[: work.e.size].copy())

    @property
    def work(self) -> Workspace:
        """The workspace that holds that point."""
        return self.stepper.work

    def cut(self, h: float) -> None:
        """Prepare a step of length h [s] instead of the one that was found, whose length the next one may have."""
        self._h, self._cut = h, True

    def accept(self) -> None:
        """Wish for the length of the next step, after the one that was found."""
        self.wish, self._refused = self._next, (0.0, 0.0)
        if self._h == self._asked and (self._halvings or self._false):
            self._halvings, self._false = max(self._halvings - 1, 0), max(self._false - 1, 0)

    def _of(self, h: float) -> float:
        """Local error of a step over the tolerance; infinite if the step is not found or is rejected: for a spurious
        solution, or if a contact is too deep for it.
        """
        stepper, balance = self.stepper, self.balance
        if not stepper.step(h):
            stepper.check_inertia()
            return math.inf
        balance.look()
        if self._false < MOST_FALSE and balance.spurious(h):
            self._false += 1
            return math.inf
        if self._contacts and (self._rough(h) or self._deep()):
            self.at_contact += 1
            return math.inf
        coordinates = float(stepper.numbers.local_error) / self.control.tolerance
        return coordinates if coordinates > 1.0 else max(coordinates, self._error_of_states(h))

    def _rough(self, h: float) -> bool:
        """Whether a step is too coarse for a contact: the error of its gap is no small part of its depth.

        A contact that begins is as deep as the step has let it be, so that steps become short beside its duration.
        """
        if self.control.constant or not self._gaps.size:
            return False
        work = self.stepper.work
        depth = -np.minimum(self.stepper.stepping.old["e"][self._gaps], work.e[self._gaps])
        closed = depth > 0
        if not closed.any():
            return False
        error = np.abs(work.jvp(self.stepper.local_errors(h))[self._gaps[closed]])
        return bool(np.any(error > DEEP * depth[closed]))

    def _deep(self) -> bool:
        """Whether contacts have begun so deeply within a step that it is halved."""
        if self._halvings >= MOST_HALVINGS:
            return False
        begun = self.balance.new_penetration()
        deep = bool(begun and self.stepper.numbers.local_size > DEEP * begun)
        self._halvings += deep
        return deep

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
