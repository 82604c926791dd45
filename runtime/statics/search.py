"""Newton's method for an equilibrium at a fixed load."""

from __future__ import annotations

import logging

import numpy as np

from flexel.base.arrays import Array
from flexel.base.errors import DynamicsError
from flexel.mechanics.newton import newton, shortened
from flexel.statics.equilibrium import MAX_STEP, STALLED_TOLERANCE, TOLERANCE, Equations, Rest

log = logging.getLogger("flexel.statics")
MAX_EVALUATIONS = 30  # evaluations
SEARCH = (
    0.2  # longest step in natural scales: stiff beams far from equilibrium do not converge in longer ones
)
POLISHING_STEPS = 3  # most further steps: they gain digits where stiffnesses differ much
CONVERGES = 1e-3  # length of the next step, over that of one, that shows that the method converges there
ROUNDING = 1e-14  # step, in natural scales, that is a rounding error
LONG_STEP = 1e-10  # the same beyond which an equilibrium is not found yet, whatever its residual
ROUNDED = 10 * np.finfo(float).eps  # of forces and deformations, relative
MAX_NULL_SPACE_SIZE = 1500  # most unknowns for which a singular matrix has a least-squares solution
# Largest share of a residual that may remain after a step that leaves out free motions.
MAX_MISSED_SHARE = 0.5
FORCE_TOLERANCE = 1e-6  # relative change of a force that does not depend on a motion
UNSETTLED = 2 * STALLED_TOLERANCE  # error of a point that a force still moves
Unknowns = tuple[Array, Array, Array]  # coordinates, multipliers, nearby deformations


