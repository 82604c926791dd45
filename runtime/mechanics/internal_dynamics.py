"""The internal dynamics of a path that actuators hold: the vibrations that remain while it is followed.

The path is prescribed, and the forces tau of actuators hold it.  Linearized with the path free, with δq = (path, q_d):
M δq'' + C δq' + K δq = F δtau.  With the path held, its columns vanish, and T with T F = 0 removes the forces:
T M_d δq_d'' + T C_d δq_d' + T K_d δq_d = 0.  The eigenvalues are the zeros of the transfer functions from the actuators
to the path.  Source: Isidori (1995), Nonlinear Control Systems, on zero dynamics; Seifried (2014), Dynamics of
Underactuated Multibody Systems.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from scipy.linalg import qr

from flexel.base.arrays import Array, ComplexArray
from flexel.base.errors import DynamicsError
from flexel.base.shown import quoted
from flexel.mechanics.actuation import path_of, unheld
from flexel.mechanics.kinematics import Kinematics
from flexel.mechanics.linearize import linearize
from flexel.mechanics.linearized_system import LinearizedSystem
from flexel.mechanics.modes import first_order
from flexel.model.state import State

GROWTH = 1.0  # exponent over the whole motion from which a vibration grows; rounding errors and moving states give less
SINGULAR = 1e-12  # reciprocal condition of the mass matrix of the internal dynamics that is singular


@dataclass(frozen=True)
class InternalDynamics:
    """Linearized internal dynamics about a state.

    Attributes
    ----------
    names : tuple of str
        States: rates of the dynamic degrees of freedom, these, the kinematic ones, internal states of laws.
    matrix : ndarray
        State matrix [1/s].
    """

    names: tuple[str, ...]
    matrix: Array

    def modes(self) -> tuple[ComplexArray, Array]:
        """Return the eigenvalues [1/s] and, in columns, the sizes of the states in their modes."""
        values, shapes = np.linalg.eig(self.matrix)
        return values, np.abs(shapes)


def internal_dynamics(kinematics: Kinematics, state: State) -> InternalDynamics:
    """Linearize the internal dynamics about a state of a system with actuators.

    Raises
    ------
    DynamicsError
        If the actuators do not move the path there; by name.
    """
    roles, s = kinematics.roles, kinematics.structure
    path, rest = roles.prescribed[roles.moved], np.delete(np.arange(roles.prescribed.size), roles.moved)
    free = replace(
        roles,
        prescribed=roles.prescribed[rest],
        motions=tuple(roles.motions[i] for i in rest),
        dynamic=np.concatenate([path, roles.dynamic]),
        actuators=None,
    )
    lin = linearize(Kinematics(kinematics.evaluation, free, kinematics.loads), replace(state, roles=free))
    T, own = _without_forces(lin, path_of(s, roles)[1]), slice(path.size, None)
    M = T @ lin.M[:, own]
    if M.size and np.linalg.cond(M / np.abs(M).max(axis=0)) * SINGULAR > 1:
        raise unheld(s, roles)
    matrix = first_order(
        M,
        (T @ lin.C[:, own], T @ lin.K[:, own], T @ lin.Z),
        (lin.A_k[:, own], lin.B_k[:, own]),
        (lin.Z_v[:, own], lin.Z_q[:, own], lin.Z_z),
    )
    names = lin.dynamic[path.size :]
    return InternalDynamics((*(f"{name}'" for name in names), *names, *lin.kinematic, *lin.internal), matrix)


def _without_forces(lin: LinearizedSystem, actuators: list[str]) -> Array:
    """Return T (nd, np + nd), orthonormal rows, with T F = 0 for the forces of the actuators."""
    return np.asarray(qr(lin.input_matrix(actuators))[0][:, len(actuators) :].T)


def growth(kinematics: Kinematics, state: State, duration: float) -> str | None:
    """Return what grows in the internal dynamics about a state, in words; None if nothing does, or without actuators.

    Parameters
    ----------
    kinematics : Kinematics
    state : State
    duration : float
        Of the motion [s], in which it must grow to be reported.
    """
    if not kinematics.roles.actuated or not kinematics.roles.nq:
        return None
    found = internal_dynamics(kinematics, state)
    values, sizes = found.modes()
    worst = int(np.argmax(values.real))
    if values[worst].real * duration < GROWTH:
        return None
    path, actuators = path_of(kinematics.structure, kinematics.roles)
    count = kinematics.roles.nd  # of rates, which are left out
    grows = found.names[count + int(np.argmax(sizes[count:, worst]))]
    return (
        f"while {quoted(actuators)} {'hold' if len(actuators) > 1 else 'holds'} the path of {quoted(path)}, the "
        f"internal dynamics is unstable at t = {state.t:.6g} s: '{grows}' grows by exp({values[worst].real:.4g} t); "
        "prescribe points nearer to the actuators, or prescribe the actuators themselves and accept the vibrations"
    )


def check_stable(kinematics: Kinematics, state: State, duration: float) -> None:
    """Refuse a path that actuators cannot hold for a duration [s] without vibrations that grow.

    Raises
    ------
    DynamicsError
        Names the actuators, the path, what grows and how fast.
    """
    text = growth(kinematics, state, duration)
    if text is not None:
        raise DynamicsError(f"simulate: {text}")
