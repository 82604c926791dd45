"""Coordinates, deformations and forces of all states of an analysis as SPACAR's vectors, with their places."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from flexel.base.arrays import Array
from flexel.spacar.reading import Spacar
from flexel.structure.state import State
from flexel.system import System

Place = tuple[int, int]  # node and coordinate, or element and mode
OF_NODES = ("x", "xd", "xdd", "fx", "fxtot")
OF_ELEMENTS = ("e", "ed", "edd", "sig")


@dataclass(frozen=True)
class Vectors:
    """The quantities of an analysis in SPACAR's numbers and signs.

    Attributes
    ----------
    time : ndarray (nt,)
    nodes, elements : tuple of (number, i)
        What the columns belong to: coordinate i of a node, mode i of an element.
    tables : mapping of str to ndarray (nt, columns)
        Of nodes x, xd, xdd, fx (loads) and fxtot (reactions); of elements e, ed, edd, sig.
    """

    time: Array
    nodes: tuple[Place, ...]
    elements: tuple[Place, ...]
    tables: Mapping[str, Array]

    def places(self, table: str) -> tuple[Place, ...]:
        """What the columns of a table belong to."""
        return self.nodes if table in OF_NODES else self.elements


def vectors(file: Spacar, states: Sequence[State], system: System | None = None) -> Vectors:
    """All quantities at some states of a file.

    Parameters
    ----------
    system : System, optional
        Of the states, if it is a variant of the file's system.
    """
    rows = [_row(file, state, system or file.system) for state in states]
    tables = {name: np.array([row[name] for row in rows]) for name in (*OF_NODES, *OF_ELEMENTS)}
    time = np.array([state.t for state in states])
    return Vectors(time, tuple(file.coordinates), tuple(file.deformations), tables)


def _row(file: Spacar, state: State, system: System) -> dict[str, list[float]]:
    names, modes = file.coordinates.values(), file.deformations
    loads = _loads(state, system)
    first = state.structure.m + state.structure.k
    return {
        "x": [state[z] for z in names],
        "xd": [state.rate(z) for z in names],
        "xdd": [state.acceleration(z) for z in names],
        "fx": [float(loads[state.structure.find(z) - first]) for z in names],
        "fxtot": [state.force(z) for z in names],
        "e": [file.deformation(state, *place) for place in modes],
        "ed": [factor * state.rate(z) for z, factor in modes.values()],
        "edd": [factor * state.acceleration(z) for z, factor in modes.values()],
        "sig": [file.stress(state, *place) for place in modes],
    }


def _loads(state: State, system: System) -> Array:
    """Forces (n,) of the loads, dual to the coordinates; moments on orientations by the angular velocities."""
    nodal, applied = system.loads.at(state.t)
    return nodal - state.J[: state.structure.m + state.structure.k].T @ applied


def numbered_places(places: Sequence[Place], width: int) -> NDArray[np.int32]:
    """Places in the vectors, from 1, as SPACAR's lnp and le have them: a row per number, 0 where there is none."""
    found = np.zeros((max((n for n, _ in places), default=0), width), dtype=np.int32)
    for column, (n, i) in enumerate(places, 1):
        found[n - 1, i - 1] = column
    return found
