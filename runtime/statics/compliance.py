"""Compliance of a body at a state of rest: its displacement due to a small force or moment in every direction.

The columns are solutions of the saddle-point system of statics, [r_x C'; C 0], loaded by unit forces and moments
on the body, preload and constraint forces included.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from flexel.base.arguments import flag, vector
from flexel.base.arguments import names as checked_names
from flexel.base.arrays import Array
from flexel.base.errors import DynamicsError, ModelError
from flexel.base.quaternions import matrix, rotation_rows
from flexel.base.shown import PrintedTable, prints
from flexel.model.state import State, own_state
from flexel.statics.equilibrium import Rest
from flexel.system import CoreSystem

DIRECTIONS = ("x", "y", "z", "turn x", "turn y", "turn z")
PLANAR_DIRECTIONS = ("x", "y", "turn")
# Compliance, relative to the largest, in lengths of the model, below which a motion counts as rigid.
RIGID_TOLERANCE = 1e-14


@dataclass(frozen=True)
class Compliance:
    """Displacements and rotations of a body due to small forces and moments on it.

    Attributes
    ----------
    directions : tuple of str
        "x", "y", "z", "turn x", "turn y", "turn z"; of a planar model "x", "y", "turn".
    matrix : ndarray (6, 6) or (3, 3)
        [m/N, rad/N; m/(N m), rad/(N m)] in global axes.
    rotation : ndarray (6, 6) or (3, 3)
        From the body's axes to the global ones, for displacements and rotations together.
    """

    directions: tuple[str, ...]
    matrix: Array
    rotation: Array

    def _table(self) -> PrintedTable:
        rows = zip(self.directions, self.matrix, strict=True)
        return PrintedTable(
            "compliance in global axes [m/N, rad/N; m/(N m), rad/(N m)]",
            ("", *self.directions),
            [(name, *(f"{value:.5g}" for value in row)) for name, row in rows],
        )

    @prints
    def __repr__(self) -> str:
        return self._table().text

    def _repr_html_(self) -> str:
        return self._table().html

    @property
    def in_body(self) -> Array:
        """The compliance in the axes of the body's frame."""
        return np.asarray(self.rotation.T @ self.matrix @ self.rotation)

    def stiffness(self, body_axes: bool = False) -> dict[str, float]:
        """Return the stiffness in each direction, with all others free: 1 / C_ii; infinite for rigid directions."""
        C = self.in_body if flag(body_axes, "compliance", "body_axes") else self.matrix
        with np.errstate(divide="ignore"):
            return dict(zip(self.directions, (1 / np.diag(C)).tolist(), strict=True))

    def stiffness_matrix(self, body_axes: bool = False) -> Array:
        """Return the inverse of the compliance: forces when one direction moves and all others are held.

        Raises
        ------
        DynamicsError
            If a direction is rigid; names it.
        """
        C = self.in_body if flag(body_axes, "compliance", "body_axes") else self.matrix
        scale = np.sqrt(np.abs(np.diag(C)))
        if not np.all(scale):
            rigid = [d for d, size in zip(self.directions, scale, strict=True) if not size]
            raise DynamicsError(
                f"no stiffness matrix: {', '.join(rigid)} cannot move; use stiffness() instead"
            )
        w, V = np.linalg.eigh(C / np.outer(scale, scale))
        if abs(w).min() < 1e-12 * abs(w).max():
            motion = V[:, int(np.argmin(abs(w)))]
            rigid = [d for d, share in zip(self.directions, motion, strict=True) if abs(share) > 0.1]
            raise DynamicsError(
                f"no stiffness matrix: a motion in {', '.join(rigid)} is not possible; use stiffness() instead"
            )
        return np.asarray(np.linalg.inv(C / np.outer(scale, scale)) / np.outer(scale, scale))


def compliance(
    system: CoreSystem,
    point: str,
    frame: str,
    state: State,
    *,
    offset: Sequence[float] | Array | None,
    hold: Sequence[str],
) -> Compliance:
    """Compute the compliance of the body that a point and a frame belong to; see `System.compliance`.

    Parameters
    ----------
    point, frame : str
        Nodes of the body.
    state : State
        A state of rest, with its preload.
    offset : sequence of float (3,) or (2,), optional
        From the point to where forces act [m].
    hold : sequence of str
        Coordinates or deformations that are held.
    """
    own_state(system.structure, state, "compliance")
    s = system.structure
    for name, kinds in ((point, ("point", "planar_point")), (frame, ("frame", "planar_angle"))):
        if s.node(name).kind not in kinds:
            raise ModelError(
                f"compliance: node '{name}' is a {s.node(name).kind}; give a {kinds[0]} node here"
            )
    held = np.array([s.find(name, "compliance") for name in checked_names(hold, "compliance")], dtype=np.intp)
    if np.any((s.m <= held) & (held < s.m + s.k)):
        raise ModelError("compliance: a slip cannot be held; name coordinates or deformations")
    problem = Rest(system, state, held)
    q = problem.equations(state.t, state.x, problem.multipliers(state), state.e)
    B, turn = _rows(state, point, frame, offset)
    rhs = np.zeros((q.residual.size, B.shape[0]))
    rhs[: s.nf] = B[:, : s.nf].T
    moved = B[:, : s.nf] @ q.matrix.solve(rhs)[: s.nf]
    size = np.ones(len(moved))
    size[: len(moved) - (3 if len(moved) == 6 else 1)] = problem.x_scale.max(initial=0.0)
    shares = np.abs(moved) / np.outer(size, size)
    moved[shares < RIGID_TOLERANCE * shares.max(initial=0.0)] = 0.0
    directions = DIRECTIONS if B.shape[0] == 6 else PLANAR_DIRECTIONS
    return Compliance(directions, moved, turn)


def _rows(state: State, point: str, frame: str, offset: object) -> tuple[Array, Array]:
    """Return the displacements and rotations of the body for changes of x (6, n) or (3, n), and its axes."""
    s = state.structure
    at, of = s.places(point), s.places(frame)
    if (s.node(point).kind == "point") != (s.node(frame).kind == "frame"):
        raise ModelError(f"compliance: '{point}' and '{frame}' are not both spatial or both planar nodes")
    if at.size == 2:
        B = np.zeros((3, s.n))
        B[[0, 1], at], B[2, of[0]] = 1.0, 1.0
        cosine, sine = np.cos(state.x[of[0]]), np.sin(state.x[of[0]])
        turn = np.array([[cosine, -sine, 0.0], [sine, cosine, 0.0], [0.0, 0.0, 1.0]])
        if offset is not None:
            d = turn[:2, :2] @ vector(offset, "compliance", "offset", 2)
            B[:2] += np.outer([-d[1], d[0]], B[2])
        return B, turn
    B = np.zeros((6, s.n))
    B[[0, 1, 2], at] = 1.0
    q = state.x[of]
    B[3:, of] = rotation_rows(q)
    R = matrix(q)
    if offset is not None:
        d = R @ vector(offset, "compliance", "offset", 3)
        cross = np.array([[0, -d[2], d[1]], [d[2], 0, -d[0]], [-d[1], d[0], 0]])
        B[:3] -= cross @ B[3:]
    return B, np.asarray(np.kron(np.eye(2), R), dtype=float)
