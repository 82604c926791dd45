"""Checkpoints: the motion so far in a file while a simulation runs, from which an aborted one continues."""

from __future__ import annotations

import json
from dataclasses import dataclass, replace
from hashlib import sha256
from pathlib import Path
from time import monotonic
from typing import Any

import numpy as np

from flexel.base.arguments import path_of
from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.integration.driver import INTERRUPTED, Run
from flexel.integration.methods import Options
from flexel.integration.outcome import Integration, States, from_start
from flexel.integration.simulation import Plan
from flexel.integration.trajectory import Trajectory
from flexel.model.controller import Controller
from flexel.model.rules import LinearRule
from flexel.model.state import State
from flexel.results.analyses.restoring import restored
from flexel.results.saved.archive import integration_of, record_of, roles_in_names
from flexel.results.saved.description import described
from flexel.results.saved.record import Record
from flexel.results.saved.record_files import read, write
from flexel.system import CoreSystem

CHECKPOINT_INTERVAL_S = 30.0  # seconds between two checkpoints
MAX_WRITING_SHARE = 0.05  # share of the time that may be spent on writing them
MARKS = "checkpoint"  # key of the header of their files
PARTS = ("model", "loads and prescribed motions", "start", "stored times", "method and its options")
SINCE_START = ("dissipated", "work")  # energy terms that count from the start of a run


@dataclass(frozen=True)
class EarlierRun:
    """The part of a simulation computed by an earlier process.

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
    system : System
    plan : Plan
        Both identify the simulation: a file of another one is refused.
    """

    def __init__(self, path: str | Path, system: CoreSystem, plan: Plan) -> None:
        self.path = path_of(path, "simulate")
        self._system, self._first = system, float(plan.times[0])
        self._times = from_start(plan.start, plan.times)
        self._marks = _marks(system, plan.start, self._times, plan.method, plan.options)
        self._next = monotonic() + CHECKPOINT_INTERVAL_S
        self._before: Integration | None = None

    def before(self) -> EarlierRun | None:
        """Return the motion in the file, or None if there is no file.

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
                f"simulate: the checkpoint '{self.path}' belongs to another simulation ({', '.join(differing)} "
                "differ); delete it, or give another path"
            )
        self._before = _attached(self._system, record)
        return EarlierRun(self._before, marks["step"], marks["complete"])

    def try_out(self, start: State) -> None:
        """Write a checkpoint of the start and remove it, so that a path that cannot be written fails now.

        Raises
        ------
        FlexelError
            A folder that does not exist or is protected, a full disk, a package that is missing.
        """
        self._write(Integration(States([start]), [], [], {}, ""), None, complete=False, trial=True)

    def __call__(self, run: Run) -> None:
        """Write a checkpoint after a step if the last one is old enough."""
        now = monotonic()
        if now < self._next:
            return
        self._write(self.whole(run.so_far()), run.step, complete=False)
        done = monotonic()
        self._next = done + max(CHECKPOINT_INTERVAL_S, (done - now) / MAX_WRITING_SHARE)

    def end(self, found: Integration, step: float | None) -> None:
        """Write the motion that has ended, which can be continued if it was interrupted."""
        complete = not found.message.startswith(INTERRUPTED)
        self._write(found.since(self._first) if complete else found, step, complete=complete)

    def _write(self, found: Integration, step: float | None, *, complete: bool, trial: bool = False) -> None:
        record = record_of(Trajectory(self._system, found))
        marks = self._marks | {"step": step, "complete": complete}
        marked = replace(record, header={**record.header, MARKS: marks})
        write(marked, self.path, owner="simulate: checkpoint", trial=trial)

    def whole(self, found: Integration) -> Integration:
        """Join the earlier part of the motion with the part that this process has computed."""
        return found if self._before is None else _joined(self._before, found, self._times)


def _marks(system: CoreSystem, start: State, times: Array, method: str, options: Options) -> dict[str, str]:
    """Return digests that identify a simulation, one for each of PARTS.

    Loads and prescribed motions are compared at the first two stored times: functions cannot be compared.
    """
    own = (system.roles.motion, system.loads.values)
    given = [f(t).tolist() for f in own for t in times[:2]]
    begin = [
        start.t,
        *(values.tolist() for values in (start.x, start.v, start.e, start.z)),
        roles_in_names(start),
    ]
    events = [(event.name, event.terminal, event.direction) for event in options.events or ()]
    contents = (
        [described(system.structure), [_settings(c) for c in system.structure.controllers]],
        [system.structure.names[i] for i in system.loads.quantities] + given,
        begin,
        times.tolist(),
        [method, {**vars(options), "events": events}],
    )
    return {part: _digest(content) for part, content in zip(PARTS, contents, strict=True)}


def _settings(c: Controller) -> list[Any]:
    """Return the properties of a controller that can be compared: all but its function."""
    rule = list(vars(c.rule).values()) if isinstance(c.rule, LinearRule) else []
    windup = [] if c.windup is None else [type(c.windup).__name__, *vars(c.windup).values()]
    return [c.name, c.inputs, c.outputs, c.period, c.delay, c.low, c.high, rule, windup]


def _digest(contents: Any) -> str:
    return sha256(json.dumps(contents, default=_plain).encode()).hexdigest()


def _plain(value: Any) -> Any:
    """Convert numbers of NumPy to lists; convert an option that is not a number, and is refused later, to text."""
    return value.tolist() if isinstance(value, np.ndarray | np.generic) else repr(value)


def _attached(system: CoreSystem, record: Record) -> Integration:
    """Return the motion in a record, with states of the system."""
    found = integration_of(record)
    return replace(
        found,
        states=States([restored(system, state) for state in found.states]),
        events=[(name, restored(system, state)) for name, state in found.events],
    )


def _joined(first: Integration, second: Integration, times: Array) -> Integration:
    """Join two parts of a motion; the second starts from the last state of the first.

    That state, and the energy terms at it, are dropped unless it is at one of the times to be stored.
    """
    at = first.states.times
    kept = np.flatnonzero(np.isin(at, times)).tolist()
    states = States([first.states[i] for i in kept])
    for state in second.states[1:]:
        states.append(state)
    counts = {name: first.statistics.get(name, 0) + count for name, count in second.statistics.items()}
    return replace(
        second,
        states=states,
        events=first.events + second.events,
        statistics=counts,
        message=f"{second.message}; continued from a checkpoint at t = {at[-1]:g} s",
        energy_terms=_joined_terms(first.energy_terms, second.energy_terms, kept),
        rechoices=first.rechoices + second.rechoices,
        warnings=list(dict.fromkeys(first.warnings + second.warnings)),
        verdict=f"since the checkpoint {second.verdict}" if second.verdict else "",
    )


def _joined_terms(
    first: dict[str, list[float]] | None, second: dict[str, list[float]] | None, kept: list[int]
) -> dict[str, list[float]] | None:
    """Join the energy terms of two parts: what the first has dissipated is added to what the second has."""
    if first is None or second is None:
        return None
    joined = {}
    for name, values in second.items():
        before = first[name][-1] if name in SINCE_START else 0.0
        joined[name] = [first[name][i] for i in kept] + [before + value for value in values[1:]]
    return joined
