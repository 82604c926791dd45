"""A workspace: everything that an evaluation writes, and the structure in C that points to it and to the tables.

A workspace belongs to one thread at a time; the tables are shared.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from flexel.base.arrays import Array
from flexel.engine.fields import Fields
from flexel.engine.lanes import aligned
from flexel.engine.tables import Tables
from flexel.engine.tangents import TangentBatch
from flexel.generated._kernels import ffi, lib

NEARBY = 0.02  # distance of that position in each coordinate
LAW_SUMS = {"law_U": "U", "law_P": "P", "S": "value", "S_rate": "rate"}


class Workspace(Fields):
    """Arrays of one evaluation, by the names of table.h, and their `struct`.

    The vectors x, v, a (n), z (nz), unwrap_from, e (m), w, stress (m + k), F (n) and the values J, M, T are views
    of what C reads and writes.
    """

    def __init__(self, tables: Tables) -> None:
        super().__init__(tables)
        self._vectors()
        self._matrices()
        self._lanes()
        self._stages()
        self._laws()
        self._tangent()
        self._relations()
        self._constant_inertia()
        # This also fills the outputs of contacts that are not evaluated while they are far away.
        found = self._samples()
        if tables.samples is None:  # another thread may be first: it finds the same
            tables.samples = found
        self.samples = tables.samples
        s = tables.structure
        sizes = [s.n, s.n, s.n, s.m, s.m + s.k + s.n, s.m + s.k + s.n, s.nz, s.nz]
        ends = np.cumsum(sizes).tolist()
        self._state = [slice(end - size, end) for end, size in zip(ends, sizes, strict=True)]

    def _samples(self) -> Array:
        """Values (2, size) of M and J for pivot orders: near the drawn position, where nothing vanishes by chance, and
        at that position.
        """
        s = self.tables.structure
        found = []
        for distance in (NEARBY, 0.0):
            self.x[:] = s.x0 + distance * np.random.default_rng(2).standard_normal(s.n)
            self.v[:] = 0.0
            self.position()
            self.inertia()
            found.append(self.values[: self.first["T"]].copy())
        return np.array(found)

    # -- evaluation: see evaluate.h ----------------------------------------------------------------

    def position(self) -> None:
        """Compute deformations e, and J, at x."""
        lib.flexel_position(self.struct)

    def rates(self) -> None:
        """Compute the rates w of deformations and slips at v."""
        lib.flexel_rates(self.struct)

    def convective(self) -> None:
        """Compute the convective parts g of the accelerations of deformations and slips at v."""
        lib.flexel_convective(self.struct)

    def inertia(self) -> None:
        """Compute the mass matrix M, forces F = f - h, and the potential U."""
        lib.flexel_inertia(self.struct)

    def laws(self) -> None:
        """Compute stresses, rates of internal states and energies of the laws."""
        lib.flexel_laws(self.struct)

    def tangent(self, by_x: float, by_v: float, by_a: float, phi: bool) -> None:
        """Compute T, the weighted sum of the derivatives of the balance of forces by x, v and a."""
        lib.flexel_tangent(self.struct, by_x, by_v, by_a, phi)

    def jvp(self, rates: Array) -> Array:
        """Multiply J with a vector (n,), for deformations and slips (m + k,)."""
        out = np.zeros(self.w.size)
        lib.flexel_push(self.struct, self.pointer_of(rates), self.pointer_of(out))
        return out

    def vjp(self, stress: Array) -> Array:
        """Compute the nodal forces J' stress (n,) of stresses (m + k,)."""
        out = np.zeros(self.x.size)
        lib.flexel_pull(self.struct, self.pointer_of(stress), self.pointer_of(out))
        return out

    def momentum(self, rates: Array) -> Array:
        """Multiply the mass matrix with a vector (n,)."""
        out = np.zeros(self.x.size)
        lib.flexel_momentum(self.struct, self.pointer_of(rates), self.pointer_of(out))
        return out

    def state(self) -> tuple[list[Array], list[float]]:
        """A copy of the complete state: x, v, a (n), e (m), rates and accelerations of all quantities (m + k + n), z,
        dz/dt (nz); kinetic, potential and strain energy, and dissipated power.
        """
        out = np.empty(self._state[-1].stop + 4)
        lib.flexel_state(self.struct, self.pointer_of(out))
        return [out[name] for name in self._state], out[-4:].tolist()

    # -- parts -----------------------------------------------------------------------------------

    def _vectors(self) -> None:
        s, t, c = self.tables.structure, self.tables, self.struct
        c.n, c.nf, c.m, c.k, c.nz = s.n, s.nf, s.m, s.k, s.nz
        c.nlaws, c.nS = t.law.count, t.law.codes.size
        self.x, self.v, self.a = (self.new(name, s.n) for name in ("x", "v", "a"))
        self.z, self.zd = (self.new(name, s.nz) for name in ("z", "zd"))
        self.unwrap_from, self.e = (self.new(name, s.m) for name in ("unwrap_from", "e"))
        names = ("w", "g", "law_stress", "stress", "element_stress")
        self.w, self.g, self.law_stress, self.stress, _ = (self.new(name, s.m + s.k) for name in names)
        self.F, self.damping = (self.new(name, s.n) for name in ("F", "damping"))
        self.law_U, self.law_P = (self.new(name, t.law.count) for name in ("law_U", "law_P"))
        c.nperiodic, c.periodic = t.periodic.size, self.ints(t.periodic)
        c.period = self.pointer(s.period[t.periodic])
        c.e_source, c.g_source = self.ints(t.e_source), self.ints(t.g_source)

    def _matrices(self) -> None:
        """Allocate J, M, T and H in one array so that a factorization can take entries of all of them."""
        t, c = self.tables, self.struct
        slips = t.J.start[[t.structure.m, t.structure.m + t.structure.k]]
        sizes = {"M": t.M.size, "J": t.J.size, "T": t.T.whole.size + 1, "H": int(np.diff(slips)[0])}
        ends = np.cumsum([0, *sizes.values()])
        self.values = aligned(int(ends[-1]))
        self.first = dict(zip(sizes, ends.tolist(), strict=False))
        for name, first in self.first.items():
            part = self.values[first : first + sizes[name]]
            setattr(self, name, part)
            setattr(c, name, self.pointer(part))
        self._pattern("J", t.J)
        self._pattern("M", t.M)
        c.M_free = self.ints(t.M.free)
        self.Phi, self.Psi_x, self.Psi_v = (self.new(name, t.J.size) for name in ("Phi", "Psi_x", "Psi_v"))
        self.D = self.new("D", t.M.size)
        self._sums("J_sums", t.J.sums)
        for name, sums in t.derivatives.items():
            self._sums("Phi_sums" if name == "Phi_x" else f"{name}_sums", sums)
        for name, sums in (("M", t.M.sums), ("D", t.M.damping), ("F", t.F), ("U", t.U)):
            self._sums(f"{name}_sums", sums)
        c.damped, c.share8 = t.M.damped, ffi.NULL
        if t.M.damped:
            c.share8 = self.pointer(t.lane_shares())

    M: Array
    J: Array
    T: Array
    H: Array

    # -- laws, tangent, relations, inertia -------------------------------------------------------

    def _laws(self) -> None:
        law, c = self.tables.law, self.struct
        for name in ("stress", "zd", "law_U", "law_P", "S", "S_rate"):
            self._sums(f"{name}_sums", getattr(law, LAW_SUMS.get(name, name)))
        self.S, self.S_rate = (self.new(name, law.codes.size + 1) for name in ("S", "S_rate"))
        lags = ffi.new("flexel_lag[]", max(len(law.lags), 1))
        for field, lag in zip(lags, law.lags, strict=False):
            field.count, field.m, field.k, field.nz = lag.count, lag.m, lag.k, lag.z.shape[1]
            field.at, field.z, field.lasting = self.ints(lag.at), self.ints(lag.z), lag.lasting
            field.direct, field.matrix, field.sides = (
                self.pointer(self.outputs["law_tangent_out"], offsets)
                for offsets in (lag.first, lag.matrix, lag.sides)
            )
        self._keep.append(lags)
        c.nlags, c.lags = len(law.lags), lags

    def _tangent(self) -> None:
        t, c = self.tables.T, self.struct
        c.nT, c.T_start = t.whole.size, self.ints(t.whole.start)
        batches = ffi.new("flexel_batch[]", max(len(t.batches), 1))
        for field, batch in zip(batches, t.batches, strict=False):
            self._tangent_batch(field, batch)
        self._keep.append(batches)
        self.tangents = {b.number: ffi.addressof(batches, place) for place, b in enumerate(t.batches)}
        c.nbatches, c.batches = len(t.batches), batches
        c.nforeign = t.pair.size
        c.foreign_pair, c.foreign_left, c.foreign_right, c.foreign_slot = (
            self.ints(indices) for indices in (t.pair, t.left, t.right, t.slot)
        )
        self.new("local", t.space)

    def _tangent_batch(self, field: Any, batch: TangentBatch) -> None:
        field.nblocks, field.size = batch.nblocks, batch.size
        field.rows, field.columns = batch.rows, batch.columns
        for name, local in batch.local.items():
            entries = getattr(field, name)
            entries.n, entries.nblocks, entries.at = local.at.size, local.nblocks, self.ints(local.at)
            entries.rows = self.pointer(self.outputs[f"{local.kind}_out"], local.first)
        field.diagonal = batch.diagonal
        field.pair = ffi.NULL if batch.pair is None else self.ints(batch.pair)
        field.nused, field.used, field.slot = batch.used.size, self.ints(batch.used), self.ints(batch.slot)
        field.share = ffi.NULL if batch.share is None else self.pointer(batch.share)
        field.active = ffi.NULL
        for name, rows in (("sigma", batch.nsigma), ("tau", batch.rows - batch.nsigma)):
            lanes, starts = self._inputs[f"{name}8"]
            setattr(field, f"n{name}", rows)
            setattr(field, name, self.pointer(lanes, starts[batch.number]))

    def _relations(self) -> None:
        """Set the linear relations; their values as drawn are those at the drawn coordinates."""
        t, c, s = self.tables, self.struct, self.tables.structure
        rows = s.relations.rows
        c.nrelations, c.relations = rows.size, self.ints(rows)
        self.drawn = self.new("drawn", rows.size)
        for name in ("e", "x", "g", "stress"):
            self._terms(f"relation_{name}", getattr(t.relations, name))
        self._terms("relation_J", t.J.relations)
        if rows.size:
            self.x[:] = s.x0
            lib.flexel_position(self.struct)
            self.drawn[:] = self.e[rows]

    def _constant_inertia(self) -> None:
        """Compute, once, the mass matrices and body forces that do not depend on the position."""
        t, c, s = self.tables, self.struct, self.tables.structure
        stage = t.stages["inertia"]
        self._varying = c.inertia.ncalls, c.inertia.calls
        self._steady = [i for i in stage.numbers if i not in t.varying]
        self._calls("inertia", stage, t.elements, self._steady, self.outputs["inertia_out"])
        self._constant = c.inertia.ncalls, c.inertia.calls
        self._none, self.steady_forces = self.pointer(np.zeros(s.n)), np.zeros(s.n)
        self._steady_pointer = self.pointer(self.steady_forces)
        c.constant_inertia = not t.varying
        self.refresh()

    def refresh(self) -> None:
        """Compute the constant inertia from the present parameters."""
        t, c, x0 = self.tables, self.struct, self.tables.structure.x0
        c.inertia.ncalls, c.inertia.calls = self._constant
        c.f0, c.constant_inertia = self._none, 0
        self.outputs["inertia_out"][:] = 0.0  # of elements whose inertia varies, from an earlier position
        self.x[:] = x0
        lib.flexel_position(
            self.struct
        )  # the potential is that of the coordinates that the kernels were given
        lib.flexel_inertia(self.struct)
        self.steady_forces[:] = self.F + self.damping
        U0 = t.steady_potential(self.outputs["inertia_out"], self._steady)
        c.f0, c.U0 = self._steady_pointer, U0 + float(self.steady_forces @ x0)
        c.inertia.ncalls, c.inertia.calls = self._varying
        c.constant_inertia = not t.varying
