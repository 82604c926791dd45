"""Linearized equations along a motion of a system."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from flexel.base.arguments import array, positive
from flexel.base.arrays import Array
from flexel.base.blas import in_one_thread
from flexel.base.errors import ModelError
from flexel.integration.trajectory import Trajectory
from flexel.linear import course
from flexel.model.controller import refuse_sampled
from flexel.model.state import State
from flexel.results.periodic_motion import PeriodicSolution
from flexel.results.time_varying import TimeVarying
from flexel.system import CoreSystem


@in_one_thread
def along(
    system: CoreSystem,
    motion: Trajectory | PeriodicSolution | State | None = None,
    *,
    times: Sequence[float] | Array | None = None,
    period: float | None = None,
) -> TimeVarying:
    """Linearize along a motion: a linear system whose matrices vary in time.

    The matrices describe small differences from the motion, between events.  Velocities that jump at an impact are
    not covered.

    Parameters
    ----------
    motion : Motion, PeriodicSolution or State, optional
        A simulated motion; a periodic one; or a state, about which the equations are constant.  Without it the
        degrees of freedom keep their initial values while prescribed motions continue: the nominal motion of a
        mechanism with small vibrations, which leaves forces F.
    times : array_like (ns,), optional
        Times of this nominal motion [s].
    period : float, optional
        Period of the motion [s], for Floquet multipliers and periodic vibrations.  The motion must last as long.

    Raises
    ------
    ModelError
        Neither a motion nor times, or both; a motion of another system.
    LinearizationError
        A motion that is shorter than its period; degrees of freedom that cannot be held.
    ConstraintError
        Coordinates that do not determine the position somewhere along the motion.

    Examples
    --------
    >>> ltv = system.along(system.simulate(2.0))  # doctest: +SKIP
    >>> ltv.at(0.3).K, ltv.state_matrices.shape  # doctest: +SKIP
    """
    refuse_sampled(system.structure.controllers, "along", "only linearize(…).sampled() closes its loop")
    length = None if period is None else positive(period, "along", "period")
    if motion is None:
        return TimeVarying(system, course.held(system, _grid(times, length), length))
    if times is not None:
        raise ModelError("along: a motion has its own times; leave out times, or the motion")
    if isinstance(motion, PeriodicSolution):
        return TimeVarying(system, course.of_vibration(system, motion.vibration, motion.t))
    if isinstance(motion, State):
        return TimeVarying(system, course.at_state(system, motion, length))
    if not isinstance(motion, Trajectory):
        raise ModelError(
            f"along: {type(motion).__name__} is not a motion; give a motion, a periodic solution or a state"
        )
    return TimeVarying(system, course.of_motion(system, motion, length))


def _grid(times: Sequence[float] | Array | None, period: float | None) -> Array:
    """Return the times of a nominal motion, checked; within one period if there is one."""
    if times is None:
        raise ModelError("along: give a motion, a state, or the times of the nominal motion")
    grid = array(times, "along", "times")
    if grid.ndim != 1 or grid.size < 2 or np.any(np.diff(grid) <= 0):
        raise ModelError("along: times must be an increasing list of at least two; sort them")
    if period is None:
        return grid
    return np.asarray(grid[grid < grid[0] + period * (1 - course.OUTSIDE)])
