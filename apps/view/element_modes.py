"""Draws an element and its modes: its nodes and triads, and its shape moved along each deformation and slip.

Coordinates, deformations, slips and shapes all come from the element's page, by its compiled kernels.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from flexel.apps.view import drawing
from flexel.apps.view.deflected import EDGE, GREY, at_coordinates
from flexel.apps.view.figures import COLOURS, figure, save, unit_text
from flexel.apps.view.poses import Poses
from flexel.apps.view.primitives import edges, extent
from flexel.apps.view.scene import PAINT, View, display_axes, view_of
from flexel.base.arrays import Array, Index
from flexel.base.shown import prints
from flexel.model.instances import Instance
from flexel.model.state import State

if TYPE_CHECKING:
    from matplotlib.figure import Figure

AMOUNT = 0.35  # of a deformation or slip that is shown: times the size of the model if it is a length, else in its unit
# Weight of a rotation by 1 rad, relative to a displacement by the size of the model: ends turn rather than move apart
# where an element deforms, and a wheel slides rather than turns where it slips.
DEFORMING, SLIDING = 0.1, 10.0
STEPS = 20  # in which coordinates are moved
CORRECTIONS = 5  # Newton steps after the last of them
NEGLIGIBLE = 1e-9  # singular values, relative to the largest
TRIAD = 0.22  # length of the arms of a triad, relative to the size of the model
ARMS = (COLOURS[1], COLOURS[2], COLOURS[3])  # colours of x, y and z
SHAPE, SLIPPING = COLOURS[0], COLOURS[4]  # colours of an element that is deformed, and of one that slips
PANEL_IN = 2.3  # width of a panel [in]
ZOOM, SPATIAL = 1.25, 0.65  # of spatial panels: enlargement, height over width
TITLES_IN = 0.45  # height of the title of a panel, and of that of the figure [in]


@dataclass(frozen=True)
class Counts:
    """The modes of an element, counted by the ranks of its matrices.

    Attributes
    ----------
    coordinates : int
        Of its nodes.
    deformations, norms, slips : int
        Independent deformations, norms of Euler parameters, and slips that are zero by default.
    left : int
        Independent motions that change none of them; without slips, these are the rigid motions.
    """

    coordinates: int
    deformations: int
    norms: int
    slips: int
    left: int

    @prints
    def __str__(self) -> str:
        parts = {"deformation": self.deformations, "norm": self.norms, "slip": self.slips}
        words = " + ".join(f"{count} {word}{'s' * (count != 1)}" for word, count in parts.items() if count)
        return f"{self.coordinates} − {self.left} = {words}"


@dataclass(frozen=True)
class ElementMode:
    """An element moved along one of its deformations or slips.

    Attributes
    ----------
    name, unit : str
        Of the deformation or slip.
    amount : float
        Value of the deformation, or integral of the slip.
    slip : bool
    state : State
        With the moved coordinates, for drawing only.
    """

    name: str
    unit: str
    amount: float
    slip: bool
    state: State


def element_counts(state: State, element: str) -> Counts:
    """Count coordinates, independent modes and the motions that are left, at a state of any model with the element."""
    rows = _Rows.of(state, element)
    J = state.J[:, rows.columns]
    slips = [i for i, slip in zip(rows.slips, rows.instance.spec.slips, strict=True) if not slip.free]
    deformations, norms = _rank(J[rows.deformations]), _rank(J[[*rows.deformations, *rows.norms]])
    all_rows = _rank(J[[*rows.deformations, *rows.norms, *slips]])
    n = rows.columns.size
    return Counts(n, deformations, norms - deformations, all_rows - norms, n - all_rows)


def element_modes(state: State, element: str, amount: float = AMOUNT) -> list[ElementMode]:
    """Move an element along each of its deformations, then along each of its slips.

    While one of them grows, the others keep their values, or are zero if they are slips. Of all motions with this
    property the smallest is taken. Displacements count more than rotations in it, and less if it is a slip.

    Parameters
    ----------
    state : State
    element : str
    amount : float
        How far it is moved: times the size of the model if the deformation is a length, else in its unit.
    """
    rows, size = _Rows.of(state, element), extent(state.structure)
    spec, found = rows.instance.spec, []
    named = [(i, d.name, d.unit, False) for i, d in enumerate(spec.deformations)]
    named += [(i, slip.name, slip.unit, True) for i, slip in enumerate(spec.slips)]
    for i, name, unit, slips in named:
        change = amount * (size if unit in ("m", "m/s") else 1.0)
        moved = at_coordinates(state, _moved(state, rows, i, slips, change))
        found.append(ElementMode(name, unit, change, slips, moved))
    return found


def plot_element(
    state: State,
    element: str,
    path: str | Path | None = None,
    *,
    amount: float = AMOUNT,
    view: View | None = None,
    columns: int = 4,
) -> Figure:
    """Draw an element with its nodes and triads, and moved along each of its deformations and slips.

    Parameters
    ----------
    state : State
        Of any model with the element; the rest of the model is drawn too.
    element : str
    path : str or Path, optional
        File to write.
    amount : float
        See `element_modes`.
    view : View, optional
        View direction, up and sketches.
    columns : int
        Panels in a row.

    Returns
    -------
    matplotlib.figure.Figure
    """
    view, modes = view_of(view, "plot_element"), element_modes(state, element, amount)
    instance, flat = state.structure.element(element), drawing.planar(state)
    columns = min(columns, len(modes) + 1)
    rows = -(-(len(modes) + 1) // columns)
    options: dict[str, Any] = {} if flat else {"subplot_kw": {"projection": "3d"}}
    with figure(rows, columns, squeeze=False, **options) as (drawn, grid):
        pen = _Pen(state, view, flat)
        first, *others = grid.flat
        pen.element(first, state, SHAPE)
        pen.triads(first, state, instance, named=True)
        first.set_title("as drawn")
        for axes, mode in zip(others, modes, strict=False):
            pen.element(axes, state, GREY)
            pen.element(axes, mode.state, SLIPPING if mode.slip else SHAPE)
            pen.triads(axes, mode.state, instance)
            axes.set_title(f"{'slip ' * mode.slip}{mode.name} {unit_text(mode.unit)}")
        height = pen.frame(list(grid.flat))
        total = (height + TITLES_IN) * rows + TITLES_IN
        drawn.set_size_inches(PANEL_IN * columns, total)
        if not flat:  # lines may leave their spatial axes, which no layout of matplotlib allows
            drawn.set_layout_engine("none")
            for i, axes in enumerate(grid.flat):
                bottom = (rows - 1 - i // columns) * (height + TITLES_IN)
                axes.set_position((i % columns / columns, bottom / total, 1 / columns, height / total))
        drawn.suptitle(f"{instance.spec.name}: {element_counts(state, element)}")
        save(drawn, path)
    return drawn


@dataclass(frozen=True)
class _Rows:
    """Where an element stands in the matrices of a model: its columns in x, its rows in J."""

    instance: Instance
    columns: Index  # of its nodes' coordinates
    angles: Array  # by which they turn a node, per unit; zero of points
    deformations: list[int]
    norms: list[int]
    slips: list[int]

    @staticmethod
    def of(state: State, element: str) -> _Rows:
        """Find the rows and columns of an element."""
        s = state.structure
        instance = s.element(element)
        nodes = [s.node(name) for name in instance.nodes]
        norms = [
            s.index[name]
            for other in s.instances
            if other.spec.family == "norm" and other.nodes[0] in instance.nodes
            for name in other.deformations
        ]
        angles = [np.full(node.x0.size, _angle(node.kind)) for node in nodes]
        return _Rows(
            instance,
            np.concatenate([s.places(node.name) for node in nodes]),
            np.concatenate(angles),
            [s.index[name] for name in instance.deformations],
            norms,
            [s.index[name] for name in instance.slips],
        )


def _angle(kind: str) -> float:
    """Return the angle by which a node turns per change of its coordinates: of Euler parameters twice as much."""
    return 0.0 if kind.endswith("point") else 2.0 if kind == "frame" else 1.0


def _moved(state: State, rows: _Rows, i: int, slip: bool, amount: float) -> Array:
    """Return coordinates (n,) at which deformation or slip i has grown by an amount, and no other."""
    held = [*rows.deformations, *rows.norms]
    turn = (SLIDING if slip else DEFORMING) * extent(state.structure)
    weights = np.where(rows.angles > 0, turn * rows.angles, 1.0)
    x, start = state.x.copy(), state.evaluation.position(state.x)[0][held]
    goal = np.zeros(len(held) + len(rows.slips))
    goal[len(held) + i if slip else i] = amount
    for step in range(1, STEPS + CORRECTIONS + 1):
        part = min(step / STEPS, 1.0)
        e, J = state.evaluation.position(x)
        change = part * goal
        change[: len(held)] -= e[held] - start
        change[len(held) :] = goal[len(held) :] / STEPS if step <= STEPS else 0.0
        A = J[[*held, *rows.slips]][:, rows.columns] / weights
        x[rows.columns] += np.linalg.lstsq(A, change, rcond=NEGLIGIBLE)[0] / weights
    return x


def _rank(rows: Array) -> int:
    """Return the number of independent rows."""
    if not rows.size:
        return 0
    values = np.linalg.svd(rows / np.linalg.norm(rows, axis=1, keepdims=True), compute_uv=False)
    return int(np.sum(values > NEGLIGIBLE * values[0]))


class _Pen:
    """Draws on the panels of one figure, and keeps what they have to show."""

    def __init__(self, state: State, view: View, flat: bool) -> None:
        self._view, self._flat, self._arm = view, flat, TRIAD * extent(state.structure)
        up = drawing.upward(state) if view.up is None else np.asarray(view.up, dtype=float)
        self._turn = np.eye(3) if flat else display_axes(up)
        self._places: list[Array] = []

    def _seen(self, line: Array) -> Array:
        """Return places (dimension, k) as axes take them."""
        shown = line @ self._turn.T
        self._places.append(shown)
        return shown.T[: 2 if self._flat else 3]

    def element(self, axes: Any, state: State, colour: str) -> None:
        """Draw all lines of the model in one colour, and its points."""
        for part in drawing.shapes(state, self._view.sketches):
            if part.style not in PAINT:
                continue
            width = max(PAINT[part.style][1] - 0.6, 0.6)
            for lines, lw in ((part.lines, width), (edges(part), EDGE)):
                for line in lines:
                    mark = {} if len(line) > 1 else {"marker": "o", "ms": 3.5}
                    axes.plot(*self._seen(line), color=colour, lw=lw, clip_on=False, **mark)

    def triads(self, axes: Any, state: State, instance: Instance, named: bool = False) -> None:
        """Draw the triads of an element's nodes, with the names of nodes and arms if wanted."""
        s, poses, up = state.structure, Poses(state), self._turn[1 if self._flat else 2]
        for origin, nodes in _places(state, instance):
            turning = [node for node in nodes if s.node(node).kind in ("frame", "planar_angle")]
            for node, style in zip(turning, ("-", ":"), strict=False):
                arms = poses.axes(node).T[: 2 if self._flat else 3]
                for letter, arm, colour in zip("xyz", arms, ARMS, strict=False):
                    end = origin + self._arm * arm
                    axes.plot(
                        *self._seen(np.array([origin, end])), style, color=colour, lw=1.3, clip_on=False
                    )
                    if named and style == "-":
                        self._text(axes, end + 0.3 * self._arm * arm, letter, colour)
            if named:
                self._text(axes, origin - 0.4 * self._arm * up, ", ".join(nodes), "black")

    def _text(self, axes: Any, where: Array, words: str, colour: str) -> None:
        axes.text(*self._seen(where[None])[:, 0], words, color=colour, ha="center", va="center", fontsize=9)

    def frame(self, grid: Sequence[Any]) -> float:
        """Give all panels the same window, without axes; return the height of a panel [in]."""
        places = np.vstack(self._places)
        low, high = places.min(axis=0), places.max(axis=0)
        centre, half = (low + high) / 2, 0.52 * np.maximum(high - low, 0.1 * np.max(high - low))
        for axes in grid:
            axes.set_xlim(centre[0] - half[0], centre[0] + half[0])
            axes.set_ylim(centre[1] - half[1], centre[1] + half[1])
            if not self._flat:
                axes.set_zlim(centre[2] - half[2], centre[2] + half[2])
                axes.set_box_aspect(tuple(half), zoom=ZOOM)
                axes.view_init(self._view.elevation, self._view.azimuth)
            else:
                axes.set_aspect("equal")
            axes.set_axis_off()
        return PANEL_IN * (float(half[1] / half[0]) if self._flat else SPATIAL)


def _places(state: State, instance: Instance) -> Iterator[tuple[Array, list[str]]]:
    """Yield places of an element's nodes, with the names of a point and of the orientation that follows it.

    Orientations without a point are at the first point of the model, or at the origin, all together.
    """
    s, named, place = state.structure, list(instance.nodes), Poses(state).place
    points = [node.name for node in s.nodes if node.kind.endswith("point")]
    somewhere = place(points[0]) if points else np.zeros(3)
    while named:
        nodes = [named.pop(0)]
        while named and not s.node(named[0]).kind.endswith("point"):
            nodes.append(named.pop(0))
        yield (place(nodes[0]) if s.node(nodes[0]).kind.endswith("point") else somewhere), nodes
