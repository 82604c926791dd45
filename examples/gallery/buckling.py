r"""
Buckling of a column
====================

A slender column on hinges buckles under :math:`\pi^2 E I/L^2` (Euler, 1744). Eight elements find its first loads.
"""

import matplotlib.pyplot as plt
import numpy as np

import flexel as fx
from flexel.apps.view.page import view_modes

length, EI, n = 1.0, 100.0, 8
m = fx.Model()
for i in range(n + 1):
    m.point(f"P{i}", (0, i * length / n), fixed=i == 0)
    m.angle(f"R{i}")
for i in range(n):
    m.beam(f"beam {i}", f"P{i}", f"R{i}", f"P{i + 1}", f"R{i + 1}", EIz=EI, EA=1e8)
m.fix(f"P{n}.x")
s = m.build()
modes = s.buckling(increment={f"P{n}.y": -1.0}, count=3)

found = [mode.multiplier for mode in modes]
known = [(i * np.pi / length) ** 2 * EI for i in (1, 2, 3)]
print("buckling loads", found, "Euler", known, "N")

plt.style.use("flexel.apps.view.style")
for mode in modes:
    x = [mode.shape.get(f"P{i}.x", 0) for i in range(n + 1)]
    plt.plot(x, np.linspace(0, length, n + 1), label=f"{mode.multiplier:.4g} N")
plt.xlabel("deflection, to scale [-]")
plt.ylabel("height [m]")
plt.title("Buckling modes of a column")
plt.legend(title="buckling load")
plt.show()

# %%
# The modes, with a slider for the amplitude.

# sphinx_gallery_thumbnail_path = 'images/gallery/buckling.png'
view_modes(s.at_rest, modes=modes, title="Buckling modes of a column")
