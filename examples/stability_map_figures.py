"""The picture of the stability map."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from flexel.examples import bicycle_data as data
from flexel.examples.stability_map import SPEEDS, stable, widths
from flexel.pictures.figures import COLOURS, figure, save


def stability(found: Any, path: Path) -> Path:
    """Width and lower end of the stable range of speeds over wheelbase and trail."""
    steady = stable(found)
    lowest = np.where(steady.any(axis=-1), SPEEDS[np.argmax(steady, axis=-1)], np.nan)
    w, c = found.wheelbase.values, found.trail.values * 1000
    with figure(1, 2, size=(11.0, 4.6), sharey=True) as (drawn, axes):
        for axis, values, title in (
            (axes[0], widths(steady), "width of the stable range [m/s]"),
            (axes[1], lowest, "lowest stable speed [m/s]"),
        ):
            filled = axis.pcolormesh(w, c, values.T, cmap="viridis", shading="nearest", rasterized=True)
            drawn.colorbar(filled, ax=axis)
            axis.set_facecolor("#d9d9d9")
            axis.plot(data.BENCHMARK["w"], data.BENCHMARK["c"] * 1000, "o", color=COLOURS[1], mec="white")
            axis.annotate("benchmark", (data.BENCHMARK["w"], data.BENCHMARK["c"] * 1000), xytext=(6, 6),
                          textcoords="offset points", color="white")  # fmt: skip
            axis.set_xlabel("wheelbase [m]")
            axis.set_title(title)
        axes[0].set_ylabel("trail [mm]")
        drawn.suptitle(
            f"{len(w) * len(c)} bicycles, hands off; grey: stable at no speed up to {SPEEDS[-1]:g} m/s"
        )
        save(drawn, path)
    return path
