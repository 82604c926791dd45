"""Signs required of the parameters of laws and elements: with others, one divides by zero or creates energy.

The words are defined in `flexel.derive.declare.words`.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np

from flexel.base.arguments import not_negative, positive
from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.derive.spec import ParameterSpec, triangle

Check = Callable[[Any, str, str], float]


def _at_least_one(value: Any, owner: str, what: str) -> float:
    if value < 1:
        raise ModelError(f"{owner}: {what} {value:g} is less than one; give 1, or 3/2 for Hertz contact")
    return float(value)


def _not_zero(value: Any, owner: str, what: str) -> float:
    if value == 0:
        raise ModelError(f"{owner}: {what} is zero, but is a divisor; give another value")
    return float(value)


def _any(value: Any, owner: str, what: str) -> float:
    return float(value)


CHECKS: dict[str, Check] = {
    "any": _any,
    "positive": positive,
    "not negative": not_negative,
    "not zero": _not_zero,
    "at least one": _at_least_one,
}


def check_signs(parameters: Sequence[ParameterSpec], values: Mapping[str, Array], owner: str) -> None:
    """Raise a ModelError for a parameter of a law or an element that has a wrong sign."""
    for parameter in parameters:
        given, name = values[parameter.name].ravel(), f"parameter {parameter.name}"
        if parameter.sign == ("semidefinite",):
            _check_triangle(given, parameter.size, owner, name)
            continue
        if "at least one" not in parameter.sign and np.all(given > 0):  # the usual case, at once
            continue
        for i, (value, word) in enumerate(zip(given, parameter.sign, strict=False), 1):
            CHECKS[word](value, owner, name + f", entry {i}," * (parameter.size > 1))


def _check_triangle(values: Array, size: int, owner: str, name: str) -> None:
    rows = triangle(size)
    if values.size != size or rows is None:
        return  # reported with the other sizes, at build
    A = np.zeros((rows, rows))
    i, j = np.triu_indices(rows)
    A[i, j] = A[j, i] = values
    refuse_negative(A, owner, name)


def refuse_negative(A: Array, owner: str, what: str) -> None:
    """Raise a ModelError for a symmetric matrix with a negative eigenvalue."""
    if np.linalg.eigvalsh(A)[0] < -1e-12 * float(np.max(np.abs(A))):
        raise ModelError(
            f"{owner}: {what} {A.tolist()} has a negative eigenvalue; correct it, or give a softening spring as a "
            "formula with m.law"
        )
