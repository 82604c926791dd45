"""Array type aliases used by every module, and the size of an array."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Index = NDArray[np.intp]
ComplexArray = NDArray[np.complex128]
Vector = Sequence[float] | Array
StateSpace = tuple[Array, Array, Array, Array]  # A, B, C, D


def largest(values: Array | ComplexArray) -> float:
    """Return the largest magnitude in an array; zero if it is empty."""
    return float(np.abs(values).max(initial=0.0))
