r"""
Belt drive
==========

Two pulleys and the two straight parts of an elastic belt. They turn together in the ratio of their radii, and
against each other at the frequency :math:`\omega^2 = 2 k (r_1^2/J_1 + r_2^2/J_2)`.
"""

import matplotlib.pyplot as plt
import numpy as np

import flexel as fx
from flexel.apps.view.plot import draw

radius, inertia, k = (0.05, 0.15), (0.002, 0.03), 5e4
m = fx.Model()
m.point("P", (0, 0), fixed=True)
m.point("Q", (0.5, 0), fixed=True)
m.angle("small")
m.angle("large")
m.rotary_inertia("rotor", "small", inertia[0])
m.rotary_inertia("fan", "large", inertia[1])
for name, side in (("upper", 1), ("lower", -1)):
    a, b = (side * r for r in radius)
    m.planar_belt(name, "P", "small", "Q", "large", radius_p=a, radius_q=b, stiffness=k, damping=5)
lin = m.build().linearize()
m.load("small.angle", 1.0)  # a motor
s = m.build()
motion = s.simulate(0.1, samples=401)

found = abs(lin.eigenvalues()).max()
known = np.sqrt(2 * k * (radius[0] ** 2 / inertia[0] + radius[1] ** 2 / inertia[1]))
print("the belt's frequency", found, "closed form", known, "rad/s")

plt.style.use("flexel.apps.view.style")
figure, (left, right) = plt.subplots(1, 2, figsize=(7.5, 3.4))
draw(motion[-1], left)
figure.suptitle("Two pulleys and their belt")
for name in ("small", "large"):
    right.plot(motion.t, motion.rate(f"{name}.angle"), label=f"{name} pulley")
right.set(xlabel="time [s]", ylabel="angular velocity [rad/s]")
right.legend()
plt.show()

# %%
# The motion: play it, turn it, point at its parts.

# sphinx_gallery_thumbnail_path = 'images/gallery/belt_drive.png'
motion.view(title="Two pulleys and their belt")
