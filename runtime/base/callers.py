"""Finds the line of a user's program that called the package, for warnings."""

import sys


def outside() -> int:
    """Return the level of the frame that called the package, as `warnings.warn` of the caller counts it."""
    frame, level = sys._getframe(1), 1
    while frame.f_back is not None and str(frame.f_globals.get("__name__")).partition(".")[0] == "flexel":
        frame, level = frame.f_back, level + 1
    return level
