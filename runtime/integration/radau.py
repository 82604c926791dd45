"""Radau IIA of order 5 in minimal coordinates: its Jacobian, and the rules that keep a motion on its branch.

The steps and their control are in C, see radau.h.  The Jacobian is that of the analytic linearization, and kept while
the iteration converges.
"""

from __future__ import annotations

import logging
from collections.abc import Sequence

import numpy as np

from flexel.base.arrays import Array
from flexel.base.errors import DynamicsError, FlexelError, PositionError
from flexel.engine.coordinate_work import CoordinateWork
from flexel.engine.covered import Covered
from flexel.engine.finite import TangentError
from flexel.engine.step_control import StepControl
from flexel.generated._kernels import lib
from flexel.integration.account import of_radau
from flexel.integration.attempts import Attempted
from flexel.integration.in_row import Looks, Place
from flexel.integration.jacobian import jacobian
from flexel.integration.radau_row import RadauRow
from flexel.integration.radau_saddle import SaddleFactors, sparse
from flexel.integration.radau_steps import FINEST, Collocation, estimated
from flexel.integration.step_method import Found, InRow, StepMethod, Tolerances
from flexel.model.snapshot import Snapshot
from flexel.model.structure import Structure

log = logging.getLogger("flexel.simulate")
CAREFUL = 1e-8  # distance of the end of a step from the integral of its rates, in natural scales, by the method and by
# the trapezoidal rule, up to which the sign of the position matrix may change: the path is smooth


