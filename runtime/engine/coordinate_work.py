"""A choice of degrees of freedom for the engine: its constant lists, and its arrays in one workspace."""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np

from flexel.base.arrays import Array, Index
from flexel.engine.lanes import aligned
from flexel.engine.structs import Struct
from flexel.engine.tables import Tables
from flexel.engine.workspace import Workspace
from flexel.generated._kernels import ffi, lib
from flexel.model.role_lists import Roles
from flexel.model.snapshot import Snapshot

MOST_COLUMNS = 16  # dynamic degrees of freedom from which accelerations come from the matrix [M C'; C 0]
TOLERANCE = 1e-15  # error of a deformation, relative to its natural scale: as exact as rounding allows


@dataclass(frozen=True, eq=False)
class Entries:
    """Entries of a square matrix: rows, columns, and where their values lie behind the mass matrix of a workspace."""

    size: int
    rows: Any
    columns: Any
    source: Any

    @classmethod
    def of(cls, size: int, *lists: Index) -> Entries:
        """Return the same with integers as the engine takes them."""
        return cls(size, *(np.ascontiguousarray(indices, dtype=np.int32) for indices in lists))


class CoordinateLists:
    """The lists of a choice of degrees of freedom, shared by all workspaces.

    Parameters
    ----------
    tables : Tables
    roles : Roles
    scales : ndarray (m + k + n,)
        Natural scales of all quantities.
    loaded : ndarray of int
        Quantities on which loads act.
    """

    def __init__(self, tables: Tables, roles: Roles, scales: Array, loaded: Index) -> None:
        s = tables.structure
        self.tables, self.roles = tables, roles
        self.rows, self.slips, self.loaded = (
            np.array(indices, dtype=np.int32) for indices in (roles.position_rows, roles.zero, loaded)
        )
        self.weight = 1.0 / scales[roles.position_rows]
        self.step_weight = 1.0 / scales[s.m + s.k :][: s.nf]
        self.forced = roles.forces.astype(np.int32)
        self.saddle = roles.nd > MOST_COLUMNS or roles.actuated
        self.P = self._position_matrix()
        self.A = self._saddle_matrix() if self.saddle else Entries.of(0, *(np.zeros(0, dtype=np.intp),) * 3)

    def _rows_of_J(self, quantities: Index) -> tuple[Index, Index, Index]:  # noqa: N802
        """Return row numbers, free coordinates and sources of the entries of rows of J, which follow those of M."""
        J = self.tables.J
        own, row = J.rows_of(quantities, self.tables.structure.nf)
        filled = J.filled[own]
        own, row = own[filled], row[filled]
        return row, J.column[own], self.tables.M.size + own

    def _position_matrix(self) -> Entries:
        return Entries.of(self.tables.structure.nf, *self._rows_of_J(self.roles.position_rows))

    def _saddle_matrix(self) -> Entries:
        M, nf = self.tables.M, self.tables.structure.nf
        held = np.concatenate([self.roles.holonomic, self.roles.zero])
        own = np.flatnonzero((M.row < nf) & (M.column < nf))
        row, column, source = self._rows_of_J(held)
        force, pulled, pulling = self._rows_of_J(np.concatenate([self.roles.forces, self.roles.zero]))
        rows = np.concatenate([M.row[own], nf + row, pulled])
        columns = np.concatenate([M.column[own], column, nf + force])
        return Entries.of(nf + held.size, rows, columns, np.concatenate([own, source, pulling]))


