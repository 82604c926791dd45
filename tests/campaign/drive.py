"""One ride by default settings, held against references: what became of it."""

import time
import warnings
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from unittest import mock

import numpy as np

import flexel as fx
from campaign.accuracy import (
    FACTOR,
    FIRST,
    SECOND,
    SURER,
    Judgement,
    References,
    differ,
    event_times,
    judge,
    passing_times,
    promised,
    references,
    tight,
)
from campaign.ride import Ride
from flexel.base.arrays import Array
from flexel.integration.driver import Run
from flexel.parts.point_contacts import PointContact
from flexel.parts.rope_contacts import RopeContact
from flexel.parts.springs import Stop
from flexel.parts.wheels import Tyre

AGREE, PART, WARNED, REFUSED, UNDECIDED, SILENT = (
    "agree",
    "agree in part",  # of some quantities the references differ
    "warned",
    "refused",
    "undecided",
    "silent error",
)
OUTCOMES = (AGREE, PART, WARNED, REFUSED, UNDECIDED, SILENT)
PATIENCE = 10_000  # steps of one motion
FINE = 5  # times as many steps of the references where something may be stepped over
BRIEF = (PointContact, Stop, RopeContact, Tyre)
FLOOR = 1e-14  # absolute tolerance of references, relative to the amplitude
ROUNDING = 1e-15  # the same, relative to the distance from the origin
LOOSER, SIZE = (
    10.0,
    1e-16,
)  # relative tolerances of references where the tightest fail, and their least absolute one


class TooLongError(BaseException):
    """A motion takes more than `PATIENCE`; not an Exception, which the program may turn into a message of its own."""


@dataclass
class Verdict:
    """What became of a ride.

    Attributes
    ----------
    outcome : str
        One of `OUTCOMES`.
    why : str
        The message of a refusal, why it is undecided, the worst quantity.
    method : str
        That of the motion.
    excess : float
        Largest error over its bound; nan where nothing is decided.
    """

    ride: Ride
    outcome: str
    why: str = ""
    method: str = ""
    excess: float = np.nan
    seconds: float = 0.0
    judgement: Judgement | None = field(default=None, repr=False)


@contextmanager
def patience(steps: int) -> Iterator[None]:
    """Raise TooLongError where the motions within take more than so many steps in all, on every machine alike."""
    left, forward = steps, Run.forward

    def counted(run: Run, most: int = 1) -> str | None:
        nonlocal left
        before = run.taken
        message = forward(run, most)
        left -= run.taken - before
        if left < 0:
            raise TooLongError
        return message

    with mock.patch.object(Run, "forward", counted):
        yield


def driven(ride: Ride) -> Verdict:
    """Simulate a ride by default settings and judge the motion."""
    begun = time.process_time()
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # what a motion knows against itself, it keeps
        verdict = _verdict(ride)
    verdict.seconds = time.process_time() - begun
    return verdict


def _verdict(ride: Ride) -> Verdict:
    """The verdict without its time."""
    duration = ride.case.duration
    try:
        system = ride.built()
        start = ride.case.start(system)
    except fx.FlexelError as error:
        return Verdict(ride, REFUSED, f"build: {_said(error)}")
    try:
        with patience(PATIENCE), warnings.catch_warnings(record=True) as shown:
            warnings.simplefilter("always")
            found = system.simulate(duration, start=start, progress=False)
    except fx.FlexelError as error:
        return Verdict(ride, REFUSED, _said(error))
    except TooLongError:
        return Verdict(ride, UNDECIDED, "the motion takes too long")
    method = found.message.partition("(")[2].partition(",")[0]
    implicit = method in ("Radau", "generalized-alpha")
    try:
        known = _references(ride, system, start, implicit)
    except fx.FlexelError as error:
        return Verdict(ride, UNDECIDED, f"reference: {_said(error)}", method)
    except TooLongError:
        return Verdict(ride, UNDECIDED, "the references take too long", method)
    rtol = promised(found)
    judged = judge(found, known, rtol)
    if ride.watched in judged.names and not np.any(judged.wrong):  # what is fixed passes nothing
        return _watched(ride, system, start, known, judged, method)
    return _concluded(ride, judged, said(shown), method)


def said(shown: Sequence[warnings.WarningMessage]) -> list[str]:
    """What a motion says against its integration; that a beam is bent beyond its range is about the model alone."""
    return [str(entry.message) for entry in shown if not issubclass(entry.category, fx.RangeWarning)]


