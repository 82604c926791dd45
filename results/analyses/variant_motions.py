"""The motion of one variant of a system, with its start."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from flexel.base.arrays import Array
from flexel.integration.driver import Run
from flexel.integration.simulation import Preparation, begun
from flexel.model.state import State
from flexel.results.analyses.motions import simulate
from flexel.results.analyses.variant_runs import Values
from flexel.results.motion import Motion
from flexel.system import CoreSystem


@dataclass(frozen=True)
class MotionOf:
    """The motion of a variant.

    Attributes
    ----------
    duration : float
        [s].
    times : ndarray (nt,)
        Times at which states are stored [s].
    start : State or None
        The initial state of each variant by default.
    values : Values
        Parameters and initial values.
    options : mapping
        Method, tolerances and steps, as in `simulate`.
    """

    duration: float
    times: Array
    start: State | None
    values: Values
    options: Mapping[str, Any]

    def __call__(self, system: CoreSystem, i: int) -> Motion:
        """Compute the motion of variant number i, alone."""
        return simulate(system, self.duration, start=self._first(system, i), progress=False, **self._options)

    def begun(self, system: CoreSystem, i: int, before: Run | None) -> Preparation:
        """Begin the motion; reuses the arrays of an earlier motion of the same system."""
        return begun(system, self.duration, before, start=self._first(system, i), **self._options)

    @property
    def _options(self) -> dict[str, Any]:
        return {"times": self.times, **self.options}

    def _first(self, system: CoreSystem, i: int) -> State:
        return _start(
            system, self.start, {name: float(rows[i]) for name, rows in self.values.initial.items()}
        )


def _start(system: CoreSystem, start: State | None, initial: Mapping[str, float]) -> State:
    """Return the start of a variant: the initial state, or another one, with its forces and given values."""
    first = system.initial if start is None else system.state(start.t, start.x, start.v, start.e, start.z)
    if not initial:
        return first
    rates = {name[:-1]: value for name, value in initial.items() if name.endswith("'")}
    values = {name: value for name, value in initial.items() if not name.endswith("'")}
    return system.state_at(values, rates or None, start=first)
