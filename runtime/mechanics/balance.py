"""The balance of forces in coordinates and multipliers together: residual and tangent (saddle-point form).

r = M a + h - f + De' sigma + V' tau = 0 together with the constraints.  Statics, buckling and implicit
integration share it; none needs a choice of independent coordinates.  Everything is sparse, with patterns
that are computed once.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from flexel.base.arrays import Array, Index
from flexel.engine.finite import check_finite, check_tangent
from flexel.engine.local import Inertia
from flexel.engine.locallaws import ImplicitStep, LawForces
from flexel.mechanics.core import Core
from flexel.mechanics.kinematics import unwrap, wrap
from flexel.structure.state import Energy, State

TINY_FORCE = 1e-3  # [N] in the denominator of relative unbalances: 1e-15 N counts as zero


@dataclass(frozen=True)
class Balance:
    """Force balance at coordinates x, rates v, accelerations a and multipliers mu.

    Attributes
    ----------
    x, v, a : ndarray (n,)
    e : ndarray (m,)
        Deformations with counted turns.
    J : ndarray
        Rows of deformations and slips, flat (see `Local`).
    w : ndarray (m + k,)
        Rates of the deformations, and slips.
    given, stress : ndarray (m + k,)
        Stresses of laws and loads, without and with the multipliers.
    multiplier : ndarray (m + k + n,)
        Multipliers by quantity.
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
    e: Array
    J: Array
    w: Array
    inertia: Inertia
    laws: LawForces
    given: Array
    stress: Array
    multiplier: Array
    force: Array
    r: Array
    gap: Array
    scale: float


