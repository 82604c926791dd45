"""Forward dynamics in minimal coordinates with SciPy's integrators, with events and a change of coordinates.

The integrator is stepped here, so that after every step the condition of the chosen coordinates can be
looked at, events located on the dense output, and progress shown.  When the coordinates become
ill-conditioned the model is re-parametrized and the integration goes on from the same x and v.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from scipy.integrate import BDF, DOP853, LSODA, RK45, Radau
from scipy.optimize import brentq
from tqdm import tqdm

from flexel.base.arguments import array, number, step_limit
from flexel.base.arrays import Array
from flexel.base.errors import ConstraintError, DynamicsError, FlexelError, ModelError, PositionError
from flexel.mechanics.states import Moment, between, state_of
from flexel.structure.roles import Roles
from flexel.structure.state import State
from flexel.structure.structure import Structure

METHODS: dict[str, Any] = {"DOP853": DOP853, "RK45": RK45, "Radau": Radau, "BDF": BDF, "LSODA": LSODA}
ILL_CONDITIONED = 0.25  # condition of B or of the position matrix, relative to that at the last choice
SHORTEST = 1e-8  # first step, relative to the times, below which a position counts as out of reach
FIRST = 1e-4  # first step, relative to the time left, after one that was out of reach
MOST_SHORT = 100  # steps of that length in a row before the integration gives up
RETRY = "out of reach"
TRAVEL = 1.0  # of an Euler parameter in one step: more than two radians could lead to another branch or turn
INSTANT = 1e-9  # of the times: an event that is found this soon is the one that the motion starts from
LOCATED = 1e-13  # accuracy of the time of an event [s]
BETTER = 1.5  # a new choice must improve the condition by this factor


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

    Notes
    -----
    A motion that starts at an event, such as from its state, does not meet it again at once.
    """

    name: str
    function: Callable[[State], float]
    terminal: bool = False
    direction: int = 0

    def __post_init__(self) -> None:
        if not callable(self.function):
            raise ModelError(
                f"event '{self.name}': {self.function!r} is no function; give one of a State, lambda s: s['A.z']"
            )
        if self.direction not in (-1, 0, 1):
            raise ModelError(
                f"event '{self.name}': direction {self.direction!r} is unknown; give 1 (up), -1 (down) or 0 (both)"
            )


@dataclass(frozen=True)
class Segment:
    """A step of the integration: its choice of freedoms, its dense output y(t) = (q, q_d', z) and its ends."""

    t0: float
    t1: float
    roles: Roles
    dense: Any
    first: Moment
    last: Moment

    def state(self, system: Any, t: float) -> State:
        """Complete state at a time within the step."""
        q, qd, z = np.split(self.dense(t), [self.roles.nq, self.roles.nq + self.roles.nd])
        near = between(self.first, self.last, t)
        return state_of(system.kinematics_of(self.roles), system.loads, t, q, qd, z, near)


@dataclass(frozen=True)
class Integration:
    """What an integration gives: states at the asked times, events, pieces with dense output, counts.

    An implicit one also gives its energy ledger at these times, and says whether it reached the end.
    """

    states: list[State]
    events: list[tuple[str, State]]
    segments: list[Segment]
    statistics: dict[str, int]
    message: str
    ledger: dict[str, list[float]] | None = None
    complete: bool = True


def stored_times(start: State, duration: Any, times: Any, samples: Any, owner: str) -> Array:
    """Times at which states are kept, from the start on.

    Raises
    ------
    ModelError
        A duration that is not positive, times that do not increase or lie outside the motion.
    """
    span = number(duration, owner, "duration")
    if span <= 0:
        raise ModelError(f"{owner}: duration {span:g} s is not positive; give a positive time")
    if times is None:
        if not isinstance(samples, (int, np.integer)) or samples < 2:
            raise ModelError(f"{owner}: {samples!r} samples asked for; give a whole number, 2 or more")
        return np.linspace(start.t, start.t + span, int(samples))
    grid = array(times, owner, "times")
    if grid.ndim != 1 or not grid.size or np.any(np.diff(grid) <= 0) or grid[0] < start.t:
        raise ModelError(f"{owner}: times must be a list that increases from {start.t:g} s; sort them")
    if grid[-1] > start.t + span * (1 + 1e-12):
        raise ModelError(
            f"{owner}: time {grid[-1]:g} s lies after the end of the motion, {start.t + span:g} s; lengthen the "
            "duration"
        )
    return np.concatenate([[start.t], grid]) if grid[0] > start.t else grid


