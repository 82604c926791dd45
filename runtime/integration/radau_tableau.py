"""The coefficients of Radau IIA of order 5.

Source: Hairer and Wanner (1996), IV.5 and IV.8.
"""

from __future__ import annotations

import numpy as np

from flexel.base.arrays import Array

_R = 6**0.5
NODES = np.array([(4 - _R) / 10, (4 + _R) / 10, 1.0])
WEIGHTS = np.array(
    [
        [(88 - 7 * _R) / 360, (296 - 169 * _R) / 1800, (-2 + 3 * _R) / 225],
        [(296 + 169 * _R) / 1800, (88 + 7 * _R) / 360, (-2 - 3 * _R) / 225],
        [(16 - _R) / 36, (16 + _R) / 36, 1 / 9],
    ]
)
# powers of time of the polynomial through the stages
COLLOCATION = np.linalg.inv(NODES[:, None] ** np.arange(1, 4))
# powers of time of 10 times the integral of (s - c1)(s - c2)(s - 1), which is zero at both ends
CORRECTION = np.array([-1.0, 4.5, -6.0, 2.5])


def _decoupled() -> tuple[Array, float, complex]:
    """T of the inverse of the matrix of the method, and its real and complex eigenvalue."""
    values, vectors = np.linalg.eig(np.linalg.inv(WEIGHTS))
    real, pair = int(np.argmin(np.abs(values.imag))), int(np.argmax(values.imag))
    T = np.column_stack([vectors[:, real].real, vectors[:, pair].real, -vectors[:, pair].imag])
    return np.ascontiguousarray(T), float(values[real].real), complex(values[pair])


T, REAL, PAIR = _decoupled()
