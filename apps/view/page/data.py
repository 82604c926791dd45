"""Prepares the data of the viewer as plain JSON: the shapes of `flexel.apps.view.drawing` over the frames.

A rigid part is stored as its lines once and a pose for each frame; a deforming one as its vertices for each
frame. Numbers are Float32, little-endian, in base64; constant data is stored once.
"""

from __future__ import annotations

import base64
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from scipy.spatial.transform import Rotation

from flexel.apps.view import drawing
from flexel.apps.view.figures import caption as printable
from flexel.apps.view.options import span_of
from flexel.apps.view.page.packing import packed, rounded
from flexel.apps.view.page.series import floors, histories
from flexel.apps.view.primitives import UNITS, Shape, extent, lowest
from flexel.apps.view.scene import PAINT, View, display_axes, painted, view_of
from flexel.apps.view.spring_painters import united
from flexel.apps.view.wavy_roads import wavy_roads
from flexel.base.arguments import names, positive, whole
from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.base.progress import followed, seen
from flexel.model.state import State

if TYPE_CHECKING:
    from flexel.integration.trajectory import Trajectory

FORMAT = 3
FRAMES = 301
MAX_FRAMES = 100_000  # more than an hour of pictures; a page of more opens in no browser
COLOURS = {style: paint[0] for style, paint in PAINT.items()}
COLOURS |= {
    "box": "#8fa3b3",
    "force": "#d4351c",
    "load": "#7b3f98",
    "joint": "#f0f3f5",
    "sketch": "#8fa3b3",
    "ground": "#c9d0d6",
}
MECHANISM = "the mechanism"  # its middle is followed
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
    frames, between, view, title, caption, plots, slower, progress
        As for `Motion.view`.

    Returns
    -------
    dict
        Numbers, text, lists and dicts only; `flexel.apps.view.page.page` makes the page from it.

    Raises
    ------
    ModelError
        If the motion has no states in this time, or the view names a node that does not exist.
    """
    states = _sampled(motion, frames, between, seen(progress, "view"))
    view = view_of(view, "view")
    asked = None if plots is None else names(plots, "view: plots")
    for node in (*view.trails, *([view.centre] if isinstance(view.centre, str) else [])):
        states[0].structure.node(node)
    shapes = drawing.shapes(states, view.sketches) + _loads(motion, states)
    times = [round(state.t, 9) for state in states]
    speed = _speed(times[-1] - times[0]) if slower is None else 1 / positive(slower, "view", "slower")
    of = ("Motion", " s") if motion.over_time else ("Load parameter", "")
    title = printable(title, "view") or f"{of[0]} from {times[0]:.4g} to {times[-1]:.4g}{of[1]}"
    found = common(states[0], shapes, view, title, printable(caption, "view", "caption")) | {
        "times": times,
        "speed": speed,
    }
    found["clock"] = (
        {"name": "time", "unit": "s"} if motion.over_time else {"name": "load parameter", "unit": ""}
    )
    found["floors"] = floors(states, shapes, found["size"])
    found["plots"] = _packed_rows(histories(states, asked))
    found["digits"] = int(np.clip(2 - np.floor(np.log10(max(times[-1] - times[0], 1e-6))), 0, 6))
    ground = list(wavy_roads(states))
    if ground:
        found["floor"] = None
    found["shapes"] = [part(shape) for shape in ground] + [
        part(united(shape) if shape.style == "guide" else shape) for shape in shapes if _acts(shape)
    ]
    return found


def _loads(motion: Trajectory, states: Sequence[State]) -> list[Shape]:
    """Return arrows of the loads at states; a motion from a file has lost its loads."""
    system = motion._system
    return drawing.loads(states, system.loads) if system is not None and system.loads.any else []


def _packed_rows(found: dict[str, Any]) -> dict[str, Any]:
    """Return histories with their values as text."""
    rows = [row | {"values": packed([row["values"]])} for row in found["rows"]]
    return found | {"rows": rows}


def _sampled(motion: Trajectory, frames: int, between: tuple[float, float] | None, bar: bool) -> list[State]:
    """Return the states to show."""
    frames = whole(frames, "view", "frames", 2, MAX_FRAMES)
    start, end = span_of(motion, between, "view")
    if motion.interpolates and end > start:
        return [motion.at(float(t)) for t in followed(np.linspace(start, end, frames), bar, frames, "frame")]
    kept = [state for state in motion if start <= state.t <= end]
    if not kept:
        raise ModelError(f"view: the motion has no states from {start:g} to {end:g} s; change between=")
    shown = np.unique(np.round(np.linspace(0, len(kept) - 1, min(frames, len(kept)))).astype(int))
    return [kept[i] for i in shown]


def _acts(shape: Shape) -> bool:
    """Whether a shape is ever visible: contacts that never close are not."""
    return shape.style not in ("force", "load") or bool(np.any(shape.force))


def _speed(duration: float) -> float:
    """Return the speed 1, 2 or 5 times a power of ten at which a motion takes about ten seconds; 1 if suitable."""
    if 1.0 <= duration <= 60.0 or duration <= 0:
        return 1.0
    wanted = duration / 10
    power = 10.0 ** np.floor(np.log10(wanted))
    return float(
        f"{power * max(factor for factor in (1, 2, 5) if power * factor <= wanted * (1 + 1e-9)):.6g}"
    )


def common(state: State, shapes: Sequence[Shape], view: View, title: str, caption: str) -> dict[str, Any]:
    """Return data that belong to no part: axes, camera, roads, colours, size.

    Parameters
    ----------
    state : State
    shapes : sequence of Shape
        Of the parts, in one state or over the frames.
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
        "floor": _floor(state, shapes, up, size) if view.ground and not roads and not flat else None,
        "camera": _camera(shapes, view, flat, size),
        "trails": list(view.trails),
        "modes": [],
        "floors": {},
        "plots": {"shown": [], "rows": []},
        "clock": {"name": "time", "unit": "s"},
        "colour": _colour(shapes),
    }


