"""The core of a built system: one structure, its roles and laws, and the evaluations on which all analyses are built.

Three methods carry all numerical work: `rhs` (right-hand side of the equations of motion), `residual`
(with its tangent from `linearize`) and `linearize`.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from copy import copy
from dataclasses import replace
from functools import cached_property, partial
from typing import Self

import numpy as np

from flexel.base.arguments import LARGEST, number, positive, vector
from flexel.base.arrays import Array, Index
from flexel.base.shown import listed
from flexel.engine.evaluate import Evaluation
from flexel.mechanics import dynamics, states
from flexel.mechanics.bent import warn_bent
from flexel.mechanics.diagnose import choose_dofs, named_dofs
from flexel.mechanics.kinematics import Configuration, Kinematics
from flexel.mechanics.linearization import Linearization
from flexel.mechanics.linearize import linearize
from flexel.mechanics.reach import lost, reach, warn_replaced
from flexel.mechanics.start_rates import consistent_rates
from flexel.structure.callbacks import Callback, raise_failures
from flexel.structure.controllers import check_smooth
from flexel.structure.loads import Loads
from flexel.structure.moment import Moment
from flexel.structure.roles import Roles
from flexel.structure.state import State, own_state
from flexel.structure.structure import Structure


class Core:
    """Base of every analysis of a system.

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
        near = Moment(start.t, start.x, np.zeros(self.structure.n), start.e, none)
        q = self.kinematics.values(start.e, start.x)[roles.dofs]
        rates_at = partial(consistent_rates, self.kinematics, rates=rates)
        x, v, e = states.located(self.kinematics, start.t, q, rates_at, near)
        self._start = Moment(start.t, x, v, e, none)

    def _prepare(self, evaluation: Evaluation, loads: Loads, roles: Roles) -> None:
        """Set the data that do not depend on the initial state."""
        self.structure: Structure = evaluation.structure
        self.evaluation = evaluation
        self.loads = loads
        self._kinematics: dict[int, Kinematics] = {}
        self._others: dict[tuple[tuple[int, ...], ...], Kinematics] = {}
        self._continued: Moment | None = None  # the last position before it was copied
        self.use(roles)

    @property
    def _last(self) -> Moment:
        """The start of the search for the position of the next right-hand side of this thread."""
        return self.kinematics.choice.last or self._continued or self._start

    @cached_property
    def initial(self) -> State:
        """The consistent initial state, with its accelerations.

        Raises
        ------
        DynamicsError
            If a degree of freedom has no inertia; `at_rest` and `unaccelerated` need none.
        """
        c = self._start
        return dynamics.complete(self.kinematics, c.t, c.x, c.v, c.e, self.structure.z0)

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
        """The kinematic problems in the coordinates `roles`, cached."""
        found = self._kinematics.get(id(roles))
        if found is None:  # another thread may be first
            found = self._kinematics.setdefault(id(roles), Kinematics(self.evaluation, roles, self.loads))
        return found

    def kinematics_with(self, dynamic: Index, kinematic: Index) -> Kinematics:
        """The kinematic problems with other degrees of freedom, given by quantities, cached."""
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
        """Numbers of coordinates, deformations (without Euler-parameter norms), slips, degrees of freedom."""
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

    def __repr__(self) -> str:
        c = self.counts
        own, rolling = (f" ({listed(names)})" if names else "" for names in (self.dynamic, self.kinematic))
        nd = c["degrees_of_freedom"]
        return (
            f"System({nd} {'degree' if nd == 1 else 'degrees'} of freedom{own}, {c['kinematic_coordinates']} kinematic "
            f"coordinates{rolling}, {c['coordinates']} coordinates, {c['deformations']} deformations)"
        )

    def faster(self, factor: float) -> Self:
        """The same system with prescribed motions, loads and initial rates that run `factor` times as fast.

        Time is that of the new system: what happened at time t happens at t / factor.
        """
        factor = positive(factor, "faster", "factor")
        found, c = copy(self), self._start
        found._prepare(self.evaluation, self.loads.faster(factor), self.roles.faster(factor))
        found._start = Moment(c.t / factor, c.x, factor * c.v, c.e, factor * c.ed)
        return found

    def warm(self, state: State | Moment) -> None:
        """Start the next right-hand side from a state: its position and turns of angles."""
        choice = self.kinematics.choice
        choice.reset()
        choice.warm(Moment.of(state) if isinstance(state, State) else state)

    @cached_property
    def _commanded(self) -> bool:
        """Whether forces come from continuous controllers."""
        return any(isinstance(law.code, Callback) for law in self.structure.laws)

    def rhs(self, t: float, y: Array) -> Array:
        """Rates of y = (q_d, q_k, q_d', z) (nq + nd + nz,) at time t [s]."""
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
        if self._commanded:
            raise_failures(law.code for law in self.structure.laws)
        return choice.dy.copy()

    def residual(self, t: float, q: Array, qd: Array, qdd: Array, guess: State) -> Array:
        """Residual of the equations of motion, H'(M a + h - f + De' sigma + V' tau) (nd,); zero in a true motion.

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
        near = Moment.of(own_state(self.structure, guess, "residual"))
        x, v, e = states.located(self.kinematics, t, q, qd, near.still(t))
        return -dynamics.driving_forces(self.kinematics, t, x, v, e, guess.z, qdd)

    def linearize(self, state: State | None = None) -> Linearization:
        """Analytic linearization about a state (the initial one by default).

        Functions of continuous controllers are differentiated numerically, and must be smooth there and within limits.
        Sampled controllers hold their outputs; `Linearization.sampled` closes their loop.

        Warns
        -----
        RangeWarning
            If a beam is bent or twisted by more than 15° within one element.

        Examples
        --------
        >>> lin = system.linearize(motion[-1])  # doctest: +SKIP
        >>> lin.eigenvalues()  # doctest: +SKIP
        """
        state = self.initial if state is None else own_state(self.structure, state, "linearize")
        warn_bent(self.structure, [state.t], state.e[None], "linearize")
        return self._linearization(state)

    def _linearization(self, state: State) -> Linearization:
        """The same for other analyses, which warn of their states themselves."""
        check_smooth(self.structure.controllers, state)
        return linearize(self._usable(state), state)

    def _usable(self, state: State) -> Kinematics:
        """The chosen degrees of freedom, or those of the state where the chosen ones are nearly singular."""
        if state.roles is self.roles:
            return self.kinematics
        theirs, near = self.kinematics_of(state.roles), Moment.of(state)
        if reach(self.kinematics, near) <= lost(self.roles) * max(reach(theirs, near), 1.0):
            return self.kinematics
        warn_replaced(self.kinematics, theirs, state.t)
        return theirs

    def state(self, t: float, x: Array, v: Array, e: Array | None = None, z: Array | None = None) -> State:
        """Complete state from coordinates and rates that satisfy the constraints.

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
        e = self.evaluation.at(t, x, v, z=z, near=e).e.copy()
        if not np.any(v) and self.roles.motions:
            choice = self.kinematics.given(t)
            self.kinematics.check(choice.factorize(), t)
            v = self.kinematics.velocity(choice, np.zeros(self.roles.nd))
        return dynamics.complete(self.kinematics, t, x, v, e, self.structure.z0 if z is None else z)

    def state_at(
        self,
        values: Mapping[str, float] | None = None,
        rates: Mapping[str, float] | None = None,
        t: float | None = None,
        start: State | None = None,
    ) -> State:
        """Consistent state with given values and rates of the named degrees of freedom, the others as in `start`.

        Parameters
        ----------
        values : mapping of name to value
            Values of degrees of freedom (dynamic or kinematic) and of laws' internal states.
        rates : mapping of name to rate
            Rates of any quantities; they must be consistent.
        t : float, optional
        start : State, optional
            The initial state by default.

        Raises
        ------
        ModelError, PositionError
            A name that is not a degree of freedom; an unreachable position; inconsistent rates, by name.
        """
        return states.state_at(self.kinematics, values, rates, t, self.initial if start is None else start)

    def use_coordinates(self, dynamic: Sequence[str], kinematic: Sequence[str] | None = None) -> None:
        """Use the named quantities as degrees of freedom from now on; checked at the initial state."""
        rows = [named_dofs(self.structure, z, "use_coordinates") for z in (dynamic, kinematic)]
        J = self.evaluation.position(self._start.x)[1]
        self.use(replace(choose_dofs(self.kinematics, J, *rows), named=True))
        self.__dict__.pop("initial", None)
        self.__dict__.pop("at_rest", None)
