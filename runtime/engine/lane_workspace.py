"""The workspace of eight variants in C: every array holds eight copies of each value, one per variant; see lanes.h.

The lists are those of one variant, with other places: a block of a kernel holds the same element of eight variants.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from flexel.base.arrays import Array, Index
from flexel.engine.batches import Batch
from flexel.engine.fields import ELEMENT_INPUTS, LANES_OF, LAW_INPUTS, Fields
from flexel.engine.lanes import LANES, aligned
from flexel.engine.stages import Stage, Sums
from flexel.engine.workspace import Workspace
from flexel.generated._kernels import ffi

STAGES = ("position", "acceleration", "inertia")
GATHERS = ("coordinates", "law_e", "law_s", "law_z")


class Outputs:
    """Where the outputs of a stage lie with one element in each block.

    Attributes
    ----------
    starts : dict of int to list of int
        Where the outputs of each batch start.
    places : ndarray of int
        For each place in the buffer of one variant; the zero and the one come last.
    size : int
    """

    def __init__(self, stage: Stage) -> None:
        self.places = np.zeros(stage.width + 2, dtype=np.intp)
        self.starts: dict[int, list[int]] = {}
        end = 0
        for i in stage.numbers:
            self.starts[i] = []
            for name in stage.starts[i]:
                old = stage.places(i, name)
                self.starts[i].append(end)
                self.places[old] = end + np.arange(old.size).reshape(old.shape)
                end += old.size
        self.places[[stage.zero, stage.one]] = end, end + 1
        self.size = end + 2


class LaneWorkspace(Fields):
    """The workspace of eight variants.

    Parameters
    ----------
    work : Workspace
        That of a variant, which gives what is the same for all of them.
    """

    def __init__(self, work: Workspace) -> None:
        super().__init__(work.tables)
        t, s, c = work.tables, work.tables.structure, self.struct
        c.n, c.nf, c.m, c.k, c.nz, c.nlaws = s.n, s.nf, s.m, s.k, s.nz, t.law.count
        self.x, self.v, _, _ = (self.wide(name, s.n) for name in ("x", "v", "a", "F"))
        _, self.e = (self.wide(name, s.m) for name in ("unwrap_from", "e"))
        self.w, *_ = (self.wide(name, s.m + s.k) for name in ("w", "g", "law_stress", "stress"))
        for name in ("z", "zd"):
            self.wide(name, s.nz)
        self.wide("damping", s.n)
        for name in ("law_U", "law_P"):
            self.wide(name, t.law.count)
        self._f0, self.U0 = self.wide("f0", s.n), aligned(LANES)
        self._matrices()
        self._gathers()
        self._parameters = [
            [_spread(values, b) for values, b in zip(*part, strict=True)] for part in self._owners(work)
        ]
        self._kernels()
        c.nrelations, c.relations = s.relations.rows.size, self.ints(s.relations.rows)
        c.drawn = self.pointer(work.drawn)
        for name in ("e", "x", "g"):
            self._terms(f"relation_{name}", getattr(t.relations, name))
        self._terms("relation_J", t.J.relations)
        c.constant_inertia, c.damped = not t.varying, t.M.damped

    def wide(self, name: str, size: int) -> Array:
        """Allocate an array of zeros (size, 8) for a field."""
        return self.new(name, max(size, 1) * LANES).reshape(-1, LANES)[:size]

    def load(self, lane: int, work: Workspace) -> None:
        """Take the parameters of a variant, and what its workspace has computed from them."""
        for wide, own in zip(self._parameters, self._owners(work), strict=True):
            for target, values, batch in zip(wide, *own, strict=True):
                target[:, :, lane] = _rows(values, batch)
        self._M[:, lane], self._D[:, lane] = work.M, work.D
        self._f0[:, lane], self.U0[lane] = work.steady_forces, work.struct.U0
        inertia = self._outputs["inertia"]
        self._inertia[inertia.places, lane] = work.outputs["inertia_out"]

    @staticmethod
    def _owners(work: Workspace) -> list[tuple[list[Array], list[Batch]]]:
        """Return the parameters by batch, and the batches, of elements and of laws."""
        t = work.tables
        return [(t.parameters[0], t.elements), (t.parameters[1], t.laws)]

    def _matrices(self) -> None:
        """Allocate M and J in one array, since a factorization takes entries of both."""
        t, c = self.tables, self.struct
        values = aligned((t.M.size + t.J.size) * LANES)
        c.M, c.J = self.pointer(values), self.pointer(values, t.M.size * LANES)
        self._M, self._D = values.reshape(-1, LANES)[: t.M.size], self.wide("D", t.M.size)
        self._pattern("J", t.J)
        self._pattern("M", t.M)
        c.M_free = self.ints(t.M.free)
        c.nperiodic, c.periodic = t.periodic.size, self.ints(t.periodic)
        c.period = self.pointer(t.structure.period[t.periodic])

    def _gathers(self) -> None:
        self._vectors: dict[str, tuple[Array, list[int]]] = {}
        for name in GATHERS:
            gather, field = self.tables.gathers[name], getattr(self.struct, name)
            field.n, field.index = gather.index.size, self.ints(gather.index)
            field.place = self._own(np.arange(gather.index.size))
            starts = np.cumsum([0, *(rows.size for rows in gather.rows)]).tolist()
            for vector in LANES_OF[name]:
                self._vectors[vector] = self.wide(vector, gather.index.size), starts
        self.struct.nt = max((b.size for b in self.tables.laws), default=0)
        self._vectors["law_t"] = self.wide("law_t", self.struct.nt), [0] * len(self.tables.laws)

    def _kernels(self) -> None:
        """Set the calls of the kernels, and the lists by which their outputs are summed."""
        t, c = self.tables, self.struct
        self._outputs = {kind: Outputs(t.stages[kind]) for kind in STAGES} | {"law": Outputs(t.law.law)}
        for kind in STAGES:
            numbers = [i for i in t.stages[kind].numbers if kind != "inertia" or i in t.varying]
            self._stage(kind, t.stages[kind], t.elements, numbers)
        self._stage("law", t.law.law, t.laws, t.law.law.numbers)
        c.e_source = self._own(self._outputs["position"].places[t.e_source])
        c.g_source = self._own(self._outputs["acceleration"].places[t.g_source])
        sums = {"J": ("position", t.J.sums), "M": ("inertia", t.M.sums), "D": ("inertia", t.M.damping)}
        sums |= {"F": ("inertia", t.F), "stress": ("law", t.law.stress), "zd": ("law", t.law.zd)}
        sums |= {"U": ("inertia", t.U), "law_U": ("law", t.law.U), "law_P": ("law", t.law.P)}
        for name, (kind, one) in sums.items():
            self._moved(f"{name}_sums", one, self._outputs[kind].places)

    def _own(self, places: Index) -> Any:
        return self.integers(np.ascontiguousarray(places, dtype=np.int32))

    def _moved(self, name: str, one: Sums, places: Index) -> None:
        self._sums(name, one)
        getattr(self.struct, name).source = self._own(places[one.source])

    def _stage(self, kind: str, stage: Stage, batches: Sequence[Batch], numbers: Sequence[int]) -> None:
        layout = self._outputs[kind]
        out = self.wide(f"{kind}_out", layout.size)
        out[-1] = 1.0
        if kind == "inertia":
            self._inertia = out
        calls = ffi.new("flexel_call[]", max(len(numbers), 1))
        for call, i in zip(calls, numbers, strict=False):
            spec, starts = batches[i].spec.kernels[kind], layout.starts[i]
            ins = [self._input(letter, kind == "law", i) for letter in spec.inputs]
            outs = [self.pointer(out, first * LANES) for first in starts]
            arrays = ffi.new("double *[]", ins), ffi.new("double *[]", outs)
            self._keep.append(arrays)
            call.kernel, call.nblocks = getattr(batches[i].struct, kind), stage.size[i]
            call.nin, call.nout = len(ins), len(outs)
            setattr(call, "in", ffi.cast("const double *const *", arrays[0]))
            call.out, call.active = arrays[1], ffi.NULL
        self._keep.append(calls)
        field = getattr(self.struct, kind)
        field.ncalls, field.calls = len(numbers), calls

    def _input(self, letter: str, law: bool, i: int) -> Any:
        if letter == "p":
            return self.pointer(self._parameters[law][i])
        names: Mapping[str, tuple[str, str]] = LAW_INPUTS if law else ELEMENT_INPUTS
        array, starts = self._vectors[names[letter][0]]
        return self.pointer(array, starts[i] * LANES)


def _rows(values: Array, batch: Batch) -> Array:
    """Take the parameters (elements, np) of a batch out of their lanes."""
    return values.transpose(0, 2, 1).reshape(values.shape[0] * LANES, values.shape[1])[: batch.size]


def _spread(values: Array, batch: Batch) -> Array:
    """Return parameters (elements, np, 8), the same in all lanes."""
    return np.ascontiguousarray(np.repeat(_rows(values, batch)[:, :, None], LANES, axis=2))
