"""The position, velocity and acceleration problem: from the degrees of freedom q to the coordinates x and back.

Position: c(x, t) = 0 and the degrees of freedom at their values, by Newton's method with warm start, angles compared
modulo 2 pi.  Velocity: B v = (u', 0, q_d').  Acceleration: B a = (u'', 0, q_d'') - convective terms.  Source: van der
Werff (1977); Jonker and Meijaard (1990); Schwab and Meijaard (2003) for the non-holonomic rows.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from flexel.base.arrays import Array, Index
from flexel.base.errors import ConstraintError, PositionError
from flexel.engine.evaluate import Evaluation
from flexel.engine.solvers import Solvable, factorize
from flexel.engine.triangular import BlockForm, ExchangedFactors
from flexel.structure.roles import Roles
from flexel.structure.structure import Structure

TOLERANCE = 1e-13  # error of a deformation, relative to its natural scale
MAX_ITERATIONS = 40
LARGE = 400  # coordinates above which matrices are sparse
TINY = 24  # coordinates below which a dense matrix is fastest
WORTH = 8  # the block form is used if it needs this many times fewer operations than the dense matrix
SHOWN = 6  # laws named in a message


@dataclass(frozen=True)
class Configuration:
    """A configuration that satisfies the constraints: time, coordinates, deformations, J = [De; V; I].

    J is a sparse matrix in a large model (`Kinematics.large`). `motion` holds value, first and second rate
    (3, prescribed) of the prescribed motions, if already computed.
    """

    t: float
    x: Array
    e: Array
    J: Any
    motion: Array | None = None


def natural_scales(structure: Structure) -> Array:
    """Natural scale of each quantity: the size of the model for lengths, one for the rest."""
    positions = [node.x0 for node in structure.nodes if node.kind in ("point", "planar_point")]
    size = 1.0
    if positions:
        columns = max(p.size for p in positions)
        cloud = np.array([np.pad(p, (0, columns - p.size)) for p in positions])
        size = float(np.ptp(cloud, axis=0).max()) or 1.0
    return np.array([size if unit == "m" else 1.0 for unit in structure.units])


def turns(difference: Array, period: Array) -> Array:
    """The whole periods in differences of quantities; zero where a quantity has none."""
    return period * np.round(np.divide(difference, period, out=np.zeros_like(difference), where=period > 0))


def wrap(residual: Array, period: Array) -> Array:
    """Differences of quantities without whole periods; those without a period unchanged."""
    return residual - turns(residual, period)


def unwrap(structure: Structure, e: Array, reference: Array) -> Array:
    """Deformations with whole periods added so that periodic ones are nearest to a reference."""
    period = structure.period[: structure.m]
    if not period.any():
        return e
    found = e + turns(reference - e, period)
    return structure.relations.shifted(e, found) if structure.relations else found


class Kinematics:
    """The kinematic problems of one model for one choice of degrees of freedom."""

    def __init__(self, evaluation: Evaluation, roles: Roles) -> None:
        self.evaluation = evaluation
        self.structure: Structure = evaluation.structure
        self.roles = roles
        self.large = self.structure.n > LARGE
        self._scale = natural_scales(self.structure)
        rows = roles.position_rows
        self._weight = 1.0 / self._scale[rows]
        self._winding = np.flatnonzero(self.structure.period[rows])
        self._period = self.structure.period[rows][self._winding]
        self._step_weight = 1.0 / self._scale[self.structure.m + self.structure.k :][: self.structure.nf]
        self._room: Array | None = None
        self.forget()

    def evaluate(self, x: Array) -> tuple[Array, Any]:
        """Deformations e (m,) as principal values, and J = [De; V; I] (m + k + n, n), sparse in a large model."""
        return self.evaluation.jacobian(x) if self.large else self.evaluation.position(x)

    @cached_property
    def heavy(self) -> Index:
        """Free coordinates with inertia, in a model that is not large."""
        found = self.evaluation.heavy
        return found[found < self.structure.nf]

    @cached_property
    def _form(self) -> tuple[BlockForm, Index] | None:
        """Block form of the position matrix and the places of its entries in J; None if dense factors are cheaper."""
        m, k, n, nf = self.structure.m, self.structure.k, self.structure.n, self.structure.nf
        if self.large or nf < TINY:
            return None
        rows = self.roles.position_rows
        i, j = np.nonzero(self.evaluation.filled[rows][:, :nf])
        form = BlockForm(i, j, nf)
        if not form.regular or form.operations > nf**3 / 3 / WORTH:
            return None
        source = np.full(form.length, (m + k) * n + 1)  # a zero: off the diagonal of the unit matrix in J
        source[form.slots] = rows[i] * n + j
        return form, source

    def _position_matrix(self, J: Any) -> Solvable:
        """Factors of the matrix of the position problem."""
        if self._form is None:
            return factorize(J[self.roles.position_rows][:, : self.structure.nf])
        form, source = self._form
        return form.factorize(J.ravel().take(source))

    def forget(self) -> None:
        """Clear the cache of the last position problem, so that the next one does not depend on it."""
        self._lu: Solvable | None = None
        self._x = self._target = np.zeros(0)

    def scales(self, rows: Any) -> Array:
        """Natural scales of quantities."""
        return np.asarray(self._scale[rows])

    def values(self, e: Array, x: Array) -> Array:
        """Values of all quantities; slips, which have none, as zero."""
        y = np.zeros(self._scale.size)
        y[: e.size] = e
        y[y.size - x.size :] = x
        return y

    def motion(self, configuration: Configuration) -> Array:
        """Value, first and second rate (3, prescribed) of the prescribed motions."""
        known = configuration.motion
        return self.roles.motion(configuration.t) if known is None else known

    def target(self, motion: Array, q: Array) -> Array:
        """Target values of the rows of the position problem, for prescribed motions (3, prescribed)."""
        nr, nu = self.roles.rigid.size, self.roles.prescribed.size
        y = np.zeros(nr + nu + q.size)
        y[nr : nr + nu] = motion[0]
        y[nr + nu :] = q
        return y

    def position(self, t: float, q: Array, guess: Array, turns: Array | None = None) -> Configuration:
        """Configuration at time t with degrees of freedom q.

        Parameters
        ----------
        t : float
        q : ndarray (nq,)
            Values of the degrees of freedom (q_d, q_k); angles over any number of turns.
        guess : ndarray (n,)
            Coordinates to start from.
        turns : ndarray (m,), optional
            Deformations near the solution; a relation needs them to count the turns of its terms.

        Raises
        ------
        PositionError
            If Newton's method does not converge; names the rows that remain unsatisfied.
        """
        nf = self.structure.nf
        motion = self.roles.motion(t)
        target = self.target(motion, q)
        x = self._predict(guess, target)
        known = self._known(turns, target)
        last = np.inf
        for _ in range(MAX_ITERATIONS):
            e, J = self._inside(x)
            residual = self._residual(e if known is None else unwrap(self.structure, e, known), x, target)
            error = float(np.abs(residual * self._weight).max(initial=0.0))
            if error < TOLERANCE or (error < 1e-10 and error > 0.5 * last):
                self._x, self._target = x, target
                return Configuration(t, x, e, J.copy(), motion)
            self._lu = self._position_matrix(J)
            if not (np.isfinite(error) and self._lu.regular):
                break
            step = self._lu.solve(residual)
            largest = float(np.abs(step * self._step_weight).max())
            x[:nf] -= step if largest < 0.5 else step * (0.5 / largest)
            last = error if largest < 0.5 else np.inf
        self.forget()
        raise PositionError(self._unreached(t, residual))

    def _known(self, turns: Array | None, target: Array) -> Array | None:
        """Deformations from which turns of angles are counted where relations need them; given ones are kept."""
        if not self.structure.relations:
            return None
        known = np.zeros(self.structure.m) if turns is None else turns.copy()
        own = self.roles.position_rows < self.structure.m
        known[self.roles.position_rows[own]] = target[own]
        return known

    def _inside(self, x: Array) -> tuple[Array, Any]:
        """The same as `evaluate`, for use within an iteration: the previous matrix is overwritten."""
        if self.large:
            return self.evaluate(x)
        e, self._room = self.evaluation.position(x, self._room)
        return e, self._room

    def _residual(self, e: Array, x: Array, target: Array) -> Array:
        residual = self.values(e, x)[self.roles.position_rows] - target
        if self._winding.size:
            residual[self._winding] -= turns(residual[self._winding], self._period)
        return residual

    def _predict(self, guess: Array, target: Array) -> Array:
        """First-order prediction from the last solution, if the guess is that one; else the guess."""
        x = guess.copy()
        if self._lu is not None and guess is self._x:
            step = self._lu.solve(target - self._target)
            if float(np.abs(step * self._step_weight).max(initial=0.0)) < 0.5:
                x[: self.structure.nf] += step
        return x

    def _unreached(self, t: float, residual: Array) -> str:
        if np.isnan(residual[self.roles.holonomic.size :]).any():
            laws = self.structure.laws
            own = [law for law in laws if law.kernels]
            named = ", ".join(dict.fromkeys(f"'{law.name}'" for law in own or laws[:SHOWN]))
            suspects = f" and the laws{' given by formulas' * bool(own)} (on {named})" * bool(laws)
            return (
                f"position at t = {t:g} s is not a number: a force was not finite just before; check the loads"
                f"{suspects} in the range that the motion reaches"
            )
        worst = np.argsort(-np.abs(np.nan_to_num(residual, nan=np.inf)) * self._weight)[:4]
        rows = self.roles.position_rows
        names = ", ".join(f"'{self.structure.names[rows[i]]}' (off by {residual[i]:.3g})" for i in worst)
        driven = f" of {self.names(self.roles.prescribed)}" if self.roles.prescribed.size else ""
        return (
            f"position at t = {t:g} s cannot be reached: {names} remain unsatisfied; the constraints admit no such "
            f"position near the current one: check prescribed and initial values{driven}, or move in smaller steps"
        )

    def velocity_matrix(self, configuration: Configuration) -> Solvable:
        """Factors of B at a configuration.

        Raises
        ------
        ConstraintError
            If B is singular: the chosen degrees of freedom do not determine the velocities here.
        """
        B = self._velocity_matrix(configuration.J)
        if not B.regular:
            raise ConstraintError(
                f"the degrees of freedom {self.names(self.roles.dynamic)} do not determine the velocities at "
                f"t = {configuration.t:g} s (singular position); choose other independent coordinates"
            )
        return B

    def _velocity_matrix(self, J: Any) -> Solvable:
        roles, nf = self.roles, self.structure.nf
        if self._form is not None:
            P = self._position_matrix(J)
            if P.regular:
                return (
                    ExchangedFactors(P, J[roles.zero][:, :nf], roles.holonomic.size) if roles.zero.size else P
                )
        return factorize(J[roles.velocity_rows][:, :nf])

    def velocity(self, configuration: Configuration, B: Solvable, qd: Array) -> Array:
        """Rates v (n,) of all coordinates for the rates q_d' (nd,) of the dynamic degrees of freedom."""
        roles = self.roles
        rhs = np.zeros(self.structure.nf)
        if roles.motions:
            rhs[roles.rigid.size : roles.holonomic.size] = self.motion(configuration)[1]
        rhs[rhs.size - roles.nd :] = qd
        v = np.zeros(self.structure.n)
        v[: self.structure.nf] = B.solve(rhs)
        return v

    def convective(self, configuration: Configuration, v: Array) -> Array:
        """Right-hand side of B a for q_d'' = 0: prescribed accelerations minus convective terms."""
        rows = self.roles.velocity_rows
        rhs = -self.evaluation.convective(configuration.x, v)[rows]
        if self.roles.motions:
            rhs[self.roles.rigid.size : self.roles.holonomic.size] += self.motion(configuration)[2]
        return rhs

    def drift(self, e: Array, x: Array) -> float:
        """Largest violation of the rigid conditions, relative to their natural scales."""
        rows = self.roles.rigid
        held = wrap(self.values(e, x)[rows], self.structure.period[rows])
        return float(np.max(np.abs(held) / self.scales(rows), initial=0.0))

    def names(self, rows: Any) -> str:
        """Names of quantities, for messages."""
        return ", ".join(f"'{self.structure.names[i]}'" for i in rows)
