"""Derivatives for the linearization at a state, as sparse matrices."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from scipy.sparse import csr_array

from flexel.base.arrays import Array
from flexel.base.copies import Portable
from flexel.engine.evaluate import Evaluation
from flexel.engine.finite import check_tangent


@dataclass(frozen=True)
class Tangents:
    """Derivatives for the linearization at one state (formulation, "Analytic linearization").

    Attributes
    ----------
    J, Phi_x, Psi_x, Psi_v : ndarray (m + k + n, n)
        J, and derivatives of the rates and of the accelerations of all quantities.
    M : ndarray (n, n)
        Mass matrix.
    r_x, r_v : ndarray (n, nf)
        Derivatives of r = M a + h - f + De' sigma + V' tau by the free coordinates and their rates.
    stress_e, stress_ed : ndarray (m + k, m), stress_s : ndarray (m + k, k), stress_z : ndarray (m + k, nz)
        Derivatives of the laws' stresses (sigma, tau) with respect to e, its rate, s and z.
    zd_x, zd_v : ndarray (nz, n), zd_z : ndarray (nz, nz)
        Derivatives of the rates of the laws' internal states with respect to x, v and z.
    """

    J: Array
    Phi_x: Array
    Psi_x: Array
    Psi_v: Array
    M: Array
    r_x: Array
    r_v: Array
    stress_e: Array
    stress_ed: Array
    stress_s: Array
    stress_z: Array
    zd_x: Array
    zd_v: Array
    zd_z: Array

    def dense(self) -> Tangents:
        """Return these tangents."""
        return self


@dataclass(frozen=True)
class Derivatives(Portable):
    """The same as values of the patterns of a model: of J, Phi_x, Psi_x and Psi_v, of M, and of r_x and r_v.

    Here r_x and r_v are without the part of the derivatives of laws.

    Attributes
    ----------
    laws : ndarray
        Derivatives of (sigma, tau, dz/dt) of all laws by (e, ed, s, z), in the order of `LawTables.entries`.
    """

    evaluation: Evaluation
    J: Array
    Phi_x: Array
    Psi_x: Array
    Psi_v: Array
    M: Array
    r_x: Array
    r_v: Array
    laws: Array

    @cached_property
    def _law_matrix(self) -> Any:
        """All derivatives of laws (m + k + nz, 2 m + k + nz), sparse."""
        s = self.evaluation.structure
        rows, columns, _ = self.evaluation.tables.law.entries
        size = s.m + s.k + s.nz
        return csr_array((self.laws, (rows, columns)), shape=(size, size + s.m))

    @cached_property
    def internal_states(self) -> tuple[Any, Any, Array]:
        """Rates of internal states by x (nz, n), v (nz, n) and z (nz, nz)."""
        s, pattern = self.evaluation.structure, self.evaluation.tables.J
        m, k = s.m, s.k
        J, Phi_x = pattern.matrix(self.J), pattern.matrix(self.Phi_x)
        lag = self._law_matrix[m + k :]
        by_e, by_rate = lag[:, :m], lag[:, m : 2 * m + k]
        by_x = by_e @ J[:m] + by_rate @ Phi_x[: m + k]
        return by_x, by_rate @ J[: m + k], lag[:, 2 * m + k :].toarray()

    @property
    def _by_laws(self) -> tuple[Any, Any]:
        """The parts (n, n) of r_x and r_v of the derivatives of laws."""
        s, pattern = self.evaluation.structure, self.evaluation.tables.J
        m, k = s.m, s.k
        J, Phi_x = pattern.matrix(self.J)[: m + k], pattern.matrix(self.Phi_x)[: m + k]
        by_e, by_rate = self._law_matrix[: m + k, :m], self._law_matrix[: m + k, m : 2 * m + k]
        return J.T @ (by_e @ J[:m] + by_rate @ Phi_x), J.T @ (by_rate @ J)

    @property
    def stress_z(self) -> Array:
        """Stresses by internal states (m + k, nz)."""
        s = self.evaluation.structure
        return np.asarray(self._law_matrix[: s.m + s.k, 2 * s.m + s.k :].toarray())

    def dense(self) -> Tangents:
        """Convert the tangents to dense arrays."""
        s, t = self.evaluation.structure, self.evaluation.tables
        m, k = s.m, s.k
        own = {name: t.J.matrix(getattr(self, name)).toarray() for name in ("J", "Phi_x", "Psi_x", "Psi_v")}
        own |= {name: t.T.whole.matrix(getattr(self, name)).toarray() for name in ("r_x", "r_v")}
        for name, part in zip(("r_x", "r_v"), self._by_laws, strict=True):
            own[name] += part[:, : s.nf].toarray()
        parts = np.split(self._law_matrix[: m + k].toarray(), [m, 2 * m, 2 * m + k], axis=1)
        own |= dict(zip(("stress_e", "stress_ed", "stress_s", "stress_z"), parts, strict=True))
        by_x, by_v, by_z = self.internal_states
        mass = t.M.matrix(self.M).toarray()
        return Tangents(**own, M=mass, zd_x=by_x.toarray(), zd_v=by_v.toarray(), zd_z=by_z)


def check_laws(evaluation: Evaluation, laws: Array, t: float) -> None:
    """Check that the derivatives of (sigma, tau, dz/dt) of all laws at a state are finite.

    Raises
    ------
    TangentError
        If a law has no slope there; names it.
    """
    good = np.isfinite(laws)
    if laws.size and not good.all():
        s = evaluation.structure
        finite = np.ones(s.m + s.k + s.nz, dtype=bool)
        finite[evaluation.tables.law.entries[0][~good]] = False
        check_tangent(s, finite, t)
