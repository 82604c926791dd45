"""The built system: one structure, its roles and laws, and the evaluations that everything else calls.

Three methods carry all numerical work: `rhs` (right-hand side of the equations of motion), `residual`
(with its tangent from `linearize`) and `linearize`.  How they are arranged is private to this room.
Imports numpy and the runtime rooms below it.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import cached_property

import numpy as np

from flexel import dynamics, stability, states, statics
from flexel.diagnose import choose_freedoms, named_freedoms
from flexel.errors import ConstraintError, PositionError
from flexel.evaluate import Evaluation
from flexel.implicit import GeneralizedAlpha
from flexel.integrate import (
    Event,
    Integration,
    Integrator,
    Segment,
    longest_step,
    stored_times,
    turning_weights,
)
from flexel.kinematics import Configuration, Factorization, Kinematics
from flexel.linearize import Linearization, linearize
from flexel.loads import Loads
from flexel.result import Motion
from flexel.roles import Roles
from flexel.state import State, own_state
from flexel.steady import steady_motion
from flexel.structure import Array, Structure


class System:
    """A mechanism ready to move; made by `Model.build`.

    Attributes
    ----------
    structure : Structure
        Names and index maps.
    roles : Roles
        The constraints and the present choice of freedoms.
    """

    def __init__(
        self,
        evaluation: Evaluation,
        loads: Loads,
        roles: Roles,
        start: Configuration,
        rates: Mapping[str, float],
    ) -> None:
        self.structure: Structure = evaluation.structure
        self.evaluation = evaluation
        self.loads = loads
        self._kinematics: dict[int, Kinematics] = {}
        self._use(roles)
        still = np.zeros(self.structure.n)
        self._last = states.End(start.t, start.x, still, start.e, np.zeros(self.structure.m))
        self._wound = any(  # where an angle's turns matter to the forces
            self.structure.angle[self.structure.index[z]]
            for law in self.structure.laws
            for z in law.deformations
        )
        qd = states.consistent_rates(self, start, rates)
        self._start = start, self.kinematics.velocity(start, self.kinematics.velocity_matrix(start), qd)

    @cached_property
    def initial(self) -> State:
        """The consistent initial state, with its accelerations.

        Raises
        ------
        DynamicsError
            If a freedom has no inertia; `rest` needs none.
        """
        c, v = self._start
        return dynamics.complete(self.kinematics, self.loads, c, v, c.e)

    @cached_property
    def rest(self) -> State:
        """The initial configuration without motion and constraint forces: where statics starts."""
        c, still = self._start[0], np.zeros(self.structure.n)
        given = dynamics.forces(self.kinematics, self.loads, c, still, c.e)
        none = np.zeros(len(self.structure.names))
        return dynamics.with_multipliers(self.kinematics, c, still, still, c.e, given, none)

    def _use(self, roles: Roles) -> None:
        self.roles = roles
        self.kinematics = self.kinematics_of(roles)

    def kinematics_of(self, roles: Roles) -> Kinematics:
        """The kinematic problems in the coordinates `roles`, kept for the next time."""
        if id(roles) not in self._kinematics:
            self._kinematics[id(roles)] = Kinematics(self.evaluation, roles)
        return self._kinematics[id(roles)]

    # -- counts and names ------------------------------------------------------------------------

    @property
    def dynamic(self) -> tuple[str, ...]:
        """Names of the dynamic freedoms q_d."""
        return tuple(self.structure.names[i] for i in self.roles.dynamic)

    @property
    def kinematic(self) -> tuple[str, ...]:
        """Names of the kinematic freedoms q_k."""
        return tuple(self.structure.names[i] for i in self.roles.kinematic)

    @cached_property
    def counts(self) -> dict[str, int]:
        """Numbers of coordinates, deformations (Euler-parameter norms not counted), slips and freedoms."""
        s, r = self.structure, self.roles
        norms = sum(instance.spec.name == "norm" for instance in s.instances)
        return {
            "coordinates": s.n,
            "free coordinates": s.nf,
            "deformations": s.m - norms,
            "norms": norms,
            "slips": s.k,
            "freedoms": r.nd,
            "kinematic_coordinates": r.nq - r.nd,
            "rigid deformations": r.rigid.size - norms,
            "prescribed": r.prescribed.size,
            "zero slips": r.zero.size,
        }

    def __repr__(self) -> str:
        c = self.counts
        return (
            f"System({c['freedoms']} freedoms {self.dynamic}, {c['kinematic_coordinates']} kinematic coordinates "
            f"{self.kinematic}, {c['coordinates']} coordinates, {c['deformations']} deformations)"
        )

    # -- evaluation ------------------------------------------------------------------------------

    def warm(self, state: State) -> None:
        """Start the next position problem from a state, and count turns of angles from it."""
        self._last = states.End.of(state)
        self.kinematics.forget()

    @property
    def position_guess(self) -> Array:
        """Coordinates (n,) of the last evaluation of `rhs`."""
        return self._last.x

    def rhs(self, t: float, y: Array) -> Array:
        """Rates of y = (q_d, q_k, q_d') (nq + nd,) at time t [s]."""
        kinematics, nq = self.kinematics, self.roles.nq
        last = self._last
        c = kinematics.position(t, y[:nq], last.x)
        B = kinematics.velocity_matrix(c)
        v = kinematics.velocity(c, B, y[nq:])
        e, ed = c.e, last.ed
        if self._wound:
            ed = c.J[: self.structure.m] @ v
            e = states.with_turns(kinematics, c, y[:nq], last.e + (t - last.t) * (last.ed + ed) / 2)
        self._last = states.End(t, c.x, v, e, ed)
        F = dynamics.forces(kinematics, self.loads, c, v, e)
        motion = dynamics.accelerations(kinematics, c, B, v, F)
        return np.concatenate([y[nq:], c.J[self.roles.kinematic] @ v, motion.qdd])

    def residual(self, t: float, q: Array, qd: Array, qdd: Array, guess: State) -> Array:
        """Unbalanced generalized forces H'(M a + h - f + De' sigma + V' tau) (nd,); zero in a true motion."""
        kinematics, nf = self.kinematics, self.structure.nf
        c = kinematics.position(t, q, guess.x)
        B = kinematics.velocity_matrix(c)
        v = kinematics.velocity(c, B, qd)
        F = dynamics.forces(kinematics, self.loads, c, v, states.unwrap(self.structure, c.e, guess.e))
        H, g = dynamics.unit_solutions(kinematics, B), B.solve(kinematics.convective(c, v))
        return np.asarray(H.T @ (F.M[:nf, :nf] @ (H @ qdd + g) - F.F[:nf]))

    def linearize(self, state: State | None = None) -> Linearization:
        """Analytic linearization about a state (the initial one by default).

        Examples
        --------
        >>> lin = system.linearize(motion[-1])  # doctest: +SKIP
        >>> lin.eigenvalues()  # doctest: +SKIP
        """
        state = self.initial if state is None else own_state(self.structure, state, "linearize")
        usable = state.roles is self.roles or self.condition(state) > 1e-9
        return linearize(self.kinematics if usable else self.kinematics_of(state.roles), state)

    # -- states ----------------------------------------------------------------------------------

    def state(self, t: float, x: Array, v: Array, e: Array | None = None) -> State:
        """Complete state from coordinates and rates that satisfy the constraints; e counts the turns."""
        principal, J = self.evaluation.position(x)
        e = principal if e is None else states.unwrap(self.structure, principal, e)
        c = Configuration(t, x, e, J)
        if not np.any(v) and self.roles.motions:
            B = self.kinematics.velocity_matrix(c)
            v = self.kinematics.velocity(c, B, np.zeros(self.roles.nd))
        return dynamics.complete(self.kinematics, self.loads, c, v, e)

    def state_at(
        self,
        values: Mapping[str, float] | None = None,
        rates: Mapping[str, float] | None = None,
        t: float | None = None,
        start: State | None = None,
    ) -> State:
        """Consistent state with given values and rates of the named freedoms, others as in `start`.

        Parameters
        ----------
        values : mapping of name to value
            Values of freedoms (dynamic or kinematic).
        rates : mapping of name to rate
            Rates of any quantities; together they must be possible.
        t : float, optional
        start : State, optional
            The initial state by default.

        Raises
        ------
        ModelError, PositionError
            A name that is no freedom; an unreachable position; inconsistent rates, by name.
        """
        return states.state_at(self, values or {}, rates, t, start or self.initial)

    def state_from(self, t: float, y: Array, roles: Roles, previous: State) -> State:
        """Complete state from y = (q, q_d') in the coordinates `roles`, turns counted from an earlier state."""
        return states.state_from(self, t, y, roles, previous)

    # -- choice of coordinates -------------------------------------------------------------------

    def condition(self, state: State, roles: Roles | None = None) -> float:
        """Reciprocal condition of the velocity and position matrices with scaled rows; small is bad."""
        roles, nf = roles or self.roles, self.structure.nf
        found = 1.0
        for rows in (roles.velocity_rows, roles.position_rows):
            A = state.J[rows, :nf]
            found = min(found, Factorization(A / np.linalg.norm(A, axis=1, keepdims=True)).rcond)
        return found

    def rechoose(self, state: State, needed: float) -> State | None:
        """Take the best freedoms at a state, if their condition reaches `needed`; the same state in them."""
        try:
            roles = choose_freedoms(self.kinematics, state.J, None, None)
        except ConstraintError:  # a singular position has no better choice: keep the present one
            return None
        if self.condition(state, roles) < needed:
            return None
        self._use(roles)
        return self.state(state.t, state.x, state.v, state.e)

    def use_freedoms(self, dynamic: Sequence[str], kinematic: Sequence[str] | None = None) -> None:
        """Describe the motion from now on by the named freedoms; checked at the initial state."""
        rows = [named_freedoms(self.structure, z, "use_freedoms") for z in (dynamic, kinematic)]
        self._use(choose_freedoms(self.kinematics, self._start[0].J, *rows))
        self.__dict__.pop("initial", None)
        self.__dict__.pop("rest", None)

    # -- analyses --------------------------------------------------------------------------------

    def simulate(
        self,
        duration: float,
        *,
        start: State | None = None,
        times: Sequence[float] | Array | None = None,
        samples: int = 201,
        method: str = "DOP853",
        rtol: float = 1e-9,
        atol: float = 1e-11,
        max_step: float = np.inf,
        events: Sequence[Event] = (),
        progress: bool | None = None,
        rechoose: bool = True,
    ) -> Motion:
        """Forward dynamics; with no freedoms left, the prescribed motion and its driving forces.

        Parameters
        ----------
        duration : float
            Length of the motion [s].
        start : State, optional
            The initial state by default.
        times : array_like, optional
            Times [s] at which states are kept; `samples` equidistant ones by default.
        method : str
            DOP853, RK45, LSODA, Radau or BDF.
        rtol, atol, max_step : float
            Of the integrator.
        events : sequence of Event
        progress : bool, optional
            Progress bar on stderr; by default where stderr is a terminal.
        rechoose : bool
            Change the freedoms when they become ill-conditioned.

        Returns
        -------
        Motion

        Raises
        ------
        ModelError, PositionError, DynamicsError
        """
        start = self.initial if start is None else own_state(self.structure, start, "simulate")
        grid = stored_times(start, duration, times, samples)
        if self.roles.nq == 0:
            return Motion(self, self._follow(start, grid))
        chosen = self.roles
        if start.roles is not chosen:
            if self.condition(start) > 1e-3 * self.condition(start, start.roles):
                start = self.state(start.t, start.x, start.v, start.e)
            else:  # the motion has led to where the chosen freedoms are of no use
                self._use(start.roles)
        try:
            run = Integrator(self, start, grid, method, rtol, atol, max_step, events, progress, rechoose)
            return Motion(self, run.run())
        finally:
            self._use(chosen)

    def simulate_stiff(
        self,
        duration: float,
        *,
        start: State | None = None,
        times: Sequence[float] | Array | None = None,
        samples: int = 201,
        tolerance: float = 1e-6,
        radius: float = 0.8,
        first_step: float | None = None,
        max_step: float = np.inf,
        progress: bool | None = None,
    ) -> Motion:
        """Implicit dynamics of a stiff model by the generalized-alpha method, whatever the freedoms.

        Parameters
        ----------
        duration : float
            Length of the motion [s].
        start : State, optional
            The initial state by default; a state of rest serves where a freedom has no inertia.
        times : array_like, optional
            Times [s] at which states are kept; `samples` equidistant ones by default.
        tolerance : float
            Local error of the coordinates in their natural scales, in one step.
        radius : float
            Spectral radius at infinite frequency, 0 (all high frequencies damped at once) to below 1.
        first_step, max_step : float
            [s]; the first is a thousandth of the duration by default.

        Raises
        ------
        ModelError, DynamicsError
        """
        start = self.initial if start is None else own_state(self.structure, start, "simulate_stiff")
        grid = stored_times(start, duration, times, samples)
        run = GeneralizedAlpha(self, start, radius, tolerance)
        return Motion(self, run.run(grid, first_step or duration / 1000, max_step, progress))

    def _follow(self, start: State, grid: Array) -> Integration:
        """States of a fully prescribed motion; long steps are halved until the position is found."""
        found, segments, none = [start], [], np.zeros(0)
        weights = turning_weights(self.structure)
        dense: Callable[[float], Array] = lambda t: none  # noqa: E731 (a fully prescribed motion has no state)
        for t in grid[1:]:
            last, step = found[-1], float(t) - found[-1].t
            while last.t < t:
                step = min(step, longest_step(last, weights))
                try:
                    state = self.state_from(min(last.t + step, float(t)), none, self.roles, last)
                except PositionError:
                    step /= 2
                    if step < 1e-6 * (grid[-1] - grid[0]):
                        raise
                    continue
                ends = states.End.of(last), states.End.of(state)
                segments.append(Segment(last.t, state.t, self.roles, dense, *ends))
                last = state
            found.append(last)
        return Integration(
            found, [], segments, {"steps": len(segments), "evaluations": 0, "rechoices": 0}, ""
        )

    def equilibrium(self, t: float | None = None, start: State | None = None) -> State:
        """State of rest in which all forces balance, kinematic coordinates held.

        Newton's method on the analytic tangent; where it fails, the forces that are out of balance at the start
        are taken on gradually, past limit points if need be.

        Parameters
        ----------
        t : float, optional
            Time [s] at which loads and prescribed motions are taken; that of `start` by default.
        start : State, optional
            Where to look from; the initial configuration by default.

        Raises
        ------
        PositionError
            If none is found; says how far the loads could be taken on.
        DynamicsError
            If nothing resists a motion; names it.
        """
        return statics.equilibrium(self, t, start or self.rest)

    def static_path(self, t_end: float, start: State | None = None) -> Motion:
        """Equilibria while the time, here the load parameter, goes to `t_end`; past limit points by arc length.

        The start must be in equilibrium (see `equilibrium`).  If the path cannot be continued, what was reached
        is returned, and ``message`` says where it stopped and why.
        """
        states_, message = statics.static_path(self, t_end, start or self.rest)
        counts = {"steps": len(states_) - 1, "evaluations": 0, "rechoices": 0}
        return Motion(self, Integration(states_, [], [], counts, message))

    def buckling(
        self, state: State | None = None, *, increment: Mapping[str, float], count: int = 5
    ) -> list[stability.BucklingMode]:
        """Load multipliers at which equilibrium branches, with their shapes, nearest first.

        Parameters
        ----------
        state : State, optional
            A state of rest, with its preload; the unloaded initial configuration by default.
        increment : mapping of name to generalized force
            The loads that are multiplied, e.g. ``{"tip.z": -1.0}``.

        Raises
        ------
        DynamicsError
            If the state is unstable already.
        """
        return stability.buckling(self, state or self.rest, increment, count)

    def vibrations(self, state: State | None = None, count: int = 10) -> list[stability.Vibration]:
        """Lowest natural frequencies [rad/s] and modes about a state of rest, damping left out.

        Unlike ``linearize(state).modes()`` this needs no choice of independent coordinates.
        """
        return stability.vibrations(self, state or self.rest, count)

    def steady(
        self,
        start: State | None = None,
        *,
        rates: Mapping[str, float] | None = None,
        unknown: Sequence[str] | None = None,
        unknown_rates: Sequence[str] = (),
    ) -> State:
        """Steady motion or equilibrium: the state near `start` whose freedoms have no acceleration.

        Parameters
        ----------
        start : State, optional
            Where to look from; the initial state by default.
        rates : mapping of name to rate, optional
            Given rates of the dynamic freedoms; those of `start` by default.
        unknown : sequence of str, optional
            Freedoms to be found; all by default (smallest change).
        unknown_rates : sequence of str
            Dynamic freedoms whose rates are to be found too.

        Raises
        ------
        PositionError
            If no steady motion is found near the start; says what was reached.
        """
        return steady_motion(self, start or self.initial, rates, unknown, unknown_rates)
