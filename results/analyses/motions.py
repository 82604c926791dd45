"""Motions: one call for all integrators, and for motions that are fully prescribed."""

from __future__ import annotations

import logging
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from flexel.base.arguments import flag
from flexel.base.arrays import Array
from flexel.base.blas import in_one_thread
from flexel.base.errors import FlexelError
from flexel.integration import methods
from flexel.integration.driver import Run
from flexel.integration.events import Event
from flexel.integration.outcome import Integration
from flexel.integration.simulation import Preparation, audited_run, explained, planned
from flexel.model.state import State
from flexel.results.analyses.checkpoints import Checkpoint
from flexel.results.interrupted import Interrupted
from flexel.results.motion import Motion
from flexel.system import CoreSystem

log = logging.getLogger("flexel.simulate")


@in_one_thread
def simulate(
    system: CoreSystem,
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
    events: Sequence[Event] = (),
    progress: bool | None = None,
    rechoose: bool | None = None,
    checkpoint: str | Path | None = None,
) -> Motion:
    """Simulate the motion; if every motion is prescribed, compute positions and driving forces.

    DOP853 and Radau integrate the degrees of freedom.  The generalized-alpha method integrates all coordinates together
    with the constraint forces, at a cost per step that grows linearly with the number of elements; it is for stiff and
    large models, and gives the energy balance.  A step is halved if it does not converge, and up to a few times where a
    rope comes to touch.  The steps of all methods end where a contact, a stop or a tyre begins or ends to act, and at
    the kinks of curves and formulas; constant steps do not.  All methods locate events and give states at any time
    (`Motion.at`); generalized-alpha takes the steps that lead there again.  Other integrators, such as those of
    ``scipy.integrate.solve_ivp``, can integrate `System.rhs`.

    Parameters
    ----------
    duration : float
        Length of the motion [s].
    start : State, optional
        The initial state by default; without its accelerations if a degree of freedom has no inertia and the
        method is generalized-alpha.  If its rates are not the prescribed ones, as with ``start=system.at_rest``, these
        jump at the start, with an impulse.
    times : array_like, optional
        Times [s] at which states are stored, and only these: include the start if it is wanted. By default,
        `samples` equidistant times from the start on.
    samples : int
        Number of stored states.
    method : str
        In minimal coordinates: DOP853, explicit and of order 8; Radau, implicit and of order 5 (Radau IIA), for
        stiff motions that are smooth.  With all coordinates: generalized-alpha.  Or auto: DOP853, unless a trial
        of both over some steps from the start shows that Radau takes less than half the evaluations (at least
        300 radians of the fastest mode, no contacts); the better trial is the beginning of the motion.  In stiff
        motions Radau may ignore degrees of freedom and rates that are smaller than its tolerance times the
        largest ones, and use ``rtol=1e-6``, unless `rtol` is given.  A motion is stiff if the largest eigenvalue
        of the linearized start times the duration exceeds 3e4 (900 000 divided by the number of degrees of
        freedom where these are more than 30), and 100 times the radians that any method must follow (those of
        modes whose amplitude at the start exceeds a twentieth of the motion or that are unstable, of rotations,
        and knots of tables), and counts as stiff above 300 degrees of freedom, where no eigenvalues are
        computed.  Generalized-alpha remains for stiff motions with contacts, if a degree of freedom has no
        inertia, above 1000 degrees of freedom, and above 300 with kinematic coordinates or internal states.
        After 1000 steps, and each time this number has doubled, auto tries the other method (DOP853 or Radau)
        for at least 60 steps, and continues with it if it needs less than half as many evaluations, or less
        than a tenth if its tolerance is looser.  ``motion.message`` reports the choice and the reason, and later
        changes.
    rtol : float, optional
        Local error in one step: DOP853 and Radau, relative to each variable (Radau: to its largest value so far;
        DOP853: of a degree of freedom, to the largest range of a coordinate in this motion so far if that is less),
        1e-9 by default; generalized-alpha, of the coordinates relative to the largest range of a coordinate in this
        motion so far, in natural scales and at most 1, and of internal states relative to their ranges, 1e-6.
        Accelerations of generalized-alpha, and forces and drives that follow from them, are less exact.
    atol : float or array_like, optional
        Absolute local error in natural scales (the size of the model for lengths, one for the rest, the same
        per second for rates): DOP853 and Radau, 1e-11 by default (DOP853: less in small motions, down to
        rounding), or one for each of (q, q_d', z) if these stay the same (rechoose=False); generalized-alpha,
        always allowed for coordinates, whatever `rtol` is, zero by default.
    step : float, optional
        For generalized-alpha: constant step [s] instead of step control by the tolerances, whatever `samples` and
        `times` are; states between its multiples are found by a shorter step each.  A step is shorter only at the end,
        at a terminal event, before a knot, at an instant of a sampled controller, or where it is not found.
    first_step, max_step : float
        [s]; the first step of generalized-alpha is a thousandth of the duration by default.
    spectral_radius : float, optional
        For generalized-alpha, at infinite frequency: 0 (all high frequencies damped at once) to below 1; 1 (no
        damping) is possible without constraints; 0.8 by default.
    newton : str, optional
        For generalized-alpha: full (default), a new tangent at every iteration; modified, the last one is kept
        while the iteration converges.
    events : sequence of Event
        Reported in ``motion.events``; a terminal one ends the motion.
    progress : bool, optional
        Progress bar on stderr; by default where stderr is a terminal.
    rechoose : bool, optional
        For DOP853 and Radau: change the degrees of freedom where others are much better; yes by default.
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
        whose rates are not the derivatives of its values; a checkpoint of another simulation.
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
        If DOP853 turns out to need many thousands of steps because the system is stiff, and was named or cannot be
        replaced.
    DampingWarning
        If generalized-alpha has removed more than 1 % of the energy of the motion: the larger of its kinetic
        energy and what was dissipated and supplied. ``motion.warnings`` and ``motion.message`` keep the
        warning.
    AuditWarning
        If the motion contradicts itself: its energy balance fails by more than its tolerance explains, a contact or
        an event was passed, the rates of a prescribed motion are not the derivatives of its values, the energy
        of a user's law contradicts its stress, a wheel pulls on the road, a rope is at its end, a position is nearly
        singular. ``motion.verdict`` says what was found, even if that is nothing.
    RangeWarning
        If a quantity is outside the data of its law at a stored time, or a beam is bent or twisted by more than
        15° within one element, by name.
    """
    if progress is not None:  # a checkpoint may hold the whole motion: no integrator checks it then
        flag(progress, "simulate", "progress")
    given: dict[str, Any] = {"rtol": rtol, "atol": atol, "step": step, "first_step": first_step}
    given |= {"max_step": max_step, "spectral_radius": spectral_radius, "newton": newton}
    plan = planned(
        system,
        duration,
        start=start,
        times=times,
        samples=samples,
        method=method,
        events=events,
        rechoose=rechoose,
        **given,
    )
    first = float(plan.times[0])
    keeper = None if checkpoint is None else Checkpoint(checkpoint, system, plan)
    before = None if keeper is None else keeper.before()
    if before is not None:
        if before.complete:
            return Motion(system, before.found.since(first))
        plan = plan.onwards(before.found.states[-1], before.step)
        log.info("continues at t = %g s from the checkpoint %s", plan.start.t, checkpoint)
    if keeper is not None:
        keeper.try_out(plan.start)
    course = Preparation(system, plan)

    def whole(found: Integration) -> Integration:
        """Return the motion with the part that an earlier process has computed, and what is to be said of it."""
        joined = found if keeper is None else keeper.whole(found)
        return explained(joined, course.why, course.found)

    try:
        run = course.chosen()
        log.info("t = %g to %g s by %s", plan.start.t, plan.times[-1], course.why or method)
        found = run.run(progress, _each(keeper, course.watch))
    except FlexelError as error:
        if course.run is not None:
            error.motion = Motion(system, whole(course.run.kept(str(error))).since(first))
        raise
    except KeyboardInterrupt:
        if course.run is None:
            raise
        kept = whole(course.run.interrupted())
        if keeper is not None:
            keeper.end(kept, course.run.step)
        raise Interrupted(kept.message, Motion(system, kept.since(first))) from None
    log.info("t = %g s: %s; %s", run.t, found.message, found.statistics)
    found = whole(audited_run(system, run, found, plan.ahead))
    motion = Motion(system, found.since(first))
    if keeper is not None:
        try:
            keeper.end(found, run.step)
        except FlexelError as error:
            error.motion = motion
            raise
    return motion


def _each(*calls: Callable[[Run], None] | None) -> Callable[[Run], None] | None:
    """Combine all given calls in one call after each step."""
    some = [call for call in calls if call is not None]
    if len(some) < 2:
        return some[0] if some else None

    def each(run: Run) -> None:
        for call in some:
            call(run)

    return each
