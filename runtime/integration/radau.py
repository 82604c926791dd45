"""Radau IIA of order 5 in minimal coordinates: its Jacobian, and the rules that keep a motion on its branch.

The steps and their control are in C, see radau.h.  The Jacobian is that of the analytic linearization, and kept while
the iteration converges.
"""

from __future__ import annotations

import logging

import numpy as np

from flexel.base.errors import DynamicsError, FlexelError, PositionError
from flexel.engine.coordinate_work import CoordinateWork
from flexel.engine.covered import Covered
from flexel.engine.finite import TangentError
from flexel.generated._kernels import lib
from flexel.integration.account import of_radau
from flexel.integration.branch import REFUSED
from flexel.integration.jacobian import jacobian
from flexel.integration.minimal import SHORTEST, MinimalRun
from flexel.integration.radau_saddle import SaddleFactors, sparse
from flexel.integration.radau_steps import FINEST, Collocation, estimated

log = logging.getLogger("flexel.simulate")
SHORTER = 0.5  # factor of a step that cannot be evaluated or trusted
CAREFUL = 1e-8  # distance of the end of a step from the integral of its rates, in natural scales, by the method and by
# the trapezoidal rule, up to which the sign of the position matrix may change: the path is smooth


class Radau(MinimalRun):
    """One run of Radau IIA."""

    method = "Radau"
    quadrature = of_radau()
    steps: Collocation | None = None
    _saddle: SaddleFactors | None = None
    _failed: FlexelError | None = None  # why the last trial failed
    _no_slope: TangentError | None = None

    def _scale(self) -> Covered:
        rtol, finest = self.tolerances.rtol, FINEST * self.tolerances.rtol / estimated(self.tolerances.rtol)
        return Covered(*self._sizes, rtol, self.largest_atol, finest, self.tolerances.relative, full=np.inf)

    def restart(self) -> None:
        """Restart from the present position in the present degrees of freedom."""
        y, before, left = self.choices.values(self.now, self.z), self.steps, self.stop - self.t
        self.take()
        if before is None or before.kinematics is not self.kinematics:
            self.steps = self._collocation()
        steps = self._steps
        steps.struct.account = self.account.struct
        other = before if before is not steps else None
        if other is not None:
            steps.take_over(other)
        steps.start(self.now, y, self.knots, self.covered)
        self.counts["evaluations"] += 1
        if other is not None:
            steps.resume(other)
        if before is None:
            steps.struct.h = self.tolerances.first_step or steps.first_step(left)
        else:
            steps.struct.h = before.struct.h

    def _collocation(self) -> Collocation:
        """Steps in the present degrees of freedom."""
        kinematics, given = self.kinematics, self.tolerances
        if self._saddle is None and sparse(kinematics):
            self._saddle = SaddleFactors(kinematics)
        elif self._saddle is not None:
            self._saddle.choose(kinematics)
        return Collocation(kinematics, given.rtol, self.natural_atol(), given.minor, self._saddle)

    @property
    def placed(self) -> CoordinateWork:
        """The arrays that hold the position at the end of the step that was found last."""
        return self._steps.choice

    def restart_with(self, h: float) -> None:
        """Restart with a step [s] to try first."""
        self._steps.struct.h = h
        self.restart()
        self._steps.struct.stale = True  # close to a flat position the Jacobian is noise

    @property
    def _steps(self) -> Collocation:
        assert self.steps is not None
        return self.steps

    def advance(self) -> str | None:
        """Take one accepted step."""
        wished = self._steps.struct.h
        while True:
            steps, c = self._steps, self._steps.struct
            c.end, c.longest = self.latest, self.tolerances.max_step
            c.shortest = max(SHORTEST * self._span, 10 * abs(np.nextafter(self.t, np.inf) - self.t))
            c.enlarged = max(1.0, self.amplification / max(1.0, self.choices.best))
            before = c.evaluations, c.refused
            code = steps.step()
            self.counts["evaluations"] += c.evaluations - before[0]
            self.counts["rejected"] += c.refused - before[1]
            if code == lib.FLEXEL_RADAU_JACOBIAN:
                self._evaluate_jacobian()
            elif code == lib.FLEXEL_RADAU_SHORT:
                return self.carry_or_stop(self._stopped())
            elif not code and self._trusted():
                break
            else:
                self._refused(code)
        return self._accepted(wished)

    def _accepted(self, wished: float) -> str | None:
        steps, c, first = self._steps, self._steps.struct, self.now
        self.amplification, self._failed = steps.choice.amplification(), None
        self.counts["bifurcations"] += bool(c.changed)
        cut, h = c.h < wished and not c.rejected, c.h
        dense = steps.accept(first)
        if cut and c.t == c.end and c.last_h == h:
            c.h = max(c.h, wished)
        z = dense.end[dense.end.size - self.z.size :].copy()
        return self.end_step(first.t, dense, first, z, dense.last)

    def _evaluate_jacobian(self) -> None:
        """The Jacobian at the start; where a law has no slope, the last one serves, with shorter steps if need be."""
        steps = self._steps
        try:
            if steps.saddle is None:
                steps.look(jacobian(self.kinematics, self.now, self.z))
            else:
                steps.saddle.look(self.kinematics, self.now, self.z)
            self._no_slope = None
        except TangentError as error:
            self._no_slope = error
        except FlexelError as error:
            raise self.noted(error) from None
        steps.look_again()

    def _refused(self, code: int) -> None:
        """Try a shorter step, in better degrees of freedom if there are any."""
        steps, c = self._steps, self._steps.struct
        self._failed = self.kinematics.failure(code, c.t + c.h, steps.choice) if code else self._off()
        log.debug("another trial at t = %.9g s with a shorter step: %s", self.t, self._failed)
        steps.refuse(SHORTER)
        self.counts["rejected"] += 1
        self.amplification = self.choices.amplification(self.now)
        if self.consider(REFUSED):
            self.restart()

    def _trusted(self) -> bool:
        """Whether the end of a step is on the branch of its start."""
        c = self._steps.struct
        return not c.changed or bool(max(c.off, c.coarse) <= CAREFUL)

    def _off(self) -> PositionError:
        """The error of a step whose end is somewhere else."""
        c, s, roles = self._steps.struct, self.kinematics.structure, self.kinematics.roles
        name = s.names[s.m + s.k + c.farthest]
        driven = (
            f"check what drives {self.kinematics.names(roles.prescribed)}, " if roles.prescribed.size else ""
        )
        return PositionError(
            f"position at t = {c.t + c.h:g} s cannot be reached: '{name}' is not where its rate leads; the position "
            f"may be singular there, or a deformation jumps; {driven}choose other degrees of freedom, or DOP853"
        )

    def _stopped(self) -> FlexelError:
        """The error of steps that have become too short."""
        if self._no_slope:
            return self._no_slope
        return self._failed or DynamicsError(
            f"integration failed at t = {self.t:g} s: the step has become too short; {self.trouble('')}"
        )
