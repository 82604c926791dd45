"""Signs that the parameters of the built-in laws must have: with others a law divides by zero or makes energy.

Parameters that are not listed, such as a camber stiffness or a trail, may have either sign.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

from flexel.base.arguments import not_negative, positive
from flexel.base.arrays import Array
from flexel.base.errors import ModelError

Check = Callable[[Any, str, str], float]
Checks = dict[str, tuple[Check, ...]]


def _at_least_one(value: Any, owner: str, what: str) -> float:
    if value < 1:
        raise ModelError(f"{owner}: {what} {value:g} is less than one; give 1, or 3/2 for Hertz")
    return float(value)


def _not_zero(value: Any, owner: str, what: str) -> float:
    if value == 0:
        raise ModelError(f"{owner}: {what} is zero and divides; give another value")
    return float(value)


def _any(value: Any, owner: str, what: str) -> float:
    return float(value)


_LOAD: Checks = {"stiffness": (not_negative,), "damping": (not_negative,)}
_SIDE: Checks = {**_LOAD, "standstill": (positive,)}
_NORMAL: Checks = {"stiffness": (not_negative,), "exponent": (_at_least_one,), "dissipation": (not_negative,)}
_COULOMB: Checks = {**_NORMAL, "friction": (not_negative,), "slip_speed": (positive,)}
_BRISTLE: Checks = {
    **_NORMAL,
    "friction": (positive,),
    "bristle_stiffness": (not_negative,),
    "bristle_damping": (not_negative,),
    "release": (not_negative,),
}
# law: parameter: the check of each of its entries
SIGNS: dict[str, Checks] = {
    "stop": _LOAD,
    "vertical_tyre": _LOAD,
    "linear_tyre": {**_SIDE, "cornering": (not_negative,)},
    "calspan_tyre": {
        **_SIDE,
        "A": (_any, _any, positive, _any, _not_zero),
        "B": (_any, positive, _any),  # B3: friction without load
        "SN": (positive,),
    },
    "magic_formula": {
        **_LOAD,
        "load0": (positive,),
        "rolling_radius": (positive,),
        "friction": (positive, _any),
        "slip_stiffness": (not_negative,),
        "cornering": (not_negative, positive),
        "shape": (positive, _any),
        "relaxation": (positive, positive),
    },
    "hertz": _NORMAL,
    **{f"hertz_coulomb_{k}": _COULOMB for k in (1, 2)},
    **{f"hertz_bristle_{k}": _BRISTLE for k in (1, 2)},
    "journal": {**_LOAD, "friction_radius": (not_negative,), "slip_speed": (positive,)},
    **{f"diagonal_{m}": {"S": (not_negative,) * m, "D": (not_negative,) * m} for m in (7, 13)},
}
# laws with matrices, given by their upper triangles, that may have no negative eigenvalue
MATRICES = {f"linear_{m}": ("S", "D") for m in range(1, 7)} | {f"viscous_{k}": ("C",) for k in range(1, 4)}


def check_signs(law: str, values: Mapping[str, Array], owner: str) -> None:
    """Raise a ModelError for a parameter of a built-in law that has a wrong sign."""
    for name, checks in SIGNS.get(law, {}).items():
        for i, (value, check) in enumerate(zip(values[name].ravel(), checks, strict=False), 1):
            check(value, owner, f"parameter {name}" + f", entry {i}," * (len(checks) > 1))
    for name in MATRICES.get(law, ()):
        _check_triangle(values[name].ravel(), int(law[-1]), owner, name)


def _check_triangle(values: Array, size: int, owner: str, name: str) -> None:
    rows, columns = np.triu_indices(size)
    if values.size != rows.size:
        return  # told with the other sizes, at build
    A = np.zeros((size, size))
    A[rows, columns] = A[columns, rows] = values
    refuse_negative(A, owner, f"parameter {name}")


def refuse_negative(A: Array, owner: str, what: str) -> None:
    """Raise a ModelError for a symmetric matrix with a negative eigenvalue."""
    if np.linalg.eigvalsh(A)[0] < -1e-12 * float(np.max(np.abs(A))):
        raise ModelError(
            f"{owner}: {what} {A.tolist()} has a negative eigenvalue; correct it, or state a softening spring as a "
            "formula with m.law"
        )
