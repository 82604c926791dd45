"""Equations of motion with multipliers, in all coordinates of all nodes, from the twins of a model.

Derivatives are taken in the complex plane: first ones by a complex step, second ones along a direction by Cauchy's
integral over a circle.  Both have the error of rounding alone.  Redundant constraints are admitted.
"""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from scipy.linalg import qr

from campaign.algebra import dot
from campaign.case import Node
from campaign.twin import Twin
from flexel.base.arrays import Array

STEP = 1e-30  # of the complex step: nothing is subtracted
POINTS = 32  # on the circle: a rod of 0.09 m may turn with 12 rad/s
RADIUS = 0.03  # of the circle: the largest change of a coordinate, and at most of the time [s]
RANK = 1e-9  # singular values below this share of the largest are zero
CLEAR = 1e-5  # those between RANK and this make a configuration nearly singular


def jacobian(f: Callable[[Array], Array], x: Array) -> Array:
    """df/dx (..., n) by a complex step."""
    n = x.size
    return np.asarray(np.imag(f(x[:, None] + 1j * STEP * np.eye(n))) / STEP)


def along(f: Callable[[Array, Array], Array], x: Array, v: Array, t: float) -> tuple[Array, Array]:
    """First and second derivative (k,) of f(x + s v, t + s) by s, at s = 0."""
    r = RADIUS / max(float(np.max(np.abs(v), initial=0.0)), 1.0)
    turns = np.exp(2j * np.pi * np.arange(POINTS) / POINTS)
    values = f(x[:, None] + r * v[:, None] * turns, t + r * turns)
    first = np.real(values @ turns.conj()) / POINTS / r
    second = np.real(values @ turns.conj() ** 2) / POINTS / r**2 * 2
    return first, second


class Norms(Twin):
    """Euler parameters have norm one."""

    def __init__(self, frame: str) -> None:
        self.nodes = (frame,)

    def rigid(self, x: Array, t: Array) -> Array:
        return np.array([dot(x, x) - 1])


@dataclass(frozen=True)
class Answer:
    """What the oracle finds in a state.

    Attributes
    ----------
    a : dict of str to float
        Accelerations of all coordinates that are not held.
    zd : dict of str to float
        Rates of internal states.
    reactions : dict of str to float
        Forces of the ground on held coordinates of points; none where redundant constraints leave them open.
    position, velocity : float
        Largest violation of the constraints by the given state.
    dynamic, kinematic : int
        Numbers of degrees of freedom.
    redundant : int
        Constraints that follow from others.
    gap : float
        Smallest singular value that counts, relative to the largest: near zero the configuration is singular.
    inertia : float
        Smallest eigenvalue of the inertia of the free motions, relative to the largest.
    """

    a: dict[str, float]
    zd: dict[str, float]
    reactions: dict[str, float]
    position: float
    velocity: float
    dynamic: int
    kinematic: int
    redundant: int
    gap: float
    inertia: float

    @property
    def singular(self) -> bool:
        """Whether the configuration is singular, or so near to it that a refusal is allowed."""
        return self.gap < CLEAR or self.inertia < 1e-10


