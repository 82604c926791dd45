"""From elements declared in SymPy to C.

The names needed to write a user-defined element or law.  They are resolved on demand, so
that ``flexel.derive.spec``, which the runtime reads, does not import SymPy.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from flexel.derive.declare import (
        TIME,
        Deformation,
        Element,
        Frame,
        Internal,
        Law,
        Let,
        Limit,
        Node,
        Output,
        Parameter,
        PlanarAngle,
        PlanarPoint,
        PlanarSlope,
        Point,
        Slip,
        Slope,
        ValidRange,
        symbol,
    )

__all__ = [
    "TIME",
    "Deformation",
    "Element",
    "Frame",
    "Internal",
    "Law",
    "Let",
    "Limit",
    "Node",
    "Output",
    "Parameter",
    "PlanarAngle",
    "PlanarPoint",
    "PlanarSlope",
    "Point",
    "Slip",
    "Slope",
    "ValidRange",
    "symbol",
]


def __getattr__(name: str) -> Any:
    if name not in __all__:
        raise AttributeError(f"flexel.derive has no '{name}'; its names are {', '.join(__all__)}")
    return getattr(import_module("flexel.derive.declare"), name)


def __dir__() -> list[str]:
    return sorted([*globals(), *__all__])
