"""The nonlinear periodic motion of a system."""

from __future__ import annotations

import warnings

import numpy as np

from flexel.base.arguments import positive, whole
from flexel.base.arrays import ComplexArray
from flexel.base.blas import in_one_thread
from flexel.base.callers import outside
from flexel.base.errors import IncompleteWarning, ModelError
from flexel.integration.outcome import Integration, States
from flexel.linear.continuation import branch
from flexel.linear.harmonics import PeriodicVibration
from flexel.linear.periodic import periodic_motion
from flexel.mechanics.drive_periods import check_drives
from flexel.model.state import State
from flexel.results.motion import Motion
from flexel.results.periodic_branch import PeriodicBranch
from flexel.results.periodic_motion import PeriodicSolution
from flexel.system import CoreSystem


@in_one_thread
def periodic(
    system: CoreSystem,
    start: PeriodicSolution | None = None,
    *,
    period: float,
    harmonics: int,
    samples: int | None = None,
    accuracy: float | None = None,
) -> PeriodicSolution:
    """Find the nonlinear periodic motion under periodic prescribed motions and loads, by harmonic balance.

    Parameters
    ----------
    start : PeriodicSolution, optional
        A neighbouring solution with as many harmonics to start from; the linearized one by default.
    period : float
        [s]
    harmonics : int
        Number of harmonics of the Fourier series.
    samples : int, optional
        Times in the period; 4 per harmonic and 4 more by default.
    accuracy : float, optional
        Largest permitted amplitude of the neglected harmonics, relative to the largest amplitude.

    Raises
    ------
    ModelError, PositionError, LinearizationError
        A period or a number of harmonics that is not positive; a load or a prescribed motion without that period; or as
        `flexel.linear.periodic.periodic_motion`.
    """
    period = positive(period, "periodic", "period")
    harmonics = whole(harmonics, "periodic", "harmonics", most=10**4)
    if samples is not None:
        samples = whole(samples, "periodic", "samples", most=10**6)
    if accuracy is not None:
        accuracy = positive(accuracy, "periodic", "accuracy")
    check_drives(system.kinematics, system.at_rest.t, period)
    X = None if start is None else _coefficients(start, harmonics, len(system.dynamic))
    orbit, vibration = periodic_motion(system, period, harmonics, X, samples, accuracy)
    return _solution(system, orbit.states, vibration)


@in_one_thread
def periodic_branch(
    system: CoreSystem,
    start: PeriodicSolution | None = None,
    *,
    period: float,
    end: float,
    harmonics: int,
    step: float = 0.2,
    most: int = 500,
    samples: int | None = None,
) -> PeriodicBranch:
    """Follow periodic motions as prescribed motions and loads become faster or slower, by arc length.

    The branch is followed past folds, through stable and unstable motions, until its period is `end` or again
    `period`.  Folds, and maxima of the largest Floquet multiplier, are located between the motions.

    Parameters
    ----------
    start : PeriodicSolution, optional
        A solution with this period and as many harmonics to start from; as for `periodic` by default.
    period : float
        Period of prescribed motions and loads [s], at which the branch starts.
    end : float
        Another period [s], at which the system runs period / end times as fast.
    harmonics : int
        Number of harmonics of the Fourier series.
    step : float
        Largest change from motion to motion: of the degrees of freedom, relative to their amplitudes (root mean
        square), together with five times the relative change of the speed.
    most : int
        Largest number of steps.
    samples : int, optional
        Times in the period; 4 per harmonic and 4 more by default.

    Raises
    ------
    ModelError, PositionError, LinearizationError
        As `periodic`; equal periods; a law that depends on time itself.

    Warns
    -----
    IncompleteWarning
        If the branch cannot be continued: what was found is returned, and ``message`` says where and why it
        stopped.
    """
    most = whole(most, "periodic_branch", "most")
    period = positive(period, "periodic_branch", "period")
    last, step = positive(end, "periodic_branch", "end"), positive(step, "periodic_branch", "step")
    if last == period:
        raise ModelError(f"periodic_branch: both periods are {last:g} s; give another end")
    first = periodic(system, start, period=period, harmonics=harmonics, samples=samples)
    X, ns = first.vibration.X, first.vibration.coefficients.samples
    stations, message = branch(system, period, last, X, ns, step, most)
    if message:
        warnings.warn(message, IncompleteWarning, stacklevel=outside())
    found = [station.point.equations for station in stations]
    solutions = [_solution(equations.system, equations.states, equations.vibration) for equations in found]
    return PeriodicBranch(
        solutions,
        np.array([station.multipliers for station in stations]),
        [station.kind for station in stations],
        message,
    )


def _coefficients(start: object, harmonics: int, dofs: int) -> ComplexArray:
    """Return the Fourier coefficients of a neighbouring solution."""
    if not isinstance(start, PeriodicSolution):
        raise ModelError(
            f"periodic: start {type(start).__name__} is not a periodic solution; give one, or none"
        )
    X = start.vibration.X
    if X.shape != (2 * harmonics + 1, dofs):
        raise ModelError(
            f"periodic: start has {start.vibration.harmonics} harmonics of {X.shape[1]} degrees of freedom; give "
            f"one with {harmonics} of {dofs}"
        )
    return X


def _solution(system: CoreSystem, states: list[State], vibration: PeriodicVibration) -> PeriodicSolution:
    """Return the result for one period."""
    counts = {"samples": len(states), "harmonics": vibration.harmonics}
    return PeriodicSolution(
        Motion(system, Integration(States(states), [], [], counts, "periodic")), vibration
    )
