"""Motions: explicit and implicit integration, and motions that are fully prescribed."""

from __future__ import annotations

import warnings
from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np

from flexel.base.arguments import step_limit
from flexel.base.arrays import Array
from flexel.base.errors import FlexelError, IncompleteWarning, ModelError, PositionError
from flexel.integration.bdf import Bdf
from flexel.integration.explicit import (
    Event,
    Integration,
    Integrator,
    Segment,
    longest_step,
    stored_times,
    turning_weights,
)
from flexel.integration.ranges import warn_outside
from flexel.integration.steps import Control, GeneralizedAlpha, Run
from flexel.mechanics.core import Core
from flexel.mechanics.states import Moment, state_of
from flexel.results.motion import Motion
from flexel.structure.state import State, own_state


class Motions(Core):
    """Motions of a system over time."""

    def simulate(
        self,
        duration: float,
        *,
        start: State | None = None,
        times: Sequence[float] | Array | None = None,
        samples: int = 201,
        method: str = "DOP853",
        rtol: float = 1e-9,
        atol: float = 1e-11,
        max_step: float = np.inf,
        events: Sequence[Event] = (),
        progress: bool | None = None,
        rechoose: bool = True,
    ) -> Motion:
        """Forward dynamics; with no freedoms left, the prescribed motion and its driving forces.

        Parameters
        ----------
        duration : float
            Length of the motion [s].
        start : State, optional
            The initial state by default.
        times : array_like, optional
            Times [s] at which states are kept; `samples` equidistant ones by default.
        method : str
            DOP853, RK45, LSODA, Radau or BDF.
        rtol, atol, max_step : float
            Of the integrator.
        events : sequence of Event
        progress : bool, optional
            Progress bar on stderr; by default where stderr is a terminal.
        rechoose : bool
            Change the freedoms when they become ill-conditioned.

        Returns
        -------
        Motion

        Raises
        ------
        ModelError, PositionError, DynamicsError
            Where the motion cannot go on, with what was computed until then as ``error.motion``.

        Warns
        -----
        RangeWarning
            Where the data of a law were left at a stored time, by name.
        """
        start = self.initial if start is None else own_state(self.structure, start, "simulate")
        grid = stored_times(start, duration, times, samples, "simulate")
        if self.roles.nq == 0:
            return _motion(self, _follow(self, start, grid))
        chosen = self.roles
        if start.roles is not chosen:
            if self.condition(start) > 1e-3 * self.condition(start, start.roles):
                start = self.state(start.t, start.x, start.v, start.e, start.z)
            else:  # the motion has led to where the chosen freedoms are of no use
                self.use(start.roles)
        try:
            run = Integrator(self, start, grid, method, rtol, atol, max_step, events, progress, rechoose)
            try:
                found = run.run()
            except FlexelError as error:
                error.motion = Motion(self, run.kept(str(error), complete=False))
                raise
        finally:
            self.use(chosen)
        return _motion(self, found)

    def simulate_stiff(
        self,
        duration: float,
        *,
        start: State | None = None,
        times: Sequence[float] | Array | None = None,
        samples: int = 201,
        tolerance: float = 1e-6,
        radius: float = 0.8,
        step: float | None = None,
        first_step: float | None = None,
        max_step: float = np.inf,
        newton: str = "full",
        method: str = "alpha",
        max_order: int = 2,
        progress: bool | None = None,
    ) -> Motion:
        """Implicit dynamics of a stiff model by the generalized-alpha method, whatever the freedoms.

        The cost of a step grows linearly with the number of elements.  Where a step does not converge it is halved,
        and a few times where a contact begins.  If the integration cannot go on, the motion up to there is returned
        with an IncompleteWarning, and ``message`` says why; its last state can be started from again.

        Parameters
        ----------
        duration : float
            Length of the motion [s].
        start : State, optional
            The initial state by default; a state of rest serves where a freedom has no inertia.
        times : array_like, optional
            Times [s] at which states are kept; `samples` equidistant ones by default.
        tolerance : float
            Local error of the coordinates in their natural scales, in one step.
        radius : float
            Spectral radius at infinite frequency, 0 (all high frequencies damped at once) to below 1; 1 (no damping) is
            possible without constraints.
        step : float, optional
            Constant step [s] in place of one that follows from the tolerance.
        first_step, max_step : float
            [s]; the first is a thousandth of the duration by default.
        newton : str
            full: a new tangent at every iteration; modified: the last one is kept while it serves.
        method : str
            alpha, or bdf: the backward differentiation formulas of SUNDIALS, for comparison (needs the optional package
            scikit-sundae; radius, step and newton are then without meaning, and first_step is its own choice by
            default).
        max_order : int
            Of bdf, 1 to 5; orders above 2 are slow on structures with little damping.

        Returns
        -------
        Motion
            With `Motion.energy_balance`, and statistics of steps, iterations and factorizations.

        Raises
        ------
        ModelError, DynamicsError
            Where a load or a prescribed motion has no value, with what was computed until then as ``error.motion``.
        """
        owner = "simulate_stiff"
        start = self.initial if start is None else own_state(self.structure, start, owner)
        grid = stored_times(start, duration, times, samples, owner)
        tolerance = step_limit(tolerance, owner, "tolerance")
        first = duration / 1000 if first_step is None else step_limit(first_step, owner, "first_step")
        control = Control(tolerance, first, step_limit(max_step, owner, "max_step"))
        if step is not None:
            control = Control(np.inf, *(step_limit(step, owner, "step"),) * 2)
        run: Run
        if method == "alpha":
            run = GeneralizedAlpha(self, start, radius, newton, control)
        elif method == "bdf":
            if step is not None:
                raise ModelError(
                    "simulate_stiff: bdf chooses its own steps; leave step out, or limit them with max_step"
                )
            if max_order not in range(1, 6):
                raise ModelError(
                    f"simulate_stiff: max_order {max_order!r} of bdf; give a whole number from 1 to 5"
                )
            run = Bdf(self, start, duration, Control(tolerance, first_step or 0.0, max_step), max_order)
        else:
            raise ModelError(f"simulate_stiff: method {method!r} is unknown; choose alpha or bdf")
        try:
            found = run.run(grid, progress)
        except FlexelError as error:
            error.motion = Motion(self, run.kept(str(error)))
            raise
        if not found.complete:
            warnings.warn(found.message, IncompleteWarning, stacklevel=2)
        return _motion(self, found)


