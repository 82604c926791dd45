"""Vectors and rotations in NumPy, for real and complex numbers; nothing of flexel is used.

Every array has its components along the first axis; further axes are configurations beside each other, so that a
Jacobian by complex step is one call.
"""

import numpy as np

from flexel.base.arrays import Array


def dot(a: Array, b: Array) -> Array:
    """The product of two vectors, (3, ...) or (2, ...) -> (...)."""
    return np.asarray(sum(a[i] * b[i] for i in range(len(a))))


def cross(a: Array, b: Array) -> Array:
    """The vector product, (3, ...)."""
    i, j = (1, 2, 0), (2, 0, 1)
    return np.array([a[k] * b[l] - a[l] * b[k] for k, l in zip(i, j, strict=True)])


def norm(a: Array) -> Array:
    """The length, analytic: no absolute value."""
    return np.sqrt(dot(a, a))


def columns(vector: Array, like: Array) -> Array:
    """A constant vector (3,) as (3, 1, …) beside an array (n, …)."""
    return np.asarray(vector).reshape(-1, *(1,) * (np.ndim(like) - 1))


def product(a: Array, b: Array) -> Array:
    """The product of two quaternions (4, ...)."""
    return np.array(
        [
            a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
            a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
            a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
            a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0],
        ]
    )


def conjugate(a: Array) -> Array:
    """The opposite rotation."""
    return np.array([a[0], -a[1], -a[2], -a[3]])


def rotation(lam: Array) -> Array:
    """The rotation matrix (3, 3, ...), a homogeneous quadratic in the Euler parameters."""
    a, b, c, d = lam
    return np.array(
        [
            [a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c)],
            [2 * (b * c + a * d), a * a - b * b + c * c - d * d, 2 * (c * d - a * b)],
            [2 * (b * d - a * c), 2 * (c * d + a * b), a * a - b * b - c * c + d * d],
        ]
    )


def rotated(lam: Array, vector: Array) -> Array:
    """R(λ) b (3, ...) of a vector in body axes (3,)."""
    R = rotation(lam)
    return np.asarray(R[:, 0] * vector[0] + R[:, 1] * vector[1] + R[:, 2] * vector[2])


def rotated_rate(lam: Array, rate: Array, vector: Array) -> Array:
    """d(R(λ) b)/dt (3, ...): R is quadratic, so that its rate is its bilinear form."""
    return rotated(lam + rate, vector) - rotated(lam, vector) - rotated(rate, vector)


def body_rate(lam: Array, rate: Array) -> Array:
    """The angular velocity in body axes (3, ...)."""
    return np.asarray(2 * product(conjugate(lam), rate)[1:])


def turned(angle: Array, vector: Array) -> Array:
    """A planar vector (2,) turned by an angle (...), as (2, ...)."""
    c, s = np.cos(angle), np.sin(angle)
    return np.array([c * vector[0] - s * vector[1], s * vector[0] + c * vector[1]])


def about(axis: Array, angle: float) -> Array:
    """Euler parameters (4,) of a turn about an axis (3,)."""
    e = np.asarray(axis, float) / np.linalg.norm(axis)
    return np.array([np.cos(angle / 2), *(np.sin(angle / 2) * e)])


def across(axis: Array) -> tuple[Array, Array]:
    """Two unit vectors across an axis (3,) and across each other."""
    e = np.asarray(axis, float) / np.linalg.norm(axis)
    first = np.cross(e, np.eye(3)[np.argmin(np.abs(e))])
    first /= np.linalg.norm(first)
    return first, np.cross(e, first)
