"""The motion of one variant of a system, with its start."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from flexel.analyses.motions import Motions
from flexel.analyses.variants import Values
from flexel.base.arrays import Array
from flexel.integration.driver import Run
from flexel.results.motion import Motion
from flexel.structure.state import State


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

    def __call__(self, system: Motions, i: int) -> Motion:
        """The motion of variant number i, alone."""
        return system.simulate(self.duration, start=self._first(system, i), progress=False, **self._options)

    def begun(self, system: Motions, i: int, before: Run | None) -> tuple[Run, str]:
        """Begin the motion; reuses the arrays of an earlier motion of the same system."""
        return system._begun(self.duration, before, start=self._first(system, i), **self._options)

    @property
    def _options(self) -> dict[str, Any]:
        return {"times": self.times, **self.options}

    def _first(self, system: Motions, i: int) -> State:
        return _start(system, self.start, {z: float(rows[i]) for z, rows in self.values.initial.items()})


def _start(system: Motions, start: State | None, initial: Mapping[str, float]) -> State:
    """The start of a variant: the initial state, or another one with its own forces, with given values and rates."""
    first = system.initial if start is None else system.state(start.t, start.x, start.v, start.e, start.z)
    if not initial:
        return first
    rates = {name[:-1]: z for name, z in initial.items() if name.endswith("'")}
    values = {name: z for name, z in initial.items() if not name.endswith("'")}
    return system.state_at(values, rates or None, start=first)
