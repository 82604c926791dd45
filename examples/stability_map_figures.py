"""The figure of the stability map."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from flexel.apps.view.figures import COLOURS, figure, save
from flexel.examples import bicycle_data as data
from flexel.examples.stability_map import SPEEDS, ranges


def stability(found: Any, path: Path) -> Path:
    """Plot width and lower end of the stable range of speeds over wheelbase and trail, with a smooth boundary."""
    low, high, margin = ranges(found)
    w, c = found.wheelbase.values, found.trail.values * 1000
    own = data.BENCHMARK["w"], data.BENCHMARK["c"] * 1000
    with figure(1, 2, size=(9.0, 4.8), sharey=True) as (drawn, axes):
        from matplotlib.ticker import MaxNLocator

        for axis, values, title in (
            (axes[0], high - low, "width of the stable range"),
            (axes[1], low, "lowest stable speed"),
        ):
            inside = values[margin > 0]
            levels = MaxNLocator(16).tick_values(inside.min(), inside.max())
            filled = axis.contourf(w, c, values.T, levels, cmap="viridis")
            drawn.colorbar(filled, ax=axis, label=f"{title} [m/s]")
            axis.contourf(w, c, margin.T, [-np.inf, 0.0], colors=["#d9d9d9"])
            axis.contour(w, c, margin.T, [0.0], colors=["#222222"], linewidths=1.2)
            axis.plot(*own, "o", color=COLOURS[1], mec="white")
            axis.annotate("benchmark", own, xytext=(6, 6), textcoords="offset points", color="white")
            axis.grid(visible=False)
            axis.set(xlabel="wheelbase [m]", title=title)
        axes[0].set_ylabel("trail [mm]")
        drawn.suptitle(
            f"{len(w) * len(c)} bicycles, hands off; grey: stable at no speed up to {SPEEDS[-1]:g} m/s"
        )
        save(drawn, path)
    return path
