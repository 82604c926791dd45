"""Selects the rope contacts near a surface, so that the cost of a step is proportional to their number.

Only contacts within reach of their surface are evaluated in the iterations of a step; the gaps of the others are
checked once after each step, so that none is missed.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from flexel.base.arrays import Array
from flexel.engine.assembly import Batch
from flexel.engine.evaluate import Evaluation
from flexel.engine.local import Local

REACH = 1.0  # gap of a near contact, in lengths of its cable
ALARM = 0.25  # gap of a far contact that requires a new selection
FEW = 100  # number of contacts below which selection does not pay

Mask = NDArray[np.bool_]


class NearContacts:
    """The contacts of a model, and which of them are near.

    Attributes
    ----------
    worthwhile : bool
        Whether there are enough contacts for a selection.  Laws with internal states evolve in open contacts too, so
        all of them are then kept.
    """

    def __init__(self, evaluation: Evaluation) -> None:
        self._evaluation = evaluation
        self._contacts = [b for b in evaluation.elements if _is_contact(b)]
        self.worthwhile = sum(b.size for b in self._contacts) > FEW and not evaluation.structure.nz
        self._far: list[Mask] = [np.zeros(b.size, dtype=bool) for b in self._contacts]
        self._whole = Local(evaluation.structure, self._contacts if self.worthwhile else [], [])

    def gaps(self, x: Array) -> list[Array]:
        """Smallest gap of every contact, in lengths of its cable, by batch."""
        e = self._whole.position(x)[0]
        return [e[b.inputs["sigma"]].min(axis=1) / b.parameter("l0")[:, 0] for b in self._contacts]

    def choose(self, x: Array) -> Local:
        """The evaluation of everything but the contacts that are far from their surfaces at coordinates x (n,)."""
        self._far = [gap > REACH for gap in self.gaps(x)]
        far = np.zeros(self._evaluation.structure.m, dtype=bool)
        for batch, mask in zip(self._contacts, self._far, strict=True):
            far[batch.inputs["sigma"][mask]] = True
        masks = dict(zip((id(b) for b in self._contacts), self._far, strict=True))
        elements = [_without(b, masks[id(b)]) if id(b) in masks else b for b in self._evaluation.elements]
        laws = [_without(b, _all(far, b)) for b in self._evaluation.laws]
        return Local(self._evaluation.structure, [b for b in elements if b.size], laws)

    def smallest(self, x: Array) -> float:
        """Smallest gap of the omitted contacts, in lengths of their cables; infinite if none are omitted."""
        return min(
            (float(g[far].min(initial=np.inf)) for g, far in zip(self.gaps(x), self._far, strict=True)),
            default=np.inf,
        )


def _is_contact(batch: Batch) -> bool:
    """Whether elements are contacts: their deformations are gaps, they have a cable's length, and no mass."""
    spec = batch.spec
    kinds = [d.kind for d in getattr(spec, "deformations", ())]
    lengths = any(p.name == "l0" for p in spec.parameters)
    return bool(kinds) and all(z == "gap" for z in kinds) and lengths and "inertia" not in spec.kernels


def _all(far: Mask, law: Batch) -> Mask:
    """Laws that act on far contacts."""
    e = law.inputs["e"]
    return np.asarray(far[e].all(axis=1)) if e.shape[1] else np.zeros(law.size, dtype=bool)


def _without(batch: Batch, out: Mask) -> Batch:
    """A batch without some of its members, which keep their numbers."""
    if not out.any():
        return batch
    kept = np.flatnonzero(~out)
    return replace(
        batch,
        inputs={name: rows[kept] for name, rows in batch.inputs.items()},
        p=batch.p[kept],
        weight=None if batch.weight is None else batch.weight[kept],
        members=kept,
        whole=batch.size,
    )
