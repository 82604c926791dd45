"""Samples a periodic motion of a system and linearizes along it: the nominal motion, or any given one.

Nothing is differentiated numerically: states, coefficients and residual forces come from the system itself.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from flexel.base.arrays import Array
from flexel.base.errors import LinearizationError
from flexel.linear.harmonics import Coefficients
from flexel.mechanics.linearize import linearize_all
from flexel.mechanics.linearized_system import LinearizedSystem
from flexel.mechanics.states import state_of
from flexel.mechanics.timed_laws import check_period
from flexel.model.snapshot import Snapshot
from flexel.model.state import State
from flexel.system import CoreSystem


@dataclass(frozen=True)
class Orbit:
    """A periodic motion, sampled: states and linearizations at equidistant times of one period.

    Attributes
    ----------
    period : float
        [s]
    states : list of State
    linearizations : list of LinearizedSystem
    coefficients : Coefficients
        F is the residual force of the held or given motion: zero if it is an actual motion.
    """

    period: float
    states: list[State]
    linearizations: list[LinearizedSystem]
    coefficients: Coefficients

    @property
    def t(self) -> Array:
        """Sampled times (ns,) [s]."""
        return np.array([state.t for state in self.states])

    def __getitem__(self, name: str) -> Array:
        """Return the values (ns,) of a named quantity over the period."""
        return np.array([state[name] for state in self.states])

    def coordinates(self, node: str) -> Array:
        """Return the coordinates (ns, …) of a node."""
        return np.array([state.position(node) for state in self.states])

    def sensitivity(self, node: str) -> Array:
        """Return the derivatives (ns, …, nd) of a node's coordinates with respect to the degrees of freedom; zero for
        fixed coordinates.
        """
        structure, nd = self.states[0].structure, len(self.coefficients.names)
        places = structure.places(node)
        free = places < structure.nf
        found = np.zeros((len(self.states), places.size, nd))
        found[:, free] = [lin.transfer.G[places[free], :nd] for lin in self.linearizations]
        return found

    def force_by_speed(self) -> Array:
        """Return the derivative (ns, nd) of F with respect to the logarithm of the speed of the motion.

        All rates are proportional to the speed and all second rates to its square; loads depend on the phase alone.
        """
        found = np.zeros_like(self.coefficients.F)
        for i, (state, lin) in enumerate(zip(self.states, self.linearizations, strict=True)):
            own, given = state.roles.dynamic, state.roles.prescribed
            for quantities, M, C in ((own, lin.M, lin.C), (given, lin.M_u, lin.C_u)):
                found[i] -= 2 * M @ state.Phi_v[quantities] + C @ state.rates[quantities]
        return found

    def displacements(self, node: str, q: Array) -> Array:
        """Return the small displacements (ns, …) of a node for a vibration q (ns, nd), to first order."""
        return np.asarray(np.einsum("sij,sj->si", self.sensitivity(node), q))


def orbit(
    system: CoreSystem,
    period: float,
    samples: int,
    motion: Callable[[Array], tuple[Array, Array, Array]] | None = None,
    start: State | None = None,
) -> Orbit:
    """Sample a periodic motion and linearize along it.

    Parameters
    ----------
    period : float
        [s]
    samples : int
        Number of equidistant times, starting at `start`.
    motion : callable, optional
        Degrees of freedom, rates and accelerations (ns, nd) at times (ns,); by default the degrees of freedom are held
        at their initial values, while the prescribed motions continue: the nominal motion.
    start : State, optional
        The initial state by default.

    Raises
    ------
    LinearizationError
        A period that is not a positive time; a system with kinematic coordinates, whose values are not determined
        by periodicity; a law that depends on time and does not have the period.
    PositionError
        A position that the mechanism cannot reach, with its time.
    """
    if system.roles.nq != system.roles.nd:
        raise LinearizationError(
            f"periodic motion of a non-holonomic system with kinematic coordinates {system.kinematic} is not "
            "available; prescribe them or remove the rolling condition"
        )
    if system.structure.nz:
        raise LinearizationError(
            f"periodic motion with internal states of laws ({', '.join(system.structure.internal)}) is not available; "
            "integrate the motion until it is periodic, or use laws without them"
        )
    if not (0 < period < np.inf) or samples < 1:
        raise LinearizationError(
            f"periodic motion: period {period:g} s, {samples} samples; both must be positive and finite"
        )
    state = start or system.at_rest
    t = state.t + np.arange(samples) * period / samples
    q0, nd = state.q, system.roles.nd
    still = np.zeros((samples, nd))
    q, qd, qdd = motion(t) if motion else (np.tile(q0, (samples, 1)), still, still)
    states, F = driven_states(system, t, q, qd, qdd, Snapshot.of(state), state.z)
    check_period(system.evaluation, states, period)
    lins = linearize_all(system.kinematics, states)
    M, C, K = (np.array([getattr(lin, name) for lin in lins]) for name in ("M", "C", "K"))
    return Orbit(period, states, lins, Coefficients(2 * np.pi / period, M, C, K, F, system.dynamic))


def driven_states(
    system: CoreSystem, t: Array, q: Array, qd: Array, qdd: Array, start: Snapshot, z: Array
) -> tuple[list[State], Array]:
    """Return the states in which the degrees of freedom move as given, and the forces that drive them.

    Parameters
    ----------
    t : ndarray (ns,)
        Times [s].
    q, qd, qdd : ndarray (ns, nd)
        Degrees of freedom, their first and second rates.
    start : Snapshot
        Start of the search for the first position.
    z : ndarray (nz,)
        Internal states of laws.

    Returns
    -------
    list of State, ndarray (ns, nd)
        The reactions of the states include the driving forces.  These are what the motion lacks to be a true one:
        F of the equations of small vibrations about it.
    """
    states, forces = [], np.zeros((t.size, system.roles.nd))
    for i in range(t.size):
        at = start.still(float(t[i]))
        states.append(state_of(system.kinematics, at.t, q[i], qd[i], z, at, qdd[i]))
        forces[i] = system.kinematics.choice.multiplier[system.roles.dynamic]
        start = Snapshot.of(states[-1])
    return states, forces
