"""A periodic motion of a system, sampled and linearized along its path: the nominal motion, or any given one.

Nothing is differentiated numerically: states, coefficients and residual forces come from the system itself.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from flexel.base.arrays import Array
from flexel.base.errors import LinearizationError
from flexel.linear.harmonics import Coefficients
from flexel.mechanics.core import Core
from flexel.mechanics.linearization import Linearization
from flexel.mechanics.linearize import linearize_all
from flexel.mechanics.states import state_of
from flexel.structure.moment import Moment
from flexel.structure.state import State


@dataclass(frozen=True)
class Orbit:
    """A periodic motion, sampled: states and linearizations at equidistant times of one period.

    Attributes
    ----------
    period : float
        [s]
    states : list of State
    linearizations : list of Linearization
    coefficients : Coefficients
        F is the residual force of the held or given motion: zero if it is an actual motion.
    """

    period: float
    states: list[State]
    linearizations: list[Linearization]
    coefficients: Coefficients

    @property
    def t(self) -> Array:
        """Sampled times (ns,) [s]."""
        return np.array([state.t for state in self.states])

    def __getitem__(self, name: str) -> Array:
        """Values (ns,) of a named quantity over the period."""
        return np.array([state[name] for state in self.states])

    def coordinates(self, node: str) -> Array:
        """Coordinates (ns, …) of a node."""
        return np.array([state.position(node) for state in self.states])

    def sensitivity(self, node: str) -> Array:
        """Derivatives (ns, …, nd) of a node's coordinates with respect to the degrees of freedom; zero for fixed
        ones.
        """
        structure, nd = self.states[0].structure, len(self.coefficients.names)
        places = structure.places(node)
        free = places < structure.nf
        found = np.zeros((len(self.states), places.size, nd))
        found[:, free] = [lin.transfer.G[places[free], :nd] for lin in self.linearizations]
        return found

    def force_by_speed(self) -> Array:
        """Derivative (ns, nd) of F by the logarithm of the speed at which the motion is run through.

        All rates are proportional to the speed and all second rates to its square; loads depend on the phase alone.
        """
        found = np.zeros_like(self.coefficients.F)
        for i, (state, lin) in enumerate(zip(self.states, self.linearizations, strict=True)):
            own, given = state.roles.dynamic, state.roles.prescribed
            for quantities, M, C in ((own, lin.M, lin.C), (given, lin.M_u, lin.C_u)):
                found[i] -= 2 * M @ state.Phi_v[quantities] + C @ state.rates[quantities]
        return found

    def displacements(self, node: str, q: Array) -> Array:
        """Small displacements (ns, …) of a node in a vibration q (ns, nd) about the orbit, to first order."""
        return np.asarray(np.einsum("sij,sj->si", self.sensitivity(node), q))


def orbit(
    system: Core,
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
        Number of equidistant times, from that of `start` on.
    motion : callable, optional
        Degrees of freedom, rates and accelerations (ns, nd) at times (ns,); by default the degrees of freedom are held
        at their initial values, while the prescribed motions continue: the nominal motion.
    start : State, optional
        The initial state by default.

    Raises
    ------
    LinearizationError
        A period that is not a positive time; a system with kinematic coordinates, whose values are not determined
        by periodicity.
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
    states, F = [], np.zeros((samples, nd))
    for i in range(samples):
        state = _driven(system, float(t[i]), q[i], qd[i], qdd[i], state)
        F[i] = system.kinematics.choice.multiplier[system.roles.dynamic]  # the driving forces
        states.append(state)
    lins = linearize_all(system.kinematics, states)
    M, C, K = (np.array([getattr(z, name) for z in lins]) for name in ("M", "C", "K"))
    return Orbit(period, states, lins, Coefficients(2 * np.pi / period, M, C, K, F, system.dynamic))


def _driven(system: Core, t: float, q: Array, qd: Array, qdd: Array, near: State) -> State:
    """State in which the degrees of freedom move as given; its stresses and reactions contain the driving forces."""
    place = Moment.of(near).still(t)
    return state_of(system.kinematics, t, q, qd, near.z, place, qdd)
