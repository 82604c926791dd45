"""
10. An element of your own
==========================

Write a few lines of SymPy; flexel derives every derivative that it needs, compiles them, and checks them.
"""

# %%
# A nonlinear spring
# ------------------
# An element has nodes, parameters, and deformations: functions of the coordinates of its nodes. This one
# measures half the square of a distance, relative to what it was in the drawing.

import sympy as sp

import flexel as fx
from flexel.derive import Deformation, Element, Let, Parameter, PlanarPoint

p, q = PlanarPoint("p"), PlanarPoint("q")
l0 = Parameter("l0", 1, "m", "length as drawn")
d = q.x - p.x
GREEN = Element(
    "green_strain",
    (p, q),
    (l0,),
    Let().entries,
    (Deformation("strain", "1", (d.dot(d) - l0.symbol**2) / (2 * l0.symbol**2)),),
    doc="e = (|x_q - x_p|² - l0²)/(2 l0²)",
    source="Green and Lagrange's strain",
)

# %%
# Compile it
# ----------
# ``compile_element`` derives Jacobians, second and third derivatives, emits C and compiles it. The result is
# kept, so that the next time takes no time.

compiled = fx.compile_element(GREEN)
print(compiled)

# %%
# Use it
# ------
# It is an element as any other: its deformation has a name, can be a degree of freedom, prescribed, or have a
# spring.

m = fx.Model(gravity=(0, -9.81))
m.point("O", (0, 0), fixed=True)
m.point("P", (0, -1.0))
m.point_mass("mass", "P", 2.0)
m.element("band", compiled, "O", "P", l0=1.0)
m.spring("band.strain", 300.0)  # J: the energy is k e²/2
s = m.build()
rest = s.equilibrium()
print("it hangs at", rest["P.y"], "m")
for mode in s.linearize(rest).modes():
    print(mode)
motion = s.simulate(5, start=s.state_at({"P.x": 0.2}))
motion.plot_phase("P.x", "P.y")

# %%
# Check
# -----
# The equilibrium of the force k e l/l0² with the weight is a cubic equation for the length l:

l = sp.Symbol("l", positive=True)
roots = sp.Poly(300.0 * (l**2 - 1) / 2 * l - 2.0 * 9.81, l).nroots()
length = next(float(sp.re(root)) for root in roots if abs(sp.im(root)) < 1e-12 and sp.re(root) > 0)
print("length", -rest["P.y"], "of the cubic", length, "m")

# %%
# Exercise
# --------
# Write an element with a kinetic energy: a point whose mass grows with its height, T = m₀ (1 + y/h) v²/2.
# Thrown upwards with 3 m/s without gravity, it has the speed 3/√(1 + y/h): the energy is constant. Use
# ``kinetic_energy=``, and ``p.v``.
#
# Solution
# --------

mass, height = (
    Parameter("mass", 1, "kg", "mass at y = 0"),
    Parameter("height", 1, "m", "height of twice the mass"),
)
GROWING = Element(
    "growing_mass",
    (p,),
    (mass, height),
    Let().entries,
    (),
    kinetic_energy=mass.symbol * (1 + p.x[1] / height.symbol) * p.v.dot(p.v) / 2,
    doc="T = mass (1 + y/height) v.v/2",
    source="an exercise",
)
m = fx.Model()
m.point("P", (0, 0))
m.element("drop", fx.compile_element(GROWING), "P", mass=1.0, height=2.0)
s = m.build()
motion = s.simulate(1.0, start=s.state_at(rates={"P.x": 0.0, "P.y": 3.0}), rtol=1e-11)
found = motion["P.y'"][-1]
known = 3 / (1 + motion["P.y"][-1] / 2.0) ** 0.5
print("speed", found, "m/s, closed form", known, "m/s")
