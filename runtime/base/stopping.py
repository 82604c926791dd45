"""Handles Ctrl-C in long tasks whose parts may handle a `KeyboardInterrupt` themselves."""

from __future__ import annotations

import signal
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType


class StoppedError(BaseException):
    """Ctrl-C within `stopping`; not a `KeyboardInterrupt`, upon which analyses of variants return partial results."""


@contextmanager
def stopping() -> Iterator[None]:
    """Make Ctrl-C raise `StoppedError`, through all functions that would otherwise return partial results.

    Signals reach only the main thread; in any other thread this does nothing.
    """

    def stop(number: int, frame: FrameType | None) -> None:
        raise StoppedError

    if threading.current_thread() is not threading.main_thread():
        yield
        return
    before = signal.signal(signal.SIGINT, stop)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, before)
