"""Draws a mechanism: any model at a state, painted on matplotlib axes."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from flexel.apps.view import drawing
from flexel.apps.view.figures import figure
from flexel.apps.view.primitives import zigzag
from flexel.apps.view.solids import Sketch, Solid
from flexel.base.arguments import flag, names, number, positive, vector
from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.base.quaternions import unit
from flexel.model.state import State

if TYPE_CHECKING:
    from matplotlib.figure import Figure

# Colour, line width and mark of each style of shape, from back to front; boxes and forces are not painted here.
PAINT: dict[str, tuple[str, float, str]] = {
    "sketch": ("#8fa3b3", 2.0, ""),
    "spoke": ("#9aa3ab", 0.6, ""),
    "valve": ("#c8501e", 1.4, ""),
    "solid": ("#8fa3b3", 1.4, ""),
    "guide": ("#7d868d", 2.0, ""),
    "slide": ("#5a646c", 6.0, ""),
    "tyre": ("#3a3f44", 2.6, ""),
    "rim": ("#222222", 2.2, ""),
    "axle": ("#222222", 2.2, ""),
    "bar": ("#0b5fa5", 2.6, ""),
    "beam": ("#2e8540", 2.6, ""),
    "rope": ("#6b4f2a", 2.0, ""),
    "sheave": ("#8a8f94", 2.2, ""),
    "spring": ("#b5651d", 1.4, ""),
    "damper": ("#55606a", 1.4, ""),
    "spiral": ("#b5651d", 1.2, ""),
    "hinge": ("#444444", 4.0, ""),
    "joint": ("#ffffff", 4.0, "o"),
    "fixed": ("#444444", 5.0, "s"),
    "mass": ("#c8501e", 5.0, "o"),
}


@dataclass(frozen=True)
class View:
    """Camera and options of a picture.

    Parameters
    ----------
    elevation, azimuth : float
        Angles of the camera, in degrees.
    up : sequence of float (3,), optional
        Direction shown as up: normal to the road, against gravity, or z by default.
    centre : str or sequence of float (3,), optional
        A point node to keep in the middle, or a position; the middle of the model by default.
    span : float, optional
        Width of the visible region [m]; the size of the model by default.
    ground : bool
        Draw a grid on the roads of the wheels.
    trails : sequence of str
        Point nodes whose past track is drawn in an animation.
    sketches : sequence of Sketch, Box, Cylinder or Mesh
        Lines and solids carried by bodies, for display only.
    """

    elevation: float = 20.0
    azimuth: float = -60.0
    up: Sequence[float] | None = None
    centre: str | Sequence[float] | None = None
    span: float | None = None
    ground: bool = True
    trails: Sequence[str] = ()
    sketches: Sequence[Sketch | Solid] = ()

    def __post_init__(self) -> None:
        number(self.elevation, "View", "elevation")
        number(self.azimuth, "View", "azimuth")
        if self.up is not None:
            unit(self.up, "View", "up")
        if self.centre is not None and not isinstance(self.centre, str):
            vector(self.centre, "View", "centre", 3)
        if self.span is not None:
            positive(self.span, "View", "span")
        flag(self.ground, "View", "ground")
        names(self.trails, "View: trails")
        if not isinstance(self.sketches, Sequence) or not all(
            isinstance(sketch, (Sketch, Solid)) for sketch in self.sketches
        ):
            raise ModelError(
                f"View: sketches {self.sketches!r:.60} are not a list of Sketch, Box, Cylinder or Mesh; give one"
            )


def view_of(given: View | None, owner: str) -> View:
    """Return the view, by default one without options; a ModelError for anything else."""
    if given is None:
        return View()
    if not isinstance(given, View):
        raise ModelError(
            f"{owner}: view {given!r:.60} is not a View; write view=fx.View(elevation=30, azimuth=-70)"
        )
    return given


@contextmanager
def canvas(state: State, size: tuple[float, float] = (7.0, 5.0)) -> Iterator[tuple[Figure, Any]]:
    """Make a figure with one set of axes: plain for a planar model, else spatial and filling the figure."""
    if drawing.planar(state):
        with figure(size=size) as (drawn, axes):
            yield drawn, axes
        return
    with figure(0, size=size) as (drawn, _):
        yield drawn, drawn.add_axes((0, 0, 1, 1), projection="3d")


def draw(
    state: State, axes: Any = None, view: View | None = None, trails: Mapping[str, Array] | None = None
) -> Any:
    """Draw a mechanism at a state: bars, beams, wheels, bodies, points and the road.

    Parameters
    ----------
    axes : matplotlib axes, optional
        Three-dimensional, or plain for a planar model; created if missing.
    view : View, optional
    trails : mapping of str to ndarray (k, 3)
        Tracks to draw, in global axes.

    Returns
    -------
    axes

    Examples
    --------
    >>> draw(motion[-1], view=View(azimuth=-70)).figure.savefig("end.png")  # doctest: +SKIP
    """
    view = view_of(view, "draw")
    flat = drawing.planar(state)
    if axes is None:
        with canvas(state) as (_, axes):
            pass
    parts = drawing.shapes(state, view.sketches)
    R = display_axes(drawing.upward(state) if view.up is None else np.asarray(view.up, dtype=float))
    centre, span = _window(state, view, parts)
    if not flat:
        if view.ground:
            for normal, height in drawing.roads(state):
                _ground(axes, R, normal, height, centre, span)
        axes.view_init(view.elevation, view.azimuth)
    turn = np.eye(3) if flat else R
    for track in (trails or {}).values():
        axes.plot(*(track @ turn.T).T[: 2 if flat else 3], color="#2e8540", lw=1.2, zorder=1, clip_on=False)
    for order, (style, (colour, width, mark)) in enumerate(PAINT.items(), start=2):
        dyes: dict[tuple[str, float], list[Array]] = {}
        for part in (part for part in parts if part.style == style):
            own = dyes.setdefault((part.colour or colour, part.opacity), [])
            own += [line @ turn.T for line in _lines(part)]
        for dye, lines in dyes.items():
            _paint(axes, flat, lines, dye, width, mark, order)
    _limits(axes, flat, turn @ centre, span)
    return axes


def display_axes(up: Array) -> Array:
    """Return the rotation (3, 3) from global axes to the picture's, whose z axis is `up`, with x changed least."""
    e_z = up / np.linalg.norm(up)
    start = np.eye(3)[0 if abs(e_z[0]) < 0.9 else 1]
    e_x = start - (start @ e_z) * e_z
    e_x /= np.linalg.norm(e_x)
    return np.array([e_x, np.cross(e_z, e_x), e_z])


