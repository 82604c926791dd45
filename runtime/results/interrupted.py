"""What Ctrl-C during a simulation raises."""

from __future__ import annotations

from flexel.results.motion import Motion


class Interrupted(KeyboardInterrupt):  # noqa: N818 - it is no error
    """Ctrl-C during a simulation.

    Attributes
    ----------
    motion : Motion
        The motion up to there.
    """

    def __init__(self, message: str, motion: Motion) -> None:
        super().__init__(message)
        self.motion = motion

    def __reduce__(self) -> tuple[type[Interrupted], tuple[str, Motion]]:
        """How it travels between processes."""
        return Interrupted, (str(self), self.motion)
