"""Draws the results of `flexel bench`: ratios to the peers, and times over the size."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from bench.compare import OWN, Comparison, Figure
from bench.peers import PEERS
from bench.ratios import peer_ratios
from bench.table import Row
from flexel.apps.view.figures import COLOURS, figure, save
from flexel.base.errors import FlexelError

if TYPE_CHECKING:
    from matplotlib.axes import Axes

NAMES = (OWN, *(peer.name for peer in PEERS))
BAR = 0.8  # height of the bars of a row


def check_format(path: str | Path) -> None:
    """Refuse a format that cannot be drawn, before anything is measured.

    Raises
    ------
    FlexelError
        Without matplotlib, or with a suffix that it does not know.
    """
    with figure(0) as (drawn, _):
        formats = drawn.canvas.get_supported_filetypes()
    if Path(path).suffix[1:].lower() not in formats:
        raise FlexelError(f"{path}: the suffix must be a format of pictures: {', '.join(sorted(formats))}")


def plot(found: Sequence[Comparison], path: str | Path) -> None:
    """Draw one panel of ratios, and one for each row that scales.

    Raises
    ------
    FlexelError
        If matplotlib is not installed.
    """
    beside = [comparison for comparison in found if ratios(comparison)]
    scaling = [
        comparison for comparison in found if comparison.row.sizes and comparison.own.value is not None
    ]
    heights = [1.2 + 0.3 * sum(len(ratios(comparison)) for comparison in beside)] * bool(beside) + [
        3.0
    ] * len(scaling)
    if not heights:
        raise FlexelError("nothing to draw: no row has an installed peer, and none has sizes")
    with figure(len(heights), size=(8.0, sum(heights)), squeeze=False, height_ratios=heights) as (
        drawn,
        axes,
    ):
        panels = list(axes[:, 0])
        if beside:
            _ratios(panels.pop(0), beside)
        for panel, row in zip(panels, scaling, strict=True):
            _sizes(panel, row.row, {OWN: row.own, **row.installed})
        drawn.suptitle(f"What {OWN} costs, compared with other programs")
        save(drawn, path)


def ratios(found: Comparison) -> dict[str, float]:
    """Return the time of each peer over flexel's, for the largest size that both can run."""
    return peer_ratios(found.own, found.peers)


def _ratios(panel: Axes, rows: Sequence[Comparison]) -> None:
    """Draw bars from 1, to the right if flexel needs less time."""
    for place, row in enumerate(rows):
        values = ratios(row)
        height = BAR / len(values)
        for i, (name, value) in enumerate(values.items()):
            y = place - BAR / 2 + (i + 0.5) * height
            panel.barh(y, value - 1, height, left=1.0, color=_colour(name))
    for name in dict.fromkeys(name for row in rows for name in ratios(row)):
        panel.barh(0, 0, color=_colour(name), label=name)
    panel.set_xscale("log")
    panel.axvline(1.0, color=_colour(OWN))
    panel.set_yticks(range(len(rows)), [row.row.name for row in rows])
    panel.invert_yaxis()
    panel.set_xlabel(f"time over that of {OWN} [-]")
    panel.legend(loc="lower center", bbox_to_anchor=(0.5, 1.0), ncols=len(PEERS))


def _sizes(panel: Axes, row: Row, figures: dict[str, Figure]) -> None:
    """Draw times over the size, and the fitted powers."""
    for name, measured in figures.items():
        known = [(n, value) for n, value in zip(row.sizes, measured.values, strict=True) if value is not None]
        if known:
            power = "" if measured.exponent is None else f": $N^{{{measured.exponent:.2f}}}$"
            panel.loglog(*zip(*known, strict=True), "o-", color=_colour(name), label=f"{name}{power}")
    panel.set_title(row.name)
    panel.set_xlabel("size N [-]")
    panel.set_ylabel(f"time [{row.unit}]")
    panel.legend()


def _colour(name: str) -> str:
    return COLOURS[NAMES.index(name) % len(COLOURS)] if name in NAMES else COLOURS[-1]
