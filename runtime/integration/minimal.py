"""Forward dynamics in minimal coordinates: the loop of trials and accepted steps, by any method of step_method.py.

Every accepted step is checked for the branch that it is on, and its end for the degrees of freedom: where others are
much better, the motion continues in them from the same x and v.
"""

from __future__ import annotations

import logging
from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import cached_property
from math import ulp
from time import perf_counter
from typing import Any

import numpy as np

from flexel.base.arrays import Array
from flexel.base.errors import DynamicsError, FlexelError
from flexel.engine.contact_selection import every_gap
from flexel.engine.covered import Covered
from flexel.generated._kernels import lib
from flexel.integration.account import Account
from flexel.integration.attempts import Attempted, search
from flexel.integration.branch import REFUSED, WORSE, Choices
from flexel.integration.carried import Carried
from flexel.integration.dense_run import DenseRun
from flexel.integration.dips import Dips
from flexel.integration.events import Event
from flexel.integration.imbalance import AT_REST, ROUNDING, STEPS, Imbalance, explained
from flexel.integration.outcome import Integration
from flexel.integration.segments import DenseOutput, Step
from flexel.integration.step_method import InRow, StepMethod, Tolerances, natural_scales_of_y
from flexel.integration.touching import TouchingContacts
from flexel.integration.workers import workers
from flexel.mechanics.amplification import amplification, lost
from flexel.mechanics.collapsed import collapsed
from flexel.mechanics.impulse import struck
from flexel.mechanics.kinematics import Kinematics
from flexel.mechanics.timed_laws import timed_law
from flexel.model.snapshot import Snapshot
from flexel.model.state import State

log = logging.getLogger("flexel.simulate")
SHORTEST = 1e-11  # step, relative to the times, below which the integration stops
EXTREME = 10.0  # amplification of kept degrees of freedom, relative to the best, that explains an early end
STILL = 1e-14  # rates, in natural scales, that are rounding errors
FAR = 10.0  # distance from the origin, in natural scales, to which rounding errors are attributed
PAUSE = 0.1  # time [s] for which an interrupt, or the progress bar, may wait for steps in a row
SHORT_ROW = 4  # steps of a row, up to an unusual one, that are not worth a row
MOST_ALONE = 63  # steps at most that are taken one by one then, before the next row is tried
SINGULAR = 1e6  # amplification of the best choice above which the position is singular


