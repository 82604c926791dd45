"""Draws Bode diagrams: magnitude and phase of frequency responses."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from flexel.apps.view.figures import COLOURS, caption, panels, save, unit_text
from flexel.base.errors import ModelError

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from flexel.linear.response import FrequencyResponse


def plot_bode(
    response: FrequencyResponse, path: str | Path | None = None, *, decibels: bool = False, title: str = ""
) -> Figure:
    """Plot magnitudes, on one pair of axes for each unit, and below them the phases of all pairs of input and output.

    Parameters
    ----------
    path : path, optional
        File for the figure; the suffix determines the format.
    decibels : bool
        Magnitudes in decibels relative to one unit; ratios on a logarithmic axis otherwise.
    title : str
    """
    f, title = response.frequencies, caption(title, "bode")
    if f[0] <= 0:
        raise ModelError("bode: the frequency axis is logarithmic; give positive frequencies")
    pairs = [(i, j) for i in range(len(response.outputs)) for j in range(len(response.inputs))]
    units = list(dict.fromkeys(response.units[i][j] for i, j in pairs))
    shown = response.decibels if decibels else response.magnitude
    with panels(len(units) + 1) as (drawn, axes):
        *above, below = axes[:, 0]
        for number, (i, j) in enumerate(pairs):
            own = above[units.index(response.units[i][j])]
            style = {"color": COLOURS[number % len(COLOURS)], "label": _pair(response, i, j)}
            own.plot(f, shown[:, i, j], **style)
            below.plot(f, np.degrees(response.phase[:, i, j]), **style)
        for panel, unit in zip(above, units, strict=True):
            if not decibels:
                panel.set_yscale("log")
            text = unit_text(unit)[1:-1]
            panel.set_ylabel(f"magnitude [dB re 1 {text}]" if decibels else f"magnitude [{text}]")
            if len(pairs) > 1:
                panel.legend(loc="best")
        below.set(xscale="log", xlabel="frequency [Hz]", ylabel="phase [°]")
        below.yaxis.set_major_locator(_steps())
        if f.size > 1 and f[-1] > f[0]:
            below.set_xlim(f[0], f[-1])
        names = _pair(response, 0, 0) if len(pairs) == 1 else _several(response.outputs, response.inputs)
        axes[0, 0].set_title(title or f"Frequency response: {names}")
        drawn.align_ylabels()
    save(drawn, path)
    return drawn


def _pair(response: FrequencyResponse, i: int, j: int) -> str:
    return f"{response.outputs[i]} / {response.inputs[j]}"


def _several(outputs: Sequence[str], inputs: Sequence[str]) -> str:
    return f"{', '.join(outputs)} by {', '.join(inputs)}"


def _steps() -> object:
    """Put ticks at multiples of 45 degrees, or larger steps."""
    from matplotlib.ticker import MaxNLocator

    return MaxNLocator(6, steps=[1, 1.8, 4.5, 9, 10])
