r"""
Hanging chain
=============

A chain of forty links between two hooks finds the catenary. With the horizontal tension :math:`H` its sag is
:math:`c\,(\cosh(d/2c) - 1)`, where :math:`c = H/w` belongs to the length :math:`2 c \sinh(d/2c)`.
"""

import matplotlib.pyplot as plt
import numpy as np
from scipy.optimize import brentq

import flexel as fx

span, n = 1.0, 40
m = fx.Model(gravity=(0, -9.81))
chain = m.chain("chain", [(0, 0), (span / 2, -0.4), (span, 0)], n, mass_per_length=1.0)
m.fix(chain.points[0], chain.points[-1])
s = m.build()
rest = s.equilibrium(stable=True)

shape = np.array([rest.position(node.name) for node in chain.points])
length = np.hypot(*np.diff(shape.T)).sum()
c = brentq(lambda trial: 2 * trial * np.sinh(span / (2 * trial)) - length, 0.1, 1.0)
found, known = -shape[:, 1].min(), c * (np.cosh(span / (2 * c)) - 1)
print("sag", found, "of the catenary", known, "m")

plt.style.use("flexel.apps.view.style")
plt.plot(*shape.T, "o", markersize=3, label="links")
x = np.linspace(0, span, 101)
plt.plot(x, c * (np.cosh((x - span / 2) / c) - np.cosh(span / (2 * c))), label="catenary")
plt.gca().set(xlabel="x [m]", ylabel="y [m]", aspect="equal", title="A chain of forty links")
plt.legend()
plt.show()

# %%
# The chain as drawn, let go: play it, turn it, point at its parts.

# sphinx_gallery_thumbnail_path = 'images/gallery/hanging_chain.png'
s.simulate(3).view(title="A chain of forty links")
