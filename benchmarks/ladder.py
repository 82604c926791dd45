"""Coupled mechanisms: a row of cranks that couplers keep parallel.

Every pair of adjacent cranks closes a loop, and all move in one motion, whose equation is known in closed form.
"""

from __future__ import annotations

import numpy as np

import flexel as fx
from flexel.base.arrays import Array
from flexel.benchmarks.timing import Work

CRANK, SPACING = 0.2, 0.3  # length of a crank and of a coupler [m]
MASS = 1.0  # of bars per length [kg/m]
GRAVITY = 9.81
ANGLE, RATE = 0.7, 2.0  # of the cranks above the horizontal [rad], [rad/s]


def ladder(n: int) -> fx.System:
    """Build n planar cranks of uniform bars, and n - 1 couplers between their tips."""
    m = fx.Model(gravity=(0, -GRAVITY))
    for i in range(n):
        m.point(f"a{i}", (SPACING * i, 0), fixed=True)
        m.point(f"b{i}", (SPACING * i + CRANK * np.cos(ANGLE), CRANK * np.sin(ANGLE)))
        m.truss(f"crank{i}", f"a{i}", f"b{i}", mass_per_length=MASS)
    for i in range(1, n):
        m.truss(f"coupler{i}", f"b{i - 1}", f"b{i}", mass_per_length=MASS)
    m.independent("b0.x")
    return m.build()


def right_hand_side(n: int) -> Work:
    """Time `System.rhs` of the moving cranks, at two alternating states."""
    system = ladder(n)
    y = np.array([CRANK * np.cos(ANGLE), -CRANK * np.sin(ANGLE) * RATE])
    points = y, y + 1e-6

    def run() -> list[Array]:
        return [system.rhs(0.0, point) for point in points]

    def error(rates: list[Array]) -> float:
        angular = (rates[0][1] + CRANK * np.cos(ANGLE) * RATE**2) / (-CRANK * np.sin(ANGLE))
        return abs(float(angular) / acceleration(n) - 1)

    return Work(run, error, count=2)


def acceleration(n: int) -> float:
    """Return the acceleration of the cranks, as one body on a hinge [rad/s²]: couplers do not turn."""
    crank, coupler = MASS * CRANK, MASS * SPACING
    inertia = (n * crank / 3 + (n - 1) * coupler) * CRANK**2
    return -float(GRAVITY * (n * crank / 2 + (n - 1) * coupler) * CRANK * np.cos(ANGLE) / inertia)
