"""Signals of a motion of the road vehicle: angles, accelerations, tyre loads, exceeded ranges.

Rotations are reported in the benchmark's order (pitch, roll, yaw from the road, so that they mix when the vehicle has
turned) and accelerations along its yawed axes.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np

import flexel as fx
from flexel.base.arrays import Array
from flexel.base.quaternions import matrix
from flexel.examples import vehicle_data as data


def angles(state: fx.State) -> tuple[float, float, float]:
    """Return pitch, roll and yaw [rad] of the chassis in the benchmark's order, R = Ry Rx Rz."""
    R = matrix(state.position("body"))
    pitch = float(np.arctan2(R[0, 2], R[2, 2]))
    return pitch, float(-np.arcsin(R[1, 2])), float(np.arctan2(R[1, 0], R[1, 1]))


def yaw_rate(state: fx.State) -> float:
    """Return the rate of the benchmark's yaw angle [rad/s]."""
    R = matrix(state.position("body"))
    omega = np.array([state.rate(f"body.omega.{component}") for component in ("wx", "wy", "wz")])
    c, s = R[1, 1], R[1, 0]
    cd, sd = np.cross(omega, R[:, 1])[1], np.cross(omega, R[:, 0])[1]
    return float((c * sd - s * cd) / (c * c + s * s))


def lateral_acceleration(state: fx.State) -> float:
    """Return the acceleration of the chassis' mass centre along the vehicle's yawed y axis [m/s²]."""
    yaw = angles(state)[2]
    return float(
        np.cos(yaw) * state.acceleration("chassis.y") - np.sin(yaw) * state.acceleration("chassis.x")
    )


def side_slip(state: fx.State) -> float:
    """Return the angle between the velocity of the mass centre and the vehicle's heading [rad]."""
    vx, vy, _ = state.velocity("chassis")
    return float(np.arctan2(vy, vx) - angles(state)[2])


def loads(state: fx.State) -> tuple[float, ...]:
    """Return the forces of the springs of the four tyres [N], in the order of `data.CORNERS`."""
    return tuple(
        sum(state.force(f"{corner} tyre.{mode}") for mode in ("drop", "deflection"))
        for corner in data.CORNERS
    )


SIGNALS: Mapping[str, Callable[[fx.State], float]] = {
    "yaw_rate": yaw_rate,
    "lateral_acceleration": lateral_acceleration,
    "roll": lambda state: float(np.degrees(angles(state)[1])),
    "side_slip": lambda state: float(np.degrees(side_slip(state))),
    "pitch": lambda state: float(np.degrees(angles(state)[0])),
    "yaw": lambda state: float(np.degrees(angles(state)[2])),
    "z": lambda state: state["chassis.z"] - data.HEIGHT,
    "speed": lambda state: float(np.hypot(*state.velocity("chassis")[:2])),
}


def history(motion: fx.Motion, signal: str) -> Array:
    """Return one of `SIGNALS` over the motion (nt,)."""
    return np.array([SIGNALS[signal](state) for state in motion])


def load_histories(motion: fx.Motion) -> Array:
    """Return the vertical forces of the tyres (nt, 4)."""
    return np.array([loads(state) for state in motion])


def lifted(motion: fx.Motion) -> list[str]:
    """List wheels that leave the road at a stored time."""
    least = load_histories(motion).min(axis=0)
    return [corner for corner, load in zip(data.CORNERS, least, strict=True) if load <= 0]


def at_stop(motion: fx.Motion) -> list[str]:
    """List leaf springs that are at their stops at a stored time."""
    travel = data.LEAF_LENGTH - data.LEAF_STOP
    return [corner for corner in data.CORNERS if motion[f"{corner} leaf.across2"].max() > travel]
