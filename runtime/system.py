"""The core of a built system: one structure, its roles and laws, and the evaluations used by all analyses.

Three methods do all numerical work: `rhs` (right-hand side of the equations of motion), `residual`
(with its tangent from `linearize`) and `linearize`.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from copy import copy
from dataclasses import replace
from functools import cached_property, partial
from typing import Any, Self

import numpy as np

from flexel.base.arguments import LARGEST, number, positive, vector
from flexel.base.arrays import Array, Index
from flexel.base.blas import in_one_thread
from flexel.base.shown import listed, prints
from flexel.base.time_functions import just_after
from flexel.engine.evaluate import Evaluation
from flexel.mechanics import dynamics, states
from flexel.mechanics.amplification import amplification, lost, warn_replaced
from flexel.mechanics.diagnose import choose_dofs, named_dofs
from flexel.mechanics.kinematics import Configuration, Kinematics
from flexel.mechanics.linearize import linearize
from flexel.mechanics.linearized_system import LinearizedSystem
from flexel.mechanics.ranges import warn_beyond
from flexel.mechanics.start_rates import consistent_rates
from flexel.model.applied_loads import Loads
from flexel.model.callbacks import Callback, callbacks_of, raise_failures
from flexel.model.controller import check_smooth
from flexel.model.origin import Origin
from flexel.model.role_lists import Roles
from flexel.model.snapshot import Snapshot
from flexel.model.state import State, own_state
from flexel.model.structure import Structure


class CoreSystem:
    """A built mechanism, on which all analyses work.

    Attributes
    ----------
    structure : Structure
        Names and index maps.
    roles : Roles
        The constraints and the current choice of degrees of freedom.
    """

    def __init__(
        self,
        evaluation: Evaluation,
        loads: Loads,
        roles: Roles,
        start: Configuration,
        rates: Mapping[str, float],
    ) -> None:
        self._prepare(evaluation, loads, roles)
        none = np.zeros(self.structure.m)
        guess = Snapshot(start.t, start.x, np.zeros(self.structure.n), start.e, none)
        q = self.kinematics.values(start.e, start.x)[roles.dofs]
        rates_at = partial(consistent_rates, self.kinematics, rates=rates)
        begun = just_after(self.kinematics.time_functions, start.t)
        x, v, e = states.located(self.kinematics, begun, q, rates_at, guess)
        self._start = Snapshot(start.t, x, v, e, none)

    def _prepare(self, evaluation: Evaluation, loads: Loads, roles: Roles) -> None:
        """Set the data that do not depend on the initial state."""
        self.structure: Structure = evaluation.structure
        self.evaluation = evaluation
        self.loads = loads
        self.origin: Origin | None = None  # the parts of its model
        self._kinematics: dict[int, Kinematics] = {}
        self._others: dict[tuple[tuple[int, ...], ...], Kinematics] = {}
        self._continued: Snapshot | None = None  # the last position before it was copied
        self.use(roles)

    @property
    def _last(self) -> Snapshot:
        """Return the start of the search for the position of this thread's next right-hand side."""
        return self.kinematics.choice.last or self._continued or self._start

    @property
    def initial(self) -> State:
        """The consistent initial state, with its accelerations.

        Raises
        ------
        DynamicsError
            If a degree of freedom has no inertia; `at_rest` and `unaccelerated` need none.
        """
        return self._complete_start() if self._changes else self._kept_start

    @cached_property
    def _changes(self) -> bool:
        """Whether forces come from functions, whose results may have changed since the last call."""
        return not self.loads.constant or bool(self._callbacks)

    def forget_start(self) -> None:
        """Compute the initial states anew when they are next needed: after a change of parameters or coordinates."""
        self.__dict__.pop("_kept_start", None)
        self.__dict__.pop("at_rest", None)

    @cached_property
    def _kept_start(self) -> State:
        return self._complete_start()

    def _complete_start(self) -> State:
        c = self._start
        begun = just_after(self.kinematics.time_functions, c.t)
        found = dynamics.complete(self.kinematics, begun, c.x, c.v, c.e, self.structure.z0)
        return found if begun == c.t else replace(found, t=c.t)

    @property
    def unaccelerated(self) -> State:
        """The initial state without accelerations and constraint forces, for use where these are undetermined."""
        return self._without_accelerations(self._start.v)

    @cached_property
    def at_rest(self) -> State:
        """The initial configuration without motion and constraint forces: the start of statics."""
        return self._without_accelerations(np.zeros(self.structure.n))

    def _without_accelerations(self, v: Array) -> State:
        c = self._start
        return dynamics.unaccelerated(self.kinematics, c.t, c.x, v, c.e, self.structure.z0)

    def use(self, roles: Roles) -> None:
        """Describe the motion by the degrees of freedom in `roles`, unchecked; see `use_coordinates`."""
        self.roles = roles
        self.kinematics = self.kinematics_of(roles)

    def kinematics_of(self, roles: Roles) -> Kinematics:
        """Return the kinematic problems in the coordinates `roles`, cached."""
        found = self._kinematics.get(id(roles))
        if found is None:  # another thread may be first
            found = self._kinematics.setdefault(id(roles), Kinematics(self.evaluation, roles, self.loads))
        return found

    def kinematics_with(self, dynamic: Index, kinematic: Index) -> Kinematics:
        """Return the kinematic problems with other degrees of freedom, given by quantities, cached."""
        key = tuple(dynamic.tolist()), tuple(kinematic.tolist())
        found = self._others.get(key)
        if found is None:
            other = self.roles.with_dofs(dynamic, kinematic)
            found = self._others.setdefault(key, self.kinematics_of(other))
        return found

    @property
    def dynamic(self) -> tuple[str, ...]:
        """Names of the dynamic degrees of freedom q_d."""
        return tuple(self.structure.names[i] for i in self.roles.dynamic)

    @property
    def kinematic(self) -> tuple[str, ...]:
        """Names of the kinematic degrees of freedom q_k."""
        return tuple(self.structure.names[i] for i in self.roles.kinematic)

    @cached_property
    def counts(self) -> dict[str, int]:
        """Count coordinates, deformations (without Euler-parameter norms), slips and degrees of freedom."""
        s, r = self.structure, self.roles
        norms = s.kinds.count("norm")
        return {
            "coordinates": s.n,
            "free_coordinates": s.nf,
            "deformations": s.m - norms,
            "norms": norms,
            "slips": s.k,
            "degrees_of_freedom": r.nd,
            "kinematic_coordinates": r.nq - r.nd,
            "rigid_deformations": r.rigid.size - norms,
            "prescribed": r.prescribed.size,
            "zero_slips": r.zero.size,
        }

    @prints
    def __repr__(self) -> str:
        c = self.counts
        own, rolling = (f" ({listed(names)})" if names else "" for names in (self.dynamic, self.kinematic))
        nd = c["degrees_of_freedom"]
        return (
            f"System({nd} {'degree' if nd == 1 else 'degrees'} of freedom{own}, {c['kinematic_coordinates']} kinematic "
            f"coordinates{rolling}, {c['coordinates']} coordinates, {c['deformations']} deformations)"
        )

    def time_scaled(self, factor: float) -> Self:
        """Return the system with prescribed motions, loads and initial rates that run `factor` times as fast.

        Times are those of the new system: an event at time t moves to t / factor.
        """
        factor = positive(factor, "time_scaled", "factor")
        found, c = copy(self), self._start
        found._prepare(self.evaluation, self.loads.time_scaled(factor), self.roles.time_scaled(factor))
        found._start = Snapshot(c.t / factor, c.x, factor * c.v, c.e, factor * c.ed)
        return found

    def warm(self, state: State | Snapshot) -> None:
        """Start the next right-hand side from a state: its position and turns of angles."""
        choice = self.kinematics.choice
        choice.reset()
        choice.warm(Snapshot.of(state) if isinstance(state, State) else state)

    @cached_property
    def _callbacks(self) -> list[Callback]:
        """Kernels of continuous controllers."""
        return callbacks_of(self.structure.laws)

    def rhs(self, t: float, y: Array) -> Array:
        """Return the rates of y = (q_d, q_k, q_d', z) (nq + nd + nz,) at time t [s], for integrators of other programs.

        The search for the position starts from that of the last call, or of `warm`.
        """
        if type(t) is not float or not -LARGEST <= t <= LARGEST:
            t = number(t, "rhs", "time t")
        choice = self.kinematics.given(t)
        if not choice.is_warm:
            choice.warm(self._continued or self._start)
        if type(y) is not np.ndarray or y.shape != choice.y.shape or y.dtype != choice.y.dtype:
            y = vector(y, "rhs", "y", choice.y.size)
        choice.y[:] = y
        if code := choice.rhs(t):
            raise self.kinematics.failure(code, t)
        raise_failures(self._callbacks)
        return choice.dy.copy()

    def residual(self, t: float, q: Array, qd: Array, qdd: Array, guess: State) -> Array:
        """Return the residual of the equations of motion, H'(M a + h - f + De' sigma + V' tau) (nd,); zero if met.

        Parameters
        ----------
        t : float
            Time [s].
        q : ndarray (nq,), qd, qdd : ndarray (nd,)
            Degrees of freedom (q_d, q_k), and the first and second rates of q_d.
        guess : State
            A state nearby: start of the search for the position, turns of angles, internal states of laws.

        Raises
        ------
        PositionError
            If the position cannot be reached.
        """
        t, sizes = number(t, "residual", "time t"), (self.roles.nq, self.roles.nd, self.roles.nd)
        q, qd, qdd = map(vector, (q, qd, qdd), ["residual"] * 3, ("q", "qd", "qdd"), sizes)
        near = Snapshot.of(own_state(self.structure, guess, "residual"))
        x, v, e = states.located(self.kinematics, t, q, qd, near.still(t))
        return -dynamics.driving_forces(self.kinematics, t, x, v, e, guess.z, qdd)

    def linearize(self, state: State | None = None) -> LinearizedSystem:
        """Linearize analytically about a state (the initial one by default); see `System.linearize`."""
        state = self.initial if state is None else own_state(self.structure, state, "linearize")
        warn_beyond(self.evaluation, [state.t], state.e[None], state.x[None], "linearize")
        return self._linearization(state)

    def _linearization(self, state: State) -> LinearizedSystem:
        """Linearize for other analyses, which warn of their states themselves."""
        check_smooth(self.structure.controllers, state)
        return linearize(self._usable(state), state)

    def _usable(self, state: State) -> Kinematics:
        """Return the chosen degrees of freedom, or those of the state if the chosen ones are nearly singular."""
        if state.roles is self.roles:
            return self.kinematics
        theirs, here = self.kinematics_of(state.roles), Snapshot.of(state)
        if amplification(self.kinematics, here) <= lost(self.roles) * max(amplification(theirs, here), 1.0):
            return self.kinematics
        warn_replaced(self.kinematics, theirs, state.t)
        return theirs

    @in_one_thread
    def state(self, t: float, x: Array, v: Array, e: Array | None = None, z: Array | None = None) -> State:
        """Return the complete state for coordinates and rates that satisfy the constraints.

        Parameters
        ----------
        t : float
            Time [s].
        x, v : ndarray (n,)
            Coordinates and rates; zero for the rates that prescribed motions determine.
        e : ndarray (m,), optional
            Deformations near the true ones, from which the turns of angles are counted; principal values by default.
        z : ndarray (nz,), optional
            Internal states of laws; their initial values by default.

        Raises
        ------
        DynamicsError
            If a degree of freedom has no inertia; names it.
        """
        s, t = self.structure, number(t, "state", "time t")
        x, v = vector(x, "state", "x", s.n), vector(v, "state", "v", s.n)
        e = None if e is None else vector(e, "state", "e", s.m)
        z = None if z is None else vector(z, "state", "z", s.nz)
        e = self.evaluation.at(t, x, v, z=z, unwrap_from=e).e.copy()
        if not np.any(v) and self.roles.motions:
            choice = self.kinematics.given(t)
            self.kinematics.check(choice.factorize(), t)
            v = self.kinematics.velocity(choice, np.zeros(self.roles.nd))
        return dynamics.complete(self.kinematics, t, x, v, e, self.structure.z0 if z is None else z)

    @in_one_thread
    def state_at(
        self,
        values: Mapping[str, float] | None = None,
        rates: Mapping[str, float] | None = None,
        t: float | None = None,
        start: State | None = None,
    ) -> State:
        """Return a consistent state with given values and rates of degrees of freedom, the others as in `start`.

        Parameters
        ----------
        values : mapping of name to value
            Values of degrees of freedom (dynamic or kinematic) and of laws' internal states; and of any other quantity,
            which then takes the place of the degree of freedom with which it moves most.  The other degrees of freedom
            keep their values.
        rates : mapping of name to rate
            Rates of any quantities; they must be consistent.
        t : float, optional
        start : State, optional
            The initial state by default.

        Raises
        ------
        ModelError, PositionError
            A quantity that is fixed, or determined by the others; an unreachable position; inconsistent rates, by name.
        """
        begin = self.initial if start is None else start
        return states.state_at(self.kinematics, self.kinematics_with, values, rates, t, begin)

    @in_one_thread
    def use_coordinates(self, dynamic: Sequence[str], kinematic: Sequence[str] | None = None) -> None:
        """Use the named quantities as degrees of freedom from now on; they are checked at the initial state."""
        rows = [named_dofs(self.structure, names, "use_coordinates") for names in (dynamic, kinematic)]
        J = self.evaluation.position(self._start.x)[1]
        self.use(replace(choose_dofs(self.kinematics, J, *rows), named=True))
        self.forget_start()

    def __getstate__(self) -> dict[str, Any]:
        """Its model, the present coordinates and the last position; tables and caches are made again."""
        own = {"evaluation": self.evaluation, "loads": self.loads, "roles": self.roles}
        return own | {"last": self._last, "start": self._start, "origin": self.origin}

    def __setstate__(self, state: dict[str, Any]) -> None:
        """The same system; its tables are made when it is first evaluated."""
        self._prepare(state["evaluation"], state["loads"], state["roles"])
        self._start, self._continued, self.origin = state["start"], state["last"], state["origin"]
