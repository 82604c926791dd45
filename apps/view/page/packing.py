"""Packs numbers as text: Float32, little-endian, in base64."""

from __future__ import annotations

import base64
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from flexel.base.errors import ModelError


def packed(rows: ArrayLike) -> str:
    """Pack rows of numbers; one row only if all are equal."""
    values = np.asarray(rows, dtype="<f4")
    if not np.all(np.isfinite(values)):
        raise ModelError(
            "view: a state has positions or forces that are not finite; show the part before it with between="
        )
    if np.all(values == values[:1]):
        values = values[:1]
    return base64.b64encode(values.tobytes()).decode()


def unpacked(text: str) -> NDArray[np.float32]:
    """Return the numbers of a text, one after another."""
    return np.frombuffer(base64.b64decode(text), dtype="<f4")


def rounded(values: Any) -> Any:
    """Round nested lists of numbers to nine digits after the point."""
    return np.round(np.asarray(values, dtype=float), 9).tolist()
