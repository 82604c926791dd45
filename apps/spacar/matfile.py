"""Writes results of an analysis to a .mat file, with the names of SPACAR: x, e, sig, lnp, le, m0, k0 ..."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from flexel.apps.spacar.analysis_modes import HISTORIES, Analysis
from flexel.apps.spacar.reading import Spacar
from flexel.apps.spacar.vectors import Place, numbered_places, vectors
from flexel.base.arrays import Array
from flexel.base.files import replacing

NODE, ELEMENT = 4, 8  # most coordinates of a node, and modes of an element: columns of lnp and le


def matlab_variables(file: Spacar, found: Analysis) -> dict[str, Any]:
    """Return the variables of a .mat file.

    In the tables (time, x, xd, xdd, fx, fxtot, e, ed, edd, sig, and small changes dx, de in mode 3) each row is a
    state.  Column ``lnp(n, i)`` is coordinate i of node n, column ``le(n, i)`` mode i of element n; zero: there is
    none.  Matrices (m0 ... g0, a ... d) of several states are pages, ``k0(:, :, step)``.
    """
    variables: dict[str, Any] = {}
    if found.states:
        own, system = vectors(file, found.states, found.system), found.system or file.system
        variables = {"time": own.time[:, None], **own.tables}
        variables |= {"lnp": numbered_places(own.nodes, NODE), "le": numbered_places(own.elements, ELEMENT)}
        variables |= _changes(found, "dx", own.nodes) | _changes(found, "de", own.elements)
        dynamic, kinematic = len(system.dynamic), len(system.kinematic)
        variables |= {"nx": len(own.nodes), "ne": len(own.elements)}
        variables |= {"nddo": dynamic, "nkdo": dynamic + kinematic}
        variables["dof"] = np.array([*system.dynamic, *system.kinematic], dtype=object)
    for name, value in found.results.items():
        if value.ndim > 1:
            variables[name.lower()] = np.moveaxis(value, 0, -1) if value.ndim > 2 else value
        elif name != "t" and not name.startswith(HISTORIES):
            variables[name] = value
    return variables


def _changes(found: Analysis, table: str, places: Sequence[Place]) -> dict[str, Array]:
    """Return a table (nt, columns) of small changes; nothing where the analysis has none."""
    columns = [found.results[name] for n, i in places if (name := f"{table}_{n}_{i}") in found.results]
    return {table: np.column_stack(columns)} if columns else {}


def write_mat(file: Spacar, found: Analysis, path: Path) -> Path:
    """Write the variables of an analysis; the file is written completely, or the old one remains."""
    from scipy.io import savemat

    with replacing(path, "run") as part:
        savemat(part, matlab_variables(file, found), do_compression=True, oned_as="column")
    return path
