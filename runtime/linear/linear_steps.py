"""Steps of linear equations y' = A(t) y by Radau IIA of order 5, and their refinement.

Strongly damped high modes need no short steps.  Source: Hairer and Wanner, "Solving ordinary differential equations
II", IV.5.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from scipy.interpolate import make_interp_spline

from flexel.base.arrays import Array
from flexel.base.blas import one_thread
from flexel.base.errors import LinearizationError
from flexel.integration.radau_tableau import NODES, WEIGHTS

BATCH_STEPS = 64  # steps computed together; limits memory
MOST_PARTS = 256  # of an interval between two times
FIRST_INTERVALS, MOST_INTERVALS = 16, 1024  # of the spline of matrices
Matrices = Callable[[Array], Array]
ORDER = 31  # change after halving the steps over the remaining error, for order 5


def step_matrices(A: Array, h: Array) -> Array:
    """Return the matrices (s, n, n) that advance y over steps, for A (s, 3, n, n) at the nodes of steps of length h."""
    n = A.shape[-1]
    coupled = np.einsum("ij,sjab,s->siajb", WEIGHTS, A, h).reshape(-1, 3 * n, 3 * n)
    return np.asarray(np.linalg.solve(np.eye(3 * n) - coupled, np.tile(np.eye(n), (3, 1)))[:, 2 * n :])


def nodes(times: Array, parts: int) -> tuple[Array, Array]:
    """Return the times (s, 3) of the nodes, and the lengths (s,), of steps between times (nt,), each in equal parts."""
    fractions = np.arange(parts) / parts
    lengths = np.diff(times)
    starts = (times[:-1, None] + lengths[:, None] * fractions).ravel()
    h = np.repeat(lengths / parts, parts)
    return starts[:, None] + h[:, None] * NODES, h


def transitions(rates: Callable[[Array], Array], times: Array, parts: int) -> Array:
    """Return the transition matrices (nt - 1, n, n) from each time to the next, with `parts` steps in between.

    Parameters
    ----------
    rates : callable
        Matrices A (nodes, n, n) at times (nodes,) [s].
    """
    at, h = nodes(times, parts)
    found = []
    for first in range(0, h.size, BATCH_STEPS):
        batch = slice(first, first + BATCH_STEPS)
        A = rates(at[batch].ravel())
        found.append(step_matrices(A.reshape(-1, 3, *A.shape[1:]), h[batch]))
    steps = np.concatenate(found)
    steps = steps.reshape(-1, parts, *steps.shape[1:])
    product = steps[:, 0]
    for i in range(1, parts):
        product = steps[:, i] @ product
    return np.asarray(product)


def interpolated(values: Callable[[Array], Array], first: float, last: float, tolerance: float) -> Matrices:
    """Return a function as a spline of degree 5 over a span of time, or itself where it is not smooth enough.

    The matrices of a motion vary slowly compared with the vibrations, so that few of them are needed.

    Parameters
    ----------
    values : callable
        Values (nt, …) at times (nt,) [s].
    tolerance : float
        Error between the nodes, relative to the largest value.
    """
    grid = np.linspace(first, last, FIRST_INTERVALS + 1)
    known = values(grid)
    while grid.size <= MOST_INTERVALS:
        spline = make_interp_spline(grid, known, k=5)
        between = (grid[:-1] + grid[1:]) / 2
        new = values(between)
        error = np.abs(spline(between) - new).max(initial=0.0)
        grid = np.insert(grid, np.arange(1, grid.size), between)
        known = np.insert(known, np.arange(1, known.shape[0]), new, axis=0)
        if error <= tolerance * np.abs(known).max(initial=1e-300):
            finer: Matrices = make_interp_spline(grid, known, k=5)
            return finer
    return values


def refined(
    compute: Callable[[int], Array], tolerance: float, owner: str, most: int = MOST_PARTS, least: int = 1
) -> Array:
    """Double the number of steps until the result changes by less than the tolerance, relative to its largest entry.

    Parameters
    ----------
    compute : callable
        The result for a number of steps in each interval.
    owner : str
        Caller named in the error.

    Raises
    ------
    LinearizationError
        If the tolerance is not met with `most` steps.
    """
    parts, change = least, np.inf
    with one_thread():
        last = compute(parts)
        while parts < most:
            parts *= 2
            new = compute(parts)
            change = float(np.abs(new - last).max(initial=0.0)) / ORDER
            change /= max(float(np.abs(new).max(initial=0.0)), 1e-300)
            last = new
            if change < tolerance:
                return last
    raise LinearizationError(
        f"{owner}: accurate to {change:.1g} with {most} steps between two times, but {tolerance:.1g} was requested; "
        "give more times, or a larger tolerance"
    )