def _value(event: Event, state: State) -> float:
    return number(event.function(state), f"event '{event.name}' at t = {state.t:g} s", "value")


def turning_weights(structure: Structure) -> Array:
    """Weights (n,) that pick the coordinates of orientations: one for Euler parameters, half for planar angles."""
    weight = {"-": 1.0, "rad": 0.5}
    return np.array([weight.get(unit, 0.0) for unit in structure.units[structure.m + structure.k :]])


def longest_step(state: State, weights: Array) -> float:
    """Time [s] in which an orientation travels by TRAVEL, at the present rates and accelerations."""
    v, a = (float(np.max(np.abs(z) * weights, initial=0.0)) for z in (state.v, state.a))
    return 2 * TRAVEL / max(v + float(np.sqrt(v * v + 2 * a * TRAVEL)), 1e-300)


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
            "rtol": step_limit(rtol, "simulate", "rtol", 1e-13),
            "atol": step_limit(atol, "simulate", "atol"),
            "max_step": step_limit(max_step, "simulate", "max_step"),
        }
        self.method = METHODS[method]
        self.events = events
        self.rechoose = rechoose
        self.progress = sys.stderr.isatty() if progress is None else progress
        self.state = start
        self._end = Moment.of(start)
        self._first_step: float | None = None
        self._values: list[float] = []
        self._short = 0
        self._turning = turning_weights(system.structure)
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
                    message = f"stopped by event '{stopped.name}'"
                    return self.kept(message)
        except KeyboardInterrupt:
            kept = self.kept("")
            message = f"interrupted at t = {kept.states[-1].t:g} s; the motion up to there is kept"
        finally:
            bar.close()
        return replace(self.result, message=message)

    def kept(self, message: str, complete: bool = True) -> Integration:
        """What has been computed, up to the last step or the event that ended it."""
        if self.state.t > self.result.states[-1].t:
            self.result.states.append(self.state)
        return replace(self.result, message=message, complete=complete)

    def _segment(self, bar: Any) -> Event | None:
        """Integrate with one choice of freedoms; returns the terminal event, if one occurred."""
        system, roles = self.system, self.system.roles
        y0 = np.concatenate([self.state.q, self.state.qd, self.state.z])
        system.warm(self.state)
        options = self.options | {"max_step": self._longest()}
        if self._first_step:
            options["first_step"] = min(self._first_step, options["max_step"])
        solver = self._solver(y0, options)
        reference = system.condition(self.state)
        self._values = [_value(event, self.state) for event in self.events]
        stopped: Event | None = None
        while solver.status == "running" and stopped is None:
            solver.max_step = self._longest()
            message = self._step(solver)
            if message == RETRY:
                break
            if solver.status == "failed":
                raise DynamicsError(
                    f"integration failed at t = {solver.t:g} s: {message}; {self._trouble(roles)}"
                )
            stopped = self._accept(solver, roles, bar)
            if stopped is None and self.rechoose and self._rechosen(reference):
                break
        self.result.statistics["evaluations"] += solver.nfev
        return stopped

    def _solver(self, y0: Array, options: dict[str, float]) -> Any:
        """A SciPy solver; with a short first step where the one that it tries by itself leads out of reach."""
        begin = self.system.rhs, self.state.t, y0, float(self.times[-1])
        try:
            return self.method(*begin, **options)
        except (PositionError, ConstraintError):
            if "first_step" in options:
                raise
            self.system.warm(self.state)
            short = min(FIRST * (begin[-1] - begin[1]), options["max_step"])
            return self.method(*begin, **options, first_step=short)

    def _accept(self, solver: Any, roles: Roles, bar: Any) -> Event | None:
        """Keep what the last step gave; returns a terminal event within it."""
        system, t0, t1 = self.system, float(solver.t_old), float(solver.t)
        dense = solver.dense_output()
        q, qd, z = np.split(dense(t1), [roles.nq, roles.nq + roles.nd])
        near = replace(Moment.of(self.state), x=system.position_guess)
        state = state_of(system.kinematics_of(roles), system.loads, t1, q, qd, z, near)
        step = Segment(t0, t1, roles, dense, self._end, Moment.of(state))
        found, self._values = self._events(step, state, self._values)
        terminal = next((z for z in found if z[0].terminal), None)
        end = terminal[1].t if terminal else t1
        self._store(step, end)
        self.result.events.extend((event.name, z) for event, z in found if z.t <= end)
        self.result.segments.append(replace(step, t1=end))
        self.result.statistics["steps"] += 1
        self._end = step.last
        bar.update(end - t0)
        self.state = terminal[1] if terminal else state
        short = t1 - t0 < SHORTEST * float(np.ptp(self.times)) and t1 < self.times[-1]
        self._short = self._short + 1 if short else 0
        if self._short > MOST_SHORT:
            raise DynamicsError(f"the steps have become too short at t = {t1:g} s; {self._trouble(roles)}")
        return terminal[0] if terminal else None

    def _trouble(self, roles: Roles) -> str:
        """What may be the matter where the integration cannot go on."""
        names = self.system.kinematics.names
        driven = f", check what drives {names(roles.prescribed)}" if roles.prescribed.size else ""
        return (
            f"freedoms {names(roles.dynamic)}, condition {self.system.condition(self.state, roles):.2g}: the motion is "
            "not smooth there, or the position is singular (gimbal lock of frames without inertia); give those frames "
            f"inertia, choose other freedoms{driven}, or end the motion before {self.state.t:g} s"
        )

    def _longest(self) -> float:
        """Longest step [s] in which no frame turns farther than a position can be followed."""
        return min(self.options["max_step"], longest_step(self.state, self._turning))

    def _step(self, solver: Any) -> str | None:
        """One step; RETRY where a stage led out of reach, so that a shorter first step is to be tried."""
        try:
            message: str | None = solver.step()
        except (PositionError, ConstraintError) as error:
            tried = float(getattr(solver, "h_abs", None) or 1e-3 * (solver.t_bound - solver.t))
            self._first_step = min(tried, self._first_step or np.inf) / 8
            if self._first_step < SHORTEST * max(abs(solver.t_bound), float(np.ptp(self.times))):
                error.add_note(f"the motion was computed up to t = {solver.t:g} s")
                raise
            return RETRY
        except FlexelError as error:
            error.add_note(f"the motion was computed up to t = {solver.t:g} s")
            raise
        self._first_step = None
        return message

    def _store(self, step: Segment, end: float) -> None:
        done = len(self.result.states)
        while done < self.times.size and self.times[done] <= end:
            self.result.states.append(step.state(self.system, float(self.times[done])))
            done += 1

    def _events(
        self, step: Segment, last: State, before: list[float]
    ) -> tuple[list[tuple[Event, State]], list[float]]:
        """Passages through zero within the last step, in the order of time, and the functions at its end."""
        after = [_value(event, last) for event in self.events]
        found: list[tuple[Event, State]] = []
        begun = float(self.times[0]) + INSTANT * float(np.ptp(self.times)) + 10 * LOCATED
        for event, g0, g1 in zip(self.events, before, after, strict=True):
            if (g0 < 0 <= g1 or g1 <= 0 < g0) and (event.direction == 0 or event.direction * (g1 - g0) > 0):
                ends = {step.t0: g0, step.t1: g1}  # as found before, so that brentq sees the same signs

                def function(t: float, event: Event = event, ends: dict[float, float] = ends) -> float:
                    return ends[t] if t in ends else _value(event, step.state(self.system, t))

                t = float(brentq(function, step.t0, step.t1, xtol=LOCATED, rtol=8.9e-16))
                if t > begun:
                    found.append((event, step.state(self.system, t)))
        return sorted(found, key=lambda z: z[1].t), after

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
