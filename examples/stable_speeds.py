"""The range of speeds in which a bicycle is stable, from its linear equations of lean and steer."""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np
from scipy.optimize import brentq

import flexel as fx
from flexel.base.arrays import Array
from flexel.mechanics.modes import Reduced

LEAN_STEER = ("lean.angle", "steer.angle")


def by_formulas(matrices: Mapping[str, Array], gravity: float) -> Callable[[float], Reduced]:
    """The equations at a speed [m/s], from M, C1, K0 and K2 of the paper of 2007."""

    def equations(v: float) -> Reduced:
        K = gravity * matrices["K0"] + v**2 * matrices["K2"]
        return Reduced(LEAN_STEER, matrices["M"], v * matrices["C1"], K)

    return equations


def stable_speeds(equations: Callable[[float], Reduced], fastest: float = 12.0) -> tuple[float, float | None]:
    """Weave speed and capsize speed [m/s] (None: no capsize below `fastest`), as roots on the lean-steer block.

    Parameters
    ----------
    equations : callable
        The lean-steer block at a speed [m/s].
    fastest : float
        [m/s]

    Raises
    ------
    LinearizationError
        If the bicycle is nowhere stable.
    """

    def weave(v: float) -> float:
        """Real part of the complex pair, positive where there is none."""
        w = equations(v).eigenvalues()
        pair = w[np.abs(w.imag) > 1e-6]
        return float(np.max(pair.real)) if pair.size else 1.0

    def capsize(v: float) -> float:
        return float(np.linalg.det(equations(v).K))

    grid = np.linspace(0.0, fastest, 49)
    oscillation, divergence = [weave(v) for v in grid], [capsize(v) for v in grid]
    last = max(i for i in range(grid.size) if oscillation[i] > 0)
    fall = [i for i in range(grid.size - 1) if divergence[i] > 0 >= divergence[i + 1]]
    end = _root(capsize, grid[fall[-1]], grid[fall[-1] + 1]) if fall else None
    if last < grid.size - 1:
        start = _root(weave, grid[last], grid[last + 1])
        between = (start + (fastest if end is None else end)) / 2
        if (end is None or start < end) and equations(between).eigenvalues().real.max() < 0:
            return start, end
    raise fx.LinearizationError(
        f"stable_range: this bicycle is stable at no speed up to {fastest:g} m/s: "
        + (
            f"its weave grows up to {fastest:g} m/s"
            if last == grid.size - 1
            else f"its weave grows up to {start:.4g} m/s, and another of its modes beyond"
        )
    )


def _root(function: object, a: float, b: float) -> float:
    return float(brentq(function, a, b, xtol=1e-13, rtol=8.9e-16))  # type: ignore[call-overload]
