"""Floquet theory: growth or decay of small disturbances of a periodic motion over one period.

The transition matrix comes from an implicit Runge–Kutta method, so strongly damped high modes need no short
steps; its coefficients between the samples are those of the Fourier series.  Source: Floquet (1883); Hairer and
Wanner, "Solving ordinary differential equations II", IV.5 (Radau IIA, order 5).
"""

from __future__ import annotations

import numpy as np

from flexel.base.arrays import Array, ComplexArray
from flexel.base.blas import one_thread
from flexel.base.errors import LinearizationError
from flexel.integration.radau_tableau import NODES, WEIGHTS

FIRST, MOST = 64, 4096  # steps per period
BATCH = 64  # steps computed together; limits memory


def multipliers(omega: float, M: Array, C: Array, K: Array, tolerance: float) -> ComplexArray:
    """Eigenvalues (2 nd,) of the transition matrix of M q'' + C q' + K q = 0, largest modulus first.

    Parameters
    ----------
    omega : float
        2 pi / period [rad/s].
    M, C, K : ndarray (ns, nd, nd)
        Samples at equidistant times of one period.
    tolerance : float
        Error of the transition matrix in (q', q omega), relative to its largest entry or one.

    Raises
    ------
    LinearizationError
        If the tolerance is not met.
    """
    nd = M.shape[1]
    rates = np.zeros((M.shape[0], 2 * nd, 2 * nd))  # per radian of the phase
    rates[:, :nd, :nd] = -np.linalg.solve(M, C) / omega
    rates[:, :nd, nd:] = -np.linalg.solve(M, K) / omega**2
    rates[:, nd:, :nd] = np.eye(nd)
    steps, change = FIRST, np.inf
    with one_thread():
        last = transition(rates, FIRST)
        while steps < MOST:
            steps *= 2
            new = transition(rates, steps)
            change = float(np.abs(new - last).max()) / 31 / max(float(np.abs(new).max()), 1.0)
            last = new
            if change < tolerance:
                w = np.linalg.eigvals(new).astype(complex)
                return np.asarray(w[np.lexsort((w.imag, -np.round(np.abs(w), 11)))])
    raise LinearizationError(
        f"Floquet multipliers at {omega:g} rad/s: the transition matrix is accurate to {change:.1g} with {MOST} steps, "
        f"{tolerance:.1g} was requested; the period is long compared with the vibrations"
    )


def transition(rates: Array, steps: int) -> Array:
    """Transition matrix (n, n) of y' = A y over one period of the phase, with A (ns, n, n) sampled over it."""
    n, h = rates.shape[1], 2 * np.pi / steps
    phases = (np.arange(steps)[:, None] + NODES) * h
    Y, unit = np.eye(n), np.eye(3 * n)
    for first in range(0, steps, BATCH):
        A = interpolated(rates, phases[first : first + BATCH].ravel()).reshape(-1, 3, n, n)
        coupled = h * np.einsum("ij,sjab->siajb", WEIGHTS, A).reshape(-1, 3 * n, 3 * n)
        ends = np.linalg.solve(unit - coupled, np.tile(np.eye(n), (3, 1)))[:, 2 * n :]
        for step in ends:
            Y = step @ Y
    return np.asarray(Y)


def interpolated(samples: Array, phases: Array) -> Array:
    """Values (np, …) at phases [rad], interpolated from equidistant samples (ns, …) of one period."""
    ns = samples.shape[0]
    hat = np.fft.rfft(samples.reshape(ns, -1), axis=0) / ns
    hat[1 : (ns + 1) // 2] *= 2
    angles = np.outer(phases, np.arange(hat.shape[0]))
    found = np.cos(angles) @ hat.real - np.sin(angles) @ hat.imag
    return np.asarray(found.reshape(phases.size, *samples.shape[1:]))
