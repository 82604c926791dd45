"""Tracks eigenvalues over a parameter as branches, each followed by the shape of its mode, not by its order.

Between adjacent values of the parameter, shapes are compared by left and right eigenvectors: |l₁ r₂| |l₂ r₁| over
|l₁ r₁| |l₂ r₂| is one for a mode and itself and zero for two modes of one matrix, whatever the units of the states.
Where shapes are not conclusive (equal eigenvalues, two that meet and become a pair) the linear continuation of the
eigenvalues decides.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import eig
from scipy.optimize import brentq, linear_sum_assignment

from flexel.base.arrays import Array, ComplexArray, Index
from flexel.base.errors import ModelError

# Relative difference below which eigenvalues count as equal, and their vectors as arbitrary.
SHARE_DIGITS = 6  # of shares that are compared: beyond is rounding
EQUAL_TOLERANCE = 1e-6
ZERO_TOLERANCE = 1e-7  # of the largest eigenvalue: smaller real parts may come from rounding
MIN_SIMILARITY = 0.1  # similarity of two shapes below which one does not continue the other
# Real part at a boundary, relative to the eigenvalues around it, that is no jump to another branch.
AT_ROOT = 1e-6
FINER = 17  # values between two neighbours of the parameter, where these are too far apart
NEAREST_VALUES = 1e-3  # relative difference of two neighbours between which no more values are taken
POINTS = 4  # number of neighbours for the interpolation between values of the parameter

_eig: Any = eig
_brentq: Any = brentq


@dataclass(frozen=True)
class Boundary:
    """A value at which a branch becomes stable or unstable.

    Attributes
    ----------
    value : float
        Of the parameter.
    branch : str
        Name of the branch.
    frequency : float
        Magnitude of the imaginary part there [rad/s]; zero for a real eigenvalue.
    """

    value: float
    branch: str
    frequency: float


@dataclass(frozen=True)
class Branches:
    """Eigenvalues over a parameter, one branch per column; complex pairs share a name.

    Attributes
    ----------
    parameter : ndarray (np,)
    eigenvalues : ndarray (np, n)
        [1/s]; rows of NaN where none are known.
    matrices : ndarray (np, n, n), optional
        State matrices of which they are the eigenvalues.
    shares : ndarray (np, n, n), optional
        Share of each state (last axis) in each branch, by left and right eigenvectors.
    labels : tuple of str
        Names of the states to which the shares belong.
    exact : callable(float) -> ndarray (n, n), optional
        The state matrix at any value of the parameter.
    """

    parameter: Array
    eigenvalues: ComplexArray
    matrices: Array | None = field(default=None, repr=False)
    shares: Array | None = field(default=None, repr=False)
    labels: tuple[str, ...] = ()
    exact: Callable[[float], Array] | None = field(default=None, repr=False, compare=False)

    @classmethod
    def of(cls, parameter: Array, given: Any, labels: Sequence[str] = ()) -> Branches:
        """Build the branches of state matrices (np, n, n), or of their eigenvalues (np, n) alone."""
        values = np.asarray(given)
        if values.ndim < 3:
            return cls(parameter, _ordered(parameter, values.astype(complex))[0])
        n = values.shape[-1]
        w = np.full(values.shape[:2], np.nan, dtype=complex)
        left, right = (np.full(values.shape, np.nan, dtype=complex) for _ in range(2))
        for i in np.flatnonzero(np.isfinite(values).all(axis=(1, 2))) if n else ():
            w[i], left[i], right[i] = _eig(values[i], left=True, right=True)
        w, order = _ordered(parameter, w, left, right)
        share = np.take_along_axis(np.abs(left.conj() * right), order[:, None, :], axis=2).transpose(0, 2, 1)
        total = share.sum(axis=2, keepdims=True)
        return cls(parameter, w, values, share / np.where(total > 0, total, 1.0), tuple(labels))

    @classmethod
    def of_shapes(cls, parameter: Array, values: Array, shapes: Array, labels: Sequence[str]) -> Branches:
        """Build branches of some of the modes (np, n), whose shapes are known, such as the lowest free vibrations.

        A branch ends if no shape continues it, because its mode is no longer among those known; another one begins
        there. Other entries are NaN.

        Parameters
        ----------
        values : ndarray (np, n)
            Frequencies or multipliers; rows of NaN where none are known.
        shapes : ndarray (np, n, k)
            Displacements in comparable units, of any size.
        labels : sequence of str
            Names of the displacements.
        """
        columns = np.asarray(shapes, dtype=complex).transpose(0, 2, 1)
        w, order = _ordered(parameter, values.astype(complex), columns, columns)
        share = np.take_along_axis(np.abs(shapes) ** 2, order[:, :, None], axis=1)
        total = share.sum(axis=2, keepdims=True)
        share = share / np.where(total > 0, total, 1.0)
        pieces = _pieces(w, np.take_along_axis(columns, order[:, None, :], axis=2))
        there = np.array([np.isin(np.arange(len(w)), rows) for _, rows in pieces]).T
        places = [j for j, _ in pieces]
        w = np.where(there, w[:, places], np.nan)
        return cls(
            parameter, w, shares=np.where(there[..., None], share[:, places], np.nan), labels=tuple(labels)
        )

    @cached_property
    def families(self) -> list[list[int]]:
        """Return the columns of one complex pair (conjugate nearly everywhere that one is complex), or one column."""
        w, found = self.eigenvalues, list[list[int]]()
        size = np.abs(w)
        for j in range(w.shape[1]):
            oscillates = np.abs(w[:, j].imag) > EQUAL_TOLERANCE * size[:, j]
            for other in found:
                pair = oscillates & (np.abs(w[:, j] - w[:, other[0]].conj()) <= EQUAL_TOLERANCE * size[:, j])
                if len(other) == 1 and 2 * pair.sum() > oscillates.sum():
                    other.append(j)
                    break
            else:
                found.append([j])
        return found

    @cached_property
    def names(self) -> list[str]:
        """Name each family by the state with the largest share in it, numbered if several have the same.

        Of states with equal shares, up to rounding, the first one is taken. Where an eigenvalue equals another one, its
        vector is an arbitrary combination, and does not count unless there is no other.
        """
        if self.shares is None or not self.labels:
            return [f"branch {i + 1}" for i in range(len(self.families))]
        unique = list(dict.fromkeys(self.labels))
        to = np.array([unique.index(label) for label in self.labels])
        alone, largest = np.array([_alone(w) for w in self.eigenvalues]), []
        for family in self.families:
            clear = alone[:, family].all(axis=1) & np.isfinite(self.eigenvalues[:, family]).all(axis=1)
            mean = np.nanmean(self.shares[clear if clear.any() else slice(None)][:, family], axis=(0, 1))
            largest.append(unique[int(np.argmax(np.bincount(to, mean, len(unique)).round(SHARE_DIGITS)))])
        return [
            name if largest.count(name) == 1 else f"{name} ({largest[: i + 1].count(name)})"
            for i, name in enumerate(largest)
        ]

    def boundaries(self, names: Sequence[str] | None = None) -> list[Boundary]:
        """Find where real parts change sign, refined between the values of the parameter, in increasing order.

        Where nothing is damped, that is where they leave zero upwards: two vibrations meet there, or a vibration
        becomes a divergence.

        The state matrix is interpolated through four neighbours, which is exact for a polynomial of third degree, such
        as equations over a speed; over a parameter it is computed again at each value that is tried. Without matrices,
        the eigenvalues are interpolated.

        Raises
        ------
        ModelError
            If the values of the parameter do not increase, or decrease.
        """
        _check_order(self.parameter)
        w, found = self.eigenvalues, list[Boundary]()
        floor = ZERO_TOLERANCE * float(np.nanmax(np.abs(w), initial=0.0))
        for name, family in zip(names or self.names, self.families, strict=True):
            for value, frequency in self._crossings(family, floor):
                if not any(
                    boundary.branch == name and np.isclose(boundary.value, value, rtol=1e-9)
                    for boundary in found
                ):
                    found.append(Boundary(value, name, frequency))
        return sorted(found, key=lambda boundary: boundary.value)

    def _crossings(self, family: Sequence[int], floor: float) -> Iterator[tuple[float, float]]:
        for j in family:
            real = self.eigenvalues[:, j].real
            known = np.flatnonzero(np.abs(real) > floor)
            for i, k in zip(known, known[1:], strict=False):
                if real[i] * real[k] < 0:
                    yield self._root(int(i), int(k), j, 0.0)
            for left, right in self._onsets(real, floor):
                yield self._root(left, right, j, floor)

    def _onsets(self, real: Array, floor: float) -> Iterator[tuple[int, int]]:
        """Yield neighbouring values of the parameter between which a real part leaves zero upwards, and stays there.

        Without matrices there is no interpolation of it: it grows with the root of the parameter.
        """
        signs = np.where(np.abs(real) <= floor, 0.0, np.sign(real)).tolist()
        for step in (1, -1) if self.matrices is not None else ():
            order = list(range(len(signs)))[::step]
            known = 0.0
            for i, k in pairwise(order):
                known = signs[i] or known
                if signs[i] == 0 and signs[k] > 0 and known >= 0:
                    yield min(i, k), max(i, k)

    def _root(self, i: int, k: int, j: int, level: float) -> tuple[float, float]:
        """Return the value of the parameter between two where branch j has a real part, and its frequency there."""
        at = self._between(i, k, j)
        root = float(_brentq(lambda p: at(p).real - level, *self.parameter[[i, k]], xtol=1e-14))
        there = at(root)
        size = float(np.abs(self.eigenvalues[[i, k], j]).max())
        if self.exact is None or abs(there.real - level) <= AT_ROOT * size:
            return root, abs(there.imag)
        return self._refined(i, k, j, self.exact, level) or (root, abs(there.imag))

    def _refined(
        self, i: int, k: int, j: int, exact: Callable[[float], Array], level: float
    ) -> tuple[float, float] | None:
        """Return the same by values between two that are too far apart to follow the branch; None if they are close."""
        first, last = self.parameter[[i, k]].tolist()
        if abs(last - first) <= NEAREST_VALUES * max(abs(first), abs(last)):
            return None
        values = np.linspace(first, last, FINER)
        fine = replace(Branches.of(values, np.array([exact(p) for p in values.tolist()])), exact=exact)
        own = int(np.argmin(np.abs(fine.eigenvalues[0] - self.eigenvalues[i, j])))
        return next(fine._crossings([own], level), None)

    def _between(self, i: int, k: int, j: int) -> Callable[[float], complex]:
        """Interpolate the branch j between its values i and k of the parameter."""
        given = self.eigenvalues[:, j] if self.matrices is None else self.matrices
        chosen = _neighbours(self.parameter, np.isfinite(self.eigenvalues[:, j]), i, k)
        p, values = self.parameter[chosen], given[chosen]
        ends = self.parameter[[i, k]], self.eigenvalues[[i, k], j]

        def at(value: float) -> complex:
            found = np.tensordot(_lagrange(p, value), values, axes=1)
            if self.matrices is None:
                return complex(found)
            share = (value - ends[0][0]) / (ends[0][1] - ends[0][0])
            near = _nearest(found, ends[1][0] + share * (ends[1][1] - ends[1][0]))
            return near if self.exact is None else _nearest(self.exact(value), near)

        return at


def _check_order(p: Array) -> None:
    """Raise a ModelError for values between which no branch can be followed."""
    steps = np.diff(p)
    if np.all(steps > 0) or np.all(steps < 0):
        return
    wrong = int(np.flatnonzero(steps * np.sign(p[-1] - p[0]) <= 0)[0])
    raise ModelError(
        f"boundaries: the values of the parameter must increase, or decrease: {p[wrong + 1]:g} comes after {p[wrong]:g}"
    )


def _nearest(A: Any, value: complex) -> complex:
    """Return the eigenvalue of a matrix that is nearest to a value."""
    w = np.linalg.eigvals(A)
    return complex(w[np.argmin(np.abs(w - value))])


def _neighbours(p: Array, known: NDArray[np.bool_], i: int, k: int) -> Index:
    """Return the indices of the parameter values nearest to the middle of two, including both."""
    usable = np.flatnonzero(known)
    order = usable[np.argsort(np.abs(p[usable] - (p[i] + p[k]) / 2), kind="stable")][:POINTS]
    return np.unique([*order, i, k])


def _lagrange(p: Array, value: float) -> Array:
    """Return the weights of a polynomial through the points p at a value."""
    off = value - p
    return np.array([np.prod(np.delete(off, i) / (p[i] - np.delete(p, i))) for i in range(p.size)])


def _ordered(
    p: Array, w: ComplexArray, left: ComplexArray | None = None, right: ComplexArray | None = None
) -> tuple[ComplexArray, Index]:
    """Sort the columns of eigenvalues (np, n) in the order of the branches; return them and that order."""
    found, order = w.copy(), np.tile(np.arange(w.shape[1]), (len(w), 1))
    known = np.flatnonzero(np.isfinite(w).all(axis=1))
    if not known.size:
        return found, order
    first = known[0]
    vectors = None if left is None or right is None else (left[first].copy(), right[first].copy())
    for i, (before, last, now) in enumerate(zip([known[0], *known], known, known[1:], strict=False)):
        expected = found[last]
        if i and p[last] != p[before]:
            expected = expected + (p[now] - p[last]) / (p[last] - p[before]) * (expected - found[before])
        cost = _distance(expected, w[now])
        if vectors is not None and left is not None and right is not None:
            cost = cost + 1 - _likeness(*vectors, left[now], right[now])
        order[now] = linear_sum_assignment(cost)[1]
        found[now] = w[now][order[now]]
        if vectors is not None and left is not None and right is not None:
            alone = _alone(found[now])  # those of equal eigenvalues are arbitrary combinations
            for kept, new in zip(vectors, (left[now], right[now]), strict=True):
                kept[:, alone] = new[:, order[now]][:, alone]
    return found, order


def _pieces(w: ComplexArray, columns: ComplexArray) -> list[tuple[int, list[int]]]:
    """Return the columns of w (np, n) with the rows through which a shape (np, k, n) continues, one or several."""
    known = np.flatnonzero(np.isfinite(w).all(axis=1))
    found = [(j, [int(known[0])]) for j in range(w.shape[1])] if known.size else []
    open_ones = list(found)
    for last, now in zip(known, known[1:], strict=False):
        alike = np.diag(_likeness(columns[last], columns[last], columns[now], columns[now]))
        other = (alike < MIN_SIMILARITY) & _alone(w[last]) & _alone(w[now])
        for j in range(w.shape[1]):
            if other[j]:
                open_ones[j] = (j, [])
                found.append(open_ones[j])
            open_ones[j][1].append(int(now))
    return found


def _distance(expected: ComplexArray, w: ComplexArray) -> Array:
    """Return the differences of expected (rows) and found eigenvalues, relative to both: from zero to one."""
    size = np.abs(expected)[:, None] + np.abs(w)[None, :]
    return np.asarray(
        np.abs(expected[:, None] - w[None, :]) / np.maximum(size, 1e-9 * size.max(initial=1e-300))
    )


def _likeness(left: ComplexArray, right: ComplexArray, left2: ComplexArray, right2: ComplexArray) -> Array:
    """Return the similarity of the shapes of one matrix (rows) to those of another: from zero to one."""
    own = np.abs((left.conj() * right).sum(axis=0))[:, None] * np.abs((left2.conj() * right2).sum(axis=0))
    across = np.abs(left.conj().T @ right2) * np.abs(left2.conj().T @ right).T
    return np.asarray(np.minimum(across / np.maximum(own, 1e-300), 1.0))


def _alone(w: ComplexArray) -> NDArray[np.bool_]:
    """Whether no other eigenvalue is nearly equal; unknown ones (NaN) are equal to none."""
    apart = np.abs(w[:, None] - w[None, :]) + np.diag(np.full(w.size, np.inf))
    least = np.fmin.reduce(apart, axis=1, initial=np.inf)
    return np.asarray(least > EQUAL_TOLERANCE * np.fmax.reduce(np.abs(w), initial=0.0))
