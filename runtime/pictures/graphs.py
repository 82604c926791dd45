"""Graphs of results: spectra, phase planes, poles, harmonics.

Every function returns the matplotlib figure and writes it to a file if a path is given.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray
from scipy.signal import get_window

from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.pictures.figures import COLOURS, figure, save

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from flexel.linear.harmonics import PeriodicVibration
    from flexel.results.branch import PeriodicBranch
    from flexel.results.motion import Motion


def spectrum(motion: Motion, name: str, window: str = "hann") -> tuple[Array, Array, str]:
    """One-sided amplitude spectrum of a quantity: a harmonic on a line of the spectrum shows its own amplitude.

    Parameters
    ----------
    name : str
        Name as in `Motion.series`.
    window : str
        A window of `scipy.signal.get_window`; ``boxcar`` for a whole number of periods.

    Returns
    -------
    f : ndarray (nf,)
        Frequencies [Hz].
    amplitude : ndarray (nf,)
    unit : str

    Raises
    ------
    ModelError
        Times that are not equidistant, or fewer than four; an unknown window.
    """
    values, unit = motion.series(name)
    t = motion.t
    steps = np.diff(t)
    if t.size < 4:
        raise ModelError(
            f"spectrum of '{name}': {t.size} stored times are too few; simulate with more samples"
        )
    if np.ptp(steps) > 1e-6 * steps.mean():
        raise ModelError(
            f"spectrum of '{name}': the {t.size} stored times are not equidistant; simulate with samples=…, or with "
            "equidistant times"
        )
    try:
        w = get_window(window, t.size)
    except ValueError as error:
        raise ModelError(
            f"spectrum of '{name}': {error}; 'hann', 'boxcar' and 'flattop' are usual"
        ) from error
    amplitude: Array = np.asarray(2 * np.abs(np.fft.rfft(w * values)) / w.sum(), dtype=float)
    amplitude[0] /= 2
    if t.size % 2 == 0:
        amplitude[-1] /= 2
    return np.asarray(np.fft.rfftfreq(t.size, float(steps.mean())), dtype=float), amplitude, unit


def plot_spectra(
    motion: Motion,
    names: Sequence[str],
    path: str | Path | None = None,
    *,
    window: str = "hann",
    logarithmic: bool = True,
    limit: float | None = None,
) -> Figure:
    """Amplitude spectra of named quantities (the degrees of freedom by default), one panel for each unit.

    Parameters
    ----------
    window : str
        See `spectrum`.
    logarithmic : bool
        Logarithmic scale of the amplitudes.
    limit : float, optional
        Largest frequency shown [Hz].
    """
    found = {name: spectrum(motion, name, window) for name in names or motion.dofs}
    units = list(dict.fromkeys(unit for _, _, unit in found.values()))
    size = (8.0, 1.2 + 2.2 * len(units))
    with figure(len(units), size=size, sharex=True, squeeze=False) as (drawn, axes):
        for panel, unit in zip(axes[:, 0], units, strict=True):
            for i, (name, (f, amplitude, own)) in enumerate(found.items()):
                if own == unit:
                    panel.plot(f, amplitude, color=COLOURS[i % len(COLOURS)], label=name)
            if logarithmic:
                panel.set_yscale("log")
            panel.set_ylabel(f"amplitude [{unit}]" if unit else "amplitude")
            panel.legend(loc="upper right")
        axes[-1, 0].set_xlabel("frequency [Hz]")
        axes[-1, 0].set_xlim(0, limit or f[-1])
    save(drawn, path)
    return drawn


def plot_phase(motion: Motion, x: str, y: str, path: str | Path | None = None) -> Figure:
    """One quantity against another; the start is marked.

    Parameters
    ----------
    motion : Motion
    x, y : str
        Quantities, their rates or forces, as in `Motion.series`.
    path : path, optional
        Where to write the figure.
    """
    (across, unit_x), (up, unit_y) = motion.series(x), motion.series(y)
    with figure(size=(6.0, 5.0)) as (drawn, axes):
        axes.plot(across, up, color=COLOURS[0])
        axes.plot(across[:1], up[:1], "o", color=COLOURS[1], ms=5, label=f"t = {motion.t[0]:g} s")
        axes.set_xlabel(f"{x} [{unit_x}]" if unit_x else x)
        axes.set_ylabel(f"{y} [{unit_y}]" if unit_y else y)
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
    """Eigenvalues in the complex plane, of one linearization or of several, coloured by a parameter.

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
    colour = np.concatenate([np.full(z.size, s) for z, s in zip(sets, shade, strict=True)])
    with figure(size=(6.4, 5.4)) as (drawn, axes):
        axes.axvline(0, color="#222222", lw=0.8)
        axes.axhline(0, color="#222222", lw=0.8)
        style: dict[str, Any] = {"marker": "x", "s": 36, "linewidths": 1.6, "zorder": 3}
        if parameter is None:
            axes.scatter(w.real, w.imag, color=COLOURS[0], **style)
        else:
            marks = axes.scatter(w.real, w.imag, c=colour, cmap="viridis", **style)
            drawn.colorbar(marks, ax=axes, label=label)
        axes.set_xlabel("real part [1/s]")
        axes.set_ylabel("imaginary part [rad/s]")
    save(drawn, path)
    return drawn


