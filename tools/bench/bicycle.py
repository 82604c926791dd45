"""The bicycle of the 2007 benchmark: right-hand side, manoeuvre M1, root loci, model build."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

import flexel as fx
from bench.timing import Work
from flexel.base.arrays import Array, ComplexArray
from flexel.examples import bicycle_data as data
from flexel.examples.bicycle import bicycle, lean_steer, rolling

SPEEDS = np.linspace(0.0, 10.0, 100)  # of the root loci [m/s]
SMALL = 1e-5  # roll rate at which the linear equations are accurate to 1e-10 [rad/s]


def published(speed: float) -> tuple[Array, Array, Array]:
    """Return M, C and K (2, 2) of lean and steer from the published matrices."""
    M, C1, K0, K2 = (np.array(matrix) for matrix in (data.M, data.C1, data.K0, data.K2))
    return M, speed * C1, data.BENCHMARK["g"] * K0 + speed**2 * K2


def build() -> Work:
    """Time the declaration and build of the model, with compiled kernels."""
    return Work(bicycle)


def right_hand_side() -> Work:
    """Time `System.rhs` at two alternating states, so that no result is remembered."""
    system = bicycle()
    start = rolling(system, data.M1_SPEED, SMALL)
    y = np.concatenate([start.q, start.qd])
    points = y, y + 1e-4
    lateral = [system.dynamic.index(name) for name in ("lean.angle", "steer.angle")]

    def run() -> list[Array]:
        return [system.rhs(0.0, point) for point in points]

    def error(rates: list[Array]) -> float:
        return accelerations_error(rates[0][start.q.size :][lateral], start.qd[lateral])

    return Work(run, error, count=2)


def accelerations_error(found: Array, rates: Array) -> float:
    """Return the error of the accelerations (2,) of lean and steer, upright at the speed of M1 with rates (2,)."""
    M, C, _ = published(data.M1_SPEED)
    expected = -np.linalg.solve(M, C @ rates)
    return float(np.abs(found - expected).max() / np.abs(expected).max())


def manoeuvre() -> Work:
    """Time manoeuvre M1 of the IFToMM benchmark, 5 s, result object included."""
    system = bicycle()
    start = rolling(system, data.M1_SPEED, data.ROLL_RATE)

    def run() -> fx.Motion:
        return system.simulate(5.0, start=start, samples=2, method="DOP853", rtol=1e-7, atol=1e-9)

    return Work(run, lambda motion: abs(motion[-1]["steer.angle"] - data.M1_STEER_5S))


def loci() -> Work:
    """Time steady motion, M, C, K and eigenvalues at 100 speeds."""
    system = bicycle()

    def run() -> list[ComplexArray]:
        return [lean_steer(system, float(v)).eigenvalues() for v in SPEEDS]

    return Work(run, worst)


def worst(found: Sequence[ComplexArray]) -> float:
    """Return the largest relative error of the eigenvalues at `SPEEDS`."""
    return max(apart(w, exact(float(v))) for w, v in zip(found, SPEEDS, strict=True))


def exact(speed: float) -> ComplexArray:
    """Return the eigenvalues (4,) of the published equations [1/s]."""
    M, C, K = published(speed)
    upper = np.hstack([np.zeros((2, 2)), np.eye(2)])
    return np.linalg.eigvals(np.vstack([upper, -np.linalg.solve(M, np.hstack([K, C]))])).astype(complex)


def apart(found: ComplexArray, expected: ComplexArray) -> float:
    """Return the largest distance of an expected eigenvalue from the nearest found one, over the largest."""
    distance = np.abs(found[:, None] - expected).min(axis=0)
    return float(distance.max() / np.abs(expected).max())
