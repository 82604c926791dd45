"""Sparse factors for the stages of Radau IIA: the saddle matrix of coordinates and multipliers; see radau_saddle.h."""

from __future__ import annotations

import numpy as np

from flexel.base.arrays import Array
from flexel.engine.angles import Angles
from flexel.engine.coordinate_work import Entries
from flexel.engine.finite import check_slopes
from flexel.engine.rotations import Rotations
from flexel.engine.structs import Struct
from flexel.engine.turns import Turns
from flexel.generated._kernels import ffi, lib
from flexel.mechanics import dynamics
from flexel.mechanics.kinematics import Kinematics
from flexel.model.snapshot import Snapshot

FEWEST = 32  # degrees of freedom from which sparse factors take less time: with cables and beams 20 to 40, with chains
# of rigid rods 40


def sparse(kinematics: Kinematics) -> bool:
    """Whether sparse factors suit a model."""
    roles = kinematics.roles
    return roles.nd >= FEWEST and roles.nq == roles.nd and not kinematics.structure.nz


class SaddleFactors(Struct):
    """The struct of radau_saddle.h for one motion, whose degrees of freedom may change.

    The matrix does not depend on the degrees of freedom, and neither does the order of its pivots.

    Parameters
    ----------
    kinematics : Kinematics
        The first degrees of freedom; without kinematic ones, and without internal states.

    Attributes
    ----------
    turns : Turns
    angles : Angles
        Orientations in the present degrees of freedom.
    """

    turns: Turns
    angles: Angles

    def __init__(self, kinematics: Kinematics) -> None:
        super().__init__(ffi.gc(ffi.new("flexel_radau_saddle *"), lib.flexel_radau_saddle_clear))
        s, t, c, roles = kinematics.structure, kinematics.evaluation.tables, self.struct, kinematics.roles
        c.nf, c.nd, c.held = s.nf, roles.nd, roles.holonomic.size
        c.nT, c.nJ = t.T.whole.size, t.J.size
        for name, pattern in (("T", t.T.whole), ("J", t.J)):
            setattr(c, f"{name}_start", self.integers(pattern.start.astype(np.int32)))
            setattr(c, f"{name}_column", self.integers(pattern.column.astype(np.int32)))
        self._K, self._D, self._M = (self.new(name, t.T.whole.size) for name in "KDM")
        self._pattern = t.T.pattern
        self.new("mass", t.M.size + t.J.size)
        self.new("single_values", t.T.whole.size + t.J.size)
        self.new("pair_values", 3 * t.T.whole.size + t.J.size)
        size = s.nf + roles.holonomic.size
        self.new("columns", 4 * s.nf)
        self.new("sides", 2 * size)
        self.new("work", 4 * size)
        self._entries: dict[str, Entries] = {}  # kept alive
        for name, entries in zip(("single", "pair"), _entries(kinematics), strict=True):
            self._set(name, entries)
        self.choose(kinematics)

    def _set(self, name: str, entries: Entries) -> None:
        """The places of the entries of a matrix; what was known of another one is released."""
        matrix = getattr(self.struct, name)
        lib.flexel_matrix_clear(ffi.addressof(matrix))
        matrix.n, matrix.nentries = entries.size, entries.rows.size
        matrix.noise = 1.0  # Newton's method corrects what rounding does
        for field in ("rows", "columns", "source"):
            setattr(matrix, field, ffi.from_buffer("int[]", getattr(entries, field)))
        self._entries[name] = entries

    def choose(self, kinematics: Kinematics) -> None:
        """Continue in other degrees of freedom."""
        self._set("P", kinematics.lists.P)
        self.turns = Turns(Rotations.of(kinematics.structure, kinematics.roles))
        self.angles = Angles(kinematics.structure, kinematics.roles)
        self.struct.turns, self.struct.angles = self.turns.struct, self.angles.struct
        self._dynamic = kinematics.roles.dynamic.astype(np.int32)
        at = self.turns.rotations.at.astype(np.intp)
        rows, columns = np.broadcast_arrays(at[:, :, None], at[:, None, :])
        self._own = np.minimum(self._pattern.find(rows, columns), self._pattern.size - 1)
        self._has = (self._pattern.row[self._own] == rows) & (self._pattern.column[self._own] == columns)
        self.struct.dynamic = ffi.from_buffer("int[]", self._dynamic)

    def look(self, kinematics: Kinematics, now: Snapshot, z: Array) -> None:
        """Take the matrices at a state.

        Raises
        ------
        TangentError
            If a law has no slope there: it counts as zero.
        ConstraintError, InertiaError
            If the state cannot be completed.
        """
        state = dynamics.complete(kinematics, now.t, now.x, now.v, now.e, z)
        work = kinematics.evaluation.work
        lib.flexel_law_tangents(work.struct, 0.0, 0)
        try:
            check_slopes(work)
        finally:
            stresses = work.pointer_of(np.ascontiguousarray(state.stresses))
            code = lib.flexel_radau_look(work.struct, self.struct, stresses)
            kinematics.check(lib.FLEXEL_SINGULAR if code else 0, now.t)

    def acting(self) -> Array:
        """Return what acts on the frames, along their axes, at the state that was looked at: see `Turns.steadier`.

        The frames are taken as if each turned alone.
        """
        E = self.turns.spinning()
        M, D, K = (
            E @ np.where(self._has, values[self._own], 0.0) @ E.transpose(0, 2, 1)
            for values in (self._M, self._D, self._K)
        )
        inertia = np.trace(M, axis1=1, axis2=2)[:, None, None] / 3
        found = np.zeros((2, *K.shape))
        np.divide([D, K], inertia, out=found, where=inertia > 0)
        return found


def _entries(kinematics: Kinematics) -> tuple[Entries, Entries]:
    """Entries of [A C'; C 0], and of the same of complex numbers as real and imaginary parts."""
    t, nf, nT = (
        kinematics.evaluation.tables,
        kinematics.structure.nf,
        kinematics.evaluation.tables.T.whole.size,
    )
    held, J = kinematics.roles.holonomic, t.J
    size, T = nf + held.size, t.T.pattern
    own, row = J.rows_of(held, nf)
    own, row = own[J.filled[own]], row[J.filled[own]]
    rows = np.concatenate([nf + row, J.column[own]])
    columns = np.concatenate([J.column[own], nf + row])
    source = np.concatenate([own, own])
    tangent = np.arange(T.size)
    real = Entries.of(
        size,
        np.concatenate([T.row, rows]),
        np.concatenate([T.column, columns]),
        np.concatenate([tangent, nT + source]),
    )
    blocks = (
        (0, 0, 0),
        (1, 1, 0),
        (1, 0, 1),
        (0, 1, 2),
    )  # row, column, values: real, imaginary, its opposite
    pair = Entries.of(
        2 * size,
        np.concatenate([*(T.row + i * size for i, _, _ in blocks), rows, rows + size]),
        np.concatenate([*(T.column + j * size for _, j, _ in blocks), columns, columns + size]),
        np.concatenate([*(tangent + k * nT for _, _, k in blocks), 3 * nT + source, 3 * nT + source]),
    )
    return real, pair
