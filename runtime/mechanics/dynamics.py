"""Completes states: accelerations, stresses, reactions and energies for coordinates and rates that satisfy the
constraints.

H' [ M a + h - f + De' sigma + V' tau ] = 0 with a = H q_d'' + g.  The multipliers (stresses of rigid deformations and
rolling contacts, driving forces of prescribed motions) follow from the factorized position matrix, or with the
accelerations.  Computed in C, see `runtime/engine/explicit.h`.  Source: Jonker and Meijaard (1990); Schwab and Meijaard
(2003), eqs. (17)-(22).
"""

from __future__ import annotations

from flexel.base.arrays import Array
from flexel.engine.coordinate_work import CoordinateWork
from flexel.engine.finite import check_finite
from flexel.engine.workspace import Workspace
from flexel.mechanics.actuation import refuse_actuators
from flexel.mechanics.kinematics import Kinematics
from flexel.model.snapshot import Snapshot
from flexel.model.state import Energy, State


def complete(
    kinematics: Kinematics, t: float, x: Array, v: Array, e: Array, z: Array, qdd: Array | None = None
) -> State:
    """Return the complete state at coordinates and rates: accelerations, stresses, reactions, energy.

    Parameters
    ----------
    t : float
        Time [s].
    x, v : ndarray (n,)
    e : ndarray (m,)
        Deformations with their turns.
    z : ndarray (nz,)
        Internal states of laws.
    qdd : ndarray (nd,), optional
        Second rates of the dynamic degrees of freedom, where the motion is driven: stresses of those that are
        deformations, and reactions of those that are coordinates, then hold what drives them.

    Raises
    ------
    ConstraintError
        If the degrees of freedom do not determine the position.
    DynamicsError
        If a degree of freedom has no inertia, or a force of a law is not finite; names it.
    """
    choice = _placed(kinematics, t, x, v, e, z)
    if qdd is not None:
        choice.qdd[:] = qdd
    code = choice.complete(qdd is not None)
    _check_forces(kinematics, choice, t)
    kinematics.check(code, t)
    return state_in(kinematics, choice.work, choice.work.stress.copy(), *choice.reactions())


def driving_forces(
    kinematics: Kinematics, t: float, x: Array, v: Array, e: Array, z: Array, qdd: Array
) -> Array:
    """Return the generalized forces (nd,) on the dynamic degrees of freedom required for accelerations q_d''.

    They are H' (f - h - De' sigma - V' tau - M a) of given forces with the opposite sign of the residual of the
    equations of motion; parameters as in `complete`.
    """
    refuse_actuators(kinematics.structure, kinematics.roles)
    choice = _placed(kinematics, t, x, v, e, z)
    choice.qdd[:] = qdd
    kinematics.check(choice.complete(True), t)
    return choice.multiplier[kinematics.roles.dynamic]


def holding_forces(kinematics: Kinematics, at: Snapshot, z: Array) -> Array | None:
    """Return the forces of constraints by quantity (m + k + n,), or None where they cannot be found.

    Parameters
    ----------
    at : Snapshot
    z : ndarray (nz,)
        Internal states of laws.
    """
    choice = kinematics.given(at.t)
    work = choice.work
    work.struct.t = at.t
    work.x[:], work.v[:], work.unwrap_from[:], work.z[:] = at.x, at.v, at.e, z
    return None if choice.complete(False) else choice.multiplier.copy()


def unaccelerated(kinematics: Kinematics, t: float, x: Array, v: Array, e: Array, z: Array) -> State:
    """Return the state with its given forces, but without accelerations and constraint forces."""
    choice = _placed(kinematics, t, x, v, e, z)
    choice.forces()
    _check_forces(kinematics, choice, t)
    choice.work.a[:] = 0.0
    choice.multiplier[:] = 0.0
    choice.work.convective()
    return state_in(kinematics, choice.work, choice.work.stress.copy(), *choice.reactions())


def _placed(kinematics: Kinematics, t: float, x: Array, v: Array, e: Array, z: Array) -> CoordinateWork:
    choice = kinematics.given(t)
    choice.reset()
    work = choice.work
    work.struct.t = t
    work.x[:], work.v[:], work.unwrap_from[:], work.z[:] = x, v, e, z
    return choice


def _check_forces(kinematics: Kinematics, choice: CoordinateWork, t: float) -> None:
    work = choice.work
    check_finite(kinematics.structure, work.stress, work.zd, t)


def state_in(
    kinematics: Kinematics, work: Workspace, given: Array, stresses: Array, reactions: Array
) -> State:
    """Return the state that a workspace holds: everything evaluated, with its accelerations.

    Parameters
    ----------
    work : Workspace
    given, stresses : ndarray (m + k,)
        Those of laws and loads, and all.
    reactions : ndarray (n,)
    """
    t = float(work.struct.t)
    (x, v, a, e, rates, second, z, zd), (kinetic, potential, strain, dissipated) = work.state()
    if kinematics.loads.any:
        potential += kinematics.loads.potential(t, kinematics.values(e, x))
    return State(
        t=t,
        x=x,
        v=v,
        a=a,
        e=e,
        rates=rates,
        stresses=stresses,
        given=given,
        reactions=reactions,
        roles=kinematics.roles,
        evaluation=kinematics.evaluation,
        energy=Energy(kinetic, potential, strain),
        drift=kinematics.drift(e),
        z=z,
        zd=zd,
        dissipated=dissipated,
        Phi_v=second,
    )
