"""The data that painters read from a model: positions, triads, forces and outputs, in one state or in many at once."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property

import numpy as np

from flexel.apps.view.primitives import extent, spatial
from flexel.base.arrays import Array
from flexel.base.quaternions import matrix
from flexel.model.instances import Instance
from flexel.model.state import State

OUTPUTS_AT_ONCE = 2**15  # elements times states of one call, so that what it returns stays below some 10 MB


class Poses:
    """A model in one state, or in several.

    Every array that it returns has the states along its first axis, where there are several: (..., 3) below is (3,) for
    one state and (states, 3) for several. Painters are written for both, so that the frames of a motion are painted in
    one go.

    Parameters
    ----------
    states : State, or sequence of State
        Of one model.
    """

    def __init__(self, states: State | Sequence[State]) -> None:
        self._alone = isinstance(states, State)
        rows = [states] if isinstance(states, State) else list(states)
        self.structure, self.roles, self._geometry = rows[0].structure, rows[0].roles, rows[0].evaluation
        self._x = np.array([state.x for state in rows])
        self._e = np.array([state.e for state in rows])
        self._stresses = np.array([state.stresses for state in rows])
        # outputs of several elements together, and the place in them, by element: those asked for last of each type
        self._found: dict[int, tuple[dict[str, Array], int]] = {}

    def _given(self, rows: Array) -> Array:
        """Return rows of states as they are returned: without their axis for one state."""
        return rows[0] if self._alone else rows

    @cached_property
    def size(self) -> float:
        """Size of the drawn model [m]."""
        return extent(self.structure)

    @property
    def shape(self) -> tuple[int, ...]:
        """Leading axes of the returned arrays: none, or the number of states."""
        return () if self._alone else (len(self._x),)

    def coordinates(self, node: str) -> Array:
        """Return the coordinates (..., k) of a node."""
        return self._given(self._x[:, self.structure.places(node)])

    def place(self, node: str) -> Array:
        """Return positions (..., 3) of a point; planar points lie in z = 0."""
        return spatial(self.coordinates(node))

    def axes(self, frame: str) -> Array:
        """Return the axes (..., 3, 3), in columns, of a frame or of a planar angle."""
        return axes_from(self.coordinates(frame))

    def deformation(self, name: str) -> Array:
        """Return the values (...) of a deformation."""
        return self._given(self._e[:, self.structure.find(name)])

    def stress(self, name: str) -> Array:
        """Return the stresses (...) of a deformation or slip."""
        return self._given(self._stresses[:, self.structure.find(name)])

    def outputs(self, instance: Instance) -> dict[str, Array]:
        """Return the outputs of an element by name, (..., *shape) each; see `State.outputs`."""
        if id(instance) not in self._found:
            self._evaluate(instance)
        found, i = self._found[id(instance)]
        return {name: self._given(values[:, i]) for name, values in found.items()}

    def _evaluate(self, first: Instance) -> None:
        """Evaluate an element together with those of its type that follow it, in place of those evaluated before."""
        same = self._same[id(first.spec), id(first.code)]
        begin = next(i for i, instance in enumerate(same) if instance is first)
        some = same[begin : begin + max(OUTPUTS_AT_ONCE // len(self._x), 1)]
        found = self._geometry.outputs(some, self._x, self._e, self._stresses)
        for other in same:
            self._found.pop(id(other), None)
        self._found |= {id(instance): (found, i) for i, instance in enumerate(some)}

    @cached_property
    def _same(self) -> dict[tuple[int, int], list[Instance]]:
        """Elements by type, in order."""
        found: dict[tuple[int, int], list[Instance]] = {}
        for instance in self.structure.instances:
            found.setdefault((id(instance.spec), id(instance.code)), []).append(instance)
        return found


def axes_from(coordinates: Array) -> Array:
    """Return axes (..., 3, 3), in columns, from Euler parameters (..., 4), or from a planar angle (..., 1)."""
    if coordinates.shape[-1] == 1:
        angle = coordinates[..., 0]
        c, s, o, i = np.cos(angle), np.sin(angle), np.zeros(angle.shape), np.ones(angle.shape)
        rows = np.array([[c, -s, o], [s, c, o], [o, o, i]])
    else:
        rows = matrix(np.moveaxis(coordinates, -1, 0))
    return np.moveaxis(rows, (0, 1), (-2, -1))
