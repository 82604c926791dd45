"""Follows the modes of a flexure mechanism over its load steps by their shapes: a line and a short name for each."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from flexel.base.arrays import Array, Index
from flexel.linear.tracking import EQUAL_TOLERANCE, Branches

AXES = ("x", "y", "z", "turn about x", "turn about y", "turn about z")


def tracked(
    load: Sequence[float] | Array, places: Array, values: Array, shapes: Array, count: int
) -> tuple[tuple[str, ...], Array]:
    """Return the names (lines,) and values (steps, lines) of the modes that are among the first at any step.

    A line ends where no shape continues it, because its mode is no longer among those known. It is named by its number,
    and the direction and node that move most.

    Parameters
    ----------
    load : sequence of float (steps,)
    places : ndarray (n, 3)
        Of the nodes [m].
    values : ndarray (steps, modes)
        Frequencies or multipliers, smallest size first; NaN where fewer are known. A few more than `count` let lines go
        on where modes change places.
    shapes : ndarray (steps, modes, n, 6)
        Displacements and rotations of the nodes.
    count : int
        Modes at a step that are wanted.
    """
    known = np.isfinite(values).sum(axis=1)
    if not known.any():
        return (), np.zeros((len(values), 0))
    n = int(known[known > 0].min())  # at all steps with any modes
    moved: Array = np.array(shapes, dtype=float)[:, :n]
    moved[..., 3:] *= float(np.ptp(places, axis=0).max()) or 1.0  # rotations as displacements
    labels = [f"{axis} of node {i + 1}" for i in range(len(places)) for axis in AXES]
    rows: Array = moved.reshape(len(moved), n, -1)
    branches = Branches.of_shapes(np.asarray(load), values[:, :n], rows, labels)
    found: Array = np.asarray(branches.eigenvalues.real)
    place, among = ranks(found), np.flatnonzero(among_lowest(found, count))
    first = [(int(np.flatnonzero(np.isfinite(found[:, j]))[0]), int(place[:, j].min())) for j in among]
    among = among[sorted(range(len(among)), key=lambda k: first[k])]
    names = branches.names
    moves = [names[j].partition(" (")[0] for j in among]
    return tuple(f"{k}: {name}" for k, name in enumerate(moves, start=1)), found[:, among]


def among_lowest(values: Array, count: int) -> NDArray[np.bool_]:
    """Return which columns of values (steps, lines) are among the smallest in size at any step."""
    return np.asarray(((ranks(values) < count) & np.isfinite(values)).any(axis=0))


def ranks(values: Array) -> Index:
    """Return the place of each value (steps, lines) in its row by size, unknown ones (NaN) last.

    Of equal values, up to rounding, that of the line before comes first.
    """
    size = np.where(np.isfinite(values), np.abs(values), np.inf)
    smaller = size[:, None, :] < (1 - EQUAL_TOLERANCE) * size[:, :, None]
    equal = ~smaller & ~smaller.transpose(0, 2, 1)
    lines = np.arange(size.shape[1])
    return np.asarray((smaller | equal & (lines < lines[:, None])).sum(axis=2))
