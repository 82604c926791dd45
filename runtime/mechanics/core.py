"""The core of a built system: one structure, its roles and laws, and the evaluations on which all analyses are built.

Three methods carry all numerical work: `rhs` (right-hand side of the equations of motion), `residual`
(with its tangent from `linearize`) and `linearize`.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import cached_property

import numpy as np

from flexel.base.arrays import Array
from flexel.base.errors import ConstraintError
from flexel.engine.evaluate import Evaluation
from flexel.engine.solvers import Factorization
from flexel.mechanics import dynamics, states
from flexel.mechanics.diagnose import choose_dofs, named_dofs
from flexel.mechanics.kinematics import Configuration, Kinematics, unwrap
from flexel.mechanics.linearization import Linearization
from flexel.mechanics.linearize import linearize
from flexel.mechanics.states import Moment
from flexel.structure.loads import Loads
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
        self.structure: Structure = evaluation.structure
        self.evaluation = evaluation
        self.local = evaluation.local
        self.loads = loads
        self._kinematics: dict[int, Kinematics] = {}
        self.use(roles)
        still = np.zeros(self.structure.n)
        self._last = Moment(start.t, start.x, still, start.e, np.zeros(self.structure.m))
        self._wound = bool(self.structure.relations) or any(  # if forces depend on counted turns of an angle
            self.structure.period[self.structure.index[z]]
            for law in self.structure.laws
            for z in law.deformations
        )
        qd = states.consistent_rates(self.kinematics, start, rates)
        self._start = start, self.kinematics.velocity(start, self.kinematics.velocity_matrix(start), qd)

    @cached_property
    def initial(self) -> State:
        """The consistent initial state, with its accelerations.

        Raises
        ------
        DynamicsError
            If a degree of freedom has no inertia; `at_rest` and `unaccelerated` need none.
        """
        c, v = self._start
        return dynamics.complete(self.kinematics, self.loads, c, v, c.e, self.structure.z0)

    @property
    def unaccelerated(self) -> State:
        """The initial state without accelerations and constraint forces, for use where these are undetermined."""
        return self._without_accelerations(self._start[1])

    @cached_property
    def at_rest(self) -> State:
        """The initial configuration without motion and constraint forces: the start of statics."""
        return self._without_accelerations(np.zeros(self.structure.n))

    def _without_accelerations(self, v: Array) -> State:
        c, z = self._start[0], self.structure.z0
        given = dynamics.forces(self.kinematics, self.loads, c, v, c.e, z)
        a, none = np.zeros(self.structure.n), np.zeros(len(self.structure.names))
        return dynamics.with_multipliers(self.kinematics, self.loads, c, v, a, c.e, z, given, none)

    def use(self, roles: Roles) -> None:
        """Describe the motion by the degrees of freedom in `roles`, unchecked; see `use_coordinates`."""
        self.roles = roles
        self.kinematics = self.kinematics_of(roles)

    def kinematics_of(self, roles: Roles) -> Kinematics:
        """The kinematic problems in the coordinates `roles`, cached."""
        if id(roles) not in self._kinematics:
            self._kinematics[id(roles)] = Kinematics(self.evaluation, roles)
        return self._kinematics[id(roles)]

    # -- counts and names ------------------------------------------------------------------------

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
        degrees = "degree" if c["degrees_of_freedom"] == 1 else "degrees"
        return (
            f"System({c['degrees_of_freedom']} {degrees} of freedom {self.dynamic}, {c['kinematic_coordinates']} "
            f"kinematic coordinates {self.kinematic}, {c['coordinates']} coordinates, {c['deformations']} deformations)"
        )

    # -- evaluation ------------------------------------------------------------------------------

    def warm(self, state: State) -> None:
        """Start the next position problem from a state, and count turns of angles from it."""
        self._last = Moment.of(state)
        self.kinematics.forget()

    @property
    def position_guess(self) -> Array:
        """Coordinates (n,) of the last evaluation of `rhs`."""
        return self._last.x

    def rhs(self, t: float, y: Array) -> Array:
        """Rates of y = (q_d, q_k, q_d', z) (nq + nd + nz,) at time t [s]."""
        kinematics, nq = self.kinematics, self.roles.nq
        qd, z = y[nq : nq + self.roles.nd], y[nq + self.roles.nd :]
        last = self._last
        c, B, v = states.placed(kinematics, t, y[:nq], qd, last.x, last.turns(t))
        e, ed = states.turned(kinematics, c, v, y[:nq], last) if self._wound else (c.e, last.ed)
        self._last = Moment(t, c.x, v, e, ed)
        F = dynamics.forces(kinematics, self.loads, c, v, e, z)
        motion = dynamics.accelerations(kinematics, c, B, v, F)
        return np.concatenate([qd, c.J[self.roles.kinematic] @ v, motion.qdd, F.zd])

    def residual(self, t: float, q: Array, qd: Array, qdd: Array, guess: State) -> Array:
        """Residual of the equations of motion, H'(M a + h - f + De' sigma + V' tau) (nd,); zero in a true motion.

        Parameters
        ----------
        t : float
            Time [s].
        q : ndarray (nq,), qd, qdd : ndarray (nd,)
            Degrees of freedom (q_d, q_k), and the first and second rates of q_d.
        guess : State
            Nearby: where to look for the position, turns of angles, internal states of laws.

        Raises
        ------
        PositionError
            If the position cannot be reached.
        """
        kinematics, nf = self.kinematics, self.structure.nf
        c, B, v = states.placed(kinematics, t, q, qd, guess.x, guess.e)
        F = dynamics.forces(kinematics, self.loads, c, v, unwrap(self.structure, c.e, guess.e), guess.z)
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

    def state(self, t: float, x: Array, v: Array, e: Array | None = None, z: Array | None = None) -> State:
        """Complete state from coordinates and rates that satisfy the constraints.

        Parameters
        ----------
        t : float
            Time [s].
        x, v : ndarray (n,)
            Coordinates and rates; rates of zero stand for those that prescribed motions ask for.
        e : ndarray (m,), optional
            Deformations near the true ones, from which the turns of angles are counted; principal values by default.
        z : ndarray (nz,), optional
            Internal states of laws; their initial values by default.

        Raises
        ------
        DynamicsError
            If a degree of freedom has no inertia; names it.
        """
        principal, J = self.kinematics.evaluate(x)
        e = principal if e is None else unwrap(self.structure, principal, e)
        c = Configuration(t, x, e, J)
        if not np.any(v) and self.roles.motions:
            B = self.kinematics.velocity_matrix(c)
            v = self.kinematics.velocity(c, B, np.zeros(self.roles.nd))
        z = self.structure.z0 if z is None else z
        return dynamics.complete(self.kinematics, self.loads, c, v, e, z)

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
        return states.state_at(self.kinematics, self.loads, values or {}, rates, t, start or self.initial)

    # -- choice of coordinates -------------------------------------------------------------------

    def condition(self, state: State, roles: Roles | None = None) -> float:
        """Reciprocal condition number of the velocity and position matrices with scaled rows; small is bad."""
        roles, nf = roles or self.roles, self.structure.nf
        found = 1.0
        both = roles.velocity_rows, roles.position_rows
        for rows in both[: 1 if np.array_equal(*both) else 2]:
            A = state.J[rows, :nf]
            found = min(found, Factorization(A / np.linalg.norm(A, axis=1, keepdims=True)).rcond)
        return found

    def rechoose(self, state: State, needed: float) -> State | None:
        """Choose the best degrees of freedom at a state, if their condition reaches `needed`; the state in them."""
        try:
            roles = choose_dofs(self.kinematics, state.J, None, None)
        except ConstraintError:  # at a singular position there is no better choice: keep the current one
            return None
        if self.condition(state, roles) < needed:
            return None
        self.use(roles)
        return self.state(state.t, state.x, state.v, state.e, state.z)

    def use_coordinates(self, dynamic: Sequence[str], kinematic: Sequence[str] | None = None) -> None:
        """Use the named quantities as degrees of freedom from now on; checked at the initial state."""
        rows = [named_dofs(self.structure, z, "use_coordinates") for z in (dynamic, kinematic)]
        self.use(choose_dofs(self.kinematics, self._start[0].J, *rows))
        self.__dict__.pop("initial", None)
        self.__dict__.pop("at_rest", None)
