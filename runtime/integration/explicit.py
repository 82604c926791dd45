"""Forward dynamics in minimal coordinates with SciPy's integrators, with events and a change of coordinates.

The integrator is stepped here, so that after every step the condition of the chosen coordinates can be
checked and events located on the dense output.  When the coordinates become
ill-conditioned the model is re-parametrized and the integration continues from the same x and v.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from scipy.integrate import BDF, DOP853, LSODA, RK45, Radau

from flexel.base.arrays import Array
from flexel.base.errors import ConstraintError, DynamicsError, FlexelError, PositionError
from flexel.integration.driver import DenseRun
from flexel.integration.events import Event
from flexel.integration.outcome import Segment
from flexel.mechanics.states import Moment, state_of
from flexel.structure.state import State
from flexel.structure.structure import Structure

METHODS: dict[str, Any] = {"DOP853": DOP853, "RK45": RK45, "Radau": Radau, "BDF": BDF, "LSODA": LSODA}
ILL_CONDITIONED = 0.25  # condition of B or of the position matrix, relative to that at the last choice
SHORTEST = 1e-8  # first step, relative to the times, below which a position counts as unreachable
FIRST = 1e-4  # first step, relative to the time left, after an unreachable one
MOST_SHORT = 100  # steps of that length in a row before the integration gives up
RETRY = "out of reach"
TRAVEL = (
    1.0  # change of an Euler parameter per step: more than two radians could lead to another branch or turn
)
BETTER = 1.5  # a new choice must improve the condition by this factor


@dataclass(frozen=True)
class Tolerances:
    """Accuracy and steps of an explicit integration.

    Attributes
    ----------
    rtol : float
        Local error relative to y = (q, q_d', z).
    atol : float or ndarray (ny,)
        Local error in the natural scales of y.
    first_step, max_step : float
        Steps [s]; by default the integrator chooses the first.
    """

    rtol: float
    atol: float | Array
    first_step: float | None = None
    max_step: float = np.inf


def turning_weights(structure: Structure) -> Array:
    """Weights (n,) that select the coordinates of orientations: one for Euler parameters, half for planar angles."""
    weight = {"-": 1.0, "rad": 0.5}
    return np.array([weight.get(unit, 0.0) for unit in structure.units[structure.m + structure.k :]])


def longest_step(state: State, weights: Array) -> float:
    """Time [s] in which an orientation changes by TRAVEL, at the current rates and accelerations."""
    v, a = (float(np.max(np.abs(z) * weights, initial=0.0)) for z in (state.v, state.a))
    return 2 * TRAVEL / max(v + float(np.sqrt(v * v + 2 * a * TRAVEL)), 1e-300)


class Explicit(DenseRun):
    """One run of an explicit integrator, or of an implicit one of SciPy, in minimal coordinates.

    Parameters
    ----------
    system : Core
    start : State
    times : ndarray
        At which states are kept.
    method : str
        One of METHODS.
    tolerances : Tolerances
    events : sequence of Event
    rechoose : bool
        Change the degrees of freedom when they become ill-conditioned.
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
        super().__init__(system, start, times, events)
        self.method = METHODS[method]
        self.tolerances, self.rechoose = tolerances, rechoose
        self._end = Moment.of(start)
        self._first_step = tolerances.first_step
        self._short = 0
        self._turning = turning_weights(system.structure)
        self._counts = {"steps": 0, "evaluations": 0, "rechoices": 0}
        self._solver: Any = None
        self._reference = 1.0

    @property
    def statistics(self) -> dict[str, int]:
        """Counts of what was done."""
        running = 0 if self._solver is None else self._solver.nfev
        return self._counts | {"evaluations": self._counts["evaluations"] + running}

    def advance(self) -> str | None:
        """One step, or a shorter one after an unreachable position."""
        solver = self._solver = self._solver or self._fresh()
        solver.max_step = self._longest()
        message = self._step(solver)
        if message == RETRY:
            self._leave()
            return None
        if solver.status == "failed":
            raise DynamicsError(f"integration failed at t = {solver.t:g} s: {message}; {self._trouble()}")
        ended = self._accept(solver)
        if ended is None and self.rechoose and self._rechosen():
            self._leave()
        return ended

    def _fresh(self) -> Any:
        """A solver that continues from the current state in the current degrees of freedom."""
        system, given = self.system, self.tolerances
        y0 = np.concatenate([self.state.q, self.state.qd, self.state.z])
        system.warm(self.state)
        atol = given.atol * natural_scales_of_y(system)
        options: dict[str, Any] = {"rtol": given.rtol, "atol": atol, "max_step": self._longest()}
        if self._first_step:
            left = float(self.times[-1]) - self.state.t
            options["first_step"] = min(self._first_step, options["max_step"], left)
        solver = self._started(y0, options)
        self._reference = system.condition(self.state)
        self.begin()
        return solver

    def _started(self, y0: Array, options: dict[str, Any]) -> Any:
        """A SciPy solver; with a short first step if its own choice leads to an unreachable position."""
        begin = self.system.rhs, self.state.t, y0, float(self.times[-1])
        try:
            return self.method(*begin, **options)
        except (PositionError, ConstraintError):
            if "first_step" in options:
                raise
            self.system.warm(self.state)
            short = min(FIRST * (begin[-1] - begin[1]), options["max_step"])
            return self.method(*begin, **options, first_step=short)

    def _leave(self) -> None:
        """Continue with another solver."""
        self._counts["evaluations"] += self._solver.nfev
        self._solver = None

    def _accept(self, solver: Any) -> str | None:
        """Store the result of the last step; returns the message of a terminal event within it."""
        system, roles, t0, t1 = self.system, self.system.roles, float(solver.t_old), float(solver.t)
        dense = solver.dense_output()
        q, qd, z = np.split(dense(t1), [roles.nq, roles.nq + roles.nd])
        near = replace(Moment.of(self.state), x=system.position_guess)
        state = state_of(system.kinematics, system.loads, t1, q, qd, z, near)
        step = Segment(t0, t1, roles, dense, self._end, Moment.of(state))
        ended = self.accept(step, state)
        self._counts["steps"] += 1
        self._end = step.last
        short = t1 - t0 < SHORTEST * self._span and t1 < self.times[-1]
        self._short = self._short + 1 if short else 0
        if self._short > MOST_SHORT:
            raise DynamicsError(f"the steps have become too short at t = {t1:g} s; {self._trouble()}")
        return ended

    def _trouble(self) -> str:
        """Possible causes where the integration cannot continue."""
        names, roles = self.system.kinematics.names, self.system.roles
        driven = f", check what drives {names(roles.prescribed)}" if roles.prescribed.size else ""
        return (
            f"degrees of freedom {names(roles.dynamic)}, condition {self.system.condition(self.state, roles):.2g}: the "
            "motion is not smooth there, or the position is singular (gimbal lock of frames without inertia); give "
            f"those frames inertia, choose other degrees of freedom{driven}, or end the motion before "
            f"{self.state.t:g} s"
        )

    def _longest(self) -> float:
        """Longest step [s] in which no frame turns too far for its position to be followed."""
        return min(self.tolerances.max_step, longest_step(self.state, self._turning))

    def _step(self, solver: Any) -> str | None:
        """One step; RETRY if a stage was unreachable, so that a shorter first step is tried."""
        try:
            message: str | None = solver.step()
        except (PositionError, ConstraintError) as error:
            tried = float(getattr(solver, "h_abs", None) or 1e-3 * (solver.t_bound - solver.t))
            self._first_step = min(tried, self._first_step or np.inf) / 8
            if self._first_step < SHORTEST * max(abs(solver.t_bound), self._span):
                error.add_note(f"the motion was computed up to t = {solver.t:g} s")
                raise
            return RETRY
        except FlexelError as error:
            error.add_note(f"the motion was computed up to t = {solver.t:g} s")
            raise
        self._first_step = None
        return message

    def _rechosen(self) -> bool:
        """Change the degrees of freedom if they became ill-conditioned and others are clearly better."""
        system = self.system
        condition = system.condition(self.state)
        if condition > ILL_CONDITIONED * self._reference:
            return False
        changed = system.rechoose(self.state, BETTER * condition)
        if changed is None:
            return False
        self.state = changed
        self._counts["rechoices"] += 1
        return True


def natural_scales_of_y(system: Any) -> Array:
    """Natural scales of y = (q, q_d', z): those of rates are per second, those of internal states of laws one."""
    roles, scales = system.roles, system.kinematics.scales
    return np.concatenate([scales(roles.dofs), scales(roles.dynamic), np.ones(system.structure.nz)])
