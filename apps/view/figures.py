"""Figures in flexel's style with matplotlib, which is imported on first use."""

from __future__ import annotations

import io
from collections.abc import Iterator, Sequence
from contextlib import AbstractContextManager, contextmanager
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

from flexel.base.arguments import path_of, text
from flexel.base.errors import FlexelError, ModelError
from flexel.base.files import replacing

if TYPE_CHECKING:
    from matplotlib.figure import Figure

COLOURS = ("#0b5fa5", "#d55e00", "#009e73", "#cc79a7", "#d9a000", "#444444")  # colour-blind safe
STABLE = "#009e73"  # stable ranges, shaded
MARK = "#c8501e"  # marked values
GUIDE: Any = {"color": "#222222", "lw": 0.8}  # lines at zero, or at a limit
STYLE = "flexel.apps.view.style"  # the file style.mplstyle in this folder, found by matplotlib
FIGURE_WIDTH_IN = 8.0  # of a figure with one column of axes [in]
WORDS = {  # common noun for several quantities of one unit
    "m": "displacement",
    "m/s": "velocity",
    "m/s²": "acceleration",
    "rad": "angle",
    "rad/s": "angular velocity",
    "rad/s²": "angular acceleration",
    "N": "force",
    "N m": "moment",
    "N/m": "force per length",
    "J": "energy",
    "rad/m": "curvature",
}


def unit_text(unit: str) -> str:
    """Write a unit for an axis: raised powers, and a dash for a number.

    Examples
    --------
    >>> unit_text("m^2/s"), unit_text("1")
    ('[m²/s]', '[-]')
    """
    for plain, raised in (("^2", "²"), ("^3", "³"), ("^4", "⁴")):
        unit = unit.replace(plain, raised)
    return "[-]" if unit in ("", "1", "-") else f"[{unit}]"


def axis_label(names: Sequence[str], unit: str, before: str = "") -> str:
    """Write quantity and unit for an axis: the name of a single quantity, or the noun common to several of one unit.

    Examples
    --------
    >>> axis_label(["crank.angle"], "rad"), axis_label(["A.x", "A.y"], "m")
    ('crank.angle [rad]', 'displacement [m]')
    """
    word = names[0] if len(names) == 1 else WORDS.get(unit_text(unit)[1:-1], "value")
    return f"{before}{word} {unit_text(unit)}"


def caption(given: Any, owner: str, what: str = "title") -> str:
    """Return a text that can be drawn.

    Raises
    ------
    ModelError
        No text, or characters that cannot be printed.
    """
    found = text(given, owner, what)
    if not found.replace("\n", "").isprintable():
        raise ModelError(f"{owner}: {what} {found!r} has characters that cannot be printed; leave them out")
    return found


def panels(count: int, **options: Any) -> AbstractContextManager[tuple[Figure, Any]]:
    """Make a figure with this many axes, one below the other, which share the horizontal axis; see `figure`."""
    size = (FIGURE_WIDTH_IN, 1.2 + 2.2 * count)
    return figure(count, size=size, **{"sharex": True, "squeeze": False, **options})


def require_matplotlib() -> None:
    """Raise a FlexelError that names the remedy if matplotlib is not installed."""
    try:
        import matplotlib  # noqa: F401
    except ImportError as error:
        message = 'pictures need matplotlib, which is not installed; pip install "flexel[plot]"'
        raise FlexelError(message) from error


@contextmanager
def figure(
    rows: int = 1, columns: int = 1, size: tuple[float, float] = (FIGURE_WIDTH_IN, 5.0), **options: Any
) -> Iterator[tuple[Figure, Any]]:
    """Make a figure with its axes in flexel's style, drawn without a window.

    Parameters
    ----------
    rows, columns : int
        Rows and columns of the grid of axes; no rows: an empty figure.
    size : (width, height)
        Size in inches.
    options
        Passed on to `matplotlib.figure.Figure.subplots`.
    """
    require_matplotlib()
    from matplotlib import style
    from matplotlib.figure import Figure

    with style.context(STYLE):
        drawn = Figure(figsize=size, layout="constrained")
        if not rows:
            drawn.set_layout_engine("none")
        # a notebook shows it as the result of a cell, also without %matplotlib
        setattr(drawn, "_repr_png_", partial(_png, drawn))  # noqa: B010
        yield drawn, drawn.subplots(rows, columns, **options) if rows else None


def _png(drawn: Figure) -> bytes:
    buffer = io.BytesIO()
    drawn.savefig(buffer, format="png")
    return buffer.getvalue()


def save(drawn: Figure, path: str | Path | None) -> None:
    """Write a figure to a file, if a path is given; the suffix determines the format."""
    if path is not None:
        path = path_of(path, "save")
        with replacing(path if path.suffix else path.with_suffix(".png")) as part:
            drawn.savefig(part, dpi=130)
