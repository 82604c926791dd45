"""Errors that flexel raises on purpose; those of the runtime, `flexel.base.errors`, are built on them."""

import re
from typing import Any

_NUMPY = re.compile(r"\bnp\.(?:(?:float|int|uint|complex|longdouble|str|bool)\w*\(([^()]*)\)|(True|False)_)")


class FlexelError(Exception):
    """Base class of all errors that flexel raises on purpose.

    Attributes
    ----------
    motion : Motion, optional
        For a simulation that failed: the motion computed so far, which can be inspected, saved and continued.
    """

    motion: Any = None

    def __str__(self) -> str:
        """Return the message, with NumPy's numbers as Python's: 1.5 for np.float64(1.5)."""
        return _NUMPY.sub(lambda found: found[1] or found[2] or "", super().__str__())


class ElementError(FlexelError, ValueError):
    """The definition of a user-defined element or law is wrong, or fails its verification."""


class VerificationError(ValueError):
    """The compiled kernels do not agree with the definition, or not everywhere."""
