"""Finds events within a step: zero crossings of functions of the state, located on the dense output."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache, partial

import numpy as np

from flexel.base.errors import FlexelError
from flexel.integration.crossings import LOCATED, crossings
from flexel.integration.event_samples import EventSamples
from flexel.integration.events import Event, value
from flexel.integration.segments import Segment
from flexel.model.state import State

INSTANT = 1e-9  # relative to the times: an event found within this time is the one at which the motion starts


def passages(
    events: Sequence[Event],
    step: Segment,
    last: State,
    samples: EventSamples,
    times: tuple[float, float],
) -> tuple[list[tuple[Event, State]], list[float]]:
    """Find the zero crossings within a step, in the order of time, and the functions at its end.

    A function that is further from zero at both ends than it can change within the step, as fast as it changed
    lately, does not cross it.  Any other is sampled within the step.  Where its size has a minimum between samples,
    the minimum is searched for, so that two crossings between two samples are found too.

    Parameters
    ----------
    events : sequence of Event
    step : Segment
    last : State
        At the end of the step.
    samples : EventSamples
        The functions at the ends of the steps before.
    times : tuple of float
        When the motion started, and its duration [s].
    """
    after = [value(event, last) for event in events]
    found: list[tuple[Event, State]] = []
    begun = times[0] + INSTANT * times[1] + 10 * LOCATED
    at, near = cache(step.state), cache(partial(_near, step))  # shared by all events
    for number, (event, g0, g1) in enumerate(zip(events, samples.values, after, strict=True)):
        if g0 * g1 > 0 and min(abs(g0), abs(g1)) > samples.travel(number, step.t1, g1):
            continue
        ends = {step.t0: g0, step.t1: g1}  # the values found before, so that all see the same signs

        def function(t: float, event: Event = event) -> float:
            return value(event, at(t))

        def about(t: float, event: Event = event) -> float:
            state = near(t)
            return np.nan if state is None else value(event, state)

        for t in crossings(function, about, ends, event.direction):
            if t > begun:
                found.append((event, at(t)))
            else:
                samples.starts_at(number, t)
    return sorted(found, key=lambda passage: passage[1].t), after


def _near(step: Segment, t: float) -> State | None:
    """Return a state near that at a time within a step; None if there is none, as near a singular position."""
    try:
        return step.roughly(t)
    except FlexelError:
        return None
