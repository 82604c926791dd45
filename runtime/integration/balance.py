"""Evaluates the balance of forces in coordinates and multipliers: residual, tangent and states (saddle-point form).

r = M a + h - f + De' sigma + V' tau = 0 together with the constraints.  Statics, buckling and implicit
integration share it; none needs a choice of independent coordinates.  Everything is sparse, with patterns
that are computed once, and is evaluated in C.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from flexel.base.arrays import Array, Index
from flexel.engine.balancing import Balancing
from flexel.engine.finite import check_finite, check_slopes
from flexel.engine.workspace import Workspace
from flexel.mechanics.actuation import refuse_actuators
from flexel.mechanics.dynamics import state_in
from flexel.model.state import State
from flexel.system import CoreSystem

TINY_FORCE = 1e-12  # [N] in the denominator of relative unbalances: 1e-24 N counts as zero


def _same(t: float) -> float:
    return t


@dataclass(frozen=True)
class Balance:
    """Force balance at coordinates x, rates v, accelerations a, internal states z and multipliers mu.

    Attributes
    ----------
    x, v, a : ndarray (n,)
    z, zd : ndarray (nz,)
        Internal states of laws, and their rates.
    e : ndarray (m,)
        Deformations with counted turns.
    w : ndarray (m + k,)
        Rates of the deformations, and slips.
    mu : ndarray (nm,)
        Multipliers of `Saddle.force_rows`.
    force : ndarray (n,)
        M a + h - f + De' sigma + V' tau, given nodal forces included.
    r : ndarray (nf,)
        Unbalanced forces on the free coordinates.
    gap : ndarray (nh,)
        Violation of the rigid and prescribed conditions.
    scale : float
        Size of the balancing forces [N].
    """

    t: float
    x: Array
    v: Array
    a: Array
    z: Array
    zd: Array
    e: Array
    w: Array
    mu: Array
    force: Array
    r: Array
    gap: Array
    scale: float


class Saddle:
    """Residual, tangent and states of a system in coordinates and multipliers.

    Parameters
    ----------
    system : CoreSystem
    more : ndarray of int, optional
        Further quantities whose multipliers are unknown.
    work : Workspace, optional
        Workspace of the evaluation; by default that of this thread.

    Attributes
    ----------
    force_rows : ndarray of int
        Quantities whose multipliers are unknown: rigid and prescribed conditions, rolling slips, further ones.
    length : float
        Largest natural scale of the coordinates.
    motion : ndarray (3, prescribed)
        Value, first and second rate of the prescribed motions at the time of the balance.
    """

    def __init__(self, system: CoreSystem, more: Index | None = None, work: Workspace | None = None) -> None:
        refuse_actuators(system.structure, system.roles)
        self.system = system
        self.structure = system.structure
        self.roles = system.roles
        self.work = system.evaluation.work if work is None else work
        none = np.zeros(0, dtype=np.intp)
        self.force_rows: Index = np.concatenate(
            [self.roles.holonomic, self.roles.zero, none if more is None else more]
        )
        self.scales = system.kinematics.scales(np.arange(len(self.structure.names)))
        self.first = self.structure.m + self.structure.k
        self.x_scale = self.scales[self.first : self.first + self.structure.nf]
        self.length = float(self.x_scale.max(initial=0.0))
        self.rest = np.zeros(self.structure.n)
        self.motion = np.zeros((3, 0))
        self.z = self.structure.z0  # internal states of laws
        self.inside: Callable[[float], float] = (
            _same  # time at which functions of time are evaluated, near a knot
        )
        self.balancing = Balancing(self.work, self.force_rows, self.structure.period[self.roles.holonomic])

    def multipliers(self, state: State) -> Array:
        """Return the multipliers of the constraints at a state: stresses less those of laws and loads."""
        both = np.concatenate([state.stresses - state.given, -state.reactions])
        return np.asarray(both[self.force_rows])

    def given(self, t: float) -> None:
        """Set the loads and the values of the prescribed motions at a time; rigid quantities stay at zero."""
        self.work.struct.t = t
        if self.system.loads.any:
            self.balancing.nodal[:], self.balancing.applied[:] = self.system.loads.at(self.inside(t))
        if self.roles.motions:
            self.motion = self.roles.motion(self.inside(t))
            self.balancing.target[self.roles.rigid.size :] = self.motion[0]

    def balance(self, t: float, x: Array, v: Array, a: Array, mu: Array, unwrap_from: Array) -> Balance:
        """Evaluate the unbalance at a time, with its parts, which the workspace holds until its next use.

        Parameters
        ----------
        t : float
            Time [s].
        x, v, a : ndarray (n,)
            Coordinates, rates and accelerations.
        mu : ndarray (nm,)
            Multipliers of `force_rows`.
        unwrap_from : ndarray (m,)
            Deformations nearby, from which the turns of angles are counted.
        """
        work = self.work
        self.given(t)
        work.x[:], work.v[:], work.a[:], work.z[:] = x, v, a, self.z
        work.unwrap_from[:], self.balancing.mu[:] = unwrap_from, mu
        self.balancing.run()
        return self.present()

    def present(self) -> Balance:
        """Return the balance that the workspace holds."""
        w, b = self.work, self.balancing
        vectors = (w.x, w.v, w.a, w.z, w.zd, w.e, w.w, b.mu, b.force, b.r, b.gap)
        x, v, a, z, zd, e, rates, mu, force, r, gap = (vector.copy() for vector in vectors)
        return Balance(float(w.struct.t), x, v, a, z, zd, e, rates, mu, force, r, gap, float(b.struct.scale))

    def stiffness(
        self, rate: float = 0.0, acceleration: float = 0.0, scaling: float = 1.0, share: float = 0.0
    ) -> None:
        """Evaluate the derivative of r by x into T of the workspace, with v and a varying at the given rates.

        Internal states of laws follow as in an implicit step z = known + share dz/dt; they are held if it is zero.

        Raises
        ------
        TangentError
            If a law has no slope there; names it.
        """
        if not self.balancing.tangent(scaling, rate, acceleration, share):
            self.check_slopes()

    @property
    def free(self) -> Array:
        """Return the entries of T of the workspace over the free coordinates, with the pattern `tables.T.pattern`."""
        return self.work.T[: self.work.tables.T.pattern.size]

    def check_slopes(self) -> None:
        """Raise if the derivatives of a law are not finite."""
        check_slopes(self.work)

    def load_rate(self, b: Balance) -> tuple[Array, Array]:
        """Return the derivatives of r (nf,) and of the gap (nh,) with respect to the time at fixed x and mu."""
        s = self.structure
        nodal, applied = self.system.loads.rates(b.t)
        gap = np.zeros(self.roles.holonomic.size)
        if self.roles.motions:
            gap[self.roles.rigid.size :] = -self.roles.motion(b.t)[1]
        self.work.x[:], self.work.unwrap_from[:] = b.x, b.e
        self.work.position()
        return (self.work.vjp(applied) - nodal)[: s.nf], gap

    def error(self, r: Array, gap: Array, stiffness: float, scale: float) -> float:
        """Return the largest residual relative to the balancing forces, or gap relative to its natural scale.

        Rounding errors of x cause a residual of about 1e-15 K x with a stiffness K, a lower bound; with its largest
        entry in the denominator, the tolerance 1e-12 can still be met.
        """
        force = np.abs(r) / (scale + 1e-3 * stiffness * self.length + TINY_FORCE)
        return max(float(force.max(initial=0.0)), float(np.abs(gap).max(initial=0.0)))

    def state(self, b: Balance) -> State:
        """Return the complete state at a balance."""
        s, loads = self.structure, self.system.loads
        work = self.system.evaluation.at(b.t, b.x, b.v, b.a, b.z, b.e)
        work.laws()
        work.inertia()
        work.convective()
        given, reactions = work.law_stress + loads.at(self.inside(b.t))[1], np.zeros(s.n)
        check_finite(s, given, work.zd, b.t)
        stresses = given.copy()
        inner = self.force_rows < self.first
        stresses[self.force_rows[inner]] += b.mu[inner]
        reactions[self.force_rows[~inner] - self.first] = -b.mu[~inner]
        reactions[s.nf :] = b.force[s.nf :]
        return state_in(self.system.kinematics, work, given, stresses, reactions)