class CoordinateWork(Struct):
    """Arrays of a choice of degrees of freedom in a workspace, by the names of explicit.h, and their `struct`.

    It keeps the arrays of the lists, but not the lists: a workspace keeps it as long as these are in use.
    """

    def __init__(self, work: Workspace, lists: CoordinateLists) -> None:
        super().__init__(ffi.gc(ffi.new("flexel_choice *"), lib.flexel_choice_clear))
        self.work = work
        c, roles = self.struct, lists.roles
        self.P = ffi.addressof(c, "P")  # the position matrix with its factors
        c.nr, c.np, c.nd, c.nk = roles.rigid.size, roles.prescribed.size, roles.nd, roles.nq - roles.nd
        c.saddle, c.tolerance, c.accept = lists.saddle, TOLERANCE, 0.0
        c.rows, c.slips, c.loaded, c.forced = (
            self.integers(indices) for indices in (lists.rows, lists.slips, lists.loaded, lists.forced)
        )
        c.nloads = lists.loaded.size
        c.weight, c.step_weight = (self.pointer(weights) for weights in (lists.weight, lists.step_weight))
        for field, entries in ((c.P, lists.P), (c.A, lists.A)):
            field.n, field.nentries = entries.size, entries.rows.size
            field.rows, field.columns, field.source = (
                self.integers(indices) for indices in (entries.rows, entries.columns, entries.source)
            )
            size = work.samples.shape[1]
            lib.flexel_matrix_prepare(ffi.addressof(field), 2, work.pointer_of(work.samples), size)
        self._vectors(lists)

    def _vectors(self, lists: CoordinateLists) -> None:
        s = lists.tables.structure
        self._free = s.nf
        nd, nk, nu = lists.roles.nd, self.struct.nk, lists.roles.prescribed.size
        count = _whole((0 if lists.saddle else nd) + nk + 1)
        self.struct.columns = count
        stride = 0 if lists.saddle else _whole(nd + 1)
        self.motion, self.loads = self.new("motion", 3 * nu), self.new("loads", lists.loaded.size)
        self.q, self.qd, self.qdd = self.new("q", nd + nk), self.new("qd", nd), self.new("qdd", nd)
        _, self.residual, _ = (self.new(name, s.nf) for name in ("target", "residual", "target_last"))
        self.new("step", max(s.nf, lists.A.size))
        self.force = self.new("force", s.n)
        self.multiplier = self.new("multiplier", s.m + s.k + s.n)
        self.struct.stride = stride
        self.G = self.new("G", max(s.nf * count, lists.A.size))
        self.new("X", max(s.nf * stride, s.n))
        self.new("inverse", nk * nk)
        reduced = 0 if lists.saddle else (nd + 2) * (stride + nd)
        self.new("small", max((nk + 1) * (count + nk), reduced))
        self.new("work", max(s.nf * count, lists.A.size))
        self.x_last = self.new("x_last", s.n)
        self.e_last, self.ed_last = self.new("e_last", s.m), self.new("ed_last", s.m)
        self.y, self.dy = (aligned(2 * nd + nk + s.nz) for _ in "12")
        self._y, self._dy = self.pointer(self.y), self.pointer(self.dy)
        self.is_warm = False
        self._pair = self.work.struct, self.struct
        self._rhs = partial(lib.flexel_rhs, *self._pair)

    @property
    def H(self) -> Array:  # noqa: N802
        """First-order transfer function dv/dq_d' (nf, nd) of the last velocities; not with many degrees of freedom."""
        nd = self.struct.nd
        return self.G.reshape(-1, self.struct.columns)[:, :nd].copy()

    def reset(self, noise: float = 0.0) -> None:
        """Discard intermediate results, so that what follows depends on nothing computed before.

        These are pivot orders, and rates of fixed coordinates that a user's state may have had.

        Parameters
        ----------
        noise : float
            Relative error that rounding may cause in what follows: pivots that enlarge it further are sought again.
        """
        self.struct.P.noise = self.struct.A.noise = noise
        lib.flexel_reset(*self._pair)

    # -- calls: see explicit.h; each returns zero or the code of what failed ------------------------

    def locate(self) -> int:
        """Find the position with the degrees of freedom q, from x and unwrap_from of the workspace."""
        self.struct.predict = 0
        return int(lib.flexel_locate(*self._pair))

    def factorize(self) -> int:
        """Factorize the position matrix at the position in the workspace."""
        self.struct.predict = 0
        return int(lib.flexel_factorize(*self._pair))

    def velocity(self) -> int:
        """Compute the velocities v of the workspace for the rates qd; the position must have been located."""
        return int(lib.flexel_velocity(*self._pair))

    def directions(self) -> int:
        """Factorize the position matrix at the position in the workspace; compute the columns for the velocities."""
        return self.factorize() or int(lib.flexel_directions(*self._pair))

    @property
    def determinant(self) -> float:
        """Logarithm of the size of the determinant of the position matrix, to base two; after `factorize`."""
        return float(lib.flexel_matrix_logarithm(self.P))

    def amplification(self) -> float:
        """Return the change of coordinates per unit of degrees of freedom, in natural scales; after `directions`."""
        return float(lib.flexel_amplification(*self._pair))

    def sensitivity(self) -> float:
        """Return the same per unit of the rigid and prescribed quantities; after `factorize`."""
        return float(lib.flexel_sensitivity(*self._pair))

    def unit_rates(self, rows: Index) -> Array:
        """Return rates (r, nd) of quantities for unit rates of few dynamic degrees of freedom, after `velocity`."""
        found, own = np.empty((rows.size, int(self.struct.nd))), rows.astype(np.int32)
        if found.size:
            lib.flexel_unit_rates(
                *self._pair, rows.size, ffi.from_buffer("int[]", own), ffi.from_buffer("double[]", found)
            )
        return found

    def complete(self, driven: bool) -> int:
        """Compute forces, accelerations and multipliers at x, v, z and unwrap_from of the workspace."""
        return int(lib.flexel_complete(*self._pair, driven))

    def reactions(self) -> tuple[Array, Array]:
        """Return stresses (m + k,) and reactions (n,) after `complete`."""
        s = self.work.tables.structure
        both = np.empty(s.m + s.k), np.empty(s.n)
        lib.flexel_reactions(*self._pair, *(self.work.pointer_of(values) for values in both))
        return both

    def forces(self) -> None:
        """Compute the given forces at x, v, z and unwrap_from of the workspace."""
        self.work.position()
        lib.flexel_forces(*self._pair)

    def rhs(self, t: float) -> int:
        """Compute the rates dy of y = (q, q_d', z); find the position from the last one."""
        code: int = self._rhs(t, self._y, self._dy)
        return code

    def evaluate(self, t: float, y: Array, guess: Array, unwrap_from: Array) -> int:
        """Compute the same; find the position from coordinates and deformations nearby."""
        self.y[:], self.work.x[:], self.work.unwrap_from[:] = y, guess, unwrap_from
        self.struct.predict = 0
        return int(lib.flexel_evaluate(*self._pair, t, self._y, self._dy))

    def warm(self, start: Snapshot) -> None:
        """Start the next right-hand side from a position."""
        self.struct.t_last, self.struct.predict, self.is_warm = start.t, 0, True
        self.x_last[:], self.e_last[:], self.ed_last[:] = start.x, start.e, start.ed

    @property
    def last(self) -> Snapshot | None:
        """Where the next right-hand side starts the search for its position; None before the first."""
        if not self.is_warm:
            return None
        c = self.struct
        return Snapshot(
            c.t_last, self.x_last.copy(), np.zeros_like(self.x_last), self.e_last.copy(), self.ed_last.copy()
        )


def _whole(columns: int) -> int:
    """Round the number of columns up to whole registers where there are several."""
    return columns if columns < 3 else -(-columns // 4) * 4