def floor(ride: Ride) -> float:
    """The absolute tolerance of references."""
    return max(FLOOR * ride.amplitude, ROUNDING * ride.away)


def fine(ride: Ride) -> int:
    """How many times as many steps the references take at least."""
    return FINE if any(isinstance(part, BRIEF) for part in ride.case.parts) else 1


def _concluded(ride: Ride, judged: Judgement, against: Sequence[str], method: str) -> Verdict:
    excess = judged.excess if np.any(judged.decided) else np.nan
    if np.any(judged.wrong):
        outcome = WARNED if against else SILENT
        return Verdict(ride, outcome, "; ".join((judged.worst, *against)), method, excess, 0.0, judged)
    if np.any(judged.undecided):
        i = int(np.flatnonzero(judged.undecided)[0])
        some = f"{np.count_nonzero(judged.undecided)} of {np.count_nonzero(judged.moving)} quantities"
        why = f"references differ by {judged.doubts[i]:.1e} (A {judged.growth[i]:.1e}) in {judged.names[i]}, {some}"
        outcome = PART if np.any(judged.decided) else UNDECIDED
        return Verdict(ride, outcome, why, method, excess, 0.0, judged)
    return Verdict(ride, AGREE, judged.worst, method, excess, 0.0, judged)


def _references(ride: Ride, system: fx.System, start: fx.State, implicit: bool) -> References:
    """References of a motion; looser ones where rounding or stability makes those with the tightest tolerances fail."""
    duration, pieces = ride.case.duration, fine(ride)
    try:
        with patience(3 * PATIENCE):
            return references(system, start, duration, floor(ride), pieces, implicit)
    except (fx.FlexelError, TooLongError) as failure:
        if isinstance(failure, TooLongError) and floor(ride) >= SIZE:
            raise  # looser ones would be as long
    with patience(3 * PATIENCE):
        return references(system, start, duration, max(floor(ride), SIZE), pieces, implicit, LOOSER)


def _watched(
    ride: Ride, system: fx.System, start: fx.State, known: References, judged: Judgement, method: str
) -> Verdict:
    """The verdict where an event is looked for: its times, by default settings and by the references."""
    first, duration = known.first, ride.case.duration
    series = first[ride.watched]
    level = float((np.min(series) + np.max(series)) / 2)
    event = fx.Event("middle", lambda state: state[ride.watched] - level)
    try:
        with patience(3 * PATIENCE), warnings.catch_warnings(record=True) as shown:
            warnings.simplefilter("always")
            found = system.simulate(duration, start=start, progress=False, events=[event])
            times = event_times(found)
            right, again = _passing(ride, system, start, known, event, times.size)
    except fx.FlexelError as error:
        return Verdict(ride, REFUSED, f"event: {_said(error)}", method)
    except TooLongError:
        return Verdict(ride, UNDECIDED, "the references of an event take too long", method)
    i = judged.names.index(ride.watched)
    range_ = float(np.ptp(series))
    fast = float(np.max(np.abs(first.rate(ride.watched)))) / range_ if range_ else 0.0
    bound = FACTOR * promised(found) * judged.growth[i]
    error, doubt = (fast * differ(instants, right) for instants in (times, again))
    if not doubt * SURER <= bound:
        return Verdict(ride, UNDECIDED, f"references of the event differ by {doubt:.1e}", method)
    if not error <= bound:
        outcome = WARNED if said(shown) else SILENT
        return Verdict(ride, outcome, f"event: {error / bound:.2g} times the bound", method, error / bound)
    return _concluded(ride, judged, said(shown), method)


def _passing(
    ride: Ride, system: fx.System, start: fx.State, known: References, event: fx.Event, count: int
) -> list[Array]:
    """Times of an event in both references, between their stored states; by whole motions if there are others."""
    atol, pieces, found = floor(ride), fine(ride), []
    for motion, accuracy in ((known.first, FIRST), (known.second, SECOND)):
        times = passing_times(system, motion, event, accuracy, atol, pieces)
        if times.size != count:
            times = event_times(
                tight(system, start, ride.case.duration, accuracy, atol, pieces, events=[event])
            )
        found.append(times)
    return found


def _said(error: Exception) -> str:
    return f"{type(error).__name__}: {' '.join(str(error).split())}"
