"""Performs linear analyses of a file, in SPACAR's coordinates, signs and names of matrices.

M0 δq'' + (C0 + D0) δq' + (K0 + N0 + G0) δq = B0 δu.  Source: UT SPACAR; Jonker and Meijaard (1990).
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from scipy.linalg import eigvals

from flexel.apps.spacar.file import SpacarFile
from flexel.base.arrays import Array, ComplexArray
from flexel.base.errors import ModelError
from flexel.base.shown import Listing
from flexel.linear.sensors import state_space
from flexel.mechanics.linearize import linearize
from flexel.mechanics.linearized_system import LinearizedSystem
from flexel.mechanics.ranges import warn_beyond
from flexel.model.controller import check_smooth
from flexel.model.state import State, own_state
from flexel.results.system_facade import System
from flexel.statics.load_path import equilibrium
from flexel.statics.stability import BucklingMode, Vibration


@dataclass(frozen=True)
class Matrices:
    """Coefficients of the linearized equations, split by their origin.

    Attributes
    ----------
    coordinates : tuple of str
        The degrees of freedom: dynamic, then kinematic ones.
    M0 : ndarray (nd, nd)
        Mass.
    C0, D0 : ndarray (nd, nd)
        Velocity dependence: of the inertia (gyroscopic), and of damping.
    K0, N0, G0 : ndarray (nd, nq)
        Stiffness: of the material; dynamic (of rates and accelerations); geometric (of stresses, of reactions and
        of weight).
    """

    coordinates: tuple[str, ...]
    M0: Array
    C0: Array
    D0: Array
    K0: Array
    N0: Array
    G0: Array

    def as_dict(self) -> dict[str, Array]:
        """Return the six matrices by name."""
        return {name: getattr(self, name) for name in ("M0", "C0", "D0", "K0", "N0", "G0")}

    def frequencies(self) -> ComplexArray:
        """Return natural frequencies [rad/s] of M0 and K0 + N0 + G0; imaginary for unstable motions.

        A motion with the frequency i w grows as exp(w t).

        Raises
        ------
        ModelError
            If there are kinematic degrees of freedom.
        """
        if len(self.coordinates) != len(self.M0):
            raise ModelError(
                "frequencies: the stiffness has columns of kinematic coordinates; use a linearization"
            )
        if not self.coordinates:
            return np.zeros(0, dtype=np.complex128)
        squares = np.sort_complex(eigvals(self.K0 + self.N0 + self.G0, self.M0))
        small = np.abs(squares.imag) <= 1e-9 * np.abs(squares).max(initial=0.0)
        return np.sqrt(np.where(small, squares.real, squares).astype(np.complex128))


def _geometric(system: System, state: State) -> Any:
    """Return the derivative (nf, nf) of the forces at a state at rest with its stresses held: laws have no slope."""
    still = np.zeros(state.x.size)
    work = system.evaluation.at(state.t, state.x, still, still, state.z, state.e)
    work.inertia()
    work.laws()
    work.stress[:] = state.stresses
    work.S[:] = work.S_rate[:] = 0.0
    work.tangent(1.0, 0.0, 0.0, phi=False)
    pattern = work.tables.T.pattern
    return pattern.matrix(work.T[: pattern.size].copy())


class LinearModels(SpacarFile):
    """Linearized models, frequencies and buckling of a file."""

    def _system(self, given: System | None) -> System:
        """Return a variant of the file's system, or the system itself."""
        if given is not None and not isinstance(given, System):
            raise ModelError(
                f"{self.path.name}: {type(given).__name__} is not a system; give what variant(…) returned"
            )
        return self.system if given is None else given

    def _linearized(self, system: System, state: State | None) -> LinearizedSystem:
        """Linearize in the coordinates that the file names, whatever those of the state are.

        Raises
        ------
        ConstraintError
            If these do not determine the motion at the state.
        """
        state = system.initial if state is None else own_state(system.structure, state, self.path.name)
        warn_beyond(system.evaluation, [state.t], state.e[None], state.x[None], "linearize")
        check_smooth(system.structure.controllers, state)
        return linearize(system.kinematics, state)

    def matrices(self, state: State | None = None, *, system: System | None = None) -> Matrices:
        """Return mass, damping and stiffness matrices about a state, split as in SPACAR.

        Parameters
        ----------
        state : State, optional
            The initial state by default.
        system : System, optional
            The system of the state, if it is a variant of the file's system.

        Raises
        ------
        LinearizationError, DynamicsError
        """
        system = self._system(system)
        lin = self._linearized(system, state)
        still = np.zeros(lin.state.x.size)
        # without rates and accelerations, but with all stresses, no dynamic terms remain
        rest = self._linearized(system, replace(lin.state, v=still, a=still))
        f = np.array([self.factor(name) for name in lin.dofs])
        nd, nq, nf = len(lin.dynamic), len(lin.dofs), lin.state.structure.nf
        m, k = lin.state.structure.m, lin.state.structure.k
        dual, De = lin.state.J[: m + k, :nf] @ lin.transfer.H[:, :nd], lin.state.J[:m, :nf]
        G = lin.transfer.G[:, :nq]
        material = dual.T @ lin.tangents.stress_e @ De @ G
        # not the difference of stiffnesses, which would keep rounding errors of the material's
        geometric = lin.transfer.H[:, :nd].T @ (_geometric(system, lin.state) @ G)
        rows, columns = 1 / f[:nd, None], 1 / f[None, :]
        return Matrices(
            coordinates=lin.dofs,
            M0=rows * lin.M * columns[:, :nd],
            C0=rows * (lin.C - rest.C) * columns[:, :nd],
            D0=rows * rest.C * columns[:, :nd],
            K0=rows * material * columns,
            N0=rows * (lin.K - rest.K) * columns,
            G0=rows * geometric * columns,
        )

    def state_space(
        self, state: State | None = None, *, system: System | None = None
    ) -> tuple[Array, Array, Array, Array]:
        """Return matrices A, B, C, D of the linear model with the file's inputs and outputs, in its signs.

        The states are all degrees of freedom, then the rates of the dynamic ones, as in SPACAR; those of laws are
        the last.  An INPUTS is the stress itself.

        Parameters
        ----------
        state : State, optional
            The initial state by default.
        system : System, optional
            The system of the state, if it is a variant of the file's system.

        Raises
        ------
        LinearizationError
        """
        lin = self._linearized(self._system(system), state)
        A, B, C, D = state_space(
            lin, [terminal.name for terminal in self.inputs], [terminal.name for terminal in self.outputs]
        )
        rates, values = len(lin.dynamic), len(lin.dynamic) + len(lin.dofs)
        order = [*range(rates, values), *range(rates), *range(values, len(lin.states))]
        A, B, C = A[np.ix_(order, order)], B[order], C[:, order]
        f = np.array([self.factor(lin.states[i].rstrip("'")) for i in order])
        u, y = (
            np.array([terminal.factor for terminal in self.inputs]),
            np.array([terminal.factor for terminal in self.outputs]),
        )
        return (
            f[:, None] * A / f,
            f[:, None] * B / u,
            y[:, None] * C / f,
            y[:, None] * D / u,
        )

    def frequencies(self, state: State | None = None, count: int = 10) -> Listing[Vibration]:
        """Return the lowest natural frequencies [rad/s] and modes; by default about the static equilibrium."""
        return self.system.vibrations(state, count=count)

    def buckling(self, count: int = 5) -> Listing[BucklingMode]:
        """Return multipliers of the file's loads at which the mechanism buckles, from its unloaded equilibrium.

        Raises
        ------
        ModelError
            If the file has no loads (FORCE, XF, TORQUEL); weight by GRAVITY is not multiplied.
        """
        loads: dict[str, float] = {}
        for load in self.model.loads:
            loads[load.name] = loads.get(load.name, 0.0) + load.function.rates(self.start)[0]
        if not loads:
            raise ModelError(f"{self.path.name}: there are no loads to multiply; add lines FORCE or XF")
        unloaded = self.variant(loads=False)
        start = equilibrium(unloaded, None, unloaded.at_rest).state  # buckling reports if it is unstable
        return unloaded.buckling(start, increment=loads, count=count)

    def static_steps(self) -> tuple[System, list[State]]:
        """Find equilibria while the increments DELXF and DELINPX are applied in equal steps.

        Returns
        -------
        system : System
            With the increments as loads and motions in proportion to the time, 0 to 1.
        states : list of State
            One more than the number of steps.

        Raises
        ------
        PositionError, DynamicsError
            If an equilibrium is not found.
        """
        system = self.variant(load_steps=True)
        states: list[State] = []
        for i in range(self.increments + 1):
            states.append(system.equilibrium(states[-1] if states else None, t=i / self.increments))
        return system, states
