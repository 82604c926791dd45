"""DOP853 in C with predicted coordinates: step control, and the rules that keep a motion on its branch.

The step control is that of SciPy (Hairer, Norsett and Wanner 1993), with three more limits: the error of the
prediction, the sign of the determinant of the position matrix, which two solutions that meet in a fold have opposite,
and the distance of the solved coordinates and rates from the predicted ones.  Where these fail, other degrees of
freedom are chosen.  A step ends where a contact begins or ends.
"""

from __future__ import annotations

import numpy as np

from flexel.base.arrays import Array
from flexel.base.errors import DynamicsError, FlexelError
from flexel.engine.coordinate_work import CoordinateWork
from flexel.generated._kernels import lib
from flexel.integration.account import of_dop853
from flexel.integration.branch import REFUSED
from flexel.integration.dense import UNRELIABLE, Interpolant
from flexel.integration.dop853_stages import B
from flexel.integration.dop853_steps import Steps
from flexel.integration.flat import crossing_step, flat_position
from flexel.integration.minimal import SHORTEST, MinimalRun
from flexel.integration.segments import Step
from flexel.integration.touching import TRIALS, TouchingContacts
from flexel.model.snapshot import Snapshot

SAFETY, SMALLEST, LARGEST = 0.9, 0.2, 10.0  # factors of the step control
EXPONENT = -1 / 8
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
SHORTER = 0.4  # factor of a step that is refused