class MinimalRun(DenseRun):
    """One run in minimal coordinates.

    Parameters
    ----------
    system : CoreSystem
    start : State
    times : ndarray
        At which states are kept.
    tolerances : Tolerances
    events : sequence of Event
    rechoose : bool
        Change the degrees of freedom where others are much better.
    kind : type of StepMethod
        What takes its steps.

    Attributes
    ----------
    method : StepMethod
    touching : TouchingContacts
    loosest : float
        The largest of the tolerances that parts of the motion have had.
    stuck : callable(MinimalRun, FlexelError) -> FlexelError or None, optional
        Changes the method where steps have become too short, of which an error tells; returns an error if it does not.
    """

    stuck: Callable[[MinimalRun, FlexelError], FlexelError | None] | None = None

    def __init__(
        self,
        system: Any,
        start: State,
        times: Array,
        tolerances: Tolerances,
        events: Sequence[Event],
        rechoose: bool,
        kind: type[StepMethod],
    ) -> None:
        super().__init__(system, start, times, events)
        self.tolerances, self.loosest = tolerances, max(tolerances.rtol, tolerances.largest_atol)
        self.choices = Choices(system, system.kinematics_of(start.roles), rechoose)
        self.counts = {
            "steps": 0,
            "rejected": 0,
            "evaluations": 0,
            "rechoices": 0,
            "bifurcations": 0,
            "carried": 0,
        }
        self.amplification = 1.0
        self.account = Account(kind.quadrature)
        self.dips = Dips()
        tables = self.kinematics.evaluation.work.tables
        self.touching = TouchingContacts(tables, every_gap(tables), self.passed)
        self._patient = 1  # steps in a row that take about PAUSE
        # steps that are taken alone after the last short row, and what is left of them
        self._unusual = self._alone = 0
        self.covered = self._scale(kind)
        self.method: StepMethod = kind(self)

    @property
    def name(self) -> str:
        """Name of the method."""
        return self.method.name

    @property
    def dense_at_once(self) -> bool:
        """Whether states within a step are asked for before the next one is taken: events are looked for."""
        return bool(self.events)

    @property
    def shortest(self) -> float:
        """Length [s] below which a step is too short."""
        return max(self.least, self.resolution)

    @property
    def resolution(self) -> float:
        """Length [s] of the shortest step that changes the time by what is asked for."""
        return 10 * ulp(self.t)

    @property
    def least(self) -> float:
        """Length [s] below which a step is too short, wherever it is."""
        return SHORTEST * self._span

    @property
    def statistics(self) -> dict[str, int]:
        """Counts of what was done."""
        return dict(self.counts)

    @property
    def exactness(self) -> float:
        """Error of a path across a flat position, in natural scales."""
        return self.tolerances.rtol + self.tolerances.largest_atol

    @property
    def timed(self) -> bool:
        """Whether anything depends on time itself: a prescribed motion, a load, a law, a sampled controller."""
        own = self.kinematics
        varying = bool(own.roles.motions) or not own.loads.constant or bool(self.sampling.all)
        return varying or timed_law(own.structure) is not None

    @property
    def kinematics(self) -> Kinematics:
        """The present degrees of freedom."""
        return self.choices.kinematics

    def begin(self) -> None:
        """Take over prescribed rates that the start does not have; change to better degrees of freedom there."""
        if self.begins_with_jump():
            self.now = struck(self._shown, self.now, self.knots.inside(self.t))
        self.amplification = self.choices.amplification(self.now)
        self.consider(WORSE)
        self.method.restart()
        self.account.note(self.t)

    def use(self, kind: type[StepMethod], tolerances: Tolerances) -> None:
        """Continue from here with another method and its tolerances."""
        if self.knots.any:
            self._pass_knots()  # the first step begins beyond one that is here
        log.info("t = %.9g s: %s instead of %s", self.t, kind.name, self.name)
        self.tolerances = replace(tolerances, first_step=None)
        self.loosest = max(self.loosest, tolerances.rtol, tolerances.largest_atol)
        before, self.covered = self.covered, self._scale(kind)
        self.covered.take_over(before)
        self.account.use(kind.quadrature)
        self.dips.forget()
        self.method = kind(self)
        self.method.restart()

    def onwards(self, kind: type[StepMethod], tolerances: Tolerances) -> MinimalRun:
        """Return another motion that continues from here by a method, to be tried."""
        times = np.array([self.t, self.times[-1]])
        other = MinimalRun(self.system, self.present, times, tolerances, (), self.choices.free, kind)
        other.covered.take_over(self.covered)
        return other

    def as_after(self, taken: float) -> MinimalRun:
        """Return another motion that continues from here as if it had taken so many steps, to be tried."""
        other = self.onwards(type(self.method), replace(self.tolerances, first_step=self.step))
        other.covered.skip(taken)
        return other

    def _scale(self, kind: type[StepMethod]) -> Covered:
        """Return what the motion covers, as the scale of the tolerances of a method."""
        return kind.scale(self.system.structure, self.kinematics.lists.step_weight, self.tolerances)

    def renew(self) -> None:
        """Compute the rates with the changed loads."""
        self.method.renew()

    def strike(self) -> None:
        """Continue from here with the rates just after an impulse."""
        super().strike()
        self.account.part()
        self.method.restart()

    def jump(self, z: Array) -> None:
        """Continue from here with other internal states."""
        self.z = z
        self.account.part()
        self.method.jump()

    def several(self, most: int) -> str | None:
        """Take one or more accepted steps, at most so many."""
        if most == 1 or self._alone or not (self.method.rows and self._in_rows):
            self._alone = max(0, self._alone - 1)
            return super().several(most)
        begun = perf_counter()
        row = self.method.row(min(most, self._patient), self.allowed())
        tried, stored, short = self.method.tried, self.stored, len(row) < SHORT_ROW
        self._unusual = min(2 * self._unusual + 1, MOST_ALONE) if self.method.unusual and short else 0
        self._alone = self._unusual
        for step in row:
            self._accept_in_row(step)
        if row:
            self._patient = int(PAUSE * len(row) / (perf_counter() - begun)) + 1
        if tried and (self.choices.changes or self.stored > stored):
            self.method.forget_trial()  # the workspace has served to find other states
        if tried or not row:
            return super().several(most)
        if self.consider(WORSE):
            self.method.restart()
        return None

    def advance(self) -> str | None:
        """Take one accepted step."""
        method, shortest = self.method, self.shortest
        method.aim(self.latest, shortest)
        while True:
            found = search(method, self.touching, self.now, shortest, self._change_refused)
            self.counts["rejected"] += found.cuts
            if found.last is not None:
                ended = self._accept_found(found.last, found.kink)
                if found.cuts:
                    self._looks.forget()
                return ended
            if found.trial is Attempted.SHORT:
                return self.carry_or_stop(method.stopped())
            if steps := self.across(method.flat):
                return self.carry(steps)

    # -- steps that are taken in a row, see StepMethod.row ---------------------------------------------

    @cached_property
    def _in_rows(self) -> bool:
        """Whether nothing is asked of the user's functions in a step."""
        return not (self.events or self._at_once or self._scales.any)

    def allowed(self, factor: float = WORSE) -> float:
        """Return the amplification up to which degrees of freedom that are better by a factor are not looked for."""
        return factor * self.choices.share * max(1.0, min(self.choices.best, SINGULAR))

    def _accept_in_row(self, found: InRow) -> None:
        """Store a step of a row, and what belongs to its end."""
        self.amplification = found.amplification
        self.account.note(found.dense.last.t, found.balance)
        if found.recall is not None:
            found.recall()
        self.counts["steps"] += 1
        self.taken += 1
        self.pass_step(found.dense, found.z)

    # -- steps that are taken in a lane, see lane_motions.py -------------------------------------------

    def pass_step(self, dense: DenseOutput, z: Array) -> str | None:
        """Store an accepted step, and the states at the times within it; returns a message as `advance` does."""
        first, last, shown = dense.first, dense.last, self._shown
        at_end = self.shown(last) if self.choices.changes else shown
        if shown is self.choices.own:
            shown = at_end  # the user's are shown where they are usable at both ends
        ended = self.accept(Step(first.t, last.t, self.kinematics, shown, first, last, dense), z)
        self._shown = at_end
        return ended

    def go_on_alone(self, now: Snapshot, z: Array, amplification: float) -> None:
        """Continue from the start of a step, to which the method has come."""
        self.now, self.z, self.amplification = now, z, amplification
        self.account.note(now.t)

    def count(self, taken: int, refused: int, evaluations: int) -> None:
        """Count steps that were taken and refused, and their evaluations."""
        self.taken += taken
        self.counts["steps"] += taken
        self.counts["rejected"] += refused
        self.counts["evaluations"] += evaluations

    # --------------------------------------------------------------------------------------------------

    def _change_refused(self) -> bool:
        """Change to better degrees of freedom at the start of a step that was refused; whether there are any."""
        self.amplification = self.choices.amplification(self.now)
        return self.consider(REFUSED)

    def poor(self) -> bool:
        """Whether other degrees of freedom are so much better that they may explain a change of sign."""
        self.amplification = self.choices.amplification(self.now)
        return self.choices.poor(self.now, self.amplification)

    def take(self) -> None:
        """Take the present instant into what the motion has covered."""
        self.covered.take(self.kinematics.evaluation.work, self.now.x, self.now.v, self.z)

    def natural_atol(self) -> Array:
        """Return the absolute tolerances of y."""
        return np.asarray(self.tolerances.atol * natural_scales_of_y(self.kinematics))

    def consider(self, factor: float) -> bool:
        """Change to the best degrees of freedom if the present ones are worse by a factor; whether they changed.

        Raises
        ------
        DynamicsError
            If they may not change, and are no longer usable; names them.
        """
        choices = self.choices
        if self.amplification <= self.allowed(factor):
            return False  # the amplification of any choice is about one or more
        other = choices.worse(self.now, self.amplification, factor)
        if other is None:
            return False
        if not choices.free:
            if self.amplification > lost(self.kinematics.roles) * choices.best:
                raise self.lost()
            return False  # shorter steps may still succeed
        before = choices.names
        choices.change(other, self.t)
        log.info("t = %.9g s: degrees of freedom %s instead of %s", self.t, choices.names, before)
        self.counts["rechoices"] += 1
        self.amplification = choices.best
        return True

    def lost(self) -> DynamicsError:
        """Return the error of degrees of freedom that can no longer describe the motion and may not change."""
        return DynamicsError(
            f"the degrees of freedom {self.kinematics.names(self.kinematics.roles.dofs)} cannot describe the "
            f"motion beyond "
            f"t = {self.t:g} s (the coordinates change {self.amplification:.2g} times as much as they do, "
            f"{self.choices.best:.2g} "
            "with the best choice): one of them has reached its extreme; omit rechoose=False, or name others with "
            "system.use_coordinates"
        )

    def shown(self, at: Snapshot) -> Kinematics:
        """Return the degrees of freedom in which states are given at the end of a step: the user's, where usable."""
        choices = self.choices
        if choices.kinematics is choices.own:
            return choices.own
        own = amplification(choices.own, at)
        return (
            choices.own
            if own <= lost(choices.own.roles) * max(self.amplification, 1.0)
            else choices.kinematics
        )

    def _accept_found(self, last: Snapshot, kink: bool) -> str | None:
        """Store the step that was found, up to a point where forces may change their law, and consider other degrees of
        freedom there.

        A step that has passed a flat position is replaced by those of `across`, if there are any.
        """
        first, method = self.now, self.method
        self.amplification = method.placed.amplification()
        dense, z = method.accept(last, kink)
        flat = self.dips.passed(self.kinematics, first, last, method.placed)
        if flat is not None and (steps := self.across(flat)):
            return self.carry(steps)
        self.account.note(last.t)
        self.counts["steps"] += 1
        ended = self.pass_step(dense, z)
        if ended is None and self.consider(WORSE):
            method.restart()
            self._shown = self.shown(self.now)
        return ended

    def carry(self, steps: list[Carried]) -> str | None:
        """Take steps across a flat position, and continue on the other side; returns a message as `advance` does.

        Steps that came too close to it are dropped.
        """
        self.counts["carried"] += 1
        begun = self.account.back(steps[0].t0)
        self.dips.back(steps[0].path.t0)
        ended = self.accept_carried(steps)
        self._balance_of(steps[0], begun)
        if ended is not None:
            return ended
        if steps[0].kinematics is not self.kinematics:
            self.choices.change(steps[0].kinematics, self.t)
            self.counts["rechoices"] += 1
        self.amplification = self.choices.amplification(self.now)
        self.consider(WORSE)
        self.method.restart_with(steps[-1].t1 - steps[-1].t0)
        if self.choices.changes:
            self._shown = self.shown(self.now)
        return None

    def _balance_of(self, step: Carried, begun: float) -> None:
        """Take the energies of a path into the account, which goes up to a time [s], from then up to now."""
        now = self.now
        work = self.kinematics.evaluation.at(now.t, now.x, now.v, np.zeros_like(now.v), self.z, now.e)
        work.laws()
        work.inertia()
        self.account.carry(work, now.t - begun, *step.path.exchanged(begun, now.t))
        self.account.note(now.t)

    def carry_or_stop(self, error: FlexelError) -> str | None:
        """Go on where steps are too short: across a flat position that is the cause, or by another method.

        Otherwise the error is raised.
        """
        if steps := self.across(self.t, at_once=True):
            return self.carry(steps)
        error = self.gives_up(error)
        left = error if self.stuck is None else self.stuck(self, error)
        if left is not None:
            raise left from None
        return None

    def evaluated(self, evaluations: int) -> None:
        """Count evaluations."""
        self.counts["evaluations"] += evaluations

    def imbalance(self) -> Imbalance:
        """Return the error of the energy balance, and how much tolerance, steps, rounding and doubt explain."""
        c, given, steps = self.account.struct, self.tolerances, self.counts["steps"]
        moved = max(c.fastest, c.through)
        sizes = moved + c.largest
        finest = self.covered.finest if given.relative else 0.0
        promised = explained(max(self.loosest, finest), steps) * moved
        allowed = promised + c.doubt + ROUNDING * max(steps, STEPS) ** 0.5 * sizes
        moves = moved > AT_REST * sizes and self.covered.fastest > STILL
        when = float(self.times[0]) + c.when
        missing, moved = (c.farthest, moved) if moves else (0.0, 0.0)
        return Imbalance(missing, moved, allowed, when, self.covered.widest)

    def workers_at(self, t: float) -> str:
        """Name what works most at the end of the step that ends near a time [s], after a colon."""
        if not self.stretches:
            return ""
        step = min(self.stretches, key=lambda step: abs(step.t1 - t))
        names = workers(step.kinematics, step.pending(step.t1).state())
        return f": {names}" if names else ""

    def dangers(self) -> list[str]:
        """Describe rounding errors, and positions that are nearly singular at the ends of steps."""
        return [*self._rounded(), *self._singular()]

    def _rounded(self) -> list[str]:
        """Describe where coordinates are rounded to more than the tolerance asks for."""
        covered, given = self.covered, self.tolerances
        of_step = covered.finest_of_step(self.t - float(self.times[0]), self.counts["steps"])
        far, most = covered.farthest > FAR, lib.FLEXEL_PROMISED * given.rtol
        if not given.relative or max(covered.finest * far, of_step) <= most or not self.imbalance().moved:
            return []
        if far:
            return [
                f"far from the origin, coordinates are rounded to {covered.finest:.1g} of the largest range in this "
                f"motion, and to {of_step:.1g} of what the fastest one moves in a step, and they or their rates cannot "
                f"be known to rtol = {given.rtol:g}: place the model near the origin"
            ]
        return [
            f"this motion is small beside the model: coordinates are rounded to {of_step:.1g} of what the fastest one "
            f"moves in a step, and rates cannot be known to rtol = {given.rtol:g}: scale the motion up if it is "
            "linear, or ask for a larger rtol"
        ]

    def _singular(self) -> list[str]:
        """Describe positions that are nearly singular, at the ends of steps."""
        if not self.dips.close:
            return []
        t, worst = max(self.dips.close, key=lambda pair: pair[1])
        return [
            f"the position is nearly singular at t = {t:.6g} s: coordinates change {worst:.1g} times as much as what "
            "holds them, so that forces lose digits, and the branch of the motion may depend on rounding: change "
            "dimensions so that the parts that line up there do so exactly, or clearly not, or end the motion earlier"
        ]

    def trouble(self, why: str) -> str:
        """Explain what may be wrong where the integration cannot continue."""
        names, roles = self.kinematics.names, self.kinematics.roles
        driven = f", check what drives {names(roles.prescribed)}" if roles.prescribed.size else ""
        self.choices.worse(self.now, np.inf, 1.0)
        if self.choices.best > SINGULAR:
            return (
                f"the position is singular there (gimbal lock of frames without inertia, or parts that line "
                f"up): {why}give "
                f"those frames inertia{driven}, or end the motion before {self.t:g} s"
            )
        if light := self.kinematics.hardly_moves(self.now):
            return (
                f"a motion of '{light}' moves almost no mass there, as where two axes of a gimbal coincide and its "
                f"angles are undetermined: {why}let it pass further from that position, measure angles about axes in "
                f"another order, give the frames between inertia{driven}, or end the motion before {self.t:g} s"
            )
        return (
            f"degrees of freedom {names(roles.dynamic)}: the motion is not smooth there; {why}check its loads and "
            f"laws{driven}, or end it before {self.t:g} s"
        )

    def gives_up(self, error: FlexelError) -> FlexelError:
        """Return the error of a motion whose steps are too short: that of kept coordinates, if others would work."""
        self.amplification = self.choices.amplification(self.now)
        if not self.choices.free and self.choices.worse(self.now, self.amplification, EXTREME) is not None:
            error = self.lost()
        elif shrunk := collapsed(self.system.structure, self.now.x):
            error = DynamicsError(
                f"the steps have become too short at t = {self.t:g} s: {shrunk}; keep these points apart by a "
                "stop or a stiffer spring, let forces act along coordinates if the points may pass one another, or end "
                f"the motion before {self.t:g} s"
            )
        return self.noted(error)

    def noted(self, error: FlexelError) -> FlexelError:
        """Return the error, with the time up to which the motion was computed."""
        error.add_note(f"the motion was computed up to t = {self.t:g} s")
        return error

    def kept(self, message: str) -> Integration:
        """Return the results so far, with the changes of the degrees of freedom."""
        return replace(super().kept(message), rechoices=self.choices.changes)
