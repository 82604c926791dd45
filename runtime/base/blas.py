"""Runs small matrix operations in one thread, because the threads of BLAS wait longer for one another than they gain.

Measured with two processors, choosing degrees of freedom of a vehicle (187 coordinates): 20 ms in one thread; with two
21 ms on an idle machine, 150 to 600 ms on a busy one, and 870 ms each from eight threads at once, instead of 15 ms.
Every analysis that a user calls is one of these: `in_one_thread` stands at its door.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import cached_property, wraps
from threading import Lock, local
from typing import Any, ParamSpec, TypeVar

from threadpoolctl import ThreadpoolController

P = ParamSpec("P")
R = TypeVar("R")


class _Limit:
    """A limit of one thread, in force from the first caller that enters it until the last one leaves."""

    def __init__(self) -> None:
        self._lock = Lock()
        self._users = 0
        self._here = local()  # number of callers in this thread
        self._before: list[int] = []  # threads of each library outside

    @cached_property
    def _libraries(self) -> list[Any]:
        """The libraries loaded at first use, listed once: this takes 8 ms, and a limit takes 0.002 ms."""
        return [library for library in ThreadpoolController().lib_controllers if library.user_api == "blas"]

    @property
    def active(self) -> bool:
        """Whether a caller has entered it."""
        return self._users > 0

    def threads(self) -> list[int]:
        """Return the number of threads of each library."""
        return [library.get_num_threads() for library in self._libraries]

    def _set(self, threads: list[int]) -> None:
        """Set the number of threads of each library; newer threadpoolctl lets one thread of the process do so."""
        for library, number in zip(self._libraries, threads, strict=True):
            released = getattr(library, "clear_controlling_thread", lambda force: None)
            released(force=True)
            library.set_num_threads(number)
            released(force=True)

    def renew(self) -> None:
        """Reset the lock in a forked child, where only the forking thread remains."""
        self._lock = Lock()
        self._users = getattr(self._here, "users", 0)

    @contextmanager
    def __call__(self) -> Iterator[None]:
        """Run BLAS in the calling thread within this context; restore the earlier setting afterwards."""
        with self._lock:
            if not self._users:
                self._before = self.threads()
                self._set([1] * len(self._before))
            self._users += 1
        self._here.users = getattr(self._here, "users", 0) + 1
        try:
            yield
        finally:
            self._here.users -= 1
            with self._lock:
                self._users -= 1
                if not self._users:
                    self._set(self._before)


LIMIT = _Limit()
one_thread = LIMIT.__call__


def in_one_thread(function: Callable[P, R]) -> Callable[P, R]:
    """Let a function, with all that it calls, run BLAS in one thread."""

    @wraps(function)
    def limited(*args: P.args, **options: P.kwargs) -> R:
        with LIMIT():
            return function(*args, **options)

    return limited


if hasattr(os, "register_at_fork"):  # not on Windows, which does not fork
    os.register_at_fork(after_in_child=LIMIT.renew)
