"""
Four-bar linkage
================

A crank turns and a rocker swings. The rocker turns back where crank and coupler are in one line, so that the
cosine rule gives its range.
"""

import matplotlib.pyplot as plt
import numpy as np

import flexel as fx
from flexel.apps.view.plot import draw

crank, coupler, rocker, base = 0.1, np.hypot(0.33, 0.14), 0.25, 0.4
m = fx.Model()
m.point("O", (0, 0), fixed=True)
m.point("A", (0, crank))
m.point("B", (0.33, 0.24))
m.point("C", (base, 0), fixed=True)
m.angle("crank")
m.beam("crank bar", "O", "crank", "A")
m.truss("coupler", "A", "B")
m.truss("rocker", "C", "B")
m.prescribe("crank.angle", fx.Polynomial([0, 2 * np.pi]))
motion = m.build().simulate(1, samples=2001)

x, y = motion.position("B").T
angle = np.arctan2(y, base - x)  # of the rocker, from the line of centres
found = angle.min(), angle.max()
far = [(base**2 + rocker**2 - (coupler + sign * crank) ** 2) / (2 * base * rocker) for sign in (-1, 1)]
known = np.arccos(far)
print("the rocker swings between", np.degrees(found), "closed form", np.degrees(known), "degrees")

plt.style.use("flexel.apps.view.style")
figure, (left, right) = plt.subplots(1, 2, figsize=(7.5, 3.4))
draw(motion[0], left)
right.plot(motion.t, np.degrees(angle))
right.set(xlabel="turns of the crank [-]", ylabel="angle of the rocker [°]")
figure.suptitle("Four-bar linkage")
plt.show()

# %%
# The motion: play it, turn it, point at its parts.

# sphinx_gallery_thumbnail_path = 'images/gallery/four_bar.png'
motion.view(title="A four-bar linkage", view=fx.View(trails=["B"]))
