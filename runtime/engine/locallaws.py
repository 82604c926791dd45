"""Laws of a structure with their tangents as a list of pairs of quantities.

A pair (i, j) says that the stress of quantity i depends on quantity j.  Pairs within one element are
multiplied element by element, as a scaling where every stress depends on its own quantity only; a pair
across elements gives the outer product of two rows of J.  Internal states z of laws that follow from an
implicit step, z = known + c dz/dt, are eliminated law by law.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from flexel.base.arrays import Array, Index
from flexel.engine.assembly import Batch, Place, Stage, summed
from flexel.engine.groups import Group
from flexel.engine.law_shapes import columns_of, coupled, rows_of
from flexel.structure.structure import Structure

MAX_ITERATIONS = 12  # for the internal states at given deformations


@dataclass(frozen=True)
class LawForces:
    """Outputs of the laws.

    Attributes
    ----------
    stress : ndarray (m + k,)
    z, zd : ndarray (nz,)
        Internal states and their rates.
    stored, dissipated : ndarray (laws,)
        Energy [J] and dissipated power [W] of each law, in the order of the batches.
    """

    stress: Array
    z: Array
    zd: Array
    stored: Array
    dissipated: Array


@dataclass(frozen=True)
class ImplicitStep:
    """Internal states at the end of an implicit step, z = known + share dz/dt."""

    known: Array
    share: float


class LocalLaws:
    """The laws of a structure.

    Attributes
    ----------
    left, right : ndarray of int
        Entries of the flat J whose products pairs across elements add to the stiffness.
    """

    def __init__(
        self,
        structure: Structure,
        laws: Sequence[Batch],
        groups: Sequence[Group],
        relations: Mapping[int, tuple[int, int]],
    ) -> None:
        self.structure, self._groups, self._batches = structure, groups, laws
        self._relations = relations  # start and width of their rows in the flat J, by quantity
        self._width = max(structure.m + structure.k, 1)
        self._lines = {
            id(b): np.concatenate([b.inputs["e"], b.inputs["s"] + structure.m], axis=1) for b in laws
        }
        starts = np.cumsum([0, *(b.whole or b.size for b in laws)])
        self.count = int(starts[-1])
        self._first = {id(b): int(z) for b, z in zip(laws, starts[:-1], strict=True)}
        codes = [self._pair_codes(b)[:, coupled(b)].ravel() for b in laws]
        self._codes = np.unique(np.concatenate(codes)) if codes else np.zeros(0, dtype=np.intp)
        self._size = self._codes.size  # values by pair have one more entry, zero, for missing pairs
        self._lagging = [b for b in laws if b.inputs["z"].shape[1]]
        widths = [b.size * rows_of(b) * columns_of(b) for b in self._lagging]
        self._Z_starts = dict(zip((id(b) for b in self._lagging), np.cumsum([0, *widths]), strict=False))
        self._Z_size = sum(widths)
        self._index = [self._own(g) for g in groups]
        self._foreign()
        self._law = Stage(laws, "law", self._place)
        self._tangent = Stage(laws, "tangent", self._place)

    @property
    def lines(self) -> Index:
        """Quantities that laws act on."""
        return np.unique(self._codes // self._width)

    def instances(self) -> list[tuple[Index, Index]]:
        """For each batch of laws, the numbers of the laws and the quantity that each of them first acts on."""
        return [(self._first[id(b)] + b.numbers, self._lines[id(b)][:, 0]) for b in self._batches]

    def _place(self, batch: Batch, name: str) -> Place:
        """Destination of an output of a law."""
        lines, z = self._lines[id(batch)], batch.inputs["z"]
        m, width = batch.inputs["e"].shape[1], self.structure.m + self.structure.k
        if name in ("sigma", "tau"):
            return Place("stress", (width,), lines[:, :m] if name == "sigma" else lines[:, m:], True)
        if name == "zd":
            return Place("zd", (self.structure.nz,), z, False)
        if name in ("U", "P"):
            one = self._first[id(batch)] + batch.numbers[:, None]
            return Place(name, (self.count,), one, False)
        if z.shape[1]:
            size = rows_of(batch) * columns_of(batch)
            places = self._Z_starts[id(batch)] + np.arange(batch.size * size).reshape(batch.size, size)
            return Place("Z", (self._Z_size,), places, False)
        return Place("L", (2, self._size + 1), self._pair_places(batch), True)

    def _pair_places(self, batch: Batch) -> Index:
        """Places of (stresses) x (e, its rate and s) in the values by pair: by e first, by the rates then."""
        m = batch.inputs["e"].shape[1]
        pair = np.searchsorted(self._codes, self._pair_codes(batch))  # meaningless where there is no pair
        places = np.concatenate([pair[:, :, :m], self._size + 1 + pair], axis=2)
        return places.reshape(batch.size, -1)

    def _pair_codes(self, batch: Batch) -> Index:
        lines = self._lines[id(batch)]
        codes: Index = lines[:, :, None] * self._width + lines[:, None, :]
        return codes

    def _find(self, codes: Index) -> Index:
        """Pair of each code, `_size` where there is none."""
        if not self._size:
            return np.zeros(codes.shape, dtype=np.intp)
        at = np.minimum(np.searchsorted(self._codes, codes), self._size - 1)
        return np.where(self._codes[at] == codes, at, self._size)

    def _own(self, group: Group) -> Index | None:
        """Pairs of a group: (elements, rows) where all are diagonal, else (elements, rows, rows); None without laws."""
        z = group.lines
        pairs = self._find(z[:, :, None] * self._width + z[:, None, :])
        if np.all(pairs == self._size):
            return None
        diagonal = np.eye(z.shape[1], dtype=bool)
        return pairs[:, diagonal] if np.all(pairs[:, ~diagonal] == self._size) else pairs

    def _foreign(self) -> None:
        """Entries of the pairs across elements: the pair, and the two entries of J that are multiplied."""
        element, first, count = (np.zeros(self._width, dtype=np.intp) for _ in range(3))
        number = 0
        for g in self._groups:
            E, rows, columns = g.shape
            element[g.lines] = number + np.arange(E)[:, None]
            first[g.lines] = g.first_J + columns * np.arange(E * rows).reshape(E, rows)
            count[g.lines] = columns
            number += E
        for i, (start, width) in self._relations.items():
            number += 1
            element[i], first[i], count[i] = number, start, width
        related = np.isin(np.arange(self._width), list(self._relations))
        left, right = self._codes // self._width, self._codes % self._width
        found: list[tuple[Index, Index, Index]] = [(np.zeros(0, dtype=np.intp),) * 3]
        for p in np.flatnonzero((element[left] != element[right]) | related[left]):
            i, j = left[p], right[p]
            a = np.repeat(first[i] + np.arange(count[i]), count[j])
            b = np.tile(first[j] + np.arange(count[j]), count[i])
            found.append((np.full(a.size, p), a, b))
        self._pair, self.left, self.right = (np.concatenate(z) for z in zip(*found, strict=True))

    # -- evaluation ------------------------------------------------------------------------------

    def forces(self, e: Array, w: Array, z: Array, t: float) -> LawForces:
        """Stresses and energies for deformations e (turns included), rates w, internal states z and time."""
        m, nz = self.structure.m, self.structure.nz
        if not self.count:
            none = np.zeros(0)
            return LawForces(np.zeros(w.size), none, none, none, none)
        self._law.run(e=e, ed=w[:m], s=w[m:], z=z, t=np.array([t]))
        U, P = self._law.flat("U", self.count), self._law.flat("P", self.count)
        zd = self._law.flat("zd", nz) if nz else z
        return LawForces(self._law.sum("stress", (w.size,)), z, zd, U, P)

    def step(self, e: Array, w: Array, z: Array, t: float, step: ImplicitStep) -> LawForces:
        """The same at the internal states of an implicit step, by Newton's method from a guess z."""
        found = self.forces(e, w, z, t)
        for _ in range(MAX_ITERATIONS):
            off = found.z - step.known - step.share * found.zd
            size = float(np.abs(found.z).max(initial=0.0) + np.abs(step.share * found.zd).max(initial=0.0))
            if float(np.abs(off).max(initial=0.0)) <= 1e-13 * size:
                break
            self._run_tangent(e, w, found.z, t)
            z = found.z.copy()
            for b, Z in self._lag_matrices():
                at, rows = b.inputs["z"], self._lines[id(b)].shape[1]
                A = np.eye(at.shape[1]) - step.share * Z[:, rows:, -at.shape[1] :]
                z[at] -= np.linalg.solve(A, off[at][:, :, None])[:, :, 0]
            found = self.forces(e, w, z, t)
        return found

    def tangents(self, e: Array, w: Array, z: Array, t: float, share: float) -> tuple[Array, Array]:
        """Derivatives of the stresses by pair: by deformations, and by their rates and slips.

        Internal states follow as in an implicit step with that share; they are held if it is zero.
        """
        if not self.count:
            return np.zeros(1), np.zeros(1)
        self._run_tangent(e, w, z, t)
        L = self._tangent.sum("L", (2, self._size + 1))
        for b, Z in self._lag_matrices():
            nz, rows = b.inputs["z"].shape[1], self._lines[id(b)].shape[1]
            direct = Z[:, :rows, :-nz]
            if share:
                A = np.eye(nz) - share * Z[:, rows:, -nz:]
                direct = direct + Z[:, :rows, -nz:] @ np.linalg.solve(A, share * Z[:, rows:, :-nz])
            places = self._pair_places(b).ravel()
            L = L + summed(places, direct.ravel(), L.size).reshape(L.shape)
        return L[0], L[1]

    def finite(self, by_value: Array, by_rate: Array) -> Any:
        """Whether the derivatives by pair of each stress (m + k,) are finite."""
        found = np.ones(self.structure.m + self.structure.k, dtype=bool)
        wrong = ~(np.isfinite(by_value) & np.isfinite(by_rate))[: self._size]
        found[self._codes[wrong] // self._width] = False
        return found

    def stress_change(self, by_value: Array, change: Array) -> Array:
        """Change of the stresses (m + k,) for small changes of the deformations (m + k,), slips not counted."""
        parts = by_value[: self._size] * change[self._codes % self._width]
        return summed(self._codes // self._width, parts, change.size)

    def _run_tangent(self, e: Array, w: Array, z: Array, t: float) -> None:
        m = self.structure.m
        self._tangent.run(e=e, ed=w[:m], s=w[m:], z=z, t=np.array([t]))

    def _lag_matrices(self) -> list[tuple[Batch, Array]]:
        """Derivatives (laws, stresses and dz/dt, e, ed, s, z) of the laws with internal states, by batch."""
        if not self._lagging:
            return []
        flat = self._tangent.flat("Z", self._Z_size)
        found = []
        for b in self._lagging:
            shape, first = (b.size, rows_of(b), columns_of(b)), self._Z_starts[id(b)]
            found.append((b, flat[first : first + int(np.prod(shape))].reshape(shape)))
        return found

    def add(
        self, K: Array, J: Array, phi: Array | None, by_value: Array, by_rate: Array, rate: float
    ) -> Array:
        """Add J' ((by value + rate by rate) J + by rate Phi) within elements to the flat K.

        Returns the same for the pairs across elements: entries in the rows `left` and columns `right` of J.
        """
        S = by_value + rate * by_rate
        for g, index in zip(self._groups, self._index, strict=True):
            if index is not None:
                _add(g, K, J, phi, S[index], by_rate[index])
        right = S[self._pair] * J[self.right]
        if phi is not None:
            right += by_rate[self._pair] * phi[self.right]
        return np.asarray(J[self.left] * right)


def _add(g: Group, K: Array, J: Array, phi: Array | None, S: Array, damping: Array) -> None:
    """Add J' (S J + damping Phi) of one group to the flat K."""
    Jg, Kg = g.J(J), g.K(K)
    if not damping.any():
        phi = None
    some = (S != 0).reshape(g.shape[0], -1).any(axis=1)
    if phi is not None:
        some |= (damping != 0).reshape(g.shape[0], -1).any(axis=1)
    every = bool(some.all())
    if not every:  # open contacts are skipped
        Jg, S, damping = Jg[some], S[some], damping[some]
    W = _times(S, Jg)
    if phi is not None:
        W += _times(damping, g.J(phi) if every else g.J(phi)[some])
    product = Jg.transpose(0, 2, 1) @ W
    if every:
        Kg += product
    else:
        Kg[some] += product


def _times(S: Array, A: Array) -> Array:
    """Products with matrices (elements, rows, rows), or with diagonals of them (elements, rows)."""
    return np.asarray(S[:, :, None] * A if S.ndim == 2 else S @ A)
