"""References of motions, integrated over positions and velocities at 1e-12, without minimal coordinates."""

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from scipy.integrate import DOP853, OdeSolution

import flexel as fx
from flexel.base.arrays import Array
from flexel.base.quaternions import matrix

RTOL, ATOL = 1e-12, 1e-14
Rates = Callable[[float, Array], Array]


def follow(rates: Rates, project: Callable[[Array], Array], y0: Array, duration: float) -> Any:
    """y(t) over the duration [s]; after every step y is projected onto the constraints."""
    solver = DOP853(rates, 0.0, y0, duration, rtol=RTOL, atol=ATOL)
    times, pieces = [0.0], []
    while solver.t < duration:
        message = solver.step()
        assert message is None, message
        times.append(solver.t)
        pieces.append(solver.dense_output())
        solver.y = project(solver.y)
        solver.f = rates(solver.t, solver.y)
    return OdeSolution(times, pieces)


def _nearest(C: Array, residual: Array) -> Array:
    """The smallest change that takes away the residual: orthogonal projection."""
    return np.asarray(np.linalg.lstsq(C, residual, rcond=1e-13)[0])


def saddle(M: Array, C: Array, f: Array, g: Array) -> Array:
    """Accelerations of M a + C' s = f, C a = g."""
    n, k = M.shape[0], C.shape[0]
    A = np.zeros((n + k, n + k))
    A[:n, :n], A[:n, n:], A[n:, :n] = M, C.T, C
    return np.asarray(np.linalg.solve(A, np.concatenate([f, g]))[:n])


class Rods:
    """A planar chain of uniform rods of 1 kg/m on the fixed origin; Lagrange's equations in their absolute angles.

    Parameters
    ----------
    points : ndarray (n, 2)
        Ends of the rods as drawn [m].
    speeds : ndarray (n,)
        Angular velocities at the start [rad/s]; the nearest ones that the held end allows are taken.
    gravity : float
        Downwards [m/s²].
    wheel, load : float
        Moment of inertia that turns with the first rod [kg m²], mass at the end of the last [kg].
    held : tuple of int
        Components of the end that are held: none (a chain), both (a four-bar), the second (a slider-crank).
    """

    def __init__(
        self,
        points: Array,
        speeds: Array,
        gravity: float = 9.81,
        wheel: float = 0.0,
        load: float = 0.0,
        held: tuple[int, ...] = (),
    ) -> None:
        self.points, self.gravity, self.wheel, self.load, self.held = points, gravity, wheel, load, list(held)
        d = np.diff(points, axis=0, prepend=np.zeros((1, 2)))
        l = self.lengths = np.hypot(*d.T)
        self.drawn = np.arctan2(d[:, 1], d[:, 0])
        beyond = np.cumsum(l[::-1])[::-1] - l + load
        self._arm = l / 2 + beyond  # half of the own mass and that beyond; it decreases outwards
        self._inertia = np.outer(l, l) * np.minimum.outer(self._arm, self._arm)
        np.fill_diagonal(self._inertia, l**2 * (l / 3 + beyond))
        self._inertia[0, 0] += wheel
        self.speeds = self.project(np.concatenate([self.drawn, speeds]))[l.size :]

    def _closure(self, angles: Array) -> Array:
        """Derivatives of the held components by the angles."""
        return np.asarray(np.array([-np.sin(angles), np.cos(angles)])[self.held] * self.lengths)

    def rates(self, t: float, y: Array) -> Array:
        """Angular velocities and accelerations (2 n,)."""
        angles, w = np.split(y, 2)
        apart = angles[:, None] - angles
        f = -(self._inertia * np.sin(apart)) @ w**2 - self.gravity * self.lengths * self._arm * np.cos(angles)
        g = np.array([np.cos(angles), np.sin(angles)])[self.held] @ (self.lengths * w**2)
        return np.concatenate([w, saddle(self._inertia * np.cos(apart), self._closure(angles), f, g)])

    def project(self, y: Array) -> Array:
        """The nearest angles and speeds that leave the held components of the end at rest."""
        angles, w = np.split(y, 2)
        if not self.held:
            return y
        for _ in range(3):
            end = self.lengths @ np.column_stack([np.cos(angles), np.sin(angles)])
            angles = angles - _nearest(self._closure(angles), (end - self.points[-1])[self.held])
        C = self._closure(angles)
        return np.concatenate([angles, w - _nearest(C, C @ w)])

    def energy(self, y: Array) -> float:
        """Kinetic and potential energy [J]."""
        angles, w = np.split(y, 2)
        kinetic = w @ (self._inertia * np.cos(angles[:, None] - angles)) @ w / 2
        return float(kinetic + self.gravity * np.sum(self.lengths * self._arm * np.sin(angles)))

    def follow(self, duration: float) -> Any:
        """Angles and speeds over time: a function of t."""
        return follow(self.rates, self.project, np.concatenate([self.drawn, self.speeds]), duration)

    @property
    def names(self) -> tuple[str, ...]:
        """Names of what `values` gives: ends of the rods, then their turns."""
        n = range(self.lengths.size)
        return (*(f"P{i}.{axis}" for axis in "xy" for i in n), *(f"R{i}.angle" for i in n))

    def values(self, y: Array) -> Array:
        """Coordinates of the ends and turns since the start (3 n, nt), of y (2 n, nt)."""
        angles = y[: self.lengths.size]
        ends = [
            np.cumsum(self.lengths[:, None] * directions, axis=0)
            for directions in (np.cos(angles), np.sin(angles))
        ]
        return np.concatenate([*ends, angles - self.drawn[:, None]])


