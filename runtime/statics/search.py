"""Newton's method for an equilibrium at a fixed load."""

from __future__ import annotations

import logging

import numpy as np

from flexel.base.arrays import Array
from flexel.base.errors import DynamicsError
from flexel.mechanics.newton import newton, shortened
from flexel.statics.equilibrium import CONVERGED, STALLED, STEP, Equations, Rest

log = logging.getLogger("flexel.statics")
MOST = 30  # evaluations
SEARCH = (
    0.2  # longest step in natural scales: stiff beams far from equilibrium do not converge in longer ones
)
POLISHING = 3  # most further steps: they gain digits where stiffnesses differ much
ROUNDING = 1e-14  # step, in natural scales, that is rounding
LARGEST_NULL_SPACE = 1500  # most unknowns for which a singular matrix has a least-squares solution
MISSED = 0.5  # largest share of a residual that a step without motions that nothing resists may leave
SAME = 1e-6  # relative change of a force that does not depend on a motion
Unknowns = tuple[Array, Array, Array]  # coordinates, multipliers, deformations nearby


class Search:
    """The search for an equilibrium.

    Where nothing resists some motions, of a car that rolls or across unstrained bars, the steps are the shortest ones:
    the model is not to move so without a reason.
    """

    def __init__(self, problem: Rest, t: float) -> None:
        self.problem, self.t, self.nf = problem, t, problem.structure.nf
        self._neutral: bool | None = None

    def found(self, x: Array, mu: Array, near: Array) -> tuple[Equations, Array] | None:
        """The equilibrium and its multipliers; None if the method does not converge.

        Raises
        ------
        DynamicsError
            If a force acts along a motion that nothing resists.
        """
        limits = {"tolerance": CONVERGED, "stalled": STALLED}
        result = newton((x, mu, near), self._evaluate, self._move, **limits, most=MOST)
        how = "found" if result.converged else "not found"
        log.info(
            "t = %g s: %s in %d Newton iterations, error %.3g", self.t, how, result.iterations, result.error
        )
        return self._polished(result.point, result.equations, result.error) if result.converged else None

    def _polished(self, point: Unknowns, q: Equations, error: float) -> tuple[Equations, Array]:
        """Further steps; their lengths decide, as the residual of a stiff model is rounding before they are.

        A step that enlarges the residual is not kept: along a motion that nothing resists any more at the equilibrium
        (the spin of a pendulum that hangs), a step is rounding divided by rounding.
        """
        last = np.inf
        for _ in range(POLISHING if q.matrix.factors.regular else 0):  # a free motion is handled elsewhere
            step = self._step(q)
            size = self.problem.extent(step)
            if not ROUNDING < size < min(0.5 * last, STEP):
                break
            there = self._moved(point, q, step)
            better, left = self._evaluate(there)
            if not left <= max(CONVERGED, error):  # false for NaN
                break
            point, q, last, error = there, better, size, left
        return q, point[1]

    def _evaluate(self, point: Unknowns) -> tuple[Equations, float]:
        q = self.problem.equations(self.t, *point)
        return q, self.problem.size(q, q.residual)

    def _move(self, point: Unknowns, q: Equations) -> Unknowns:
        step = self._step(q)
        return self._moved(point, q, shortened(step, self.problem.extent(step), SEARCH))

    def _moved(self, point: Unknowns, q: Equations, step: Array) -> Unknowns:
        x, mu = point[0].copy(), point[1] - step[self.nf :]
        x[: self.nf] -= step[: self.nf]
        return x, mu, q.balance.e

    def _step(self, q: Equations) -> Array:
        if self._neutral is None:
            motion = q.matrix.free_motion() if len(q.residual) <= LARGEST_NULL_SPACE else None
            self._neutral = motion is not None
            if motion is not None:
                log.info("nothing resists a motion of %s: steps without it", q.matrix.names_of(motion))
        if self._neutral:
            smallest, missed = q.matrix.least_solution(q.residual)
            size = self.problem.size(q, missed)
            if size <= max(CONVERGED, MISSED * self.problem.size(q, q.residual)):
                return smallest
            self._check_supported(q, missed[: self.nf])
        return q.matrix.solve(q.residual)

    def _check_supported(self, q: Equations, missed: Array) -> None:
        """Check that no force acts along a motion that nothing resists, however far it goes."""
        problem, nf, first = self.problem, self.nf, self.problem.first
        motions = q.matrix.free_motions()
        motion = motions @ (motions.T @ missed)
        extent = problem.extent(motion)
        if not extent:
            return
        motion *= SEARCH / extent
        power, x = float(motion @ missed), q.balance.x.copy()
        x[:nf] += motion
        there = problem.equations(self.t, x, q.balance.mu, q.balance.e)
        change = np.abs(there.residual - q.residual)[:nf].max()
        same = change <= SAME * np.abs(missed).max() + ROUNDING * np.abs(problem.free).max(initial=0.0)
        if not (same and power > SAME * float(np.linalg.norm(motion) * np.linalg.norm(missed))):
            return
        name = problem.structure.names[first + self._heaviest(motion)]
        raise DynamicsError(
            f"no equilibrium{problem.when(self.t)}: a force acts where nothing resists a motion of '{name}'; "
            f"support it, or give hold=['{name}']"
        )

    def _heaviest(self, motion: Array) -> int:
        """The coordinate with the largest mass among those that take part most in a motion (nf,)."""
        problem = self.problem
        problem.work.tangent(0.0, 0.0, 1.0, phi=False)
        mass = problem.work.tables.T.pattern.matrix(problem.free).diagonal()
        return int(np.argmax(np.where(np.abs(motion) > 0.9 * np.abs(motion).max(), mass, -1.0)))
