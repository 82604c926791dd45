"""Runs user functions within an evaluation: a controller or a load may use the system it belongs to.

The function's computations must not overwrite the arrays of the evaluation that called it: each level has its arrays.
"""

from __future__ import annotations

import threading
from collections.abc import Callable
from types import TracebackType
from typing import Generic, TypeVar

from flexel.base.errors import ModelError

T = TypeVar("T")
MAX_DEPTH = 5  # levels; a function that calls itself through its system never ends


class _Here(threading.local):
    """Return how many user functions run in this thread, each called by the evaluation of the previous one."""

    depth = 0


_HERE = _Here()


class Within:
    """Provide a context in which a user function runs.

    Raises
    ------
    ModelError
        If functions call one another endlessly.
    """

    def __enter__(self) -> None:
        if _HERE.depth == MAX_DEPTH:
            raise ModelError(
                "the function endlessly evaluates the system that calls it; let it use a system without this function, "
                "built from another model"
            )
        _HERE.depth += 1

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        _HERE.depth -= 1


WITHIN = Within()


class Levels(Generic[T]):
    """An object for each thread and level, created when first needed."""

    def __init__(self, make: Callable[[], T]) -> None:
        self._make = make
        self._threads = threading.local()

    def present(self) -> T:
        """Return the object of this thread and level."""
        name = "first" if not _HERE.depth else f"level {_HERE.depth}"
        found: T | None = getattr(self._threads, name, None)
        if found is None:
            found = self._make()
            setattr(self._threads, name, found)
        return found
