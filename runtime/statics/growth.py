"""Detects growing motions about an equilibrium if forces have no potential or wheels roll."""

from __future__ import annotations

import numpy as np

from flexel.mechanics.inertia import InertiaError
from flexel.mechanics.rigid import spectrum
from flexel.model.state import State
from flexel.system import CoreSystem

GROWTH = 1e-6  # real part of an eigenvalue, relative to the largest one, that counts as growth
MAX_DOFS = 400  # most degrees of freedom for which all eigenvalues are computed


def growing_motions(system: CoreSystem, state: State) -> int:
    """Count the eigenvalues of the linearized equations with positive real parts.

    Returns zero if a degree of freedom has no inertia, or for very large models.
    """
    if system.roles.nq > MAX_DOFS:
        return 0
    try:
        lin = system._linearization(state)
    except InertiaError:
        return 0
    w = spectrum(lin.state_matrix, len(lin.dynamic))[0]
    return int(np.sum(w.real > GROWTH * np.abs(w).max(initial=0.0)))
