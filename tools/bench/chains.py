"""The right-hand side of chains of rigid rods on hinges in space, hanging from one end or from both, and of a ladder.

All hinges turn about y, so the chain moves in a plane, and its equations are known in closed form.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

import flexel as fx
from bench.timing import Work
from flexel.base.arrays import Array
from flexel.examples import linkages

LENGTH, MASS = 0.1, 0.1  # of a rod [m], [kg]
INERTIA = (1e-5, 8e-5, 8e-5)  # about its centre [kg m²]
GRAVITY = 9.81
SAG = 0.8  # direction of the first rod of a chain held at both ends, below the horizontal [rad]


def drawn(n: int, closed: bool) -> Array:
    """Return the directions (n,) below the horizontal [rad] in which the rods are drawn; hinge angles start there."""
    return SAG * (1 - (2 * np.arange(n) + 1) / n) if closed else np.zeros(n)


def chain(n: int, closed: bool = False) -> fx.System:
    """Build a chain of n rods along x, or sagging in an arc between two hinges.

    The last point of the closed chain is held in x and z only. This is a hinge without redundant conditions: the n
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
    m.independent(*(f"h{i + 1}.angle" for i in range(n) if i not in dependent(n, closed)))
    if closed:
        m.fix(f"p{n}.x", f"p{n}.z")
    return m.build()


@dataclass(frozen=True)
class Moving:
    """A bent chain in motion: angles [rad] and rates [rad/s] (n,) of its hinges, and its motion in closed form."""

    angles: Array
    rates: Array
    closed: bool

    @property
    def directions(self) -> Array:
        """Of the rods, below the horizontal [rad]."""
        return drawn(self.angles.size, self.closed) + np.cumsum(self.angles)

    def error(self, found: Array, some: Sequence[int] | None = None) -> float:
        """Return the largest difference of accelerations of some hinges (default: all) over the largest of them."""
        expected = accelerations(self.directions, np.cumsum(self.rates), self.closed)
        if some is not None:
            expected = expected[some]
        return float(np.abs(found - expected).max() / np.abs(expected).max())


def dependent(n: int, closed: bool) -> list[int]:
    """Return the dependent hinges: with the last point, they are the corners of a triangle."""
    return [0, n // 2] if closed else []


def moving(n: int, closed: bool = False) -> Moving:
    """Return a state of the chain: random, except for the hinges that follow from the closure."""
    rng, rest = np.random.default_rng(1), dependent(n, closed)
    found = Moving(0.01 * rng.standard_normal(n), 0.5 * rng.standard_normal(n), closed)
    if not closed:
        return found
    end = tip(drawn(n, closed))[0]
    for _ in range(20):  # Newton's method: 10 digits from a good start need four
        place, slopes = tip(found.directions)
        found.angles[rest] -= np.linalg.solve(slopes[:, rest], place - end)
    slopes = tip(found.directions)[1]
    found.rates[rest] = 0.0
    found.rates[rest] = -np.linalg.solve(slopes[:, rest], slopes @ found.rates)
    return found


def tip(theta: Array) -> tuple[Array, Array]:
    """Return the position (2,) [m] of the last point in the plane, and its derivatives (2, n) by the hinge angles."""
    u, across = np.array([np.cos(theta), -np.sin(theta)]), np.array([-np.sin(theta), -np.cos(theta)])
    return LENGTH * u.sum(axis=1), LENGTH * np.cumsum(across[:, ::-1], axis=1)[:, ::-1]


def right_hand_side(n: int, closed: bool = False) -> Work:
    """Time `System.rhs` of a bent chain in motion, at two alternating states."""
    system, state = chain(n, closed), moving(n, closed)
    hinges = [f"h{i}.angle" for i in range(1, n + 1)]
    some = [hinges.index(name) for name in system.dynamic]
    angles, rates = (
        dict(zip(system.dynamic, values[some], strict=True)) for values in (state.angles, state.rates)
    )
    start = system.state_at(angles, rates)
    y = np.concatenate([start.q, start.qd])
    points = y, y + 1e-6

    def run() -> list[Array]:
        return [system.rhs(0.0, point) for point in points]

    return Work(run, lambda rates: state.error(rates[0][start.q.size :], some), count=2)


def accelerations(theta: Array, omega: Array, closed: bool) -> Array:
    """Return accelerations (n,) [rad/s²] of the hinges of the planar chain, from directions and angular rates of rods.

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


def ladder(n: int) -> Work:
    """Time `System.rhs` of n moving cranks with couplers between them, at two alternating states."""
    system, y = linkages.ladder(n), linkages.ladder_state()
    points = y, y + 1e-6

    def run() -> list[Array]:
        return [system.rhs(0.0, point) for point in points]

    return Work(run, lambda rates: linkages.ladder_error(rates[0], n), count=2)
