"""Linear relations among deformations and coordinates: gears, screws, racks, belts and differentials.

A relation is one more deformation, r = Σ cᵢ (eᵢ − eᵢ as drawn), with a role, a stress and laws of its own.  Its row
of J is the same combination of rows, and its stress σ acts on each term as the stress cᵢ σ.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

import numpy as np
from scipy.sparse import csr_array

from flexel.base.arrays import Index
from flexel.model.instances import Instance


@dataclass(frozen=True)
class Relations:
    """All relations of a model.

    Attributes
    ----------
    rows : ndarray of int (nr,)
        Quantities that are relations.
    C : csr_array (nr, m + k + n)
        Coefficients of all quantities; relations among relations are resolved.
    """

    rows: Index
    C: csr_array

    def __bool__(self) -> bool:
        return bool(self.rows.size)


def find_relations(instances: Iterable[Instance], index: Mapping[str, int], size: int) -> Relations:
    """Find the relations among the instances; each term has been checked where it was declared."""
    own = [instance for instance in instances if instance.terms is not None]
    rows = np.array([index[instance.deformations[0]] for instance in own], dtype=np.intp)
    C = np.zeros((rows.size, size))
    for i, instance in enumerate(own):
        for name, c in (instance.terms or {}).items():
            j = index[name]
            earlier = np.flatnonzero(rows[:i] == j)
            C[i] += c * C[earlier[0]] if earlier.size else c * (np.arange(size) == j)
    return Relations(rows, csr_array(C))
