"""Periodic coefficients as functions of the speed, obtained from three orbits if they are polynomials in the speed."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from flexel.base.arrays import Array, ComplexArray
from flexel.base.errors import LinearizationError
from flexel.linear.harmonics import Coefficients, spectrum
from flexel.linear.orbits import Orbit


@dataclass(frozen=True)
class SpeedFamily:
    """Coefficients of a nominal motion as polynomials in its speed: M; C0 + C1 ω; K, F of second degree.

    Exact where the prescribed motion depends on the phase ω t alone and damping is linear.
    """

    M: Array
    C: Array  # (2, ns, nd, nd)
    K: Array  # (3, ns, nd, nd)
    F: Array  # (3, ns, nd)
    names: tuple[str, ...]

    @classmethod
    def through(cls, orbits: Sequence[Orbit]) -> SpeedFamily:
        """Fit the family to three orbits that differ only in their speed.

        Raises
        ------
        LinearizationError
            The periods are not three different ones, or the coefficients are not such polynomials.
        """
        if len({orbit.period for orbit in orbits}) != 3 or len(orbits) != 3:
            raise LinearizationError("a family of speeds needs three orbits of three different periods")
        w = np.array([orbit.coefficients.omega for orbit in orbits])
        V = np.linalg.inv(np.vander(w, 3, increasing=True))
        M, C, K, F = (
            np.array([getattr(orbit.coefficients, n) for orbit in orbits]) for n in ("M", "C", "K", "F")
        )
        polynomial = [np.tensordot(V, samples, axes=1) for samples in (C, K, F)]
        for name, off, of in (("M", M - M[0], M), ("C", polynomial[0][2] * w.max() ** 2, C)):
            if np.abs(off).max(initial=0.0) > 1e-7 * np.abs(of).max(initial=1e-300):
                raise LinearizationError(
                    f"a family of speeds: {name} is not a polynomial in the speed; the prescribed motion must depend "
                    "on the phase alone"
                )
        return cls(M[0], polynomial[0][:2], polynomial[1], polynomial[2], orbits[0].coefficients.names)

    def at(self, omega: float) -> Coefficients:
        """Evaluate the coefficients at a speed [rad/s], which must be positive."""
        if not 0 < omega < np.inf:
            raise LinearizationError(f"a speed of {omega:g} rad/s has no period; give positive speeds")
        C, K, F = (_at(polynomial, omega) for polynomial in (self.C, self.K, self.F))
        M, *others = self._spectra
        return Coefficients(
            omega, self.M, C, K, F, self.names, known=(M, *(_at(polynomial, omega) for polynomial in others))
        )

    @cached_property
    def _spectra(self) -> list[ComplexArray]:
        """Compute the Fourier coefficients of M (ns, nd, nd), and of the polynomial coefficients of C, K and F."""
        return [
            spectrum(self.M),
            *(np.array([spectrum(y) for y in samples]) for samples in (self.C, self.K, self.F)),
        ]


def _at(polynomial: Any, omega: float) -> Any:
    """Evaluate a polynomial with arrays as coefficients (degree + 1, …)."""
    powers = omega ** np.arange(len(polynomial))
    return (powers @ polynomial.reshape(len(polynomial), -1)).reshape(polynomial.shape[1:])
