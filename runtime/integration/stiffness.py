"""How stiff a system is for an explicit integrator: at its start, and during a motion that turns out to be long."""

from __future__ import annotations

import warnings
from dataclasses import dataclass, field

import numpy as np

from flexel.base.arrays import Array
from flexel.base.callers import outside
from flexel.base.errors import FlexelError, StiffWarning
from flexel.engine.solvers import eigenvalues
from flexel.integration.driver import Run
from flexel.integration.excitation import followed
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
LOOK = 1000  # steps after which an explicit integration is looked at: short motions cost nothing more
LONG = 5 * LOOK  # steps of a motion that is called long


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
    if turns <= SPREAD * turned:
        return False, f"{fastest}, and excited modes turn through {turned:.2g} rad, not {SPREAD:g} times less"
    return True, f"{fastest}, above {most:.3g}"


class Watch:
    """Looks at a motion by DOP853 after some steps, and warns if the rest will be long because of stiffness.

    Parameters
    ----------
    system : CoreSystem

    Attributes
    ----------
    found : str
        The finding; empty before the check, and for motions that are not stiff or not long.
    """

    def __init__(self, system: CoreSystem) -> None:
        self.system = system
        self.found = ""
        self._steps, self._half = 0, 0.0

    def __call__(self, run: Run) -> None:
        """Count a step."""
        self._steps += 1
        if self._steps == LOOK // 2:
            self._half = run.t
        elif self._steps == LOOK:
            self._look(run)

    def _look(self, run: Run) -> None:
        """Estimate the steps of the whole motion from the last ones, and find what makes them short."""
        end, step = float(run.times[-1]), 2 * (run.t - self._half) / LOOK
        count = LOOK + (end - run.t) / step
        if count < LONG:
            return
        demands = suitable(self.system, run.present)
        fastest = float(demands.rates.max(initial=0.0))
        slowest = float(demands.rates[demands.rates > RIGID * fastest].min(initial=np.inf))
        if fastest * (end - float(run.times[0])) > STIFF and fastest > SPREAD * slowest:
            why = f"its largest eigenvalue is {fastest:.2g} 1/s in magnitude at t = {run.t:.3g} s"
        elif demands.method == ALPHA or demands.is_large:
            why = demands.why
        else:
            return  # accuracy asks for these steps
        self.found = f"{EXPLICIT} takes about {count:.2g} steps: {why}"
        other = RADAU if few(self.system) else ALPHA
        warnings.warn(
            f"simulate: {self.found}; an interrupt keeps what was computed, use method='{other}'",
            StiffWarning,
            stacklevel=outside(),
        )
