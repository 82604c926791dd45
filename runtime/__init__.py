"""flexel, a compiler for mechanisms: the names a user needs, found when they are first used.

Nothing is imported here until it is asked for (PEP 562), so that ``import flexel`` is quick and
``python -m flexel.derive`` starts even when the compiled kernels are missing or broken.
This room may import the standard library only; type checkers see the real imports below.
"""

from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from flexel.errors import FlexelError, ModelError
    from flexel.functions import Harmonic, Polynomial, Ramp, Table
    from flexel.integrate import Event
    from flexel.linearize import Linearization
    from flexel.model import Model
    from flexel.result import Motion
    from flexel.system import State, System

__version__ = "0.1.0"

__all__ = [
    "Event",
    "FlexelError",
    "Harmonic",
    "Linearization",
    "Model",
    "ModelError",
    "Motion",
    "Polynomial",
    "Ramp",
    "State",
    "System",
    "Table",
]

_HOMES = {
    "Event": "flexel.integrate",
    "FlexelError": "flexel.errors",
    "Harmonic": "flexel.functions",
    "Linearization": "flexel.linearize",
    "Model": "flexel.model",
    "ModelError": "flexel.errors",
    "Motion": "flexel.result",
    "Polynomial": "flexel.functions",
    "Ramp": "flexel.functions",
    "State": "flexel.system",
    "System": "flexel.system",
    "Table": "flexel.functions",
}


def __getattr__(name: str) -> object:
    """Import the module in which a public name lives, and keep the name for the next time."""
    if name not in _HOMES:
        raise AttributeError(f"module 'flexel' has no attribute {name!r}; its names are {', '.join(__all__)}")
    value: object = getattr(import_module(_HOMES[name]), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    """List the public names, whether or not they have been imported yet."""
    return sorted({*globals(), *__all__})
