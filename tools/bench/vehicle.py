"""Times the road vehicle: ramp-to-step steering, linearization, model build."""

from __future__ import annotations

import numpy as np

from bench.timing import Work
from flexel.examples import vehicle_runs as runs
from flexel.examples.differences import state_matrix
from flexel.examples.vehicle import vehicle
from flexel.examples.vehicle_signals import yaw_rate
from flexel.results.linearization import Linearization

SPEED = 30.0  # of the steering manoeuvre [m/s]
YAW_RATE = -0.084853807401929  # after 5 s, by DOP853 at rtol 1e-11 [rad/s]


def build() -> Work:
    """Time the declaration and build of the model, with compiled kernels."""
    return Work(lambda: vehicle(SPEED, rack=runs.rounded_ramp()))


def ramp() -> Work:
    """Time the motion of `vehicle_runs.steer` at 30 m/s, 5 s with 126 stored states, from a given state."""
    system = vehicle(SPEED, rack=runs.rounded_ramp())
    start = runs.start(system, SPEED)
    return Work(
        lambda: runs.ride(system, start, 5.0, samples=126),
        lambda motion: abs(yaw_rate(motion[-1]) / YAW_RATE - 1),
    )


def linearization() -> Work:
    """Time `System.linearize` of the vehicle running straight at 20 m/s."""
    system, state = runs.straight(20.0)

    def error(found: Linearization) -> float:
        expected = state_matrix(system, state)
        return float(np.abs(found.state_matrix - expected).max() / np.abs(expected).max())

    return Work(lambda: system.linearize(state), error)
