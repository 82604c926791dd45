"""What a method in minimal coordinates is: it takes steps of a motion, which decides what they are for.

The motion owns time, degrees of freedom and results, see minimal.py; a method owns one step.
"""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import ClassVar, NamedTuple, Protocol
from weakref import proxy

import numpy as np

from flexel.base.arrays import Array
from flexel.base.errors import FlexelError
from flexel.engine.coordinate_work import CoordinateWork
from flexel.engine.covered import Covered
from flexel.engine.step_control import StepControl
from flexel.engine.workspace import Workspace
from flexel.integration.account import Account, Quadrature
from flexel.integration.attempts import Attempts
from flexel.integration.branch import Choices
from flexel.integration.dips import Dips
from flexel.integration.knots import Knots
from flexel.integration.segments import DenseOutput
from flexel.integration.touching import TouchingContacts
from flexel.mechanics.kinematics import Kinematics
from flexel.model.snapshot import Snapshot
from flexel.model.structure import Structure

MINOR = 1e-4  # of the largest degrees of freedom and rates: what is smaller does not determine steps
RESOLUTION = 5e-16  # error of coordinates, relative to their size or natural scale, that shortens no step


@dataclass(frozen=True)
class Tolerances:
    """Accuracy and steps of an integration in minimal coordinates.

    Attributes
    ----------
    rtol : float
        Local error relative to y = (q, q_d', z).
    atol : float or ndarray (ny,)
        Local error in the natural scales of y.
    relative : bool
        Whether both are relative to the size of the motion, where that is less than the machine's.
    first_step, max_step : float
        Steps [s]; by default the integrator chooses the first.
    minor : float
        Of Radau: degrees of freedom and rates, relative to the largest ones in natural scales, that count as zero.
    """

    rtol: float
    atol: float | Array
    first_step: float | None = None
    max_step: float = np.inf
    relative: bool = False
    minor: float = MINOR

    @cached_property
    def largest_atol(self) -> float:
        """The largest local error in natural scales."""
        return float(np.max(self.atol))


def natural_scales_of_y(kinematics: Kinematics) -> Array:
    """Return natural scales of y = (q, q_d', z): those of rates are per second, those of internal states one."""
    roles, scales = kinematics.roles, kinematics.scales
    return np.concatenate([scales(roles.dofs), scales(roles.dynamic), np.ones(kinematics.structure.nz)])


class Found(NamedTuple):
    """A step that was found.

    Attributes
    ----------
    dense : DenseOutput
        Of the step.
    z : ndarray (nz,)
        Internal states at its end.
    """

    dense: DenseOutput
    z: Array


class InRow(NamedTuple):
    """A step of a row.

    Attributes
    ----------
    dense : DenseOutput
    z : ndarray (nz,)
        Internal states at its end.
    amplification : float
        Of the degrees of freedom there.
    balance : bytes
        The energy balance there, see account.h.
    recall : callable(), optional
        To be called before states within it are stored, if they are.
    """

    dense: DenseOutput
    z: Array
    amplification: float
    balance: bytes
    recall: Callable[[], None] | None


