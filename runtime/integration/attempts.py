"""The loop of trials of every method: a step is tried until it can be accepted, and ends where a contact does."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable
from enum import Enum, auto
from typing import NamedTuple

from flexel.engine.workspace import Workspace
from flexel.integration.touching import TouchingContacts
from flexel.model.snapshot import Snapshot

TRIALS = 8  # of one step, that end where a contact begins or ends


class Attempted(Enum):
    """What became of a trial to take a step."""

    FOUND = auto()  # the step can be accepted
    AGAIN = auto()  # another is prepared
    UNUSABLE = auto()  # it cannot be evaluated or trusted: other degrees of freedom may be better
    FLAT = auto()  # it shows a flat position, see `StepMethod.flat`; another is prepared
    SHORT = auto()  # it would be too short


class Attempts(ABC):
    """What a method does for a step, before it is accepted."""

    @abstractmethod
    def aim(self, end: float, shortest: float) -> None:
        """Prepare a step that ends at a time [s] at the latest; a shorter one than `shortest` [s] is too short."""

    @abstractmethod
    def attempt(self) -> Attempted:
        """Try the step that is prepared; nothing is accepted yet."""

    @abstractmethod
    def refuse(self, changed: bool) -> Attempted:
        """Prepare a shorter step after one that was of no use, perhaps in other degrees of freedom."""

    @abstractmethod
    def end(self) -> Snapshot:
        """Return the point at the end of the step that was found."""

    @property
    @abstractmethod
    def work(self) -> Workspace:
        """The workspace that holds that point."""

    @abstractmethod
    def cut(self, h: float) -> None:
        """Prepare a step of length h [s] instead of the one that was found: a contact begins or ends there."""


class Searched(NamedTuple):
    """How a search for a step has ended.

    Attributes
    ----------
    trial : Attempted
        FOUND, FLAT or SHORT.
    last : Snapshot or None
        The end of the step that was found.
    cuts : int
        How often it was cut short for a contact.
    whole : bool
        Whether no contact begins, ends or is passed within it, as far as it was looked for.
    kink : bool
        Whether forces change their law at its end: a contact begins or ends there.
    """

    trial: Attempted
    last: Snapshot | None = None
    cuts: int = 0
    whole: bool = True
    kink: bool = False


def search(
    attempts: Attempts,
    touching: TouchingContacts,
    first: Snapshot,
    shortest: float,
    other: Callable[[], bool],
) -> Searched:
    """Find the next step of a motion.

    Parameters
    ----------
    attempts : Attempts
        That have an aim.
    touching : TouchingContacts
    first : Snapshot
        The start of the step.
    shortest : float
        Length of a step [s] below which no contact ends it.
    other : callable() -> bool
        Change to better degrees of freedom at the start, after a trial that is of no use; whether there are any.
    """
    for cuts in range(TRIALS):
        trial = _tried(attempts, other)
        if trial is not Attempted.FOUND:
            return Searched(trial, cuts=cuts)
        last = attempts.end()
        until = touching.until(first, last, attempts.work)
        if until <= shortest:
            return Searched(trial, last, cuts, kink=cuts > 0 or touching.touched)
        if cuts + 1 < TRIALS:
            attempts.cut(until)
    return Searched(trial, last, cuts, whole=False, kink=True)


def _tried(attempts: Attempts, other: Callable[[], bool]) -> Attempted:
    """Try shorter steps until one is found, or there is a reason to stop."""
    while True:
        trial = attempts.attempt()
        if trial is Attempted.UNUSABLE:
            trial = attempts.refuse(other())
        if trial is not Attempted.AGAIN:
            return trial
