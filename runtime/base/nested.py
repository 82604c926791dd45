"""Functions of the user that run within an evaluation: a controller or a load may use the system that it belongs to.

What the function computes must not overwrite the arrays of the evaluation that has called it: each level has its own.
"""

from __future__ import annotations

import threading
from collections.abc import Callable
from types import TracebackType
from typing import Generic, TypeVar

from flexel.base.errors import ModelError

T = TypeVar("T")
DEEPEST = 5  # levels: a function that calls itself by way of its system has no end


class _Here(threading.local):
    """How many functions of the user run in this thread, each called by the evaluation of the one before."""

    depth = 0


_HERE = _Here()


class Within:
    """A context in which a function of the user runs.

    Raises
    ------
    ModelError
        Where functions call one another without end.
    """

    def __enter__(self) -> None:
        if _HERE.depth == DEEPEST:
            raise ModelError(
                "the function evaluates the system that calls it, without end; let it use a system without this "
                "function, built from another model"
            )
        _HERE.depth += 1

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        _HERE.depth -= 1


WITHIN = Within()


class Levels(Generic[T]):
    """An object for each thread and level, made when it is first needed."""

    def __init__(self, make: Callable[[], T]) -> None:
        self._make = make
        self._threads = threading.local()

    def present(self) -> T:
        """The object of this thread and level."""
        name = "first" if not _HERE.depth else f"level {_HERE.depth}"
        found: T | None = getattr(self._threads, name, None)
        if found is None:
            found = self._make()
            setattr(self._threads, name, found)
        return found
