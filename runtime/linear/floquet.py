"""Floquet theory: growth or decay of small disturbances of a periodic motion over one period.

The transition matrix is computed by an implicit Runge–Kutta method, so strongly damped high modes need no short
steps; its coefficients between the samples are those of the Fourier series.  Source: Floquet (1883); Hairer and
Wanner, "Solving ordinary differential equations II", IV.5 (Radau IIA, order 5).
"""

from __future__ import annotations

import numpy as np

from flexel.base.arrays import Array, ComplexArray
from flexel.base.blas import one_thread
from flexel.base.errors import LinearizationError
from flexel.linear.linear_steps import transitions

FIRST_STEPS, MAX_STEPS = 64, 4096  # steps per period


def sorted_multipliers(transition: Array) -> ComplexArray:
    """Return the eigenvalues (n,) of a transition matrix over one period, largest modulus first."""
    w = np.linalg.eigvals(transition).astype(complex)
    return np.asarray(w[np.lexsort((w.imag, -np.round(np.abs(w), 11)))])


def multipliers(
    omega: float, M: Array, C: Array, K: Array, tolerance: float, second: int | None = None
) -> ComplexArray:
    """Compute the eigenvalues (nd + n,) of the transition matrix of M q'' + C q' + K q = 0, largest modulus first.

    Parameters
    ----------
    omega : float
        2 pi / period [rad/s].
    M, C, K : ndarray (ns, n, n)
        Samples at equidistant times of one period.
    second : int, optional
        Number nd of equations of second order, the first ones; all by default.  The others give q' of what follows.
    tolerance : float
        Error of the transition matrix in (q', q omega), relative to its largest entry or one.

    Raises
    ------
    LinearizationError
        If the tolerance is not met.
    """
    n = M.shape[1]
    nd = n if second is None else second
    rates = np.zeros((M.shape[0], nd + n, nd + n))  # of (q_d' / omega, q), per radian of the phase
    own = M[:, :nd, :nd]
    rates[:, :nd, :nd] = -np.linalg.solve(own, C[:, :nd, :nd]) / omega
    rates[:, :nd, nd:] = -np.linalg.solve(own, K[:, :nd]) / omega**2
    rates[:, nd : 2 * nd, :nd] = np.eye(nd)
    rates[:, 2 * nd :, :nd] = -C[:, nd:, :nd]
    rates[:, 2 * nd :, nd:] = -K[:, nd:] / omega
    steps, change = FIRST_STEPS, np.inf
    with one_thread():
        last = transition(rates, FIRST_STEPS)
        while steps < MAX_STEPS:
            steps *= 2
            new = transition(rates, steps)
            change = float(np.abs(new - last).max()) / 31 / max(float(np.abs(new).max()), 1.0)
            last = new
            if change < tolerance:
                return sorted_multipliers(new)
    raise LinearizationError(
        f"Floquet multipliers at {omega:g} rad/s: the transition matrix is accurate to {change:.1g} with "
        f"{MAX_STEPS} steps, but {tolerance:.1g} was requested; the period is long compared with the vibrations"
    )


def transition(rates: Array, steps: int) -> Array:
    """Compute the transition matrix (n, n) of y' = A y over one period of the phase, from samples A (ns, n, n)."""
    turn = np.array([0.0, 2 * np.pi])
    return np.asarray(transitions(lambda phases: interpolated(rates, phases), turn, steps)[0])


def interpolated(samples: Array, phases: Array) -> Array:
    """Interpolate equidistant samples (ns, …) of one period at phases [rad]; returns values (np, …)."""
    ns = samples.shape[0]
    hat = np.fft.rfft(samples.reshape(ns, -1), axis=0) / ns
    hat[1 : (ns + 1) // 2] *= 2
    angles = np.outer(phases, np.arange(hat.shape[0]))
    found = np.cos(angles) @ hat.real - np.sin(angles) @ hat.imag
    return np.asarray(found.reshape(phases.size, *samples.shape[1:]))
