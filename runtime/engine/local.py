"""Kernels of all elements with their outputs kept element by element: the sparse side of the evaluation.

Outputs lie one element after another in flat arrays: J (an element's deformation and slip rows times its
coordinates) and K, M (coordinates times coordinates).  J as stored is a sparse matrix.  Nothing here is
larger than the sum of its elements, so that cost and storage grow linearly with their number.
Symbols as in the formulation.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from scipy.sparse import coo_array, csc_array, csr_array, eye_array, vstack

from flexel.base.arrays import Array, Index
from flexel.engine.assembly import Batch, Place, Stage, summed
from flexel.engine.groups import grouped
from flexel.engine.locallaws import LocalLaws
from flexel.engine.relation_lines import RelationLines
from flexel.structure.structure import Structure


def varies(batch: Batch) -> bool:
    """Whether the mass matrix or the body force of an element depends on its position.

    h vanishes identically if and only if M is constant.
    """
    kernels = batch.spec.kernels
    if "inertia" not in kernels:
        return False
    outputs = {out.name: out for kind in ("inertia", "tangent") for out in kernels[kind].outputs}
    return any(outputs[name].nonzeros for name in ("h", "R_x", "R_v"))


@dataclass(frozen=True)
class Inertia:
    """Inertia at (x, v): mass matrices of the elements where they vary (flat), and h, f (n,) of all."""

    M: Array
    h: Array
    f: Array
    potential: float


class Local:
    """The compiled kernels of a structure, outputs kept element by element.

    Attributes
    ----------
    groups : list of Group
    lines : ndarray of int
        Quantity of each local row; `line_of` is its inverse.
    rows_K, columns_K : ndarray of int
        Coordinates of each entry of the flat arrays of the kind of K.
    """

    def __init__(self, structure: Structure, elements: Sequence[Batch], laws: Sequence[Batch]) -> None:
        self.structure = structure
        m, k, n = structure.m, structure.k, structure.n
        batches = sorted(elements, key=lambda z: not varies(z))
        self.groups = grouped(batches, m)
        self._group = {id(g.batch): g for g in self.groups}
        moving = [g for g in self.groups if varies(g.batch)]  # they come first in the flat arrays
        self._relations = RelationLines(structure, self.groups)
        own = _joined(g.lines for g in self.groups)
        self.lines = np.concatenate([own, self._relations.quantities])
        self.line_of = np.empty(m + k, dtype=np.intp)
        self.line_of[self.lines] = np.arange(self.lines.size)
        columns = _joined(np.repeat(g.places[:, None, :], g.shape[1], axis=1) for g in self.groups)
        self.columns_J = np.concatenate([columns, self._relations.columns])
        self.rows_K = _joined(np.repeat(g.places, g.shape[2], axis=1) for g in self.groups)
        self.columns_K = _joined(np.repeat(g.places[:, None, :], g.shape[2], axis=1) for g in self.groups)
        self.size_M = sum(g.places.size * g.shape[2] for g in moving)
        self._places_M = _joined(g.places for g in moving)
        starts = _starts((g.lines.size, g.shape[2]) for g in self.groups)
        self.starts_J = np.append(starts, starts[-1] + np.cumsum(self._relations.widths))
        starts_M = _starts((g.places.size, g.shape[2]) for g in moving)
        shape = self.lines.size, n
        self._J: Any = csr_array((np.zeros(self.columns_J.size), self.columns_J, self.starts_J), shape=shape)
        self._J_transposed: Any = csc_array(
            (np.zeros(self.columns_J.size), self.columns_J, self.starts_J), shape=shape[::-1]
        )
        columns = self.columns_K[: self.size_M]
        self._M: Any = csr_array((np.zeros(self.size_M), columns, starts_M), shape=(self._places_M.size, n))
        self._shares = _joined(
            (np.repeat(_weights(g.batch), g.shape[2]) for g in moving), dtype=np.float64
        )  # mass-proportional damping of each row of M
        relations = {
            int(z): (int(self.starts_J[self.line_of[z]]), int(width))
            for z, width in zip(self._relations.quantities, self._relations.widths, strict=True)
        }
        self.laws = LocalLaws(structure, laws, self.groups, relations)
        self._stage_kernels([g.batch for g in moving])
        self._constant_inertia()
        self.drawn = np.zeros(
            self._relations.quantities.size
        )  # of the relations, for which they count as zero
        if self.drawn.size:
            e, _ = self.position(structure.x0)
            self.drawn = e[self._relations.quantities]

    def _stage_kernels(self, moving: list[Batch]) -> None:
        batches = [g.batch for g in self.groups]
        self._position = Stage(batches, "position", self._place)
        self._acceleration = Stage(batches, "acceleration", self._place)
        self._inertia = Stage(moving, "inertia", self._place)
        self._tangent = Stage(moving, "tangent", self._place)
        self._stiffness = Stage(batches, "stiffness", self._place)
        lawful = np.zeros(self.line_of.size, dtype=bool)
        lawful[self.laws.lines] = True
        lawful |= self._relations.among(lawful)
        damped = [g.batch for g in self.groups if lawful[g.lines].any() or g.batch.inputs["tau"].size]
        self._rates = Stage(damped, "rates", self._place)

    def _place(self, batch: Batch, name: str) -> Place:
        """Destination of an output of an element."""
        m, k, n = self.structure.m, self.structure.k, self.structure.n
        g, x = self._group[id(batch)], batch.inputs["x"]
        E, rows, columns = g.shape
        if name in ("h", "f"):
            return Place(name, (n,), x, True)
        if name == "U":
            return Place("U", (1,), np.zeros((E, 1), dtype=np.intp), True)
        if name in ("M", "K", "R_x", "R_v"):
            square = g.first_K + np.arange(E * columns**2).reshape(E, -1)
            return Place(name, (self.rows_K.size,), square, False)
        if name in ("e", "g", "gs"):
            lines = (
                g.lines[:, : g.batch.inputs["sigma"].shape[1]] if name != "gs" else batch.inputs["tau"] + m
            )
            return Place(name[0], (m + k,), lines, False)
        places = g.first_J + np.arange(E * rows * columns).reshape(E, rows, columns)
        deformations = batch.inputs["sigma"].shape[1]
        part = {"De": slice(0, deformations), "V": slice(deformations, rows)}.get(name, slice(0, rows))
        array = "J" if name in ("De", "V") else name
        return Place(array, (self.columns_J.size,), places[:, part].reshape(E, -1), False)

    def _constant_inertia(self) -> None:
        """Mass matrix, damping matrix and body forces of the elements with constant ones, computed once."""
        n, x0 = self.structure.n, self.structure.x0
        steady = [g.batch for g in self.groups if not varies(g.batch)]
        stage = Stage(steady, "inertia", self._place)
        stage.run(x=x0, v=np.zeros(n))
        entries = stage.flat("M", self.rows_K.size)[self.size_M :]
        at = self.rows_K[self.size_M :], self.columns_K[self.size_M :]
        shares = _joined(
            (np.repeat(_weights(g.batch), g.shape[2] ** 2) for g in self.groups if not varies(g.batch)),
            dtype=np.float64,
        )
        self.masses0 = entries
        self.M0: Any = csr_array(coo_array((entries, at), shape=(n, n)))
        self.damping0: Any = csr_array(coo_array((entries * shares, at), shape=(n, n)))
        self.damped = bool(self._shares.any() or shares.any())
        self._f0 = stage.sum("f", (n,))
        self._U0 = float(stage.sum("U", (1,))[0]) + float(self._f0 @ x0)

    # -- evaluation ------------------------------------------------------------------------------

    def position(self, x: Array) -> tuple[Array, Array]:
        """Deformations e (m,) as principal values, and the flat J."""
        self._position.run(x=x)
        e = self._position.flat("e", self.structure.m)
        J = self._relations.fill(self._position.flat("J", self.columns_J.size))
        if self._relations.quantities.size:
            e[self._relations.quantities] = self.structure.relations.of(e, x) - self.drawn
        return e, J

    def rates(self, J: Array, v: Array) -> Array:
        """Rates of the deformations and slips (m + k,)."""
        self._J.data = J
        w = np.zeros(self.line_of.size)
        w[self.lines] = self._J @ v
        return w

    def pull(self, J: Array, stress: Array) -> Array:
        """Nodal forces J' stress (n,) of stresses (m + k,)."""
        self._J_transposed.data = J
        return np.asarray(self._J_transposed @ stress[self.lines])

    def convective(self, x: Array, v: Array) -> Array:
        """Convective accelerations [D²e(v,v); s_x v] (m + k,)."""
        self._acceleration.run(x=x, v=v)
        return self._relations.combine(self._acceleration.flat("g", self.line_of.size))

    def inertia(self, x: Array, v: Array) -> Inertia:
        """Inertia at (x, v); mass-proportional damping is included in h."""
        n = self.structure.n
        if not self.size_M:
            M, h, f, U = np.zeros(0), np.zeros(n), self._f0, 0.0
        else:
            self._inertia.run(x=x, v=v)
            M = self._inertia.flat("M", self.size_M)
            h, f = self._inertia.sum("h", (n,)), self._inertia.sum("f", (n,)) + self._f0
            U = float(self._inertia.sum("U", (1,))[0])
        if self.damped:
            h = h + self.damping(M, v)
        return Inertia(M, h, f, U + self._U0 - float(self._f0 @ x))

    def damping(self, M: Array, v: Array) -> Array:
        """Forces (n,) of the mass-proportional damping."""
        d = np.asarray(self.damping0 @ v)
        return d + self._momentum(M, v, self._shares) if self._shares.any() else d

    def momentum(self, M: Array, a: Array) -> Array:
        """The mass matrix times a (n,): momenta for rates, forces for accelerations."""
        p = np.asarray(self.M0 @ a)
        return p + self._momentum(M, a, 1.0) if self.size_M else p

    def _momentum(self, M: Array, a: Array, share: Any) -> Array:
        self._M.data = M
        return summed(self._places_M, share * (self._M @ a), a.size)

    def phi(self, x: Array, v: Array) -> Array:
        """Derivatives of the rates of deformations and slips by x, flat like J."""
        self._rates.run(x=x, v=v)
        return self._relations.fill(self._rates.flat("Phi_x", self.columns_J.size), 0.0)

    def stress_stiffness(self, x: Array, stress: Array) -> Array:
        """Derivative of J' stress by x at given stresses (m + k,), flat like K."""
        m = self.structure.m
        if self._relations.quantities.size:
            stress = self.structure.relations.distributed(stress)
        self._stiffness.run(x=x, sigma=stress[:m], tau=stress[m:])
        return self._stiffness.flat("K", self.rows_K.size)

    def inertia_tangent(self, K: Array, x: Array, v: Array, a: Array, M: Array, rate: float) -> None:
        """Add the derivatives of M a + h - f by x, and `rate` times those by v, to K."""
        if not self.size_M:
            return
        self._tangent.run(x=x, v=v, a=a)
        own = K[: self.size_M]
        own += self._tangent.flat("R_x", self.size_M)
        if rate:
            own += rate * self._tangent.flat("R_v", self.size_M)
            if self._shares.any():
                own += rate * np.repeat(self._shares, np.diff(self._M.indptr)) * M

    def assembled(self, K: Array) -> Any:
        """The sum (n, n) of a flat array of the kind of K as a sparse matrix."""
        n = self.structure.n
        return csr_array(coo_array((K, (self.rows_K, self.columns_K)), shape=(n, n)))

    def mass(self, M: Array) -> Any:
        """The sparse mass matrix (n, n), from its part that varies."""
        return self.assembled(np.concatenate([M, self.masses0]))

    def matrix(self, J: Array) -> Any:
        """The sparse matrix [De; V; I] (m + k + n, n) in the order of the quantities."""
        self._J.data = J
        return vstack([self._J[self.line_of], eye_array(self.structure.n)], format="csr")


def _joined(parts: Any, dtype: Any = np.intp) -> Any:
    flat = [np.ravel(z) for z in parts]
    return np.concatenate(flat) if flat else np.zeros(0, dtype=dtype)


def _starts(counts: Any) -> Index:
    """Starts of rows in a flat array, from the number and width of rows in each group."""
    widths = _joined(np.full(rows, width, dtype=np.intp) for rows, width in counts)
    return np.concatenate([[0], np.cumsum(widths)]).astype(np.intp)


def _weights(batch: Batch) -> Array:
    return np.zeros(batch.size) if batch.weight is None else batch.weight