class SteppedMotion(Protocol):
    """A motion in minimal coordinates, as its method sees it.

    Attributes
    ----------
    now : Snapshot
        The point from which the next step begins.
    z : ndarray (nz,)
        Internal states there.
    choices : Choices
        The degrees of freedom.
    amplification : float
        Theirs, when last determined.
    counts : dict of str to int
        Steps that were refused, evaluations and bifurcations, counted by the method too.
    times : ndarray
        At which states are stored.
    """

    now: Snapshot
    z: Array
    choices: Choices
    amplification: float
    knots: Knots
    covered: Covered
    account: Account
    tolerances: Tolerances
    counts: dict[str, int]
    times: Array
    touching: TouchingContacts
    dips: Dips

    @property
    def t(self) -> float:
        """Current time of the motion."""
        ...

    @property
    def kinematics(self) -> Kinematics:
        """The present degrees of freedom."""
        ...

    @property
    def resolution(self) -> float:
        """Length [s] of the shortest step that changes the time by what is asked for."""
        ...

    @property
    def stop(self) -> float:
        """When the next step ends at the latest: at the end, a knot, or an instant of a sampled controller."""
        ...

    @property
    def dense_at_once(self) -> bool:
        """Whether states within a step are asked for before the next one is taken, whatever is stored."""
        ...

    @property
    def until(self) -> float:
        """The next time at which a state is stored."""
        ...

    @property
    def stored(self) -> int:
        """How many states are stored."""
        ...

    @property
    def least(self) -> float:
        """Length [s] below which a step is too short, wherever it is."""
        ...

    def take(self) -> None:
        """Take the present instant into what the motion has covered."""

    def natural_atol(self) -> Array:
        """Return the absolute tolerances of y."""
        ...

    def poor(self) -> bool:
        """Whether other degrees of freedom are so much better that they may explain a change of sign."""
        ...

    def trouble(self, why: str) -> str:
        """Explain what may be wrong where the integration cannot continue."""
        ...

    def noted(self, error: FlexelError) -> FlexelError:
        """Return the error, with the time up to which the motion was computed."""
        ...


class StepMethod(Attempts):
    """Steps of a motion.

    Parameters
    ----------
    course : SteppedMotion
        The motion.
    """

    name: ClassVar[str]
    quadrature: ClassVar[Quadrature]
    control: ClassVar[StepControl]
    rows = False  # whether it takes steps in a row
    unusual = False  # whether the last row has come to a step that is to be taken alone
    tried = False  # whether the workspace holds a trial of the next step, that was made at the end of a row
    flat = -np.inf  # time [s] of a flat position at which steps were refused

    def __init__(self, course: SteppedMotion) -> None:
        self.course: SteppedMotion = proxy(course)  # no cycle: the arrays of a motion are freed with it

    @classmethod
    @abstractmethod
    def scale(cls, structure: Structure, weight: Array, given: Tolerances) -> Covered:
        """Return what a motion covers, as the scale of its tolerances.

        Parameters
        ----------
        structure : Structure
        weight : ndarray (nf,)
            One over natural scales of the free coordinates.
        given : Tolerances
        """

    @abstractmethod
    def reuse(self, other: StepMethod) -> None:
        """Use the arrays of another motion, which has ended and had the same tolerances, if that helps."""

    @property
    @abstractmethod
    def placed(self) -> CoordinateWork:
        """The arrays that hold the position at the end of the step that was found last."""

    @property
    def work(self) -> Workspace:
        """The workspace that holds the end of the step that was found last."""
        return self.placed.work

    @abstractmethod
    def restart(self) -> None:
        """Restart from the present position in the present degrees of freedom."""

    @abstractmethod
    def restart_with(self, h: float) -> None:
        """Restart beyond a flat position with a step [s] to try first."""

    def renew(self) -> None:
        """Compute the rates with the changed loads."""
        self.restart()

    def jump(self) -> None:
        """Continue from the present position, where internal states have jumped."""
        self.restart()

    def row(self, most: int, allowed: float) -> Sequence[InRow]:
        """Take some steps in a row without a look at each of them; none where the method does not, or cannot here.

        Parameters
        ----------
        most : int
            At most so many.
        allowed : float
            Amplification of the degrees of freedom beyond which others may be better: steps end there.
        """
        return ()

    def forget_trial(self) -> None:
        """The workspace no longer holds the trial that a row has made: it is to be made again."""
        self.tried = False

    @abstractmethod
    def accept(self, last: Snapshot, kink: bool) -> Found:
        """Continue from the end of the step that was found, a point, where forces may change their law."""

    @abstractmethod
    def stopped(self) -> FlexelError:
        """Return the error of steps that have become too short."""