def _colour(shapes: Sequence[Shape]) -> str:
    """Return the value by which flexible parts are coloured when the page opens: of beams, else of ropes; or none."""
    lines = [shape for shape in shapes if shape.style in ("beam", "rope")]
    for name in ("normal stress", "bending moment", "tension"):
        if any(name in shape.values for shape in lines):
            return name
    return ""


def _floor(state: State, shapes: Sequence[Shape], up: Array, size: float) -> dict[str, Any] | None:
    """Return a floor below all painted shapes, if there is gravity; for display only."""
    if not any(np.any(instance.parameters.get("gravity", 0.0)) for instance in state.structure.instances):
        return None
    low = min(lowest(shape, up) for shape in shapes if shape.style in PAINT)
    return {"axes": rounded(display_axes(up)), "height": float(f"{low - 0.02 * size:.6g}")}


def _camera(shapes: Sequence[Shape], view: View, flat: bool, size: float) -> dict[str, Any]:
    """Return the initial position of the camera, and the object it follows."""
    places = painted(shapes)
    first, places = places.reshape(-1, *places.shape[-2:])[0], places.reshape(-1, 3)
    low, high = places.min(axis=0), places.max(axis=0)
    near = 1.15 * max(float(np.max(np.ptp(first, axis=0))), size)
    span, follow = max(1.15 * float(np.max(high - low)), near), ""
    if isinstance(view.centre, str):
        follow, span = view.centre, near
    elif view.centre is None and span > WINDOW * near:
        follow, span = MECHANISM, near
    centre = (low + high) / 2 if view.centre is None or follow else np.asarray(view.centre, dtype=float)
    return {
        "azimuth": -90.0 if flat else view.azimuth,
        "elevation": 0.0 if flat else view.elevation,
        "centre": rounded(centre),
        "span": float(f"{view.span or span:.6g}"),
        "fit": view.span is None and (view.centre is None or bool(follow)),
        "follow": follow,
        "path": packed(_middle(shapes)),
    }


def _middle(shapes: Sequence[Shape]) -> Array:
    """Return the middle (states, 3) of all parts that are painted and not fixed."""
    places = painted([shape for shape in shapes if shape.style not in ("fixed", "guide")] or shapes)
    places = places.reshape(-1, *places.shape[-2:])
    return np.asarray((places.min(axis=1) + places.max(axis=1)) / 2)


def part(shape: Shape) -> dict[str, Any]:
    """Return one part, in one state or over the frames."""
    found: dict[str, Any] = {
        "style": shape.style,
        "name": shape.name,
        "counts": [line.shape[-2] for line in shape.lines],
        "rigid": shape.pose is not None,
        "data": packed(_rows(numbers(shape), 1)),
        "values": {
            name: {"count": value.shape[-1], "data": packed(_rows(value, 1))}
            for name, value in shape.values.items()
        },
    }
    if shape.outline is not None:
        found["outline"] = rounded(shape.outline)
    if shape.colour is not None:
        found["colour"] = shape.colour
    if shape.opacity < 1:
        found["opacity"] = shape.opacity
    if shape.aside:
        found["aside"] = True
    if shape.surface is not None:
        vertices, triangles = shape.surface
        found["surface"] = packed([vertices])
        found["triangles"] = base64.b64encode(triangles.astype("<u4").tobytes()).decode()
    if shape.pose is not None:
        origin, R = (_rows(rows, axes)[0] for axes, rows in enumerate(shape.pose, start=1))
        first = np.concatenate([_rows(line, 2)[0] for line in shape.lines])
        found["local"] = packed([(first - origin) @ R])
    if shape.across is not None:
        across = shape.across if shape.pose is None else shape.across @ shape.pose[1]
        found["across"] = packed(_rows(across, 2))
    if shape.force is not None:
        found["force"] = packed(_rows(shape.force, 1))
    return found


def _rows(values: Array, axes: int) -> Array:
    """Return values with the axis of the states, also those of one state, which have `axes` axes."""
    return values.reshape(-1, *values.shape[values.ndim - axes :])


def numbers(shape: Shape) -> Array:
    """Return the moving data (..., k) of a shape: its pose (position and quaternion), or its vertices.

    The quaternions of successive states have the signs that bring them nearest to one another.
    """
    if shape.pose is None:
        places = np.concatenate(shape.lines, axis=-2)
        return places.reshape(*places.shape[:-2], -1)
    origin, R = shape.pose
    turned = Rotation.from_matrix(
        np.array(R).reshape(-1, 3, 3)
    )  # a copy: old versions refuse what is read-only
    turns = np.roll(turned.as_quat(), 1, axis=1)  # SciPy has the scalar last
    same = np.sum(turns[1:] * turns[:-1], axis=1) >= 0
    turns[1:] *= np.cumprod(np.where(same, 1.0, -1.0))[:, None]
    return np.concatenate([origin, turns.reshape(*origin.shape[:-1], 4)], axis=-1)
