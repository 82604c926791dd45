"""Forward dynamics in minimal coordinates with SciPy's integrators, with events and a change of coordinates.

The integrator is stepped here, so that after every step the condition of the chosen coordinates can be
looked at, events located on the dense output, and progress shown.  When the coordinates become
ill-conditioned the model is re-parametrized and the integration goes on from the same x and v.
Imports numpy, scipy, tqdm and the dynamics.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from scipy.integrate import BDF, DOP853, LSODA, RK45, Radau
from scipy.optimize import brentq
from tqdm import tqdm

from flexel.errors import DynamicsError, FlexelError, ModelError
from flexel.inputs import array, number
from flexel.roles import Roles
from flexel.state import State
from flexel.structure import Array

METHODS: dict[str, Any] = {"DOP853": DOP853, "RK45": RK45, "Radau": Radau, "BDF": BDF, "LSODA": LSODA}
ILL_CONDITIONED = 0.02  # condition of B or of the position matrix, relative to that at the last choice
BETTER = 4.0  # a new choice must improve the condition by this factor


@dataclass(frozen=True)
class Event:
    """Something that happens when a function of the state passes through zero.

    Parameters
    ----------
    name : str
    function : callable(State) -> float
    terminal : bool
        Stop the simulation there.
    direction : int
        +1: only upward passages; -1: only downward; 0: both.
    """

    name: str
    function: Callable[[State], float]
    terminal: bool = False
    direction: int = 0


@dataclass(frozen=True)
class Segment:
    """A piece of motion with one choice of freedoms and its dense output y(t) = (q, q_d')."""

    t0: float
    t1: float
    roles: Roles
    dense: Any


@dataclass(frozen=True)
class Integration:
    """What an integration gives: states at the asked times, events, pieces with dense output, counts."""

    states: list[State]
    events: list[tuple[str, State]]
    segments: list[Segment]
    statistics: dict[str, int]
    message: str


def stored_times(start: State, duration: Any, times: Any, samples: Any) -> Array:
    """Times at which states are kept, from the start on.

    Raises
    ------
    ModelError
        A duration that is not positive, times that do not increase or lie outside the motion.
    """
    span = number(duration, "simulate", "duration")
    if span <= 0:
        raise ModelError(f"simulate: duration {span:g} s is not positive; give a positive time")
    if times is None:
        if not isinstance(samples, (int, np.integer)) or samples < 2:
            raise ModelError(f"simulate: {samples!r} samples asked for; give a whole number, 2 or more")
        return np.linspace(start.t, start.t + span, int(samples))
    grid = array(times, "simulate", "times")
    if grid.ndim != 1 or not grid.size or np.any(np.diff(grid) <= 0) or grid[0] < start.t:
        raise ModelError(f"simulate: times must be a list that increases from {start.t:g} s; sort them")
    if grid[-1] > start.t + span * (1 + 1e-12):
        raise ModelError(
            f"simulate: time {grid[-1]:g} s lies after the end of the motion, {start.t + span:g} s; lengthen the "
            "duration"
        )
    return np.concatenate([[start.t], grid]) if grid[0] > start.t else grid


def _positive(value: Any, what: str, least: float = 0.0) -> float:
    checked = np.inf if value is np.inf else number(value, "simulate", what)
    if checked <= least:
        raise ModelError(f"simulate: {what} {checked:g} is too small; give more than {least:g}")
    return checked


def _value(event: Event, state: State) -> float:
    return number(event.function(state), f"event '{event.name}' at t = {state.t:g} s", "value")


class Integrator:
    """One run of the forward dynamics of a system."""

    def __init__(
        self,
        system: Any,
        start: State,
        times: Array,
        method: str,
        rtol: float,
        atol: float,
        max_step: float,
        events: Sequence[Event],
        progress: bool | None,
        rechoose: bool,
    ) -> None:
        if not isinstance(method, str) or method not in METHODS:
            raise ModelError(f"simulate: method {method!r} is unknown; choose one of {', '.join(METHODS)}")
        if isinstance(events, Event) or not all(isinstance(z, Event) for z in events):
            raise ModelError(
                f"simulate: events {events!r} are not a list of Events; write [Event(name, function)]"
            )
        self.system = system
        self.times = times
        self.options = {
            "rtol": _positive(rtol, "rtol", 1e-13),
            "atol": _positive(atol, "atol"),
            "max_step": _positive(max_step, "max_step"),
        }
        self.method = METHODS[method]
        self.events = events
        self.rechoose = rechoose
        self.progress = sys.stderr.isatty() if progress is None else progress
        self.state = start
        self.result = Integration([start], [], [], {"steps": 0, "evaluations": 0, "rechoices": 0}, "")

    def run(self) -> Integration:
        """Integrate to the last time; an interrupt (Ctrl-C) keeps what was computed."""
        message = "reached the end"
        bar = tqdm(
            total=float(self.times[-1] - self.times[0]), disable=not self.progress, unit="s", leave=False
        )
        bar.bar_format = "{l_bar}{bar}| {n:.3g}/{total:.3g} s [{elapsed}<{remaining}]"
        try:
            while self.state.t < self.times[-1]:
                stopped = self._segment(bar)
                if stopped:
                    message = f"stopped by event '{stopped}'"
                    break
        except KeyboardInterrupt:
            message = f"interrupted at t = {self.state.t:g} s; the motion up to there is kept"
        finally:
            bar.close()
        r = self.result
        return Integration(r.states, r.events, r.segments, r.statistics, message)

    def _segment(self, bar: Any) -> str | None:
        """Integrate with one choice of freedoms; returns the name of a terminal event, if one occurred."""
        system, roles = self.system, self.system.roles
        y0 = np.concatenate([self.state.q, self.state.qd])
        system.warm(self.state)
        solver = self.method(system.rhs, self.state.t, y0, float(self.times[-1]), **self.options)
        reference = system.condition(self.state)
        values = [_value(event, self.state) for event in self.events]
        statistics = self.result.statistics
        count = 0
        while solver.status == "running":
            message = self._step(solver)
            if solver.status == "failed":
                raise DynamicsError(
                    f"integration failed at t = {solver.t:g} s: {message}; see motion up to there"
                )
            statistics["steps"] += 1
            dense = solver.dense_output()
            t1 = float(solver.t)
            found, values, state = self._events(solver, dense, values)
            terminal = next((z for z in found if self._terminal(z[0])), None)
            end = terminal[1].t if terminal else t1
            self._store(dense, end, roles)
            self.result.events.extend(z for z in found if z[1].t <= end)
            self.result.segments.append(Segment(float(solver.t_old), end, roles, dense))
            bar.update(end - float(solver.t_old))
            self.state = terminal[1] if terminal else state
            if terminal:
                statistics["evaluations"] += solver.nfev
                return terminal[0]
            count += 1
            if self.rechoose and self._rechosen(reference):
                break
        statistics["evaluations"] += solver.nfev
        return None

    def _step(self, solver: Any) -> str | None:
        try:
            message: str | None = solver.step()
        except FlexelError as error:
            note = f"the motion was computed up to t = {solver.t:g} s"
            error.add_note(note)
            raise
        return message

    def _store(self, dense: Any, end: float, roles: Roles) -> None:
        done = len(self.result.states)
        while done < self.times.size and self.times[done] <= end:
            t = float(self.times[done])
            self.result.states.append(self.system.state_from(t, dense(t), roles, self.result.states[-1]))
            done += 1

    def _terminal(self, name: str) -> bool:
        return any(event.terminal for event in self.events if event.name == name)

    def _events(
        self, solver: Any, dense: Any, before: list[float]
    ) -> tuple[list[tuple[str, State]], list[float], State]:
        """Passages through zero within the last step, in the order of time."""
        system, roles, t0, t1 = self.system, self.system.roles, float(solver.t_old), float(solver.t)

        def state(t: float) -> State:
            found: State = system.state_from(t, dense(t), roles, self.state)
            return found

        last = state(t1)
        after = [_value(event, last) for event in self.events]
        found: list[tuple[str, State]] = []
        for event, g0, g1 in zip(self.events, before, after, strict=True):
            if (g0 < 0 <= g1 or g1 <= 0 < g0) and (event.direction == 0 or event.direction * (g1 - g0) > 0):
                t = brentq(lambda z, event=event: event.function(state(z)), t0, t1, xtol=1e-13, rtol=8.9e-16)
                found.append((event.name, state(float(t))))
        return sorted(found, key=lambda z: z[1].t), after, last

    def _rechosen(self, reference: float) -> bool:
        """Take other freedoms if the present ones became ill-conditioned and others are clearly better."""
        system = self.system
        condition = system.condition(self.state)
        if condition > ILL_CONDITIONED * reference:
            return False
        changed = system.rechoose(self.state, BETTER * condition)
        if changed is None:
            return False
        self.state = changed
        self.result.statistics["rechoices"] += 1
        return True
