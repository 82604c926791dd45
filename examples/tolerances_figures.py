"""The figure of the tolerances: how the lowest frequency of the stages is distributed."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from flexel.apps.view.figures import COLOURS, figure, save
from flexel.base.arrays import Array


def distribution(found: Array, closed: Array, path: Path) -> Path:
    """Plot the part of the stages below each lowest frequency, and the frequencies of the leaf springs themselves."""
    part = (np.arange(len(found)) + 0.5) / len(found)
    with figure(1, 2, size=(9.0, 4.0)) as (drawn, axes):
        axes[0].plot(np.sort(found[:, 0]), part, color=COLOURS[0], label="sweep")
        axes[0].plot(np.sort(closed), part, "--", color=COLOURS[1], label="closed form at the same points")
        axes[0].set(title="lowest frequency", xlabel="frequency [Hz]", ylabel="share of the stages below [-]")
        for mode in range(1, found.shape[1]):
            axes[1].plot(np.sort(found[:, mode]), part, color=COLOURS[mode], label=f"mode {mode + 1}")
        axes[1].set(title="frequencies of the leaf springs", xlabel="frequency [Hz]")
        for axis in axes:
            axis.legend()
        drawn.suptitle(f"{len(found)} parallel guides within their tolerances")
        save(drawn, path)
    return path
