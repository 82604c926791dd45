"""Numerical Euler parameters and triads for the declaration of models.

Quaternions are arrays (4,) with the scalar first, lambda = (lambda0, lambda1, lambda2, lambda3).
The symbolic counterpart, used to derive the kernels, is `flexel.derive.declare.rotation`.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from flexel.base.arguments import number, vector
from flexel.base.arrays import Array
from flexel.base.errors import ModelError


def product(p: Array, q: Array) -> Array:
    """Multiply quaternions, p o q: rotate by q first, then by p."""
    p0, p1, p2, p3 = p
    q0, q1, q2, q3 = q
    return np.array(
        [
            p0 * q0 - p1 * q1 - p2 * q2 - p3 * q3,
            p0 * q1 + p1 * q0 + p2 * q3 - p3 * q2,
            p0 * q2 - p1 * q3 + p2 * q0 + p3 * q1,
            p0 * q3 + p1 * q2 - p2 * q1 + p3 * q0,
        ]
    )


def conjugate(p: Array) -> Array:
    """Invert a unit quaternion."""
    return np.array([p[0], -p[1], -p[2], -p[3]])


def matrix(q: Array) -> Array:
    """Return the rotation matrix (3, 3) of a unit quaternion; its columns are the rotated axes."""
    q0, q1, q2, q3 = q
    return np.array(
        [
            [q0 * q0 + q1 * q1 - q2 * q2 - q3 * q3, 2 * (q1 * q2 - q0 * q3), 2 * (q1 * q3 + q0 * q2)],
            [2 * (q1 * q2 + q0 * q3), q0 * q0 - q1 * q1 + q2 * q2 - q3 * q3, 2 * (q2 * q3 - q0 * q1)],
            [2 * (q1 * q3 - q0 * q2), 2 * (q2 * q3 + q0 * q1), q0 * q0 - q1 * q1 - q2 * q2 + q3 * q3],
        ]
    )


def rotation_rows(q: Array) -> Array:
    """Return W (3, 4) of omega = W lambda', the angular velocity in global axes."""
    return 2 * np.array([[-q[1], q[0], -q[3], q[2]], [-q[2], q[3], q[0], -q[1]], [-q[3], -q[2], q[1], q[0]]])


def from_matrix(R: Array) -> Array:
    """Return the unit quaternion (4,) of a rotation matrix, by its largest component (Shepperd 1978)."""
    d = np.array([np.trace(R), R[0, 0], R[1, 1], R[2, 2]])
    k = int(np.argmax(d))
    if k == 0:
        q = np.array([1 + d[0], R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]])
    elif k == 1:
        q = np.array([R[2, 1] - R[1, 2], 1 + 2 * d[1] - d[0], R[0, 1] + R[1, 0], R[0, 2] + R[2, 0]])
    elif k == 2:
        q = np.array([R[0, 2] - R[2, 0], R[0, 1] + R[1, 0], 1 + 2 * d[2] - d[0], R[1, 2] + R[2, 1]])
    else:
        q = np.array([R[1, 0] - R[0, 1], R[0, 2] + R[2, 0], R[1, 2] + R[2, 1], 1 + 2 * d[3] - d[0]])
    return np.asarray(q / np.linalg.norm(q))


def turn(axis: Any, angle: float) -> Array:
    """Return the unit quaternion of a rotation by `angle` [rad] about `axis` (3,), for `Model.frame(orientation=…)`."""
    u, angle = unit(axis, "turn", "axis"), number(angle, "turn", "angle")
    return np.concatenate([[np.cos(angle / 2)], np.sin(angle / 2) * u])


def unit(direction: Any, owner: str, what: str, size: int = 3) -> Array:
    """Normalize a copy of a direction.

    Raises
    ------
    ModelError
        If it does not have `size` finite components or has no length; `owner` and `what` name it.
    """
    d = vector(direction, owner, what, size)
    length = np.linalg.norm(d)
    if length < 1e-12:
        raise ModelError(f"{owner}: {what} {d.tolist()} has no length; give a direction")
    return np.asarray(d / length)


def triad(e_x: Array, hint: Any | None, owner: str) -> Array:
    """Return the unit quaternion of a triad whose x-axis is `e_x` and whose y-axis is nearest to `hint`.

    Without a hint, the global axis farthest from `e_x` is used.
    """
    if hint is None:
        h = np.zeros(3)
        h[int(np.argmin(np.abs(e_x)))] = 1.0
    else:
        h = unit(hint, owner, "direction")
    e_y = h - (h @ e_x) * e_x
    length = np.linalg.norm(e_y)
    if length < 1e-8:
        raise ModelError(f"{owner}: direction {h.tolist()} is parallel to the axis; give another direction")
    e_y /= length
    return from_matrix(np.column_stack([e_x, e_y, np.cross(e_x, e_y)]))


def in_frame(frame: Array, triad: Array) -> Array:
    """Express a triad given in global axes in a body frame."""
    return product(conjugate(frame), triad)


def in_body(orientation: Array, d: Array) -> Array:
    """Transform a vector d into the axes of a body: d (3,) with a quaternion (4,), or d (2,) with an angle (1,)."""
    if d.size == 3:
        return np.asarray(matrix(orientation).T @ d)
    c, s = np.cos(orientation[0]), np.sin(orientation[0])
    return np.array([c * d[0] + s * d[1], c * d[1] - s * d[0]])


def euler_angles(q: Array) -> Array:
    """Return the angles (3,) [rad] of successive turns about z, the new y and the new x axis that make a rotation.

    At a quarter turn about y the other two turns are about the same axis; their sum is then returned as that about z.
    """
    R = matrix(q)
    level = float(np.hypot(R[0, 0], R[1, 0]))
    y = np.arctan2(-R[2, 0], level)
    if level < 1e-12:
        return np.array([np.arctan2(-R[0, 1], R[1, 1]), y, 0.0])
    return np.array([np.arctan2(R[1, 0], R[0, 0]), y, np.arctan2(R[2, 1], R[2, 2])])


def axis_angle(q: Array) -> tuple[Array, float]:
    """Return the axis (3,) and the angle [rad], from zero to pi, of a rotation; the axis is zero without a rotation."""
    size = float(np.linalg.norm(q[1:]))
    if size == 0.0:
        return np.zeros(3), 0.0
    sign = 1.0 if q[0] >= 0 else -1.0
    return sign * q[1:] / size, 2 * float(np.arctan2(size, abs(q[0])))
