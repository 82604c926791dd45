"""Declarations of elements and laws: the vocabulary of their definitions, and immediate checks."""

from flexel.derive.declare.constants import Parameter
from flexel.derive.declare.deformations import Deformation, Slip
from flexel.derive.declare.element import Element
from flexel.derive.declare.element_nodes import (
    Frame,
    Node,
    PlanarAngle,
    PlanarPoint,
    PlanarSlope,
    Point,
    Slope,
    Warping,
)
from flexel.derive.declare.law import Internal, Law, Limit
from flexel.derive.declare.let import Let
from flexel.derive.declare.output import Output, ValidRange
from flexel.derive.declare.symbols import TIME, symbol

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
    "Warping",
    "symbol",
]
