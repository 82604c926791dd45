"""Checks that outputs of laws are finite: errors name the quantity whose law has no value or tangent at a state."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from flexel.base.arrays import Array
from flexel.base.errors import DynamicsError
from flexel.engine.workspace import Workspace
from flexel.model.callbacks import raise_failures
from flexel.model.structure import Structure


class TangentError(DynamicsError):
    """A law has no slope at a state reached by an analysis."""


def check_finite(structure: Structure, stress: Array, zd: Array, t: float) -> None:
    """Raise if a given stress, or the rate of an internal state of a law, is not finite, by its name.

    Raises
    ------
    DynamicsError
    """
    if np.isfinite(stress).all() and np.isfinite(zd).all():
        return
    raise_failures(law.code for law in structure.laws)
    if name := _first(structure, np.isfinite(stress), np.isfinite(zd)):
        what = "rate" if name in structure.internal else "stress"
        raise DynamicsError(
            f"the {what} of '{name}' at t = {t:g} s is not finite: its law has no value here; correct the law, or "
            "start within its range"
        )


def check_tangent(structure: Structure, finite: NDArray[np.bool_], t: float) -> None:
    """Raise if a law has no tangent: `finite` flags the stresses (m + k,), then the internal states.

    Raises
    ------
    TangentError
    """
    size = structure.m + structure.k
    raise_failures(law.code for law in structure.laws)
    if name := _first(structure, finite[:size], finite[size:]):
        raise TangentError(
            f"the tangent of the law on '{name}' at t = {t:g} s is not finite: the law has no slope here; correct the "
            "law, or use another state"
        )


def check_slopes(work: Workspace) -> None:
    """Check that the derivatives of the stresses of all laws, which a workspace holds, are finite.

    Raises
    ------
    TangentError
        If a law has no slope there; names it.
    """
    structure, codes = work.tables.structure, work.tables.law.codes
    size = structure.m + structure.k
    wrong = ~(np.isfinite(work.S) & np.isfinite(work.S_rate))[: codes.size]
    finite = np.ones(size, dtype=bool)
    finite[codes[wrong] // max(size, 1)] = False
    check_tangent(structure, finite, float(work.struct.t))


def _first(structure: Structure, stresses: NDArray[np.bool_], lags: NDArray[np.bool_]) -> str | None:
    """Name of the first quantity, or internal state, that is not finite."""
    if not stresses.all():
        return structure.names[int(np.argmin(stresses))]
    if not lags.all():
        return list(structure.internal)[int(np.argmin(lags))]
    return None
