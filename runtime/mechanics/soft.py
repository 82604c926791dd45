"""Computes eigenvalues that are small relative to the largest, to their last digits.

An eigenvalue of a state matrix has a rounding error proportional to the largest eigenvalue: the bending frequency of a
leaf spring is then accurate to ten digits.  Inverse iteration with the equations E x' = F x themselves,
without the inverse of the mass matrix, gives right and left vectors, and their Rayleigh quotient an eigenvalue whose
error is of second order in those of the vectors.  Nearly equal eigenvalues are treated together.
Source: Parlett (1974), Math. Comp. 28, "The Rayleigh quotient iteration and some generalizations for nonnormal
matrices".
"""

from __future__ import annotations

from typing import Any

import numpy as np
from scipy.linalg import eig, get_lapack_funcs

from flexel.base.arrays import Array, ComplexArray, Index

SOFT = 1e-3  # eigenvalues below this, relative to the largest, are corrected
NEAR = 1e-4  # distance of the shift, and of eigenvalues that are treated together, relative to them
TURNS = 2  # steps of inverse iteration
TRUSTED = 1e-3  # largest relative change that is a correction of the last digits

# eigenvalues, left and right eigenvectors in columns
Spectrum = tuple[ComplexArray, ComplexArray, ComplexArray]
_eig: Any = eig
_factors: Any = get_lapack_funcs("getrf", dtype=np.complex128)  # `lu_factor` warns of a singular matrix
_solved: Any = get_lapack_funcs("getrs", dtype=np.complex128)


def corrected(found: Spectrum, M: Array, forces: Array, A: Array) -> Spectrum:
    """Correct the small eigenvalues in the spectrum of a state matrix.

    Parameters
    ----------
    found : tuple of ndarray
        Eigenvalues, left and right eigenvectors of A.
    M : ndarray (nd, nd)
    forces : ndarray (nd, n)
        M times minus the first rows of the state matrix.
    A : ndarray (n, n)
        The state matrix.
    """
    values, left, right = (part.astype(complex) for part in found)
    size = np.abs(values)
    soft = np.flatnonzero((size > 0) & (size < SOFT * size.max(initial=0.0)))
    if not soft.size:
        return found
    equations = _Equations(M, forces, A)
    for group in _groups(values, soft):
        twins = [
            place + 1 for place in group
        ]  # LAPACK puts the conjugate after the one with positive imaginary part
        above, below = np.all(values[group].imag > 0), np.all(values[group].imag < 0)
        if below:
            continue
        better = equations.corrected(values[group], left[:, group], right[:, group])
        if better is None:
            continue
        values[group], left[:, group], right[:, group] = better
        if above:
            values[twins], left[:, twins], right[:, twins] = (part.conj() for part in better)
    return values, left, right


class _Equations:
    """E x' = F x, rows divided by their largest entries."""

    def __init__(self, M: Array, forces: Array, A: Array) -> None:
        nd = len(M)
        self.E, self.F = np.eye(len(A)), A.copy()
        self.E[:nd, :nd], self.F[:nd] = M, -forces
        self.scale = 1 / np.maximum(np.abs(self.F).max(axis=1), np.abs(self.E).max(axis=1))

    def corrected(self, values: ComplexArray, left: ComplexArray, right: ComplexArray) -> Spectrum | None:
        """Return nearly equal eigenvalues, and their vectors; None if they do not agree with the given ones."""
        shift = values.mean() * (1 - NEAR)
        matrix = self.scale[:, None] * (self.F - shift * self.E)
        *factors, singular = _factors(matrix)
        if singular:  # a multiple eigenvalue zero, which LAPACK's rounding has split
            return None
        # those of the equations with scaled rows: y = (scale E)^-H l
        other = np.linalg.solve((self.scale[:, None] * self.E).T.astype(complex), left)
        for _ in range(TURNS):
            right = _turned(matrix, factors, self.scale[:, None] * (self.E @ right), 0)
            other = _turned(matrix.conj().T, factors, self.E.T @ (self.scale[:, None] * other), 2)
        along = (self.scale[:, None] * other).conj().T
        F, E = along @ (self.F @ right), along @ (self.E @ right)
        if len(values) == 1:
            if E[0, 0] == 0:
                return None
            new, own_left, own_right = F[0] / E[0], np.eye(1), np.eye(1)
        else:
            new, own_left, own_right = _eig(F, E, left=True, right=True)
        order = _order(new)
        new = np.asarray(new)[order]
        if not np.all(np.abs(new - values[_order(values)]) <= TRUSTED * np.abs(values)):  # false for NaN
            return None
        places = np.argsort(_order(values))  # back to the given order
        found = new[places], (other @ own_left)[:, order][:, places], (right @ own_right)[:, order][:, places]
        left = self.E.T @ (self.scale[:, None] * found[1])
        return found[0], _units(left), _units(found[2])


def _groups(values: ComplexArray, chosen: Index) -> list[list[int]]:
    """Group the chosen eigenvalues, nearly equal ones together."""
    groups: list[list[int]] = []
    for place in sorted(chosen.tolist(), key=lambda number: abs(values[number])):
        close = [g for g in groups if np.any(np.abs(values[g] - values[place]) <= NEAR * abs(values[place]))]
        groups = [g for g in groups if g not in close]
        groups.append([*(number for g in close for number in g), place])
    return groups


def _order(values: ComplexArray) -> Index:
    return np.lexsort((values.imag, values.real)) if len(values) > 1 else np.zeros(1, dtype=np.intp)


def _turned(matrix: Any, factors: Any, rhs: ComplexArray, way: int) -> ComplexArray:
    """Return mutually orthogonal solutions of unit size; solved, and corrected once."""
    x = _solved(*factors, rhs, trans=way)[0]
    x = x + _solved(*factors, rhs - matrix @ x, trans=way)[0]
    return np.asarray(np.linalg.qr(x)[0])


def _units(vectors: ComplexArray) -> ComplexArray:
    return np.asarray(vectors / np.linalg.norm(vectors, axis=0))