class Constrained:
    """Any scleronomic system over all its coordinates; only the accelerations at given (x, v) come from it.

    Parameters
    ----------
    system : System
        In degrees of freedom that stay regular.
    angles : sequence of str
        Deformations whose turns are counted, by integration of their rates.
    """

    def __init__(self, system: fx.System, angles: Sequence[str] = ()) -> None:
        self.system, s, roles = system, system.structure, system.roles
        self.names = (*s.names[s.m + s.k :][: s.nf], *angles)
        self._nf, self._n = s.nf, s.n
        self._angles = [s.index[angle] for angle in angles]
        self._rigid, self._still = roles.rigid, np.concatenate([roles.rigid, roles.zero])

    def rates(self, t: float, y: Array) -> Array:
        """Rates of (x, v, angles)."""
        state = self._state(t, y)
        return np.concatenate([state.v, state.a, state.rates[self._angles]])

    def _state(self, t: float, y: Array) -> fx.State:
        return self.system.state(t, y[: self._n], y[self._n : 2 * self._n])

    def project(self, y: Array) -> Array:
        """The nearest coordinates and rates that satisfy the constraints."""
        y, n, nf = y.copy(), self._n, self._nf
        for _ in range(3):
            state = self._state(0.0, y)
            y[:nf] -= _nearest(state.J[self._rigid, :nf], state.e[self._rigid])
        C = self._state(0.0, y).J[self._still, :nf]
        y[n : n + nf] -= _nearest(C, C @ y[n : n + nf])
        return y

    def energy(self, y: Array) -> float:
        """Energy [J]."""
        return self._state(0.0, y).energy.total

    def follow(self, duration: float) -> Any:
        """(x, v, angles) over time: a function of t."""
        start = self.system.initial
        y0 = np.concatenate([start.x, start.v, start.e[self._angles]])
        return follow(self.rates, self.project, y0, duration)

    def values(self, y: Array) -> Array:
        """Free coordinates and angles (len(names), nt), of y (…, nt)."""
        return np.concatenate([y[: self._nf], y[2 * self._n :]])


class Balls:
    """Bodies in a chain of ball joints, each with its mass centre at the next joint; equations in angular velocities.

    Parameters
    ----------
    links : ndarray (n, 3)
        From joint to joint as drawn [m].
    masses : sequence of float (n,)
        [kg]
    inertia : ndarray (3,)
        Principal moments of each body, along the global axes as drawn [kg m²].
    omega : ndarray (n, 3)
        Angular velocities at the start [rad/s].
    """

    def __init__(self, links: Array, masses: Sequence[float], inertia: Array, omega: Array) -> None:
        self.links, self.masses, self.inertia, self.omega = links, masses, inertia, omega
        n = range(len(links))
        self.names = (
            *(f"P{i}.{axis}" for i in n for axis in "xyz"),
            *(f"F{i}.lambda{k}" for i in n for k in range(4)),
        )

    def rates(self, t: float, y: Array) -> Array:
        """Rates of Euler parameters (n, 4) and angular velocities (n, 3), one after the other."""
        n = len(self.links)
        turns, omega = y[: 4 * n].reshape(n, 4), y[4 * n :].reshape(n, 3)
        M, f = np.zeros((3 * n, 3 * n)), np.zeros(3 * n)
        J, bias = np.zeros((3, 3 * n)), np.zeros(3)
        for i in range(n):
            own, R = slice(3 * i, 3 * i + 3), matrix(turns[i])
            arm, inertia, w = R @ self.links[i], (R * self.inertia) @ R.T, omega[i]
            J[:, own] = -_cross(arm)
            bias = bias + np.cross(w, np.cross(w, arm))
            M += self.masses[i] * J.T @ J
            f += self.masses[i] * J.T @ (np.array((0, 0, -9.81)) - bias)
            M[own, own] += inertia
            f[own] -= np.cross(w, inertia @ w)
        scalar = -np.sum(omega * turns[:, 1:], axis=1, keepdims=True) / 2
        vector = (turns[:, :1] * omega + np.cross(omega, turns[:, 1:])) / 2
        return np.concatenate([np.hstack([scalar, vector]).ravel(), np.linalg.solve(M, f)])

    def project(self, y: Array) -> Array:
        """Euler parameters of norm one."""
        n = len(self.links)
        turns = y[: 4 * n].reshape(n, 4)
        return np.concatenate([(turns / np.linalg.norm(turns, axis=1, keepdims=True)).ravel(), y[4 * n :]])

    def follow(self) -> Callable[[Array], Array]:
        """The quantities `names` over time, for a second."""
        n = len(self.links)
        y0 = np.concatenate([np.tile([1.0, 0.0, 0.0, 0.0], n), self.omega.ravel()])
        y = follow(self.rates, self.project, y0, 1.0)

        def values(t: Array) -> Array:
            return np.column_stack([self._placed(column[: 4 * n].reshape(n, 4)) for column in y(t).T])

        return values

    def _placed(self, turns: Array) -> Array:
        ends = np.cumsum([matrix(turn) @ link for turn, link in zip(turns, self.links, strict=True)], axis=0)
        return np.concatenate([ends.ravel(), turns.ravel()])


def _cross(a: Array) -> Array:
    """Matrix of the vector product with a."""
    return np.array([(0, -a[2], a[1]), (a[2], 0, -a[0]), (-a[1], a[0], 0)])
