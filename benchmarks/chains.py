"""Chains of rigid rods on hinges in space, hanging from one end or from both: the right-hand side.

All hinges turn about y, so the chain moves in a plane, where its equations are known in closed form.
"""

from __future__ import annotations

import numpy as np

import flexel as fx
from flexel.base.arrays import Array
from flexel.benchmarks.timing import Work

LENGTH, MASS = 0.1, 0.1  # of a rod [m], [kg]
INERTIA = (1e-5, 8e-5, 8e-5)  # about its centre [kg m²]
GRAVITY = 9.81
SAG = 0.8  # direction of the first rod of a chain that is held at both ends, below the horizontal [rad]


def drawn(n: int, closed: bool) -> Array:
    """Directions (n,) below the horizontal [rad] in which the rods are drawn; hinges count their angles from there."""
    return SAG * (1 - (2 * np.arange(n) + 1) / n) if closed else np.zeros(n)


def chain(n: int, closed: bool = False) -> fx.System:
    """A chain of n rods along x, or sagging in an arc between two hinges.

    The last point of the closed chain is held in x and z only. That is a hinge without what is redundant: the n
    hinges already keep the chain in its plane and the axis at its end parallel to theirs.
    """
    angles = drawn(n, closed)
    places = np.cumsum(LENGTH * np.column_stack([np.cos(angles), 0 * angles, -np.sin(angles)]), axis=0)
    m = fx.Model(gravity=(0, 0, -GRAVITY))
    m.point("p0", (0, 0, 0), fixed=True)
    m.frame("r0", fixed=True)
    for i, angle in enumerate(angles, start=1):
        m.point(f"p{i}", places[i - 1])
        m.frame(f"r{i}", (np.cos(angle / 2), 0, np.sin(angle / 2), 0))
        m.hinge(f"h{i}", f"r{i - 1}", f"r{i}", axis=(0, 1, 0))
        m.beam(f"b{i}", f"p{i - 1}", f"r{i}", f"p{i}")
        m.body(f"m{i}", f"p{i}", f"r{i}", mass=MASS, inertia=INERTIA, offset=(-LENGTH / 2, 0, 0))
    dependent = (1, n // 2 + 1) if closed else ()  # with the last point the corners of a triangle
    m.independent(*(f"h{i}.angle" for i in range(1, n + 1) if i not in dependent))
    if closed:
        m.fix(f"p{n}.x", f"p{n}.z")
    return m.build()


def right_hand_side(n: int, closed: bool = False) -> Work:
    """`System.rhs` of a bent chain in motion, at two states in turn."""
    system, rng = chain(n, closed), np.random.default_rng(1)
    bent = {z: system.initial[z] + 0.01 * rng.standard_normal() for z in system.dynamic}
    state = system.state_at(bent, {z: 0.5 * rng.standard_normal() for z in system.dynamic})
    y = np.concatenate([state.q, state.qd])
    points = y, y + 1e-6

    def run() -> list[Array]:
        return [system.rhs(0.0, z) for z in points]

    def error(rates: list[Array]) -> float:
        hinges = [f"h{i}.angle" for i in range(1, n + 1)]
        directions = drawn(n, closed) + np.cumsum([state[z] for z in hinges])
        turns = np.cumsum([state.rate(z) for z in hinges])
        expected = accelerations(directions, turns, closed)[[hinges.index(z) for z in system.dynamic]]
        return float(np.abs(rates[0][state.q.size :] - expected).max() / np.abs(expected).max())

    return Work(run, error, count=2)


def accelerations(theta: Array, omega: Array, closed: bool) -> Array:
    """Accelerations (n,) [rad/s²] of the hinges of the planar chain, from directions and angular rates of its rods.

    The centre of rod i is at the sum of arm[i, j] u(j) over the rods j, where u is the direction of a rod.
    """
    n = theta.size
    arm = LENGTH * (np.tri(n, k=-1) + np.eye(n) / 2)
    L = MASS * arm.T @ arm
    between = theta[:, None] - theta
    M = L * np.cos(between) + INERTIA[1] * np.eye(n)
    f = MASS * GRAVITY * arm.sum(axis=0) * np.cos(theta) - L * np.sin(between) @ omega**2
    if closed:
        u, across = np.array([np.cos(theta), -np.sin(theta)]), np.array([-np.sin(theta), -np.cos(theta)])
        M = np.block([[M, across.T], [across, np.zeros((2, 2))]])
        f = np.concatenate([f, u @ omega**2])
    return np.diff(np.linalg.solve(M, f)[:n], prepend=0.0)
