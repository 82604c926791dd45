r"""
Double pendulum
===============

Two point masses on two massless rods. Hanging, they swing with two frequencies, of :math:`\det(K - \omega^2 M) = 0`
with matrices from the textbook. Let go from above, the motion is chaotic.
"""

import matplotlib.pyplot as plt
import numpy as np

import flexel as fx
from flexel.apps.view.plot import draw

m = fx.Model(gravity=(0, -9.81))
m.point("O", (0, 0), fixed=True)
m.point("A", (1, 0.2))
m.point("B", (1.5, 1))
m.truss("upper", "O", "A")
m.truss("lower", "A", "B")
m.point_mass("mass A", "A", 1.0)
m.point_mass("mass B", "B", 1.0)
s = m.build()
motion = s.simulate(10, samples=2001, rtol=1e-10)

rest = s.equilibrium(stable=True)
length = np.hypot(1, 0.2), np.hypot(0.5, 0.8)
found = [mode.omega for mode in s.vibrations(rest)]
inertia = [[2 * length[0] ** 2, length[0] * length[1]], [length[0] * length[1], length[1] ** 2]]
stiffness = np.diag([2 * length[0], length[1]]) * 9.81
known = np.sqrt(np.sort(np.linalg.eigvals(np.linalg.solve(inertia, stiffness))))
print("frequencies", found, "closed form", known, "rad/s")

plt.style.use("flexel.apps.view.style")
figure, axes = plt.subplots(figsize=(5, 5))
axes.plot(*motion.position("B").T, lw=0.6)
draw(motion[0], axes, fx.View(centre=(0, -0.2, 0), span=4.2))
axes.set_title("Path of the lower mass")
plt.show()

# %%
# The motion: play it, turn it, point at its parts.

# sphinx_gallery_thumbnail_path = 'images/gallery/double_pendulum.png'
motion.view(title="A double pendulum", view=fx.View(trails=["B"]))
