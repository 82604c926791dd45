"""Plots of motions: time histories, root loci, and, from sibling modules, the mechanism at rest and moving.

Every function returns the matplotlib figure (or axes, or path) and writes it to a file if a path is given.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from flexel.base.arrays import Array, ComplexArray
from flexel.pictures.animation import animate
from flexel.pictures.figures import COLOURS, figure, save
from flexel.pictures.loci import root_loci
from flexel.pictures.scene import draw
from flexel.pictures.solids import Box, Cylinder, Mesh, Sketch

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from flexel.results.motion import Motion

__all__ = ["Box", "Cylinder", "Mesh", "Sketch", "animate", "draw", "plot_histories", "root_loci"]


# -- time histories -------------------------------------------------------------------------------


def plot_histories(motion: Motion, names: Sequence[str], path: str | Path | None = None) -> Figure:
    """Time histories of named quantities, one panel for each unit.

    Parameters
    ----------
    names : sequence of str
        Quantities; ``"steer.angle'"`` is a rate, ``"steer.angle''"`` an acceleration, ``"force:rod.elongation"`` a
        stress.  The degrees of freedom of the motion by default.
    path : path, optional
        File for the figure; the suffix determines the format.

    Raises
    ------
    ModelError
        An unknown name.
    FlexelError
        If matplotlib is not installed.
    """
    chosen = tuple(names) or motion.dofs
    series = {name: motion.series(name) for name in chosen}
    units = list(dict.fromkeys(unit for _, unit in series.values()))
    with figure(len(units), size=(8.0, 1.2 + 2.2 * len(units)), sharex=True, squeeze=False) as (drawn, axes):
        for panel, unit in zip(axes[:, 0], units, strict=True):
            for name, (values, own) in series.items():
                if own == unit:
                    colour = COLOURS[list(series).index(name) % len(COLOURS)]
                    panel.plot(motion.t, values, color=colour, label=name)
            panel.set_ylabel(f"[{unit}]" if unit else "")
            panel.legend(loc="upper right")
        axes[-1, 0].set_xlabel("time [s]")
        if motion.t[-1] > motion.t[0]:  # a motion interrupted immediately has only one state
            axes[-1, 0].set_xlim(motion.t[0], motion.t[-1])
    save(drawn, path)
    return drawn
