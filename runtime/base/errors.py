"""Errors that name the object at fault and the remedy.

Every message has the form ``kind 'name': fact; remedy``.
"""

from __future__ import annotations

from flexel.derive.definition_errors import ElementError, FlexelError

__all__ = [
    "AssemblyWarning",
    "AuditWarning",
    "CompilerError",
    "ConstraintError",
    "CoordinateWarning",
    "DampingWarning",
    "DynamicsError",
    "ElementError",
    "FlexelError",
    "IncompleteWarning",
    "LinearizationError",
    "ModelError",
    "ModelWarning",
    "PositionError",
    "RangeWarning",
    "StiffWarning",
    "UnstableWarning",
    "UnsteadyWarning",
]


class ModelError(FlexelError, ValueError):
    """A declaration in the model is wrong: unknown or duplicate name, impossible geometry, bad value."""


class ConstraintError(FlexelError, ValueError):
    """The model is over- or under-constrained, or a chosen set of coordinates is dependent."""


class PositionError(FlexelError, RuntimeError):
    """The constraints cannot be satisfied: an unreachable position or an inconsistent velocity."""


class DynamicsError(FlexelError, RuntimeError):
    """The equations of motion cannot be solved or integrated: a singular mass matrix, or a failed step."""


class CoordinateWarning(UserWarning):
    """The degrees of freedom are nearly singular at a state: the message names them, and those used instead."""


class AuditWarning(UserWarning):
    """A motion contradicts itself: the message says by how much, where, and the remedy; see `Motion.warnings`."""


class DampingWarning(UserWarning):
    """A motion is less accurate than it seems: the message names the method, what was lost, and the remedy."""


class IncompleteWarning(UserWarning):
    """An analysis is incomplete: the message says what was reached and where it stopped."""


class UnsteadyWarning(UserWarning):
    """Eigenvalues or modes are requested for an accelerating state, whose motion they do not describe."""


class AssemblyWarning(UserWarning):
    """A drawing violates rigid conditions: the message names them, and the coordinates that are moved."""


class ModelWarning(UserWarning):
    """A part of a model is probably a mistake: a node without an element, a value that suggests a different unit."""


class UnstableWarning(UserWarning):
    """An equilibrium is unstable: the smallest disturbance moves the mechanism away from it."""


class RangeWarning(UserWarning):
    """A state is beyond the data of a law, or beyond the deformations for which an element is accurate; names it."""


class StiffWarning(UserWarning):
    """An explicit integration will take long because the system is stiff: the message says how long, and the remedy."""


class CompilerError(FlexelError, RuntimeError):
    """A user-defined law or element cannot be compiled: there is no C compiler, or it reports an error."""


class LinearizationError(FlexelError, ValueError):
    """A linearization cannot be formed or reduced as requested."""
