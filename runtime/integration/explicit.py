"""Forward dynamics in minimal coordinates with SciPy's integrators RK45, LSODA and BDF.

The integrator is stepped here, so that the ends of its steps can be checked for their branch and events be located on
the dense output.  The implicit ones have the Jacobian of the analytic linearization.
"""

from __future__ import annotations

import logging
from collections.abc import Sequence
from typing import Any

import numpy as np
from scipy.integrate import BDF, LSODA, RK45

from flexel.base.arrays import Array
from flexel.base.errors import ConstraintError, DynamicsError, FlexelError, PositionError
from flexel.engine.coordinate_work import CoordinateWork
from flexel.generated._kernels import lib
from flexel.integration.account import INNER, QUADRATURES
from flexel.integration.branch import REFUSED
from flexel.integration.events import Event
from flexel.integration.followed import longest_step, turning_weights
from flexel.integration.jacobian import jacobian
from flexel.integration.minimal import SHORTEST, MinimalRun, Tolerances
from flexel.mechanics.states import between, located
from flexel.model.snapshot import Snapshot
from flexel.model.state import State

log = logging.getLogger("flexel.simulate")
METHODS: dict[str, Any] = {"RK45": RK45, "BDF": BDF, "LSODA": LSODA}
IMPLICIT = ("BDF", "LSODA")
FIRST = 1e-4  # first step, relative to the time left, after an unreachable position
TWICE = 2.0  # distance of the position from the one that the rates lead to, in expected errors
FARTHEST = 10.0  # the same where the expected error is least
CAREFUL = 1e-9  # expected error of a step in which the sign of the position matrix may change
FLOOR = 1e-3  # that is always allowed, in natural scales: the rates are integrated by Simpson's rule only


