"""Prepares the data of the viewer as plain JSON: the shapes of `flexel.apps.view.drawing` over the frames.

A rigid part is stored as its lines once and a pose for each frame; a deforming one as its vertices for each
frame. Numbers are Float32, little-endian, in base64; constant data is stored once.
"""

from __future__ import annotations

import base64
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from flexel.apps.view import drawing
from flexel.apps.view.page.packing import packed, rounded
from flexel.apps.view.page.series import floors, histories
from flexel.apps.view.primitives import UNITS, Shape, extent, lowest
from flexel.apps.view.scene import PAINT, View, display_axes, painted
from flexel.apps.view.spring_painters import united
from flexel.apps.view.wavy_roads import wavy_roads
from flexel.base.arguments import quantities
from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.base.progress import followed, seen
from flexel.base.quaternions import from_matrix
from flexel.model.state import State

if TYPE_CHECKING:
    from flexel.integration.trajectory import Trajectory

FORMAT = 2
FRAMES = 301
COLOURS = {style: paint[0] for style, paint in PAINT.items()}
COLOURS |= {
    "box": "#8fa3b3",
    "force": "#d4351c",
    "load": "#7b3f98",
    "joint": "#f0f3f5",
    "sketch": "#8fa3b3",
    "ground": "#c9d0d6",
}
WINDOW = 4.0  # the camera follows motions that go farther than this many times the model's size


def scene_data(
    motion: Trajectory,
    *,
    frames: int = FRAMES,
    between: tuple[float, float] | None = None,
    view: View | None = None,
    title: str = "",
    caption: str = "",
    plots: Sequence[str] | None = None,
    slower: float | None = None,
    progress: bool | None = None,
) -> dict[str, Any]:
    """Return all data that the viewer needs to show a motion, in a form that can be saved to a file.

    Parameters
    ----------
    frames : int
        Equally spaced in time; for a motion without dense output, that many of its stored states.
    between : (start, end), optional
        Times [s] of the part to show; all by default.
    view : View, optional
        Camera, window, node to follow, trails and sketches.
    title, caption : str
        Written above the picture; the title is the time of the motion by default.
    plots : sequence of str, optional
        Quantities in the plot strip when the page opens, by the names of `Motion.series`; three degrees of freedom by
        default.  The page offers more.
    slower : float, optional
        Seconds of picture per second of motion; by default chosen so that the motion can be followed.
    progress : bool, optional
        Progress bar on stderr; by default where stderr is a terminal.

    Returns
    -------
    dict
        Numbers, text, lists and dicts only; `flexel.apps.view.page.page` makes the page from it.

    Raises
    ------
    ModelError
        If the motion has no states in this time, or the view names a node that does not exist.
    """
    states = _sampled(motion, frames, between)
    view = view or View()
    asked = None if plots is None else quantities(plots, "view: plots")
    for name in (*view.trails, *([view.centre] if isinstance(view.centre, str) else [])):
        states[0].structure.node(name)
    steps = followed(states, seen(progress, "view"), len(states), "frame")
    applied = _loads(motion)
    table = [drawing.shapes(state, view.sketches) + applied(state) for state in steps]
    times = [round(state.t, 9) for state in states]
    speed = _speed(times[-1] - times[0]) if slower is None else 1 / slower
    title = title or f"Motion from {times[0]:.4g} to {times[-1]:.4g} s"
    found = common(states[0], table, view, title, caption) | {"times": times, "speed": speed}
    found["floors"] = floors(states, table, found["size"])
    found["plots"] = _packed_rows(histories(states, asked))
    found["digits"] = int(np.clip(2 - np.floor(np.log10(max(times[-1] - times[0], 1e-6))), 0, 6))
    ground = list(wavy_roads(states))
    if ground:
        found["floor"] = None
    found["shapes"] = [part([shape]) for shape in ground] + [
        part(_whole(column)) for column in zip(*table, strict=True) if _acts(column)
    ]
    return found


def _loads(motion: Trajectory) -> Callable[[State], list[Shape]]:
    """Return arrows of the loads at a state; a motion from a file has lost its loads."""
    system = motion._system
    if system is None or not system.loads.any:
        return lambda _: []
    return lambda state: drawing.loads(state, system.loads)


def _packed_rows(found: dict[str, Any]) -> dict[str, Any]:
    """Return histories with their values as text."""
    rows = [row | {"values": packed([row["values"]])} for row in found["rows"]]
    return found | {"rows": rows}


def _whole(column: Sequence[Shape]) -> Sequence[Shape]:
    """Return the shapes drawn once for all frames: guides."""
    return united(list(column)) if column[0].style == "guide" else column


def _sampled(motion: Trajectory, frames: int, between: tuple[float, float] | None) -> list[State]:
    """Return the states to show."""
    if not isinstance(frames, (int, np.integer)) or frames < 2:
        raise ModelError(f"view: frames is {frames!r}; give a whole number, 2 or more")
    start, end = between or (float(motion.t[0]), float(motion.t[-1]))
    if motion.dense and end > start:
        return [motion.at(float(t)) for t in np.linspace(start, end, frames)]
    kept = [state for state in motion if start <= state.t <= end]
    if not kept:
        raise ModelError(f"view: the motion has no states from {start:g} to {end:g} s; change between=")
    shown = np.unique(np.round(np.linspace(0, len(kept) - 1, min(frames, len(kept)))).astype(int))
    return [kept[i] for i in shown]


def _acts(column: Sequence[Shape]) -> bool:
    """Whether a shape is ever visible: contacts that never close are not."""
    return column[0].style not in ("force", "load") or any(np.any(shape.force) for shape in column)


