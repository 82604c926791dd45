"""Checkpoints: the motion so far in a file while a simulation runs, from which an aborted one continues."""

from __future__ import annotations

import json
from dataclasses import dataclass, replace
from hashlib import sha256
from pathlib import Path
from time import monotonic
from typing import Any

import numpy as np

from flexel.analyses.restoring import restored
from flexel.base.arguments import path_of
from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.integration.driver import INTERRUPTED, Run
from flexel.integration.methods import Options
from flexel.integration.outcome import Integration, States, from_start
from flexel.mechanics.core import Core
from flexel.results.motion import Motion
from flexel.results.saved.archive import motion_of, record_of, roles_in_names
from flexel.results.saved.description import described
from flexel.results.saved.files import read, write
from flexel.results.saved.record import Record
from flexel.structure.controllers import Controller
from flexel.structure.rules import LinearRule
from flexel.structure.state import State

EVERY = 30.0  # seconds between two checkpoints
SHARE = 0.05  # share of the time that may be spent on writing them
MARKS = "checkpoint"  # key of the header of their files
PARTS = ("model", "loads and prescribed motions", "start", "stored times", "method and its options")
SINCE_START = ("dissipated", "work")  # columns of the ledger that count from the start of a run


@dataclass(frozen=True)
class Before:
    """The part of a simulation that an earlier process has computed.

    Attributes
    ----------
    found : Integration
        Up to the last checkpoint, with the state at it.
    step : float or None
        The step [s] with which to continue.
    complete : bool
        Whether it is the whole motion.
    """

    found: Integration
    step: float | None
    complete: bool


class Checkpoint:
    """Writes the motion so far to a file during a simulation, and reads it back in the next one.

    Parameters
    ----------
    path : str or Path
        As for `Motion.save`.
    system, start, times, method, options
        They identify the simulation: a file of another one is refused.
    """

    def __init__(
        self, path: str | Path, system: Core, start: State, times: Array, method: str, options: Options
    ) -> None:
        self.path = path_of(path, "simulate")
        self._system, self._first, self._times = system, float(times[0]), from_start(start, times)
        self._marks = _marks(system, start, self._times, method, options)
        self._next = monotonic() + EVERY
        self._before: Integration | None = None

    def before(self) -> Before | None:
        """The motion in the file, or None if there is no file.

        Raises
        ------
        ModelError
            A file of something else, or of another simulation: it names what differs.
        """
        if not self.path.exists():
            return None
        record = read(self.path)
        marks = record.header.get(MARKS)
        if record.kind != "motion" or not isinstance(marks, dict):
            raise ModelError(
                f"simulate: '{self.path}' holds a result that is not a checkpoint; give another path, so that nothing "
                "is lost"
            )
        differing = [part for part in PARTS if marks.get(part) != self._marks[part]]
        if differing:
            raise ModelError(
                f"simulate: the checkpoint '{self.path}' is of another simulation ({', '.join(differing)} differ); "
                "delete it, or give another path"
            )
        self._before = _attached(self._system, record)
        return Before(self._before, marks["step"], marks["complete"])

    def try_out(self, start: State) -> None:
        """Write a checkpoint of the start and remove it, so that a path that cannot be written fails now.

        Raises
        ------
        FlexelError
            A folder that does not exist or is protected, a full disk, a package that is missing.
        """
        self._write(Integration(States([start]), [], [], {}, ""), None, complete=False, trial=True)

    def __call__(self, run: Run) -> None:
        """Called after a step: write a checkpoint if the last one is old enough."""
        now = monotonic()
        if now < self._next:
            return
        self._write(self.whole(run.so_far()), run.step, complete=False)
        done = monotonic()
        self._next = done + max(EVERY, (done - now) / SHARE)

    def end(self, found: Integration, step: float | None) -> None:
        """Write the motion that has ended, which can be continued if it was interrupted."""
        complete = not found.message.startswith(INTERRUPTED)
        self._write(found.since(self._first) if complete else found, step, complete=complete)

    def _write(self, found: Integration, step: float | None, *, complete: bool, trial: bool = False) -> None:
        record = record_of(Motion(self._system, found))
        marks = self._marks | {"step": step, "complete": complete}
        marked = replace(record, header={**record.header, MARKS: marks})
        write(marked, self.path, owner="simulate: checkpoint", trial=trial)

    def whole(self, found: Integration) -> Integration:
        """The earlier part of the motion joined with the part that this process has computed."""
        return found if self._before is None else _joined(self._before, found, self._times)