class Scipy(MinimalRun):
    """One run of an integrator of SciPy.

    Parameters
    ----------
    method : str
        One of METHODS; the others as for `MinimalRun`.
    """

    def __init__(
        self,
        system: Any,
        start: State,
        times: Array,
        method: str,
        tolerances: Tolerances,
        events: Sequence[Event],
        rechoose: bool,
    ) -> None:
        self.quadrature = QUADRATURES[method]
        super().__init__(system, start, times, tolerances, events, rechoose)
        self.method, self._kind, self._implicit = method, METHODS[method], method in IMPLICIT
        self._turning = turning_weights(system.structure)
        self._first_step = tolerances.first_step
        self._solver: Any = None
        self._sign = 1

    @property
    def statistics(self) -> dict[str, int]:
        """Counts of what was done."""
        running = 0 if self._solver is None else self._solver.nfev
        return self.counts | {"evaluations": self.counts["evaluations"] + running}

    def restart(self) -> None:
        """Start another solver, which continues from the present position in the present degrees of freedom."""
        if self._solver is not None:
            self.counts["evaluations"] += self._solver.nfev
        y = self.choices.values(self.now, self.z)
        self._choice = self.kinematics.choice
        self._choice.reset()
        self._choice.warm(self.now)
        left = self.stop - self.t
        options: dict[str, Any] = {
            "rtol": self.tolerances.rtol,
            "atol": self.natural_atol(),
            "max_step": self._longest(),
        }
        if self._first_step:
            options["first_step"] = min(self._first_step, options["max_step"], left)
        if self._implicit:
            options["jac"] = self._jacobian
        self._solver = self._started(y, options)
        if self._implicit:
            self._look(self.t, y, self.now)
        self.account.first_trial()
        self._sign = self._sign_at(self.now)

    @property
    def placed(self) -> CoordinateWork:
        """The arrays that hold the position at the end of the step that was found last."""
        return self._choice

    def restart_with(self, h: float) -> None:
        """Restart with a step [s] to try first."""
        self._first_step = h
        if self.t < self.stop:
            self.restart()

    def _started(self, y: Array, options: dict[str, Any]) -> Any:
        """Start a solver, with a short first step if its own choice leads to an unreachable position."""
        begin = self._rates, self.t, y, self.stop
        self.account.begin()
        try:
            return self._kind(*begin, **options)
        except (PositionError, ConstraintError):
            if "first_step" in options:
                raise
            self._choice.warm(self.now)
            self.account.begin()
            short = min(FIRST * (begin[-1] - begin[1]), options["max_step"])
            return self._kind(*begin, **options, first_step=short)

    def _rates(self, t: float, y: Array) -> Array:
        choice: CoordinateWork = self.kinematics.given(self.knots.inside(t))
        choice.y[:] = y
        self.kinematics.check(choice.rhs(t), t)
        if not self._implicit:
            self.account.evaluated(choice)
        return choice.dy.copy()

    def _look(self, t: float, y: Array, guess: Snapshot) -> None:
        """Take the powers at an instant into the account, which needs one evaluation of the rates."""
        choice = self.kinematics.given(self.knots.inside(t))
        self.counts["evaluations"] += 1
        self.kinematics.check(choice.evaluate(t, y, guess.x, guess.e), t)
        self.account.evaluated(choice)

    def _look_within(self, solver: Any, last: Snapshot) -> None:
        """Take the powers within a step, from its dense output, and at its end into the account."""
        dense = solver.dense_output()
        for t in (self.t + INNER * (last.t - self.t)).tolist():
            self._look(t, dense(t), between(self.now, last, t))
        self._look(last.t, solver.y, last)

    def _jacobian(self, t: float, y: Array) -> Array:
        """Return the derivatives of the rates by y."""
        roles = self.kinematics.roles
        q, qd, z = np.split(y, [roles.nq, roles.nq + roles.nd])
        choice = self._choice
        guess = choice.last or self.now
        x, v, e = located(self.kinematics, t, q, qd, guess)
        choice.warm(Snapshot(t, x, v, e, guess.ed))
        return jacobian(self.kinematics, Snapshot(t, x, v, e, guess.ed), z)

    def _longest(self) -> float:
        """Return the longest step [s] in which no frame turns too far for its position to be followed."""
        still = np.zeros_like(self.now.v)
        return min(self.tolerances.max_step, longest_step(self.now.v, still, self._turning))

    def advance(self) -> str | None:
        """Take one step, or a shorter one after a position that cannot be reached or trusted."""
        if self._solver.t_bound != self.stop:
            self.restart()
        solver = self._solver
        solver.max_step = self._longest()
        try:
            message: str | None = solver.step()
            if solver.status == "failed":
                raise DynamicsError(
                    f"integration failed at t = {solver.t:g} s: {message}; {self.trouble('')}"
                )
            last = self._end(solver)
            if self._implicit:
                self._look_within(solver, last)
        except (PositionError, ConstraintError) as error:
            return self._refused(solver, error)
        except FlexelError as error:
            return self.carry_or_stop(error)
        self.account.accept(last.t - self.t)
        self._first_step = None
        first, dense = self.now, solver.dense_output()
        z = np.array(solver.y[self.kinematics.roles.nq + self.kinematics.roles.nd :])
        return self.end_step(first.t, dense, first, z, last)

    def _refused(self, solver: Any, error: FlexelError) -> str | None:
        """Start again from where the step began, with a shorter one, in better degrees of freedom if there are any.

        Where that would be too short, the motion may be carried across a flat position.
        """
        tried = float(getattr(solver, "h_abs", None) or 1e-3 * (solver.t_bound - self.t))
        tried = min(tried, abs(solver.t - self.t) or tried)
        self.counts["rejected"] += 1
        log.debug("restarts at t = %.9g s with a shorter step: %s", self.t, error)
        self._first_step = min(tried, self._first_step or np.inf) / 2
        if self._first_step < SHORTEST * self._span:
            return self.carry_or_stop(error)
        self.amplification = self.choices.amplification(self.now)
        self.consider(REFUSED)
        self.restart()
        return None

    def _end(self, solver: Any) -> Snapshot:
        """Return position and rates at the end of a step.

        Raises
        ------
        PositionError
            If the position is not the one that the rates in the step lead to.
        """
        roles, t1 = self.kinematics.roles, float(solver.t)
        half = 0.5 * (self.t + t1)
        guess = self.now.turns(t1)
        ahead = Snapshot(t1, self._choice.x_last.copy(), self.now.v, guess, self._choice.ed_last.copy())
        q, qd, _ = np.split(solver.y, [roles.nq, roles.nq + roles.nd])
        x, v, e = located(self.kinematics, self.knots.inside(t1), q, qd, ahead)
        work = self._choice.work
        work.rates()
        last = Snapshot(t1, x, v, e, work.w[: e.size].copy())
        sign = lib.flexel_matrix_sign(self._choice.P)
        q, qd, _ = np.split(solver.dense_output()(half), [roles.nq, roles.nq + roles.nd])
        middle = located(self.kinematics, half, q, qd, between(self.now, last, half))[1]
        self._check(last, middle, sign)
        self._choice.warm(last)
        self.amplification = self._choice.amplification()
        return last

    def _check(self, last: Snapshot, middle: Array, sign: int) -> None:
        """Raise if the end of a step is on another branch than its start."""
        h, s = last.t - self.t, self.kinematics.structure
        simpson = self.now.x + h / 6 * (self.now.v + 4 * middle + last.v)
        coarse = self.now.x + h / 2 * (self.now.v + last.v)
        weight = self.kinematics.lists.step_weight
        off, expected = (
            float(np.max(np.abs(values - simpson)[: s.nf] * weight, initial=0.0))
            for values in (last.x, coarse)
        )
        expected *= 0.1  # Simpson's rule is better than the trapezoidal one by more than that
        if sign == self._sign and off <= max(TWICE * expected, FARTHEST * FLOOR):
            return
        if sign != self._sign and expected <= CAREFUL and off <= FARTHEST * CAREFUL:
            self.counts["bifurcations"] += 1  # the sign changes along a smooth path
            self._sign = sign
            return
        name = s.names[s.m + s.k + int(np.argmax(np.abs(last.x - simpson)[: s.nf] * weight))]
        roles = self.kinematics.roles
        driven = (
            f"check what drives {self.kinematics.names(roles.prescribed)}, " if roles.prescribed.size else ""
        )
        raise PositionError(
            f"position at t = {last.t:g} s cannot be reached: '{name}' is not where its rate leads; the position "
            f"may be singular there, or a deformation jumps; {driven}choose other degrees of freedom, or DOP853"
        )

    def _sign_at(self, at: Snapshot) -> int:
        self.choices.amplification(at)
        return int(lib.flexel_matrix_sign(self._choice.P))
