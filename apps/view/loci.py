"""Plots root loci: eigenvalues against a parameter or in the complex plane, one colour and name for each branch."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from flexel.apps.view.figures import COLOURS, GUIDE, MARK, STABLE, caption, figure, save
from flexel.base.arguments import array, number
from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.linear.tracking import Boundary, Branches

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

Names = Mapping[str, "tuple[float, float]"] | Sequence[str] | None
SHADE: Any = {"color": STABLE, "alpha": 0.13, "lw": 0}
MAX_BRANCHES_INSIDE = 6  # branches above which the legend is placed next to the axes


def root_loci(
    parameter: Sequence[float] | Array,
    eigenvalues: Any,
    path: str | Path | None = None,
    *,
    label: str = "parameter",
    marks: Mapping[str, float] | None = None,
    limits: tuple[float, float] | None = None,
    names: Names = None,
    title: str = "",
    plane: bool = False,
) -> Figure:
    """Plot real and imaginary parts of eigenvalues against a parameter; stable ranges are shaded.

    Parameters
    ----------
    parameter : array_like (np,)
        Increasing.
    eigenvalues : array_like (np, n) or (np, n, n)
        [1/s]; or the state matrices, with which branches are followed by the shapes of their modes.
    label : str
        Name and unit of the parameter.
    marks : mapping of str to float
        Values of the parameter to mark, with their names; by default where a branch becomes stable or unstable.
    limits : (low, high), optional
        Limits of the real parts shown [1/s].
    names : mapping of str to (parameter, real part), or sequence of str
        Names of branches: a name labels the branch nearest to its position, where it is written; or names of all.
    title : str
    plane : bool
        Plot imaginary against real parts instead, with marks at both ends.
    """
    branches = Branches.of(array(parameter, "root_loci", "parameter"), eigenvalues)
    return plot_loci(
        branches, path, label=label, marks=marks, limits=limits, names=names, title=title, plane=plane
    )


def plot_loci(
    branches: Branches,
    path: str | Path | None = None,
    *,
    label: str = "parameter",
    marks: Mapping[str, float] | None = None,
    limits: tuple[float, float] | None = None,
    names: Names = None,
    title: str = "",
    plane: bool = False,
) -> Figure:
    """Draw a figure of branches; see `root_loci`."""
    called, places = _names(branches, names)
    label, title = caption(label, "root_loci", "label"), caption(title, "root_loci")
    title = title or f"Eigenvalues against {label.partition(' [')[0]}"
    if plane:
        drawn = _plane(branches, called, label, title, limits)
    else:
        drawn = _over(branches, called, places, (label, title), _marks(branches, called, marks), limits)
    save(drawn, path)
    return drawn


def _names(branches: Branches, names: Names) -> tuple[list[str], Mapping[str, tuple[float, float]]]:
    """Return the names of all branches, and the positions at which some are written."""
    own = list(branches.names)
    if names is None:
        return own, {}
    if not isinstance(names, Mapping):
        if isinstance(names, str) or len(names) != len(own):
            raise ModelError(
                f"root_loci: names {names!r}; give one for each of {own}, or positions of some of them"
            )
        return [caption(name, "root_loci", "name") for name in names], {}
    p, w = branches.parameter, branches.eigenvalues.real
    for name, place in names.items():
        x, y = (number(coordinate, "root_loci", f"position of '{name}'") for coordinate in place)
        row = w[int(np.argmin(np.abs(p - x)))]
        off = [np.abs(row[family] - y).min() for family in branches.families]
        own[int(np.nanargmin(off))] = name
    return own, names


def _marks(
    branches: Branches, called: Sequence[str], marks: Mapping[str, float] | None
) -> list[tuple[str, float]]:
    if marks is not None:
        return list(marks.items())
    return [(boundary.branch, boundary.value) for boundary in branches.boundaries(called)]


def _style(i: int) -> dict[str, Any]:
    """Return the colour of the i-th branch, paler from the second round on."""
    return {"color": COLOURS[i % len(COLOURS)], "alpha": 0.55 if i >= len(COLOURS) else 1.0}


def _over(
    branches: Branches,
    called: Sequence[str],
    places: Mapping[str, tuple[float, float]],
    texts: tuple[str, str],
    marks: Sequence[tuple[str, float]],
    limits: tuple[float, float] | None,
) -> Figure:
    """Draw real parts above, imaginary parts below."""
    p, w = branches.parameter, branches.eigenvalues
    with figure(2, size=(8.0, 6.4), sharex=True, height_ratios=(3, 2)) as (drawn, axes):
        axes[0].axhline(0, **GUIDE)
        for panel in axes:
            for start, end in stable_ranges(branches):
                panel.axvspan(start, end, **SHADE)
            for _, value in marks:
                panel.axvline(value, color=MARK, lw=0.9, ls=":")
        for i, (name, family) in enumerate(zip(called, branches.families, strict=True)):
            for k, j in enumerate(family):
                axes[0].plot(p, w[:, j].real, **_style(i), label=None if k or name in places else name)
                axes[1].plot(p, np.abs(w[:, j].imag), "--", **_style(i))
            if name in places:
                axes[0].text(
                    *places[name], name, style="italic", ha="center", color=COLOURS[i % len(COLOURS)]
                )
        _limits(axes[0], limits, axes[0].set_ylim)
        axes[1].set_ylim(0, None)
        axes[0].fill_between([], [], [], **SHADE, label="asymptotically stable")
        _legend(axes[0], len(called) - len(places))
        for name, value in marks:
            axes[0].annotate(f"{name}\n{value:.4g}", (value, 0.985), xycoords=("data", "axes fraction"), va="top",
                             xytext=(3, 0), textcoords="offset points", color=MARK, fontsize=9)  # fmt: skip
        axes[0].set(ylabel="real part [1/s]", title=texts[1])
        axes[1].set(ylabel="|imaginary part| [rad/s]", xlabel=texts[0])
        if p.size > 1:
            axes[1].set_xlim(p[0], p[-1])
        drawn.align_ylabels()
    return drawn


def _plane(
    branches: Branches, called: Sequence[str], label: str, title: str, limits: tuple[float, float] | None
) -> Figure:
    """Draw imaginary over real parts; both ends of the parameter are marked."""
    w, (quantity, _, unit) = branches.eigenvalues, label.partition(" [")
    known = np.flatnonzero(np.isfinite(w).all(axis=1))
    with figure(size=(7.6, 5.6)) as (drawn, axes):
        axes.axvline(0, **GUIDE)
        axes.axhline(0, **GUIDE)
        for i, (name, family) in enumerate(zip(called, branches.families, strict=True)):
            for k, j in enumerate(family):
                axes.plot(w[:, j].real, w[:, j].imag, **_style(i), label=None if k else name)
                for end, mark in zip(known[[0, -1]] if known.size else (), "xo", strict=False):
                    axes.plot(w[end, j].real, w[end, j].imag, mark, **_style(i), mfc="white", ms=6)
        for end, mark in zip(known[[0, -1]] if known.size else (), "xo", strict=False):
            text = f"{quantity} {branches.parameter[end]:.4g} {unit.rstrip(']')}"
            axes.plot([], [], mark, color=COLOURS[5], mfc="white", label=text.rstrip())
        _limits(axes, limits, axes.set_xlim)
        _legend(axes, len(called))
        axes.set(xlabel="real part [1/s]", ylabel="imaginary part [rad/s]", title=title)
    return drawn


def _limits(axes: Axes, limits: tuple[float, float] | None, put: Any) -> None:
    if limits is not None:
        put(*(number(limit, "root_loci", "limit") for limit in limits))


def _legend(axes: Axes, count: int) -> None:
    """Draw the legend, next to the axes if there are many branches."""
    if count > MAX_BRANCHES_INSIDE:
        axes.legend(loc="upper left", bbox_to_anchor=(1.0, 1.0))
    else:
        axes.legend(loc="best")


def stable_ranges(branches: Branches) -> Iterator[tuple[float, float]]:
    """Return ranges of the parameter in which all real parts are negative, with refined ends."""
    p, known = branches.parameter, np.isfinite(branches.eigenvalues).all(axis=1)
    if not known.any():
        return
    changes: list[Boundary] = branches.boundaries()
    ends = [p[known][0], *(change.value for change in changes), p[known][-1]]
    largest = branches.eigenvalues.real.max(axis=1)
    for start, end in zip(ends, ends[1:], strict=False):
        inside = known & (p > start) & (p < end)
        if inside.any() and (largest[inside] < 0).all():
            yield float(start), float(end)
