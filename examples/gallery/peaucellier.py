"""
Peaucellier linkage
===================

Seven bars turn a circle into an exact straight line (1864). A rhombus of side :math:`a` hangs on two bars of length
:math:`b`; where its near corner runs on a circle of radius :math:`c` through the pivot, the far corner runs on the
line :math:`x = (b^2 - a^2)/(2 c)`.
"""

import matplotlib.pyplot as plt
import numpy as np

import flexel as fx
from flexel.apps.view.plot import draw

a, b, c = 0.25, 0.5, 0.2
m = fx.Model()
m.point("O", (0, 0), fixed=True)
m.point("centre", (c, 0), fixed=True)
m.point("near", (2 * c, 0))
far = (b**2 - a**2) / (2 * c)
middle = c + far / 2
m.point("upper", (middle, np.sqrt(b**2 - middle**2)))
m.point("lower", (middle, -np.sqrt(b**2 - middle**2)))
m.point("far", (far, 0))
m.truss("arm", "centre", "near", mass_per_length=1)
for side in ("upper", "lower"):
    m.truss(f"long {side}", "O", side, mass_per_length=1)
    m.truss(f"inner {side}", "near", side, mass_per_length=1)
    m.truss(f"outer {side}", side, "far", mass_per_length=1)
m.prescribe("far.y", fx.Harmonic(0.4, 1))
motion = m.build().simulate(6)

x, y = motion.position("far").T
found, known = x, np.full_like(x, far)
print("largest distance from the straight line", abs(found - known).max(), "m over", np.ptp(y), "m")

plt.style.use("flexel.apps.view.style")
figure, axes = plt.subplots(figsize=(5, 4))
for name in ("near", "upper", "far"):
    axes.plot(*motion.position(name).T, label=name)
draw(motion[-1], axes, fx.View(centre=(0.35, 0, 0), span=1.2))
axes.set_title("Paths of three joints")
axes.legend()
plt.show()

# %%
# The motion: play it, turn it, point at its parts.

# sphinx_gallery_thumbnail_path = 'images/gallery/peaucellier.png'
motion.view(title="Peaucellier's linkage", view=fx.View(trails=["far"]))
