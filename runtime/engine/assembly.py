"""Runs the compiled kernels of all elements of a model and scatters their outputs.

All elements of one type form a batch; the inputs of all batches are gathered with one `take` into one
buffer, the batches run in one C call, and their outputs are scattered with one indexed assignment
(each entry has one owner) or summed place by place.  It orchestrates and computes nothing.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from flexel.base.arrays import Array, Index
from flexel.base.errors import FlexelError
from flexel.derive.spec import ElementSpec, LawSpec
from flexel.engine.lanes import LANES, blocks, lanes
from flexel.generated._kernels import ffi, lib


@dataclass(frozen=True)
class Batch:
    """All elements (or laws) of one type.

    Attributes
    ----------
    spec : ElementSpec or LawSpec
    struct : cffi struct
        Function pointers of the kernels.
    inputs : dict of str to ndarray of int (elements, rows)
        For each kernel input, the places of its rows in the global vector.
    p : ndarray (elements, np)
        Parameters.
    weight : ndarray (elements,), optional
        Mass-proportional damping of the elements [1/s].
    members : ndarray of int (elements,), optional
        For a part of a batch: the numbers of its elements in the whole one, which has `whole` elements.
    """

    spec: ElementSpec | LawSpec
    struct: Any
    inputs: dict[str, Index]
    p: Array
    weight: Array | None = None
    members: Index | None = None
    whole: int = 0

    @property
    def numbers(self) -> Index:
        """Numbers (elements,) of the elements in the whole batch."""
        return np.arange(self.size) if self.members is None else self.members

    @property
    def size(self) -> int:
        """Number of elements."""
        return int(self.p.shape[0])

    def parameter(self, name: str) -> Array:
        """Values (elements, size) of a parameter."""
        first = 0
        for parameter in self.spec.parameters:
            if parameter.name == name:
                return self.p[:, first : first + parameter.size]
            first += parameter.size
        raise KeyError(name)


@dataclass(frozen=True)
class Place:
    """Destination of one output of a batch: flat places (elements, local size) in a global array of `shape`."""

    array: str
    shape: tuple[int, ...]
    places: Index
    summed: bool


Placement = Callable[[Batch, str], Place]


def kernel_struct(spec: ElementSpec | LawSpec, address: object) -> Any:
    """The C table of function pointers of a built-in (by name) or user-defined (by address) type."""
    law = isinstance(spec, LawSpec)
    if address is None:
        struct = getattr(lib, f"flexel_law_{spec.name}" if law else f"flexel_{spec.name}")
    else:
        struct = ffi.cast("flexel_law *" if law else "flexel_element *", address)[0]
    if ffi.string(struct.digest).decode() != spec.digest:
        raise FlexelError(
            f"the compiled kernels of '{spec.name}' belong to another derivation than generated/table.py; compile them "
            "again: pip install -e . (or make test)"
        )
    return struct


class Stage:
    """One kernel kind, run over all batches that have it.

    Parameters
    ----------
    batches : sequence of Batch
    kind : str
        Name of the kernel, e.g. "position".
    placement : Placement
        Destination of each output.
    """

    def __init__(self, batches: Sequence[Batch], kind: str, placement: Placement) -> None:
        active = [b for b in batches if b.size and kind in b.spec.kernels]
        names = active[0].spec.kernels[kind].inputs if active else ()
        self._names = tuple(name for name in names if name != "p")
        self._gather = {
            name: np.concatenate([blocks(b.inputs[name]).ravel() for b in active]).astype(np.intp)
            for name in self._names
        }
        self._filled = tuple(name for name in self._names if self._gather[name].size)
        self._inputs = {name: np.zeros(max(index.size, 1)) for name, index in self._gather.items()}
        self._parameters = [blocks(b.p).ravel() for b in active]
        self._starts, width = _output_starts(active, kind)
        self._output = np.zeros(width + 1)  # the last entry stays zero, see `flat`
        self._count = len(active)
        self._shares = _input_shares(active) if kind == "tangent" and "a" in self._names else None
        self._calls = self._call_table(active, kind)
        self._targets = self._scatter_table(active, kind, placement)
        self._flat: dict[str, Index] = {}
        self._stack_sums()

    def _call_table(self, active: list[Batch], kind: str) -> Any:
        """The array of `flexel_call` with all pointers, created once."""
        start = dict.fromkeys(self._names, 0)
        self._keep: list[Any] = []
        rows: list[dict[str, Any]] = []
        for i, batch in enumerate(active):
            spec, count = batch.spec.kernels[kind], -(-batch.size // LANES)
            ins: list[Any] = []
            for name in spec.inputs:
                if name == "p":
                    ins.append(_pointer(self._parameters[i], 0))
                    continue
                ins.append(_pointer(self._inputs[name], start[name]))
                start[name] += batch.inputs[name].shape[1] * count * LANES
            outs = [_pointer(self._output, place) for place in self._starts[i].values()]
            arrays = ffi.new("double *[]", ins), ffi.new("double *[]", outs)
            self._keep.append(arrays)
            rows.append(
                {
                    "kernel": getattr(batch.struct, kind),
                    "nblocks": count,
                    "in": ffi.cast("const double *const *", arrays[0]),
                    "out": arrays[1],
                }
            )
        return ffi.new("flexel_call[]", rows)

    def _scatter_table(self, active: list[Batch], kind: str, placement: Placement) -> dict[str, Any]:
        pieces: dict[str, tuple[Place, list[Index], list[Index]]] = {}
        for batch, starts in zip(active, self._starts, strict=True):
            for out in batch.spec.kernels[kind].outputs:
                place = placement(batch, out.name)
                nonzeros = np.array(out.nonzeros, dtype=np.intp)
                _, sources, targets = pieces.setdefault(place.array, (place, [], []))
                sources.append(lanes(batch.size, nonzeros.size, starts[out.name]))
                targets.append(place.places[:, nonzeros].ravel())
        table: dict[str, Any] = {}
        for name, (place, s, t) in pieces.items():
            source, target = np.concatenate(s), np.concatenate(t)
            if place.summed:
                table[name] = _Sum(source, target, int(np.prod(place.shape)))
                shares = [_share(b, rows.size // b.size) for b, rows in zip(active, s, strict=False)]
                if name == "M" and any(z.any() for z in shares):
                    table["damped M"] = _Sum(source, target, table[name].size, np.concatenate(shares))
            else:
                table[name] = (source, target)
        return table

    def _stack_sums(self) -> None:
        """The entries of all summed outputs in one list, and where the places of each output begin in it."""
        tables = {name: z for name, z in self._targets.items() if isinstance(z, _Sum)}
        places = [np.unique(z.target, return_inverse=True) for z in tables.values()]
        ends = np.cumsum([0, *(unique.size for unique, _ in places)])
        self._parts = {
            name: (z.size, unique, slice(a, a + unique.size))
            for (name, z), (unique, _), a in zip(tables.items(), places, ends, strict=False)
        }
        self._sources = np.concatenate([np.zeros(0, dtype=np.intp), *(z.source for z in tables.values())])
        self._bins = np.concatenate(
            [
                np.zeros(0, dtype=np.intp),
                *(inverse + a for (_, inverse), a in zip(places, ends, strict=False)),
            ]
        )
        weights = [np.ones(z.source.size) if z.weight is None else z.weight for z in tables.values()]
        self._weights = np.concatenate(weights) if "damped M" in tables else None
        self._sizes = int(ends[-1])
        self._totals: Array | None = None

    def run(self, **vectors: Array) -> None:
        """Gather the inputs and run the kernels of all batches; read the results with `add` and `put`."""
        for name in self._filled:
            vectors[name].take(self._gather[name], out=self._inputs[name], mode="clip")
        if self._shares is not None:
            self._inputs["a"] += self._shares * self._inputs["v"]
        if self._count:
            lib.flexel_run(self._count, self._calls)
        self._totals = None

    def put(self, name: str, out: Array) -> Array:
        """Write the entries of the output `name` into `out` (each has one owner) and return it."""
        table = self._targets.get(name)
        if table is not None:
            out.ravel()[table[1]] = self._output.take(table[0])
        return out

    def places(self, name: str) -> Index:
        """Flat places in the global array that the output `name` fills, at least one entry each."""
        table = self._targets.get(name)
        if table is None:
            return np.zeros(0, dtype=np.intp)
        return self._parts[name][1] if isinstance(table, _Sum) else table[1]

    def flat(self, name: str, size: int) -> Array:
        """The output `name` (each entry has one owner) as a new flat array (size,), zeros filled in."""
        source = self._flat.get(name)
        if source is None:
            source = np.full(size, self._output.size - 1)
            if name in self._targets:
                places, targets = self._targets[name]
                source[targets] = places
            self._flat[name] = source
        found: Array = self._output.take(source, mode="clip")
        return found

    def sum(self, name: str, shape: tuple[int, ...]) -> Array:
        """The output `name`, contributions of all elements summed."""
        if name not in self._parts:
            return np.zeros(shape)
        if self._totals is None:
            entries = self._output.take(self._sources)
            if self._weights is not None:
                entries *= self._weights
            self._totals = summed(self._bins, entries, self._sizes)
        size, places, part = self._parts[name]
        if places.size == size:
            return self._totals[part].reshape(shape)
        total = np.zeros(size)
        total[places] = self._totals[part]
        return total.reshape(shape)


@dataclass(frozen=True)
class _Sum:
    """Entries of the output buffer, and the places in an array of `size` at which they are summed with weights."""

    source: Index
    target: Index
    size: int
    weight: Array | None = None


def summed(places: Index, values: Array, size: int) -> Array:
    """Array (size,) of the sums of the values at each place."""
    return np.asarray(np.bincount(places, values, minlength=size), dtype=np.float64)


def _pointer(array: Array, offset: int) -> Any:
    return ffi.cast("double *", array.ctypes.data) + offset


def _share(batch: Batch, rows: int) -> Array:
    """The elements' mass-proportional damping, once for each of `rows` entries of an element."""
    return np.repeat(np.zeros(batch.size) if batch.weight is None else batch.weight, rows)


def _input_shares(active: list[Batch]) -> Array | None:
    """Damping of each entry of the gathered accelerations of the tangent, which then is that of M (a + share v)."""
    if not any(b.weight is not None and b.weight.any() for b in active):
        return None
    columns = [(_share(b, 1)[:, None], b.inputs["a"].shape[1]) for b in active]
    return np.concatenate([blocks(np.repeat(share, rows, axis=1)).ravel() for share, rows in columns])


def _output_starts(active: list[Batch], kind: str) -> tuple[list[dict[str, int]], int]:
    """Start of each output of each batch in the common output buffer, and the buffer's length."""
    starts: list[dict[str, int]] = []
    place = 0
    for batch in active:
        found: dict[str, int] = {}
        for out in batch.spec.kernels[kind].outputs:
            found[out.name] = place
            place += len(out.nonzeros) * -(-batch.size // LANES) * LANES
        starts.append(found)
    return starts, place
