"""Checks of numbers and geometry that several kinds of elements share.

Imports numpy, the errors and the orientation.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from flexel.errors import ModelError
from flexel.inputs import number as checked
from flexel.orientation import conjugate, product
from flexel.structure import Array


def positive(value: Any, owner: str, what: str) -> float:
    """A positive finite number, or a ModelError."""
    number = checked(value, owner, what)
    if number <= 0:
        raise ModelError(f"{owner}: {what} {number:g} is not positive; give a positive value")
    return number


def not_negative(value: Any, owner: str, what: str) -> float:
    """A finite number that is zero or positive, or a ModelError."""
    number = checked(value, owner, what)
    if number < 0:
        raise ModelError(f"{owner}: {what} {number:g} is negative; give zero or a positive value")
    return number


def span(xp: Array, xq: Array, owner: str) -> tuple[Array, float]:
    """Direction and length of the line between two points."""
    line = xq - xp
    length = float(np.linalg.norm(line))
    if length < 1e-12 * max(1.0, float(np.max(np.abs(xp)))):
        raise ModelError(
            f"{owner}: its two points coincide at {tuple(xp.tolist())}; the element has no length, move one"
        )
    return line / length, length


def in_frame(frame: Array, triad: Array) -> Array:
    """Triad, given in global axes, as seen from a body frame."""
    return product(conjugate(frame), triad)
