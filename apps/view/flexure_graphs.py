"""Plots results of a flexure mechanism over its load steps."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, Protocol

import numpy as np

from flexel.apps.view.figures import COLOURS, figure, save
from flexel.base.arguments import whole
from flexel.base.arrays import Array
from flexel.linear.tracking import Branches

if TYPE_CHECKING:
    from matplotlib.figure import Figure

CURVES_SHOWN = 3  # frequencies and multipliers drawn
AXES = ("x", "y", "z", "turn about x", "turn about y", "turn about z")


class LoadSteps(Protocol):
    """Load steps of a flexure mechanism, as far as their figure needs them."""

    @property
    def displacements(self) -> Array:
        """Displacements of the nodes."""

    @property
    def load(self) -> Array:
        """Share of the load at each step."""

    @property
    def stress(self) -> Array:
        """Largest stresses [Pa] of the elements."""

    @property
    def variables(self) -> Mapping[str, Any]:
        """All results, by name."""


def plot_flexure(result: LoadSteps, nodes: Sequence[int], path: str | Path | None = None) -> Figure:
    """Plot displacements of nodes, lowest frequencies, largest stress and buckling multipliers over the load.

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
        ("frequency [Hz]", _tracked(result, "frequency", "mode_shape")),
        (
            "largest stress [MPa]",
            {
                f"element {i + 1}": 1e-6 * stress
                for i, stress in enumerate(result.stress.T)
                if not np.isnan(stress).all()
            },
        ),
        ("buckling multiplier [-]", _tracked(result, "buckling", "buckling_shape")),
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


def _tracked(result: LoadSteps, values: str, shapes: str) -> dict[str, Array]:
    """Track the modes that are among the first at any step by shape, and name them after the largest motion in them."""
    given: Array = np.asarray(result.variables[values].values)
    counts = np.isfinite(given).sum(axis=1)
    if not counts.any():
        return {}
    n = int(counts[counts > 0].min())  # number known at all steps with any modes
    moved: Array = np.array(result.variables[shapes].values, dtype=float)[:, :n]  # (steps, modes, nodes, 6)
    drawn = np.asarray(result.variables["drawn"].values)
    moved[..., 3:] *= float(np.ptp(drawn, axis=0).max()) or 1.0  # rotations as displacements
    labels = [f"node {i + 1}, {axis}" for i in range(len(drawn)) for axis in AXES]
    rows: Array = moved.reshape(len(moved), n, -1)
    branches = Branches.of_shapes(result.load, given[:, :n], rows, labels)
    found = branches.eigenvalues.real
    place = np.argsort(np.argsort(np.abs(found), axis=1, kind="stable"), axis=1)  # NaN last
    among = np.flatnonzero(((place < CURVES_SHOWN) & np.isfinite(found)).any(axis=0))
    return {branches.names[j]: found[:, j] for j in among}


def _curves(panel: Any, load: Array, curves: dict[str, Array]) -> None:
    """Draw curves with marks at the steps."""
    for i, (name, values) in enumerate(curves.items()):
        panel.plot(load, values, ".-", color=COLOURS[i % len(COLOURS)], label=name)
    panel.legend(loc="best")
