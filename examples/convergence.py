"""How many elements a problem needs: convergence over meshes, orders, extrapolation.

Imports numpy and the errors.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from flexel.base.arrays import Array
from flexel.base.errors import FlexelError

MOST = 128  # elements, beyond which the search gives up


def order(errors: Sequence[float]) -> float:
    """Order of convergence from the errors of the last two of meshes that double."""
    return float(np.log2(errors[-2] / errors[-1]))


def romberg(values: Sequence[Array]) -> Array:
    """Limit of values on meshes that double, whose errors go with h², h⁴, ...; two or three meshes are usual."""
    rows = [np.asarray(z, dtype=float) for z in values]
    power = 4.0
    while len(rows) > 1:
        rows = [(power * b - a) / (power - 1) for a, b in zip(rows, rows[1:], strict=False)]
        power *= 4.0
    return rows[0]


def elements_needed(
    error: Callable[[int], float], bounds: Sequence[float], fewest: int = 1
) -> list[int | None]:
    """Fewest elements with which the error stays below each of some bounds; None above `MOST`.

    Meshes are doubled until the error is below the smallest bound; between the last mesh that is too coarse and the
    next the error is taken to fall steadily.  A mesh on which no solution is found counts as too coarse.

    Parameters
    ----------
    error : callable
        Relative error on a mesh of n elements.
    """
    found: dict[int, float] = {}

    def log_error(n: int) -> float:
        if n not in found:
            try:
                found[n] = float(np.log(error(n)))
            except FlexelError:
                found[n] = 10.0
        return found[n]

    meshes = [fewest]
    while log_error(meshes[-1]) > np.log(min(bounds)):
        meshes.append(2 * meshes[-1])
        if meshes[-1] > MOST:
            break
    return [_fewest(log_error, float(np.log(z)), meshes) for z in bounds]


def _fewest(log_error: Callable[[int], float], bound: float, meshes: Sequence[int]) -> int | None:
    """Fewest elements by interpolation with the power of n that the error falls with."""
    coarse = [n for n in meshes if n <= MOST and log_error(n) > bound]
    if not coarse:
        return meshes[0]
    low, high = coarse[-1], 2 * coarse[-1]
    if high > MOST:
        return None
    while high - low > 1:
        share = (log_error(low) - bound) / (log_error(low) - log_error(high))
        guess = int(np.clip(np.ceil(low * (high / low) ** share), low + 1, high - 1))
        if log_error(guess) > bound:
            low = guess
        elif log_error(guess - 1) > bound:
            return guess
        else:
            high = guess - 1
    return high
