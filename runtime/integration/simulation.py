"""Plans a motion: its method, start, stored times and options; begins it, and ends it with its verdict."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np

from flexel.base.arguments import flag
from flexel.base.arrays import Array
from flexel.base.errors import AuditWarning, RangeWarning
from flexel.integration import methods
from flexel.integration.audit import audited
from flexel.integration.choose import Chosen, automatic
from flexel.integration.consistent import check_rates
from flexel.integration.driver import Run
from flexel.integration.events import Event, checked
from flexel.integration.minimal import MinimalRun
from flexel.integration.outcome import Integration, from_start, stored_times
from flexel.integration.ranges import outside
from flexel.integration.step_method import StepMethod
from flexel.integration.watch import Watch, watch_of
from flexel.integration.wheels_flat import fallen
from flexel.mechanics.internal_dynamics import check_stable
from flexel.mechanics.ranges import compared
from flexel.model.state import State
from flexel.system import CoreSystem


class Plan(NamedTuple):
    """What was asked for, checked.

    Attributes
    ----------
    method : str
    start : State
    times : ndarray (nt,)
        At which states are stored [s].
    duration : float
        [s]
    options : Options
    """

    method: str
    start: State
    times: Array
    duration: float
    options: methods.Options

    @property
    def ahead(self) -> Array:
        """The stored times from the start on [s]."""
        return self.times[self.times >= self.start.t]

    @property
    def left(self) -> float:
        """Time from the start to the end [s]."""
        return float(self.times[-1]) - self.start.t

    def onwards(self, start: State, step: float | None) -> Plan:
        """Return the rest of the plan, from a later state on, with a first step [s]."""
        return self._replace(start=start, options=self.options.with_first(step))


def planned(
    system: CoreSystem,
    duration: float,
    *,
    start: State | None = None,
    times: Sequence[float] | Array | None = None,
    samples: int = 201,
    method: str = methods.AUTO,
    max_step: float = np.inf,
    events: Sequence[Event] = (),
    rechoose: bool | None = None,
    **given: Any,
) -> Plan:
    """Check what is asked for of a motion, and find its start and the stored times."""
    if rechoose is not None:
        flag(rechoose, "simulate", "rechoose")
    unlimited = isinstance(max_step, float) and max_step == np.inf
    longest = None if unlimited else max_step
    options = methods.Options(max_step=longest, events=checked(events) or None, rechoose=rechoose, **given)
    methods.check(method, options)
    begin = methods.start_of(system, method, start, options)
    grid = stored_times(begin, duration, times, samples, "simulate")
    check_stable(system.kinematics, begin, float(duration))
    check_rates(system, begin.t, begin.t + float(duration))
    return Plan(method, begin, grid, float(duration), options)


class Preparation:
    """Chooses the method of a motion and prepares it.

    Attributes
    ----------
    run : Run or None
        The motion, which has begun if its method was tried; None before.
    why : str
        The method and why it was chosen; empty if it was named.
    watch : Watch or None
        Looks at the motion, where its method may turn out to be the wrong one.
    """

    def __init__(self, system: CoreSystem, plan: Plan) -> None:
        self._system, self._plan = system, plan
        self.run: Run | None = None
        self.why = ""
        self.watch: Watch | None = None

    def chosen(self) -> Run:
        """Choose the method, and return the motion; while methods are tried, `run` is what was tried last."""
        system, plan = self._system, self._plan
        made = Chosen(plan.method, "", plan.options)
        if plan.method == methods.AUTO:
            made = automatic(system, plan.start, plan.left, plan.options, self._minimal)
        self.why, self.watch = made.why, watch_of(system, plan.method, made.method, plan.options)
        self.run = run = made.run or self._of(made.method, made.options)
        if self.watch is not None and isinstance(run, MinimalRun):
            run.stuck = self.watch.stuck
        return run

    @property
    def found(self) -> str:
        """What was found about the motion on the way."""
        return self.watch.found if self.watch else ""

    def _of(self, method: str, options: methods.Options) -> Run:
        plan = self._plan
        times = from_start(plan.start, plan.ahead)
        return methods.run_of(self._system, method, plan.start, times, plan.duration, options)

    def _minimal(self, options: methods.Options, kind: type[StepMethod]) -> MinimalRun:
        self.run = run = self._of(kind.name, options)
        assert isinstance(run, MinimalRun)  # `automatic` tries no others
        return run


def begun(system: CoreSystem, duration: float, before: Run | None = None, **given: Any) -> Preparation:
    """Begin a motion; reuses the arrays of one with the same options."""
    found = Preparation(system, planned(system, duration, **given))
    run = found.chosen()
    if run.times[-1] > run.times[0]:
        if isinstance(run, MinimalRun) and isinstance(before, MinimalRun):
            run.method.reuse(before.method)
        run.once()
    return found


def ended(system: CoreSystem, motion: Preparation, times: Array) -> Integration:
    """Continue a begun motion to its end; return the states at the times from the first of these on."""
    run = motion.run
    assert run is not None
    found = run.kept("reached the end") if run.t >= run.times[-1] else run.rest(False, motion.watch)
    found = audited_run(system, run, found, times)
    return explained(found, motion.why, motion.found).since(float(times[0]))


def explained(found: Integration, *why: str) -> Integration:
    """Return the result, with a message on how the method was chosen and what was found about the motion."""
    reasons = "; ".join(text for text in (*why, *found.warnings, found.verdict) if text)
    return replace(found, message=f"{found.message} ({reasons})") if reasons else found


def audited_run(system: CoreSystem, run: Run, found: Integration, times: Array) -> Integration:
    """Return the result with its verdict, and warnings of what is outside the range of laws, elements and wheels."""
    stored = found.since(float(times[0])).states
    beyond = outside(system, stored)
    if beyond:
        found.warn("; ".join(beyond), RangeWarning, "")
    at, x = stored.times, stored.coordinates
    elements = compared(system.evaluation, at, stored.deformations, x)
    for text in elements.texts:
        found.warn(text, RangeWarning)
    for text in fallen(system.structure, at, x):
        found.warn(text, AuditWarning)
    found = audited(system, run, found)
    if np.isnan(elements.share):
        return found
    told = f"elements at {100 * elements.share:.3g} % of their ranges at most"
    return replace(found, verdict="; ".join(filter(None, (found.verdict, told))))
