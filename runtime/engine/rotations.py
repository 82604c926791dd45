"""Orientations that turn freely, whose angular velocities are integrated; see rotations.h."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from flexel.base.arrays import Array
from flexel.base.quaternions import product
from flexel.model.role_lists import Roles
from flexel.model.structure import Structure

LISTS = ("at", "part", "rest", "dof")
Indices = list[int]


def frames_with(
    structure: Structure, roles: Roles, parameters: int
) -> Iterator[tuple[Indices, Indices, Indices]]:
    """Find the frames that have so many Euler parameters as dynamic degrees of freedom.

    Yields
    ------
    at : list of int (4,)
        Coordinates of the Euler parameters.
    part : list of int
        Which of the four are degrees of freedom.
    dof : list of int
        Numbers of these among the dynamic degrees of freedom.
    """
    numbers = {int(quantity): i for i, quantity in enumerate(roles.dynamic)}
    for node in structure.nodes:
        quantities = [structure.find(name) for name in node.coordinates] if node.kind == "frame" else []
        part = [i for i, quantity in enumerate(quantities) if quantity in numbers]
        if len(part) == parameters:
            at = [quantity - structure.m - structure.k for quantity in quantities]
            yield at, part, [numbers[quantities[i]] for i in part]


def numbers_of(at: NDArray[np.int32]) -> dict[int, int]:
    """Return the number of each frame by the coordinate of its first Euler parameter, from all (count, 4)."""
    return {int(first): i for i, first in enumerate(at[:, 0])}


@dataclass(frozen=True, eq=False)
class Rotations:
    """The frames with three Euler parameters as dynamic degrees of freedom.

    Attributes
    ----------
    at : ndarray of int (count, 4)
        Coordinates of the Euler parameters.
    part : ndarray of int (count, 3)
        Which of the four are degrees of freedom.
    rest : ndarray of int (count,)
        Which one is not.
    dof : ndarray of int (count, 3)
        Numbers of the three among the dynamic degrees of freedom.
    nq : int
        Number of degrees of freedom.
    """

    at: NDArray[np.int32]
    part: NDArray[np.int32]
    rest: NDArray[np.int32]
    dof: NDArray[np.int32]
    nq: int

    @classmethod
    def of(cls, structure: Structure, roles: Roles) -> Rotations:
        """Return the rotations of a choice of degrees of freedom."""
        found = [
            [*at, *part, 6 - sum(part), *dof] for at, part, dof in frames_with(structure, roles, parameters=3)
        ]
        all_ = np.array(found, dtype=np.int32).reshape(-1, 11)
        return cls(all_[:, :4], all_[:, 4:7], all_[:, 7], all_[:, 8:], roles.nq)

    @property
    def count(self) -> int:
        """Number of frames."""
        return int(self.rest.size)

    @property
    def numbers(self) -> dict[int, int]:
        """Number of each frame by the coordinate of its first Euler parameter."""
        return numbers_of(self.at)

    def sizes(self, rows: int) -> dict[str, int]:
        """Sizes of the arrays of rotations.h, for a number of stages."""
        widths = {"w": 3, "w_new": 3, "W": 3 * rows, "stage": 3, "scale": 4}
        return {name: width * self.count for name, width in widths.items()}

    def apart(self, weight: Array) -> Array:
        """Return weights (nf,) of free coordinates with zeros for the Euler parameters of these frames."""
        found = weight.copy()
        found[self.at.ravel()] = 0.0
        return found

    def allowed(self, of_y: Array, of_rotations: Array) -> Array:
        """Return the allowed errors (ny + 4 count,) in the order of `place`, from the arrays `scale` of a step."""
        own = of_rotations.reshape(-1, 4)
        return np.concatenate([of_y, own[:, :3].ravel(), own[:, 3]])

    @staticmethod
    def turned(L: Array, p: Array) -> Array:
        """Rotate orientations L (count, 4) by p (count, 3); return Euler parameters (count, 4), as in turns.h."""
        angle = np.linalg.norm(p, axis=1, keepdims=True)
        share = 0.5 * np.sinc(0.5 * angle / np.pi)
        return product(L.T, np.hstack([np.cos(0.5 * angle), share * p]).T).T

    def place(self, y: Array, w: Array, other: Array) -> Array:
        """Normalize the Euler parameters in y to length one; set their rates from angular velocities.

        Parameters
        ----------
        y : ndarray (ny,)
        w : ndarray (3 count,)
            Angular velocities.
        other : ndarray (count,)
            The Euler parameters that are not in y.
        """
        y, w, frame = y.copy(), w.reshape(-1, 3), np.arange(self.count)
        L = np.empty((self.count, 4))
        L[frame[:, None], self.part], L[frame, self.rest] = y[self.dof], other
        L /= np.linalg.norm(L, axis=1, keepdims=True)
        v = 0.5 * product(L.T, np.insert(w, 0, 0.0, axis=1).T).T
        y[self.dof], y[self.nq + self.dof] = L[frame[:, None], self.part], v[frame[:, None], self.part]
        return y
