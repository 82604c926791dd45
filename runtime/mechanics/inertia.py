"""Errors that name motions without mass."""

from __future__ import annotations

import numpy as np

from flexel.base.arrays import Array
from flexel.base.errors import DynamicsError
from flexel.model.role_lists import Roles
from flexel.model.structure import Structure

LOST = 1e-12  # inertia of a degree of freedom, relative to the largest eigenvalue, that is not zero


class InertiaError(DynamicsError):
    """A motion moves no mass, so its acceleration is undetermined."""


def unmoved(name: str | None) -> InertiaError:
    """Return the error for a motion without mass in which a coordinate takes part (None: unknown)."""
    motion = "a motion" if name is None else f"a motion of '{name}'"
    return InertiaError(
        f"the mass matrix is singular: {motion} moves no mass; give its bodies mass and inertia, or start from rest "
        "(start=system.at_rest)"
    )


def massless(structure: Structure, roles: Roles, reduced: Array) -> InertiaError:
    """Return the error for a reduced mass matrix (nd, nd) that is not positive definite."""
    w, V = np.linalg.eigh(reduced)
    row = int(np.argmax(np.abs(V[:, 0])))
    culprit = structure.names[roles.dynamic[row]]
    lost = bool(reduced[row, row] > LOST * w[-1])  # it moves mass only together with others
    why = ", or so little that it is lost in rounding errors of the largest inertia" * lost
    remedy = ", or name coordinates of the heaviest bodies with m.independent(…)" * lost
    return InertiaError(
        f"reduced mass matrix is not positive definite (smallest eigenvalue {w[0]:.3g}, largest {w[-1]:.3g}): "
        f"{'a motion of' if lost else 'the degree of freedom'} '{culprit}' moves no mass{why}; give its bodies mass "
        f"and inertia, or prescribe it{remedy}"
    )