def _motion(system: Core, found: Integration) -> Motion:
    """The motion, with a warning of what has left the data of its law."""
    warn_outside(system, found.states)
    return Motion(system, found)


def _follow(system: Core, start: State, grid: Array) -> Integration:
    """States of a fully prescribed motion; long steps are halved until the position is found."""
    found, none = [start], np.zeros(0)
    segments: list[Segment] = []
    weights = turning_weights(system.structure)
    dense: Callable[[float], Array] = lambda t: none  # noqa: E731 (a fully prescribed motion has no state)
    for t in grid[1:]:
        last, step = found[-1], float(t) - found[-1].t
        while last.t < t:
            step = min(step, longest_step(last, weights))
            try:
                here = Moment.of(last)
                ahead = replace(here, x=last.x + min(step, float(t) - last.t) * last.v)
                state = state_of(
                    system.kinematics, system.loads, min(last.t + step, float(t)), none, none, last.z, ahead
                )
            except FlexelError as error:
                step /= 2
                if not isinstance(error, PositionError) or step < 1e-6 * (grid[-1] - grid[0]):
                    reached = [*found, last] if last.t > found[-1].t else found
                    error.motion = Motion(system, _followed(reached, segments, str(error), complete=False))
                    raise
                continue
            ends = Moment.of(last), Moment.of(state)
            segments.append(Segment(last.t, state.t, system.roles, dense, *ends))
            last = state
        found.append(last)
    return _followed(found, segments)


def _followed(
    found: list[State], segments: list[Segment], message: str = "", complete: bool = True
) -> Integration:
    counts = {"steps": len(segments), "evaluations": 0, "rechoices": 0}
    return Integration(found, [], segments, counts, message, complete=complete)
