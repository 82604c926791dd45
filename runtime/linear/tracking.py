"""Eigenvalues over a parameter, put in order so that each column continues smoothly."""

from __future__ import annotations

from typing import Any

import numpy as np
from scipy.optimize import linear_sum_assignment

from flexel.base.arrays import Array, ComplexArray


def branches(parameter: Array, eigenvalues: Any) -> ComplexArray:
    """Eigenvalues (np, n) with their columns reordered so that each column continues smoothly.

    From one value of the parameter to the next the eigenvalues are assigned to the linear continuation of the
    branches so that the sum of the distances is smallest.
    """
    found = np.array(eigenvalues, dtype=complex)
    for i in range(1, len(found)):
        step = (parameter[i] - parameter[i - 1]) / (parameter[i - 1] - parameter[i - 2]) if i > 1 else 0.0
        expected = found[i - 1] + step * (found[i - 1] - found[i - 2] if i > 1 else 0.0)
        order = linear_sum_assignment(np.abs(expected[:, None] - found[i][None, :]))[1]
        found[i] = found[i][order]
    return found
