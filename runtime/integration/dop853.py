"""DOP853 in C with predicted coordinates: what becomes of a trial, and the rules that keep a motion on its branch.

The step control is that of SciPy (Hairer, Norsett and Wanner 1993), with three more limits: the error of the
prediction, the sign of the determinant of the position matrix, which two solutions that meet in a fold have opposite,
and the distance of the solved coordinates and rates from the predicted ones.  Where these fail, other degrees of
freedom are chosen.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from flexel.base.arrays import Array
from flexel.base.errors import DynamicsError, FlexelError
from flexel.engine.coordinate_work import CoordinateWork
from flexel.engine.covered import Covered
from flexel.engine.step_control import StepControl
from flexel.integration.account import of_dop853
from flexel.integration.attempts import Attempted
from flexel.integration.dense import Allowed, Interpolant
from flexel.integration.dop853_row import ENDED, TRIED, Row
from flexel.integration.dop853_stages import B
from flexel.integration.dop853_steps import Steps
from flexel.integration.flat import crossing_step, flat_position
from flexel.integration.in_row import Looks, Place
from flexel.integration.step_method import (
    RESOLUTION,
    Found,
    InRow,
    StepMethod,
    Tolerances,
    natural_scales_of_y,
)
from flexel.model.snapshot import Snapshot
from flexel.model.structure import Structure

PREDICTED = 1e-3  # error of the prediction in one step, in natural scales
CAREFUL = 1e-6  # of the predicted coordinates and rates where the sign of the position matrix changes
TURNS = 0.1  # of periodic deformations, in periods
FARTHEST = 10.0  # distance of the solution from the prediction, in expected errors
FLOOR = 1e-5  # that is always allowed
STAYS = 0.8  # share of a defect that a step of 0.4 times the length leaves, if the length is not its cause
UNAMPLIFIED = 1.01  # amplification up to which coordinates do not enlarge errors
NOISE = 2.0  # of one step to another
TRUE = 0.1  # error of a step of order eight, relative to the estimates by its embedded formulas
FIRST = 1e-9  # least first step, relative to the time left: values of y that are rounding errors ask for less


class Dop853(StepMethod):
    """Steps by DOP853.

    Attributes
    ----------
    steps : Steps
    spare : Steps, optional
        Those of another motion that has ended, with the same tolerances: used again if the degrees of freedom are
        the same.
    h : float
        Length of the next trial [s].
    """

    name = "DOP853"
    quadrature = of_dop853()
    rows = True
    control = StepControl(order=8, most=10.0, unusable=0.4)
    steps: Steps
    spare: Steps | None = None
    h = 0.0
    _wished = 0.0  # that of the first one
    _end = 0.0  # when it ends at the latest
    _shortest = 0.0  # length below which it is too short [s]
    _to = 0.0  # when the last trial ends
    _code = 0  # what failed in it, or zero
    _error = np.inf  # its error over what is allowed
    _rejected = _careful = False
    _defect = np.inf  # of the rates, of a longer trial
    _found = np.inf  # the same of the last one, if that is why it was refused
    _jump = (-np.inf, False)  # a time [s], and whether forces jump after it
    _row: Row | None = None
    _resumes = False  # whether the last row has left a trial to be judged
    _noise = 0.0  # largest defect of the rates that shorter steps did not reduce, with a margin

    @classmethod
    def scale(cls, structure: Structure, weight: Array, given: Tolerances) -> Covered:
        """Return what a motion covers, as the scale of its tolerances."""
        return Covered(structure, weight, given.rtol, given.largest_atol, RESOLUTION, given.relative)

    def restart(self) -> None:
        """Restart from the present position in the present degrees of freedom."""
        course, self._jump = self.course, (-np.inf, False)
        y = course.choices.values(course.now, course.z)
        course.take()
        spare, self.spare = self.spare, None
        if spare is not None and spare.kinematics is course.kinematics:
            self.steps = spare
            spare.start(course.now, y, course.knots, course.covered)
        else:
            rtol, atol = course.tolerances.rtol, course.natural_atol()
            self.steps = Steps(course.kinematics, course.now, y, rtol, atol, course.knots, course.covered)
        self.steps.struct.account = course.account.struct
        self.renew()
        if not self.h:
            self.h = course.tolerances.first_step or self._first_step()

    def reuse(self, other: StepMethod) -> None:
        """Use the arrays of another motion by this method, if the degrees of freedom are the same."""
        if isinstance(other, Dop853):
            self.spare = other.steps

    @property
    def placed(self) -> CoordinateWork:
        """The arrays that hold the position at the end of the step that was found last."""
        return self.steps.choice

    def restart_with(self, h: float) -> None:
        """Restart beyond a flat position with a step [s] to try first."""
        self.h, self.flat = h, -np.inf
        self.restart()

    def renew(self) -> None:
        """Compute the rates with the changed loads."""
        self.steps.begin(self.course.t)
        self.course.counts["evaluations"] += 1

    def jump(self) -> None:
        """Continue from the present position, where internal states have jumped, with the same length of steps."""
        z = self.course.z
        self.steps.y[self.steps.y.size - z.size :] = z
        self.renew()

    def _first_step(self) -> float:
        """The first step, as SciPy chooses it from the size of the rates and of their change."""
        s, course = self.steps, self.course
        longest, left = course.tolerances.max_step, course.stop - course.t
        y, f = s.y.copy(), s.K[0].copy()
        scale = course.natural_atol() + np.abs(y) * course.tolerances.rtol
        d0, d1 = _norm(y / scale), _norm(f / scale)
        h0 = min(1e-6 if d0 < 1e-5 or d1 < 1e-5 else 0.01 * d0 / d1, left)
        try:
            change = self._rates_at(course.t + h0, y + h0 * f) - f
        except FlexelError:
            return min(1e-4 * left, longest)
        d2 = _norm(change / scale) / h0
        h1 = max(1e-6, h0 * 1e-3) if d1 <= 1e-15 and d2 <= 1e-15 else (0.01 / max(d1, d2)) ** (1 / 8)
        return float(min(max(100 * h0, FIRST * left), h1, left, longest))

    def _rates_at(self, t: float, y: Array) -> Array:
        course, kinematics = self.course, self.course.kinematics
        choice, now = kinematics.given(course.knots.inside(t)), course.now
        ahead = now.x + (t - now.t) * now.v
        course.counts["evaluations"] += 1
        kinematics.check(choice.evaluate(t, y, ahead, now.turns(t)), t)
        return choice.dy.copy()

    def aim(self, end: float, shortest: float) -> None:
        """Prepare a step that ends at a time [s] at the latest."""
        self._end, self._wished, self._shortest = end, self.h, shortest
        self._rejected, self._careful, self._defect = False, False, np.inf
        if self._resumes and self._row is not None:
            r, self._resumes = self._row.struct, False
            self._wished, self._rejected = float(r.first), r.tries > 0

    def attempt(self) -> Attempted:
        """Try the step that is prepared."""
        course, t = self.course, self.course.t
        short = self.h < self._shortest and self.h < self._end - t
        if short and not self._jumps(t):
            return Attempted.SHORT
        if short and self.h < course.resolution:
            return self._cross(t)
        c = self.steps.struct
        if not self.tried:
            ahead = crossing_step(self.flat - t, min(self.h, course.tolerances.max_step))
            self._to = min(t + ahead, self._end)
            self._try(t)
        self.tried = False
        self._error, self._found = self._largest_error() if not self._code else np.inf, self._defect
        if self._error < 1:
            trusted = self._trusted()
            exact = trusted and self._exact(self._defect)
            if exact and not (c.changed and (self._rough() or self._poor(t))):
                return Attempted.FOUND
            if trusted and not exact:
                self._found = float(c.defect_v)
            self._error = np.inf
        course.counts["rejected"] += 1
        return self.refuse(False) if np.isfinite(self._error) else Attempted.UNUSABLE

    def _try(self, t: float) -> None:
        """Make the trial from a time [s], up to the one that is set."""
        before = self.steps.struct.evaluations
        self._code = self.steps.step(t, self._to - t, self._careful)
        self.course.counts["evaluations"] += self.steps.struct.evaluations - before

    def _jumps(self, t: float) -> bool:
        """Whether forces jump after a time [s]: in a step that is as short as it may be, rates hardly change."""
        if self._jump[0] == t:
            return self._jump[1]
        self._to, self.tried = min(t + self._shortest, self._end), False
        self._try(t)
        c, kinematics = self.steps.struct, self.course.kinematics
        rates = slice(kinematics.roles.nq, kinematics.roles.nq + kinematics.roles.nd)
        change = np.abs(self.steps.K - self.steps.K[0])[:, rates] / natural_scales_of_y(kinematics)[rates]
        slight = (self._to - t) * change.max(initial=0.0) <= PREDICTED * c.fastest  # false for NaN
        self._jump = t, bool(slight and not self._code and not c.changed)
        return self._jump[1]

    def _cross(self, t: float) -> Attempted:
        """Cross a jump of forces in the shortest step of all; its error is that of an instant, known no better."""
        self._to, self.tried = min(t + self.course.resolution, self._end), False
        self._try(t)
        if self._code or self.steps.struct.changed or not (self._trusted() and self._exact(self._defect)):
            return Attempted.SHORT
        self._error = min(self._largest_error(), 0.5)
        return Attempted.FOUND

    def _poor(self, t: float) -> bool:
        """Whether other degrees of freedom may explain a change of sign of the trial from a time [s].

        If not, the trial is made again: the answer was found in its workspace.
        """
        if self.course.poor():
            return True
        self._try(t)
        return False

    def end(self) -> Snapshot:
        """Return the point at the end of the step that was found."""
        return self.steps.end(self._to)

    def cut(self, h: float) -> None:
        """Prepare a step of length h [s] instead of the one that was found."""
        self.h = h

    def refuse(self, changed: bool) -> Attempted:
        """Prepare a shorter step, or first one of the same length that shows why it was of no use."""
        h = self._to - self.course.t
        longer, self._defect = self._defect, self._found
        if changed:
            self.flat = -np.inf
            self.restart()
        elif not self._careful and not self._code and (self._rejected or self._suspicious()):
            self._careful, self._defect = True, longer
            return Attempted.AGAIN
        shows = self._careful and not self._code and self._shows_flat(h)
        if not shows:
            self.h = h * self.control.shorter(self._error)
        self._rejected = True
        return Attempted.FLAT if shows else Attempted.AGAIN

    def accept(self, last: Snapshot, kink: bool) -> Found:
        """Continue from the end of the step that was found."""
        course, s, first = self.course, self.steps, self.course.now
        self._lengthen(last.t - first.t)
        if s.struct.changed:
            course.counts["bifurcations"] += 1
            s.struct.sign = -s.struct.sign
        y1, covered = s.y_new.copy(), course.covered
        of_step = s.scale.copy(), s.w_scale.copy(), y1, covered.ranges(y1), covered.part
        allowed = Allowed(*of_step, course.tolerances.relative)
        z = y1[y1.size - course.z.size :]
        exactness = float(s.struct.rtol), float(s.choice.struct.accept)
        begun = s.y.copy(), s.K[0].copy(), s.w.copy(), s.w_rates[0].copy()
        dense = Interpolant(
            course.kinematics, first, last, *begun, z, allowed, course.knots.interval, *exactness
        )
        stored = course.until < last.t
        if course.dense_at_once or stored:
            dense.take(s, stored)
        s.accept()
        return Found(dense, z)

    def _lengthen(self, h: float) -> None:
        """Wish for the length of the next step, after one of length h [s]."""
        factor = self.control.longer(self._error)
        self.h = h * (min(1.0, factor) if self._rejected else factor)
        if self._to == self._end and not self._rejected:
            self.h = max(self.h, self._wished)  # it was cut short

    def _largest_error(self) -> float:
        """The largest of the errors of a step, relative to what is allowed."""
        c = self.steps.struct
        found = max(c.error, c.error_own, c.error_x / PREDICTED, c.error_turns / TURNS)
        return float(found) if np.isfinite(found) else np.inf

    def _rough(self) -> bool:
        """Whether the prediction is too inexact to tell a flat position from a fold by it."""
        c = self.steps.struct
        return bool(max(c.error_x, c.error_v / (c.fastest or 1.0)) > CAREFUL)

    def _suspicious(self) -> bool:
        """Whether a step may have been refused because one of its stages is close to a flat position."""
        c = self.steps.struct
        return bool(c.changed) or not c.defect_v <= TRUE * (c.error_v + self._allowed())

    def _allowed(self) -> float:
        """Error of the rates within the tolerance."""
        given = self.course.tolerances
        return float(given.largest_atol + given.rtol * self.steps.struct.fastest)

    def _shows_flat(self, h: float) -> bool:
        """Whether a refused step of this length [s] shows a flat position that was not known."""
        t = self.course.t
        known, share = self.flat > t, flat_position(self.steps.determinant)
        self.flat = -np.inf if share is None else float(t + share * h)
        return share is not None and not known

    def _trusted(self) -> bool:
        """Whether the solved coordinates are where they were predicted, within what is expected."""
        c, given = self.steps.struct, self.course.tolerances
        expected = c.error_x + self.course.amplification * (given.largest_atol + given.rtol)
        return bool(c.defect <= FARTHEST * max(expected, FLOOR))

    def _exact(self, longer: float) -> bool:
        """Whether the solved rates are the predicted ones: near an extreme of a degree of freedom they are not.

        A defect no smaller than that of a longer, refused step is not an error of the step. Later steps may have such a
        defect too, within the tolerance that the coordinates enlarge, or each would have to be shorter than the last.
        """
        c, allowed = self.steps.struct, self._allowed()
        enlarged = max(self.course.amplification, 1.0)  # zero where every motion is prescribed
        if c.defect_v > min(c.error_v, PREDICTED * c.fastest) + enlarged * allowed:
            return False  # without an impulse rates do not jump
        expected = TRUE * (c.error_v + allowed) + min(self._noise, enlarged * allowed)
        if c.defect_v <= expected or self.steps.choice.amplification() <= UNAMPLIFIED:
            return True
        if stays := bool(c.defect_v > STAYS * longer):
            self._noise = max(self._noise, NOISE * c.defect_v)
        return stays

    # -- steps that are taken in a row, or in a lane ---------------------------------------------------

    @property
    def usual(self) -> bool:
        """Whether the usual rules have applied to all earlier steps."""
        return not self._noise and self.flat <= self.course.t

    def give_rules(self, struct: Any) -> None:
        """Write the rules of usual steps into a struct of dop853_rules.h."""
        given = self.course.tolerances
        self.control.give(struct.control)
        struct.rtol, struct.atol = given.rtol, given.largest_atol
        struct.predicted, struct.turns, struct.farthest, struct.floor = PREDICTED, TURNS, FARTHEST, FLOOR
        struct.exact, struct.unamplified = TRUE, UNAMPLIFIED

    def row(self, most: int, allowed: float) -> Sequence[InRow]:
        """Take up to `most` steps in a row, from the present point; see `StepMethod.row`."""
        if not self.usual:
            return ()
        course, steps, counts = self.course, self.steps, self.course.counts
        row = self._row
        if row is None or row.steps is not steps or row.times is not course.times:
            row = self._row = self._new_row()
        before = steps.struct.evaluations
        place = Place(course.t, course.stop, course.amplification, allowed, most)
        found = row.take(place, course.now, self.h, course.stored, course.z.size, course.knots.interval)
        r = row.struct
        self.h, self._to, self._code = float(r.h), float(r.to), int(r.code)
        self.tried = self._resumes = self.unusual = row.ended == TRIED
        counts["evaluations"] += steps.struct.evaluations - before
        counts["rejected"] += int(r.refused + r.tries * (row.ended != ENDED))
        return found

    def forget_trial(self) -> None:
        """The workspace no longer holds the trial that a row has made: it is to be made again."""
        super().forget_trial()
        if self._row is not None:
            self.course.counts["evaluations"] -= int(self._row.struct.cost)

    def _new_row(self) -> Row:
        course = self.course
        looks = Looks(course.touching.look, course.dips, course.least)
        row = Row(self.steps, looks, course.times, course.tolerances)
        self.give_rules(row.struct.rules)
        return row

    def stopped(self) -> FlexelError:
        """Return the error of steps that have become too short."""
        course, kinematics = self.course, self.course.kinematics
        if self._code:
            return kinematics.failure(self._code, course.t, self.steps.choice)
        c, s, jumped = self.steps.struct, kinematics.structure, ""
        if not self._trusted():
            jumped = f"'{s.names[s.m + s.k + c.farthest]}' jumps by {c.defect:.2g} of its natural scale{self._cut()}; "
        return DynamicsError(
            f"the steps have become too short at t = {course.t:g} s (amplification {course.amplification:.2g}, "
            f"with the best choice {course.choices.best:.2g}): {course.trouble(jumped)}"
        )

    def _cut(self) -> str:
        """The rigid deformation that jumps, if one does: it is far from zero where the coordinates lead smoothly."""
        s, kinematics = self.steps, self.course.kinematics
        nf, rigid, x = kinematics.structure.nf, kinematics.roles.rigid, s.x.copy()
        x[:nf] += (self._to - self.course.t) * (B @ s.V[:12])
        e = kinematics.evaluation.position(x, self.course.now.e)[0]
        off = np.abs(kinematics.values(e, x)[rigid]) / kinematics.scales(rigid)
        if not off.size or off.max() < FLOOR:
            return ""
        name = kinematics.structure.names[rigid[int(np.argmax(off))]]
        return f", and the rigid deformation '{name}' by {off.max():.2g}: declare its period in its element"


def _norm(x: Array) -> float:
    return float(np.linalg.norm(x) / x.size**0.5)
