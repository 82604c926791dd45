"""Reissner's rod, clamped at the origin along x and loaded at its end: shooting on its differential equations.

The strains are stretch and shear (N/EA, V/GA) and twist and curvature (T/GJ, M/EI) in the axes of the section
(Reissner 1972 in the plane, Simo 1985 in space); force and moment at the end keep their directions.
"""

from collections.abc import Callable, Sequence

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import root

from flexel.base.arrays import Array
from flexel.base.quaternions import matrix

STEPS = 4  # of the load, each starts from the moment found before


def _shot(rates: Callable[[Array, Array], Array], start: Array, loads: Array, size: int) -> Array:
    """State at the end of the rod whose last `size` entries, the moment, are the last entries of the loads there."""
    moment = np.zeros(size)
    for share in np.arange(1, STEPS + 1) / STEPS:

        def end(moment: Array, load: Array = share * loads) -> Array:
            y0 = np.concatenate([start, moment])
            found = solve_ivp(
                lambda s, y: rates(y, load), (0, 1), y0, method="DOP853", rtol=1e-10, atol=1e-12
            )
            return np.asarray(found.y[:, -1])

        solution = root(
            lambda trial, load=share * loads: end(trial)[-size:] - load[-size:], moment, tol=1e-12
        )
        assert np.max(np.abs(solution.fun)) < 1e-9
        moment = solution.x
    return end(moment)


def planar_tip(EA: float, EI: float, GA: float, force: Sequence[float], moment: float) -> Array:
    """Place and angle (3,) of the end; GA may be infinite."""

    def rates(y: Array, load: Array) -> Array:
        c, s = np.cos(y[2]), np.sin(y[2])
        along, across = 1 + (c * load[0] + s * load[1]) / EA, (c * load[1] - s * load[0]) / GA
        dx, dy = c * along - s * across, s * along + c * across
        return np.array([dx, dy, y[3] / EI, dy * load[0] - dx * load[1]])

    return _shot(rates, np.zeros(3), np.array([*force, moment]), 1)[:3]


def spatial_tip(
    stretch: Sequence[float], bending: Sequence[float], force: Sequence[float], moment: Sequence[float]
) -> Array:
    """Place and unit quaternion (7,) of the end, for the stiffnesses (EA, GAy, GAz) and (GJ, EIy, EIz)."""

    def rates(y: Array, load: Array) -> Array:
        q = y[3:7] / np.linalg.norm(y[3:7])
        R = matrix(q)
        along = R @ (R.T @ load[:3] / stretch + [1, 0, 0])
        k = R.T @ y[7:] / bending
        turning = [-q[1:] @ k, *(q[0] * k + np.cross(q[1:], k))]
        return np.array([*along, *(0.5 * np.array(turning)), *np.cross(load[:3], along)])

    start = np.array([0, 0, 0, 1, 0, 0, 0.0])
    y = _shot(rates, start, np.array([*force, *moment], dtype=float), 3)
    return np.concatenate([y[:3], y[3:7] / np.linalg.norm(y[3:7])])
