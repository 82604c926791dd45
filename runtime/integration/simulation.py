"""Plans a motion: its method, start, stored times and options; begins it, and ends it with its verdict."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from flexel.base.arguments import flag
from flexel.base.arrays import Array
from flexel.base.errors import RangeWarning
from flexel.integration import methods
from flexel.integration.audit import audited
from flexel.integration.choose import automatic
from flexel.integration.consistent import check_rates
from flexel.integration.driver import Run
from flexel.integration.events import Event, checked
from flexel.integration.minimal import MinimalRun
from flexel.integration.outcome import Integration, from_start, stored_times
from flexel.integration.ranges import outside
from flexel.mechanics.internal_dynamics import check_stable
from flexel.mechanics.ranges import compared
from flexel.model.state import State
from flexel.system import CoreSystem


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
) -> tuple[str, str, State, Array, methods.Options]:
    """Plan a motion: its method and the reason, the start, the stored times and the options."""
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
    if method != methods.AUTO:
        return method, "", begin, grid, options
    chosen, why, options = automatic(system, begin, float(duration), options)
    return chosen, why, begin, grid, options


def begun(system: CoreSystem, duration: float, before: Run | None = None, **given: Any) -> tuple[Run, str]:
    """Begin a motion, and return why its method was chosen; reuses the arrays of one with the same options."""
    method, why, begin, grid, options = planned(system, duration, **given)
    run = methods.run_of(system, method, begin, from_start(begin, grid), float(duration), options)
    if run.times[-1] > run.times[0]:
        if isinstance(run, MinimalRun) and isinstance(before, MinimalRun):
            run.method.reuse(before.method)
        run.begin()
    return run, why


def ended(system: CoreSystem, run: Run, why: str, times: Array) -> Integration:
    """Continue a begun motion to its end; return the states at the times from the first of these on."""
    found = run.kept("reached the end") if run.t >= run.times[-1] else run.rest(False)
    found = audited_run(system, run, found, times)
    return explained(found, why).since(float(times[0]))


def explained(found: Integration, *why: str) -> Integration:
    """Return the result, with a message on how the method was chosen and what was found about the motion."""
    reasons = "; ".join(text for text in (*why, *found.warnings, found.verdict) if text)
    return replace(found, message=f"{found.message} ({reasons})") if reasons else found


def audited_run(system: CoreSystem, run: Run, found: Integration, times: Array) -> Integration:
    """Return the result with its verdict, and warnings of quantities outside the range of laws and elements."""
    stored = found.since(float(times[0])).states
    beyond = outside(system, stored)
    if beyond:
        found.warn("; ".join(beyond), RangeWarning, "")
    elements = compared(system.evaluation, stored.times, stored.deformations, stored.coordinates)
    for text in elements.texts:
        found.warn(text, RangeWarning)
    found = audited(system, run, found)
    if np.isnan(elements.share):
        return found
    told = f"elements at {100 * elements.share:.3g} % of their ranges at most"
    return replace(found, verdict="; ".join(filter(None, (found.verdict, told))))