def plot_harmonics(
    vibration: PeriodicVibration, units: Sequence[str], path: str | Path | None = None
) -> Figure:
    """Amplitudes of the harmonics of every degree of freedom of a periodic motion, one panel for each unit."""
    names, k = vibration.coefficients.names, vibration.harmonics
    amplitude = harmonic_amplitudes(vibration)
    kinds = list(dict.fromkeys(units))
    size = (8.0, 1.2 + 2.2 * len(kinds))
    with figure(len(kinds), size=size, sharex=True, squeeze=False) as (drawn, axes):
        for panel, unit in zip(axes[:, 0], kinds, strict=True):
            members = [i for i, own in enumerate(units) if own == unit]
            width = 0.8 / len(members)
            for j, i in enumerate(members):
                place = np.arange(k + 1) + (j - (len(members) - 1) / 2) * width
                panel.bar(place, amplitude[:, i], width, color=COLOURS[i % len(COLOURS)], label=names[i])
            panel.set_yscale("log")
            panel.set_ylabel(f"amplitude [{unit}]" if unit else "amplitude")
            panel.legend(loc="upper right")
        axes[-1, 0].set_xlabel(f"harmonic of {vibration.coefficients.omega:.4g} rad/s")
    save(drawn, path)
    return drawn


def harmonic_amplitudes(vibration: PeriodicVibration) -> Array:
    """Amplitudes (k + 1, nd) of the harmonics 0…k."""
    k = vibration.harmonics
    amplitude = 2 * np.abs(vibration.X[k:])
    amplitude[0] /= 2
    return np.asarray(amplitude)


def plot_branch(branch: PeriodicBranch, names: Sequence[str], path: str | Path | None = None) -> Figure:
    """Largest magnitudes of quantities, and the largest Floquet multiplier, over the speed; unstable motions dashed."""
    rows = [(branch.largest(name), name, branch[0].unit(name)) for name in names]
    rows.append((branch.modulus, "largest multiplier", ""))
    w = branch.omega
    with figure(len(rows), size=(8.0, 1.2 + 2.2 * len(rows)), sharex=True, squeeze=False) as (drawn, axes):
        for panel, (values, name, unit) in zip(axes[:, 0], rows, strict=True):
            for part, stable in branch.stretches:
                panel.plot(w[part], values[part], "-" if stable else "--", color=COLOURS[0])
            panel.plot(w[branch.folds], values[branch.folds], "o", color=COLOURS[1], label="fold")
            panel.set_ylabel(f"{name} [{unit}]" if unit else name)
        axes[-1, 0].axhline(1, color="#222222", lw=0.8)
        axes[-1, 0].set_xlabel("speed [rad/s]")
        if branch.folds:
            axes[0, 0].legend(loc="upper left")
    save(drawn, path)
    return drawn
