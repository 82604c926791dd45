"""Norm of the Euler parameters of a frame."""

from flexel.derive.declare import Deformation, Element, Frame
from flexel.derive.declare.rotation import dot

_r = Frame("r")

NORM = Element(
    name="norm",
    family="norm",
    nodes=(_r,),
    deformations=(Deformation("norm", "1", dot(_r.x, _r.x) - 1, kind="norm"),),
    doc="norm = lambda.lambda - 1",
    source="Schwab and Meijaard 2006, DETC2006-99307",
)
