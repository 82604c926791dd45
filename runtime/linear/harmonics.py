"""Linear equations with periodic coefficients: Fourier series, harmonic balance, quasi-statics, Floquet multipliers.

The periodic coefficients of M q'' + C q' + K q = F are sampled at equidistant times and expanded in Fourier
series.  Source: Schwab and Meijaard, "SPACAR" (2004), harmonic balance: (2k+1) nd linear equations; Floquet (1883).
"""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np
from scipy.linalg import get_lapack_funcs

from flexel.base.arrays import Array, ComplexArray
from flexel.base.blas import one_thread
from flexel.base.errors import LinearizationError
from flexel.linear import floquet

_getrf: Any = get_lapack_funcs("getrf", dtype=np.float64)
_getrs: Any = get_lapack_funcs("getrs", dtype=np.float64)
_gecon: Any = get_lapack_funcs("gecon", dtype=np.float64)
SINGULAR_CONDITION = 1e-14  # reciprocal condition of the scaled balance below which it counts as singular
NEUTRAL = 1e-11  # singular values of the scaled balance, relative to the largest, that count as zero
NEUTRAL_RESIDUAL = 1e-8  # of a singular balance, relative to its right-hand side
FORCE_ROUNDING = 1e-14  # forces that are rounding errors, relative to those of a vibration of unit size


def fourier_sum(X: ComplexArray, omega: float, t: Array) -> tuple[Array, Array, Array]:
    """Return value, first and second rate (nt, nd) of Σ X_j exp(i j omega t), j = -k…k."""
    k = X.shape[0] // 2
    iw = 1j * omega * np.arange(-k, k + 1)
    E = np.exp(np.outer(t, iw))
    return (E @ X).real, (E @ (iw[:, None] * X)).real, (E @ ((iw**2)[:, None] * X)).real


def cosine_sine(series: Array, count: int) -> Array:
    """Return the Fourier coefficients [[a0, 0], [a1, b1], …] of one period: Σ a_j cos jωt + b_j sin jωt.

    Raises
    ------
    LinearizationError
        If the series is too short for this number of harmonics.
    """
    c = np.fft.rfft(series) / series.size
    if 2 * count >= series.size:
        raise LinearizationError(
            f"{count} harmonics need more than {2 * count} samples; there are {series.size}: take more samples"
        )
    pairs = np.column_stack([2 * c.real, -2 * c.imag])[: count + 1]
    pairs[0] = c[0].real, 0.0
    return pairs


def refined(series: Array, factor: int = 16) -> Array:
    """Resample one period `factor` times as densely by its Fourier series, to find extremes between the samples."""
    n = series.size
    c = np.fft.rfft(series)
    if n % 2 == 0:
        c[-1] /= 2  # half belongs to the negative frequency, which the longer series holds separately
    return np.asarray(np.fft.irfft(c, n * factor) * factor)


def spectrum(values: Array) -> ComplexArray:
    """Return the Fourier coefficients (ns, …) of real samples (ns, …) of one period, negative frequencies last."""
    ns = values.shape[0]
    half = np.fft.rfft(values, axis=0) / ns
    return np.concatenate([half, half[1 : ns - half.shape[0] + 1][::-1].conj()])


def _balance(
    M: ComplexArray, C: ComplexArray, K: ComplexArray, F: ComplexArray, omega: float, k: int
) -> tuple[Array, Array]:
    """Assemble matrix and right-hand sides of the real equations for Re X_0…Re X_k, then Im X_1…Im X_k.

    The forces are F (ns, nd, forces). The equations are the real parts of the balances of the harmonics 0…k, and the
    imaginary ones of 1…k, with the conjugates for the negative harmonics.
    """
    ns, nd = F.shape[:2]
    order = np.arange(-k, k + 1)
    iw, shift = (1j * omega * order)[:, None, None], (order[k:, None] - order) % ns
    A = (M[shift] * iw + C[shift]) * iw + K[shift]  # maps X_-k…X_k to the harmonics 0…k
    negative, positive = A[:, :k][:, ::-1], A[:, k + 1 :]
    by = np.concatenate([A[:, k : k + 1], positive + negative, 1j * (positive - negative)], axis=1)
    both = np.concatenate([by.real, by[1:].imag])
    size = (2 * k + 1) * nd
    rhs = np.concatenate([F[: k + 1].real, F[1 : k + 1].imag])
    return both.transpose(0, 2, 1, 3).reshape(size, size), rhs.reshape(size, -1)


def symmetric(parts: Array) -> ComplexArray:
    """Return X_-k…X_k from the real parts of X_0…X_k and the imaginary parts of X_1…X_k."""
    k = parts.shape[0] // 2
    X = parts[: k + 1].astype(complex)
    X[1:] += 1j * parts[k + 1 :]
    return np.concatenate([X[:0:-1].conj(), X])


