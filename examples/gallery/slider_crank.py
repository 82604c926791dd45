r"""
Slider-crank
============

A crank of radius :math:`r` turns at constant speed and moves a slider through a rod of length :math:`l`. The slider
is at :math:`r \cos\varphi + \sqrt{l^2 - r^2 \sin^2\varphi}`.
"""

import matplotlib.pyplot as plt
import numpy as np

import flexel as fx
from flexel.apps.view.plot import draw

r, l, speed = 0.1, 0.3, 20.0
m = fx.Model()
m.point("O", (0, 0), fixed=True)
m.point("A", (r, 0))
m.point("B", (r + l, 0))
m.fix("B.y")
m.angle("crank")
m.beam("crank bar", "O", "crank", "A")
m.truss("rod", "A", "B", mass_per_length=1.0)
m.point_mass("slider", "B", 0.5)
m.prescribe("crank.angle", fx.Polynomial([0, speed]))
motion = m.build().simulate(2 * 2 * np.pi / speed)

phi = motion["crank.angle"]
found, known = motion["B.x"], r * np.cos(phi) + np.sqrt(l**2 - (r * np.sin(phi)) ** 2)
print("largest difference from the closed form", abs(found - known).max(), "m")

plt.style.use("flexel.apps.view.style")
figure, (left, right) = plt.subplots(1, 2, figsize=(7.5, 3.4))
draw(motion[30], left)
right.plot(motion.t, motion.force("rod.elongation"))
right.set(xlabel="time [s]", ylabel="force in the rod [N]")
figure.suptitle("Slider-crank")
plt.show()

# %%
# The motion: play it, turn it, point at its parts.

# sphinx_gallery_thumbnail_path = 'images/gallery/slider_crank.png'
motion.view(title="A slider-crank")
