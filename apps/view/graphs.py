"""Plots results: spectra, phase planes, poles, harmonics.

Every function returns the matplotlib figure and writes it to a file if a path is given.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, Protocol

import numpy as np
from numpy.typing import NDArray

from flexel.apps.view.figures import COLOURS, GUIDE, MARK, axis_label, caption, figure, panels, save
from flexel.base.arguments import flag, positive, quantities
from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.base.shown import listed

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from flexel.integration.trajectory import Trajectory
    from flexel.linear.harmonics import PeriodicVibration
    from flexel.mechanics.linearized_system import LinearizedSystem


def plot_spectra(
    motion: Trajectory,
    names: Sequence[str],
    path: str | Path | None = None,
    *,
    window: str = "hann",
    lin: LinearizedSystem | None = None,
    logarithmic: bool = True,
    limit: float | None = None,
    title: str = "",
) -> Figure:
    """Plot amplitude spectra of named quantities, one panel for each unit; see `Motion.spectrum_plot`."""
    logarithmic, title = flag(logarithmic, "spectrum_plot", "logarithmic"), caption(title, "spectrum_plot")
    shown = quantities(names, "spectrum_plot") or motion.dofs
    found = {name: (*motion.spectrum(name, window), motion.unit(name)) for name in shown}
    units = list(dict.fromkeys(unit for *_, unit in found.values()))
    highest = float(found[shown[0]][0][-1]) if limit is None else positive(limit, "spectrum_plot", "limit")
    with panels(len(units)) as (drawn, axes):
        for panel, unit in zip(axes[:, 0], units, strict=True):
            members = [name for name in found if found[name][2] == unit]
            for name in members:
                f, amplitude, _ = found[name]
                panel.plot(f, amplitude, color=COLOURS[list(found).index(name) % len(COLOURS)], label=name)
            if logarithmic:
                panel.set_yscale("log")
            panel.set_ylabel(
                axis_label(members, unit, "amplitude of " if len(members) == 1 else "amplitude, ")
            )
            _natural(panel, lin, highest)
            if len(members) > 1 or lin is not None:
                panel.legend(loc="upper right")
        axes[0, 0].set_title(title or f"Spectrum of {listed(shown, 4)}")
        axes[-1, 0].set(xlabel="frequency [Hz]", xlim=(0, highest))
        drawn.align_ylabels()
    save(drawn, path)
    return drawn


def _natural(panel: Axes, lin: LinearizedSystem | None, highest: float) -> None:
    """Mark the frequencies at which the modes oscillate."""
    if lin is None:
        return
    if not hasattr(lin, "eigenvalues"):
        raise ModelError(f"spectrum_plot: lin is {lin!r}; give a linearization, system.linearize(state)")
    f = lin.eigenvalues().imag / (2 * np.pi)
    for i, value in enumerate(f[(f > 0) & (f <= highest)]):
        panel.axvline(value, color=MARK, lw=0.9, ls=":", label=None if i else "natural frequencies")


def plot_phase(motion: Trajectory, x: str, y: str, path: str | Path | None = None) -> Figure:
    """Plot one quantity against another; the start is marked.

    Parameters
    ----------
    motion : Trajectory
    x, y : str
        Quantities, their rates or forces, as in `Motion.series`.
    path : path, optional
        Where to write the figure.
    """
    (across, unit_x), (up, unit_y) = motion.series(x), motion.series(y)
    with figure(size=(6.0, 5.0)) as (drawn, axes):
        axes.plot(across, up, color=COLOURS[0])
        axes.plot(across[:1], up[:1], "o", color=COLOURS[1], ms=5, label=f"t = {motion.t[0]:g} s")
        axes.set(xlabel=axis_label([x], unit_x), ylabel=axis_label([y], unit_y), title=f"{y} against {x}")
        if unit_x == unit_y == "m":  # the path of a point
            axes.set_aspect("equal", adjustable="datalim")
        axes.legend(loc="upper right")
    save(drawn, path)
    return drawn


def plot_poles(
    eigenvalues: Iterable[NDArray[np.complex128]],
    path: str | Path | None = None,
    *,
    parameter: Sequence[float] | Array | None = None,
    label: str = "parameter",
) -> Figure:
    """Plot eigenvalues in the complex plane, of one linearization or of several, coloured by a parameter.

    Parameters
    ----------
    eigenvalues : iterable of ndarray of complex
        [1/s]
    parameter : array_like, optional
        One value for each set of eigenvalues.
    label : str
        Name and unit of the parameter.
    """
    sets = [np.asarray(w) for w in eigenvalues]
    if parameter is not None and len(parameter) != len(sets):
        raise ModelError(f"poles: {len(sets)} sets of eigenvalues and {len(parameter)} values of '{label}'")
    shade = np.zeros(len(sets)) if parameter is None else np.asarray(parameter, dtype=float)
    w = np.concatenate(sets)
    colour = np.concatenate([np.full(points.size, s) for points, s in zip(sets, shade, strict=True)])
    with figure(size=(6.4, 5.4)) as (drawn, axes):
        axes.axvline(0, **GUIDE)
        axes.axhline(0, **GUIDE)
        style: dict[str, Any] = {"marker": "x", "s": 36, "linewidths": 1.6, "zorder": 3}
        if parameter is None:
            axes.scatter(w.real, w.imag, color=COLOURS[0], **style)
        else:
            marks = axes.scatter(w.real, w.imag, c=colour, cmap="viridis", **style)
            drawn.colorbar(marks, ax=axes, label=label)
        title = "Eigenvalues" if parameter is None else f"Eigenvalues against {label.partition(' [')[0]}"
        axes.set(xlabel="real part [1/s]", ylabel="imaginary part [rad/s]", title=title)
    save(drawn, path)
    return drawn


def plot_harmonics(
    vibration: PeriodicVibration, units: Sequence[str], path: str | Path | None = None
) -> Figure:
    """Plot amplitudes of the harmonics of every degree of freedom of a periodic motion, one panel for each unit."""
    names, k = vibration.coefficients.names, vibration.harmonics
    amplitude = harmonic_amplitudes(vibration)
    kinds = list(dict.fromkeys(units))
    with panels(len(kinds)) as (drawn, axes):
        for panel, unit in zip(axes[:, 0], kinds, strict=True):
            members = [i for i, own in enumerate(units) if own == unit]
            width = 0.8 / len(members)
            for j, i in enumerate(members):
                place = np.arange(k + 1) + (j - (len(members) - 1) / 2) * width
                panel.bar(place, amplitude[:, i], width, color=COLOURS[i % len(COLOURS)], label=names[i])
            panel.set_yscale("log")
            panel.set_ylabel(axis_label([names[i] for i in members], unit, "amplitude, "))
            if len(members) > 1:
                panel.legend(loc="upper right")
        axes[0, 0].set_title("Harmonics of the periodic motion")
        axes[-1, 0].set_xlabel(f"harmonic of {vibration.coefficients.omega:.4g} rad/s [-]")
    save(drawn, path)
    return drawn


def harmonic_amplitudes(vibration: PeriodicVibration) -> Array:
    """Return the amplitudes (k + 1, nd) of the harmonics 0…k."""
    k = vibration.harmonics
    amplitude = 2 * np.abs(vibration.X[k:])
    amplitude[0] /= 2
    return np.asarray(amplitude)


class StabilityBranch(Protocol):
    """A branch of periodic motions, as far as its figure needs it."""

    @property
    def omega(self) -> Array:
        """Angular frequencies [rad/s]."""

    @property
    def modulus(self) -> Array:
        """Largest Floquet multipliers."""

    @property
    def stable(self) -> NDArray[np.bool_]:
        """Whether each motion is stable."""

    @property
    def folds(self) -> list[int]:
        """Numbers of the motions at folds."""

    @property
    def stretches(self) -> list[tuple[slice, bool]]:
        """Parts of the branch, and whether their motions are stable."""

    def largest(self, name: str) -> Array:
        """Return the largest magnitudes of a quantity."""

    def __getitem__(self, number: int) -> Any: ...


def plot_branch(branch: StabilityBranch, names: Sequence[str], path: str | Path | None = None) -> Figure:
    """Plot largest magnitudes, and the largest Floquet multiplier, against the speed; unstable motions are dashed."""
    rows = [(branch.largest(name), name, branch[0].unit(name)) for name in names]
    rows.append((branch.modulus, "largest multiplier", ""))
    w = branch.omega
    with panels(len(rows)) as (drawn, axes):
        for panel, (values, name, unit) in zip(axes[:, 0], rows, strict=True):
            for part, stable in branch.stretches:
                panel.plot(w[part], values[part], "-" if stable else "--", color=COLOURS[0])
            panel.plot(
                w[branch.folds],
                values[branch.folds],
                "o",
                color=COLOURS[1],
                label="fold" if branch.folds else None,
            )
            panel.set_ylabel(axis_label([name], unit))
        axes[-1, 0].axhline(1, **GUIDE)
        axes[-1, 0].set_xlabel("speed [rad/s]")
        axes[0, 0].plot([], [], "-", color=COLOURS[0], label="stable")
        if not branch.stable.all():
            axes[0, 0].plot([], [], "--", color=COLOURS[0], label="unstable")
        axes[0, 0].set_title("Largest magnitudes of the periodic motions against their speed")
        axes[0, 0].legend(loc="upper left")
    save(drawn, path)
    return drawn
