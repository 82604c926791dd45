"""Growth of motions about an equilibrium, where forces have no potential or wheels roll."""

from __future__ import annotations

import numpy as np

from flexel.mechanics.core import Core
from flexel.mechanics.inertia import InertiaError
from flexel.mechanics.rigid import spectrum
from flexel.structure.state import State

GROWTH = 1e-6  # real part of an eigenvalue, relative to the largest one, that counts as growth
LARGEST = 400  # most degrees of freedom for which all eigenvalues are computed


def growing_motions(system: Core, state: State) -> int:
    """Number of eigenvalues of the linearized equations whose real parts are positive.

    None are counted if a degree of freedom has no inertia, or in very large models.
    """
    if system.roles.nq > LARGEST:
        return 0
    try:
        lin = system._linearization(state)
    except InertiaError:
        return 0
    w = spectrum(lin.state_matrix, len(lin.dynamic))[0]
    return int(np.sum(w.real > GROWTH * np.abs(w).max(initial=0.0)))
