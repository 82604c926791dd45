"""Detects growing motions about an equilibrium if forces have no potential or wheels roll."""

from __future__ import annotations

import numpy as np

from flexel.base.errors import ConstraintError
from flexel.mechanics.inertia import InertiaError
from flexel.mechanics.rigid import spectrum
from flexel.model.state import State
from flexel.statics.eigenproblem import FLUTTER_SHARE, lowest_squares, mass_matrix
from flexel.statics.equilibrium import Rest
from flexel.system import CoreSystem

GROWTH = 1e-6  # real part of an eigenvalue, relative to the largest one, that counts as growth
MAX_DOFS = 400  # most degrees of freedom for which all eigenvalues are computed
FEW_VIBRATIONS = 10  # of larger models that are looked at


def growing_motions(system: CoreSystem, state: State) -> int:
    """Count the eigenvalues of the linearized equations with positive real parts.

    Returns zero if a degree of freedom has no inertia, or at a singular position, where nothing is known.  Of large
    models only the lowest vibrations are looked at, without damping.
    """
    if system.roles.nq > MAX_DOFS:
        return _growing_vibrations(system, state)
    try:
        lin = system._linearization(state)
    except (InertiaError, ConstraintError):
        return 0
    w = spectrum(lin.state_matrix, len(lin.dynamic))[0]
    return int(np.sum(w.real > GROWTH * np.abs(w).max(initial=0.0)))


def _growing_vibrations(system: CoreSystem, state: State) -> int:
    """Count those of the lowest vibrations of a large model that grow: their squares are negative, or complex."""
    problem = Rest(system, state)
    q = problem.equations(state.t, state.x, problem.multipliers(state), state.e)
    M = mass_matrix(problem)
    if not np.any(M.diagonal()):
        return 0
    w2 = lowest_squares(problem, q, M, FEW_VIBRATIONS)[0]
    largest = np.abs(w2).max(initial=0.0)
    grows = (np.abs(w2.imag) > FLUTTER_SHARE * np.abs(w2)) | (w2.real < 0)
    return int(np.sum(grows & (np.abs(w2) > GROWTH * largest)))
