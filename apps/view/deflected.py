"""Draws deflected shapes and mode shapes: a mechanism at several states, or displaced from one.

Every function returns the matplotlib figure and writes it to a file if a path is given.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from copy import copy
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from flexel.apps.view import drawing
from flexel.apps.view.figures import COLOURS, caption, save
from flexel.apps.view.primitives import edges
from flexel.apps.view.scene import View, canvas, display_axes, view_of
from flexel.base.arguments import text
from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.model.state import State
from flexel.model.structure import Structure

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from flexel.integration.trajectory import Trajectory

UNSHOWN_STYLES = ("spoke", "axle", "box", "guide", "slide", "spiral", "damper")
GREY = "#b8bfc6"
EDGE = 0.8  # width of the edges of a section
AXES_HEIGHT = 0.84  # height of spatial axes in the figure: title and legend are above
LEGEND_COLUMNS = 3  # of the legend
MODE_AMPLITUDE = 0.1  # displacement of a mode shape, relative to the size of the model


def plot_states(
    motion: Trajectory,
    times: Sequence[float],
    path: str | Path | None = None,
    *,
    view: View | None = None,
    scale: float = 1.0,
    label: str = "t = {:.4g} s",
    title: str = "Shapes during the motion",
) -> Figure:
    """Draw the mechanism at the stored states nearest to the times, over its drawn shape in grey.

    Parameters
    ----------
    times : sequence of float
        [s]; the last stored one if none is given.
    view : View, optional
        View direction, up and sketches.
    scale : float
        Magnification of displacements from the drawn shape.
    label : str
        How the time of a state is written in the legend, as a format.
    title : str
        A magnification is added to it.
    """
    title = caption(title, "plot_shapes") + ("" if scale == 1 else f", displacements × {scale:g}")
    first = motion[0]
    drawn = at_coordinates(first, motion.structure.x0)
    figures = [(drawn, GREY, "as drawn")]
    for i, state in enumerate([motion.nearest(t) for t in times] or [motion[-1]]):
        shown = displaced(drawn, scale * (state.x - drawn.x))
        figures.append(
            (shown, COLOURS[i % len(COLOURS)], text(label, "plot_shapes", "label").format(state.t))
        )
    return _overlaid(figures, path, view, title)


def plot_shape(
    state: State,
    shape: Mapping[str, complex],
    path: str | Path | None = None,
    *,
    size: float | None = None,
    phases: Sequence[float] = (0.0,),
    view: View | None = None,
    title: str = "",
) -> Figure:
    """Draw a mode shape over its state, shown in grey.

    Parameters
    ----------
    state : State
    shape : mapping of str to complex
        Displacements of coordinates, as in `Vibration.shape`, `BucklingMode.shape` or `Linearization.mode_shape`.
    size : float, optional
        Largest displacement shown [m]; a tenth of the model's size by default.
    phases : sequence of float
        Phases at which the motion is shown [rad]; use several if the parts do not move in phase.
    view : View, optional
    title : str
    """
    X = coordinates_of(state.structure, shape)
    X = X * (mode_size(state, X) if size is None else size / max(_travel(state, X), 1e-300))
    figures = [(state, GREY, "")]
    for i, phase in enumerate(phases):
        shown = displaced(state, np.real(X * np.exp(1j * phase)))
        label = f"{np.degrees(phase):.0f}°" if len(phases) > 1 else ""
        figures.append((shown, COLOURS[i % len(COLOURS)], label))
    return _overlaid(figures, path, view, title)


def coordinates_of(structure: Structure, shape: Mapping[str, complex]) -> Any:
    """Return displacements (n,) of all coordinates from those named in a shape; other quantities are ignored."""
    first = structure.m + structure.k
    X = np.zeros(structure.n, dtype=complex)
    for name, value in shape.items():
        i = structure.find(name, "shape") - first
        if i >= 0:
            X[i] = value
    if not np.any(X):
        raise ModelError("shape: no coordinate moves; give the displacements of coordinates, by name")
    return X


def mode_size(state: State, X: Any) -> float:
    """Return the factor that makes the largest displacement of a shape (n,) a tenth of the model's size."""
    places = np.vstack([line for part in drawing.shapes(state) for line in part.lines])
    return MODE_AMPLITUDE * float(np.max(np.ptp(places, axis=0))) / max(_travel(state, X), 1e-300)


def _travel(state: State, X: Any) -> float:
    """Return the largest displacement of the drawn parts, to first order."""
    small = 1e-6 / float(np.max(np.abs(X)))
    moved = [displaced(state, small * part) for part in (np.real(X), np.imag(X))]
    before = np.vstack([line for part in drawing.shapes(state) for line in part.lines])
    after = [
        np.vstack([line for part in drawing.shapes(displaced) for line in part.lines]) for displaced in moved
    ]
    square = sum(np.sum((points - before) ** 2, axis=1) for points in after)
    return float(np.sqrt(np.max(square))) / small


def displaced(state: State, dx: Array) -> State:
    """Make a state for drawing only, with displaced coordinates; Euler parameters keep their norm."""
    x, structure = state.x + dx, state.structure
    for node in structure.nodes:
        if node.kind == "frame":
            places = structure.places(node.name)
            x[places] /= np.linalg.norm(x[places])
    return at_coordinates(state, x)


def at_coordinates(state: State, x: Array) -> State:
    """Make a state for drawing only, with other coordinates (n,); the rest is unchanged."""
    moved = copy(state)
    object.__setattr__(moved, "x", x)
    return moved


def _overlaid(
    figures: Sequence[tuple[State, str, str]], path: str | Path | None, view: View | None, title: str
) -> Figure:
    """Draw several states of one model in one picture, each in a different colour."""
    view = view_of(view, "picture of shapes")
    flat = drawing.planar(figures[0][0])
    up = drawing.upward(figures[0][0]) if view.up is None else np.asarray(view.up, dtype=float)
    turn = np.eye(3) if flat else display_axes(up)
    with canvas(figures[0][0]) as (drawn, axes):
        for state, colour, label in figures:
            parts = [
                part for part in drawing.shapes(state, view.sketches) if part.style not in UNSHOWN_STYLES
            ]
            lines = [line for part in parts for line in part.lines if len(line) > 1]
            wide = [] if flat else [edge for part in parts for edge in edges(part)]
            for i, line in enumerate([*lines, *wide]):
                shown, width = (line @ turn.T).T[: 2 if flat else 3], 2.0 if i < len(lines) else EDGE
                axes.plot(*shown, color=colour, lw=width, label=label if i == 0 else None)
            points = np.array(
                [
                    line[0]
                    for part in drawing.shapes(state)
                    if part.style in ("joint", "mass")
                    for line in part.lines
                ]
            )
            if points.size:
                axes.plot(*(points @ turn.T).T[: 2 if flat else 3], ".", color=colour, ms=5)
        if flat:
            axes.set_xlabel("x [m]")
            axes.set_ylabel("y [m]")
        else:
            axes.view_init(view.elevation, view.azimuth)
            axes.set_axis_off()
            axes.set_position((0, 0, 1, AXES_HEIGHT))
        axes.set_aspect("equal")
        labels = sum(bool(label) for *_, label in figures)
        if labels:  # above the drawing, which may fill its axes
            axes.legend(loc="lower center", bbox_to_anchor=(0.5, 1.0), ncols=min(labels, LEGEND_COLUMNS))
        drawn.suptitle(title)
    save(drawn, path)
    return drawn
