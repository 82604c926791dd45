"""Memory layout of the rows of a batch: blocks of eight elements side by side, one lane each."""

from __future__ import annotations

from typing import Any

import numpy as np

from flexel.base.arrays import Index

LANES = 8  # elements in a block, see generated/kernels.h


def blocks(values: Any) -> Any:
    """Rows (elements, r) laid out as (blocks, r, 8), the last lanes repeating the last element."""
    size, rows = values.shape
    count = -(-size // LANES)
    padded = np.concatenate([values, np.repeat(values[-1:], count * LANES - size, axis=0)])
    return np.ascontiguousarray(padded.reshape(count, LANES, rows).transpose(0, 2, 1))


def lanes(size: int, rows: int, start: int) -> Index:
    """Buffer indices (elements x rows, flat) of the rows of one output, element by element."""
    element = np.arange(size)[:, None]
    return (start + (element // LANES * rows + np.arange(rows)) * LANES + element % LANES).ravel()
