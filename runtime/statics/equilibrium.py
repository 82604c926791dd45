"""The equations of static equilibrium.

They are written in coordinates and multipliers together (the saddle-point form), so no choice of
independent coordinates is needed, however large the deformation; the tangent is the analytic r_x.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from scipy.sparse.linalg import lsmr

from flexel.base.arrays import Array, Index
from flexel.integration.balance import Balance, Saddle
from flexel.mechanics.saddle import Matrix, SaddlePattern
from flexel.model.state import State, own_state
from flexel.system import CoreSystem

TOLERANCE, STALLED_TOLERANCE = 1e-12, 1e-9
DURATION = 1e12  # of the displacement to an equilibrium [s]: so long that no damper carries anything
MAX_STEP = 0.4  # largest change of a coordinate, in its natural scale, in one Newton step


class Rest(Saddle):
    """The equations of equilibrium of a system; kinematic coordinates and most internal states of laws are held.

    Internal states that change with displacements only (the deflection of bristles) follow the displacement from the
    last known equilibrium, as in one implicit step that takes so long that nothing else depends on rates.

    Additional held coordinates or deformations are given as quantities.
    """

    def __init__(self, system: CoreSystem, start: State, held: Index | None = None) -> None:
        own_state(system.structure, start, "equilibrium")
        more = np.zeros(0, dtype=np.intp) if held is None else held
        super().__init__(system, more)
        lasting, step = any(lag.lasting for lag in self.work.tables.law.lags), self.balancing.struct
        self._share, self._rate = (DURATION, 1 / DURATION) if lasting else (0.0, 0.0)
        step.implicit, step.at_rest, step.share = lasting, lasting, self._share
        self.leave(start)
        self.still = np.concatenate([self.roles.kinematic, more])
        self.held = start.values[self.still]
        self.hold_rows = np.concatenate([self.roles.holonomic, self.still])

    def leave(self, known: State) -> None:
        """Let the internal states follow the displacement from a known equilibrium, from their values there."""
        self.z, self._from = known.z, known.x
        self.balancing.known[:] = known.z

    def state(self, b: Balance) -> State:
        """Return the state of rest at a balance."""
        return super().state(replace(b, v=self.rest))

    @cached_property
    def pattern(self) -> SaddlePattern:
        """The pattern of the tangent."""
        return SaddlePattern(self.work, self.force_rows, self.hold_rows)

    def holding_forces(self, t: float, start: State) -> Array:
        """Return the multipliers that best balance the given forces at a configuration, by least squares.

        They contain the geometric stiffness of a mechanism (a pendulum's gravity), without which the first tangent
        would be singular.
        """
        if not self.force_rows.size:
            return np.zeros(0)
        none = np.zeros(self.force_rows.size)
        b = self.balance(t, start.x, self.rest, self.rest, none, start.e)
        C = self.work.tables.J.matrix(self.work.J)[self.force_rows][:, : self.structure.nf]
        return np.asarray(lsmr(C.T, -b.r, atol=1e-12, btol=1e-12, conlim=1e10)[0])

    def equations(self, t: float, x: Array, mu: Array, unwrap_from: Array) -> Equations:
        """Evaluate the residual (r, gap) and its derivative by (x, mu) at time t."""
        v = self._rate * (x - self._from) if self._rate else self.rest
        b = self.balance(t, x, v, self.rest, mu, unwrap_from)
        self.stiffness(self._rate, share=self._share)
        values = self.system.kinematics.values(b.e, x)
        gap = np.concatenate([b.gap, values[self.still] - self.held])
        largest = float(np.abs(self.free).max(initial=0.0))
        return Equations(b, np.concatenate([b.r, gap]), self.pattern.matrix(self.work), largest)

    def size(self, q: Equations, residual: Array) -> float:
        """Return the size of a residual in natural scales."""
        nf = self.structure.nf
        gap = residual[nf:] / self.scales[self.hold_rows]
        return self.error(residual[:nf], gap, q.stiffness, q.balance.scale)

    def extent(self, step: Array) -> float:
        """Return the largest change of a coordinate, in its natural scale, in a step of (x, mu)."""
        return float(np.abs(step[: self.structure.nf] / self.x_scale).max(initial=0.0))

    def when(self, t: float) -> str:
        """Return the time in words if loads or prescribed motions depend on it; empty otherwise."""
        depends = len(self.system.loads.functions) or len(self.roles.motions)
        return f" at t = {t:g} s" if depends else ""

    def unheld(self) -> str:
        """Return advice if the friction of a contact at the last balance depends on the sliding velocity."""
        s, law = self.structure, self.work.tables.law
        rows = law.codes[np.flatnonzero(self.work.S_rate[:-1])] // max(s.m + s.k, 1)
        sliding = [s.names[row].rpartition(".")[0] for row in rows if row >= s.m]
        sliding = [name for name in sliding if f"{name}.gap" in s.index]
        if not sliding:
            return ""
        how = "depends on the sliding velocity and is zero at rest: bristle_stiffness holds"
        return f"; the friction of '{sliding[0]}' {how}"

    def rate(self, q: Equations) -> Array:
        """Return the derivative of the residual with respect to time at fixed x and mu."""
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
