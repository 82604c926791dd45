"""From elements declared in SymPy to C: the floor that derives. See `flexel.derive.element` for the declaration.

What a user's own element or law is written with is found here.
"""

from flexel.derive.element import (
    TIME,
    Deformation,
    Element,
    Frame,
    Internal,
    Law,
    Let,
    Node,
    Parameter,
    PlanarAngle,
    PlanarPoint,
    Point,
    Slip,
    Slope,
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
    "Node",
    "Parameter",
    "PlanarAngle",
    "PlanarPoint",
    "Point",
    "Slip",
    "Slope",
    "symbol",
]
