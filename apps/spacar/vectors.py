"""Writes coordinates, deformations and forces of all states of an analysis as SPACAR's vectors, with their indices."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from flexel.apps.spacar.reading import Spacar
from flexel.base.arrays import Array
from flexel.model.state import State
from flexel.results.system_facade import System

Place = tuple[int, int]  # node and coordinate, or element and mode
Reader = Callable[[Spacar, State, System], list[float]]  # a row of a table
OF_NODES = ("x", "xd", "xdd", "fx", "fxtot")


@dataclass(frozen=True)
class Vectors:
    """The quantities of an analysis in SPACAR's numbers and signs.

    Attributes
    ----------
    time : ndarray (nt,)
    nodes, elements : tuple of (number, i)
        The quantities of the columns: coordinate i of a node, mode i of an element.
    tables : mapping of str to ndarray (nt, columns)
        Of nodes x, xd, xdd, fx (loads) and fxtot (reactions); of elements e, ed, edd, sig.
    """

    time: Array
    nodes: tuple[Place, ...]
    elements: tuple[Place, ...]
    tables: Mapping[str, Array]

    def places(self, table: str) -> tuple[Place, ...]:
        """Return the quantities of the columns of a table."""
        return self.nodes if table in OF_NODES else self.elements


def vectors(
    file: Spacar, states: Sequence[State], system: System | None = None, wanted: Iterable[str] | None = None
) -> Vectors:
    """Return quantities at some states of a file.

    Parameters
    ----------
    system : System, optional
        Of the states, if it is a variant of the file's system.
    wanted : iterable of str, optional
        Names of tables; all by default.
    """
    of = system or file.system
    chosen = READERS if wanted is None else wanted
    tables = {name: np.array([READERS[name](file, state, of) for state in states]) for name in chosen}
    time = np.array([state.t for state in states])
    return Vectors(time, tuple(file.coordinates), tuple(file.deformations), tables)


def _of_nodes(read: Callable[[State, str], float]) -> Reader:
    return lambda file, state, _: [read(state, name) for name in file.coordinates.values()]


def _of_modes(read: Callable[[State, str, float], float]) -> Reader:
    return lambda file, state, _: [read(state, name, factor) for name, factor in file.deformations.values()]


def _loaded(file: Spacar, state: State, system: System) -> list[float]:
    loads, first = _loads(state, system), state.structure.m + state.structure.k
    return [float(loads[state.structure.find(name) - first]) for name in file.coordinates.values()]


def _loads(state: State, system: System) -> Array:
    """Return forces (n,) of the loads, conjugate to coordinates; moments on orientations by angular velocities."""
    nodal, applied = system.loads.at(state.t)
    return nodal - state.J[: state.structure.m + state.structure.k].T @ applied


def numbered_places(places: Sequence[Place], width: int) -> NDArray[np.int32]:
    """Return indices in the vectors, from 1, as in SPACAR's lnp and le: a row per number, 0 if there is none."""
    found = np.zeros((max((n for n, _ in places), default=0), width), dtype=np.int32)
    for column, (n, i) in enumerate(places, 1):
        found[n - 1, i - 1] = column
    return found


READERS: dict[str, Reader] = {
    "x": _of_nodes(lambda state, name: state[name]),
    "xd": _of_nodes(lambda state, name: state.rate(name)),
    "xdd": _of_nodes(lambda state, name: state.acceleration(name)),
    "fx": _loaded,
    "fxtot": _of_nodes(lambda state, name: state.force(name)),
    "e": lambda file, state, _: [file.deformation(state, *place) for place in file.deformations],
    "ed": _of_modes(lambda state, name, factor: factor * state.rate(name)),
    "edd": _of_modes(lambda state, name, factor: factor * state.acceleration(name)),
    "sig": lambda file, state, _: [file.stress(state, *place) for place in file.deformations],
}
