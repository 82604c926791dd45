"""The shape of a law's tangent, and which of its entries are not zero."""

from __future__ import annotations

from typing import Any

import numpy as np

from flexel.engine.assembly import Batch


def coupled(batch: Batch) -> Any:
    """Which stresses (rows) of a law depend on which of its quantities (rows, rows), at all."""
    m, z = batch.inputs["e"].shape[1], batch.inputs["z"].shape[1]
    size = m + batch.inputs["s"].shape[1]
    (output,) = batch.spec.kernels["tangent"].outputs
    i, j = np.divmod(np.array(output.nonzeros, dtype=np.intp), columns_of(batch))
    found = np.full((size, size), z > 0)
    own = (i < size) & (j < size + m)
    found[i[own], np.where(j[own] < m, j[own], j[own] - m)] = True
    return found


def rows_of(batch: Batch) -> int:
    """Rows of a law's tangent: stresses and rates of internal states."""
    return sum(batch.inputs[z].shape[1] for z in ("e", "s", "z"))


def columns_of(batch: Batch) -> int:
    """Columns of a law's tangent: deformations, their rates, slips and internal states."""
    return rows_of(batch) + int(batch.inputs["e"].shape[1])