class Dop853(MinimalRun):
    """One run of DOP853.

    Attributes
    ----------
    steps : Steps
    spare : Steps, optional
        Those of another motion that has ended, with the same tolerances: used again if the degrees of freedom are
        the same.
    touching : TouchingContacts
    """

    steps: Steps
    touching: TouchingContacts
    spare: Steps | None = None
    method = "DOP853"
    quadrature = of_dop853()
    _h = 0.0
    _tried = 0.0
    _failed = 0
    _noise = 0.0  # largest defect of the rates that shorter steps did not reduce, with a margin
    _flat = -np.inf  # time of a flat position that steps were refused at

    def restart(self) -> None:
        """Restart from the present position in the present degrees of freedom."""
        y = self.choices.values(self.now, self.z)
        self.take()
        self.touching = TouchingContacts(self.kinematics.evaluation.work.tables)
        spare, self.spare = self.spare, None
        if spare is not None and spare.kinematics is self.kinematics:
            self.steps = spare
            spare.start(self.now, y, self.knots, self.covered)
        else:
            rtol, atol = self.tolerances.rtol, self.natural_atol()
            self.steps = Steps(self.kinematics, self.now, y, rtol, atol, self.knots, self.covered)
        self.steps.struct.account = self.account.struct
        self.renew()
        if not self._h:
            self._h = self.tolerances.first_step or self._first_step()

    @property
    def placed(self) -> CoordinateWork:
        """The arrays that hold the position at the end of the step that was found last."""
        return self.steps.choice

    def restart_with(self, h: float) -> None:
        """Restart with a step [s] to try first."""
        self._h, self._flat = h, -np.inf
        self.restart()

    def renew(self) -> None:
        """Compute the rates with the changed loads."""
        self.steps.begin(self.t)
        self.counts["evaluations"] += 1

    def jump(self, z: Array) -> None:
        """Continue from here with other internal states and the same length of steps."""
        self.z = z
        self.account.part()
        self.steps.y[self.steps.y.size - z.size :] = z
        self.renew()

    def _first_step(self) -> float:
        """The first step, as SciPy chooses it from the size of the rates and of their change."""
        s, left = self.steps, self.stop - self.t
        y, f = s.y.copy(), s.K[0].copy()
        scale = self.natural_atol() + np.abs(y) * self.tolerances.rtol
        d0, d1 = _norm(y / scale), _norm(f / scale)
        h0 = min(1e-6 if d0 < 1e-5 or d1 < 1e-5 else 0.01 * d0 / d1, left)
        try:
            change = self._rates_at(self.t + h0, y + h0 * f) - f
        except FlexelError:
            return min(1e-4 * left, self.tolerances.max_step)
        d2 = _norm(change / scale) / h0
        h1 = max(1e-6, h0 * 1e-3) if d1 <= 1e-15 and d2 <= 1e-15 else (0.01 / max(d1, d2)) ** (1 / 8)
        return float(min(max(100 * h0, FIRST * left), h1, left, self.tolerances.max_step))

    def _rates_at(self, t: float, y: Array) -> Array:
        choice = self.kinematics.given(self.knots.inside(t))
        ahead = self.now.x + (t - self.t) * self.now.v
        self.counts["evaluations"] += 1
        self.kinematics.check(choice.evaluate(t, y, ahead, self.now.turns(t)), t)
        return choice.dy.copy()

    def advance(self) -> str | None:
        """Take one accepted step."""
        end, rejected, careful, defect = self.latest, False, False, np.inf
        first_order, trials = self.steps.first_order, TRIALS
        wished = self._h
        while True:
            s, c = self.steps, self.steps.struct
            shortest = max(SHORTEST * self._span, 10 * abs(np.nextafter(self.t, np.inf) - self.t))
            if self._h < shortest and self._h < end - self.t:
                return self.carry_or_stop(self._stopped())
            t1 = min(self.t + crossing_step(self._flat - self.t, min(self._h, self.tolerances.max_step)), end)
            h = self._tried = t1 - self.t
            before = c.evaluations
            code = s.step(self.t, h, careful)
            self.counts["evaluations"] += c.evaluations - before
            error, longer = self._error() if not code else np.inf, defect
            if error < 1:
                trusted = self._trusted()
                exact = trusted and self._exact(defect)
                if exact and not (c.changed and (self._rough() or self._poor())):
                    trials -= 1
                    last = s.end(t1)
                    until = self.touching.until(self.now, last) if trials > 0 else 0.0
                    if until <= shortest:
                        break
                    self._h = until
                    self.counts["rejected"] += 1
                    continue
                if trusted and not exact:
                    defect = float(c.defect_v)
                error = np.inf
            self._failed = code
            self.counts["rejected"] += 1
            if first_order:  # a failed trial must not leave another order of pivots behind
                self.steps.use_first_order()
            if not np.isfinite(error) and self.consider_refused():
                self._flat = -np.inf
                self.restart()
            elif not careful and not code and (rejected or self._suspicious()):
                careful, defect = True, longer  # the same length again
                continue
            if careful and not code and self._finds(h):
                if steps := self.across(self._flat):
                    return self.carry(steps)
            else:
                self._h = h * (max(SMALLEST, SAFETY * error**EXPONENT) if np.isfinite(error) else SHORTER)
            rejected = True
        factor = min(LARGEST, SAFETY * error**EXPONENT) if error > 0 else LARGEST
        self._h = h * (min(1.0, factor) if rejected else factor)
        if t1 == end and not rejected:
            self._h = max(self._h, wished)  # it was cut short
        ended = self._accepted(last)
        if trials < TRIALS - 1:  # the step was cut: a contact begins or ends here
            self._looks.forget()
        return ended

    def _error(self) -> float:
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
        return float(self.largest_atol + self.tolerances.rtol * self.steps.struct.fastest)

    def _finds(self, h: float) -> bool:
        """Whether a refused step of this length [s] shows a flat position that was not known."""
        known, share = self._flat > self.t, flat_position(self.steps.determinant)
        self._flat = -np.inf if share is None else float(self.t + share * h)
        return share is not None and not known

    def _poor(self) -> bool:
        """Whether other degrees of freedom are so much better that they may explain a change of sign."""
        self.amplification = self.choices.amplification(self.now)
        return self.choices.poor(self.now, self.amplification)

    def _trusted(self) -> bool:
        """Whether the solved coordinates are where they were predicted, within what is expected."""
        c, given = self.steps.struct, self.tolerances
        expected = c.error_x + self.amplification * (self.largest_atol + given.rtol)
        return bool(c.defect <= FARTHEST * max(expected, FLOOR))

    def _exact(self, longer: float) -> bool:
        """Whether the solved rates are the predicted ones: near an extreme of a degree of freedom they are not.

        A defect no smaller than that of a longer, refused step is not an error of the step. Later steps may have such a
        defect too, within the tolerance that the coordinates enlarge, or each would have to be shorter than the last.
        """
        c, allowed = self.steps.struct, self._allowed()
        enlarged = max(self.amplification, 1.0)  # zero where every motion is prescribed
        if c.defect_v > min(c.error_v, PREDICTED * c.fastest) + enlarged * allowed:
            return False  # without an impulse rates do not jump
        expected = TRUE * (c.error_v + allowed) + min(self._noise, enlarged * allowed)
        if c.defect_v <= expected or self.steps.choice.amplification() <= UNAMPLIFIED:
            return True
        if stays := bool(c.defect_v > STAYS * longer):
            self._noise = max(self._noise, NOISE * c.defect_v)
        return stays

    def consider_refused(self) -> bool:
        """Change to better degrees of freedom at the start of a refused step."""
        self.amplification = self.choices.amplification(self.now)
        return self.consider(REFUSED)

    def _accepted(self, last: Snapshot) -> str | None:
        s, first = self.steps, self.now
        if s.struct.changed:
            self.counts["bifurcations"] += 1
            s.struct.sign = -s.struct.sign
        self.amplification = s.choice.amplification()
        allowed = self.allowed_inside(
            s.scale, s.w_scale, s.y, s.y_new, self.covered.ranges(s.y_new), self.covered.part
        )
        z = s.y_new[s.y_new.size - self.z.size :].copy()
        exactness = float(s.struct.rtol), float(s.choice.struct.accept)
        begun = s.y.copy(), s.K[0].copy(), s.w.copy(), s.w_rates[0].copy()
        dense = Interpolant(self.kinematics, first, last, *begun, z, allowed, self.knots.interval, *exactness)
        stored = self.until < last.t
        if self.events or stored:
            dense.take(s, stored)
        s.accept()
        return self.end_step(first.t, dense, first, z, last)

    def allowed_inside(
        self, scale: Array, w_scale: Array, y0: Array, y1: Array, ranges: Array, part: float
    ) -> Array:
        """Return errors allowed of an interpolation from y0 to y1, from those of the step at its end.

        Rates that hardly change are as exact relative to their range, as all that is stored: at its end a step is more
        exact than it has to be. An error that only rounding explains is not more of an interpolation.
        """
        allowed, roles = scale.copy(), self.kinematics.roles
        if self.tolerances.relative:
            rates = slice(roles.nq, roles.nq + roles.nd)
            rtol, size = part * self.tolerances.rtol, np.maximum(np.abs(y0), np.abs(y1))[rates]
            rounded = (allowed[rates] - rtol * size) / UNRELIABLE
            allowed[rates] = rounded + rtol * np.minimum(size, ranges[rates])
        return self.steps.rotations.allowed(allowed, w_scale) / part

    # -- steps that are taken in a lane, see abreast.py ------------------------------------------------

    @property
    def usual(self) -> bool:
        """Whether the usual rules have applied to all earlier steps."""
        return not self._noise and self._flat <= self.t

    @property
    def next_step(self) -> float:
        """Length of the next step [s]."""
        return self._h

    def pass_step(self, first: Snapshot, last: Snapshot, dense: Interpolant) -> None:
        """Store the states at the times within an accepted step."""
        self.accept(Step(first.t, last.t, self.kinematics, self._shown, first, last, dense), dense.z1)

    def go_on_alone(self, now: Snapshot, h: float, amplification: float) -> None:
        """Continue from the start of a step, whose variables and rates are in `steps`."""
        self.now, self.z, self._h, self.amplification = (
            now,
            self.steps.y[self.steps.y.size - self.z.size :].copy(),
            h,
            amplification,
        )
        self.account.note(now.t)

    def count(self, taken: int, refused: int) -> None:
        """Count steps that were taken and refused."""
        self.counts["steps"] += taken
        self.counts["rejected"] += refused
        self.counts["evaluations"] += lib.FLEXEL_STAGES * (taken + refused)

    def _stopped(self) -> FlexelError:
        """The error of steps that have become too short."""
        if self._failed:
            return self.kinematics.failure(self._failed, self.t, self.steps.choice)
        c, s, jumped = self.steps.struct, self.system.structure, ""
        if not self._trusted():
            jumped = f"'{s.names[s.m + s.k + c.farthest]}' jumps by {c.defect:.2g} of its natural scale{self._cut()}; "
        return DynamicsError(
            f"the steps have become too short at t = {self.t:g} s (amplification {self.amplification:.2g}, "
            f"with the best choice {self.choices.best:.2g}): {self.trouble(jumped)}"
        )

    def _cut(self) -> str:
        """The rigid deformation that jumps, if one does: it is far from zero where the coordinates lead smoothly."""
        s, kinematics = self.steps, self.kinematics
        nf, rigid, x = kinematics.structure.nf, kinematics.roles.rigid, s.x.copy()
        x[:nf] += self._tried * (B @ s.V[:12])
        e = kinematics.evaluation.position(x, self.now.e)[0]
        off = np.abs(kinematics.values(e, x)[rigid]) / kinematics.scales(rigid)
        if not off.size or off.max() < FLOOR:
            return ""
        name = kinematics.structure.names[rigid[int(np.argmax(off))]]
        return f", and the rigid deformation '{name}' by {off.max():.2g}: declare its period in its element"


def _norm(x: Array) -> float:
    return float(np.linalg.norm(x) / x.size**0.5)
