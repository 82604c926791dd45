"""The driver of all integrations: steps until the end, progress bar, interruption, and stored states."""

from __future__ import annotations

import logging
from abc import ABC, abstractmethod
from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np

from flexel.base.arrays import Array
from flexel.base.errors import DampingWarning, FlexelError
from flexel.base.progress import progress_bar, seen
from flexel.integration.event_passages import passages
from flexel.integration.event_samples import EventSample, EventSamples
from flexel.integration.events import Event, value
from flexel.integration.imbalance import Imbalance
from flexel.integration.knots import FORCES, RATES, Knots
from flexel.integration.outcome import Integration, States
from flexel.integration.passed import Passages
from flexel.integration.sampling import Sampling
from flexel.integration.segments import Segment
from flexel.integration.time_scales import TimeScales
from flexel.integration.watchdog import Watchdog
from flexel.model.callbacks import callbacks_of, raise_failures
from flexel.model.snapshot import Snapshot
from flexel.model.state import State
from flexel.system import CoreSystem

log = logging.getLogger("flexel.simulate")
INTERRUPTED = "interrupted"  # begins the message of a motion that Ctrl-C has ended
LOOK_EVERY = 50  # steps, after multiples of which a motion is looked at; see watchdog.py and watch.py
BAR = "{l_bar}{bar}| {n:.3g}/{total:.3g} s [{elapsed}<{remaining}]"


