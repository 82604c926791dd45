"""Evaluates a model's elements and laws at a state, as global arrays.

The rows of the stacked arrays are the quantities [deformations | slips | coordinates] of
`flexel.structure.structure`; symbols as in the formulation: e, De, V, γ, M, h, f, σ, τ, Φ, Ψ.  The matrix J stacks
De, V and the identity, so that the rate of any quantity is a row of J times v.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from flexel.base.arrays import Array, Index
from flexel.engine.assembly import Batch, Place, Stage
from flexel.engine.batches import element_batches, law_batches, with_inertia
from flexel.engine.finite import check_tangent
from flexel.engine.local import Local
from flexel.structure.structure import Structure


@dataclass(frozen=True)
class Tangents:
    """Derivatives for the linearization at one state (formulation, "Analytic linearization").

    Attributes
    ----------
    Phi_x, Psi_x, Psi_v : ndarray (m + k + n, n)
        Derivatives of the rates and of the accelerations of all quantities.
    r_x, r_v : ndarray (n, n)
        Derivatives of r = M a + h - f + De' sigma + V' tau.
    stress_e, stress_ed : ndarray (m + k, m), stress_s : ndarray (m + k, k), stress_z : ndarray (m + k, nz)
        Derivatives of the laws' stresses (sigma, tau) with respect to e, its rate, s and z.
    zd_x, zd_v : ndarray (nz, n), zd_z : ndarray (nz, nz)
        Derivatives of the rates of the laws' internal states with respect to x, v and z.
    """

    Phi_x: Array
    Psi_x: Array
    Psi_v: Array
    r_x: Array
    r_v: Array
    stress_e: Array
    stress_ed: Array
    stress_s: Array
    stress_z: Array
    zd_x: Array
    zd_v: Array
    zd_z: Array


@dataclass(frozen=True)
class Constitutive:
    """Outputs of laws at (e, ed, s, z, t): stresses (m + k,), rates of z (nz,), energy [J], dissipated power [W]."""

    stress: Array
    zd: Array
    stored: float
    dissipated: float


class Evaluation:
    """The compiled kernels of a structure, ready to be called with global vectors."""

    def __init__(self, structure: Structure) -> None:
        self.structure = structure
        m, k, n = structure.m, structure.k, structure.n
        self._rows = m + k + n
        self._damped = any(z.mass_damping for z in structure.instances)
        self.elements = element_batches(structure)
        self.laws = law_batches(structure)
        self._place = _Places(m, k, n, structure.nz)
        self._stages: dict[str, Stage] = {}

    @cached_property
    def local(self) -> Local:
        """The same kernels with their outputs kept element by element, for sparse evaluation."""
        return Local(self.structure, self.elements, self.laws)

    def _stage(self, kind: str) -> Stage:
        """A kernel of all elements, prepared when first needed (its tables are as large as dense matrices)."""
        if kind not in self._stages:
            batches = self._with_inertia if kind in ("inertia", "tangent") else self.elements
            self._stages[kind] = Stage(batches, kind, self._place.element)
        return self._stages[kind]

    @cached_property
    def _with_inertia(self) -> list[Batch]:
        return with_inertia(self.elements, self.structure)

    @cached_property
    def _law(self) -> Stage:
        return Stage(self.laws, "law", self._place.law)

    @cached_property
    def _law_tangent(self) -> Stage:
        return Stage(self.laws, "tangent", self._place.law)

    @cached_property
    def _J(self) -> Array:  # noqa: N802
        J = np.zeros((self._rows, self.structure.n))
        J[self._rows - self.structure.n :] = np.eye(self.structure.n)
        return J

    def position(self, x: Array, out: Array | None = None) -> tuple[Array, Array]:
        """Deformations e (m,) as principal values, and J = [De; V; I] (m + k + n, n).

        J is written into `out`, if given: an earlier J of this model, whose zeros need not be written again.
        """
        stage = self._stage("position")
        stage.run(x=x)
        e = stage.put("e", np.zeros(self.structure.m))
        J = stage.put("J", self._J.copy() if out is None else out)
        if relations := self.structure.relations:
            e[relations.rows] = relations.of(e, x) - self.local.drawn
            J[relations.rows] = 0.0
            J[relations.rows] = relations.C @ J
        return e, J

    @cached_property
    def filled(self) -> Array:
        """Structural nonzeros of J (m + k + n, n), as booleans."""
        found: Array = self._J != 0
        found.ravel()[self._stage("position").places("J")] = True
        if relations := self.structure.relations:
            found[relations.rows] = abs(relations.C) @ found.astype(float) > 0
        return found

    def jacobian(self, x: Array) -> tuple[Array, Any]:
        """Deformations e (m,) as principal values, and J as a sparse matrix."""
        e, J = self.local.position(x)
        return e, self.local.matrix(J)

    def sparse_inertia(self, x: Array, v: Array) -> tuple[Any, Array, Array, float]:
        """The same as `inertia` with a sparse mass matrix."""
        found = self.local.inertia(x, v)
        return self.local.mass(found.M), found.h, found.f, found.potential

    @cached_property
    def heavy(self) -> Index:
        """Coordinates with inertia: the others have no rows and columns in the mass matrix."""
        places = self._stage("inertia").places("M")
        return np.unique(places % self.structure.n)

    def convective(self, x: Array, v: Array) -> Array:
        """Convective accelerations [D²e(v,v); s_x v; 0] of all quantities (m + k + n,)."""
        return np.concatenate([self.local.convective(x, v), np.zeros(self.structure.n)])

    def inertia(self, x: Array, v: Array) -> tuple[Array, Array, Array, float]:
        """Mass matrix M (n, n), convective inertia h (n,), body forces f (n,) and their potential [J].

        Mass-proportional damping is included in h.
        """
        n = self.structure.n
        self._stage("inertia").run(x=x, v=v)
        stage = self._stage("inertia")
        U = float(stage.sum("U", (1,))[0])
        h = stage.sum("h", (n,))
        if self._damped:
            h = h + stage.sum("damped M", (n, n)) @ v
        return stage.sum("M", (n, n)), h, stage.sum("f", (n,)), U

    def constitutive(self, e: Array, ed: Array, s: Array, z: Array, t: float) -> Constitutive:
        """Outputs of the laws at deformations (with turns), rates, slips, internal states and time."""
        size, nz, law = self.structure.m + self.structure.k, self.structure.nz, self._law
        if not self.structure.laws:
            return Constitutive(np.zeros(size), np.zeros(0), 0.0, 0.0)
        law.run(e=e, ed=ed, s=s, z=z, t=np.array([t], dtype=float))
        stored, dissipated = float(law.sum("U", (1,))[0]), float(law.sum("P", (1,))[0])
        return Constitutive(law.sum("stress", (size,)), law.put("zd", np.zeros(nz)), stored, dissipated)

    def stress_stiffness(self, x: Array, stress: Array) -> Array:
        """Derivative (n, n) of De' sigma + V' tau by x at given stresses (m + k,)."""
        m, n = self.structure.m, self.structure.n
        if relations := self.structure.relations:
            stress = relations.distributed(stress)
        self._stage("stiffness").run(x=x, sigma=stress[:m], tau=stress[m:])
        return self._stage("stiffness").sum("K", (n, n))

    def tangents(
        self, x: Array, v: Array, a: Array, J: Array, e: Array, stress: Array, z: Array, t: float
    ) -> Tangents:
        """All derivatives at a state; `stress` (m + k,) includes those of rigid deformations."""
        m, k, n = self.structure.m, self.structure.k, self.structure.n
        shape = (self._rows, n)
        self._stage("rates").run(x=x, v=v)
        self._stage("kinematics").run(x=x, v=v, a=a)
        Phi_x = self._stage("rates").put("Phi_x", np.zeros(shape))
        Psi_x, Psi_v = (self._stage("kinematics").put(name, np.zeros(shape)) for name in ("Psi_x", "Psi_v"))
        if relations := self.structure.relations:
            for rates in (Phi_x, Psi_x, Psi_v):
                rates[relations.rows] = relations.C @ rates
        self._stage("tangent").run(x=x, v=v, a=a)
        r_x = self.stress_stiffness(x, stress) + self._stage("tangent").sum("R_x", (n, n))
        r_v = self._stage("tangent").sum("R_v", (n, n))
        if self._damped:
            self._stage("inertia").run(x=x, v=v)
            r_v += self._stage("inertia").sum("damped M", (n, n))
        S = J[: m + k]
        L = self._law_derivatives(e, J[:m] @ v, J[m : m + k] @ v, z, t)
        Le, Ld, Ls, Lz = np.split(L, [m, 2 * m, 2 * m + k], axis=1)
        by_x = Le @ J[:m] + Ld @ Phi_x[:m] + Ls @ Phi_x[m : m + k]
        by_v = Ld @ J[:m] + Ls @ J[m : m + k]
        r_x += S.T @ by_x[: m + k]
        r_v += S.T @ by_v[: m + k]
        Se, Sd, Ss, Sz = (part[: m + k] for part in (Le, Ld, Ls, Lz))
        lags = by_x[m + k :], by_v[m + k :], Lz[m + k :]
        return Tangents(Phi_x, Psi_x, Psi_v, r_x, r_v, Se, Sd, Ss, Sz, *lags)

    def _law_derivatives(self, e: Array, ed: Array, s: Array, z: Array, t: float) -> Array:
        """Derivatives (m + k + nz, 2 m + k + nz) of (sigma, tau, dz/dt) of all laws by (e, ed, s, z)."""
        m, k, nz = self.structure.m, self.structure.k, self.structure.nz
        self._law_tangent.run(e=e, ed=ed, s=s, z=z, t=np.array([t], dtype=float))
        L = self._law_tangent.sum("J", (m + k + nz, 2 * m + k + nz))
        check_tangent(self.structure, np.all(np.isfinite(L), axis=1), t)
        return L


@dataclass(frozen=True)
class _Places:
    """Destinations of the outputs of the kernels in the global arrays."""

    m: int
    k: int
    n: int
    nz: int

    def element(self, batch: Batch, name: str) -> Place:
        d, s, x = batch.inputs["sigma"], batch.inputs["tau"] + self.m, batch.inputs["x"]
        rows, n = self.m + self.k + self.n, self.n
        both = np.concatenate([d, s], axis=1)
        vectors = {"e": ("e", d), "ed": ("w", d), "s": ("w", s), "g": ("g", d), "gs": ("g", s)}
        if name in vectors:
            array, places = vectors[name]
            return Place(array, (rows,), places, False)
        if name in ("h", "f"):
            return Place(name, (n,), x, True)
        if name == "U":
            return Place("U", (1,), np.zeros((batch.size, 1), dtype=np.intp), True)
        if name in ("M", "K", "R_x", "R_v"):
            return Place(name, (n, n), _outer(x, x, n), True)
        matrices = {"De": ("J", d), "V": ("J", s)}
        array, lines = matrices.get(name, (name, both))
        return Place(array, (rows, n), _outer(lines, x, n), False)

    def law(self, batch: Batch, name: str) -> Place:
        d, s, z = (batch.inputs[letter] for letter in ("e", "s", "z"))
        rows, width = self.m + self.k, 2 * self.m + self.k
        if name in ("sigma", "tau"):
            return Place("stress", (rows,), d if name == "sigma" else s + self.m, True)
        if name == "zd":
            return Place("zd", (self.nz,), z, False)
        if name in ("U", "P"):
            return Place(name, (1,), np.zeros((batch.size, 1), dtype=np.intp), True)
        lines = np.concatenate([d, s + self.m, z + rows], axis=1)
        columns = np.concatenate([d, d + self.m, s + 2 * self.m, z + width], axis=1)
        width += self.nz
        return Place(name, (rows + self.nz, width), _outer(lines, columns, width), True)


def _outer(lines: Index, columns: Index, width: int) -> Index:
    """Flat places (elements, rows x columns) of local matrices in a global one of that width."""
    return (lines[:, :, None] * width + columns[:, None, :]).reshape(lines.shape[0], -1)
