"""The result of an integration, and the times at which it is stored."""

from __future__ import annotations

import warnings
from bisect import bisect_left
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass, field, replace
from typing import Any, SupportsIndex, overload

import numpy as np

from flexel.base.arguments import array, number, whole
from flexel.base.arrays import Array
from flexel.base.callers import outside
from flexel.base.errors import ModelError
from flexel.integration.segments import Pending, Segment
from flexel.model.snapshot import Snapshot
from flexel.model.state import State
from flexel.model.structure import Structure


class States(Sequence[State]):
    """States in the order of time; those that are pending are completed on demand."""

    def __init__(self, states: Sequence[State | Pending] = ()) -> None:
        self._entries: list[State | Pending] = list(states)

    def __getstate__(self) -> dict[str, Any]:
        """Pending states stay pending, and are small; those that need a user's code are completed first, so that
        results can be read where that code cannot be compiled.
        """
        if self._entries and self._structure.has_user_code:
            self._entries = list(self)
        return {"_entries": list(self._entries)}

    @property
    def _structure(self) -> Structure:
        first = self._entries[0]
        return first.kinematics.structure if isinstance(first, Pending) else first.structure

    def append(self, state: State | Pending) -> None:
        """Add the next state."""
        self._entries.append(state)

    def copy(self) -> States:
        """Copy the list of states."""
        return States(self._entries)

    def cut(self, size: int) -> None:
        """Keep the first `size` states only."""
        del self._entries[size:]

    def since(self, first: int) -> States:
        """Return the states from that index on."""
        return States(self._entries[first:])

    def last(self) -> States:
        """Return the last state, alone."""
        return States(self._entries[-1:])

    @property
    def times(self) -> list[float]:
        """Their times [s]."""
        return [entry.t for entry in self._entries]

    @property
    def deformations(self) -> Array:
        """Deformations (times, m); pending states are not completed for them."""
        return np.array(
            [entry.moment.e if isinstance(entry, Pending) else entry.e for entry in self._entries]
        )

    @property
    def coordinates(self) -> Array:
        """Coordinates (times, n); pending states are not completed for them."""
        return np.array(
            [entry.moment.x if isinstance(entry, Pending) else entry.x for entry in self._entries]
        )

    def moments(self, parts: Sequence[float]) -> list[tuple[Snapshot, Array]]:
        """Return instants at parts of the list, with internal states; pending states are not completed for them."""
        return [
            (state.moment if isinstance(state, Pending) else Snapshot.of(state), state.z)
            for state in self.some(parts)
        ]

    def some(self, parts: Sequence[float]) -> list[State | Pending]:
        """Return the states at parts of the list, as they are."""
        places = [round(part * (len(self._entries) - 1)) for part in parts]
        return [self._entries[i] for i in dict.fromkeys(places)]

    def complete_and(self, count: int) -> list[State | Pending]:
        """Return all complete states, and about `count` at even distances, as they are."""
        if len(self._entries) <= count:
            return self._entries
        places = {round(i * (len(self._entries) - 1) / (count - 1)) for i in range(count)}
        return [entry for i, entry in enumerate(self._entries) if i in places or isinstance(entry, State)]

    @property
    def end(self) -> float:
        """Time [s] of the last one."""
        return self._entries[-1].t

    def __len__(self) -> int:
        return len(self._entries)

    @overload
    def __getitem__(self, key: SupportsIndex) -> State: ...
    @overload
    def __getitem__(self, key: slice) -> list[State]: ...
    def __getitem__(self, key: SupportsIndex | slice) -> State | list[State]:
        if isinstance(key, slice):
            return [self[i] for i in range(*key.indices(len(self)))]
        entry = self._entries[key]
        if isinstance(entry, Pending):
            entry = self._entries[key] = entry.state()
        return entry

    def __iter__(self) -> Iterator[State]:
        return (self[i] for i in range(len(self)))


Said = list[tuple[type[Warning], str]]
_gathered: ContextVar[Said | None] = ContextVar("gathered", default=None)


@contextmanager
def gathered() -> Iterator[Said]:
    """Gather the warnings of motions instead of issuing them."""
    said: Said = []
    token = _gathered.set(said)
    try:
        yield said
    finally:
        _gathered.reset(token)


def issue(text: str, category: type[Warning], owner: str = "simulate: ") -> None:
    """Issue a warning after the name of its owner; within `gathered` who gathers does so."""
    said = _gathered.get()
    if said is None:
        warnings.warn(owner + text, category, stacklevel=outside())
    else:
        said.append((category, text))


EQUILIBRIA = "equilibria"  # the statistic that only states without anything between them have