def _speed(duration: float) -> float:
    """Return the speed 1, 2 or 5 times a power of ten at which a motion takes about ten seconds; 1 if suitable."""
    if 1.0 <= duration <= 60.0 or duration <= 0:
        return 1.0
    wanted = duration / 10
    power = 10.0 ** np.floor(np.log10(wanted))
    return float(
        f"{power * max(factor for factor in (1, 2, 5) if power * factor <= wanted * (1 + 1e-9)):.6g}"
    )


def common(
    state: State, table: Sequence[Sequence[Shape]], view: View, title: str, caption: str
) -> dict[str, Any]:
    """Return data that belong to no part: axes, camera, roads, colours, size.

    Parameters
    ----------
    state : State
    table : sequence of sequences of Shape
        Shapes of the parts at each frame.
    view : View
    title, caption : str
    """
    flat = drawing.planar(state)
    up = drawing.upward(state) if view.up is None else np.asarray(view.up, dtype=float)
    axes = np.array([(1.0, 0, 0), (0, 0, -1), (0, 1, 0)]) if flat else display_axes(up)
    size = extent(state.structure)
    roads = drawing.roads(state) if view.ground else []
    return {
        "format": FORMAT,
        "title": title,
        "caption": caption,
        "axes": rounded(axes),
        "size": float(f"{size:.6g}"),
        "colours": COLOURS,
        "units": UNITS,
        "roads": [{"axes": rounded(display_axes(n)), "height": height} for n, height in roads],
        "floor": _floor(state, table, up, size) if view.ground and not roads and not flat else None,
        "camera": _camera(table, view, flat, size),
        "trails": list(view.trails),
        "modes": [],
        "floors": {},
        "plots": {"shown": [], "rows": []},
    }


def _floor(state: State, table: Sequence[Sequence[Shape]], up: Array, size: float) -> dict[str, Any] | None:
    """Return a floor below all painted shapes, if there is gravity; for display only."""
    if not any(np.any(instance.parameters.get("gravity", 0.0)) for instance in state.structure.instances):
        return None
    low = min(lowest(shape, up) for shapes in table for shape in shapes if shape.style in PAINT)
    return {"axes": rounded(display_axes(up)), "height": float(f"{low - 0.02 * size:.6g}")}


def _camera(table: Sequence[Sequence[Shape]], view: View, flat: bool, size: float) -> dict[str, Any]:
    """Return the initial position of the camera, and the object it follows."""
    places = np.vstack([painted(shapes) for shapes in table])
    low, high = places.min(axis=0), places.max(axis=0)
    near = 1.15 * max(float(np.max(np.ptp(painted(table[0]), axis=0))), size)
    span, follow = max(1.15 * float(np.max(high - low)), near), ""
    if isinstance(view.centre, str):
        follow, span = view.centre, near
    elif view.centre is None and span > WINDOW * near:
        follow, span = _mover(table), near
    centre = (low + high) / 2 if view.centre is None or follow else np.asarray(view.centre, dtype=float)
    return {
        "azimuth": -90.0 if flat else view.azimuth,
        "elevation": 0.0 if flat else view.elevation,
        "centre": rounded(centre),
        "span": float(f"{view.span or span:.6g}"),
        "fit": view.span is None and (view.centre is None or bool(follow)),
        "follow": follow,
    }


def _mover(table: Sequence[Sequence[Shape]]) -> str:
    """Return the mark that moves farthest."""
    ends = [(b.name, float(np.linalg.norm(b.lines[0] - a.lines[0]))) for a, b in zip(table[0], table[-1], strict=True)
            if b.style in ("joint", "mass")]  # fmt: skip
    return max(ends, key=lambda end: end[1])[0] if ends else ""


def part(shapes: Sequence[Shape]) -> dict[str, Any]:
    """Return one part over all frames."""
    first = shapes[0]
    found: dict[str, Any] = {
        "style": first.style,
        "name": first.name,
        "counts": [len(line) for line in first.lines],
        "rigid": first.pose is not None,
        "data": packed([numbers(shape) for shape in shapes]),
        "values": {
            name: {"count": int(np.size(value)), "data": packed([shape.values[name] for shape in shapes])}
            for name, value in first.values.items()
        },
    }
    if first.outline is not None:
        found["outline"] = rounded(first.outline)
    if first.colour is not None:
        found["colour"] = first.colour
    if first.opacity < 1:
        found["opacity"] = first.opacity
    if first.surface is not None:
        vertices, triangles = first.surface
        found["surface"] = packed([vertices])
        found["triangles"] = base64.b64encode(triangles.astype("<u4").tobytes()).decode()
    if first.pose is not None:
        origin, R = first.pose
        found["local"] = packed([(np.vstack(first.lines) - origin) @ R])
    if first.across is not None:
        found["across"] = packed([shape.across if shape.pose is None else _local(shape) for shape in shapes])
    if first.force is not None:
        found["force"] = packed([shape.force for shape in shapes])
    return found


def _local(shape: Shape) -> Array:
    """Return the section's directions in the body's axes."""
    assert shape.pose is not None and shape.across is not None
    return np.asarray(shape.across @ shape.pose[1])


def numbers(shape: Shape) -> Array:
    """Return the moving data of a shape: its pose (position and quaternion), or its vertices."""
    if shape.pose is None:
        return np.vstack(shape.lines).ravel()
    origin, R = shape.pose
    return np.concatenate([origin, from_matrix(R)])
