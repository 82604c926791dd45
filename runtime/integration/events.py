"""Events: zero crossings of functions of the state."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import Any

import numpy as np

from flexel.base.arguments import flag, number, text
from flexel.base.copies import Constant, check_travels
from flexel.base.errors import ModelError
from flexel.base.nested import WITHIN
from flexel.model.state import State


@dataclass(frozen=True)
class Event(Constant):
    """An event: a zero crossing of a function of the state.

    Parameters
    ----------
    name : str
    function : callable(State) -> float or bool
        A condition counts as 1 where it holds, and as -1 where it does not.
    terminal : bool
        Stop the simulation there.
    direction : int
        +1: only upward crossings; -1: only downward; 0: both.

    Notes
    -----
    A motion that starts at an event, for example from its state, does not trigger it again immediately.

    The function is evaluated once per step while it is further from zero than it would move in the step at the
    fastest rate of the last few steps, and inside the step otherwise. Two crossings in one step are found if the
    function is continuous and its size has a single minimum between them and the samples around them, at quarters
    of the step and near its ends. A function that only touches zero does not cross it. A function that jumps, such
    as one that is 1 within a gate and -1 elsewhere, may be missed: give a distance that changes sign, or a
    `max_step` shorter than the passage.
    """

    name: str
    function: Callable[[State], float | bool]
    terminal: bool = False
    direction: int = 0

    def __post_init__(self) -> None:
        owner = f"event '{text(self.name, 'event', 'name')}'"
        flag(self.terminal, owner, "terminal")
        if not callable(self.function) or isinstance(self.function, type):
            raise ModelError(
                f"event '{self.name}': {self.function!r} is not a function; give one of a State, lambda s: s['A.z']"
            )
        if (
            isinstance(self.direction, bool)
            or not isinstance(self.direction, int)
            or self.direction not in (-1, 0, 1)
        ):
            raise ModelError(
                f"event '{self.name}': direction {self.direction!r} is unknown; give 1 (up), -1 (down) or 0 (both)"
            )

    def __getstate__(self) -> dict[str, Any]:
        """Return the fields; raise a ModelError that names the event if its function cannot be pickled."""
        check_travels(f"event '{self.name}'", self.function)
        return super().__getstate__()


def checked(events: Any) -> tuple[Event, ...]:
    """Return the user's events, or raise a ModelError."""
    listed = tuple(events) if isinstance(events, Iterable) else None
    if listed is None or not all(isinstance(event, Event) for event in listed):
        raise ModelError(
            f"simulate: events {events!r} are not a list of Events; write [Event(name, function)]"
        )
    return listed


def value(event: Event, state: State) -> float:
    """Return the function of an event at a state."""
    owner = f"event '{event.name}' at t = {state.t:g} s"
    try:
        with WITHIN:
            found = event.function(state)
    except RecursionError as error:
        raise ModelError(f"{owner}: its function calls itself endlessly; correct it") from error
    if isinstance(found, bool | np.bool_):
        return 1.0 if found else -1.0
    return number(found, owner, "value")
