"""Linear equations with coefficients that vary in time: small vibrations about a nominal motion, as a result."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace

import numpy as np

from flexel.base.arguments import array, index, mapping, names, number, numbers, positive, unknown, whole
from flexel.base.arrays import Array, ComplexArray, StateSpace
from flexel.base.blas import in_one_thread
from flexel.base.errors import LinearizationError, ModelError
from flexel.base.shown import counted, listed, prints
from flexel.integration.branch import Choices
from flexel.linear.course import Course
from flexel.linear.floquet import FIRST_STEPS, MAX_STEPS, sorted_multipliers
from flexel.linear.harmonics import Coefficients, PeriodicVibration
from flexel.linear.linear_steps import interpolated, refined, transitions
from flexel.linear.sensors import state_space
from flexel.linear.small_vibrations import coefficients
from flexel.linear.state_space_inputs import DISPLACEMENT, Inputs
from flexel.linear.transients import forced_motion
from flexel.mechanics.amplification import amplification, lost
from flexel.mechanics.linearize import linearize_all
from flexel.mechanics.linearized_system import LinearizedSystem
from flexel.mechanics.modes import first_order
from flexel.model.controller import check_smooth
from flexel.model.snapshot import Snapshot
from flexel.model.state import State
from flexel.results.linearization import Linearization, as_linearization
from flexel.results.small_motion import SmallMotion
from flexel.system import CoreSystem


class TimeVarying(Sequence[Linearization]):
    """Linearized equations along a motion, from `System.along`: M δq_d'' + C δq_d' + K δq + Z δz = F + F̄ δu.

    ``along[i]`` is the linearization at sample i, ``along.at(t)`` that at any time of the motion; both are
    analytic.  The states are (δq_d', δq_d, δq_k, δz), in one choice of coordinates for the whole motion.
    They are changes at fixed time, so the accelerations of the nominal motion enter all matrices.

    Attributes
    ----------
    t : ndarray (ns,)
        Sampled times [s].
    period : float or None
        Period of the motion [s], if it has one.
    constant : bool
        Whether it is one state; its matrices are constant.
    """

    def __init__(self, system: CoreSystem, course: Course) -> None:
        self.system, self.course = system, course
        self.t, self.period, self.constant = course.t, course.period, course.constant
        self._samples, self._forces = self.linearized(course.t)

    def __len__(self) -> int:
        return int(self.t.size)

    def __getitem__(self, key: int) -> Linearization:  # type: ignore[override]
        number = index(key, "along", "sample")
        if not -len(self) <= number < len(self):
            raise LinearizationError(f"along: sample {number}; there are {len(self)}, numbered from 0")
        return as_linearization(self._samples[number])

    def __iter__(self) -> Iterator[Linearization]:
        return (self[i] for i in range(len(self)))

    @prints
    def __repr__(self) -> str:
        first, last = self.t[0], self.t[-1]
        span = f"t = {first:g} … {last:g} s" if len(self) > 1 else "constant"
        more = "" if self.period is None else f"; period {self.period:g} s"
        return (
            f"TimeVarying({counted(len(self), 'sample')}, {span}, {counted(len(self.states), 'state')}{more})"
        )

    # -- matrices ------------------------------------------------------------------------------------

    @property
    def dynamic(self) -> tuple[str, ...]:
        """Names of the dynamic degrees of freedom q_d."""
        return self._samples[0].dynamic

    @property
    def dofs(self) -> tuple[str, ...]:
        """Names of q = (q_d, q_k)."""
        return self._samples[0].dofs

    @property
    def internal(self) -> tuple[str, ...]:
        """Names of the internal states z of laws."""
        return self._samples[0].internal

    @property
    def states(self) -> tuple[str, ...]:
        """Names of the states (q_d', q_d, q_k, z)."""
        return self._samples[0].states

    @property
    def M(self) -> Array:  # noqa: N802
        """Mass matrices (ns, nd, nd)."""
        return self._stacked("M")

    @property
    def C(self) -> Array:  # noqa: N802
        """Matrices (ns, nd, nd) of the rates q_d'."""
        return self._stacked("C")

    @property
    def K(self) -> Array:  # noqa: N802
        """Stiffness matrices (ns, nd, nq): columns for dynamic, then kinematic degrees of freedom."""
        return self._stacked("K")

    @property
    def A_k(self) -> Array:  # noqa: N802
        """Matrices (ns, nk, nd) of δq_k' = A_k δq_d' + B_k δq."""
        return self._stacked("A_k")

    @property
    def B_k(self) -> Array:  # noqa: N802
        """Matrices (ns, nk, nq) of the same."""
        return self._stacked("B_k")

    @property
    def F(self) -> Array:  # noqa: N802
        """Forces (ns, nd) that the nominal motion leaves unbalanced; zero for a true motion.

        Where degrees of freedom are held, the vibration about the nominal motion is driven by them.
        """
        return self._forces

    @property
    def state_matrices(self) -> Array:
        """Matrices A (ns, n, n) of the first-order equations at the samples, n = 2 nd + nk + nz."""
        return self._rates(self._samples)

    @in_one_thread
    def at(self, t: float) -> Linearization:
        """Return the linearization at any time [s] of the motion.

        Raises
        ------
        LinearizationError
            A time outside the motion; coordinates that do not determine the position there.
        """
        return as_linearization(self.linearized(np.array([number(t, "along.at", "time")]))[0][0])

    @in_one_thread
    def state_space(
        self, inputs: Sequence[str] = (), outputs: Sequence[str] = (), times: Sequence[float] | None = None
    ) -> StateSpace:
        """Return state-space matrices A, B, C, D (nt, …) along the motion.

        Parameters
        ----------
        inputs, outputs : sequence of str
            As in `Linearization.state_space`, but without ``displacement:``, whose shifted states would need
            the rates of the matrices.
        times : sequence of float, optional
            [s]; the samples by default.

        Raises
        ------
        LinearizationError
            A displacement as an input; or as `at`.
        """
        owner = "along.state_space"
        samples = self._samples if times is None else self.linearized(_grid(times, owner))[0]
        return self._matrices(samples, names(inputs, f"{owner}: inputs"), names(outputs, f"{owner}: outputs"))

    # -- analyses --------------------------------------------------------------------------------

    @in_one_thread
    def transient(
        self,
        initial: Mapping[str, float] | None = None,
        *,
        inputs: Mapping[str, float | Callable[[float], float]] | None = None,
        times: Sequence[float] | Array | None = None,
        tolerance: float = 1e-8,
    ) -> SmallMotion:
        """Integrate small vibrations about the motion, driven by F and by inputs.

        Parameters
        ----------
        initial : mapping of name to number, optional
            Small changes of states at the start, by the names in `states`; zero by default.
        inputs : mapping of name to number or callable(t), optional
            Small changes of loads, or accelerations of prescribed motions, as in `state_space`.
        times : sequence of float, optional
            [s]; the samples by default.
        tolerance : float
            Error relative to the largest state; steps between two times are halved until it is met.

        Raises
        ------
        ModelError
            An unknown state.
        LinearizationError
            A single time; a tolerance that is not met.

        Examples
        --------
        >>> small = system.along(motion).transient({"lean.angle": 0.01})  # doctest: +SKIP
        >>> small["steer.angle"], small.total("steer.angle")  # doctest: +SKIP
        """
        grid = self.t if times is None else _grid(times, "along.transient")
        if grid.size < 2 or np.any(np.diff(grid) <= 0):
            raise LinearizationError("along.transient: give at least two increasing times")
        driven = {
            name: given if callable(given) else number(given, "along.transient", f"input '{name}'")
            for name, given in mapping(inputs, "along.transient", "inputs").items()
        }
        small, tolerance = tuple(driven), positive(tolerance, "along.transient", "tolerance")
        labels = Inputs.of(self._samples[0], small).states(self.states)
        start = np.zeros(len(labels))
        for name, value in numbers(initial, "along.transient", "initial value").items():
            if name not in labels:
                raise ModelError(unknown(name, labels, "state"))
            start[labels.index(name)] = value

        def values(at: Array) -> Array:
            columns = [
                _values(given, at, f"along.transient: input '{name}'")
                if callable(given)
                else np.full(at.size, given)
                for name, given in driven.items()
            ]
            return np.array(columns).reshape(len(small), at.size)

        def equations(at: Array) -> tuple[Array, Array]:
            samples, forces = self.linearized(at)
            A, B, _, _ = self._matrices(samples, small, ())
            b = np.einsum("sij,js->si", B, values(at))
            if forces.any():
                b[:, : forces.shape[1]] += np.array(
                    [np.linalg.solve(lin.M, force) for lin, force in zip(samples, forces, strict=True)]
                )
            return A, b

        x = forced_motion(equations, start, grid, tolerance)
        return SmallMotion(self, grid, x, labels, dict(zip(small, values(grid), strict=True)))

    @in_one_thread
    def multipliers(self, tolerance: float = 1e-9) -> ComplexArray:
        """Compute Floquet multipliers (n,), largest modulus first; below one in modulus, small changes decay.

        A change along the motion itself, or of a coordinate that enters no force, has the multiplier one.

        Parameters
        ----------
        tolerance : float
            Error of the transition matrix over the period, relative to its largest entry.

        Raises
        ------
        LinearizationError
            A motion without a period.
        """
        times = self._turn("multipliers")

        def matrices(at: Array) -> Array:
            return self._rates(self.linearized(at)[0])

        spline = interpolated(
            matrices, float(times[0]), float(times[1]), positive(tolerance, "multipliers", "tolerance")
        )

        def transition(parts: int) -> Array:
            return np.asarray(transitions(spline, times, parts)[0])

        found = refined(transition, tolerance, "along.multipliers", MAX_STEPS, FIRST_STEPS)
        return sorted_multipliers(found)

    @in_one_thread
    def coefficients(self, samples: int) -> Coefficients:
        """Return the equations of (q_d, q_k, z) at equidistant times of the period, for harmonic balance.

        Raises
        ------
        LinearizationError
            A motion without a period.
        """
        first, end = self._turn("coefficients")
        grid = first + (end - first) * np.arange(whole(samples, "along.coefficients", "samples")) / samples
        lins, forces = self.linearized(grid)
        return coefficients(float(end - first), lins, forces)

    @in_one_thread
    def harmonic_balance(
        self,
        harmonics: int,
        *,
        inputs: Mapping[str, Callable[[float], float]] | None = None,
        samples: int | None = None,
        accuracy: float | None = None,
    ) -> PeriodicVibration:
        """Find the periodic small vibration about the periodic motion, driven by F and by loads.

        Parameters
        ----------
        harmonics : int
        inputs : mapping of name to callable(t), optional
            Small periodic loads on named quantities.
        samples : int, optional
            Times in the period; 4 per harmonic and 4 more by default.
        accuracy : float, optional
            Largest permitted amplitude of the neglected harmonics, relative to the largest amplitude.

        Raises
        ------
        LinearizationError
            A motion without a period; as `Coefficients.harmonic_balance`.
        """
        owner = "along.harmonic_balance"
        k = whole(harmonics, owner, "harmonics", most=10**4)
        given = mapping(inputs, owner, "inputs")
        if accuracy is not None:
            accuracy = positive(accuracy, owner, "accuracy")
        c = self.coefficients(4 * k + 4 if samples is None else samples)
        if given:
            t = self.t[0] + 2 * np.pi / c.omega * np.arange(c.samples) / c.samples
            u = np.array([_values(load, t, f"{owner}: input '{name}'") for name, load in given.items()])
            F = c.F.copy()
            for i, lin in enumerate(self.linearized(t)[0]):
                F[i, : len(self.dynamic)] += lin.input_matrix(tuple(given)) @ u[:, i]
            c = replace(c, F=F)
        return c.harmonic_balance(k, accuracy)

    def _turn(self, owner: str) -> Array:
        """Return the start and the end of the period."""
        if self.period is None:
            raise LinearizationError(f"along.{owner}: the motion has no period; give along(…, period=…)")
        return np.array([self.t[0], self.t[0] + self.period])

    # -- at any times, for the analyses ---------------------------------------------------------------

    def linearized(self, times: Array) -> tuple[list[LinearizedSystem], Array]:
        """Linearize at times (nt,) [s]; also returns the forces F (nt, nd) there."""
        if self.constant and "_samples" in self.__dict__:
            return self._samples * times.size, np.tile(self._forces, (times.size, 1))
        states, forces = self.course.states(times)
        for state in states:
            check_smooth(self.system.structure.controllers, state)
            _check_coordinates(self.system, state)
        return linearize_all(self.system.kinematics, states), forces

    @staticmethod
    def _rates(samples: Sequence[LinearizedSystem]) -> Array:
        """Return the state matrices (ns, n, n) of linearizations."""
        M, C, K, Z, A_k, B_k, Z_v, Z_q, Z_z = (
            np.array([getattr(lin, name) for lin in samples])
            for name in ("M", "C", "K", "Z", "A_k", "B_k", "Z_v", "Z_q", "Z_z")
        )
        return first_order(M, (C, K, Z), (A_k, B_k), (Z_v, Z_q, Z_z))

    @staticmethod
    def _matrices(
        samples: Sequence[LinearizedSystem], inputs: Sequence[str], outputs: Sequence[str]
    ) -> StateSpace:
        """Return state-space matrices (ns, …) of linearizations."""
        for name in inputs:
            if isinstance(name, str) and name.startswith(DISPLACEMENT):
                base = name.removeprefix(DISPLACEMENT)
                raise LinearizationError(
                    f"along: input '{name}': its states would contain rates of the matrices; take the acceleration, "
                    f"\"{base}''\""
                )
        parts = [state_space(lin, inputs, outputs) for lin in samples]
        A, B, C, D = (np.array(column) for column in zip(*parts, strict=True))
        return A, B, C, D

    def _stacked(self, name: str) -> Array:
        return np.array([getattr(lin, name) for lin in self._samples])


def _grid(times: Sequence[float] | Array, owner: str) -> Array:
    """Return times as an array (nt,) of at least one."""
    grid = array(times, owner, "times")
    if grid.ndim != 1 or not grid.size:
        raise ModelError(f"{owner}: times must be a list of at least one time [s]")
    return grid


def _values(function: Callable[[float], float], times: Array, owner: str) -> Array:
    """Return the values (nt,) of a function of time that a user gave."""
    if not callable(function):
        raise ModelError(f"{owner} must be a function of time, such as lambda t: 0.1 * np.cos(2 * t)")
    return np.array([number(function(float(t)), owner, "value") for t in times])


def _check_coordinates(system: CoreSystem, state: State) -> None:
    """Refuse coordinates that are nearly singular at a state, where others are not."""
    here, own = Snapshot.of(state), system.kinematics
    present, limit = amplification(own, here), lost(system.roles)
    if present <= limit:
        return  # the amplification of any choice is about one or more
    theirs = Choices(system, own, True).worse(here, present, limit)
    if theirs is not None:
        raise LinearizationError(
            f"along: the degrees of freedom {listed(system.dynamic)} are nearly singular at t = {state.t:g} s, and "
            f"the matrices need one choice for the whole motion; call "
            f"system.use_coordinates([{theirs.names(theirs.roles.dynamic)}]), or take a part of the motion"
        )
