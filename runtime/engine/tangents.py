"""The tangent of the balance of forces over the free coordinates: its pattern, and where elements and
laws add to it.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from flexel.base.arrays import Array, Index
from flexel.engine.batches import Batch
from flexel.engine.lanes import LANES, blocks, filled
from flexel.engine.lawtables import LawTables
from flexel.engine.patterns import JacobianPattern, Pattern
from flexel.engine.stages import Stage, flat
from flexel.model.structure import Structure

KINDS = {"De": "position", "V": "position", "Phi": "rates", "K": "stiffness"}
KINDS |= {"R_x": "tangent", "R_v": "tangent", "M": "inertia"}
NAMES = {"Phi": "Phi_x"}


@dataclass(frozen=True)
class Local:
    """Stored entries of a local matrix: their places in it, and where they start in the buffer of a kind of kernel."""

    at: Index
    kind: str
    first: int
    nblocks: int


@dataclass(frozen=True)
class TangentBatch:
    """Tangent of the elements of one type; see `flexel_batch` in table.h."""

    number: int
    size: int
    nblocks: int
    nsigma: int
    rows: int
    columns: int
    local: Mapping[str, Local]
    pair: Index | None
    diagonal: bool
    used: Index
    slot: Index
    share: Array | None


class TangentTables:
    """The tangent T.

    Attributes
    ----------
    whole : Pattern
        Of the rows of all coordinates, and the columns of the free ones.
    pattern : Pattern
        Of the free rows, whose entries come first.
    batches : list of TangentBatch
    pair, left, right, slot : ndarray of int
        Pairs across elements: entries of J that are multiplied, and where their products belong.
    """

    def __init__(
        self,
        structure: Structure,
        batches: Sequence[Batch],
        stages: Mapping[str, Stage],
        J: JacobianPattern,
        laws: LawTables,
    ) -> None:
        nf = structure.nf
        found = [_local(b, i, stages) for i, b in enumerate(batches)]
        pairs = [laws.own(lines) if lines.shape[1] else None for lines in J.lines]
        used = [_used(b, local, p is not None) for b, local, p in zip(batches, found, pairs, strict=True)]
        self.pair, self.left, self.right = laws.foreign(J)
        columns = J.column[self.left], J.column[self.right]
        rows_of, columns_of = [columns[0]], [columns[1]]
        for b, at in zip(batches, used, strict=True):
            x = b.places["x"]
            rows_of.append(x[:, at // x.shape[1]])
            columns_of.append(x[:, at % x.shape[1]])
        row, column = flat(rows_of), flat(columns_of)
        inside, free = column < nf, (row < nf) & (column < nf)
        self.whole = Pattern(row[inside], column[inside], (structure.n, nf))
        self.pattern = Pattern(row[free], column[free], (nf, nf))
        slots = np.where(inside, self.whole.find(row, column), self.whole.size)
        ends = np.cumsum([rows.size for rows in rows_of])[:-1]
        self.slot, *own = np.split(slots, ends)
        self.batches = [
            self._batch(i, b, local, pair, at, slot.reshape(b.size, at.size))
            for i, (b, local, pair, at, slot) in enumerate(zip(batches, found, pairs, used, own, strict=True))
            if at.size
        ]

    def _batch(
        self,
        i: int,
        b: Batch,
        local: Mapping[str, Local],
        pair: tuple[Index, bool] | None,
        used: Index,
        slot: Index,
    ) -> TangentBatch:
        share = (
            blocks(np.where(np.arange(b.size) < b.n_with_inertia, b.weight, 0.0)[:, None])
            if b.weight.any()
            else None
        )
        m, k, n = (b.places[name].shape[1] for name in ("sigma", "tau", "x"))
        lanes = filled(slot, self.whole.size)
        own, diagonal = (None, False) if pair is None else pair
        return TangentBatch(i, b.size, b.nblocks, m, m + k, n, local, own, diagonal, used, lanes, share)

    @property
    def space(self) -> int:
        """Numbers needed for the local matrices of one block."""
        return max(
            (batch.columns * (batch.columns + 3 * batch.rows) * LANES for batch in self.batches), default=1
        )


def _local(b: Batch, i: int, stages: Mapping[str, Stage]) -> dict[str, Local]:
    """Return the stored entries of all local matrices of a batch; V lies in the rows below De."""
    found = {}
    below = b.places["sigma"].shape[1] * b.places["x"].shape[1]
    for name, kind in KINDS.items():
        own = NAMES.get(name, name)
        at = stages[kind].nonzeros(i, own)
        first = stages[kind].starts[i][own] if at.size else 0
        found[name] = Local(at + below * (name == "V"), kind, first, stages[kind].nblocks(i))
    return found


def _used(b: Batch, local: Mapping[str, Local], laws: bool) -> Index:
    """Return the flat indices of the local matrix that can differ from zero."""
    n = b.places["x"].shape[1]
    used = np.unique(flat(local[name].at for name in ("K", "R_x", "R_v", "M")))
    if not laws:
        return used
    columns = np.unique(flat(local[name].at % n for name in ("De", "V", "Phi")))
    return np.union1d(used, (columns[:, None] * n + columns).ravel())
