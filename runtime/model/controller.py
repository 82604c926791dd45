"""Controllers of a model: their inputs and outputs, rule, limits, period and delay."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property
from typing import Protocol

import numpy as np

from flexel.base.arrays import Array
from flexel.base.copies import Constant
from flexel.base.errors import LinearizationError
from flexel.model.rules import Rule
from flexel.model.windup import AntiWindup

SAME = 1e-9  # of a period: times that close are one instant
LIMIT_TOLERANCE = 1e-12  # relative


class MeasuredState(Protocol):
    """The values that are read from the state of a mechanism."""

    @property
    def t(self) -> float:
        """Time [s]."""
        ...

    def __getitem__(self, name: str) -> float:
        """Return the value of a quantity or internal state."""
        ...

    def rate(self, name: str) -> float:
        """Return the rate of a quantity."""
        ...

    def acceleration(self, name: str) -> float:
        """Return the second rate of a quantity."""
        ...

    def force(self, name: str) -> float:
        """Return the stress or reaction of a quantity."""
        ...


@dataclass(frozen=True)
class Controller(Constant):
    """A controller: u, x = rule(t, y, x), u within its limits; continuous or sampled.

    Attributes
    ----------
    name : str
    inputs, outputs : tuple of str
        As the user named them: histories, and the quantities on which forces act.
    rule : Rule
    low, high : ndarray (nu,)
        Limits of the outputs; infinite for none.
    period : float or None
        [s]; None for a continuous one.
    delay : float
        From an instant to the change of the outputs [s].
    windup : AntiWindup or None
        What happens to its state while an output is beyond its limits.
    """

    name: str
    inputs: tuple[str, ...]
    outputs: tuple[str, ...]
    rule: Rule
    low: Array
    high: Array
    period: float | None = None
    delay: float = 0.0
    windup: AntiWindup | None = None

    @property
    def owner(self) -> str:
        """Beginning of messages."""
        return f"controller '{self.name}'"

    @cached_property
    def shown(self) -> tuple[str, ...]:
        """Names of the outputs in results: ``name.u``, or ``name.u0``, ``name.u1``, … of several."""
        return tuple(f"{self.name}.{output}" for output in numbered("u", len(self.outputs)))

    @cached_property
    def own(self) -> tuple[str, ...]:
        """Names of its states, ``name.x0``, ``name.x1``, …"""
        return tuple(f"{self.name}.x{i}" for i in range(self.rule.nx))

    @cached_property
    def waiting(self) -> tuple[str, ...]:
        """Names of the delayed outputs, ``name.next0``, …, in the order in which they take effect."""
        return tuple(f"{self.name}.next{i}" for i in range(self.slots * len(self.outputs)))

    @cached_property
    def lag(self) -> tuple[int, float]:
        """The delay in whole periods, and the rest [s]."""
        assert self.period is not None
        whole = int(np.floor(self.delay / self.period + SAME))
        rest = self.delay - whole * self.period
        return whole, rest if rest > SAME * self.period else 0.0

    @property
    def slots(self) -> int:
        """Largest number of instants whose outputs are delayed at once."""
        if self.period is None:
            return 0
        whole, rest = self.lag
        return whole + (rest > 0)

    @property
    def limits(self) -> bool:
        """Whether an output has a limit."""
        return bool(np.isfinite([self.low, self.high]).any())

    def limited(self, u: Array) -> Array:
        """Limit the outputs."""
        return np.minimum(np.maximum(u, self.low), self.high)

    def advanced(self, t: float, y: Array, x: Array) -> tuple[Array, Array]:
        """Return the limited outputs (nu,), and the state after the instant or its rate (nx,)."""
        u, new = self.rule(t, y, x)
        limited = self.limited(u)
        if self.windup is not None and np.any(u != limited):
            new = self.windup(x, new, u - limited, lambda other: self.rule(t, y, other)[0])
        return limited, new

    def measured(self, state: MeasuredState) -> Array:
        """Return the inputs (ny,) at a state."""
        return np.array([read(state, name) for name in self.inputs])

    def remembered(self, state: MeasuredState) -> Array:
        """Return the controller's state (nx,) at a state of the mechanism."""
        return np.array([state[name] for name in self.own])

    def outputs_at(self, state: MeasuredState) -> Array:
        """Return the outputs (nu,) of a continuous controller at a state."""
        return self.advanced(state.t, self.measured(state), self.remembered(state))[0]

    def slopes(self, state: MeasuredState) -> Array:
        """Return the derivatives (nu + nx, ny + nx) of outputs and state, or its rate, by inputs and state.

        Raises
        ------
        LinearizationError
            If it is not smooth there, or an output is at its limit.
        """
        given = state.t, self.measured(state), self.remembered(state)
        u = self.rule(*given)[0]
        slack = LIMIT_TOLERANCE * (1 + np.abs(u))
        for name, value, low, high, small in zip(self.outputs, u, self.low, self.high, slack, strict=True):
            if value <= low + small or value >= high - small:
                raise LinearizationError(
                    f"{self.owner}: its output on '{name}' is at its limit ({low:g} … {high:g}) at t = {state.t:g} s, "
                    "so it has no linearization there; linearize about a state in which it is within its limits"
                )
        return self.rule.smooth_slopes(*given)


def refuse_sampled(controllers: Iterable[Controller], owner: str, instead: str) -> None:
    """Refuse an analysis that has no meaning for sampled controllers; names the first of them."""
    for c in controllers:
        if c.period is not None:
            raise LinearizationError(f"{owner}: {c.owner} is sampled (period {c.period:g} s); {instead}")


def check_smooth(controllers: Iterable[Controller], state: MeasuredState) -> None:
    """Raise if a continuous controller has no linearization at a state."""
    for c in controllers:
        if c.period is None:
            c.slopes(state)


def numbered(letter: str, size: int) -> tuple[str, ...]:
    """Return the letter for one quantity, and the letter with numbers for several."""
    return (letter,) if size == 1 else tuple(f"{letter}{i}" for i in range(size))


def parts(name: str) -> tuple[str, int]:
    """Split the name of a history into the quantity and its order: 0 to 2 primes, -1 for a force."""
    base = name.removeprefix("force:")
    if base != name:
        return base, -1
    return base.rstrip("'"), len(base) - len(base.rstrip("'"))


def read(state: MeasuredState, name: str) -> float:
    """Return the value of a history at a state."""
    base, order = parts(name)
    if order == -1:
        return state.force(base)
    return (state.__getitem__, state.rate, state.acceleration)[order](base)
