"""Errors that flexel raises on purpose; those of the runtime, `flexel.base.errors`, are built on them."""

from typing import Any


class FlexelError(Exception):
    """Base of all errors that flexel raises on purpose.

    Attributes
    ----------
    motion : Motion, optional
        For a simulation that failed: the motion computed so far, which can be inspected, saved and continued.
    """

    motion: Any = None


class ElementError(FlexelError, ValueError):
    """The definition of a user-defined element or law is wrong, or fails its verification."""
