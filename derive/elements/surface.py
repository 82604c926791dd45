"""Surface of second degree on which a point stays."""

from flexel.derive.declare import Deformation, Element, Parameter, Point
from flexel.derive.declare.rotation import dot

QUADRATIC = Parameter(
    "quadratic",
    6,
    "1/m",
    "coefficients of x^2, y^2, z^2, x y, x z, y z",
    ("xx", "yy", "zz", "xy", "xz", "yz"),
)
LINEAR = Parameter("linear", 3, "1", "coefficients of x, y, z", ("x", "y", "z"))
CONSTANT = Parameter("constant", 1, "m", "constant term")


def _surface() -> Element:
    p = Point("p")
    x, y, z = p.x
    terms = (x * x, y * y, z * z, x * y, x * z, y * z)
    g = sum(c * term for c, term in zip(QUADRATIC.symbols, terms, strict=True))
    return Element(
        name="surface",
        family="surface",
        nodes=(p,),
        parameters=(QUADRATIC, LINEAR, CONSTANT),
        deformations=(Deformation("height", "m", g + dot(LINEAR.vector, p.x) + CONSTANT.symbol),),
        doc="height = quadratic.(x^2, y^2, z^2, x y, x z, y z) + linear.(x, y, z) + constant",
        source="SPACAR95 manual (Schwab and Meijaard 2000), SURFACE",
    )


SURFACE = _surface()
