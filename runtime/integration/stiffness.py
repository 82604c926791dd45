"""How stiff a system is for an explicit integrator at a state."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from flexel.base.arrays import Array
from flexel.base.errors import FlexelError
from flexel.engine.solvers import eigenvalues
from flexel.integration.excitation import followed, knots
from flexel.integration.radau_saddle import sparse
from flexel.mechanics.inertia import InertiaError
from flexel.model.state import State
from flexel.system import CoreSystem

EXPLICIT, RADAU, ALPHA = "DOP853", "Radau", "generalized-alpha"
STIFF = 3e4  # max |λ| times the duration from which a motion is integrated implicitly
SMALL = 30  # degrees of freedom above which a step of an explicit method costs more than one of an implicit method
SPREAD = 100.0  # ratio of max |λ| to the rates that the motion follows from which it is integrated implicitly
LARGE = 300  # degrees of freedom above which no eigenvalues are taken: the trials of the methods decide alone
MANY = 1000  # degrees of freedom above which a motion is integrated by generalized-alpha
RIGID = 1e-6  # relative to the largest eigenvalue: below it nothing resists the motion


@dataclass(frozen=True)
class Suitable:
    """Demands of a system on an integrator at a state.

    Attributes
    ----------
    method : str
        The one that suits motions of any length; empty where it depends on the length.
    why, detail : str
        Why, and the message of the error that shows it.
    rates : ndarray
        Magnitudes of the eigenvalues [1/s] of the linearized state, if it was linearized.
    matrix : ndarray
        Its state matrix.
    inertia : ndarray (nd,)
        Inertia of each dynamic degree of freedom in its natural scale [kg m²], if it was linearized.
    is_large : bool
        Whether it was not linearized because it has many degrees of freedom.
    """

    method: str
    why: str = ""
    detail: str = ""
    rates: Array = field(default_factory=lambda: np.zeros(0))
    matrix: Array = field(default_factory=lambda: np.zeros((0, 0)))
    inertia: Array = field(default_factory=lambda: np.zeros(0))
    is_large: bool = False


def suitable(system: CoreSystem, state: State) -> Suitable:
    """Find the demands of a system on an integrator at a state; eigenvalues of very large systems are not computed."""
    nd = system.roles.nd
    if nd > MANY or (nd > LARGE and not few(system)):
        return Suitable(ALPHA, f"{nd} degrees of freedom, above {MANY if nd > MANY else LARGE}")
    if nd > LARGE:
        return Suitable("", f"{nd} degrees of freedom, above {LARGE}", is_large=True)
    try:
        lin = system._linearization(state)
        inertia = np.diag(lin.M) * system.kinematics.scales(system.roles.dynamic) ** 2
        matrix = lin.state_matrix
        return Suitable("", rates=np.abs(eigenvalues(matrix)), matrix=matrix, inertia=inertia)
    except InertiaError as error:
        return Suitable(ALPHA, "a degree of freedom has no inertia", str(error))
    except (FlexelError, np.linalg.LinAlgError) as error:
        return Suitable(EXPLICIT, "the start cannot be linearized", str(error))


def few(system: CoreSystem) -> bool:
    """Whether Radau may suit: large matrices must be sparse."""
    nd = system.roles.nd
    return nd <= min(LARGE, MANY) or (nd <= MANY and sparse(system.kinematics))


def smooth(system: CoreSystem) -> bool:
    """Whether Radau may suit motions that are not stiff too: contacts would end smooth motions again and again."""
    return few(system) and "gap" not in system.structure.kinds


def limit(system: CoreSystem) -> float:
    """Return max |λ| times the duration from which a motion is implicitly integrated if no fast modes are excited."""
    return STIFF / max(1.0, system.roles.nd / SMALL)


def stiff(system: CoreSystem, state: State, found: Suitable, duration: float) -> tuple[bool, str]:
    """Whether a motion from a state that was linearized is stiff, and why or why not."""
    turns, most = float(found.rates.max(initial=0.0)) * duration, limit(system)
    fastest = f"max|eigenvalue|*duration = {turns:.2g} at t = {state.t:.3g} s"
    if turns <= most:
        return False, f"{fastest}, at most {most:.3g}"
    turned = followed(system, state, found.matrix, duration)
    turned = max(turned, knots(system, state.t, state.t + duration))  # each counts as a radian
    if turns <= SPREAD * turned:
        return False, f"{fastest}, and excited modes turn through {turned:.2g} rad, not {SPREAD:g} times less"
    return True, f"{fastest}, above {most:.3g}"
