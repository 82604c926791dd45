"""Graphs of a flexure mechanism over its load steps."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from flexel.base.arguments import whole
from flexel.base.arrays import Array
from flexel.pictures.figures import COLOURS, figure, save

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from flexel.results.flexure import Flexure

SHOWN = 3  # frequencies and multipliers drawn


def plot_flexure(result: Flexure, nodes: Sequence[int], path: str | Path | None = None) -> Figure:
    """Displacements of nodes, lowest frequencies, largest stress and buckling multipliers over the load.

    Parameters
    ----------
    nodes : sequence of int
        Nodes whose displacements are shown; the one that moves farthest by default.
    path : path, optional
        File for the figure; the suffix determines the format.
    """
    moved = result.displacements
    count = moved.shape[1]
    chosen = [whole(i, "flexure.plot", "node", most=count) for i in nodes]
    chosen = chosen or [1 + int(np.argmax(np.linalg.norm(moved[-1], axis=1)))]
    panels: list[tuple[str, dict[str, Array]]] = [
        (
            "displacement [mm]",
            {f"node {i}, {axis}": 1e3 * moved[:, i - 1, k] for i in chosen for k, axis in enumerate("xyz")},
        ),
        ("frequency [Hz]", {f"mode {k + 1}": z for k, z in enumerate(result.frequencies.T[:SHOWN])}),
        (
            "largest stress [MPa]",
            {f"element {i + 1}": 1e-6 * z for i, z in enumerate(result.stress.T) if not np.isnan(z).all()},
        ),
        ("buckling multiplier [-]", {f"mode {k + 1}": z for k, z in enumerate(result.buckling.T[:SHOWN])}),
    ]
    panels = [(label, curves) for label, curves in panels if curves]
    rows = (len(panels) + 1) // 2
    with figure(rows, 2, size=(9.0, 0.6 + 3.0 * rows), squeeze=False, sharex=True) as (drawn, axes):
        for panel, (label, curves) in zip(axes.flat, panels, strict=False):
            _curves(panel, result.load, curves)
            panel.set_ylabel(label)
        for panel in axes.flat[len(panels) :]:
            panel.set_visible(False)
        for panel in axes[-1]:
            panel.set_xlabel("share of the loads [-]")
        drawn.suptitle("Flexure mechanism over its load steps")
    save(drawn, path)
    return drawn


def _curves(panel: Any, load: Array, curves: dict[str, Array]) -> None:
    """Curves with marks at the steps."""
    for i, (name, values) in enumerate(curves.items()):
        panel.plot(load, values, ".-", color=COLOURS[i % len(COLOURS)], label=name)
    panel.legend(loc="best")
