"""Motions: one call for all integrators, and for motions that are fully prescribed."""

from __future__ import annotations

import logging
from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from flexel.analyses.checkpoints import Checkpoint
from flexel.base.arguments import flag
from flexel.base.arrays import Array
from flexel.base.errors import FlexelError
from flexel.integration import methods
from flexel.integration.consistent import check_rates
from flexel.integration.dop853 import Dop853
from flexel.integration.driver import Run
from flexel.integration.events import Event, checked
from flexel.integration.outcome import Integration, from_start, stored_times
from flexel.integration.ranges import warn_outside
from flexel.integration.stiffness import Watch
from flexel.mechanics.bent import warn_bent
from flexel.mechanics.core import Core
from flexel.results.interrupted import Interrupted
from flexel.results.motion import Motion
from flexel.structure.state import State

log = logging.getLogger("flexel.simulate")


class Motions(Core):
    """Motions of a system over time."""

    def simulate(
        self,
        duration: float,
        *,
        start: State | None = None,
        times: Sequence[float] | Array | None = None,
        samples: int = 201,
        method: str = methods.AUTO,
        rtol: float | None = None,
        atol: float | Array | None = None,
        step: float | None = None,
        first_step: float | None = None,
        max_step: float = np.inf,
        spectral_radius: float | None = None,
        newton: str | None = None,
        max_order: int | None = None,
        events: Sequence[Event] = (),
        progress: bool | None = None,
        rechoose: bool | None = None,
        checkpoint: str | Path | None = None,
    ) -> Motion:
        """Forward dynamics; if every motion is prescribed, positions and driving forces.

        Most methods integrate the degrees of freedom; they locate events and give states at any time (`Motion.at`).
        The generalized-alpha method integrates all coordinates together with the constraint forces, at a cost per step
        that grows linearly with the number of elements; it is for stiff and large models, and gives the energy balance.
        A step is halved if it does not converge, and up to a few times where a contact begins.

        Parameters
        ----------
        duration : float
            Length of the motion [s].
        start : State, optional
            The initial state by default; without its accelerations if a degree of freedom has no inertia and the
            method is implicit.
        times : array_like, optional
            Times [s] at which states are stored: these alone, so that the start is one of them where it is wanted.
            `samples` equidistant ones from the start on by default.
        samples : int
            Number of stored states.
        method : str
            In minimal coordinates ("explicit" below): DOP853; Radau, implicit and of order 5 (Radau IIA), for stiff
            motions that are smooth; RK45, LSODA or BDF of SciPy.  With all coordinates: generalized-alpha; sundials,
            the backward differentiation formulas of SUNDIALS, for comparison (needs the optional package
            scikit-sundae).  Or auto: this chooses DOP853, but Radau where both methods, tried for some steps from the
            start, show that it takes less than half the evaluations (at least 300 radians of the fastest mode, at
            most 300 degrees of freedom, no contacts, no functions of the user in laws).  Where neither does and the
            motion is stiff, it takes Radau with ``rtol=1e-6``, unless `rtol` is given, or generalized-alpha.  A motion
            is stiff if the largest eigenvalue of the linearized start times the duration exceeds 3e4 (900 000 divided
            by the number of degrees of freedom where these are more than 30), and 100 times the radians that any
            method must follow (those of modes whose amplitude at the start exceeds a twentieth of the motion or that
            are unstable, of rotations, and knots of tables).  If a degree of freedom has no inertia, and above 300
            degrees of freedom, it takes generalized-alpha.  ``motion.message`` reports which and why.
        rtol : float, optional
            Local error in one step: explicit, relative to each variable (Radau: to its largest value so far), 1e-9 by
            default; generalized-alpha, of the coordinates relative to the largest range of a coordinate in this motion
            so far, in natural scales and at most 1, and of internal states relative to their ranges, 1e-6; sundials,
            relative to each coordinate and rate, 1e-6.
        atol : float or array_like, optional
            Absolute local error in natural scales (the size of the model for lengths, one for the rest, the same in a
            second for rates): explicit, 1e-11 by default, or one for each of (q, q_d', z) if these stay the same
            (rechoose=False); generalized-alpha, allowed of coordinates whatever `rtol`, zero by default; sundials, that
            of `rtol` by default.
        step : float, optional
            For generalized-alpha: constant step [s] instead of step control by the tolerances.
        first_step, max_step : float
            [s]; the first step of generalized-alpha is a thousandth of the duration by default.
        spectral_radius : float, optional
            For generalized-alpha, at infinite frequency: 0 (all high frequencies damped at once) to below 1; 1 (no
            damping) is possible without constraints; 0.8 by default.
        newton : str, optional
            For generalized-alpha: full (default), a new tangent at every iteration; modified, the last one is kept
            while the iteration converges.
        max_order : int, optional
            For sundials, 1 to 5, by default 2; higher orders are slow on structures with little damping.
        events : sequence of Event
            For explicit methods.
        progress : bool, optional
            Progress bar on stderr; by default where stderr is a terminal.
        rechoose : bool, optional
            For explicit methods: change the degrees of freedom where others are much better; yes by default.
            `Motion.rechoices` lists the changes.
        checkpoint : str or Path, optional
            A file (.npz, .nc, .mat or .csv) for the motion so far, written about every 30 s, and at the end. If a run
            is killed, the same call continues from the file, within the tolerances of the method; if the file holds
            the whole motion, it is returned. `fx.load` reads the file at any time.

        Returns
        -------
        Motion

        Raises
        ------
        ModelError
            An option that the method does not have; a load or a prescribed motion without a value; a prescribed motion
            whose rates are not those of its values; a checkpoint of another simulation.
        FlexelError
            A checkpoint that cannot be written: before the first step, or later; ``error.motion`` then holds the
            motion.
        PositionError, DynamicsError
            If the motion cannot be continued; ``error.motion`` holds the motion so far.
        Interrupted
            After Ctrl-C: a `KeyboardInterrupt` whose ``motion`` is the motion so far.

        Warns
        -----
        StiffWarning
            If an explicit method turns out to need many thousands of steps because the system is stiff.
        DampingWarning
            If an implicit method has taken out more than 1 % of the energy of the motion: the larger of its kinetic
            energy and what was dissipated and supplied. ``motion.warnings`` and ``motion.message`` keep it.
        RangeWarning
            If a quantity is outside the data of its law at a stored time, or a beam is bent or twisted by more than
            15° within one element, by name.
        """
        if progress is not None:  # a checkpoint may hold the whole motion: no integrator checks it then
            flag(progress, "simulate", "progress")
        given: dict[str, Any] = {"rtol": rtol, "atol": atol, "step": step, "first_step": first_step}
        given |= {
            "max_step": max_step,
            "spectral_radius": spectral_radius,
            "newton": newton,
            "max_order": max_order,
        }
        method, why, begin, grid, options = self._planned(
            duration,
            start=start,
            times=times,
            samples=samples,
            method=method,
            events=events,
            rechoose=rechoose,
            **given,
        )
        keeper = None if checkpoint is None else Checkpoint(checkpoint, self, begin, grid, method, options)
        before = None if keeper is None else keeper.before()
        if before is not None:
            if before.complete:
                return _motion(self, before.found, grid)
            begin, options = before.found.states[-1], options.with_first(before.step)
            log.info("continues at t = %g s from the checkpoint %s", begin.t, checkpoint)
        if keeper is not None:
            keeper.try_out(begin)
        log.info("t = %g to %g s by %s", begin.t, grid[-1], why or method)
        ahead = from_start(begin, grid[grid >= begin.t])
        run = methods.run_of(self, method, begin, ahead, float(duration), options)
        watch = Watch(self, method) if method in methods.WATCHED else None
        try:
            found = run.run(progress, _each(keeper, watch))
        except FlexelError as error:
            kept = _explained(_whole(run.kept(str(error)), keeper), why)
            error.motion = Motion(self, kept.since(grid[0]))
            raise
        except KeyboardInterrupt:
            kept = _explained(_whole(run.interrupted(), keeper), why)
            if keeper is not None:
                keeper.end(kept, run.step)
            raise Interrupted(kept.message, Motion(self, kept.since(grid[0]))) from None
        log.info("t = %g s: %s; %s", run.t, found.message, found.statistics)
        found = _explained(_whole(found, keeper), why, watch.found if watch else "")
        motion = _motion(self, found, grid)
        if keeper is not None:
            try:
                keeper.end(found, run.step)
            except FlexelError as error:
                error.motion = motion
                raise
        return motion

    def _planned(
        self,
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
        """The method and why it was chosen, the start, the stored times and the options of a motion."""
        if rechoose is not None:
            flag(rechoose, "simulate", "rechoose")
        unlimited = isinstance(max_step, float) and max_step == np.inf
        longest = None if unlimited else max_step
        options = methods.Options(
            max_step=longest, events=checked(events) or None, rechoose=rechoose, **given
        )
        methods.check(method, options)
        begin = methods.start_of(self, method, start, options)
        grid = stored_times(begin, duration, times, samples, "simulate")
        check_rates(self, begin.t, begin.t + float(duration))
        if method != methods.AUTO:
            return method, "", begin, grid, options
        chosen, why, options = methods.automatic(self, begin, float(duration), options)
        return chosen, why, begin, grid, options

    def _begun(self, duration: float, before: Run | None = None, **given: Any) -> tuple[Run, str]:
        """A motion that has begun, and why its method was chosen; it reuses the arrays of one with the same options."""
        method, why, begin, grid, options = self._planned(duration, **given)
        run = methods.run_of(self, method, begin, from_start(begin, grid), float(duration), options)
        if run.times[-1] > run.times[0]:
            if isinstance(run, Dop853) and isinstance(before, Dop853):
                run.spare = before.steps
            run.begin()
        return run, why

    def _ended(self, run: Run, why: str, times: Array) -> Motion:
        """A motion of `_begun`, continued to its end, with the states at the times from the first of these on."""
        found = run.kept("reached the end") if run.t >= run.times[-1] else run.rest(False)
        return _motion(self, _explained(found, why), times)


def _whole(found: Integration, keeper: Checkpoint | None) -> Integration:
    """The motion, joined with the part that an earlier process has computed."""
    return found if keeper is None else keeper.whole(found)


def _each(*calls: Callable[[Run], None] | None) -> Callable[[Run], None] | None:
    """One call after each step for all that are there."""
    some = [z for z in calls if z is not None]
    if len(some) < 2:
        return some[0] if some else None

    def each(run: Run) -> None:
        for call in some:
            call(run)

    return each


def _explained(found: Integration, *why: str) -> Integration:
    """The result, with a message that reports how the method was chosen and what was found about it and the motion."""
    reasons = "; ".join(text for text in (*why, *found.warnings) if text)
    return replace(found, message=f"{found.message} ({reasons})") if reasons else found


def _motion(system: Core, found: Integration, times: Array) -> Motion:
    """The motion from the first time to be stored on, with a warning of quantities outside the data of their laws."""
    stored = found.since(float(times[0]))
    warn_outside(system, stored.states)
    warn_bent(system.structure, stored.states.times, stored.states.deformations, "simulate")
    return Motion(system, stored)
