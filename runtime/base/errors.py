"""Errors that name the object at fault and the remedy.

Every message has the form ``kind 'name': fact; remedy``.
"""

from __future__ import annotations

from typing import Any


class FlexelError(Exception):
    """Base of all errors that flexel raises on purpose.

    Attributes
    ----------
    motion : Motion, optional
        For a simulation that failed: the motion computed so far, which can be inspected, saved and continued.
    """

    motion: Any = None


class ModelError(FlexelError, ValueError):
    """A declaration in the model is wrong: unknown or duplicate name, impossible geometry, bad value."""


class ConstraintError(FlexelError, ValueError):
    """The model is over- or under-constrained, or a chosen set of coordinates is dependent."""


class PositionError(FlexelError, RuntimeError):
    """The constraints cannot be satisfied: an unreachable position or an inconsistent velocity."""


class DynamicsError(FlexelError, RuntimeError):
    """The equations of motion cannot be solved or integrated (singular mass matrix, failed step)."""


class IncompleteWarning(UserWarning):
    """An analysis is incomplete: the message says what was reached and where it stopped."""


class RangeWarning(UserWarning):
    """A motion has left the range of the data of a law: the message names the quantity and says how the law goes on."""


class CompilerError(FlexelError, RuntimeError):
    """A user-defined law or element cannot be compiled: there is no C compiler, or it reports an error."""


class ElementError(FlexelError, ValueError):
    """The definition of a user-defined element or law is wrong, or fails its verification."""


class LinearizationError(FlexelError, ValueError):
    """A linearization cannot be formed or reduced as requested."""
