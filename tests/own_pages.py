"""Pages as users write them, for tests: a cam, the rubber of its roller, a bar."""

CAM = """
import sympy as sp
from flexel.derive import Deformation, Element, Let, Parameter, PlanarAngle, PlanarPoint

axis, shaft, tip = PlanarPoint("c"), PlanarAngle("cam"), PlanarPoint("p")
base = Parameter("base", 1, "m", "radius of the base circle")
lift = Parameter("lift", 1, "m", "height of the lobe")
let = Let()
d = let.vector("d", tip.x - axis.x)
theta = let.scalar("theta", sp.atan2(d[1], d[0]) - shaft.x[0])
r = let.scalar("r", base.symbol + lift.symbol * (1 + sp.cos(theta)) / 2)
gap = Deformation("gap", "m", sp.sqrt(d.dot(d)) - r)
CAM = Element("cam", (axis, shaft, tip), (base, lift), let.entries, (gap,), doc="gap = |p - c| - r(theta)")
"""
CAM_LINE = 13  # of its declaration

RUBBER = """
from flexel.derive import Internal, Law, Parameter, symbol

e, ed, z = symbol("e"), symbol("ed"), symbol("z")
k, lag = Parameter("k", 1, "N/m", "stiffness"), Parameter("lag", 1, "s", "time of relaxation")
RUBBER = Law(
    "rubber", "sigma = k (e - z), z' = (e - z)/lag", (k, lag), (e,), (ed,), (), (k.symbol * (e - z),), (),
    k.symbol * (e - z) ** 2 / 2, states=(Internal("z", "m", (e - z) / lag.symbol),),
)
"""

ROOT = """
import sympy as sp
from flexel.derive import Deformation, Element, Parameter, PlanarPoint

p, l0 = PlanarPoint("p"), Parameter("l0", 1, "m", "length")
BARS = [
    Element(name, (p,), (l0,), (), (Deformation("d", "m", sp.sqrt(p.x[0]) - l0.symbol),), doc="d = sqrt(x) - l0")
    for name in ("first_root", "second_root")
]
"""