def _smallest(matrix: Array, rhs: Array) -> Array | None:
    """Return the smallest solution of a singular balance; None if there is none."""
    size = np.abs(matrix).max(axis=1)
    scale = 1 / np.sqrt(np.maximum(size, NEUTRAL * size.max()))
    right = scale[:, None] * rhs
    scaled = scale[:, None] * matrix * scale
    found = np.linalg.lstsq(scaled, right, rcond=NEUTRAL)[0]
    off = np.abs(scaled @ found - right).max(initial=0.0)
    return scale[:, None] * found if off <= NEUTRAL_RESIDUAL * np.abs(right).max(initial=0.0) else None


@dataclass(frozen=True)
class Coefficients:
    """Periodic coefficients of M q'' + C q' + K q = F at equidistant times of one period.

    Attributes
    ----------
    omega : float
        Base frequency 2 pi / period [rad/s].
    M, C, K : ndarray (ns, nd, nd)
    F : ndarray (ns, nd)
    names : tuple of str
        The degrees of freedom.
    known : tuple of ndarray, optional
        The Fourier coefficients of M, C, K and F, if they are known already.
    second : int, optional
        Number of equations of second order, the first ones; all by default.  The others, of kinematic coordinates and
        internal states, give the rates of these: their rows of M are zero, and C is one there.
    """

    omega: float
    M: Array
    C: Array
    K: Array
    F: Array
    names: tuple[str, ...]
    known: tuple[ComplexArray, ...] | None = field(default=None, repr=False, compare=False)
    second: int | None = None

    @property
    def samples(self) -> int:
        """Number of times in the period."""
        return int(self.F.shape[0])

    @cached_property
    def spectra(self) -> tuple[ComplexArray, ...]:
        """Return the Fourier coefficients (ns, …) of M, C, K and F."""
        return self.known or tuple(spectrum(samples) for samples in (self.M, self.C, self.K, self.F))

    def series(self, name: str, harmonics: int) -> Array:
        """Return Fourier coefficients (harmonics + 1, 2, …) of M, C, K or F: cosine and sine parts of each entry."""
        value = getattr(self, name)
        columns = value.reshape(self.samples, -1).T
        found = np.array([cosine_sine(column, harmonics) for column in columns])
        return np.moveaxis(found, 0, -1).reshape(harmonics + 1, 2, *value.shape[1:])

    def harmonic_balance(self, harmonics: int, accuracy: float | None = None) -> PeriodicVibration:
        """Find the periodic solution with the given number of harmonics, by (2k+1) nd linear equations.

        Parameters
        ----------
        accuracy : float, optional
            Largest permitted amplitude of the neglected harmonics, relative to the largest amplitude.

        Raises
        ------
        LinearizationError
            Too few samples for the harmonics; a singular balance (a resonance without damping); too few harmonics
            for the accuracy; its attribute ``reached`` is the best solution.

        Notes
        -----
        Where kinematic coordinates enter no force, their means are as small as possible.
        """
        X = self.responses(harmonics, self.F)[0]
        found = self.vibration(X)
        check_accuracy(found, accuracy)
        return found

    def responses(self, harmonics: int, *forces: Array) -> ComplexArray:
        """Return Fourier coefficients (forces, 2 harmonics + 1, nd) of the responses to periodic forces (ns, nd)."""
        k, nd, ns = harmonics, self.F.shape[1], self.samples
        if k < 0 or ns < 4 * k + 1:
            raise LinearizationError(
                f"{k} harmonics need {4 * k + 1} samples of the coefficients; there are {ns}: take more samples"
            )
        M, C, K, own = self.spectra
        F = np.stack([own if force is self.F else spectrum(force) for force in forces], axis=-1)
        matrix, rhs = _balance(M, C, K, F, self.omega, k)
        with one_thread():
            parts = self._solve(matrix, rhs)
        return np.array([symmetric(column.reshape(2 * k + 1, nd)) for column in parts.T])

    def balanced(self, size: Array) -> bool:
        """Whether the forces F are rounding errors relative to those of a vibration of natural size (nd,)."""
        dynamic = sum(
            np.abs(samples).max(axis=0) * self.omega**power
            for power, samples in enumerate((self.K, self.C, self.M))
        )
        return bool(np.all(np.abs(self.F) <= FORCE_ROUNDING * (dynamic @ size)))

    def vibration(self, X: ComplexArray) -> PeriodicVibration:
        """Return the vibration with these Fourier coefficients (2k + 1, nd), with an estimate of its error."""
        return PeriodicVibration(self, X, self._neglected(X))

    def _solve(self, matrix: Array, rhs: Array) -> Array:
        """Solve the balance for the given columns, its rows and columns scaled by the diagonal."""
        # coordinates that enter no force, such as where a wheel is, leave their means open
        whole = None if self.second is None else matrix.copy()
        scale = 1 / np.sqrt(np.maximum(np.abs(matrix).max(axis=1), 1e-300))
        matrix *= scale[:, None] * scale
        norm = np.abs(matrix).sum(axis=1).max()
        # transposed, to match the memory layout
        lu, pivots, info = _getrf(matrix.T, overwrite_a=True)
        rcond = 0.0 if info else float(_gecon(lu, norm)[0])
        if not rcond > SINGULAR_CONDITION:
            neutral = None if whole is None else _smallest(whole, rhs)
            if neutral is not None:
                return neutral
            raise LinearizationError(
                f"harmonic balance at {self.omega:g} rad/s is singular: a resonance without damping, or a degree of "
                f"freedom without stiffness, among {', '.join(self.names)}; add damping, or omit this speed"
            )
        return np.asarray(scale[:, None] * _getrs(lu, pivots, scale[:, None] * rhs, trans=1)[0])

    def _neglected(self, X: ComplexArray) -> float:
        """Estimate the amplitude of the neglected harmonics: the response of the mean system to their residual."""
        k = X.shape[0] // 2
        w = PeriodicVibration(self, X, 0.0)
        q, qd, qdd = w.samples()
        r = self.F - sum(
            np.einsum("sij,sj->si", matrix, y) for matrix, y in ((self.M, qdd), (self.C, qd), (self.K, q))
        )
        j = np.arange(k + 1, (self.samples - 1) // 2 + 1)
        if not j.size:
            return 0.0
        R = np.fft.rfft(r, axis=0)[j] / self.samples
        s = 1j * self.omega * j[:, None, None]
        M, C, K = (samples.mean(axis=0) for samples in (self.M, self.C, self.K))
        driven = np.linalg.solve(s * s * M + s * C + K, R[..., None])[..., 0]
        return float(2 * np.abs(driven).max(axis=1).sum())

    def quasi_static(self) -> Array:
        """Solve K q = F (ns, nd) at every sampled time: the quasi-static response, without resonance."""
        try:
            return np.asarray(np.linalg.solve(self.K, self.F[..., None])[..., 0])
        except np.linalg.LinAlgError as error:
            raise LinearizationError(
                f"the stiffness at {self.omega:g} rad/s is singular: one of {', '.join(self.names)} has no stiffness"
            ) from error

    def floquet_multipliers(self, tolerance: float = 1e-9) -> ComplexArray:
        """Compute the eigenvalues of the transition matrix of (q_d', q) over one period, largest modulus first.

        If all are below one in modulus, small disturbances decay.

        Parameters
        ----------
        tolerance : float
            Error of the transition matrix; the steps are halved until its change is smaller.

        Raises
        ------
        LinearizationError
            If the tolerance is not met with the shortest steps.
        """
        return floquet.multipliers(self.omega, self.M, self.C, self.K, tolerance, self.second)


@dataclass(frozen=True)
class PeriodicVibration:
    """A periodic solution: q(t) = Σ X_j exp(i j omega t), j = -k…k.

    Attributes
    ----------
    coefficients : Coefficients
    X : ndarray of complex (2k + 1, nd)
    neglected : float
        Estimated amplitude of all neglected harmonics.
    """

    coefficients: Coefficients
    X: ComplexArray
    neglected: float

    @property
    def harmonics(self) -> int:
        """Number of harmonics k."""
        return int(self.X.shape[0] // 2)

    @property
    def error(self) -> float:
        """Estimated amplitude of the neglected harmonics, relative to the largest amplitude."""
        largest = float(2 * np.abs(self.X).max(initial=0.0))
        return self.neglected / largest if largest else 0.0

    def at(self, t: Array) -> tuple[Array, Array, Array]:
        """Return degrees of freedom, rates and accelerations (nt, nd) at times t (nt,) from the start of the period."""
        return fourier_sum(self.X, self.coefficients.omega, t)

    def samples(self) -> tuple[Array, Array, Array]:
        """Return the same at the sampled times of the coefficients."""
        ns, omega, k = self.coefficients.samples, self.coefficients.omega, self.harmonics
        if 2 * k >= ns:
            return self.at(np.asarray(np.arange(ns) * 2 * np.pi / (omega * ns)))
        iw = 1j * omega * np.arange(k + 1)[:, None]
        half = (self.X[k:] + self.X[k::-1].conj()) * (ns / 2)
        q, qd, qdd = np.fft.irfft(np.stack([half, iw * half, iw**2 * half]), ns, axis=1)
        return q, qd, qdd


def check_accuracy(vibration: PeriodicVibration, accuracy: float | None) -> None:
    """Raise a LinearizationError if the harmonics neglect more than is permitted, with the vibration as ``reached``."""
    if accuracy is None or vibration.error <= accuracy:
        return
    error = LinearizationError(
        f"{vibration.harmonics} harmonics at {vibration.coefficients.omega:g} rad/s neglect about "
        f"{vibration.error:.2g} of the largest amplitude; {accuracy:g} was requested: take more harmonics"
    )
    error.reached = vibration  # type: ignore[attr-defined]
    raise error
