r"""
An element of your own
======================

A planet and its sun in one element: a kinetic and a potential energy, a dozen lines of SymPy. Everything else is
derived and compiled. The planet returns after Kepler's :math:`2 \pi \sqrt{a^3/\mu}`.
"""

import matplotlib.pyplot as plt
import numpy as np
import sympy as sp

import flexel as fx
from flexel.derive import Element, Let, Parameter, PlanarPoint

place = PlanarPoint("p")
mass, mu = Parameter("mass", 1, "kg", "mass"), Parameter("mu", 1, "m^3/s^2", "attraction of the sun")
r = sp.sqrt(place.x.dot(place.x))
PLANET = Element(
    "planet",
    (place,),
    (mass, mu),
    Let().entries,
    (),
    kinetic_energy=mass.symbol * place.v.dot(place.v) / 2,
    potential=-mass.symbol * mu.symbol / r,
    doc="T = mass v.v/2,  U = -mass mu/|x|",
    source="own",
)
m = fx.Model()
m.point("P", (1, 0))
m.element("planet", fx.compile_element(PLANET), "P", mass=1.0, mu=1.0)
s = m.build()
axis = 1 / (2 - 1.2**2)  # semi-major, from the speed
period = 2 * np.pi * axis**1.5
motion = s.simulate(period, start=s.state_at(rates={"P.x": 0, "P.y": 1.2}), rtol=1e-10, atol=1e-10)

found, known = motion.position("P")[-1], (1, 0)
print("after Kepler's period the planet is at", found, "and was at", known)

plt.style.use("flexel.apps.view.style")
plt.plot(*motion.position("P").T, label="planet")
plt.plot(0, 0, "yo", markersize=12, label="sun")
plt.gca().set(xlabel="x [m]", ylabel="y [m]", aspect="equal", title="Orbit of a planet")
plt.legend(loc="upper right")
plt.show()

# %%
# The motion: play it, turn it, point at its parts.

# sphinx_gallery_thumbnail_path = 'images/gallery/own_element.png'
motion.view(title="Orbit of a planet", view=fx.View(trails=["P"]))
