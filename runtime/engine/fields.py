"""The fields of a workspace's structure in C: arrays and lists, and the calls of all kernels."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from flexel.base.arrays import Array, Index
from flexel.engine.batches import Batch
from flexel.engine.lanes import LANES
from flexel.engine.patterns import Pattern, Terms
from flexel.engine.stages import Stage, Sums
from flexel.engine.structs import Struct
from flexel.engine.tables import Tables
from flexel.generated._kernels import ffi

LANES_OF = {
    "coordinates": ("x8", "v8", "a8"),
    "sigma": ("sigma8",),
    "tau": ("tau8",),
    "law_e": ("law_e8", "law_ed8"),
    "law_s": ("law_s8",),
    "law_z": ("law_z8",),
}  # the arrays of lanes that a list fills
ELEMENT_INPUTS = {
    "x": ("x8", "x"),
    "v": ("v8", "x"),
    "a": ("a8", "x"),
    "sigma": ("sigma8", "sigma"),
    "tau": ("tau8", "tau"),
}  # inputs of kernels: array of lanes, and the rows of a batch that it holds
LAW_INPUTS = {
    "e": ("law_e8", "e"),
    "ed": ("law_ed8", "e"),
    "s": ("law_s8", "s"),
    "z": ("law_z8", "z"),
    "t": ("law_t", ""),
}


class Fields(Struct):
    """A new structure in C with its arrays, filled field by field by the names of table.h.

    Attributes
    ----------
    tables : Tables
    struct : cffi struct
    outputs : dict of str to ndarray
        Buffers of the outputs of the kernels, by the name of their field.
    """

    def __init__(self, tables: Tables) -> None:
        super().__init__(ffi.new("flexel_work *"))
        self.tables = tables
        self.outputs: dict[str, Array] = {}

    def ints(self, array: Index) -> Any:
        """Return a pointer to integers, shared by all workspaces."""
        found = self.tables.ints(array)
        return ffi.cast("int *", found.ctypes.data)

    def _sums(self, name: str, sums: Sums) -> None:
        field = getattr(self.struct, name)
        field.n = sums.size
        field.start = ffi.NULL if sums.start is None else self.ints(sums.start)
        field.source = self.ints(sums.source)
        field.weight = ffi.NULL if sums.weight is None else self.pointer(sums.weight)

    def _terms(self, name: str, terms: Terms) -> None:
        field = getattr(self.struct, name)
        field.n = terms.target.size
        field.target, field.source = self.ints(terms.target), self.ints(terms.source)
        field.factor = self.pointer(terms.factor)

    def _pattern(self, name: str, pattern: Pattern) -> None:
        setattr(self.struct, f"{name}_start", self.ints(pattern.start))
        setattr(self.struct, f"{name}_column", self.ints(pattern.column))

    @staticmethod
    def pointer_of(array: Array) -> Any:
        """Return a pointer to the numbers of an array for the duration of a call."""
        return ffi.from_buffer("double[]", array)

    # -- kernels ---------------------------------------------------------------------------------

    def _lanes(self) -> None:
        """Allocate the inputs of the kernels; lanes without an element keep what they are given here."""
        t = self.tables
        self._inputs: dict[str, tuple[Array, list[int]]] = {}
        for name, vectors in LANES_OF.items():
            gather, field = t.gathers[name], getattr(self.struct, name)
            field.n, field.index, field.place = (
                gather.index.size,
                self.ints(gather.index),
                self.ints(gather.place),
            )
            for vector in vectors:
                self._inputs[vector] = self.new(vector, gather.size), gather.starts
        self.struct.n8 = t.gathers["coordinates"].size
        self._inputs["x8"][0][:] = t.gathers["coordinates"].filled(t.structure.x0)
        self.struct.nt = LANES * max((b.nblocks for b in t.laws), default=0)
        self._inputs["law_t"] = self.new("law_t", self.struct.nt), [0] * len(t.laws)

    def _stages(self) -> None:
        t = self.tables
        self.calls: dict[str, dict[int, Any]] = {}  # by kind of kernel and number of the batch
        for kind, stage in t.stages.items():
            out = self._output(f"{kind}_out", stage.width)
            numbers = [i for i in stage.numbers if kind != "inertia" or i in t.varying]
            self._calls(kind, stage, t.elements, numbers, out)
        out = self._output("law_out", t.law.law.width)
        self._calls("law", t.law.law, t.laws, t.law.law.numbers, out)
        out = self._output("law_tangent_out", t.law.width)
        self._calls("law_tangent", t.law.tangent, t.laws, t.law.tangent.numbers, out)

    def _output(self, name: str, width: int) -> Array:
        """Allocate a buffer of outputs, which ends with a zero and a one."""
        out = self.outputs[name] = self.new(name, width + 2)
        out[width + 1] = 1.0
        return out

    def _calls(
        self, name: str, stage: Stage, batches: Sequence[Batch], numbers: list[int], out: Array
    ) -> None:
        calls = ffi.new("flexel_call[]", max(len(numbers), 1))
        for position, i in enumerate(numbers):
            self._call(calls[position], stage, batches[i], i, out)
        self._keep.append(calls)
        self.calls[name] = {i: ffi.addressof(calls, place) for place, i in enumerate(numbers)}
        field = getattr(self.struct, name)
        field.ncalls, field.calls = len(numbers), calls

    def _call(self, call: Any, stage: Stage, batch: Batch, i: int, out: Array) -> None:
        """Set one kernel of one batch with its arguments."""
        spec = batch.spec.kernels[stage.kind]
        names = LAW_INPUTS if "law" in batch.spec.kernels else ELEMENT_INPUTS
        ins, steps = [], []
        for letter in spec.inputs:
            if letter == "p":
                ins.append(self.pointer(self.tables.parameters["law" in batch.spec.kernels][i]))
                steps.append(batch.p.shape[1] * LANES)
                continue
            vector, rows = names[letter]
            lanes, starts = self._inputs[vector]
            ins.append(self.pointer(lanes, starts[i]))
            steps.append((batch.places[rows].shape[1] if rows else 1) * LANES)
        outs = [self.pointer(out, first) for first in stage.starts[i].values()]
        steps += [len(output.nonzeros) * LANES for output in spec.outputs]
        arrays = ffi.new("double *[]", ins), ffi.new("double *[]", outs), ffi.new("size_t[]", steps)
        self._keep.append(arrays)
        call.kernel = getattr(batch.struct, stage.kind)
        call.nblocks, call.nin, call.nout = stage.nblocks(i), len(ins), len(outs)
        setattr(call, "in", ffi.cast("const double *const *", arrays[0]))
        call.out, call.step, call.active = arrays[1], arrays[2], ffi.NULL
        if "x" in batch.places:
            call.alone = "position" not in batch.spec.kernels
            call.width = batch.places["x"].shape[1]
            call.first = sum(indices.size for indices in self.tables.gathers["coordinates"].rows[:i])
            call.last = call.first + min(batch.size, stage.nblocks(i) * LANES) * call.width