class Oracle:
    """The twins of a model, assembled.

    Parameters
    ----------
    nodes : mapping of str to Node
    twins : iterable of Twin
    """

    def __init__(self, nodes: Mapping[str, Node], twins: Iterable[Twin]) -> None:
        norms = [
            Norms(node.name) for node in nodes.values() if node.kind == "frame" and not np.all(node.fixed)
        ]
        self.nodes, self.twins = nodes, [*twins, *norms]
        sizes = np.cumsum([0, *(node.drawn.size for node in nodes.values())])
        for twin in self.twins:
            assert len(set(twin.nodes)) == len(twin.nodes), f"a node of {type(twin).__name__} is named twice"
        self._rows = {name: np.arange(*sizes[i : i + 2]) for i, name in enumerate(nodes)}
        self.names = tuple(name for node in nodes.values() for name in node.names)
        held = np.concatenate([node.fixed for node in nodes.values()])
        self.drawn = np.concatenate([node.drawn for node in nodes.values()])
        self.free = np.flatnonzero(~held)
        points = np.concatenate([np.full(node.drawn.size, node.kind == "point") for node in nodes.values()])
        self._grounded = np.flatnonzero(held & points)
        self.states = tuple(name for twin in self.twins for name in twin.states)

    @cached_property
    def conserves(self) -> bool:
        """Whether energy is conserved."""
        return all(twin.conserves for twin in self.twins)

    def rows(self, twin: Twin) -> Array:
        """Where the coordinates of a twin are."""
        parts = [self._rows[name] for name in twin.nodes]
        return np.concatenate(parts) if parts else np.zeros(0, int)

    def vector(self, values: Callable[[str], float], held: bool = True) -> Array:
        """All coordinates (n,) from values by name; those of fixed ones as drawn, or zero."""
        x = self.drawn.copy() if held else np.zeros(self.drawn.size)
        x[self.free] = [values(self.names[i]) for i in self.free]
        return x

    def inertia(self, x: Array) -> Array:
        """M (n, n), from T by polarization."""
        M = np.zeros((x.size, x.size))
        for twin in self.twins:
            rows = self.rows(twin)
            n = rows.size
            i, j = np.triu_indices(n)
            v = np.zeros((n, i.size))
            v[i, range(i.size)] += 1
            v[j, range(i.size)] += 1
            T = twin.kinetic(np.repeat(x[rows, None], i.size, axis=1), v)
            own = np.zeros((n, n))
            own[i, j] = own[j, i] = T
            M_ii = np.diag(own) / 2  # T(2 e_i) = 2 M_ii, T(e_i + e_j) = M_ij + (M_ii + M_jj) / 2
            own -= np.add.outer(M_ii, M_ii) / 2
            own[range(n), range(n)] = M_ii
            M[np.ix_(rows, rows)] += own
        return M

    def convective(self, x: Array, v: Array) -> Array:
        """Ṁ v - ∂T/∂x (n,)."""
        h = np.zeros(x.size)
        for twin in self.twins:
            rows = self.rows(twin)
            xs, vs, one = x[rows], v[rows], np.eye(rows.size)
            moved = np.repeat((xs + 1j * STEP * vs)[:, None], rows.size, axis=1)
            now = np.repeat(vs[:, None], rows.size, axis=1)
            momentum = twin.kinetic(moved, now + one) - twin.kinetic(moved, now) - twin.kinetic(moved, one)
            dT = twin.kinetic(xs[:, None] + 1j * STEP * one, now)
            h[rows] += np.imag(momentum - dT) / STEP
        return h

    def forces(self, x: Array, v: Array, z: Mapping[str, float], t: float) -> Array:
        """Generalized forces (n,) of potentials and of the rest."""
        f = np.zeros(x.size)
        for twin in self.twins:
            rows = self.rows(twin)
            own = np.array([z[name] for name in twin.states])
            f[rows] += twin.force(x[rows], v[rows], own, t) - jacobian(twin.potential, x[rows])
        return f

    def energy(self, x: Array, v: Array) -> float:
        """Kinetic and potential energy [J]."""
        each = ((twin, self.rows(twin)) for twin in self.twins)
        return float(sum(float(twin.kinetic(x[i], v[i]) + twin.potential(x[i])) for twin, i in each))

    def rates(self, x: Array, v: Array, z: Mapping[str, float], t: float) -> dict[str, float]:
        """Rates of internal states by name."""
        found: dict[str, float] = {}
        for twin in self.twins:
            rows = self.rows(twin)
            own = np.array([z[name] for name in twin.states])
            found |= dict(zip(twin.states, twin.zdot(x[rows], v[rows], own, t), strict=True))
        return found

    def holonomic(self, x: Array, v: Array, t: float) -> tuple[Array, Array, Array, Array]:
        """φ (k,), ∂φ/∂x (k, n), φ̇ and the part of φ̈ without accelerations (k,)."""
        phi, A, rate, curve = [], [], [], []
        for twin in self.twins:
            rows = self.rows(twin)
            own = np.zeros((twin.rigid(x[rows], np.asarray(t)).size, x.size))
            if not own.size:
                continue
            own[:, rows] = jacobian(lambda y, twin=twin: twin.rigid(y, np.asarray(t)), x[rows])
            first, second = along(twin.rigid, x[rows], v[rows], t)
            for all_, new in (
                (phi, twin.rigid(x[rows], np.asarray(t))),
                (A, own),
                (rate, first),
                (curve, second),
            ):
                all_.append(new)
        if not A:
            return np.zeros(0), np.zeros((0, x.size)), np.zeros(0), np.zeros(0)
        return np.concatenate(phi), np.concatenate(A), np.concatenate(rate), np.concatenate(curve)

    def rolling(self, x: Array, v: Array) -> tuple[Array, Array]:
        """A (k, n) of the slips that are zero, and Ȧ v (k,)."""
        A, curve = [], []
        for twin in self.twins:
            rows = self.rows(twin)
            own = twin.slips(x[rows])
            if own.size:
                all_ = np.zeros((len(own), x.size))
                all_[:, rows] = own
                A.append(all_)
                curve.append(np.imag(twin.slips(x[rows] + 1j * STEP * v[rows])) / STEP @ v[rows])
        if not A:
            return np.zeros((0, x.size)), np.zeros(0)
        return np.concatenate(A), np.concatenate(curve)

    def passes_flat(self, x: Array, y: Array) -> bool:
        """Whether a flat position lies between two nearby ones, x and y (n,): an odd number of them is seen.

        Where a condition that follows from no other becomes one that does, and is independent again, the determinant of
        the independent conditions at x and the directions that they leave free there changes its sign.
        """
        before, after = (self._conditions(z)[:, self.free] for z in (x, y))
        rank, _, _, Z = _split(before, np.zeros(len(before)))
        rows = qr(before.T, mode="r", pivoting=True)[1][:rank]
        signs = [np.linalg.slogdet(np.concatenate([A[rows], Z.T]))[0] for A in (before, after)]
        return bool(signs[0] != signs[1])

    def _conditions(self, x: Array) -> Array:
        """Derivatives (k, n) of all conditions by the coordinates, and of slips by the rates."""
        still = np.zeros(x.size)
        return np.concatenate([self.holonomic(x, still, 0.0)[1], self.rolling(x, still)[0]])

    def solve(self, x: Array, v: Array, z: Mapping[str, float], t: float) -> Answer:
        """Accelerations and what there is to say about the state; x, v (n,) include held coordinates."""
        phi, C, rate, curve = self.holonomic(x, v, t)
        S, swept = self.rolling(x, v)
        free = self.free
        full, g = np.concatenate([C, S]), -np.concatenate([curve, swept])
        weight = 1 / np.maximum(np.linalg.norm(full[:, free], axis=1), 1e-300)
        full, g = full * weight[:, None], g * weight
        A = full[:, free]
        M, unbalance = self.inertia(x), self.convective(x, v) - self.forces(x, v, z, t)
        rank, gap, particular, Z = _split(A, g)
        Mf = M[np.ix_(free, free)]
        reduced = Z.T @ Mf @ Z
        a = particular - Z @ _solved(reduced, Z.T @ (unbalance[free] + Mf @ particular))
        spread = np.linalg.eigvalsh(reduced) if reduced.size else np.ones(1)
        nq = free.size - _split(A[: len(C)], np.zeros(len(C)))[0]
        needed = M[:, free] @ a + unbalance  # by constraints
        held = needed - full.T @ _solved(A.T, needed[free])
        return Answer(
            {self.names[i]: float(value) for i, value in zip(free, a, strict=True)},
            self.rates(x, v, z, t),
            {self.names[i]: float(held[i]) for i in self._grounded} if rank == len(A) else {},
            float(np.max(np.abs(phi), initial=0.0)),
            float(np.max(np.abs(np.concatenate([rate, S @ v])), initial=0.0)),
            free.size - rank,
            nq - (free.size - rank),
            len(A) - rank,
            gap,
            float(spread[0] / spread[-1]),
        )


def _solved(A: Array, b: Array) -> Array:
    return np.linalg.lstsq(A, b, rcond=1e-14)[0] if A.size else np.zeros(0)


def _split(A: Array, g: Array) -> tuple[int, float, Array, Array]:
    """Rank, its clearness, the smallest solution of A a = g and a basis of A's null space."""
    n = A.shape[1]
    if not len(A) or not n:
        return 0, 1.0, np.zeros(n), np.eye(n)
    U, s, Vt = np.linalg.svd(A)
    rank = int(np.sum(s > RANK * s[0]))
    particular = Vt[:rank].T @ ((U[:, :rank].T @ g) / s[:rank])
    return rank, float(s[rank - 1] / s[0]), particular, Vt[rank:].T