def _marks(system: Core, start: State, times: Array, method: str, options: Options) -> dict[str, str]:
    """Digests that identify a simulation, one for each of PARTS.

    Loads and prescribed motions are compared at the first two stored times: functions cannot be compared.
    """
    own = (system.roles.motion, system.loads.values)
    given = [f(t).tolist() for f in own for t in times[:2]]
    begin = [start.t, *(z.tolist() for z in (start.x, start.v, start.e, start.z)), roles_in_names(start)]
    events = [(z.name, z.terminal, z.direction) for z in options.events or ()]
    contents = (
        [described(system.structure), [_settings(c) for c in system.structure.controllers]],
        [system.structure.names[i] for i in system.loads.quantities] + given,
        begin,
        times.tolist(),
        [method, {**vars(options), "events": events}],
    )
    return {part: _digest(z) for part, z in zip(PARTS, contents, strict=True)}


def _settings(c: Controller) -> list[Any]:
    """The properties of a controller that can be compared: all but its function."""
    rule = list(vars(c.rule).values()) if isinstance(c.rule, LinearRule) else []
    windup = [] if c.windup is None else [type(c.windup).__name__, *vars(c.windup).values()]
    return [c.name, c.inputs, c.outputs, c.period, c.delay, c.low, c.high, rule, windup]


def _digest(contents: Any) -> str:
    return sha256(json.dumps(contents, default=_plain).encode()).hexdigest()


def _plain(value: Any) -> Any:
    """Numbers of NumPy as lists; an option that is not a number, and is refused later, as its text."""
    return value.tolist() if isinstance(value, np.ndarray | np.generic) else repr(value)


def _attached(system: Core, record: Record) -> Integration:
    """The motion in a record, with states of the system."""
    motion = motion_of(record)
    return Integration(
        States([restored(system, z) for z in motion]),
        [(name, restored(system, z)) for name, z in motion.events],
        [],
        motion.statistics,
        motion.message,
        motion.ledger,
        motion.rechoices,
        list(motion.warnings),
    )


def _joined(first: Integration, second: Integration, times: Array) -> Integration:
    """Two parts of a motion; the second starts from the last state of the first.

    That state, and the ledger at it, are dropped unless it is at one of the times to be stored.
    """
    at = first.states.times
    kept = np.flatnonzero(np.isin(at, times)).tolist()
    states = States([first.states[i] for i in kept])
    for state in second.states[1:]:
        states.append(state)
    counts = {z: first.statistics.get(z, 0) + count for z, count in second.statistics.items()}
    return replace(
        second,
        states=states,
        events=first.events + second.events,
        statistics=counts,
        message=f"{second.message}; continued from a checkpoint at t = {at[-1]:g} s",
        ledger=_joined_ledger(first.ledger, second.ledger, kept),
        rechoices=first.rechoices + second.rechoices,
        warnings=list(dict.fromkeys(first.warnings + second.warnings)),
    )


def _joined_ledger(
    first: dict[str, list[float]] | None, second: dict[str, list[float]] | None, kept: list[int]
) -> dict[str, list[float]] | None:
    """The ledger of two parts: what the second has dissipated is added to what the first had."""
    if first is None or second is None:
        return None
    joined = {}
    for name, values in second.items():
        before = first[name][-1] if name in SINCE_START else 0.0
        joined[name] = [first[name][i] for i in kept] + [before + z for z in values[1:]]
    return joined
