"""Forward dynamics in minimal coordinates: what all explicit integrations, and the implicit ones of SciPy, share.

Every accepted step is checked for the branch that it is on, and its end for the degrees of freedom: where others are
much better, the motion continues in them from the same x and v.
"""

from __future__ import annotations

import logging
from abc import abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from flexel.base.arrays import Array
from flexel.base.errors import DynamicsError, FlexelError
from flexel.integration.branch import WORSE, Choices
from flexel.integration.driver import DenseRun
from flexel.integration.events import Event
from flexel.integration.outcome import Integration, Segment
from flexel.mechanics.kinematics import Kinematics
from flexel.mechanics.reach import lost, reach
from flexel.structure.moment import Moment
from flexel.structure.state import State

log = logging.getLogger("flexel.simulate")
SHORTEST = 1e-11  # step, relative to the times, below which the integration stops
EXTREME = (
    10.0  # reach of kept degrees of freedom, relative to the best, that counts as the cause of an early end
)
SINGULAR = 1e6  # reach of the best choice above which the position is singular


@dataclass(frozen=True)
class Tolerances:
    """Accuracy and steps of an integration in minimal coordinates.

    Attributes
    ----------
    rtol : float
        Local error relative to y = (q, q_d', z).
    atol : float or ndarray (ny,)
        Local error in the natural scales of y.
    first_step, max_step : float
        Steps [s]; by default the integrator chooses the first.
    """

    rtol: float
    atol: float | Array
    first_step: float | None = None
    max_step: float = np.inf


class MinimalRun(DenseRun):
    """One run in minimal coordinates.

    Parameters
    ----------
    system : Core
    start : State
    times : ndarray
        At which states are kept.
    tolerances : Tolerances
    events : sequence of Event
    rechoose : bool
        Change the degrees of freedom where others are much better.
    """

    def __init__(
        self,
        system: Any,
        start: State,
        times: Array,
        tolerances: Tolerances,
        events: Sequence[Event],
        rechoose: bool,
    ) -> None:
        super().__init__(system, start, times, events)
        self.tolerances = tolerances
        self.largest_atol = float(np.max(tolerances.atol))
        self.choices = Choices(system, system.kinematics_of(start.roles), rechoose)
        self.counts = {"steps": 0, "rejected": 0, "evaluations": 0, "rechoices": 0, "bifurcations": 0}
        self.reached = 1.0

    @property
    def statistics(self) -> dict[str, int]:
        """Counts of what was done."""
        return dict(self.counts)

    @property
    def kinematics(self) -> Kinematics:
        """The present degrees of freedom."""
        return self.choices.kinematics

    def begin(self) -> None:
        """Change to better degrees of freedom at the start if the given ones are poor there."""
        self.reached = self.choices.reach(self.now)
        self.consider(WORSE)
        self.restart()

    @abstractmethod
    def restart(self) -> None:
        """Restart from the present position in the present degrees of freedom."""

    def strike(self) -> None:
        """Continue from here with the rates just after an impulse."""
        super().strike()
        self.restart()

    def natural_atol(self) -> Array:
        """Absolute tolerances of y."""
        return np.asarray(self.tolerances.atol * natural_scales_of_y(self.kinematics))

    def consider(self, factor: float) -> bool:
        """Change to the best degrees of freedom if the present ones are worse by a factor; whether they changed.

        Raises
        ------
        DynamicsError
            If they may not change, and are no longer usable; names them.
        """
        choices = self.choices
        if self.reached <= factor * choices.share * max(1.0, min(choices.best, SINGULAR)):
            return False  # the reach of any choice is about one or more
        other = choices.worse(self.now, self.reached, factor)
        if other is None:
            return False
        if not choices.free:
            if self.reached > lost(self.kinematics.roles) * choices.best:
                raise self.lost()
            return False  # shorter steps may still succeed
        before = choices.names
        choices.change(other, self.t)
        log.info("t = %.9g s: degrees of freedom %s instead of %s", self.t, choices.names, before)
        self.counts["rechoices"] += 1
        self.reached = choices.best
        return True

    def lost(self) -> DynamicsError:
        """The error of degrees of freedom that can no longer describe the motion and may not change."""
        return DynamicsError(
            f"the degrees of freedom {self.kinematics.names(self.kinematics.roles.dofs)} cannot describe the "
            f"motion beyond "
            f"t = {self.t:g} s (the coordinates change {self.reached:.2g} times as much as they do, "
            f"{self.choices.best:.2g} "
            "with the best choice): one of them has reached its extreme; leave rechoose=False out, or name others with "
            "system.use_coordinates"
        )

    def shown(self) -> Kinematics:
        """The degrees of freedom in which states are given: the user's, where these are usable."""
        choices = self.choices
        if choices.kinematics is choices.own:
            return choices.own
        own = reach(choices.own, self.now)
        return choices.own if own <= lost(choices.own.roles) * max(self.reached, 1.0) else choices.kinematics

    def end_step(self, t0: float, dense: Any, first: Moment, z: Array, last: Moment) -> str | None:
        """Store an accepted step, and consider other degrees of freedom at its end."""
        segment = Segment(t0, last.t, self.kinematics, self._shown, dense, first, last)
        self.counts["steps"] += 1
        ended = self.accept(segment, z)
        if ended is None and self.consider(WORSE):
            self.restart()
        if self.choices.changes:
            self._shown = self.shown()
        return ended

    def trouble(self, why: str) -> str:
        """What may be wrong where the integration cannot continue."""
        names, roles = self.kinematics.names, self.kinematics.roles
        driven = f", check what drives {names(roles.prescribed)}" if roles.prescribed.size else ""
        self.choices.worse(self.now, np.inf, 1.0)
        if self.choices.best > SINGULAR:
            return (
                f"the position is singular there (gimbal lock of frames without inertia, or parts that line "
                f"up): {why}give "
                f"those frames inertia{driven}, or end the motion before {self.t:g} s"
            )
        return (
            f"degrees of freedom {names(roles.dynamic)}: the motion is not smooth there; {why}check its loads and "
            f"laws{driven}, or end it before {self.t:g} s"
        )

    def gives_up(self, error: FlexelError) -> FlexelError:
        """The error of a motion whose steps have become too short: that of kept coordinates, if others would work."""
        self.reached = self.choices.reach(self.now)
        if not self.choices.free and self.choices.worse(self.now, self.reached, EXTREME) is not None:
            error = self.lost()
        return self.noted(error)

    def noted(self, error: FlexelError) -> FlexelError:
        """The error, with the time up to which the motion was computed."""
        error.add_note(f"the motion was computed up to t = {self.t:g} s")
        return error

    def kept(self, message: str) -> Integration:
        """The results so far, with the changes of the degrees of freedom."""
        return replace(super().kept(message), rechoices=self.choices.changes)


def natural_scales_of_y(kinematics: Kinematics) -> Array:
    """Natural scales of y = (q, q_d', z): those of rates are per second, those of internal states of laws one."""
    roles, scales = kinematics.roles, kinematics.scales
    return np.concatenate([scales(roles.dofs), scales(roles.dynamic), np.ones(kinematics.structure.nz)])
