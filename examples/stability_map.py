"""Stability map of the bicycle: the range of speeds without control over wheelbase and trail.

The bicycle of the 2007 benchmark with other wheelbases and trails: each is built and linearized by `fx.sweep`, and its
equations are compared with the formulas of the benchmark at every point.  The stable range follows from Routh and
Hurwitz.
`fx.sweep` needs joblib and xarray, the extra ``sweep``.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

import flexel as fx
from flexel.base.arrays import Array
from flexel.examples import bicycle, whipple
from flexel.examples import bicycle_data as data
from flexel.examples.reasons import ROUNDING
from flexel.results.reproduction import Quantity, Report

WHEELBASE, TRAIL = (0.85, 1.25), (0.0, 0.16)  # [m]
COARSE, FINE = 21, 100  # points along each side: of the table, and of the picture
SPEEDS = np.linspace(0.0, 12.0, 481)  # [m/s]
MATRICES = ("M", "C1", "K0", "K2")


def parameters(wheelbase: float, trail: float) -> dict[str, float]:
    """Return the parameters of the benchmark with another wheelbase and trail [m]."""
    return data.BENCHMARK | {"w": wheelbase, "c": trail}


def build(wheelbase: float, trail: float) -> fx.Model:
    """Build the bicycle with another wheelbase and trail [m]; all masses stay where they are."""
    return bicycle.model(parameters(wheelbase, trail))


def analyse(system: fx.System) -> dict[str, Array]:
    """Compute M, C1, K0 and K2 of lean and steer."""
    return bicycle.matrices(system, data.BENCHMARK["g"])


def sweep(count: int, **options: Any) -> Any:
    """Compute the matrices at count x count points, as an xarray.Dataset."""
    points = {"wheelbase": np.linspace(*WHEELBASE, count), "trail": np.linspace(*TRAIL, count)}
    return fx.sweep(build, points, analyse, **options)


def stable(found: Any) -> Array:
    """Whether the straight motion is stable (wheelbases, trails, speeds): by Routh and Hurwitz."""
    return np.asarray((conditions(found, SPEEDS) > 0).all(axis=0))


def conditions(found: Any, v: Array) -> Array:
    """Return the conditions of Routh and Hurwitz (6, wheelbases, trails, speeds), all positive where stable."""
    M, C1, K0, K2 = (found[name].values[:, :, None] for name in MATRICES)
    v = v[..., None, None]
    C, K = v * C1, data.BENCHMARK["g"] * K0 + v**2 * K2
    a4, a3, a2, a1, a0 = _determinant(M, C, K)
    hurwitz = a3 * (a2 * a1 - a3 * a0) - a4 * a1**2
    return np.array(np.broadcast_arrays(a4, a3, a2, a1, a0, hurwitz))


def margins(found: Any) -> tuple[Array, Array]:
    """Return the smallest condition over speeds (wheelbases, trails, speeds), and the largest of these, refined.

    Each condition is divided by its largest magnitude over the speeds, so that their order does not depend on units.
    """
    every = conditions(found, SPEEDS)
    size = np.abs(every).max(axis=-1, keepdims=True)
    over = np.min(every / size, axis=0)
    step = SPEEDS[1] - SPEEDS[0]
    near = np.maximum(SPEEDS[np.argmax(over, axis=-1)][..., None] + step * np.linspace(-1, 1, 41), 0.0)
    return over, np.max(np.min(conditions(found, near) / size, axis=0), axis=-1)


def ranges(found: Any) -> tuple[Array, Array, Array]:
    """Return the ends [m/s] of the stable range, by interpolation between the speeds, and the largest margin in it.

    Where no speed is stable both ends are the speed that is nearest to it, so that they continue the ranges.
    """
    size, most = margins(found)
    best = np.argmax(size, axis=-1)
    ends = []
    for step in (-1, 1):
        at = best.copy()
        for _ in range(SPEEDS.size):  # outwards from the best speed, while it is stable
            further = np.clip(at + step, 0, SPEEDS.size - 1)
            at = np.where(_at(size, further) > 0, further, at)
        beyond = np.clip(at + step, 0, SPEEDS.size - 1)
        inside, outside = _at(size, at), _at(size, beyond)
        crossing = (inside > 0) & (outside <= 0)
        share = np.where(crossing, inside / np.where(crossing, inside - outside, 1.0), 0.0)
        ends.append(SPEEDS[at] + share * (SPEEDS[beyond] - SPEEDS[at]))
    return ends[0], ends[1], most


def _at(values: Array, number: Any) -> Array:
    """Pick one value of the last axis for each of the others."""
    return np.asarray(np.take_along_axis(values, number[..., None], axis=-1)[..., 0])


def _determinant(M: Array, C: Array, K: Array) -> list[Array]:
    """Return the coefficients of det(s² M + s C + K), from that of s⁴ on."""
    parts: list[Any] = [0.0] * 5
    for i, A in enumerate((M, C, K)):
        for j, B in enumerate((M, C, K)):
            parts[i + j] = parts[i + j] + A[..., 0, 0] * B[..., 1, 1] - A[..., 0, 1] * B[..., 1, 0]
    return parts


def widths(steady: Array) -> Array:
    """Return the width [m/s] of the stable range; NaN where there is none."""
    width = steady.sum(axis=-1) * (SPEEDS[1] - SPEEDS[0])
    return np.where(width > 0, width, np.nan)


def reproduce(out: Path | None = None) -> Report:
    """Compare the equations with the formulas on a coarse grid; write the map of 10⁴ points to `out`, if given."""
    found = sweep(COARSE)
    files: list[Path] = []
    if out is not None:
        from flexel.examples.stability_map_figures import stability

        files = [stability(sweep(FINE), out / "stability_map.png")]
    return Report("stability-map", rows(found), files)


def rows(found: Any) -> list[Quantity]:
    """Return the largest differences from the formulas, and the ranges of the map."""
    w, c = found.wheelbase.values, found.trail.values
    exact = [[whipple.matrices(parameters(float(a), float(b))) for b in c] for a in w]
    table = []
    for name in MATRICES:
        formula = np.array([[matrices[name] for matrices in line] for line in exact])
        off = np.abs(found[name].values - formula).max() / np.abs(formula).max()
        table.append(
            Quantity(f"{name}_largest_error", float(off), 0.0, 1e-13, "", data.PAPER + ", appendix A",
                     kind="published", reason=ROUNDING)
        )  # fmt: skip
    width = widths(stable(found))
    widest = np.unravel_index(np.nanargmax(width), width.shape)
    table += [
        Quantity("share_with_a_stable_range", float(np.isfinite(width).mean())),
        Quantity("widest_range", float(width[widest]), unit="m/s"),
        Quantity("widest_at_wheelbase", float(w[widest[0]]), unit="m"),
        Quantity("widest_at_trail", float(c[widest[1]]), unit="m"),
    ]
    return table
