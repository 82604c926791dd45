"""One instant of a motion: coordinates, rates and deformations, without accelerations and forces."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from flexel.base.arrays import Array
from flexel.model.state import State


@dataclass(frozen=True)
class Snapshot:
    """Positions and rates at one instant of a motion: the start of the search for a nearby state and its turns."""

    t: float
    x: Array
    v: Array
    e: Array
    ed: Array

    @staticmethod
    def of(state: State) -> Snapshot:
        """Return the instant of a complete state."""
        return Snapshot(state.t, state.x, state.v, state.e, state.rates[: state.e.size])

    def turns(self, t: float) -> Array:
        """Extrapolate the deformations (m,) to another time with the current rates, for counting turns of angles."""
        return self.e + (t - self.t) * self.ed

    def still(self, t: float) -> Snapshot:
        """Return the same position at another time, without rates: for finding the nearest configuration."""
        none = np.zeros_like
        return Snapshot(t, self.x, none(self.v), self.e, none(self.ed))
