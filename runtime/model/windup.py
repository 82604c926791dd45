"""Anti-windup of controllers: what happens to their state while an output is beyond its limits."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Protocol

import numpy as np

from flexel.base.arrays import Array
from flexel.base.copies import Constant

Outputs = Callable[
    [Array], Array
]  # outputs (nu,) of an own state (nx,), at the same time and with the same inputs


class AntiWindup(Protocol):
    """A change of the state that depends on how far the outputs exceed their limits."""

    def __call__(self, x: Array, new: Array, excess: Array, outputs: Outputs) -> Array:
        """Return the state after an instant, or its rate (nx,).

        Parameters
        ----------
        x, new : ndarray (nx,)
            The state, and its next value or its rate by the rule.
        excess : ndarray (nu,)
            Outputs of the rule minus the limited ones.
        outputs : callable
            The outputs of the rule for another state.
        """
        ...


@dataclass(frozen=True)
class BackCalculation(Constant):
    """The limited outputs minus the outputs are fed back to the state, or to its rate, with gains (nx, nu)."""

    gains: Array

    def __call__(self, x: Array, new: Array, excess: Array, outputs: Outputs) -> Array:
        """See `AntiWindup`."""
        return new - self.gains @ excess


@dataclass(frozen=True)
class Clamping(Constant):
    """An integral part stops at an instant at which it would drive its output further beyond the limit.

    Attributes
    ----------
    parts : ndarray (nu, nx)
        Integral part of each output, from the state.
    states : ndarray (nx, nu)
        Change of the state for a change of these parts.
    """

    parts: Array
    states: Array

    def __call__(self, x: Array, new: Array, excess: Array, outputs: Outputs) -> Array:
        """See `AntiWindup`."""
        change = self.parts @ (new - x)
        return new - self.states @ np.where(change * excess > 0, change, 0.0)


@dataclass(frozen=True)
class Holding(Constant):
    """The whole state stops at an instant at which it would drive an output further beyond its limit."""

    def __call__(self, x: Array, new: Array, excess: Array, outputs: Outputs) -> Array:
        """See `AntiWindup`."""
        change = outputs(new) - outputs(x)
        return x if np.any(change * excess > 0) else new
