"""Modes and eigenvalues of linearized equations."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np

from flexel.base.arguments import names as checked_names
from flexel.base.arguments import not_negative
from flexel.base.arrays import Array, ComplexArray, Index
from flexel.base.errors import LinearizationError
from flexel.base.shown import Listing, prints
from flexel.engine.solvers import eigenvalues, solved
from flexel.mechanics.soft import Spectrum

NAMED = 2  # degrees of freedom in the name of a mode


@dataclass(frozen=True)
class Mode:
    """A mode of the linearized motion.

    Attributes
    ----------
    eigenvalue : complex
        [1/s]
    shape : dict of str to complex
        Amplitude of each degree of freedom and internal state of a law, the largest scaled to 1.
    participation : dict of str to float
        Share of each of them (dynamic degrees of freedom with their rates) in the mode, by left and right eigenvectors;
        sums to 1.
    """

    eigenvalue: complex
    shape: dict[str, complex]
    participation: dict[str, float]

    HEAD: ClassVar[tuple[str, ...]] = ("mode", "eigenvalue [1/s]", "frequency [Hz]", "damping")

    def row(self) -> tuple[str, ...]:
        """Return its row in a table of modes."""
        return self.name, self._eigenvalue, f"{self.hertz:.5g}", self._damping

    @prints
    def __repr__(self) -> str:
        return (
            f"Mode({self.name}: eigenvalue {self._eigenvalue}, {self.hertz:.5g} Hz, damping {self._damping})"
        )

    @property
    def _eigenvalue(self) -> str:
        value = self.eigenvalue
        return f"{value:.5g}" if value.imag else f"{value.real:.5g}"

    @property
    def _damping(self) -> str:
        return f"{self.damping + 0.0:.4g}"  # not -0

    @property
    def name(self) -> str:
        """Name the two degrees of freedom with the largest participation, and count others with a quarter of it."""
        order = sorted(self.participation, key=lambda name: -self.participation[name])
        large = [name for name in order if self.participation[name] >= 0.25 * self.participation[order[0]]]
        others = [f"{len(large) - NAMED} more"] if len(large) > NAMED else []
        return "+".join([*large[:NAMED], *others])

    @property
    def omega(self) -> float:
        """Undamped natural frequency |eigenvalue| [rad/s]."""
        return abs(self.eigenvalue)

    @property
    def hertz(self) -> float:
        """Undamped natural frequency [Hz]."""
        return self.omega / (2 * np.pi)

    @property
    def damping(self) -> float:
        """Damping ratio -Re/|.|; 0 for a zero eigenvalue."""
        return -self.eigenvalue.real / self.omega if self.omega else 0.0


@dataclass(frozen=True)
class Reduced:
    """Second-order equations of some degrees of freedom, decoupled from the rest: M q'' + C q' + K q = 0.

    Attributes
    ----------
    names : tuple of str (n,)
        The degrees of freedom q.
    M, C, K : ndarray (n, n)
        Mass, damping and stiffness matrix.
    """

    names: tuple[str, ...]
    M: Array
    C: Array
    K: Array

    @prints
    def __repr__(self) -> str:
        return f"Reduced({', '.join(self.names)}; M, C, K)"

    @property
    def state_matrix(self) -> Array:
        """Return the matrix of the first-order form for (q', q)."""
        return first_order(self.M, (self.C, self.K))

    def eigenvalues(self) -> ComplexArray:
        """Return the 2 n eigenvalues [1/s], sorted by real, then imaginary part."""
        return sort_eigenvalues(eigenvalues(self.state_matrix))


def places_of(names: Sequence[str], dynamic: Sequence[str]) -> Index:
    """Return the indices of some dynamic degrees of freedom among all.

    Raises
    ------
    LinearizationError
        No name, one that is given twice, or one that is not a dynamic degree of freedom.
    """
    if not checked_names(names, "reduced") or len(set(names)) < len(names):
        raise LinearizationError(
            f"reduced: {names!r} given; name one or more dynamic degrees of freedom, each once"
        )
    for name in names:
        if name not in dynamic:
            raise LinearizationError(
                f"reduced: '{name}' is not a dynamic degree of freedom; name some of {dynamic}"
            )
    return np.array([dynamic.index(name) for name in names])


def check_decoupled(
    names: Sequence[str], columns: Mapping[str, Sequence[str]], sizes: Sequence[float], tolerance: float
) -> None:
    """Check that only the named degrees of freedom enter their equations.

    Parameters
    ----------
    columns : mapping of str to sequence of str
        Names of the columns of M, C, K and Z.
    sizes : sequence of float
        Largest entry of each of these columns in the equations.
    tolerance : float
        Relative to the largest entry of the matrix; for Z of K.

    Raises
    ------
    LinearizationError
    """
    tolerance = not_negative(tolerance, "reduced", "tolerance")
    first, largest = 0, 0.0
    for label, others in columns.items():
        own = sizes[first : first + len(others)]
        first += len(others)
        if label != "Z":
            largest = max(own)
        for size, name in zip(own, others, strict=True):
            if name not in names and size > tolerance * largest:
                raise LinearizationError(
                    f"{tuple(names)} are not decoupled: '{name}' enters through {label} ({size:.3g}); include it, or "
                    "use the full state matrix"
                )


def first_order(M: Array, forces: Sequence[Array], *rest: Sequence[Array]) -> Array:
    """Return matrices (…, n, n) of first-order equations for (q_d', q_d, …), from M q_d'' + forces = 0.

    Parameters
    ----------
    M : ndarray (…, nd, nd)
    forces : sequence of ndarray (…, nd, columns)
        Blocks, side by side, by columns of all n unknowns.
    *rest : sequence of ndarray (…, rows, columns)
        Rates of the unknowns after q_d: adjacent blocks; omitted columns are zero.
    """
    top = np.concatenate(forces, axis=-1)
    nd, n = top.shape[-2:]
    A = np.zeros((*M.shape[:-2], n, n))
    # a stack of one costs ten times as much, in every linearization
    A[..., :nd, :] = -solved(M, top) if M.ndim == 2 else -np.linalg.solve(M, top)
    A[..., nd : 2 * nd, :nd] = np.eye(nd)
    row = 2 * nd
    for blocks in rest:
        rates = np.concatenate(blocks, axis=-1)
        A[..., row : row + rates.shape[-2], : rates.shape[-1]] = rates
        row += rates.shape[-2]
    return A


def modes_of(found: Spectrum, names: tuple[str, ...], nd: int) -> Listing[Mode]:
    """Return the modes of first-order equations for (q_d', q_d, q_k, z), one per complex pair, in eigenvalue order.

    The `names` are those of (q_d, q_k, z); the first `nd` of them are dynamic.
    """
    w, left, right = found
    scale = float(np.max(np.abs(w), initial=1e-300))
    keep = [i for i in range(w.size) if w[i].imag >= -1e-12 * scale]
    keep.sort(key=lambda i: (round(float(w[i].real) / scale, 11), float(w[i].imag)))
    return Listing(_mode(complex(w[i]), left[:, i], right[:, i], names, nd) for i in keep)


def _mode(value: complex, left: ComplexArray, right: ComplexArray, names: tuple[str, ...], nd: int) -> Mode:
    displacement = right[nd:]
    pivot = displacement[int(np.argmax(np.abs(displacement)))]
    share = np.abs(left.conj() * right)
    share = np.concatenate([share[:nd] + share[nd : 2 * nd], share[2 * nd :]])
    total = float(share.sum()) or 1.0
    shape = {n: complex(entry / pivot) for n, entry in zip(names, displacement, strict=True)}
    return Mode(value, shape, {n: float(part / total) for n, part in zip(names, share, strict=True)})


def sort_eigenvalues(values: Any) -> ComplexArray:
    """Return the order of complex numbers by real, then imaginary part; real parts equal to rounding count as equal."""
    w = np.asarray(values, dtype=complex)
    scale = np.abs(w).max(initial=1e-300)
    order = np.lexsort((w.imag, np.round(w.real / scale, 11)))
    return w[order]
