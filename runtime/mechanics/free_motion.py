"""Detects undetermined motions: they move no mass, and nothing resists them."""

from __future__ import annotations

from typing import Any

from flexel.mechanics.inertia import InertiaError
from flexel.mechanics.saddle import Matrix

UNMOVED = (
    1e-9  # kinetic energy of a motion, relative to that of its separate coordinates, that counts as zero
)


def check_inertia(matrix: Matrix, M: Any) -> None:
    """Raise if a motion left free by a singular matrix of an implicit step moves no mass: no step determines it.

    Parameters
    ----------
    matrix : Matrix
    M : sparse (n, n)
        The mass matrix.

    Raises
    ------
    InertiaError
    """
    motion = matrix.free_motion()
    if motion is None:
        return
    M = M[: motion.size, : motion.size]
    if motion @ (M @ motion) <= UNMOVED * float(M.diagonal() @ motion**2):
        raise InertiaError(
            f"a motion of {matrix.names_of(motion)} moves no mass, and nothing resists it: it is undetermined; fix it, "
            "or give it mass, stiffness or damping"
        )
