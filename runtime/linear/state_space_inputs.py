"""Inputs of a state-space model: loads, accelerations of prescribed motions, and their displacements."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from flexel.base.arguments import names
from flexel.base.arrays import Array
from flexel.base.errors import LinearizationError
from flexel.mechanics.linearized_system import LinearizedSystem

DISPLACEMENT = "displacement:"
Matrices = tuple[Array, Array, Array, Array]


@dataclass(frozen=True)
class Inputs:
    """The inputs of a state-space model as requested.

    Attributes
    ----------
    labels : tuple of str
        A load by its quantity, an acceleration with two primes, a displacement with its prefix.
    quantities : tuple of str
    driven : tuple of int
        Inputs that are prescribed motions; the states hold their rates, then their values, in this order.
    displaced : tuple of int
        Those of them whose displacement is the input.
    """

    labels: tuple[str, ...]
    quantities: tuple[str, ...]
    driven: tuple[int, ...]
    displaced: tuple[int, ...]

    @classmethod
    def of(cls, lin: LinearizedSystem, given: Sequence[str]) -> Inputs:
        """Find the inputs with the given names.

        Raises
        ------
        LinearizationError
            A displacement or an acceleration of what is not prescribed; a quantity that is named twice.
        """
        labels, quantities, driven, displaced = [], [], [], []
        for i, name in enumerate(names(given, "inputs")):
            base = name.removeprefix(DISPLACEMENT).removesuffix("''")
            prescribed = base in lin.prescribed
            if name != base and not prescribed:
                lin.state.structure.find(base, "input")
                raise LinearizationError(
                    f"input '{name}': the motion of '{base}' is not prescribed; prescribe it, or name '{base}' for a "
                    "load on it"
                )
            if base in quantities:
                raise LinearizationError(f"input '{name}': '{base}' is already an input; name it once")
            if name.startswith(DISPLACEMENT):
                displaced.append(i)
            if prescribed:
                driven.append(i)
            labels.append(f"{base}''" if prescribed and i not in displaced else name)
            quantities.append(base)
        return cls(tuple(labels), tuple(quantities), tuple(driven), tuple(displaced))

    def states(self, own: Sequence[str]) -> tuple[str, ...]:
        """Return the names of the states after those of the model; a star marks states that displacements shift."""
        kept = [self.quantities[i] for i in self.driven if i not in self.displaced]
        mark = "*" if self.displaced else ""
        return (*(f"{name}{mark}" for name in own), *(f"{name}'" for name in kept), *kept)

    def by_displacement(self, matrices: Matrices, own: int, outputs: Sequence[str]) -> Matrices:
        """Convert matrices for accelerations as inputs, with rates and values as states, to displacements as inputs.

        With x' = A x + B₂ u'' + B₁ u' + B₀ u, the state x - B₂ u' - (B₁ + A B₂) u has no rates of u in its equation.

        Parameters
        ----------
        own : int
            Number of states of the model itself.

        Raises
        ------
        LinearizationError
            An output that depends directly on the rate of an input, and so is not a function of the displacement.
        """
        A, B, C, D = matrices
        count, gone = len(self.driven), []
        for i in self.displaced:
            rate = own + self.driven.index(i)
            value = rate + count
            main = np.r_[0:own]
            B2, B1, B0 = B[main, i], A[main, rate], A[main, value]
            shift = B1 + A[np.ix_(main, main)] @ B2
            fast = np.abs(np.column_stack([D[:, i], C[:, rate] + C[:, main] @ B2]))
            scale = max(float(np.abs(C).max(initial=0.0)), float(np.abs(D).max(initial=0.0)), 1e-300)
            if fast.max(initial=0.0) > 1e-9 * scale:
                name = outputs[int(np.argmax(fast.max(axis=1)))]
                raise LinearizationError(
                    f"input '{self.labels[i]}': the output '{name}' contains its rate; use the acceleration as the "
                    f"input, \"{self.quantities[i]}''\""
                )
            B, D = B.copy(), D.copy()
            B[main, i] = B0 + A[np.ix_(main, main)] @ shift
            D[:, i] = C[:, value] + C[:, main] @ shift
            gone += [rate, value]
        kept = np.delete(np.arange(len(A)), gone)
        return A[np.ix_(kept, kept)], B[kept], C[:, kept], D