class Radau(StepMethod):
    """Steps by Radau IIA."""

    name = "Radau"
    quadrature = of_radau()
    control = StepControl(
        order=4, most=8.0, steady=1.2
    )  # of the error estimate; other factors of the matrices
    steps: Collocation
    _begun = False
    _saddle: SaddleFactors | None = None
    _failed: FlexelError | None = None  # why the last trial failed
    _no_slope: TangentError | None = None
    _code = 0  # of what failed in it, or zero
    _wished = 0.0  # length of the first trial [s]
    _row: RadauRow | None = None
    rows = True

    @classmethod
    def scale(cls, structure: Structure, weight: Array, given: Tolerances) -> Covered:
        """Return what a motion covers, as the scale of its tolerances."""
        rtol, finest = given.rtol, FINEST * given.rtol / estimated(given.rtol)
        return Covered(structure, weight, rtol, given.largest_atol, finest, given.relative, full=np.inf)

    def reuse(self, other: StepMethod) -> None:
        """Use nothing of another motion: its Jacobian would be that of another position."""

    def restart(self) -> None:
        """Restart from the present position in the present degrees of freedom."""
        course, before = self.course, self.steps if self._begun else None
        y, left = course.choices.values(course.now, course.z), course.stop - course.t
        course.take()
        if before is None or before.kinematics is not course.kinematics:
            self.steps = self._collocation()
        self._begun, steps = True, self.steps
        steps.struct.account = course.account.struct
        other = before if before is not steps else None
        if other is not None:
            steps.take_over(other)
        steps.start(course.now, y, course.knots, course.covered)
        course.counts["evaluations"] += 1
        if other is not None:
            steps.resume(other)
        if before is None:
            steps.struct.h = course.tolerances.first_step or steps.first_step(left)
        else:
            steps.struct.h = before.struct.h

    def _collocation(self) -> Collocation:
        """Steps in the present degrees of freedom."""
        kinematics, given = self.course.kinematics, self.course.tolerances
        if self._saddle is None and sparse(kinematics):
            self._saddle = SaddleFactors(kinematics)
        elif self._saddle is not None:
            self._saddle.choose(kinematics)
        steps = Collocation(kinematics, given.rtol, self.course.natural_atol(), given.minor, self._saddle)
        self.control.give(steps.struct.control)
        return steps

    @property
    def placed(self) -> CoordinateWork:
        """The arrays that hold the position at the end of the step that was found last."""
        return self.steps.choice

    def restart_with(self, h: float) -> None:
        """Restart beyond a flat position with a step [s] to try first."""
        self.steps.struct.h = h
        self.restart()
        self.steps.struct.stale = True  # close to a flat position the Jacobian is noise

    def aim(self, end: float, shortest: float) -> None:
        """Prepare a step that ends at a time [s] at the latest."""
        c = self.steps.struct
        self._wished, c.end, c.longest = c.h, end, self.course.tolerances.max_step
        c.shortest = shortest

    def attempt(self) -> Attempted:
        """Try the step that is prepared, and shorter ones until the error is small."""
        course, steps, c = self.course, self.steps, self.steps.struct
        c.enlarged = max(1.0, course.amplification / max(1.0, course.choices.best))
        before = c.evaluations, c.refused
        self._code = steps.step()
        self._count(before)
        if self._code == lib.FLEXEL_RADAU_JACOBIAN:
            self._evaluate_jacobian(course.now, course.z)
            return Attempted.AGAIN
        if self._code == lib.FLEXEL_RADAU_SHORT:
            return Attempted.SHORT
        if not self._code and self._trusted():
            return Attempted.FOUND
        self._failed = (
            course.kinematics.failure(self._code, c.t + c.h, steps.choice) if self._code else self._off()
        )
        course.counts["rejected"] += 1
        return Attempted.UNUSABLE

    def _count(self, before: tuple[int, int]) -> None:
        """Count evaluations and refused steps, since there were so many."""
        c, counts = self.steps.struct, self.course.counts
        counts["evaluations"] += c.evaluations - before[0]
        counts["rejected"] += c.refused - before[1]

    def row(self, most: int, allowed: float) -> Sequence[InRow]:
        """Take up to `most` steps in a row, from the present point; see `StepMethod.row`.

        The trial of an unusual one is made anew: states that are stored up to there are found in the same workspace,
        and the motion must not depend on them.
        """
        course, steps, c = self.course, self.steps, self.steps.struct
        row = self._row
        if row is None or row.steps is not steps:
            row = self._row = RadauRow(steps, Looks(course.touching.look, course.dips, course.least))
        before, c.longest = (c.evaluations, c.refused), course.tolerances.max_step
        place = Place(course.t, course.stop, course.amplification, allowed, most)
        found = row.take(place, course.now, course.choices.best, course.z.size, self._evaluate_jacobian)
        self.unusual = row.unusual
        self._count(before)
        if found:
            self._failed = None
        return found

    def refuse(self, changed: bool) -> Attempted:
        """Prepare a shorter step."""
        c = self.steps.struct
        log.debug("another trial at t = %.9g s with a shorter step: %s", c.t, self._failed)
        wished, end = self._wished, c.end
        self.steps.refuse(self.control.shorter())
        if changed:
            self.restart()
            self.aim(end, c.shortest)
            self._wished = wished
        return Attempted.AGAIN

    def end(self) -> Snapshot:
        """Return the point at the end of the step that was found."""
        c = self.steps.struct
        return self.steps.end(c.end if c.h == c.end - c.t else c.t + c.h)

    def cut(self, h: float) -> None:
        """Prepare a step of length h [s] instead of the one that was found."""
        c = self.steps.struct
        c.h, c.waiting = h, False
        c.last_error = (
            0.0  # the error does not choose this length: the next one must not be predicted from it
        )

    def accept(self, last: Snapshot, kink: bool) -> Found:
        """Continue from the end of the step that was found."""
        course, steps, c = self.course, self.steps, self.steps.struct
        self._failed = None
        course.counts["bifurcations"] += bool(c.changed)
        cut, h = c.h < self._wished and not c.rejected, c.h
        dense = steps.accept(course.now, last)
        if kink:
            c.stale, c.last_error = True, 0.0
        elif cut and c.t == c.end and c.last_h == h:
            c.h = max(c.h, self._wished)
        return Found(dense, dense.end[dense.end.size - course.z.size :].copy())

    def _evaluate_jacobian(self, now: Snapshot, z: Array) -> None:
        """The Jacobian at the start of a step; where a law has no slope, the last one serves, with shorter steps."""
        course, steps = self.course, self.steps
        try:
            if steps.saddle is None:
                steps.look(jacobian(course.kinematics, now, z))
            else:
                steps.saddle.look(course.kinematics, now, z)
                if steps.turns.rotations.count:
                    steps.choose_axes(steps.saddle.acting())
            self._no_slope = None
        except TangentError as error:
            self._no_slope = error
        except FlexelError as error:
            raise course.noted(error) from None
        steps.look_again()

    def _trusted(self) -> bool:
        """Whether the end of a step is on the branch of its start."""
        c = self.steps.struct
        return not c.changed or bool(max(c.off, c.coarse) <= CAREFUL)

    def _off(self) -> PositionError:
        """The error of a step whose end is somewhere else."""
        c, kinematics = self.steps.struct, self.course.kinematics
        s, roles = kinematics.structure, kinematics.roles
        name = s.names[s.m + s.k + c.farthest]
        driven = f"check what drives {kinematics.names(roles.prescribed)}, " if roles.prescribed.size else ""
        return PositionError(
            f"position at t = {c.t + c.h:g} s cannot be reached: '{name}' is not where its rate leads; the position "
            f"may be singular there, or a deformation jumps; {driven}choose other degrees of freedom, or DOP853"
        )

    def stopped(self) -> FlexelError:
        """Return the error of steps that have become too short."""
        if self._no_slope:
            return self._no_slope
        return self._failed or DynamicsError(
            f"integration failed at t = {self.course.t:g} s: the step has become too short; {self.course.trouble('')}"
        )
