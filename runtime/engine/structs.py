"""Structures in C with the arrays that they point to, which they keep alive."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from flexel.base.arrays import Array
from flexel.engine.lanes import aligned
from flexel.generated._kernels import ffi


class Struct:
    """Base of classes that are a structure in C: its `struct`, and arrays by the names of its fields."""

    struct: Any

    def __init__(self, struct: Any) -> None:
        self.struct = struct
        self._keep: list[Any] = []

    def pointer(self, array: Array, first: int = 0) -> Any:
        """Return a pointer to the numbers of an array, which is kept alive."""
        self._keep.append(array)
        return ffi.from_buffer("double[]", array) + first

    def integers(self, array: NDArray[np.int32]) -> Any:
        """Return a pointer to integers of 32 bits, which are kept alive."""
        self._keep.append(array)
        return ffi.from_buffer("int[]", array) + 0

    def new(self, name: str, size: int) -> Array:
        """Allocate an array of zeros (size,) for a field, aligned to a cache line."""
        array = aligned(max(size, 1))[:size]
        setattr(self.struct, name, self.pointer(array))
        return array