class Run(ABC):
    """A motion being integrated over given times, by any method.

    Attributes
    ----------
    times : ndarray (nt,)
        Times at which states are stored.
    result : Integration
        The results stored so far.
    knots : Knots
        Where prescribed motions and loads are not smooth: every step ends there.
    smooth_since : float
        Time [s] of the last of them, or at which controllers were sampled.
    passed : Passages
        Contacts that were passed within steps.
    events : sequence of Event
    taken : int
        Steps so far.
    over : str or None
        What has ended it before its last time, if anything.
    """

    def __init__(self, system: CoreSystem, start: State, times: Array, events: Sequence[Event]) -> None:
        self.times, self.events = times, events
        self._span = float(times[-1] - times[0])
        self._looks = EventSamples(events, start.t, [value(event, start) for event in events])
        begin, end = float(times[0]), float(times[-1])
        self._scales = TimeScales(system.kinematics.time_functions, begin, end)
        self.knots = Knots(system, begin, end, self._scales.jumps)
        self.result = Integration(States([start]), [], [], {}, "")
        self.sampling = Sampling(start.structure)
        self._callbacks = callbacks_of(start.structure.laws)
        self._jumped: float | None = None  # when controllers were sampled last
        self.smooth_since = float(times[0])
        self._watchdog = Watchdog(start.structure)
        self.passed = Passages(system.evaluation)
        self.taken = 0
        self.over: str | None = None
        self._begun = False

    @property
    @abstractmethod
    def name(self) -> str:
        """Name of the method; empty if nothing is integrated."""

    @property
    @abstractmethod
    def t(self) -> float:
        """Current time of the motion."""

    @property
    @abstractmethod
    def statistics(self) -> dict[str, int]:
        """Counts of operations."""

    @abstractmethod
    def begin(self) -> None:
        """Prepare the first step."""

    def once(self) -> None:
        """Begin, unless the motion has begun already."""
        if not self._begun:
            self._begun = True
            self.begin()

    @abstractmethod
    def advance(self) -> str | None:
        """Take one step; returns a message if the motion ends with it.

        Raises
        ------
        FlexelError
            If the motion cannot be continued.
        """

    @abstractmethod
    def keep(self) -> None:
        """Store the current state, unless it is already stored."""

    def several(self, most: int) -> str | None:
        """Take one or more steps, at most so many; otherwise as `advance`."""
        self.taken += 1
        return self.advance()

    @property
    def stored(self) -> int:
        """How many states are stored."""
        return len(self.result.states)

    @property
    def more_times(self) -> bool:
        """Whether there is another time at which a state is stored."""
        return len(self.result.states) < self.times.size

    @property
    def until(self) -> float:
        """The next time at which a state is stored."""
        return float(self.times[len(self.result.states)])

    @property
    def stop(self) -> float:
        """When the next step ends at the latest: at the end, a knot, or an instant of a sampled controller.

        A knot that only rounding separates from a stored time is at that time.
        """
        end = min(float(self.times[-1]), self.knots.end)
        if self.knots.any and self.more_times and self.knots.near(self.until, end):
            end = self.until
        return min(end, self.sampling.stop(self.t, self.times)) if self.sampling.all else end

    @property
    def latest(self) -> float:
        """When the next step ends at the latest: at a stop, or where it would miss how a function of time varies."""
        return min(self.stop, self._scales.until(self.t)) if self._scales.any else self.stop

    @property
    def step(self) -> float | None:
        """A first step [s] with which the motion can continue from here; None if the method chooses it again."""
        return None

    @property
    @abstractmethod
    def present(self) -> State:
        """The complete state at the current time."""

    @abstractmethod
    def jump(self, z: Array) -> None:
        """Continue from here with other internal states: the right-hand side jumps, the motion does not."""

    @abstractmethod
    def strike(self) -> None:
        """Continue from here with the rates just after an impulse: prescribed rates jump at the current time."""
        self._looks.forget()

    def report_events(self, step: Segment, last: Callable[[], State]) -> tuple[Event, State] | None:
        """Report the events within a step up to the first terminal one; return that and the state there, if any.

        Parameters
        ----------
        step : Segment
        last : callable() -> State
            At its end.
        """
        if not self.events:
            return None
        times = float(self.times[0]), self._span
        found, values = passages(self.events, step, last(), self._looks, times)
        self._looks.note(step.t1, values, found)
        terminal = next((passage for passage in found if passage[0].terminal), None)
        end = terminal[1].t if terminal else step.t1
        for event, state in [passage for passage in found if passage[1].t <= end]:
            log.info("t = %.9g s: event '%s'", state.t, event.name)
            self.result.events.append((event.name, state))
        return terminal

    def begins_with_jump(self) -> bool:
        """Whether the start does not have the prescribed rates: they then jump there, with an impulse."""
        jumps = self.knots.jumps_at(self.result.states[0])
        if jumps:
            log.info("t = %.9g s: prescribed rates jump, since the start does not have them", self.t)
        return jumps

    def _pass_knots(self) -> None:
        """Cross the knot at the current time if there is one, and look for the next."""
        if self.t < self.knots.end and not self.knots.near(self.t, self.knots.end):
            self.knots.look(self.t)
            return
        jumped, self.smooth_since = self.knots.cross(self.t), self.t
        if jumped == RATES:
            log.info("t = %.9g s: prescribed rates jump", self.t)
            self.strike()
        elif jumped == FORCES:
            self.jump(self.instant[1])

    def forward(self, most: int = 1) -> str | None:
        """Cross a knot and sample the controllers if it is time, and take steps as `several` does."""
        if self.knots.any:
            self._pass_knots()
        if self.sampling.all and self.t != self._jumped and self.sampling.due(self.t):
            at, z = self.instant
            self._jumped = self.smooth_since = self.t
            self.jump(self.sampling.after(at, z, lambda: self.present))
        if not self._callbacks:
            return self.several(most)
        try:
            message = self.several(1)
        except FlexelError:
            raise_failures(self._callbacks)
            raise
        for code in self._callbacks:
            code.forget_failure()  # of a trial that was refused
        return message

    def watched(self, most: int) -> None:
        """Go on as `forward` does, under the eyes of the watchdog, and note what has ended the motion."""
        self.over = self.forward(most)
        self._watchdog.look(self)

    @property
    def at_end(self) -> bool:
        """Whether the motion is at its end."""
        return self.over is not None or self.t >= self.times[-1]

    def run(self, progress: bool | None, each: Callable[[Run], None] | None = None) -> Integration:
        """Integrate to the last time.

        Parameters
        ----------
        progress : bool, optional
            Progress bar on stderr; by default where stderr is a terminal.
        each : callable, optional
            Called with the run after each step.
        """
        self.once()
        return self.rest(progress, each)

    def rest(self, progress: bool | None, each: Callable[[Run], None] | None = None) -> Integration:
        """Compute the rest of a motion that has begun, as in `run`."""
        begin, end = float(self.times[0]), float(self.times[-1])
        show = seen(progress, "simulate")
        detailed = log.isEnabledFor(logging.DEBUG)
        bar = progress_bar(show, end - begin, "s", BAR)
        try:
            while self.over is None and self.t < end:
                self.watched(1 if detailed else LOOK_EVERY - self.taken % LOOK_EVERY)
                if detailed:
                    log.debug("step to t = %.9g s", self.t)
                bar.update(self.t - begin - float(bar.n))
                if each is not None:
                    each(self)
        finally:
            bar.close()
        against = self.judge()
        if against:
            self.warn(against)
        return self.kept(self.over or "reached the end")

    def interrupted(self) -> Integration:
        """Return the results so far of a motion that Ctrl-C has ended."""
        found = self.kept(INTERRUPTED)
        return replace(found, message=f"{INTERRUPTED} at t = {found.states.end:g} s")

    def kept(self, message: str) -> Integration:
        """Return the results so far, up to the last step or the event that ended it."""
        self.keep()
        return replace(self.result, message=message, statistics=self.statistics)

    def warn(self, text: str, category: type[Warning] = DampingWarning) -> None:
        """Record evidence against the motion, and issue it once as a Python warning; see `Motion.warnings`."""
        self.result.warn(text, category)

    def imbalance(self) -> Imbalance | None:
        """Return the error of the energy balance of the ended motion; None where nothing was integrated."""
        return None

    def describe_imbalance(self, balance: Imbalance) -> str:
        """Describe the error where the energy balance fails."""
        return (
            f"the energy balance of {self.name} fails by {balance.missing:.2g} J of {balance.moved:.3g} J, most at "
            f"t = {balance.when:.6g} s, {balance.missing / balance.allowed:.2g} times what its tolerance explains; "
            "give a smaller rtol and atol, or a max_step, and check what acts there"
            f"{self.workers_at(balance.when)}"
        )

    def workers_at(self, t: float) -> str:
        """Name what works most at a time [s], after a colon; empty if nothing does, or nothing is known."""
        return ""

    def contradictions(self) -> list[EventSample]:
        """Return what contradicts the events that were reported."""
        result = self.result
        return list(self._looks.contradictions(result.states, result.segments))

    def passages(self) -> Passages:
        """Return the contacts that were passed within steps."""
        return self.passed

    def dangers(self) -> list[str]:
        """Describe positions of the motion in which its digits, or its branch, are not reliable."""
        return []

    def judge(self) -> str | None:
        """Return the evidence of the method against the motion, which has ended; none for most methods."""
        return None

    @property
    @abstractmethod
    def instant(self) -> tuple[Snapshot, Array]:
        """Coordinates, rates and deformations at the current time, and internal states of laws."""

    def go_on(self, until: float) -> None:
        """Continue to another time, from a motion that has ended; what was stored before is dropped."""
        self.times, self.over = np.array([self.t, until]), None
        self.result = self.result.last()

    def so_far(self) -> Integration:
        """Copy the results so far and the current state to separate lists; the run continues unchanged."""
        stored = len(self.result.states)
        found = self.kept("not at its end").copy()
        self.result.cut(stored)
        return found


def ended_by(event: Event) -> str:
    """Return the message of a motion that an event has ended."""
    return f"stopped by event '{event.name}'"
