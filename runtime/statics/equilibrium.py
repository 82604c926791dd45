"""The equations of static equilibrium, and their solution at a fixed load.

They are written in coordinates and multipliers together (the saddle-point form), so no choice of
independent coordinates is needed, however large the deformation; the tangent is the analytic r_x.
"""

from __future__ import annotations

import logging
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from scipy.sparse.linalg import lsmr

from flexel.base.arrays import Array, Index
from flexel.mechanics.balance import Balance, Saddle
from flexel.mechanics.core import Core
from flexel.mechanics.newton import newton, shortened
from flexel.mechanics.saddle import Matrix, SaddlePattern
from flexel.structure.state import State, own_state

log = logging.getLogger("flexel.statics")
POLISHING = 3  # largest number of further steps: they gain digits where stiffnesses differ much
ROUNDING = 1e-14  # step, in natural scales, that is rounding
CONVERGED, STALLED, MAX_ITERATIONS = 1e-12, 1e-9, 30
STEP = 0.4  # largest change of a coordinate, in its natural scale, in one Newton step
SEARCH = 0.2  # the same in a search at the full load: stiff beams far from equilibrium do not converge in longer ones


class Rest(Saddle):
    """The equations of equilibrium of a system; kinematic coordinates and internal states of laws are held.

    Additional held coordinates or deformations are given as quantities.
    """

    def __init__(self, system: Core, start: State, held: Index | None = None) -> None:
        own_state(system.structure, start, "equilibrium")
        more = np.zeros(0, dtype=np.intp) if held is None else held
        super().__init__(system, more)
        self.z = start.z
        self.still = np.concatenate([self.roles.kinematic, more])
        self.held = start.values[self.still]
        self.hold_rows = np.concatenate([self.roles.holonomic, self.still])

    @cached_property
    def pattern(self) -> SaddlePattern:
        """Pattern of the tangent."""
        return SaddlePattern(self.work, self.force_rows, self.hold_rows)

    def holding_forces(self, t: float, start: State) -> Array:
        """Multipliers that best balance the given forces at a configuration, by least squares.

        They contain the geometric stiffness of a mechanism (a pendulum's gravity), without which the first tangent
        would be singular.
        """
        if not self.force_rows.size:
            return np.zeros(0)
        none = np.zeros(self.force_rows.size)
        b = self.balance(t, start.x, self.rest, self.rest, none, start.e)
        C = self.work.tables.J.matrix(self.work.J)[self.force_rows][:, : self.structure.nf]
        return np.asarray(lsmr(C.T, -b.r, atol=1e-12, btol=1e-12, conlim=1e10)[0])

    def equations(self, t: float, x: Array, mu: Array, near: Array) -> Equations:
        """Residual (r, gap) and its derivative by (x, mu) at time t."""
        b = self.balance(t, x, self.rest, self.rest, mu, near)
        self.stiffness()
        values = self.system.kinematics.values(b.e, x)
        gap = np.concatenate([b.gap, values[self.still] - self.held])
        largest = float(np.abs(self.free).max(initial=0.0))
        return Equations(b, np.concatenate([b.r, gap]), self.pattern.matrix(self.work), largest)

    def size(self, q: Equations, residual: Array) -> float:
        """Size of a residual in natural scales."""
        nf = self.structure.nf
        gap = residual[nf:] / self.scales[self.hold_rows]
        return self.error(residual[:nf], gap, q.stiffness, q.balance.scale)

    def extent(self, step: Array) -> float:
        """Largest change of a coordinate, in its natural scale, in a step of (x, mu)."""
        return float(np.abs(step[: self.structure.nf] / self.x_scale).max(initial=0.0))

    def rate(self, q: Equations) -> Array:
        """Derivative of the residual with respect to time at fixed x and mu."""
        return np.concatenate([*self.load_rate(q.balance), np.zeros(self.still.size)])


@dataclass(frozen=True)
class Equations:
    """The equations of equilibrium at one point.

    Attributes
    ----------
    balance : Balance
    residual : ndarray
        (r, gap).
    matrix : Matrix
        Its derivative by (x, mu).
    stiffness : float
        Largest entry of the stiffness.
    """

    balance: Balance
    residual: Array
    matrix: Matrix
    stiffness: float


def solve(problem: Rest, t: float, x: Array, mu: Array, near: Array) -> tuple[Equations, Array] | None:
    """The equilibrium at a fixed parameter, and its multipliers, by Newton's method; None if it does not converge."""
    nf = problem.structure.nf

    def evaluate(point: tuple[Array, Array, Array]) -> tuple[Equations, float]:
        q = problem.equations(t, *point)
        return q, problem.size(q, q.residual)

    def newton_step(q: Equations) -> Array:
        # the smallest solution: unstrained bars resist no transverse motion
        step = q.matrix.least_solution(q.residual)
        return q.matrix.solve(q.residual) if step is None else step

    def moved(point: tuple[Array, Array, Array], q: Equations, step: Array) -> tuple[Array, Array, Array]:
        x, mu = point[0].copy(), point[1] - step[nf:]
        x[:nf] -= step[:nf]
        return x, mu, q.balance.e

    def move(point: tuple[Array, Array, Array], q: Equations) -> tuple[Array, Array, Array]:
        step = newton_step(q)
        return moved(point, q, shortened(step, problem.extent(step), SEARCH))

    limits = {"tolerance": CONVERGED, "stalled": STALLED}
    found = newton((x, mu, near), evaluate, move, **limits, most=MAX_ITERATIONS)
    how = "found" if found.converged else "not found"
    log.info("t = %g s: %s in %d Newton iterations, error %.3g", t, how, found.iterations, found.error)
    if not found.converged:
        return None
    q, point, last = found.equations, found.point, np.inf
    # The steps decide, not the residual: in a stiff model it is rounding from the first of these steps on.
    for _ in range(POLISHING if q.matrix.factors.regular else 0):  # a free motion is handled elsewhere
        step = newton_step(q)
        size = problem.extent(step)
        if not ROUNDING < size < min(0.5 * last, STEP):
            break
        point, last = moved(point, q, step), size
        q = evaluate(point)[0]
    return q, point[1]