def _window(state: State, view: View, parts: Sequence[drawing.Shape]) -> tuple[Array, float]:
    """Return centre and width of the visible region."""
    places = painted(parts)
    low, high = places.min(axis=0), places.max(axis=0)
    centre = (low + high) / 2
    if isinstance(view.centre, str):
        place = state.position(view.centre)
        centre[: place.size] = place
    elif view.centre is not None:
        centre = np.asarray(view.centre, dtype=float)
    return centre, view.span or 1.1 * max(float(np.max(high - low)), 1e-9)


def painted(parts: Sequence[drawing.Shape]) -> Array:
    """Return all vertices (..., k, 3) that are painted.

    Raises
    ------
    ModelError
        If there are none.
    """
    lines = [line for part in parts if part.style in PAINT for line in part.lines]
    if not lines:
        raise ModelError(
            "nothing to draw: no part of the model has a position; give it points, or plot its values: motion.plot(…)"
        )
    return np.concatenate(lines, axis=-2)


def _lines(part: drawing.Shape) -> tuple[Array, ...]:
    """Return polylines of a part as they are painted: springs as zigzags, tyres where they are widest."""
    if part.style == "spring":
        return (zigzag(part.lines[0]),)
    if part.style == "tyre" and part.pose is not None and part.outline is not None:
        arms = part.lines[0] - part.pose[0]
        return (part.lines[0] + float(part.outline[:, 1].max()) * arms / np.linalg.norm(arms[0]),)
    return part.lines


def _paint(
    axes: Any, flat: bool, lines: list[Array], dye: tuple[str, float], width: float, mark: str, order: int
) -> None:
    """Draw all lines or marks of one style, colour and opacity at once."""
    colour, opacity = dye
    if mark:
        points = np.vstack(lines).T[: 2 if flat else 3]
        options = {
            "linestyle": "",
            "marker": mark,
            "ms": width,
            "color": colour,
            "alpha": opacity,
            "mec": "#222222",
            "mew": 0.8,
        }
        axes.plot(*points, zorder=order, **options)
    elif flat:
        from matplotlib.collections import LineCollection

        axes.add_collection(
            LineCollection(
                [line[:, :2] for line in lines], colors=colour, alpha=opacity, lw=width, zorder=order
            )
        )
    else:
        _spatial_lines(axes, lines, colour, width, order, opacity)


def _spatial_lines(
    axes: Any, lines: list[Array], colour: str, width: float, order: int, opacity: float = 1.0
) -> None:
    from mpl_toolkits.mplot3d.art3d import Line3DCollection  # type: ignore[import-untyped]

    collection = Line3DCollection(lines, colors=colour, alpha=opacity, lw=width, zorder=order, clip_on=False)
    axes.add_collection3d(collection, autolim=False)


def _ground(axes: Any, R: Array, normal: Array, height: float, centre: Array, span: float) -> None:
    """Draw a grid with round steps on a road, fixed to the ground, clipped at the edge of the window."""
    T = display_axes(normal)  # rows: two directions in the road, and its normal
    step = 10.0 ** np.floor(np.log10(span / 2.0))
    step *= next(factor for factor in (1, 2, 5, 10) if span / (step * factor) <= 9)
    (a0, b0), (a1, b1) = (T @ centre)[:2] - 0.7 * span, (T @ centre)[:2] + 0.7 * span
    lines = [[(a, b0, height), (a, b1, height)] for a in step * np.arange(np.ceil(a0 / step), a1 / step)]
    lines += [[(a0, b, height), (a1, b, height)] for b in step * np.arange(np.ceil(b0 / step), b1 / step)]
    _spatial_lines(axes, [np.array(line) @ T @ R.T for line in lines], "#cfd6dc", 0.7, 0)


def _limits(axes: Any, flat: bool, centre: Array, span: float) -> None:
    """Set equal scales around the centre; a spatial picture without box and ticks."""
    axes.set_xlim(centre[0] - span / 2, centre[0] + span / 2)
    axes.set_ylim(centre[1] - span / 2, centre[1] + span / 2)
    if flat:
        axes.set_aspect("equal")
        axes.set_xlabel("x [m]")
        axes.set_ylabel("y [m]")
    else:
        axes.set_zlim(centre[2] - span / 2, centre[2] + span / 2)
        axes.set_box_aspect((1, 1, 1), zoom=1.9)
        axes.set_axis_off()
        axes.computed_zorder = False
