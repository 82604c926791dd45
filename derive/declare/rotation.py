"""Rotations by Euler parameters, as plain functions on SymPy columns.

A quaternion is a column (4, 1), scalar part first. ``rotation_matrix`` is
the homogeneous quadratic R(lambda), a rotation for a unit quaternion and |lambda|^2 times a rotation
otherwise, and the angular velocities are the homogeneous bilinear forms that belong to it; nothing is
normalized, the norm condition lambda.lambda = 1 is a separate deformation.
"""

import sympy as sp
from sympy import Expr, Matrix

HALF = sp.Rational(1, 2)


def dot(a: Matrix, b: Matrix) -> Expr:
    """Return the scalar product of two columns."""
    return sp.Add(*(a[i] * b[i] for i in range(len(a))))


def cross(a: Matrix, b: Matrix) -> Matrix:
    """Return the vector product of two columns (3, 1)."""
    return Matrix([a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]])


def norm(a: Matrix) -> Expr:
    """Return the length of a column."""
    return sp.sqrt(dot(a, a))


def conjugate(a: Matrix) -> Matrix:
    """Return the conjugate of a quaternion."""
    return Matrix([a[0], -a[1], -a[2], -a[3]])


def product(a: Matrix, b: Matrix) -> Matrix:
    """Return the quaternion product a o b, so that R(a o b) = R(a) R(b)."""
    return Matrix(
        [
            a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
            a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
            a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
            a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0],
        ]
    )


def triad(q: Matrix) -> tuple[Matrix, Matrix, Matrix]:
    """Return the columns e_x, e_y, e_z of R(q), homogeneous quadratic in the quaternion q."""
    q0, q1, q2, q3 = q
    return (
        Matrix([q0**2 + q1**2 - q2**2 - q3**2, 2 * (q1 * q2 + q0 * q3), 2 * (q1 * q3 - q0 * q2)]),
        Matrix([2 * (q1 * q2 - q0 * q3), q0**2 - q1**2 + q2**2 - q3**2, 2 * (q2 * q3 + q0 * q1)]),
        Matrix([2 * (q1 * q3 + q0 * q2), 2 * (q2 * q3 - q0 * q1), q0**2 - q1**2 - q2**2 + q3**2]),
    )


def rotation_matrix(q: Matrix) -> Matrix:
    """Return R(q), shape (3, 3)."""
    return Matrix.hstack(*triad(q))


def components(axes: tuple[Matrix, Matrix, Matrix], a: Matrix) -> Matrix:
    """Return the components of the column a on three axes."""
    return Matrix([dot(axis, a) for axis in axes])


def combination(axes: tuple[Matrix, Matrix, Matrix], c: Matrix) -> Matrix:
    """Return the column with components c on three axes."""
    return Matrix([sum(axis[i] * c[j] for j, axis in enumerate(axes)) for i in range(3)])


def _vector_part(q: Matrix) -> Matrix:
    return Matrix([2 * q[1], 2 * q[2], 2 * q[3]])


def angular_velocity(q: Matrix, qd: Matrix) -> Matrix:
    """Return the angular velocity in global axes [rad/s]: the vector part of 2 (qd o conj q)."""
    return _vector_part(product(qd, conjugate(q)))


def body_angular_velocity(q: Matrix, qd: Matrix) -> Matrix:
    """Return the angular velocity in the axes of R(q) [rad/s]: the vector part of 2 (conj q o qd), = 2 L(q) qd."""
    return _vector_part(product(conjugate(q), qd))


def triad_rate(q: Matrix, qd: Matrix) -> tuple[Matrix, Matrix, Matrix]:
    """Return the rates of the columns of R(q): the derivative of the homogeneous quadratic along qd."""
    (a0, a1, a2, a3), (b0, b1, b2, b3) = q, qd
    d00, d11, d22, d33 = (2 * a0 * b0, 2 * a1 * b1, 2 * a2 * b2, 2 * a3 * b3)
    d12, d13, d23 = 2 * (a1 * b2 + a2 * b1), 2 * (a1 * b3 + a3 * b1), 2 * (a2 * b3 + a3 * b2)
    d01, d02, d03 = 2 * (a0 * b1 + a1 * b0), 2 * (a0 * b2 + a2 * b0), 2 * (a0 * b3 + a3 * b0)
    return (
        Matrix([d00 + d11 - d22 - d33, d12 + d03, d13 - d02]),
        Matrix([d12 - d03, d00 - d11 + d22 - d33, d23 + d01]),
        Matrix([d13 + d02, d23 - d01, d00 - d11 - d22 + d33]),
    )
