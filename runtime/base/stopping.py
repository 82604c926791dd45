"""Ctrl-C in long work that consists of parts, each of which would answer a `KeyboardInterrupt` itself."""

from __future__ import annotations

import signal
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType


class StoppedError(BaseException):
    """Ctrl-C in `stopping`; not a `KeyboardInterrupt`, which a simulation answers with the motion up to there."""


@contextmanager
def stopping() -> Iterator[None]:
    """Let Ctrl-C raise `StoppedError`, through everything that would keep a part of its results.

    Signals reach only the main thread; in any other this does nothing.
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
