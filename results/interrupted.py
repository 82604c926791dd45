"""The exception raised by Ctrl-C during a simulation."""

from __future__ import annotations

from flexel.results.motion import Motion


class Interrupted(KeyboardInterrupt):  # noqa: N818 - not an error
    """Ctrl-C during a simulation.

    Attributes
    ----------
    motion : Motion
        The motion up to that point.
    """

    def __init__(self, message: str, motion: Motion) -> None:
        super().__init__(message)
        self.motion = motion

    def __reduce__(self) -> tuple[type[Interrupted], tuple[str, Motion]]:
        """Return the arguments for pickling, to pass it between processes."""
        return Interrupted, (str(self), self.motion)
