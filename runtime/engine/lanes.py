"""Memory layout of the rows of a batch: blocks of eight elements side by side, one lane each."""

from __future__ import annotations

from typing import Any

import numpy as np

from flexel.base.arrays import Array, Index

LANES = 8  # elements in a block, see generated/kernels.h


def blocks(values: Any) -> Any:
    """Lay out rows (elements, r) as (blocks, r, 8); the last lanes repeat the last element."""
    size, rows = values.shape
    count = -(-size // LANES)
    padded = np.concatenate([values, np.repeat(values[-1:], count * LANES - size, axis=0)])
    return np.ascontiguousarray(padded.reshape(count, LANES, rows).transpose(0, 2, 1))


def filled(values: Any, beyond: int) -> Any:
    """Lay out rows in the same way, with one value in the lanes without an element."""
    found = blocks(values)
    size, (count, _, _) = values.shape[0], found.shape
    if size < count * LANES:
        found[-1, :, size - count * LANES :] = beyond
    return found


def lanes(size: int, rows: int, start: int) -> Index:
    """Return the buffer indices (elements, rows) of the rows of one output."""
    element = np.arange(size)[:, None]
    return np.asarray(start + (element // LANES * rows + np.arange(rows)) * LANES + element % LANES)


def aligned(size: int) -> Array:
    """Allocate zeros (size,) that begin a cache line."""
    space = np.zeros(size + LANES)
    first = -space.ctypes.data % 64 // 8
    return space[first : first + size]
