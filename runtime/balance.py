"""The balance of forces in coordinates and multipliers together: residual and tangent (saddle-point form).

r = M a + h - f + De' sigma + V' tau = 0 with the constraints beside it.  Statics, buckling and implicit
integration share it; none needs a choice of independent coordinates.
Imports numpy and the dynamics.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from flexel.diagnose import largest, null_space, quoted
from flexel.dynamics import Forces, forces, with_multipliers
from flexel.errors import DynamicsError
from flexel.evaluate import Tangents
from flexel.kinematics import Configuration, wrap
from flexel.state import State
from flexel.states import unwrap
from flexel.structure import Array, Index

if TYPE_CHECKING:
    from flexel.system import System

TINY_FORCE = 1e-3  # [N] in the denominator of relative unbalances: 1e-15 N counts as nothing


@dataclass(frozen=True)
class Balance:
    """Unbalance at coordinates x, rates v, accelerations a and multipliers mu.

    Attributes
    ----------
    configuration : Configuration
    v, a : ndarray (n,)
    e : ndarray (m,)
        Deformations with their turns.
    forces : Forces
    r : ndarray (nf,)
        Unbalanced forces on the free coordinates.
    gap : ndarray (nh,)
        Violation of the rigid and prescribed conditions.
    scale : float
        Size of the forces that balance one another [N].
    """

    configuration: Configuration
    v: Array
    a: Array
    e: Array
    forces: Forces
    multiplier: Array
    r: Array
    gap: Array
    scale: float


class Saddle:
    """Residual, tangent and states of a system in coordinates and multipliers.

    Attributes
    ----------
    force_rows : ndarray of int
        Quantities whose multipliers are unknown: rigid and prescribed conditions, rolling slips.
    """

    def __init__(self, system: System) -> None:
        self.system = system
        self.structure = system.structure
        self.roles = system.roles
        self.force_rows: Index = np.concatenate([self.roles.holonomic, self.roles.zero])
        self.scales = system.kinematics.scales(np.arange(len(self.structure.names)))
        self.first = self.structure.m + self.structure.k
        self.x_scale = self.scales[self.first : self.first + self.structure.nf]
        self.rest = np.zeros(self.structure.n)
        self.z = self.structure.z0  # internal states of laws, held

    def multipliers(self, state: State) -> Array:
        """Multipliers of the constraints at a state: stresses less those of laws and loads."""
        c = Configuration(state.t, state.x, state.e, state.J)
        given = forces(self.system.kinematics, self.system.loads, c, state.v, state.e, state.z)
        return np.concatenate([state.stress - given.stress, -state.reactions])[self.force_rows]

    def balance(self, t: float, x: Array, v: Array, a: Array, mu: Array, e_near: Array) -> Balance:
        """Unbalance at (x, v, a, mu) and time t; angles are counted from `e_near`."""
        s, kinematics = self.structure, self.system.kinematics
        principal, J = kinematics.evaluation.position(x)
        e = unwrap(s, principal, e_near)
        c = Configuration(t, x, principal, J)
        given = forces(kinematics, self.system.loads, c, v, e, self.z)
        multiplier = np.zeros(len(s.names))
        multiplier[self.force_rows] = mu
        inertia = given.M[: s.nf] @ a
        C = J[self.force_rows, : s.nf]
        target = kinematics.target(t, np.zeros(0))
        rows = self.roles.holonomic
        gap = wrap(kinematics.values(e, x)[rows] - target, s.angle[rows])
        stress = given.stress + multiplier[: self.first]
        parts = (
            np.abs(stress) * np.abs(J[: self.first, : s.nf]).max(axis=1, initial=0.0),
            given.F[: s.nf],
            inertia,
            mu,
        )
        scale = max(float(np.abs(z).max(initial=0.0)) for z in parts)
        return Balance(c, v, a, e, given, multiplier, inertia - given.F[: s.nf] + mu @ C, gap, scale)

    def tangents(self, b: Balance) -> Tangents:
        """Derivatives at a balance, the multipliers' stresses included."""
        c = b.configuration
        stress = b.forces.stress + b.multiplier[: self.first]
        return self.system.evaluation.tangents(c.x, b.v, b.a, c.J, b.e, stress, self.z, c.t)

    def load_rate(self, b: Balance) -> tuple[Array, Array]:
        """Derivatives of r (nf,) and of the gap (nh,) with respect to the time at fixed x and mu."""
        s, t = self.structure, b.configuration.t
        nodal, applied = self.system.loads.at(t, order=1)
        gap = np.zeros(self.roles.holonomic.size)
        if self.roles.motions:
            gap[self.roles.rigid.size :] = -self.roles.motion(t)[1]
        return -nodal[: s.nf] + applied @ b.configuration.J[: applied.size, : s.nf], gap

    def error(self, b: Balance, r: Array, gap: Array, stiffness: Array) -> float:
        """Largest unbalance relative to the forces that balance, or gap relative to its natural scale.

        A stiffness K turns a rounding of x into an unbalance of about 1e-15 K x, below which nothing can go; with
        it in the denominator, the tolerance 1e-12 is met there.
        """
        stiff = float(np.abs(stiffness).max(initial=0.0)) * float(self.x_scale.max(initial=0.0))
        force = float(np.abs(r).max(initial=0.0)) / (b.scale + 1e-3 * stiff + TINY_FORCE)
        return max(force, float(np.abs(gap).max(initial=0.0)))

    def state(self, b: Balance) -> State:
        """The complete state at a balance."""
        kinematics, loads = self.system.kinematics, self.system.loads
        return with_multipliers(
            kinematics, loads, b.configuration, b.v, b.a, b.e, self.z, b.forces, b.multiplier
        )

    def solve(self, matrix: Array, rhs: Array) -> Array:
        """Solve a saddle-point system; names the motion that nothing resists if it is singular.

        Raises
        ------
        DynamicsError
        """
        try:
            return np.asarray(np.linalg.solve(matrix, rhs))
        except np.linalg.LinAlgError as error:
            nf = self.structure.nf
            right, _ = null_space(matrix, matrix.shape[0])
            rows = np.arange(nf) + self.first
            names = largest(self.structure, rows, right[:nf, 0]) if right.shape[1] else []
            raise DynamicsError(
                f"the stiffness is singular: nothing resists a motion of {quoted(names)}; support it, or give it "
                "a stiffness or a mass"
            ) from error
