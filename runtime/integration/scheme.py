"""The generalized-alpha scheme: its coefficients.

Source: Chung and Hulbert (1993); Jansen, Whiting and Hulbert (2000) for first order; Arnold and Brüls (2007).
"""

from __future__ import annotations

from dataclasses import dataclass

from flexel.base.arguments import number
from flexel.base.errors import ModelError


@dataclass(frozen=True)
class Scheme:
    """Coefficients of the generalized-alpha method with a given spectral radius at infinite frequency."""

    alpha_m: float
    alpha_f: float
    beta: float
    gamma: float
    lag_m: float
    lag_gamma: float

    @classmethod
    def with_radius(cls, radius: float, constrained: bool = True) -> Scheme:
        """Return the optimal scheme of second order; radius 1 conserves energy, 0 damps high frequencies at once.

        Radius 1 needs a system without constraints: with them its accelerations and multipliers grow without bound.
        """
        radius = number(radius, "simulate", "spectral_radius")
        if not (0 <= radius < 1 or (radius == 1 and not constrained)):
            raise ModelError(
                f"simulate: spectral_radius {radius} lies outside 0 ≤ radius < 1 (1 without constraints); 0.8 is a "
                "good value"
            )
        m, f = (2 * radius - 1) / (radius + 1), radius / (radius + 1)
        gamma = 0.5 - m + f
        lag = (3 * radius - 1) / (2 * (radius + 1))
        return cls(m, f, 0.25 * (gamma + 0.5) ** 2, gamma, lag, 0.5 - lag + f)
