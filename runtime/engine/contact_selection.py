"""Selects the rope contacts close to a surface, so that the cost of a step is proportional to their number.

Only contacts within reach of their surface are evaluated in the iterations of a step, in blocks; the gaps of the others
are checked once after each step, so that none is missed.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from flexel.base.arrays import Array, Index
from flexel.engine.batches import Batch
from flexel.engine.lanes import LANES, blocks
from flexel.engine.tables import EVERY, Tables
from flexel.engine.workspace import Workspace
from flexel.generated._kernels import ffi, lib

SELECTED_GAP = 1.0  # largest gap of a selected contact, in lengths of its cable
ALARM = 0.25  # gap of a far contact that requires a new selection
FEW = 100  # number of contacts below which selection does not pay


class ContactSelection:
    """The contacts of a workspace, and which of their blocks are selected.

    Attributes
    ----------
    worthwhile : bool
        Whether there are enough contacts for a selection.  Laws with internal states evolve in open contacts too, so
        all of them are then kept.
    """

    def __init__(self, work: Workspace) -> None:
        tables = work.tables
        contacts = {i: b for i, b in enumerate(tables.elements) if _is_contact(b)}
        self.worthwhile = sum(b.size for b in contacts.values()) > FEW and not tables.structure.nz
        self._work, self._contacts = work, contacts if self.worthwhile else {}
        self._flags = {i: np.ones(b.nblocks, dtype=np.uint8) for i, b in self._contacts.items()}
        self._law_flags = {i: np.ones(b.nblocks, dtype=np.uint8) for i, b in enumerate(tables.laws)}
        self._left_out = np.zeros(tables.structure.m + tables.structure.k, dtype=np.uint8)
        self._lengths = {i: blocks(b.parameter("l0")).ravel() for i, b in self._contacts.items()}
        if self.worthwhile:
            self._attach()
        self._types = ffi.new("flexel_contacts[]", max(len(self._contacts), 1))
        stage = tables.stages["position"]
        for c, (i, b) in zip(self._types, self._contacts.items(), strict=False):
            c.position, c.selected = (
                work.calls["position"][i],
                ffi.from_buffer("unsigned char[]", self._flags[i]),
            )
            c.count, c.ngaps = b.size, b.places["sigma"].shape[1]
            c.gaps = ffi.cast("double *", work.outputs["position_out"].ctypes.data) + stage.starts[i]["e"]
            c.length = ffi.from_buffer("double[]", self._lengths[i])

    def choose(self, x: Array) -> None:
        """Leave out the contacts that are far from their surfaces at coordinates x (n,)."""
        work = self._work
        for flags in (*self._flags.values(), *self._law_flags.values()):
            flags[:] = 1
        self._left_out[:] = 0
        work.x[:] = x
        work.position()
        m, far = work.tables.structure.m, self._left_out
        for i, b in self._contacts.items():
            gap = work.e[b.places["sigma"]].min(axis=1) / b.parameter("l0")[:, 0]
            self._flags[i][:] = np.logical_or.reduceat(gap <= SELECTED_GAP, np.arange(0, b.size, LANES))
            out = np.repeat(self._flags[i] == 0, LANES)[: b.size]
            far[b.places["sigma"][out]] = far[m + b.places["tau"][out]] = 1
        for i, b in enumerate(work.tables.laws):
            e = b.places["e"]
            if e.shape[1]:
                selected = (far[e] == 0).any(axis=1)
                self._law_flags[i][:] = np.logical_or.reduceat(selected, np.arange(0, b.size, LANES))
        self._silence()

    def _attach(self) -> None:
        """Pass the flags of the blocks to evaluate to the kernels' calls."""
        for kinds, flags in ((EVERY, self._flags), (("law", "law_tangent"), self._law_flags)):
            for kind in kinds:
                for i, call in self._work.calls[kind].items():
                    if i in flags:
                        call.active = ffi.from_buffer("unsigned char[]", flags[i])
        self._work.struct.left_out = ffi.from_buffer("unsigned char[]", self._left_out)
        for i, tangent in self._work.tangents.items():
            if i in self._flags:
                tangent.active = ffi.from_buffer("unsigned char[]", self._flags[i])

    def _silence(self) -> None:
        """Set the outputs of the laws that are left out to zero."""
        law = self._work.tables.law
        for name, stage in (("law_out", law.law), ("law_tangent_out", law.tangent)):
            for i in stage.numbers:
                for output, first in stage.starts[i].items():
                    count, size = stage.nblocks(i), stage.nonzeros(i, output).size * LANES
                    lanes = self._work.outputs[name][first : first + count * size].reshape(count, size)
                    lanes[self._law_flags[i] == 0] = 0.0

    @property
    def used(self) -> NDArray[np.bool_]:
        """Entries of the tangent over the free coordinates that can differ from zero, far contacts left out."""
        T = self._work.tables.T
        used = np.zeros(T.whole.size + 1, dtype=bool)
        used[T.slot] = True
        for b in T.batches:
            used[b.slot[self._flags[b.number] == 1] if b.number in self._flags else b.slot] = True
        return used[: T.pattern.size]

    def smallest(self) -> float:
        """Return the smallest gap left out, in lengths of cables, at the last evaluation; infinite if there is none."""
        return float(lib.flexel_far_gap(self._work.struct, len(self._contacts), self._types))


def _is_contact(batch: Batch) -> bool:
    """Whether elements are contacts: their deformations are gaps, they have a cable's length, and no mass."""
    spec = batch.spec
    kinds = [d.kind for d in getattr(spec, "deformations", ())]
    lengths = any(p.name == "l0" for p in spec.parameters)
    return bool(kinds) and all(kind == "gap" for kind in kinds) and lengths and "inertia" not in spec.kernels


def rope_gaps(tables: Tables) -> Index:
    """Return the indices in e of the gaps of the contacts along ropes."""
    places = [b.places["sigma"].ravel() for b in tables.elements if _is_contact(b)]
    return np.concatenate(places) if places else np.zeros(0, dtype=np.intp)


def every_gap(tables: Tables) -> Index:
    """Return the indices in e of all gaps on which a law acts; others are measured only, or held."""
    if "gap" not in tables.structure.kinds:
        return np.zeros(0, dtype=np.intp)
    acting = np.zeros(tables.structure.m, dtype=bool)
    for batch in tables.laws:
        acting[batch.places["e"].ravel()] = True
    return np.flatnonzero((np.array(tables.structure.kinds) == "gap") & acting)


def free_gaps(tables: Tables) -> Index:
    """Return the indices in e of the gaps that are not along ropes: of these, their neighbours hold each."""
    every = every_gap(tables)
    return np.setdiff1d(every, rope_gaps(tables)) if every.size else every
