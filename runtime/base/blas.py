"""Runs small matrix operations in one thread, because the threads of BLAS wait longer for one another than they gain.

Measured with two processors, choosing degrees of freedom of a vehicle (187 coordinates): 20 ms in one thread; with two
21 ms on an idle machine, 150 to 600 ms on a busy one, and 870 ms each from eight threads at once, instead of 15 ms.
Every analysis that a user calls is one of these, and has the decorator `in_one_thread`.
"""

from __future__ import annotations

import ctypes
import os
from collections.abc import Callable
from functools import cached_property, wraps
from threading import Lock, local
from typing import Any, ParamSpec, TypeVar

from threadpoolctl import ThreadpoolController

P = ParamSpec("P")
R = TypeVar("R")
Getter = Callable[[], int]
Setter = Callable[[int], Any]
# Of OpenBLAS in wheels.
AFFIXES = [(prefix, suffix) for prefix in ("", "scipy_") for suffix in ("", "64_", "_64")]


def _functions(library: Any) -> tuple[Getter, Setter]:
    """Return the functions that read and set the number of threads of a library.

    Those of threadpoolctl look for the names of OpenBLAS in each call, which takes 0.02 ms, and newer ones let only one
    thread of the process set the number.
    """
    for prefix, suffix in AFFIXES:
        names = [f"{prefix}openblas_{what}_num_threads{suffix}" for what in ("get", "set")]
        if library.internal_api == "openblas" and all(hasattr(library.dynlib, name) for name in names):
            own = ctypes.PyDLL(library.filepath)  # keeps the interpreter's lock in such short calls
            return getattr(own, names[0]), getattr(own, names[1])
    return library.get_num_threads, library.set_num_threads


class _Limit:
    """A limit of one thread, in force from the first thread that enters it until the last one leaves."""

    def __init__(self) -> None:
        self._lock = Lock()
        self._users = 0  # threads within it
        self._here = local()  # how often this thread has entered it
        self._before: list[int] = []  # threads of each library outside

    @cached_property
    def _libraries(self) -> list[tuple[Getter, Setter]]:
        """The libraries loaded at first use, listed once: this takes 8 ms, and a limit a few microseconds."""
        found = ThreadpoolController().lib_controllers
        return [_functions(library) for library in found if library.user_api == "blas"]

    @property
    def active(self) -> bool:
        """Whether a thread has entered it."""
        return self._users > 0

    def threads(self) -> list[int]:
        """Return the number of threads of each library."""
        return [read() for read, _ in self._libraries]

    def renew(self) -> None:
        """Reset the lock in a forked child, where only the forking thread remains."""
        self._lock = Lock()
        self._users = int(getattr(self._here, "users", 0) > 0)

    def __enter__(self) -> None:
        """Run BLAS in the calling thread."""
        users = self._here.__dict__.get("users", 0)
        if not users:
            with self._lock:
                if not self._users:
                    self._before = self.threads()
                    for (_, write), number in zip(self._libraries, self._before, strict=True):
                        if number != 1:
                            write(1)
                self._users += 1
        self._here.users = users + 1

    def __exit__(self, *exception: object) -> None:
        """Restore the earlier setting when the last thread leaves."""
        self._here.users -= 1
        if not self._here.users:
            with self._lock:
                self._users -= 1
                if not self._users:
                    for (_, write), number in zip(self._libraries, self._before, strict=True):
                        if number != 1:
                            write(number)


LIMIT = _Limit()


def one_thread() -> _Limit:
    """Return the limit as a context, in which BLAS runs in the calling thread."""
    return LIMIT


def in_one_thread(function: Callable[P, R]) -> Callable[P, R]:
    """Let a function, with all that it calls, run BLAS in one thread."""

    @wraps(function)
    def limited(*args: P.args, **options: P.kwargs) -> R:
        with LIMIT:
            return function(*args, **options)

    return limited


if hasattr(os, "register_at_fork"):  # not on Windows, which does not fork
    os.register_at_fork(after_in_child=LIMIT.renew)
