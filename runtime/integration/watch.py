"""Looks at a motion by DOP853 or Radau: where the other one is faster it goes on with that, or a warning names it."""

from __future__ import annotations

import warnings

import numpy as np

from flexel.base.callers import outside
from flexel.base.errors import StiffWarning
from flexel.integration.choose import CHEAPER, cheaper, fewer, later_ways, linear_algebra
from flexel.integration.dop853 import Dop853
from flexel.integration.driver import Run
from flexel.integration.methods import Options, tolerances_of
from flexel.integration.minimal import MinimalRun
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
LONG = 4 * LOOK  # steps that are left of a motion that is called long


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
        self._half = 0.0, 0  # time [s] and evaluations after half of the steps up to the next look

    def __call__(self, run: Run) -> None:
        """Look at a motion if it has taken enough steps."""
        if run.taken == self._next:
            self._look(run)
            self._next *= 2
        if run.taken == self._next // 2:
            self._half = run.t, run.statistics["evaluations"]

    def _look(self, run: Run) -> None:
        """Look at the rest of a motion, which goes on as since half of its steps."""
        left, (half, before), now = float(run.times[-1]) - run.t, self._half, run.statistics["evaluations"]
        share, steps = left / (run.t - half), run.taken - run.taken // 2
        if share * steps < LONG:
            return
        if isinstance(run, MinimalRun) and self._options is not None and few(self.system):
            linear = steps * linear_algebra(self.system) if run.name == RADAU else 0.0
            self._change(run, self._options, (now - before + linear) * share, SHARE * now)
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
        """Name a method that suits the motion."""
        self.found, other = found, RADAU if few(self.system) else ALPHA
        warnings.warn(
            f"simulate: {found}; an interrupt keeps what was computed, use method='{other}'",
            StiffWarning,
            stacklevel=outside(),
        )

    def _change(self, run: MinimalRun, options: Options, cost: float, least: float) -> None:
        """Go on with the other method if it takes fewer evaluations than the present one."""
        own, more = tolerances_of(self.system, options), linear_algebra(self.system)
        if run.name == RADAU:
            if CHEAPER * explicit_evaluations(run.onwards(Dop853, own)) < cost:
                self._say(f"{EXPLICIT} from t = {run.t:.3g} s on")
                run.use(Dop853, own)
            return
        some = cheaper(
            lambda way: run.onwards(Radau, tolerances_of(self.system, way)),
            later_ways(options),
            cost,
            Budget(least, least),
            more,
        )
        if some is not None:
            self._say(f"{RADAU} from t = {run.t:.3g} s on, since {fewer(some)}")
            run.use(Radau, tolerances_of(self.system, some))

    def _say(self, text: str) -> None:
        self.found = "; ".join(filter(None, (self.found, text)))
