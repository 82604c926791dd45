"""Places of the kernels' outputs in their buffers, and lists that scatter them to the arrays of the model."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np

from flexel.base.arrays import Array, Index
from flexel.engine.batches import Batch
from flexel.engine.lanes import LANES, lanes


@dataclass(frozen=True)
class Sums:
    """Sums of weighted entries of a buffer: entry i over the sources start[i] to start[i + 1].

    Without `start` each entry has one source; without `weight` all weights are one.
    """

    size: int
    start: Index | None
    source: Index
    weight: Array | None = None

    def filled(self, zero: int) -> Index:
        """Return the entries with at least one source other than the zero."""
        count = np.ones(self.size, dtype=np.intp) if self.start is None else np.diff(self.start)
        own = np.repeat(np.arange(self.size), count)
        return np.unique(own[self.source != zero])


def sums(targets: Index, sources: Index, size: int, zero: int, weights: Array | None = None) -> Sums:
    """Combine sources with equal targets in sums; `zero` is the index of a zero in the buffer."""
    if weights is None and np.unique(targets).size == targets.size:
        source = np.full(size, zero)
        source[targets] = sources
        return Sums(size, None, source)
    order = np.argsort(targets, kind="stable")
    start = np.searchsorted(targets[order], np.arange(size + 1))
    return Sums(size, start, sources[order], None if weights is None else weights[order])


class Stage:
    """One kind of kernel of all types that have it, and the layout of its buffer of outputs.

    Attributes
    ----------
    numbers : list of int
        The batches that have this kernel.
    width : int
        Numbers in the buffer, which then ends with a zero and a one.
    """

    def __init__(self, kind: str, batches: Sequence[Batch], counts: Sequence[int] | None = None) -> None:
        sizes = [b.size for b in batches] if counts is None else counts
        self.kind = kind
        self.numbers = [i for i, b in enumerate(batches) if sizes[i] and kind in b.spec.kernels]
        self.size = dict(enumerate(sizes))
        self.starts: dict[int, dict[str, int]] = {}
        self._outputs = {
            i: {out.name: out for out in batches[i].spec.kernels[kind].outputs} for i in self.numbers
        }
        place = 0
        for i in self.numbers:
            self.starts[i] = {}
            for name, out in self._outputs[i].items():
                self.starts[i][name] = place
                place += len(out.nonzeros) * self.nblocks(i) * LANES
        self.width = place

    def nblocks(self, i: int) -> int:
        """Return the number of blocks of a batch."""
        return -(-self.size[i] // LANES)

    @property
    def zero(self) -> int:
        """Place of a zero in the buffer."""
        return self.width

    @property
    def one(self) -> int:
        """Place of a one in the buffer."""
        return self.width + 1

    def nonzeros(self, i: int, name: str) -> Index:
        """Return flat indices of the stored entries in the local array; none if the batch lacks this kernel."""
        stored = self._outputs[i][name].nonzeros if i in self._outputs else ()
        return np.array(stored, dtype=np.intp)

    def rows(self, i: int, name: str) -> int:
        """Return the number of rows of the full local array of an output."""
        return int(self._outputs[i][name].shape[0])

    def places(self, i: int, name: str) -> Index:
        """Return the indices (elements, stored entries) of an output of a batch in the buffer."""
        if i not in self._outputs:
            return np.zeros((self.size[i], 0), dtype=np.intp)
        return lanes(self.size[i], len(self._outputs[i][name].nonzeros), self.starts[i][name])

    def summed(self, parts: Sequence[tuple[Index, Index]], size: int) -> Sums:
        """Combine outputs in sums, given as pairs of targets and buffer indices of the same shape."""
        return sums(
            flat(targets for targets, _ in parts),
            flat(places for _, places in parts),
            size,
            self.zero,
        )


def flat(parts: Iterable[Index]) -> Index:
    """Join all entries, one array after another."""
    found = [np.ravel(part) for part in parts]
    return np.concatenate(found).astype(np.intp) if found else np.zeros(0, dtype=np.intp)
