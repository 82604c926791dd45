"""Small matrices in one thread: the threads of BLAS would wait for one another longer than they gain.

Measured with two processors, choosing degrees of freedom of a vehicle (187 coordinates): 20 ms in one thread; with two
21 ms on an idle machine, 150 to 600 ms on a busy one, and 870 ms each from eight threads at once, instead of 15 ms.
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cached_property
from threading import Lock, local
from typing import Any

from threadpoolctl import ThreadpoolController


class _Limit:
    """The limit of one thread, valid from the first caller that enters it until the last one leaves."""

    def __init__(self) -> None:
        self._lock = Lock()
        self._users = 0
        self._here = local()  # how many of them are in this thread
        self._set: Any = None

    @cached_property
    def _controller(self) -> Any:
        """The libraries that are loaded at first use, listed once: this takes 8 ms, and a limit 0.02 ms."""
        return ThreadpoolController()

    def threads(self) -> list[int]:
        """The number of threads of each of these libraries."""
        return [z["num_threads"] for z in self._controller.info() if z["user_api"] == "blas"]

    def renew(self) -> None:
        """In a forked child, only the forking thread remains, and no other holds the lock."""
        self._lock = Lock()
        self._users = getattr(self._here, "users", 0)

    @contextmanager
    def __call__(self) -> Iterator[None]:
        """BLAS works in the calling thread in this context; the earlier setting is restored after it."""
        with self._lock:
            if not self._users:
                self._set = self._controller.limit(limits=1, user_api="blas")
            self._users += 1
        self._here.users = getattr(self._here, "users", 0) + 1
        try:
            yield
        finally:
            self._here.users -= 1
            with self._lock:
                self._users -= 1
                if not self._users:
                    self._set.restore_original_limits()


LIMIT = _Limit()
one_thread = LIMIT.__call__
if hasattr(os, "register_at_fork"):  # not on Windows, which does not fork
    os.register_at_fork(after_in_child=LIMIT.renew)
