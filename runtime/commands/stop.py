"""Shared handling of Ctrl-C in commands."""

import signal
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType

INTERRUPTED = 130  # exit status of a program that was interrupted: 128 and the number of the signal


class StoppedError(BaseException):
    """Ctrl-C in `stopping`; not a `KeyboardInterrupt`, which a simulation answers with the motion up to there."""


@contextmanager
def stopping() -> Iterator[None]:
    """Let Ctrl-C raise `StoppedError`, through everything that would keep a part of its results."""

    def stop(number: int, frame: FrameType | None) -> None:
        raise StoppedError

    before = signal.signal(signal.SIGINT, stop)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, before)
