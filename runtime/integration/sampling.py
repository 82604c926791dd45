"""The instants of sampled controllers, and what changes at them.

The outputs that a controller holds, its delayed outputs and its own state are internal states of laws, which jump at
the instants and are constant between them.  So every state of a motion holds all that is needed to continue from it.  A
motion that ends at an instant ends just before the jump, and one that starts at an instant begins with it.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from flexel.base.arrays import Array, Index
from flexel.base.nested import WITHIN
from flexel.model.controller import SAME, Controller, parts, read
from flexel.model.snapshot import Snapshot
from flexel.model.state import State
from flexel.model.structure import Structure

ROUNDING = 1e-15  # of a number of periods, relative
Completed = Callable[[], State]  # the complete state at an instant, computed if it is needed


@dataclass(frozen=True)
class Sampled:
    """A sampled controller and the places of its variables.

    Attributes
    ----------
    held, waiting, own : ndarray of int
        Places in z of the outputs, of the delayed outputs, and of the own state.
    inputs : ndarray of int or None
        Places of the inputs in (e, x, ė, v, z); None if one of them needs the complete state.
    """

    controller: Controller
    held: Index
    waiting: Index
    own: Index
    inputs: Index | None

    @classmethod
    def of(cls, structure: Structure, c: Controller) -> Sampled:
        """Return the controller with its indices in the structure."""
        held, waiting, own = (
            np.array([structure.internal[name] for name in names], dtype=np.intp)
            for names in (c.shown, c.waiting, c.own)
        )
        places = [_place(structure, name) for name in c.inputs]
        plain = None if None in places else np.array(places, dtype=np.intp)
        return cls(c, held, waiting, own, plain)

    @cached_property
    def phases(self) -> tuple[float, ...]:
        """Times within a period at which something changes [s]."""
        rest = self.controller.lag[1]
        return (0.0, rest) if rest else (0.0,)

    def next(self, t: float) -> float:
        """Return the first instant after t at which something changes."""
        T = self.controller.period
        assert T is not None
        periods = [(t - phase) / T for phase in self.phases]
        passed = [np.floor(count + SAME + ROUNDING * abs(count)) for count in periods]
        return float(min((count + 1.0) * T + phase for count, phase in zip(passed, self.phases, strict=True)))

    def due(self, t: float, phase: float) -> bool:
        """Whether something changes at t."""
        T = self.controller.period
        assert T is not None
        periods = (t - phase) / T
        return bool(abs(periods - round(periods)) <= SAME + ROUNDING * abs(periods))

    def jump(self, t: float, at: Snapshot, z: Array, complete: Completed, new: Array) -> None:
        """Put what changes at t into `new`; z are all internal states before."""
        c, rest = self.controller, self.controller.lag[1]
        if self.due(t, 0.0):
            if self.inputs is None:
                state = complete()
                y = np.array([read(state, name) for name in c.inputs])
            else:
                y = np.concatenate([at.e, at.x, at.ed, at.v, z])[self.inputs]
            with WITHIN:
                u, new[self.own] = c.advanced(t, y, z[self.own])
            size = u.size
            queue = np.concatenate([z[self.waiting], u])
            if not rest:
                new[self.held] = queue[:size]
            if self.waiting.size:
                new[self.waiting] = queue[size:]
        elif rest and self.due(t, rest):
            new[self.held] = z[self.waiting][: self.held.size]


def _place(structure: Structure, name: str) -> int | None:
    """Place of an input in (e, x, ė, v, z); None if it is not among them."""
    base, order = parts(name)
    m, n, slips = structure.m, structure.n, structure.k
    if base in structure.internal:
        return None if order else 2 * (m + n) + structure.internal[base]
    i = structure.find(base)
    if order not in (0, 1) or m <= i < m + slips:
        return None
    return (i if i < m else i - slips) + order * (m + n)


class Sampling:
    """All sampled controllers of a structure."""

    def __init__(self, structure: Structure) -> None:
        self.all = [Sampled.of(structure, c) for c in structure.controllers if c.period is not None]
        self._same = SAME * min(
            (c.period for c in structure.controllers if c.period is not None), default=0.0
        )

    def next(self, t: float) -> float:
        """Return the first instant after t; infinite without controllers."""
        return min((sampled.next(t) for sampled in self.all), default=np.inf)

    def stop(self, t: float, times: Array) -> float:
        """Return the first instant after t; a stored time that differs from it by rounding only is used instead.

        Otherwise a state could be stored just after an instant, and a motion that continues from it would sample again.
        """
        found = self.next(t)
        i = int(np.searchsorted(times, found))
        time: float
        for time in times[max(i - 1, 0) : i + 1].tolist():
            if time > t and abs(time - found) <= self._same + ROUNDING * abs(found):
                return time
        return found

    def due(self, t: float) -> bool:
        """Whether something changes at t."""
        return any(sampled.due(t, phase) for sampled in self.all for phase in sampled.phases)

    def after(self, at: Snapshot, z: Array, complete: Completed) -> Array:
        """Return the internal states just after an instant; all controllers measure just before it."""
        new = z.copy()
        for sampled in self.all:
            sampled.jump(at.t, at, z, complete, new)
        return new
