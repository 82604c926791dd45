"""What every row of the tables of `flexel reproduce` must fulfil."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

KINDS = ("published", "closed form", "other program", "own")
MOST = 3.0  # tolerance over the error that is found
LEAST = 1e-12  # tolerance over the size of the reference, for rounding


def objections(row: Mapping[str, Any]) -> list[str]:
    """What is wrong with a row, as `Quantity.to_dict` gives it."""
    found = []
    if row["reference"] is None:
        if row["kind"] != "none":
            found.append("a kind without a reference")
        if row["ok"] is not None:
            found.append("a verdict without a reference")
        return found
    if row["kind"] not in KINDS:
        found.append(f"kind {row['kind']!r}")
    if not row["source"]:
        found.append("a reference without a source")
    if row["ok"] is not True:
        found.append(f"not reproduced: error {row['error']:.2g}")
    scale = 1.0
    if row["tolerance_kind"] == "absolute":
        scale = float(np.max(np.abs(np.asarray(row["reference"], dtype=float)))) or 1.0
    elif np.any(size(row["reference"]) == 0):
        found.append("relative to an entry that is zero")
    if row["tolerance"] > max(MOST * row["error"], LEAST * scale) * (1 + 1e-9) and not row["reason"]:
        found.append(f"tolerance {row['tolerance']:.2g} for an error of {row['error']:.2g}, without a reason")
    return found


def size(values: Any) -> Any:
    """Sizes of the entries; a pair [re, im] of an array of complex numbers counts as a number that is not zero."""
    numbers = np.abs(np.asarray(values, dtype=float))
    return np.max(numbers, axis=-1) if numbers.ndim > 1 else numbers
