"""Array type aliases used by every module."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Index = NDArray[np.intp]
ComplexArray = NDArray[np.complex128]
Vector = Sequence[float] | Array
StateSpace = tuple[Array, Array, Array, Array]  # A, B, C, D
