"""Orientations that turn freely, in the variables of a step of Radau IIA; see turns.h."""

from __future__ import annotations

import numpy as np

from flexel.base.arrays import Array
from flexel.base.quaternions import product
from flexel.engine.rotations import LISTS, Rotations
from flexel.engine.structs import Struct
from flexel.generated._kernels import ffi


class Turns(Struct):
    """The struct of turns.h for one choice of degrees of freedom.

    Parameters
    ----------
    rotations : Rotations

    Attributes
    ----------
    start, first : ndarray (count, 4)
        Euler parameters at the start of the step and of the motion.
    """

    def __init__(self, rotations: Rotations) -> None:
        super().__init__(ffi.new("flexel_turns *"))
        self.rotations, c = rotations, self.struct
        c.count, c.nq = rotations.count, rotations.nq
        for name in LISTS:
            setattr(c, name, self.integers(getattr(rotations, name).flatten()))
        self.start, self.first, self._seen = (
            self.new(name, 4 * rotations.count).reshape(-1, 4) for name in ("start", "first", "seen")
        )
        self._spin = self.new("spin", 3 * rotations.count).reshape(-1, 3)

    def keep_first(self, before: Turns) -> None:
        """Keep the orientations at the start of the motion, of frames that both have."""
        numbers = before.rotations.numbers
        for at, i in self.rotations.numbers.items():
            if at in numbers:
                self.first[i] = before.first[numbers[at]]

    def take_over(self, before: Turns) -> None:
        """Keep what the Jacobian is for, in another choice of Euler parameters of the same frames."""
        numbers = before.rotations.numbers
        order = [numbers[at] for at in self.rotations.numbers]
        self._seen[:], self._spin[:] = before._seen[order], before._spin[order]

    def jacobian(self, A: Array, y: Array, f: Array) -> Array:
        """Return the derivatives (ny, ny) of the rates of the variables by the variables, at the start of a step.

        Parameters
        ----------
        A : ndarray (ny, ny)
            The same of y = (q, q_d', z) with Euler parameters and their rates.
        y, f : ndarray (ny,)
            The variables and their rates.
        """
        r, change = self.rotations, np.eye(y.size)
        blocks = [self._blocks(i, y, f) for i in range(r.count)]
        for dof, (B, C, _, _) in zip(r.dof, blocks, strict=True):
            rate = r.nq + dof
            change[np.ix_(dof, dof)] = change[np.ix_(rate, rate)] = B
            change[np.ix_(rate, dof)] = C
        J = A @ change
        for dof, (B, _, by_turn, by_rate) in zip(r.dof, blocks, strict=True):
            rate, w = r.nq + dof, y[r.nq + dof]
            J[np.ix_(rate, dof)] -= by_turn
            J[np.ix_(rate, rate)] -= by_rate
            J[rate] = np.linalg.solve(B, J[rate])
            J[dof] = 0.0
            J[np.ix_(dof, dof)], J[np.ix_(dof, rate)] = 0.5 * _by(w)[1:], np.eye(3)
        return J

    def _blocks(self, i: int, y: Array, f: Array) -> tuple[Array, Array, Array, Array]:
        """Return derivatives (3, 3) of the Euler parameters of frame i that are degrees of freedom, for p = 0.

        Those of L by p, which are those of L' by w too; of L' by p; of L'' by p and by w for a constant w'.
        """
        r, L = self.rotations, self.start[i]
        w, rate = y[r.nq + r.dof[i]], f[r.nq + r.dof[i]]
        part, left = r.part[i], np.column_stack([product(L, unit) for unit in np.eye(4)])
        B = 0.5 * left[part, 1:]
        C, by_turn = (0.25 * (left @ _by(u))[part] for u in (w, rate))
        return B, C, by_turn - 0.25 * (w @ w) * B, -0.5 * np.outer(L[part], w)


def _by(a: Array) -> Array:
    """Return the matrix (4, 3) of the product of a vector p with another one, (0, p) o (0, a)."""
    return np.column_stack([product(unit, np.insert(a, 0, 0.0)) for unit in np.eye(4)[1:]])
