"""Tension, strain and curvature of cables, at three points of each."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from flexel.base.arguments import unknown
from flexel.base.arrays import Array, Index
from flexel.base.errors import ModelError
from flexel.rope.cables import LEGENDRE, PLACES, STRAINS
from flexel.structure.instances import Instance
from flexel.structure.state import State


def cable_tension(state: State, cable: str) -> tuple[Array, Array]:
    """Arc length [m] and tension [N] at three points of a cable, damping included; compression is negative.

    Parameters
    ----------
    state : State
    cable : str
        Name of an element.

    Returns
    -------
    s, T : ndarray (3,)
        Undeformed arc length from the first end, and the force in the direction of the cable, at the Gauss points.

    Raises
    ------
    ModelError
        If there is no cable of that name.
    """
    rows = cable_rows(state, [cable])
    return PLACES * rows.l0[0], rows.tension(state)[0]


@dataclass(frozen=True)
class CableRows:
    """Some cables of a model: their deformations, to be read from states.

    Attributes
    ----------
    axial : ndarray of int (cables, 3)
        Quantities of the axial strains.
    bending : ndarray of int (cables, 3, components)
        Quantities of the curvature at each point.
    l0 : ndarray (cables,)
        Undeformed lengths [m].
    """

    axial: Index
    bending: Index
    l0: Array

    def tension(self, state: State) -> Array:
        """Tension (cables, 3) [N] at the Gauss points, damping included."""
        return np.asarray(state.stresses[self.axial] / (STRAINS * self.l0[:, None]) @ LEGENDRE.T)

    def strain(self, state: State) -> Array:
        """Axial strain (cables, 3) at the Gauss points."""
        return np.asarray(state.e[self.axial] @ LEGENDRE.T)

    def curvature(self, state: State) -> Array:
        """Magnitude of the curvature (cables, 3) [1/m] at the Gauss points."""
        return np.asarray(np.linalg.norm(state.e[self.bending], axis=2))


def cable_rows(state: State, cables: Sequence[str]) -> CableRows:
    """The rows of some cables, by name."""
    known = _cables(state)
    found = [known[z] if z in known else find_cable(state, z) for z in cables]
    rows = np.array([[state.structure.index[name] for name in z.deformations] for z in found])
    l0 = np.array([float(z.parameters["l0"][0]) for z in found])
    return CableRows(rows[:, :3], rows[:, 3:].reshape(len(found), 3, -1), l0)


def _cables(state: State) -> dict[str, Instance]:
    return {z.name: z for z in state.structure.instances if z.spec.family == "cable"}


def find_cable(state: State, cable: str) -> Instance:
    """The cable of that name, or a ModelError with the nearest ones."""
    known = _cables(state)
    if cable not in known:
        raise ModelError(unknown(str(cable), known, "cable"))
    return known[cable]
