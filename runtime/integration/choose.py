"""The method that `simulate` chooses by itself, at the start of a motion and during it."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from flexel.base.errors import FlexelError
from flexel.integration.dop853 import Dop853
from flexel.integration.excitation import followed
from flexel.integration.methods import IMPLICIT_RTOL, Options, has_rates, rtol_of
from flexel.integration.minimal import MinimalRun
from flexel.integration.radau import Radau
from flexel.integration.radau_saddle import sparse
from flexel.integration.step_method import StepMethod
from flexel.integration.stiffness import ALPHA, EXPLICIT, RADAU, few, smooth, stiff, suitable
from flexel.integration.trial import Budget, explicit_evaluations, implicit_evaluations
from flexel.model.state import State
from flexel.system import CoreSystem

PER_RADIAN, ORDER = (
    48.0,
    5,
)  # evaluations of Radau in a radian of what it follows, at rtol = 1e-6; and its order
LINEAR = (
    17.0  # degrees of freedom for which the linear algebra of a step of Radau costs as much as one evaluation
)
SPARSE = 6.0  # the same with sparse factors, in evaluations: 4 to 8 whatever the size
FEW = 300.0  # radians of the fastest mode that DOP853 follows in no time
TRIAL = 0.05  # of the cost of DOP853, that a trial of Radau may take: motions may begin with a transient
MOST = 20_000  # evaluations that it may take
CHEAPER = (
    2.0  # times that Radau must need fewer evaluations: a motion may become more lively than at its start
)
MUCH_CHEAPER = 20.0  # the same at a looser tolerance than that of the motion so far
LONGER = 4.0  # times its budget, which a trial at the start may take while a transient dies out
SOON = 200  # steps after which a motion is linearized if its start cannot be


class Way(NamedTuple):
    """Options of Radau, and by what factor it must need fewer evaluations with them."""

    options: Options
    factor: float


class Chosen(NamedTuple):
    """The method for a motion.

    Attributes
    ----------
    method : str
    why : str
        The method and why it was chosen; empty if it was named.
    options : Options
        With the tolerance that was chosen for it.
    run : MinimalRun or None
        The motion as far as it was tried.
    """

    method: str
    why: str
    options: Options
    run: MinimalRun | None = None


Prepared = Callable[[Options, type[StepMethod]], MinimalRun]  # a motion by some method, which has not begun


def automatic(
    system: CoreSystem, start: State, duration: float, options: Options, prepared: Prepared
) -> Chosen:
    """Choose the method for a motion.

    Parameters
    ----------
    system : CoreSystem
    start : State
    duration : float
        [s]
    options : Options
        Those that the user has given.
    prepared : callable(options, kind) -> MinimalRun
        Prepares the motion by a method; it is tried, and goes on if that method is chosen.
    """
    if not duration:
        return Chosen(EXPLICIT, "nothing to integrate: only the start is stored", options)
    if system.roles.actuated and system.roles.nq:
        return Chosen(EXPLICIT, f"{EXPLICIT}, chosen because actuators hold a path", options)
    if system.roles.nq == 0:
        alone = "only internal states are integrated" if has_rates(system.structure) else "not integrated"
        return Chosen(EXPLICIT, f"{alone}: every motion is prescribed", options)
    found = suitable(system, start)
    if found.method == EXPLICIT:  # as where a law has an infinite derivative at the start
        start = _soon(prepared(options, Dop853), start)
        found = suitable(system, start)
    if found.method:
        return _because(found.method, found.why, options)
    is_stiff, why = (True, found.why) if found.is_large else stiff(system, start, found, duration)
    suits = few(system) if is_stiff else smooth(system)
    if (found.is_large or float(found.rates.max(initial=0.0)) * duration > FEW) and suits:
        run = prepared(options, Dop853)
        count = explicit_evaluations(run)
        turns = 0.0 if found.is_large else followed(system, start, found.matrix, duration)
        least = min(TRIAL * count, MOST)
        won = cheaper(
            lambda some: prepared(some, Radau),
            _ways(options, is_stiff),
            count,
            Budget(least, LONGER * least),
            linear_algebra(system),
            turns,
        )
        if won is not None:
            return _because(RADAU, f"{fewer(won.options)}; {why}", *won)
        if np.isfinite(count):
            lost = f"{why}; {RADAU} would not take fewer evaluations" if is_stiff else why
            return _because(EXPLICIT, lost, options, run)
    return _because(ALPHA if is_stiff else EXPLICIT, why, options)


def _ways(options: Options, is_stiff: bool) -> list[Way]:
    """Return ways of Radau for a whole motion, the most accurate first.

    In stiff motions it may ignore vibrations that are small beside the largest motion, and take a looser tolerance if
    none is given.
    """
    if not is_stiff:
        return [Way(options, CHEAPER)]
    loose = _loosely(options)
    every = [Way(options, CHEAPER), Way(replace(options, minor=1.0), CHEAPER), Way(loose, 1.0)]
    return [*every, Way(replace(loose, minor=1.0), 1.0)]


def later_ways(options: Options) -> list[Way]:
    """Return ways of Radau for the rest of a motion, which has been more accurate so far."""
    return [Way(options, CHEAPER), Way(replace(_loosely(options), minor=1.0), MUCH_CHEAPER)]


def _loosely(options: Options) -> Options:
    """Return options with the tolerance of stiff motions, if none is given."""
    return options if options.rtol is not None else replace(options, rtol=IMPLICIT_RTOL)


class Won(NamedTuple):
    """Options with which Radau takes fewer evaluations, and the motion as far as it was tried."""

    options: Options
    run: MinimalRun


def cheaper(
    prepared: Callable[[Options], MinimalRun],
    ways: Sequence[Way],
    explicit: float,
    budget: Budget,
    more: float,
    turns: float = 0.0,
) -> Won | None:
    """Return the first way in which Radau takes fewer evaluations than DOP853; None if there is none.

    If the most accurate way is none, the least accurate one is tried next: the others take more evaluations than that.

    Parameters
    ----------
    prepared : callable(options) -> MinimalRun
        Prepares the motion by Radau.
    ways : sequence of Way
        The most accurate first.
    explicit : float
        Evaluations that DOP853 takes.
    budget : Budget
        Evaluations that each trial takes.
    more : float
        Those that cost as much as the linear algebra of a step.
    turns : float
        Radians that any method must follow.
    """

    def tried(way: Way) -> Won | None:
        run, wanted = prepared(way.options), explicit / way.factor
        least = turns * PER_RADIAN * (IMPLICIT_RTOL / run.tolerances.rtol) ** (1 / ORDER)
        wins = least < wanted and implicit_evaluations(run, more, budget, wanted) < wanted
        return Won(way.options, run) if wins else None

    first, *others = ways
    won = tried(first)
    if won is not None or not others:
        return won
    last = tried(others[-1])
    if last is None:
        return None
    return next(filter(None, map(tried, others[:-1])), last)


def linear_algebra(system: CoreSystem) -> float:
    """Return the evaluations that cost as much as the linear algebra of a step of Radau."""
    return SPARSE if sparse(system.kinematics) else system.roles.nd / LINEAR


def fewer(options: Options) -> str:
    """Say why Radau is chosen, with its tolerance."""
    return f"it takes fewer evaluations than {EXPLICIT} at rtol = {rtol_of(options):g}"


def _soon(run: MinimalRun, start: State) -> State:
    """Return a state of a motion a few steps after its start; the start itself if there is none."""
    try:
        run.once()
        while run.taken < SOON and not run.at_end:
            run.watched(1)
        return run.present
    except FlexelError:
        return start


def _because(method: str, why: str, options: Options, run: MinimalRun | None = None) -> Chosen:
    return Chosen(method, f"{method}, chosen because {why}", options, run)
