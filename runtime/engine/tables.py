"""The tables of a model: constant lists of what the engine in C calls, and of where numbers come from and go.

They are built once for a structure and shared by all its workspaces (`flexel.engine.workspace`).
"""

from __future__ import annotations

from copy import copy
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from flexel.base.arrays import Array, Index
from flexel.engine.batches import element_batches, law_batches
from flexel.engine.lanes import LANES, blocks, lanes
from flexel.engine.lawtables import LawTables
from flexel.engine.patterns import JacobianPattern, MassPattern, relation_terms
from flexel.engine.stages import Stage, flat, sums
from flexel.engine.tangents import TangentTables
from flexel.model.structure import Structure


@dataclass(frozen=True)
class Gather:
    """Inputs of all batches, gathered from a global vector.

    Attributes
    ----------
    rows : list of ndarray of int (elements, rows)
        Places in the vector, by batch.
    index, place : ndarray of int
        Places in the vector and in the lanes, of the lanes that have an element.
    starts : list of int
        Where the lanes of each batch start.
    size : int
    """

    rows: list[Index]
    index: Index
    place: Index
    starts: list[int]
    size: int

    @classmethod
    def of(cls, rows: list[Index]) -> Gather:
        """Build the list for the rows of each batch."""
        sizes = [-(-indices.shape[0] // LANES) * indices.shape[1] * LANES for indices in rows]
        starts = np.cumsum([0, *sizes]).tolist()
        places = [
            lanes(indices.shape[0], indices.shape[1], first)
            for indices, first in zip(rows, starts, strict=False)
        ]
        return cls(rows, flat(rows), flat(places), starts, starts[-1])

    def filled(self, vector: Array) -> Array:
        """Fill all lanes; those without an element repeat the values of the last one."""
        return np.concatenate(
            [np.zeros(0), *(blocks(vector[indices]).ravel() for indices in self.rows if indices.size)]
        )


EVERY = ("position", "acceleration", "rates", "kinematics", "stiffness")


class Tables:
    """All tables of a structure.

    Attributes
    ----------
    elements, laws : list of Batch
    stages : dict of str to Stage
        By kind of kernel; "inertia" holds the outputs of all elements with mass, "tangent" of those whose mass matrix
        varies.
    J, M : Pattern
    T : TangentTables
    e_source, g_source : ndarray of int
        Places of the deformations (m,), and of the convective parts (m + k,), in the buffers.
    periodic : ndarray of int
        Deformations with a period.
    drawn : ndarray (nr,)
        Values of the relations as drawn, for which they count as zero.
    parameters : tuple of list of ndarray (blocks, parameters, 8)
        Parameters of the elements and of the laws, by batch.
    samples : ndarray (2, size), optional
        What the first workspace found for pivot orders; shared, so that all workspaces begin with the same orders.
    """

    def __init__(self, structure: Structure) -> None:
        self.structure = structure
        self.elements = element_batches(structure)
        self.laws = law_batches(structure)
        n_with_inertia = [b.n_with_inertia for b in self.elements]
        self.stages = {kind: Stage(kind, self.elements) for kind in EVERY}
        self.stages["inertia"] = Stage("inertia", self.elements, n_with_inertia)
        varying = [b.n_with_inertia if b.n_with_inertia and b.varies else 0 for b in self.elements]
        self.stages["tangent"] = Stage("tangent", self.elements, varying)
        self.varying = [i for i, count in enumerate(varying) if count]
        self.J = JacobianPattern(structure, self.elements, self.stages["position"])
        self.M = MassPattern(structure, self.elements, self.stages["inertia"])
        self.law = LawTables(structure, self.laws)
        self.T = TangentTables(structure, self.elements, self.stages, self.J, self.law)
        self.relations = relation_terms(structure)
        self.drawn = np.zeros(structure.relations.rows.size)
        self._sources()
        self._sums()
        self.derivatives = {
            name: self.J.derivatives(self.stages[kind], name)
            for name, kind in (("Phi_x", "rates"), ("Psi_x", "kinematics"), ("Psi_v", "kinematics"))
        }
        self.gathers = self._gathers()
        self.periodic = np.flatnonzero(structure.period[: structure.m])
        self.parameters = [blocks(b.p) for b in self.elements], [blocks(b.p) for b in self.laws]
        self._shared: dict[int, tuple[Index, NDArray[np.int32]]] = {}
        self.samples: Array | None = None

    def variant(self) -> Tables:
        """Copy the tables with separate parameters, see `flexel.engine.variants`."""
        found = copy(self)
        found.parameters = tuple([values.copy() for values in part] for part in self.parameters)
        return found

    parameters: tuple[list[Array], ...]

    def _gathers(self) -> dict[str, Gather]:
        m = self.structure.m
        found = {
            "coordinates": [b.places["x"] for b in self.elements],
            "sigma": [b.places["sigma"] for b in self.elements],
            "tau": [b.places["tau"] + m for b in self.elements],
        }
        found |= {f"law_{name}": [b.places[name] for b in self.laws] for name in ("e", "s", "z")}
        return {name: Gather.of(rows) for name, rows in found.items()}

    def _sources(self) -> None:
        m, k = self.structure.m, self.structure.k
        position, acceleration = self.stages["position"], self.stages["acceleration"]
        self.e_source, self.g_source = np.full(m, position.zero), np.full(m + k, acceleration.zero)
        for i in position.numbers:
            sigma = self.elements[i].places["sigma"]
            self.e_source[sigma[:, position.nonzeros(i, "e")]] = position.places(i, "e")
        for i in acceleration.numbers:
            sigma, tau = (self.elements[i].places[name] for name in ("sigma", "tau"))
            self.g_source[sigma[:, acceleration.nonzeros(i, "g")]] = acceleration.places(i, "g")
            self.g_source[m + tau[:, acceleration.nonzeros(i, "gs")]] = acceleration.places(i, "gs")

    def _sums(self) -> None:
        """Sum the forces f - h of all elements, and potential and body forces for varying and constant inertia."""
        n, inertia = self.structure.n, self.stages["inertia"]
        targets, sources, weights = [], [], []
        energy: list[tuple[Index, Index]] = []
        for i in inertia.numbers:
            x = self.elements[i].places["x"][: inertia.size[i]]
            for name, sign in (("f", 1.0), ("h", -1.0)):
                targets.append(x[:, inertia.nonzeros(i, name)])
                sources.append(inertia.places(i, name))
                weights.append(np.full(sources[-1].shape, sign))
            if i in self.varying:
                places = inertia.places(i, "U")
                energy.append((np.zeros_like(places), places))
        weight = np.concatenate([np.zeros(0), *(np.ravel(values) for values in weights)])
        self.F = sums(flat(targets), flat(sources), n, inertia.zero, weight)
        self.U = inertia.summed(energy, 1)

    def lane_shares(self) -> Array:
        """Return mass-proportional damping of the lanes of coordinates; zero for elements without mass."""
        parts = [np.zeros(0)]
        for b in self.elements:
            share = np.where(np.arange(b.size) < b.n_with_inertia, b.weight, 0.0)
            parts.append(blocks(np.repeat(share[:, None], b.places["x"].shape[1], axis=1)).ravel())
        return np.concatenate(parts)

    def steady_potential(self, out: Array, steady: list[int]) -> float:
        """Return the potential of the body forces of some batches, from the outputs of their inertia."""
        return float(sum(out[self.stages["inertia"].places(i, "U")].sum() for i in steady))

    def ints(self, array: Index) -> NDArray[np.int32]:
        """Convert numbers to 32-bit integers, once, for all workspaces."""
        found = self._shared.get(id(array))
        if found is None:  # another thread may be first: all must point to the same numbers
            made = array, np.ascontiguousarray(array, dtype=np.int32)
            found = self._shared.setdefault(id(array), made)
        return found[1]
