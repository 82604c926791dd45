"""The independent description of one part of a model, in maximal coordinates; nothing of flexel is used in it."""

import numpy as np

from flexel.base.arrays import Array


class Twin:
    """One part: its energies, constraints and forces as functions of the coordinates of its nodes.

    A subclass says what it has; all answers here are empty.  x and v are flexel's nodal coordinates of `nodes`, one
    node after the other (positions; planar angles; Euler parameters λ0 … λ3), and their rates.  The norm of Euler
    parameters is a constraint of the node, which the oracle adds.

    `kinetic`, `potential`, `rigid` and `slips` are differentiated by steps in the complex plane.  They must be
    analytic (no abs, no real part, no branch that depends on x) and take x, v of shape (n, ...): components along the
    first axis, configurations beside each other along the others.  `force` and `zdot` are called with real x, v (n,)
    only, and may be piecewise.

    Attributes
    ----------
    nodes : tuple of str
        Names of the nodes whose coordinates are x, in this order.
    states : tuple of str
        Names of the internal states z of its law, as flexel names them.
    conserves : bool
        Energy is conserved: no damping, no load, nothing that depends on time.
    """

    nodes: tuple[str, ...] = ()
    states: tuple[str, ...] = ()
    conserves: bool = True

    def kinetic(self, x: Array, v: Array) -> Array:
        """T (...) [J], quadratic in v."""
        return np.zeros(x.shape[1:])

    def potential(self, x: Array) -> Array:
        """U (...) [J]: weight, springs, strain."""
        return np.zeros(x.shape[1:])

    def rigid(self, x: Array, t: Array) -> Array:
        """Holonomic constraints φ(x, t) = 0 (k, ...); prescribed motions too.  t is a number or (...)."""
        return np.zeros((0, *x.shape[1:]))

    def slips(self, x: Array) -> Array:
        """A(x) (k, n, ...) of the non-holonomic constraints A v = 0."""
        return np.zeros((0, *x.shape))

    def force(self, x: Array, v: Array, z: Array, t: float) -> Array:
        """Generalized forces (n,) on x that have no potential: dampers, tyres, loads."""
        return np.zeros_like(x)

    def scaled(self, length: float, mirror: bool) -> Array:
        """Factors (len(states),) of the internal states where lengths are longer, or the model is mirrored."""
        return np.full(len(self.states), length)

    def zdot(self, x: Array, v: Array, z: Array, t: float) -> Array:
        """Rates (len(states),) of the internal states."""
        return np.zeros(len(self.states))
