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
from flexel.linear.tracking import branches
from flexel.pictures.animation import animate
from flexel.pictures.figures import COLOURS, figure, save
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


# -- root loci ------------------------------------------------------------------------------------


def root_loci(
    parameter: Sequence[float] | Array,
    eigenvalues: Any,
    path: str | Path | None = None,
    *,
    label: str = "parameter",
    marks: Mapping[str, float] | None = None,
    limits: tuple[float, float] | None = None,
    names: Mapping[str, tuple[float, float]] | None = None,
    title: str = "",
) -> Figure:
    """Real and imaginary parts of eigenvalues over a parameter; ranges with all real parts negative are shaded.

    Parameters
    ----------
    parameter : array_like (np,)
        Increasing.
    eigenvalues : array_like (np, n)
        [1/s]
    label : str
        Name and unit of the parameter.
    marks : mapping of str to float
        Values of the parameter to mark, with their names.
    limits : (low, high), optional
        Limits of the real parts shown [1/s].
    names : mapping of str to (parameter, real part)
        Names of branches and their positions.
    """
    p = np.asarray(parameter, dtype=float)
    w = branches(p, np.asarray(eigenvalues))
    with figure(2, size=(8.0, 6.4), sharex=True, height_ratios=(3, 2)) as (drawn, axes):
        for panel, part, name in (
            (axes[0], w.real, "real part [1/s]"),
            (axes[1], w.imag, "imaginary part [rad/s]"),
        ):
            for start, end in _stable(p, w):
                panel.axvspan(start, end, color="#2e8540", alpha=0.13, lw=0)
            panel.axhline(0, color="#222222", lw=0.8)
            for k in range(w.shape[1]):
                _branch(panel, p, part[:, k], np.abs(w[:, k].imag) > 1e-9, COLOURS[0])
            for value in (marks or {}).values():
                panel.axvline(value, color="#c8501e", lw=0.9, ls=":")
            panel.set_ylabel(name)
        axes[0].plot([], [], color=COLOURS[0], label="complex pair")
        axes[0].plot([], [], color=COLOURS[1], label="real")
        axes[0].fill_between([], [], [], color="#2e8540", alpha=0.13, lw=0, label="asymptotically stable")
        axes[0].legend(loc="lower right")
        if limits is not None:
            axes[0].set_ylim(*limits)
        for name, value in (marks or {}).items():
            axes[0].annotate(f"{name}\n{value:.4g}", (value, 0.985), xycoords=("data", "axes fraction"), va="top",
                             xytext=(3, 0), textcoords="offset points", color="#c8501e", fontsize=9)  # fmt: skip
        for name, place in (names or {}).items():
            axes[0].text(*place, name, style="italic", ha="center")
        axes[1].set_xlabel(label)
        axes[1].set_xlim(p[0], p[-1])
        axes[0].set_title(title)
    save(drawn, path)
    return drawn


def _branch(panel: Axes, p: Array, part: Array, oscillatory: NDArray[np.bool_], colour: str) -> None:
    """One branch, in another colour where it is real; a join belongs to both."""
    for mask, shade in ((oscillatory, colour), (~oscillatory, COLOURS[1])):
        panel.plot(p, np.where(mask, part, np.nan), color=shade)


def _stable(p: Array, w: ComplexArray) -> Iterator[tuple[float, float]]:
    """Ranges of the parameter in which all real parts are negative, ends interpolated."""
    largest = np.max(w.real, axis=1)
    start = p[0] if largest[0] < 0 else None
    for i in range(1, p.size):
        if (largest[i] < 0) != (largest[i - 1] < 0):
            crossing = p[i - 1] + (p[i] - p[i - 1]) * largest[i - 1] / (largest[i - 1] - largest[i])
            if start is not None:
                yield float(start), float(crossing)
            start = crossing if largest[i] < 0 else None
    if start is not None:
        yield float(start), float(p[-1])
