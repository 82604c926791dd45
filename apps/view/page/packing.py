"""Packs numbers as text for the page."""

from __future__ import annotations

import base64
from collections.abc import Iterable
from typing import Any

import numpy as np

from flexel.base.errors import ModelError


def packed(rows: Iterable[Any]) -> str:
    """Pack rows of numbers as Float32 in base64; one row only if all are equal."""
    values = np.array([np.ravel(row) for row in rows], dtype="<f4")
    if not np.all(np.isfinite(values)):
        raise ModelError(
            "view: a state has positions or forces that are not finite; show the part before it with between="
        )
    if np.all(values == values[0]):
        values = values[:1]
    return base64.b64encode(values.tobytes()).decode()


def rounded(values: Any) -> Any:
    """Round nested lists of numbers to nine digits after the point."""
    return np.round(np.asarray(values, dtype=float), 9).tolist()
