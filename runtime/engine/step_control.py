"""How the length of a step follows from its error: one rule for all methods, with the numbers of each.

Source: Hairer, Norsett and Wanner (1993), II.4; Hairer and Wanner (1996), IV.8.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import inf, isfinite
from typing import Any

SAFETY = 0.9  # factor of the length that the error asks for
LEAST = 0.2  # factor of a step that is refused, at least


@dataclass(frozen=True)
class StepControl:
    """The rule of a method; errors are relative to what is allowed.

    Attributes
    ----------
    order : float
        The error of a step grows with its length to this power.
    most : float
        Largest factor of the length of an accepted step.
    steady : float
        Factor up to which a longer step is not worth what its change costs.
    unusable : float
        Factor of a trial whose error is not known.
    """

    order: float
    most: float
    steady: float = 1.0
    unusable: float = 0.5

    def shorter(self, error: float = inf) -> float:
        """Return the factor of the next trial after one that was refused; without its error if it is of no use."""
        return max(LEAST, SAFETY * error ** (-1 / self.order)) if isfinite(error) else self.unusable

    def longer(self, error: float) -> float:
        """Return the factor of the next step after one that was accepted."""
        factor = min(self.most, SAFETY * error ** (-1 / self.order)) if error > 0 else self.most
        return 1.0 if 1.0 < factor < self.steady else factor

    def give(self, struct: Any) -> None:
        """Write the numbers into a struct of step_control.h."""
        struct.safety, struct.least = SAFETY, LEAST
        for name, value in vars(self).items():
            setattr(struct, name, value)
