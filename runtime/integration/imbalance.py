"""The error of the energy balance of a motion, and what its method may leave."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

STEPS = 100  # that errors are allowed for; more steps may have larger ones
PROMISED = 100.0  # errors of the energy that moves, in local tolerances, that are no surprise
KINKS = 1000.0  # the same where forces have kinks within steps, whose errors their estimates do not know
ROUGH, LEAST = 0.01, 1e-6  # errors up to which kinks may be the reason, and below which nothing is said
ROUNDING = 1e-13  # of energies, relative to the largest ones, in a few hundred steps
AT_REST = 1e-20  # energy that moves, relative to what is stored, below which nothing moves


def explained(tolerance: float, steps: int) -> float:
    """Return the relative error of the energy balance that a local tolerance explains."""
    kinks = min(KINKS * tolerance, ROUGH)
    return max(PROMISED * tolerance, kinks, LEAST) * max(steps / STEPS, 1.0)


@dataclass(frozen=True)
class Imbalance:
    """The energy balance of a motion [J].

    Attributes
    ----------
    missing : float
        Its largest error.
    moved : float
        Largest kinetic energy, or what was dissipated and supplied if that is more.
    allowed : float
        Error that tolerance, rounding and the integration of powers explain.
    when : float
        Time [s] at the end of the step in which most was missing.
    covered : float
        Largest range of a coordinate, in its natural scale; not known where it is infinite.
    """

    missing: float
    moved: float
    allowed: float
    when: float
    covered: float = np.inf

    @property
    def fails(self) -> bool:
        """Whether something else has gone wrong."""
        return not self.missing <= self.allowed

    def __str__(self) -> str:
        if not self.moved:
            seen = 0 < self.covered < np.inf
            return "nothing has moved" + f" by more than {self.covered:.1g} of the model's size" * seen
        return f"energy balance within {self.missing:.1g} of {self.moved:.3g} J"
