"""Looks at a motion by DOP853 or Radau: where the other one is faster it goes on with that, or a warning names it."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from flexel.base.errors import FlexelError, StiffWarning
from flexel.integration.choose import CHEAPER, cheaper, fewer, later_ways, linear_algebra
from flexel.integration.dop853 import Dop853
from flexel.integration.driver import Run
from flexel.integration.methods import AUTO, Options, tolerances_of
from flexel.integration.minimal import MinimalRun
from flexel.integration.outcome import issue
from flexel.integration.radau import Radau
from flexel.integration.stiffness import (
    ALPHA,
    EXPLICIT,
    RADAU,
    RIGID,
    SPREAD,
    STIFF,
    Suitable,
    few,
    suitable,
)
from flexel.integration.trial import Budget, explicit_evaluations
from flexel.system import CoreSystem

LOOK = 1000  # steps after which a motion is looked at, and again after twice as many: short motions cost nothing more
SHARE = 0.02  # of the evaluations so far, that each trial of Radau takes, but at least as many as `trial.STEPS` need
APART = 1e-5  # share of the times, within which steps that are too short again show a singularity
LONG = 4 * LOOK  # steps that are left of a motion that is called long


class Half(NamedTuple):
    """A motion after half of the steps up to the next look."""

    t: float
    taken: int
    evaluations: int


class Watch:
    """Looks at a motion by DOP853, or by Radau if `simulate` has chosen that.

    Parameters
    ----------
    system : CoreSystem
    options : Options, optional
        Those that the user has given, of a motion that may change its method; None where the method was named.

    Attributes
    ----------
    found : str
        The finding; empty before the look, and for motions that are not stiff or not long.
    """

    def __init__(self, system: CoreSystem, options: Options | None) -> None:
        self.system, self._options = system, options
        self.found = ""
        self._next = LOOK
        self._half: Half | None = None
        self._stuck: tuple[float, FlexelError] | None = None  # when steps were too short last [s]

    @property
    def next(self) -> int:
        """Steps after which it looks at the motion next."""
        return self._next // 2 if self._half is None else max(self._next, 2 * self._half.taken)

    def __call__(self, run: Run) -> None:
        """Look at a motion if it has taken enough steps."""
        if run.taken < self.next:
            return
        if self._half is None:
            self._half = Half(run.t, run.taken, run.statistics["evaluations"])
        else:
            self._look(run, self._half)
            self._half, self._next = Half(run.t, run.taken, run.statistics["evaluations"]), 2 * run.taken

    def _look(self, run: Run, half: Half) -> None:
        """Look at the rest of a motion, which goes on as since half of its steps."""
        left, now = float(run.times[-1]) - run.t, run.statistics["evaluations"]
        share, steps = left / (run.t - half.t), run.taken - half.taken
        if share * steps < LONG:
            return
        if isinstance(run, MinimalRun) and self._options is not None and few(self.system):
            linear = steps * linear_algebra(self.system) if run.name == RADAU else 0.0
            self._change(run, self._options, (now - half.evaluations + linear) * share, SHARE * now)
        elif not self.found and (why := self._why(run, suitable(self.system, run.present))):
            self._warn(f"{EXPLICIT} takes about {run.taken + share * steps:.2g} steps: {why}")

    def _why(self, run: Run, demands: Suitable) -> str:
        """Say why a motion is stiff; empty if accuracy asks for its steps."""
        fastest = float(demands.rates.max(initial=0.0))
        slowest = float(demands.rates[demands.rates > RIGID * fastest].min(initial=np.inf))
        if fastest * float(run.times[-1] - run.times[0]) > STIFF and fastest > SPREAD * slowest:
            return f"its largest eigenvalue is {fastest:.2g} 1/s in magnitude at t = {run.t:.3g} s"
        return demands.why if demands.method == ALPHA or demands.is_large else ""

    def _warn(self, found: str) -> None:
        """Say what suits the motion."""
        self.found = found
        other = (
            f"use method='{ALPHA}'"
            if self._options is not None
            else "omit method, so that a faster one is chosen"
        )
        issue(f"{found}; an interrupt keeps what was computed, {other}", StiffWarning)

    def _change(self, run: MinimalRun, options: Options, cost: float, least: float) -> None:
        """Go on with the other method if it takes fewer evaluations than the present one."""
        options = options.with_first(None)
        own, more = tolerances_of(self.system, options), linear_algebra(self.system)
        if run.name == RADAU:
            if CHEAPER * explicit_evaluations(run.onwards(Dop853, own)) < cost:
                self._say(f"{EXPLICIT} from t = {run.t:.3g} s on")
                run.use(Dop853, own)
            return
        won = cheaper(
            lambda way: run.onwards(Radau, tolerances_of(self.system, way)),
            later_ways(options),
            cost,
            Budget(least, least),
            more,
        )
        if won is not None:
            self._say(f"{RADAU} from t = {run.t:.3g} s on, since {fewer(won.options)}")
            run.use(Radau, tolerances_of(self.system, won.options))

    def stuck(self, run: MinimalRun, error: FlexelError) -> FlexelError | None:
        """Go on with the other method where the steps of one have become too short; return the error if it does not.

        Rounding in the accelerations of a stiff model may be the cause, which an implicit method filters, or forces
        that jump, across which it finds no stages.  Where neither method goes on, the error of the first one is
        returned.
        """
        if self._stuck is not None and run.t - self._stuck[0] <= APART * float(run.times[-1] - run.times[0]):
            return self._stuck[1]
        if self._options is None or not few(self.system):
            return error
        self._stuck, before = (run.t, error), run.name
        other = Dop853 if before == RADAU else Radau
        self._say(f"{other.name} from t = {run.t:.3g} s on, since the steps of {before} became too short")
        run.use(other, tolerances_of(self.system, self._options.with_first(None)))
        return None

    def _say(self, text: str) -> None:
        self.found = "; ".join(filter(None, (self.found, text)))


def watch_of(system: CoreSystem, asked: str, method: str, options: Options) -> Watch | None:
    """Return what looks at a motion by a method, which was asked for or chosen; None where nothing is looked for.

    Parameters
    ----------
    system : CoreSystem
    asked, method : str
    options : Options
        Those that the user has given.
    """
    free = asked == AUTO and not system.roles.actuated
    return (
        Watch(system, options if free else None) if method == EXPLICIT or (free and method == RADAU) else None
    )
