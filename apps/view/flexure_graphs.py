"""Plots results of a flexure mechanism over its load steps, and the stiffness of a node over its travel."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, Protocol

import numpy as np

from flexel.apps.view.figures import COLOURS, figure, save
from flexel.base.arguments import text, unknown, whole
from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.linear.mode_tracking import among_lowest

if TYPE_CHECKING:
    from matplotlib.figure import Figure

CURVES_SHOWN = 3  # frequencies and multipliers drawn
TURNED, MOVED = ("turn x", "turn y", "turn z"), ("x", "y", "z")  # directions of a compliance


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
    def tracked_frequencies(self) -> Mapping[str, Array]:
        """Frequencies [Hz] of each mode at the steps, by name."""

    @property
    def tracked_buckling(self) -> Mapping[str, Array]:
        """Buckling multipliers of each mode at the steps, by name."""

    def stiffness(self, node: int, body_axes: bool = False) -> Array:
        """Return the stiffness of a node at the steps."""


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
        ("frequency [Hz]", _lowest(result.tracked_frequencies)),
        (
            "largest stress [MPa]",
            {
                f"element {i + 1}": 1e-6 * stress
                for i, stress in enumerate(result.stress.T)
                if not np.isnan(stress).all()
            },
        ),
        ("buckling multiplier [-]", _lowest(result.tracked_buckling)),
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


def plot_stiffness(
    result: LoadSteps, node: int, along: str = "", body_axes: bool = False, path: str | Path | None = None
) -> Figure:
    """Plot the stiffness of a node in every direction over its travel.

    Parameters
    ----------
    node, along, body_axes, path
        As for `Flexure.plot_stiffness`.
    """
    stiffness = result.stiffness(node, body_axes)
    travel = result.displacements[:, node - 1]
    if text(along, "plot_stiffness", "along") and along not in MOVED:
        raise ModelError(f"plot_stiffness: {unknown(along, MOVED, 'direction')}")
    i = MOVED.index(along) if along else int(np.argmax(np.ptp(travel, axis=0)))
    panels = (("stiffness [N/m]", MOVED, stiffness[:, :3]), ("stiffness [N m/rad]", TURNED, stiffness[:, 3:]))
    shown = [
        (
            label,
            {name: values for name, values in zip(names, part.T, strict=True) if np.isfinite(values).any()},
        )
        for label, names, part in panels
    ]
    with figure(2, 1, size=(7.0, 6.6), squeeze=False, sharex=True) as (drawn, axes):
        for panel, (label, curves) in zip(axes.flat, shown, strict=True):
            _curves(panel, 1e3 * travel[:, i], {name: np.abs(values) for name, values in curves.items()})
            panel.set_yscale("log")
            panel.set_ylabel(label)
        axes[-1, 0].set_xlabel(f"displacement of node {node} in {MOVED[i]} [mm]")
        drawn.suptitle(f"Stiffness of node {node} over its travel")
    save(drawn, path)
    return drawn


def _lowest(curves: Mapping[str, Array]) -> dict[str, Array]:
    """Return the curves that are among the first few at any step."""
    if not curves:
        return {}
    among = among_lowest(np.array(list(curves.values())).T, CURVES_SHOWN)
    return {name: values for (name, values), shown in zip(curves.items(), among, strict=True) if shown}


def _curves(panel: Any, load: Array, curves: dict[str, Array]) -> None:
    """Draw curves with marks at the steps."""
    for i, (name, values) in enumerate(curves.items()):
        panel.plot(load, values, ".-", color=COLOURS[i % len(COLOURS)], label=name)
    panel.legend(loc="best")
