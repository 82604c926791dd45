"""The nominal motion about which equations are linearized: its complete states at any time."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

import numpy as np
from scipy.interpolate import BPoly

from flexel.base.arrays import Array
from flexel.base.errors import LinearizationError
from flexel.integration.trajectory import Trajectory
from flexel.linear.harmonics import PeriodicVibration
from flexel.linear.orbits import driven_states
from flexel.mechanics.states import state_of
from flexel.mechanics.travel import travelled
from flexel.model.snapshot import Snapshot
from flexel.model.state import State, own_state
from flexel.system import CoreSystem

GivenMotion = Callable[[Array], tuple[Array, Array, Array]]  # q, q', q'' (nt, nd) at times
OUTSIDE = 1e-9  # part of the length by which a time may lie outside the motion, for rounding


@dataclass(frozen=True)
class Course:
    """A nominal motion.

    Attributes
    ----------
    t : ndarray (ns,)
        Times of the samples [s].
    find : callable
        Complete states at given times, and the forces (nt, nd) that drive the degrees of freedom there.
    period : float, optional
        [s], if the motion is periodic.
    constant : bool
        Whether it is one state, the same at all times.
    """

    t: Array
    find: Callable[[Array], tuple[list[State], Array]]
    period: float | None = None
    constant: bool = False

    def states(self, times: Array) -> tuple[list[State], Array]:
        """Return states and driving forces at times, which may lie in any period if there is one.

        Raises
        ------
        LinearizationError
            A time outside the motion.
        """
        if self.constant:
            return self.find(times)
        first, last = float(self.t[0]), float(self.t[-1])
        if self.period is not None:
            return self.find(first + np.mod(times - first, self.period))
        slack = OUTSIDE * (last - first)
        wrong = times[(times < first - slack) | (times > last + slack)]
        if wrong.size:
            raise LinearizationError(
                f"along: time {wrong[0]:g} s lies outside the motion, {first:g}…{last:g} s; use a longer motion"
            )
        return self.find(np.clip(times, first, last))


def at_state(system: CoreSystem, state: State, period: float | None) -> Course:
    """Return a state as a motion: the linearized equations are constant."""
    own_state(system.structure, state, "along")

    find = partial(_same, state, system.roles.nd)
    return Course(np.array([state.t]), find, period, constant=True)


def _same(state: State, nd: int, times: Array) -> tuple[list[State], Array]:
    """Return one state at all times."""
    return [state] * times.size, np.zeros((times.size, nd))


def of_motion(system: CoreSystem, motion: Trajectory, period: float | None) -> Course:
    """Return a simulated motion: by its dense output, or through its stored states."""
    if len(motion) < 2:
        raise LinearizationError(
            "along: the motion has one state; give the state, or a motion with more times"
        )
    own_state(system.structure, motion[0], "along")
    found = partial(
        _true, motion.at if motion.interpolates else _interpolated(system, motion), system.roles.nd
    )
    if period is None:
        return Course(motion.t, found)
    length = float(motion.t[-1] - motion.t[0])
    if length < period * (1 - OUTSIDE):
        raise LinearizationError(
            f"along: the motion lasts {length:g} s, which is shorter than its period {period:g} s; simulate one period"
        )
    inner = motion.t < motion.t[0] + period * (1 - OUTSIDE)
    return Course(motion.t[inner], found, period)


def _true(find: Callable[[float], State], nd: int, times: Array) -> tuple[list[State], Array]:
    """Return states of a true motion, which needs no forces."""
    return [find(float(t)) for t in times], np.zeros((times.size, nd))


def _interpolated(system: CoreSystem, motion: Trajectory) -> Callable[[float], State]:
    """Return states through the stored ones: degrees of freedom by polynomials of degree 5 through their rates."""
    states, dofs = list(motion), system.roles.dofs
    nodes = [(state.values[dofs], state.rates[dofs], state.Phi_v[dofs]) for state in states]
    q = BPoly.from_derivatives(motion.t, [np.stack(node) for node in nodes])
    z = BPoly.from_derivatives(motion.t, [np.stack([state.z, state.zd]) for state in states])
    return partial(_through, system, states, q, z)


def _through(system: CoreSystem, states: list[State], q: BPoly, z: BPoly, t: float) -> State:
    """Return the state at degrees of freedom and internal states that are functions of time."""
    guess = Snapshot.of(min(states, key=lambda state: abs(state.t - t)))
    return state_of(system.kinematics, t, q(t), q(t, 1)[: system.roles.nd], z(t), guess)


def held(system: CoreSystem, times: Array, period: float | None) -> Course:
    """Return the motion in which the degrees of freedom keep their initial values while prescribed motions continue.

    Raises
    ------
    LinearizationError
        Kinematic coordinates or internal states, which cannot be held.
    """
    moving = (*system.kinematic, *system.structure.internal)
    if moving:
        raise LinearizationError(
            f"along: {', '.join(moving)} cannot be held, since their rates follow from the motion; give a motion or a "
            "state"
        )
    motion = partial(_still, system.at_rest.q)
    return Course(times, partial(_driven, system, motion, [system.at_rest]), period)


def _still(q: Array, times: Array) -> tuple[Array, Array, Array]:
    """Return degrees of freedom that keep their values, with their rates."""
    rest = np.zeros((times.size, q.size))
    return q + rest, rest, rest


def _driven(
    system: CoreSystem, motion: GivenMotion, known: list[State], times: Array
) -> tuple[list[State], Array]:
    """Return states of a given motion; the search starts from the nearest one that is known, and adds the last."""
    q, qd, qdd = motion(times)
    nearest = min(known, key=lambda state: abs(state.t - float(times[0])))
    start = travelled(system.kinematics, Snapshot.of(nearest), float(times[0]), q[0])
    states, forces = driven_states(system, times, q, qd, qdd, start or Snapshot.of(nearest), nearest.z)
    known.append(states[-1])
    return states, forces


def _series(vibration: PeriodicVibration, start: float, times: Array) -> tuple[Array, Array, Array]:
    """Return degrees of freedom by their Fourier series, with their rates."""
    return vibration.at(times - start)


def of_vibration(system: CoreSystem, vibration: PeriodicVibration, t: Array) -> Course:
    """Return a periodic motion by its Fourier series."""
    find = partial(_driven, system, partial(_series, vibration, float(t[0])), [system.at_rest])
    return Course(t, find, 2 * np.pi / vibration.coefficients.omega)
