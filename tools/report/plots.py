"""Draws plots for the page: SVG by matplotlib, in the colours of the page; without matplotlib there are only tables."""

from __future__ import annotations

import io
import re
from collections.abc import Callable, Mapping, Sequence
from math import ceil, floor, log10
from typing import TYPE_CHECKING, Any

from flexel.apps.view.figures import COLOURS, figure, require_matplotlib
from flexel.base.errors import FlexelError
from report.markup import Html

if TYPE_CHECKING:
    from matplotlib.axes import Axes

INK, LINE, GUIDE = "#010203", "#040506", "#070809"  # placeholders for the colours of the page
VARIABLES = {INK: "--ink", LINE: "--line", GUIDE: "--faint"} | {
    colour: f"--c{i}" for i, colour in enumerate(COLOURS)
}
STYLE = {
    "svg.fonttype": "none",  # text stays text
    "svg.hashsalt": "flexel",  # reproducible names
    "font.family": "sans-serif",
    "text.color": INK,
    "axes.labelcolor": INK,
    "axes.edgecolor": INK,
    "xtick.color": INK,
    "ytick.color": INK,
    "grid.color": LINE,
}
HIGHEST = 10  # highest order for which a line is drawn
FLOOR = 1e-17  # position of an error of 0


class Plots:
    """Draws plots, each with unique names in the page.

    Attributes
    ----------
    remedy : str
        The command that installs matplotlib, if it is missing.
    """

    def __init__(self) -> None:
        self.remedy, self._count = "", 0
        try:
            require_matplotlib()
        except FlexelError as error:
            self.remedy = f"Without plots: {error}"

    @property
    def possible(self) -> bool:
        """Whether matplotlib is installed."""
        return not self.remedy

    def draw(self, plot: Callable[..., None], *data: Any, size: tuple[float, float] | None = None) -> Html:
        """Return the SVG of a plot.

        Parameters
        ----------
        plot : function
            Draws the data into axes, which are its first argument.
        size : (width, height), optional
            In inches.
        """
        import matplotlib

        self._count += 1
        shape = size or (SIZES[plot](*data) if plot in SIZES else (3.2, 2.3))
        with figure(1, 1, shape) as (drawn, axes), matplotlib.rc_context(STYLE):  # type: ignore[arg-type]
            axes.clear()
            for spine in axes.spines.values():
                spine.set_color(INK)
            plot(axes, *data)
            stream = io.StringIO()
            nothing = dict.fromkeys(("Date", "Creator", "Format", "Type"))
            drawn.savefig(stream, format="svg", transparent=True, metadata=nothing)
        return Html(_inline(stream.getvalue(), f"p{self._count}-"))


def _inline(svg: str, prefix: str) -> str:
    """Return the element alone, as wide as its box, with the colours of the page; names begin with the prefix."""
    svg = svg[svg.index("<svg") :]
    svg = re.sub(r'(<svg )[^>]*?(viewBox="[^"]*")[^>]*>', r'\1\2 role="img">', svg, count=1)
    svg = re.sub(r"<!--.*?-->|<style.*?</style>|font-family: [^;\"]*;? ?", "", svg, flags=re.DOTALL)
    svg = re.sub(r'<g id="[^"]*"', "<g", svg)  # nothing refers to groups
    svg = re.sub(r'\bid="', f'id="{prefix}', svg)
    svg = re.sub(r"url\(#", f"url(#{prefix}", svg)
    svg = re.sub(r'(?:xlink:)?href="#', f'href="#{prefix}', svg)
    for colour, variable in VARIABLES.items():
        svg = svg.replace(colour, f"var({variable})")
    return re.sub(r"\s*\n\s*", "\n", svg).strip()


def log_log(
    axes: Axes, meshes: Sequence[float], errors: Sequence[float], order: float | None, over: str
) -> None:
    """Plot errors over the number of elements or steps, and a dashed line of the nearest whole order."""
    known = [(n, error) for n, error in zip(meshes, errors, strict=True) if error > 0 and n > 0]
    if order is not None and known and 0.5 < order < HIGHEST:
        n, last = known[-1]
        axes.loglog(
            [n for n, _ in known],
            [last * (n / mesh) ** round(order) for mesh, _ in known],
            "--",
            color=GUIDE,
            lw=1,
        )
    axes.loglog([n for n, _ in known], [error for _, error in known], "o-", color=COLOURS[0], ms=4)
    axes.set_xticks([n for n, _ in known], [f"{n:g}" for n, _ in known])
    low, high = (log10(extreme([error for _, error in known], default=1.0)) for extreme in (min, max))
    axes.set_ylim(
        10.0 ** floor(low), 10.0 ** max(ceil(high), floor(low) + 1)
    )  # whole decades: each has a label
    axes.minorticks_off()
    axes.set_xlabel(over)
    axes.set_ylabel("error")


def limits(axes: Axes, rows: Mapping[str, Sequence[tuple[float, float]]]) -> None:
    """Plot errors relative to tolerances for each kind of reference; errors above the line are failures.

    Parameters
    ----------
    rows : mapping of str to a sequence of (tolerance, error)
    """
    low, high = FLOOR, 1.0
    for i, (kind, pairs) in enumerate(rows.items()):
        x, y = zip(*((max(a, FLOOR), max(b, FLOOR)) for a, b in pairs), strict=True)
        high = max(high, *x, *y)
        axes.loglog(
            x,
            y,
            "os^D"[i % 4],
            color=COLOURS[i % len(COLOURS)],
            ms=4.5,
            alpha=0.75,
            label=f"{kind} ({len(x)})",
        )
    axes.loglog([low, high], [low, high], color=INK, lw=1)
    axes.set_xlabel("tolerance")
    axes.set_ylabel("error")
    axes.legend(loc="upper left")


def bars(axes: Axes, names: Sequence[str], values: Sequence[float], label: str) -> None:
    """Draw a bar for each ratio, starting at 1."""
    places = range(len(names))
    axes.barh(
        places,
        [ratio - 1 for ratio in values],
        left=1.0,
        color=[COLOURS[0] if ratio > 1 else COLOURS[1] for ratio in values],
    )
    axes.set_xscale("log")
    axes.axvline(1.0, color=INK, lw=1)
    for place, value in zip(places, values, strict=True):
        axes.annotate(f"{value:.3g}", (value, place), (3 if value > 1 else -3, 0), textcoords="offset points",
                      va="center", ha="left" if value > 1 else "right")  # fmt: skip
    axes.margins(x=0.15)
    axes.set_yticks(places, names)
    axes.invert_yaxis()
    axes.grid(axis="y", visible=False)


SIZES: dict[Callable[..., None], Callable[..., tuple[float, float]]] = {
    limits: lambda _: (6.5, 4.5),
    bars: lambda names, *_: (7.0, 0.8 + 0.28 * len(names)),
}
