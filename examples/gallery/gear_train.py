"""
Planetary gear
==============

A sun wheel, a planet on a carrier, and a fixed ring with teeth inside. The sun turns :math:`1 + z_r/z_s` times as
fast as the carrier.
"""

import matplotlib.pyplot as plt
import numpy as np

import flexel as fx
from flexel.apps.view.plot import draw

sun, planet = 20, 15  # teeth
ring = sun + 2 * planet
m = fx.Model()
m.point("centre", (0, 0), fixed=True)
m.point("pin", (sun + planet, 0))
m.angle("ring", fixed=True)
for name in ("sun", "planet", "carrier"):
    m.angle(name)
m.beam("arm", "centre", "carrier", "pin")
m.planar_gear("inner mesh", "centre", "sun", "pin", "planet", radius_p=sun, radius_q=planet)
m.planar_gear("outer mesh", "pin", "planet", "centre", "ring", radius_p=planet, radius_q=-ring)
m.rotary_inertia("rotor", "sun", 0.01)
m.prescribe("sun.angle", fx.Ramp(0, 1, 0, 20 * np.pi))
motion = m.build().simulate(1)

found = motion["sun.angle"][-1] / motion["carrier.angle"][-1]
known = 1 + ring / sun
print("the sun turns", found, "times as fast as the carrier, closed form", known)

plt.style.use("flexel.apps.view.style")
figure, (left, right) = plt.subplots(1, 2, figsize=(7.5, 3.4))
draw(motion[0], left)
figure.suptitle("Planetary gear train")
for name in ("sun", "carrier", "planet"):
    right.plot(motion.t, motion[f"{name}.angle"] / (2 * np.pi), label=name)
right.set(xlabel="time [s]", ylabel="turns [-]")
right.legend()
plt.show()

# %%
# The motion: play it, turn it, point at its parts.

# sphinx_gallery_thumbnail_path = 'images/gallery/gear_train.png'
motion.view(title="A planetary gear train")