@dataclass(frozen=True)
class Integration:
    """Result of an integration: states at the requested times, events, pieces with dense output, counts.

    Attributes
    ----------
    rechoices : list of (float, tuple of str, tuple of str)
        Changes of the degrees of freedom: times [s], old and new names.
    energy_terms : dict of str to list of float, optional
        Terms of the energy balance of an implicit integration, at the stored times.
    warnings : list of str
        Evidence of its method and the audit against the motion; each was issued as a Python warning.
    verdict : str
        Result of the audit in one line; empty if there was none.
    """

    states: States
    events: list[tuple[str, State]]
    segments: list[Segment]
    statistics: dict[str, int]
    message: str
    energy_terms: dict[str, list[float]] | None = None
    rechoices: list[tuple[float, tuple[str, ...], tuple[str, ...]]] = field(default_factory=list)
    warnings: list[str] = field(default_factory=list)
    verdict: str = ""

    @classmethod
    def of_equilibria(cls, states: Sequence[State], message: str) -> Integration:
        """Return equilibria in the order of their load parameter, without anything between them."""
        counts = {"steps": len(states) - 1, "evaluations": 0, "rechoices": 0, EQUILIBRIA: len(states)}
        return cls(States(states), [], [], counts, message)

    def copy(self) -> Integration:
        """Copy the results to separate lists."""
        terms = self.energy_terms
        return replace(
            self,
            states=self.states.copy(),
            events=list(self.events),
            segments=list(self.segments),
            energy_terms=None if terms is None else {name: list(values) for name, values in terms.items()},
            rechoices=list(self.rechoices),
            warnings=list(self.warnings),
        )

    def warn(self, text: str, category: type[Warning], owner: str = "simulate: ") -> None:
        """Record evidence against the motion, and issue it once as a Python warning, after the owner's name."""
        if text in self.warnings:
            return
        self.warnings.append(text)
        issue(text, category, owner)

    def since(self, t: float) -> Integration:
        """Drop the states before a time, such as a start that is not to be stored.

        The last state is always kept.  `energy_terms` keeps the energy with which the motion began, as "initial".
        """
        first = min(bisect_left(self.states.times, t), len(self.states) - 1)
        if first <= 0:
            return self
        kept = {name: column[first:] for name, column in (self.energy_terms or {}).items()}
        if self.energy_terms is not None:
            surplus = (
                self.states[0].energy.total
                + self.energy_terms["dissipated"][0]
                - self.energy_terms["work"][0]
            )
            kept["initial"] = [surplus] * len(kept["work"])
        terms = None if self.energy_terms is None else kept
        return replace(self, states=self.states.since(first), energy_terms=terms)

    def last(self) -> Integration:
        """Keep the last state alone; the energy terms, which continue, keep their last values."""
        for column in (self.energy_terms or {}).values():
            del column[:-1]
        return Integration(self.states.last(), [], [], {}, "", self.energy_terms, warnings=self.warnings)

    def cut(self, size: int) -> None:
        """Keep the first `size` stored states, and the energy terms at these."""
        self.states.cut(size)
        for column in (self.energy_terms or {}).values():
            del column[size:]


def stored_times(start: State, duration: Any, times: Any, samples: Any, owner: str) -> Array:
    """Return the times at which states are stored: those given, or equidistant ones from the start on.

    Parameters
    ----------
    start : State
    duration : float
        Length of the motion [s].
    times : array_like or None
        The times [s]; None for equidistant ones.
    samples : int
        Number of these.
    owner : str
        Caller named in error messages.

    Raises
    ------
    ModelError
        A duration that is not positive, times that do not increase or lie outside the motion.
    """
    span = number(duration, owner, "duration")
    if span <= 0:
        raise ModelError(f"{owner}: duration {span:g} s is not positive; give a positive time")
    if times is None:
        return np.linspace(start.t, start.t + span, whole(samples, owner, "samples", 2))
    grid = array(times, owner, "times")
    if grid.ndim != 1 or not grid.size or np.any(np.diff(grid) <= 0) or grid[0] < start.t:
        raise ModelError(f"{owner}: times must be a list that increases from {start.t:g} s; sort them")
    if grid[-1] > start.t + span * (1 + 1e-12):
        raise ModelError(
            f"{owner}: time {grid[-1]:g} s lies after the end of the motion, {start.t + span:g} s; lengthen the "
            "duration"
        )
    return grid


def from_start(start: State, times: Array) -> Array:
    """Put the time of the start in front of the times, where a run begins; see `Integration.since`."""
    return np.concatenate([[start.t], times]) if times[0] > start.t else times
