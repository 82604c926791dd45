"""Orientations that turn freely, in the variables of a step of Radau IIA; see turns.h."""

from __future__ import annotations

import numpy as np

from flexel.base.arrays import Array, Index
from flexel.base.quaternions import matrix, product
from flexel.engine.rotations import LISTS, Rotations
from flexel.engine.structs import Struct
from flexel.generated._kernels import ffi

# Change of what acts on a frame, relative to the matrix of a step, from which axes are chosen: the rate of convergence
# from which the Jacobian is evaluated again, see radau.c.  The part of it that must be left along the other axes.  How
# much faster it must be than the frame turns: a body without forces is integrated most exactly along its own axes.
CHANGED, STEADIER, FAST = 1e-3, 0.5, 10.0


class Turns(Struct):
    """The struct of turns.h for one choice of degrees of freedom.

    Parameters
    ----------
    rotations : Rotations

    Attributes
    ----------
    start, first : ndarray (count, 4)
        Euler parameters at the start of the step and of the motion.
    space : ndarray of int (count,)
        Whether the variables of a frame are along the axes of space instead of its own.
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
        self.space = np.zeros(rotations.count, dtype=np.int32)
        c.space = self.integers(self.space)
        self._acting = np.full((2, rotations.count, 3, 3), np.nan)  # at `seen`, along the axes of the frames

    def keep_first(self, before: Turns) -> None:
        """Keep the orientations at the start of the motion, and the axes, of frames that both have."""
        numbers = before.rotations.numbers
        for at, i in self.rotations.numbers.items():
            if at in numbers:
                self.first[i], self.space[i] = before.first[numbers[at]], before.space[numbers[at]]

    def take_over(self, before: Turns) -> None:
        """Keep what the Jacobian is for, in another choice of Euler parameters of the same frames."""
        numbers = before.rotations.numbers
        order = [numbers[at] for at in self.rotations.numbers]
        self._seen[:], self._spin[:] = before._seen[order], before._spin[order]
        self._acting[:] = before._acting[:, order]

    def acting_in(self, J: Array) -> Array:
        """Return what acts on the frames, along their axes, from the Jacobian at the start of a step."""
        dof = self.rotations.dof
        rate = self.rotations.nq + dof
        found = np.array([J[rate[:, :, None], columns[:, None, :]] for columns in (rate, dof)])
        R = np.where(self.space[:, None, None], _axes(self.start), np.eye(3))
        return np.asarray(R.transpose(0, 2, 1) @ found @ R)

    def spinning(self) -> Array:
        """Return E (count, 3, 4) of angular velocities w = 2 E L' along the axes of the frames, at their start."""
        L0, L1, L2, L3 = self.start.T
        rows = ((-L1, L0, L3, -L2), (-L2, -L3, L0, L1), (-L3, L2, -L1, L0))
        return np.array(rows).transpose(2, 0, 1)

    def steadier(self, acting: Array, h: float) -> Index:
        """Return the numbers of the frames for which what acts on them has changed less along the other axes.

        Parameters
        ----------
        acting : ndarray (2, count, 3, 3)
            Derivatives of the angular acceleration of each frame by its angular velocity and its rotation, at the
            start of the step, along its axes; they are kept to compare the next ones with them.
        h : float
            Length of a step [s].
        """
        before, R = self._acting, _axes(self._seen).transpose(0, 2, 1) @ _axes(self.start)
        turned = R.transpose(0, 2, 1) @ before @ R
        weight = np.array([h, h**2])
        size, own, other = (
            weight @ np.linalg.norm(acting - old, axis=(2, 3)) for old in (0.0, before, turned)
        )
        own, other = np.where(self.space, other, own), np.where(self.space, own, other)
        turning = h * np.linalg.norm(self._spin, axis=1)
        matters = (own > CHANGED) & (size > FAST * (turning + turning**2))
        self._acting = acting
        return np.flatnonzero(matters & (other < STEADIER * own))

    def change_axes(self, i: int, *values: Array) -> None:
        """Have the variables of a frame along the other axes, and in values and rates (…, ny) of them."""
        R = _axes(self.start)[i]
        turn = R.T if self.space[i] else R
        self.space[i] = not self.space[i]
        for array in values:
            for at in (self.rotations.dof[i], self.rotations.nq + self.rotations.dof[i]):
                array[..., at] = array[..., at] @ turn.T

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
        for i, (B, _, by_turn, by_rate) in enumerate(blocks):
            dof, sign = r.dof[i], -1.0 if self.space[i] else 1.0
            rate, w = r.nq + dof, y[r.nq + dof]
            J[np.ix_(rate, dof)] -= by_turn
            J[np.ix_(rate, rate)] -= by_rate
            J[rate] = np.linalg.solve(B, J[rate])
            J[dof] = 0.0
            J[np.ix_(dof, dof)], J[np.ix_(dof, rate)] = sign * 0.5 * _by(w)[1:], np.eye(3)
        return J

    def _blocks(self, i: int, y: Array, f: Array) -> tuple[Array, Array, Array, Array]:
        """Return derivatives (3, 3) of the Euler parameters of frame i that are degrees of freedom, for p = 0.

        Those of L by p, which are those of L' by w too; of L' by p; of L'' by p and by w for a constant w'.  Along the
        axes of space the products have their factors in the reverse order.
        """
        r, L = self.rotations, self.start[i]
        w, rate, part = y[r.nq + r.dof[i]], f[r.nq + r.dof[i]], r.part[i]
        if self.space[i]:
            side = np.column_stack([product(unit, L) for unit in np.eye(4)])
            C, by_turn = (0.25 * (side @ _of(u))[part] for u in (w, rate))
        else:
            side = np.column_stack([product(L, unit) for unit in np.eye(4)])
            C, by_turn = (0.25 * (side @ _by(u))[part] for u in (w, rate))
        B = 0.5 * side[part, 1:]
        return B, C, by_turn - 0.25 * (w @ w) * B, -0.5 * np.outer(L[part], w)


def _axes(L: Array) -> Array:
    """Return the rotation matrices (count, 3, 3) of Euler parameters (count, 4)."""
    return matrix(L.T).transpose(2, 0, 1)


def _by(a: Array) -> Array:
    """Return the matrix (4, 3) of the product of a vector p with another one, (0, p) o (0, a)."""
    return np.column_stack([product(unit, np.insert(a, 0, 0.0)) for unit in np.eye(4)[1:]])


def _of(a: Array) -> Array:
    """Return the matrix (4, 3) of the product of a vector with p, (0, a) o (0, p)."""
    return np.column_stack([product(np.insert(a, 0, 0.0), unit) for unit in np.eye(4)[1:]])
