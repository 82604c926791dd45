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
from flexel.engine.choice import Choice
from flexel.generated._kernels import lib
from flexel.integration.branch import REFUSED
from flexel.integration.events import Event
from flexel.integration.followed import longest_step, turning_weights
from flexel.integration.jacobian import jacobian
from flexel.integration.minimal import SHORTEST, MinimalRun, Tolerances
from flexel.mechanics.states import between, located
from flexel.structure.moment import Moment
from flexel.structure.state import State

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
        super().__init__(system, start, times, tolerances, events, rechoose)
        self.method, self._implicit = METHODS[method], method in IMPLICIT
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
        """Another solver, which continues from the present position in the present degrees of freedom."""
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
        self._sign = self._sign_at(self.now)

    def jump(self, z: Array) -> None:
        """Continue from here with other internal states."""
        self.z = z
        self.restart()

    def _started(self, y: Array, options: dict[str, Any]) -> Any:
        """A solver; with a short first step if its own choice leads to an unreachable position."""
        begin = self._rates, self.t, y, self.stop
        try:
            return self.method(*begin, **options)
        except (PositionError, ConstraintError):
            if "first_step" in options:
                raise
            self._choice.warm(self.now)
            short = min(FIRST * (begin[-1] - begin[1]), options["max_step"])
            return self.method(*begin, **options, first_step=short)

    def _rates(self, t: float, y: Array) -> Array:
        choice: Choice = self.kinematics.given(self.knots.inside(t))
        choice.y[:] = y
        self.kinematics.check(choice.rhs(t), t)
        return choice.dy.copy()

    def _jacobian(self, t: float, y: Array) -> Array:
        """Derivatives of the rates by y."""
        roles = self.kinematics.roles
        q, qd, z = np.split(y, [roles.nq, roles.nq + roles.nd])
        choice = self._choice
        near = choice.last or self.now
        x, v, e = located(self.kinematics, t, q, qd, near)
        choice.warm(Moment(t, x, v, e, near.ed))
        return jacobian(self.kinematics, Moment(t, x, v, e, near.ed), z)

    def _longest(self) -> float:
        """Longest step [s] in which no frame turns too far for its position to be followed."""
        still = np.zeros_like(self.now.v)
        return min(self.tolerances.max_step, longest_step(self.now.v, still, self._turning))

    def advance(self) -> str | None:
        """One step, or a shorter one after a position that cannot be reached or trusted."""
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
        except (PositionError, ConstraintError) as error:
            self._refused(solver, error)
            return None
        except FlexelError as error:
            raise self.noted(error) from None
        self._first_step = None
        first, dense = self.now, solver.dense_output()
        z = np.array(solver.y[self.kinematics.roles.nq + self.kinematics.roles.nd :])
        return self.end_step(first.t, dense, first, z, last)

    def _refused(self, solver: Any, error: FlexelError) -> None:
        """Start again from where the step began, with a shorter one, in better degrees of freedom if there are any."""
        tried = float(getattr(solver, "h_abs", None) or 1e-3 * (solver.t_bound - self.t))
        tried = min(tried, abs(solver.t - self.t) or tried)
        self.counts["rejected"] += 1
        log.debug("restarts at t = %.9g s with a shorter step: %s", self.t, error)
        self._first_step = min(tried, self._first_step or np.inf) / 2
        if self._first_step < SHORTEST * self._span:
            raise self.gives_up(error)
        self.reached = self.choices.reach(self.now)
        self.consider(REFUSED)
        self.restart()

    def _end(self, solver: Any) -> Moment:
        """Position and rates at the end of a step.

        Raises
        ------
        PositionError
            If the position is not the one that the rates in the step lead to.
        """
        roles, t1 = self.kinematics.roles, float(solver.t)
        half = 0.5 * (self.t + t1)
        guess = self.now.turns(t1)
        ahead = Moment(t1, self._choice.x_last.copy(), self.now.v, guess, self._choice.ed_last.copy())
        q, qd, _ = np.split(solver.y, [roles.nq, roles.nq + roles.nd])
        x, v, e = located(self.kinematics, t1, q, qd, ahead)
        work = self._choice.work
        work.rates()
        last = Moment(t1, x, v, e, work.w[: e.size].copy())
        sign = lib.flexel_matrix_sign(self._choice.P)
        q, qd, _ = np.split(solver.dense_output()(half), [roles.nq, roles.nq + roles.nd])
        middle = located(self.kinematics, half, q, qd, between(self.now, last, half))[1]
        self._check(last, middle, sign)
        self._choice.warm(last)
        self.reached = self._choice.reach()
        return last

    def _check(self, last: Moment, middle: Array, sign: int) -> None:
        """Raise if the end of a step is on another branch than its start."""
        h, s = last.t - self.t, self.kinematics.structure
        simpson = self.now.x + h / 6 * (self.now.v + 4 * middle + last.v)
        coarse = self.now.x + h / 2 * (self.now.v + last.v)
        weight = self.kinematics.lists.step_weight
        off, expected = (
            float(np.max(np.abs(z - simpson)[: s.nf] * weight, initial=0.0)) for z in (last.x, coarse)
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
            f"position at t = {last.t:g} s cannot be reached: '{name}' is not where its rate leads to; the position "
            f"may be singular there, or a deformation jumps; {driven}choose other degrees of freedom, or DOP853"
        )

    def _sign_at(self, near: Moment) -> int:
        self.choices.reach(near)
        return int(lib.flexel_matrix_sign(self._choice.P))