class Search:
    """The search for an equilibrium.

    If no stiffness resists some motions, such as a car that rolls or motion across unstrained bars, the shortest steps
    are taken: the model should not move in these directions without a reason.
    """

    def __init__(self, problem: Rest, t: float) -> None:
        self.problem, self.t, self.nf = problem, t, problem.structure.nf
        self._neutral: bool | None = None
        self._solved: tuple[Equations, Array] | None = None  # the last equations and their step

    def found(self, x: Array, mu: Array, unwrap_from: Array) -> tuple[Equations, Array] | None:
        """Find the equilibrium and its multipliers; return None if the method does not converge.

        Raises
        ------
        DynamicsError
            If a force acts along a motion that nothing resists.
        """
        limits = {"tolerance": TOLERANCE, "stalled": STALLED_TOLERANCE}
        result = newton((x, mu, unwrap_from), self._evaluate, self._move, **limits, most=MAX_EVALUATIONS)
        how = "found" if result.converged else "not found"
        log.info(
            "t = %g s: %s in %d Newton iterations, error %.3g", self.t, how, result.iterations, result.error
        )
        return self._polished(result.point, result.equations, result.error) if result.converged else None

    def _polished(self, point: Unknowns, q: Equations, error: float) -> tuple[Equations, Array]:
        """Take further steps; their lengths decide, as the residual of a stiff model reaches rounding level earlier.

        A step that enlarges the residual is not kept, unless the next one is far shorter: along a motion that is free
        at the equilibrium (the spin of a hanging pendulum), all steps are quotients of rounding errors.
        """
        if not q.matrix.factors.regular:  # free motions are handled elsewhere
            return q, point[1]
        last, step = np.inf, self._step(q)
        for _ in range(POLISHING_STEPS):
            size = self.problem.extent(step)
            if not ROUNDING < size < min(0.5 * last, MAX_STEP):
                break
            there = self._moved(point, q, step)
            better, left = self._evaluate(there)
            if not (left < STALLED_TOLERANCE and better.matrix.factors.regular):  # false for NaN
                break
            following = self._step(better)
            if left > max(TOLERANCE, error) and self.problem.extent(following) > CONVERGES * size:
                break
            point, q, last, error, step = there, better, size, left, following
        return q, point[1]

    def _evaluate(self, point: Unknowns) -> tuple[Equations, float]:
        """Evaluate the equations, and their error: that of a point from which a force still moves the model is large.

        Beside a stiff part, forces on soft ones are so small that they seem to be in balance.
        """
        q = self.problem.equations(self.t, *point)
        error = self.problem.size(q, q.residual)
        return q, max(error, UNSETTLED) if error < STALLED_TOLERANCE and self._moves(q) else error

    def _moves(self, q: Equations) -> bool:
        """Whether the next step is long, and the work of its forces is more than that of rounding errors."""
        if not q.matrix.factors.regular:
            return False
        step = self._step(q)
        if self._neutral or self.problem.extent(step) <= LONG_STEP:
            return False
        return bool(abs(step[: self.nf] @ q.residual[: self.nf]) > self._noise(q, step))

    def _noise(self, q: Equations, step: Array) -> float:
        """Return the work of rounding errors along a step; the workspace holds the equations.

        Deformations are as exact as coordinates are.  Their rounding errors cause stresses, which do no work along a
        step in which the deformations do not change, such as the bending of a slender beam.
        """
        problem, work = self.problem, self.problem.work
        change = np.zeros(problem.structure.n)
        change[: self.nf] = step[: self.nf]
        left, right = np.divmod(work.tables.law.codes, max(problem.first, 1))
        errors = np.abs(work.S[: left.size]) * np.maximum(problem.scales[right], problem.length)
        stresses = np.bincount(left, errors, minlength=problem.first)
        others = q.balance.scale * float(np.abs(change).sum())
        return ROUNDED * (float(stresses @ np.abs(work.jvp(change))) + others)

    def _move(self, point: Unknowns, q: Equations) -> Unknowns:
        step = self._step(q)
        return self._moved(point, q, shortened(step, self.problem.extent(step), SEARCH))

    def _moved(self, point: Unknowns, q: Equations, step: Array) -> Unknowns:
        x, mu = point[0].copy(), point[1] - step[self.nf :]
        x[: self.nf] -= step[: self.nf]
        return x, mu, q.balance.e

    def _step(self, q: Equations) -> Array:
        """Return the step from a point, which is solved for once."""
        if self._solved is None or self._solved[0] is not q:
            self._solved = q, self._new_step(q)
        return self._solved[1]

    def _new_step(self, q: Equations) -> Array:
        if self._neutral is None:
            motion = free_motion(q)
            self._neutral = motion is not None
            if motion is not None:
                log.info("nothing resists a motion of %s: steps without it", q.matrix.names_of(motion))
        if self._neutral:
            smallest, missed = q.matrix.least_solution(q.residual)
            size = self.problem.size(q, missed)
            if size <= max(TOLERANCE, MAX_MISSED_SHARE * self.problem.size(q, q.residual)):
                return smallest
            self._check_supported(q, missed[: self.nf])
        return q.matrix.solve(q.residual)

    def _check_supported(self, q: Equations, missed: Array) -> None:
        """Check that no force acts along a free motion, however far it goes."""
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
        same = change <= FORCE_TOLERANCE * np.abs(missed).max() + ROUNDING * np.abs(problem.free).max(
            initial=0.0
        )
        if not (same and power > FORCE_TOLERANCE * float(np.linalg.norm(motion) * np.linalg.norm(missed))):
            return
        name = problem.structure.names[first + heaviest(problem, motion)]
        raise DynamicsError(
            f"no equilibrium{problem.when(self.t)}: a force acts where nothing resists a motion of '{name}'; "
            f"support it, or give hold=['{name}']{problem.unheld()}"
        )


def free_motion(q: Equations) -> Array | None:
    """Return a motion (nf,) that nothing resists; None if there is none, or in a model too large to leave it out."""
    return q.matrix.free_motion() if len(q.residual) <= MAX_NULL_SPACE_SIZE else None


def heaviest(problem: Rest, motion: Array) -> int:
    """Return the coordinate with the largest mass among those that take most part in a motion (nf,)."""
    problem.work.tangent(0.0, 0.0, 1.0, phi=False)
    mass = problem.work.tables.T.pattern.matrix(problem.free).diagonal()
    return int(np.argmax(np.where(np.abs(motion) > 0.9 * np.abs(motion).max(), mass, -1.0)))
