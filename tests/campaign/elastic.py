"""What flexible elements have in common: a stiffness on some deformations, with the others held or free."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from campaign.oracle import STEP, jacobian
from campaign.twin import Twin
from flexel.base.arrays import Array

Deformations = Callable[[Array], Array]


class Stressed(Twin):
    """A twin whose stresses are known without multipliers: those of laws on its deformations and slips."""

    def stresses(self, x: Array, v: Array, z: Array, t: float) -> dict[str, float]:
        """Stresses by the names of the model's quantities, where the program reports their sum of all laws there."""
        raise NotImplementedError


def rates(function: Deformations, x: Array, v: Array) -> Array:
    """Derivative of a function at x along v, by a complex step."""
    return np.asarray(np.imag(function(x + 1j * STEP * v)) / STEP)


@dataclass(frozen=True)
class Elastic:
    """Linear viscous elasticity of some deformations: S (e - e0) + D e'.

    Attributes
    ----------
    modes : names of all deformations of the element (m,)
    flexible : indices (k,) of those with a stiffness
    S, D : ndarray (k, k)
        Stiffness and damping.
    e0 : ndarray (k,)
        Deformations without stress.
    """

    modes: tuple[str, ...]
    flexible: tuple[int, ...]
    S: Array
    D: Array
    e0: Array

    def energy(self, e: Array) -> Array:
        """Strain energy (…) of the deformations (m, …)."""
        d = e[list(self.flexible)] - self.e0.reshape(-1, *(1,) * (e.ndim - 1))
        return np.asarray((d * np.tensordot(self.S, d, 1)).sum(0) / 2)

    def viscous(self, deformations: Deformations, x: Array, v: Array) -> Array:
        """Generalized forces (n,) of the damping on the coordinates."""
        if not self.D.any():
            return np.zeros_like(x)
        k = list(self.flexible)
        return np.asarray(-(self.D @ rates(deformations, x, v)[k]) @ jacobian(deformations, x)[k])

    def stresses(self, deformations: Deformations, x: Array, v: Array) -> dict[str, float]:
        """Derivative of the energy by the deformations, and the damping, by the names of the flexible modes."""
        conservative = jacobian(self.energy, deformations(x))
        viscous = self.D @ rates(deformations, x, v)[list(self.flexible)]
        return {self.modes[i]: float(conservative[i] + viscous[j]) for j, i in enumerate(self.flexible)}


def elastic(modes: Sequence[str], S: Array, e0: Array, ratio: float | Array) -> Elastic:
    """Elasticity with the stiffness (m, m) of all modes; damping is `ratio` (a number or (m,)) times it."""
    flexible = tuple(np.flatnonzero(np.diag(S) > 0).tolist())
    D = np.broadcast_to(ratio, len(modes))[:, None] * S
    own = np.ix_(flexible, flexible)
    return Elastic(tuple(modes), flexible, S[own], D[own], e0[list(flexible)])
