"""The defect of an interpolation of DOP853 shows its error, where it is looked at, in every step that is stable."""

from collections.abc import Callable

import numpy as np
import pytest
from numpy.polynomial import legendre
from scipy.integrate._ivp import dop853_coefficients as tableau

from flexel.base.arrays import Array
from flexel.integration import dense

PARTS = np.linspace(0.01, 0.99, 99)
ORDERS = {
    7: (dense.CHECK, dense.SLOPE_7, lambda part: dense._shares(part) @ dense.SEVENTH),
    8: (dense.FINAL, dense.SLOPE_8, lambda part: dense._legendre(2 * part - 1) @ dense.EIGHTH),
}


def of_the_state(z: complex) -> tuple[Array, Callable[[float], complex]]:
    """Rates times the step of y' = λy from one, for z = λh, and the solution less its start."""
    K: Array = np.zeros(dense.INSIDE, complex)
    for i in range(12):
        K[i] = z * (1 + tableau.A[i, :i] @ K[:i])
    K[12] = z * (1 + tableau.B @ K[:12])
    for i in range(dense.EXTRA, dense.INSIDE):
        K[i] = z * (1 + dense.ROWS[i - dense.EXTRA, :i] @ K[:i])
    return K, lambda part: complex(np.exp(z * part) - 1)


def of_time(z: complex) -> tuple[Array, Callable[[float], complex]]:
    """The same of y' = exp(z t/h)/h."""
    times = np.array([*tableau.C[:12], 1.0, *dense.PLACED])
    return np.exp(z * times), lambda part: complex((np.exp(z * part) - 1) / z)


def ratio(order: int, K: Array, solution: Callable[[float], complex]) -> float:
    """The defect times the step, over the largest error of the interpolation."""
    stage, slope, shares = ORDERS[order]
    error = max(abs(shares(part) @ K - solution(part)) for part in PARTS)
    return float(abs(slope @ K - K[stage]) / error)


@pytest.mark.parametrize("order", ORDERS)
def test_a_defect_is_some_times_the_error(order: int) -> None:
    """At 0.75 that of order 8 was 0.03 times the error of a part that is damped within a step."""
    angles, sizes = np.radians([180, 170, 160, 150, 135, 120, 100, 90]), np.arange(0.5, 6.6, 0.25)
    made = [size * np.exp(1j * angle) for angle in angles for size in sizes]
    stable = [K for K in map(of_the_state, made) if abs(1 + tableau.B @ K[0][:12]) <= 1.01]
    assert len(stable) > 150
    found = [ratio(order, *K) for K in stable]
    assert 1.7 < min(found) and max(found) < 11
    found = [ratio(order, *of_time(z)) for z in (*made, 1, 3, 5) if abs(z) <= 4]
    assert 1.6 < min(found) and max(found) < 6


def test_both_interpolations_end_where_the_step_ends() -> None:
    K, _ = of_the_state(-2.0)
    ends = dense.SEVENTH[0], legendre.legval(1.0, dense.EIGHTH)
    assert all(abs(end @ K - tableau.B @ K[:12]) < 1e-14 for end in ends)
