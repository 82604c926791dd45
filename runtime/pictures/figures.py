"""Figures in flexel's style with matplotlib, which is imported on first use."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

from flexel.base.arguments import path_of
from flexel.base.errors import FlexelError
from flexel.base.files import replacing

if TYPE_CHECKING:
    from matplotlib.figure import Figure

COLOURS = ("#0b5fa5", "#c8501e", "#2e8540", "#7b3f98", "#b8860b", "#444444")
STYLE: Any = {
    "font.size": 10,
    "axes.grid": True,
    "grid.color": "#dddddd",
    "grid.linewidth": 0.6,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.axisbelow": True,
    "figure.dpi": 110,
    "legend.frameon": False,
    "lines.linewidth": 1.6,
}


def require_matplotlib() -> None:
    """Raise a FlexelError that names the remedy if matplotlib is not installed."""
    try:
        import matplotlib  # noqa: F401
    except ImportError as error:
        message = 'pictures need matplotlib, which is not installed; pip install "flexel[plot]"'
        raise FlexelError(message) from error


@contextmanager
def figure(
    rows: int = 1, columns: int = 1, size: tuple[float, float] = (8.0, 5.0), **options: Any
) -> Iterator[tuple[Figure, Any]]:
    """A figure with its axes in flexel's style, drawn without a window.

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
    import matplotlib
    from matplotlib.figure import Figure

    with matplotlib.rc_context(STYLE):
        drawn = Figure(figsize=size, layout="constrained" if rows else None)
        yield drawn, drawn.subplots(rows, columns, **options) if rows else None


def save(drawn: Figure, path: str | Path | None) -> None:
    """Write a figure to a file, if a path is given; the suffix determines the format."""
    if path is not None:
        path = path_of(path, "save")
        with replacing(path if path.suffix else path.with_suffix(".png")) as part:
            drawn.savefig(part, dpi=130)