class Saddle:
    """Residual, tangent and states of a system in coordinates and multipliers.

    Attributes
    ----------
    force_rows : ndarray of int
        Quantities whose multipliers are unknown: rigid and prescribed conditions, rolling slips.
    length : float
        Largest natural scale of the coordinates.
    """

    def __init__(self, system: Core) -> None:
        self.system = system
        self.local = system.local
        self.structure = system.structure
        self.roles = system.roles
        self.force_rows: Index = np.concatenate([self.roles.holonomic, self.roles.zero])
        self.scales = system.kinematics.scales(np.arange(len(self.structure.names)))
        self.first = self.structure.m + self.structure.k
        self.x_scale = self.scales[self.first : self.first + self.structure.nf]
        self.length = float(self.x_scale.max(initial=0.0))
        self.rest = np.zeros(self.structure.n)
        self.z = self.structure.z0  # internal states of laws: held, or those at the start of an implicit step
        self.step: ImplicitStep | None = None
        self._sizes: Array | None = None  # of the rows of J, recomputed with every tangent
        self._period = self.structure.period[self.roles.holonomic]

    def multipliers(self, state: State) -> Array:
        """Multipliers of the constraints at a state: stresses minus those of laws and loads."""
        e, J = state.e, self.local.position(state.x)[1]
        laws = self.local.laws.forces(e, self.local.rates(J, state.v), state.z, state.t).stress
        applied = self.system.loads.at(state.t)[1]
        return np.concatenate([state.stresses - laws - applied, -state.reactions])[self.force_rows]

    def balance(self, t: float, x: Array, v: Array, a: Array, mu: Array, e_near: Array) -> Balance:
        """Unbalance at a time, with the parts it is made of.

        Parameters
        ----------
        t : float
            Time [s].
        x, v, a : ndarray (n,)
            Coordinates, rates and accelerations.
        mu : ndarray (nm,)
            Multipliers of `force_rows`.
        e_near : ndarray (m,)
            Deformations nearby, from which the turns of angles are counted.
        """
        s, local = self.structure, self.local
        principal, J = local.position(x)
        e = unwrap(s, principal, e_near)
        w = local.rates(J, v)
        laws = self._laws(e, w, t)
        nodal, applied = self.system.loads.at(t)
        given = laws.stress + applied
        multiplier = np.zeros(len(s.names))
        multiplier[self.force_rows] = mu
        stress = given + multiplier[: self.first]
        inertia = local.inertia(x, v)
        momentum = local.momentum(inertia.M, a)
        outer = inertia.h - inertia.f - nodal
        force = momentum + outer + local.pull(J, stress)
        r = (force + multiplier[self.first :])[: s.nf]
        if self._sizes is None:
            self._sizes = self._row_sizes(J)
        sizes = np.concatenate([stress * self._sizes, outer[: s.nf], momentum[: s.nf], mu])
        scale = float(np.abs(sizes).max(initial=0.0))
        gap = self._gap(t, x, e if s.relations else principal)
        return Balance(
            t, x, v, a, e, J, w, inertia, laws, given, stress, multiplier, force, r, gap, scale
        )  # fmt: skip

    def _laws(self, e: Array, w: Array, t: float) -> LawForces:
        if self.step is None or not self.z.size:
            return self.local.laws.forces(e, w, self.z, t)
        return self.local.laws.step(e, w, self.z, t, self.step)

    def _gap(self, t: float, x: Array, e: Array) -> Array:
        rows = self.roles.holonomic
        if not rows.size:
            return np.zeros(0)
        kinematics = self.system.kinematics
        target = kinematics.target(kinematics.roles.motion(t), np.zeros(0))
        return wrap(kinematics.values(e, x)[rows] - target, self._period)

    def _row_sizes(self, J: Array) -> Array:
        """Largest entry of the row of each quantity in J."""
        local = self.local
        sizes = np.zeros(local.line_of.size)
        if J.size:
            sizes[local.lines] = np.maximum.reduceat(np.abs(J), local.starts_J[:-1])
        return sizes

    def stiffness(
        self, b: Balance, rate: float = 0.0, acceleration: float = 0.0
    ) -> tuple[Array, Array, Array | None]:
        """Derivative of r with respect to x, with v and a varying at the given rates, without the constant masses.

        Returns K (flat), its entries across elements, and the derivative of the rates of all quantities (flat
        like J; None where neither damping nor rolling needs it).
        """
        local, self._sizes = self.local, None
        K = local.stress_stiffness(b.x, b.stress)
        local.inertia_tangent(K, b.x, b.v, b.a, b.inertia.M, rate)
        if acceleration and local.size_M:
            K[: local.size_M] += acceleration * b.inertia.M
        share = 0.0 if self.step is None else self.step.share
        by_value, by_rate = local.laws.tangents(b.e, b.w, b.laws.z, b.t, share)
        if np.isfinite(b.laws.stress).all():  # else the trial step was too long, and the iteration rejects it
            check_tangent(self.structure, local.laws.finite(by_value, by_rate), b.t)
        phi = None
        if np.any(b.v) and (self.roles.zero.size or by_rate.any()):
            phi = local.phi(b.x, b.v)
        cross = local.laws.add(K, b.J, phi, by_value, by_rate, rate)
        return K, cross, phi

    def load_rate(self, b: Balance) -> tuple[Array, Array]:
        """Derivatives of r (nf,) and of the gap (nh,) with respect to the time at fixed x and mu."""
        s = self.structure
        nodal, applied = self.system.loads.at(b.t, order=1)
        gap = np.zeros(self.roles.holonomic.size)
        if self.roles.motions:
            gap[self.roles.rigid.size :] = -self.roles.motion(b.t)[1]
        return (self.local.pull(b.J, applied) - nodal)[: s.nf], gap

    def error(
        self, b: Balance, r: Array, gap: Array, stiffness: float | Array, scale: float | None = None
    ) -> float:
        """Largest residual relative to the balancing forces, or gap relative to its natural scale.

        A stiffness K turns rounding of x into a residual of about 1e-15 K x, which is a lower bound; with its largest
        entry, or that of each row, in the denominator, the tolerance 1e-12 can still be met.  `scale` replaces the
        size of the forces of the balance.
        """
        stiff = stiffness * self.length
        force = np.abs(r) / ((scale or b.scale) + 1e-3 * stiff + TINY_FORCE)
        return max(float(force.max(initial=0.0)), float(np.abs(gap).max(initial=0.0)))

    def energy(self, b: Balance) -> Energy:
        """Kinetic, potential and strain energy at a balance."""
        kinetic = float(b.v @ self.local.momentum(b.inertia.M, b.v)) / 2
        values = self.system.kinematics.values(b.e, b.x)
        potential = b.inertia.potential + self.system.loads.potential(b.t, values)
        return Energy(kinetic, potential, float(b.laws.stored.sum()))

    def state(self, b: Balance) -> State:
        """The complete state at a balance."""
        s, kinematics, local = self.structure, self.system.kinematics, self.local
        check_finite(s, b.given, b.laws.zd, b.t)
        reactions = -b.multiplier[self.first :]
        reactions[s.nf :] = b.force[s.nf :]
        return State(
            t=b.t,
            x=b.x,
            v=b.v,
            a=b.a,
            e=b.e,
            rates=np.concatenate([b.w, b.v]),
            stresses=b.stress,
            reactions=reactions,
            roles=self.roles,
            evaluation=self.system.evaluation,
            energy=self.energy(b),
            drift=kinematics.drift(b.e, b.x),
            z=b.laws.z,
            zd=b.laws.zd,
            dissipated=float(b.laws.dissipated.sum()),
            Phi_v=np.concatenate([local.convective(b.x, b.v) + local.rates(b.J, b.a), b.a]),
        )
