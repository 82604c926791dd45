"""
Trebuchet
=========

A counterweight falls, a beam turns, and a sling throws the projectile. The range depends on when the sling opens;
the energy of the whole stays constant.
"""

import matplotlib.pyplot as plt
import numpy as np

import flexel as fx
from flexel.apps.view.plot import draw

m = fx.Model(gravity=(0, -9.81))
m.point("axis", (0, 3), fixed=True)
tip = np.array([-2.6, -2.6])
m.point("tip", (0, 3) + tip)
m.point("short", (0, 3) - tip / 4)
m.point("weight", (0, 3) - tip / 4 - (0, 0.8))
m.point("stone", (0.6, 0.4))
m.angle("beam")
m.beam("long arm", "axis", "beam", "tip", mass_per_length=5)
m.body_point("short arm", "axis", "beam", "short")
m.truss("hanger", "short", "weight")
m.truss("sling", "tip", "stone")
m.point_mass("counterweight", "weight", 1500.0)
m.point_mass("projectile", "stone", 15.0)
motion = m.build().simulate(1.2, samples=1201, rtol=1e-10, atol=1e-12)

total = motion.energy["total"]
found, known = total[-1], total[0]
print("energy at the end", found, "at the start", known, "J")
(x, y), (vx, vy) = motion.position("stone").T, motion.velocity("stone").T
reach = x + vx * (vy + np.sqrt(vy**2 + 2 * 9.81 * np.maximum(y, 0))) / 9.81  # if the sling opens now
best = np.argmax(reach)
print(f"opened after {motion.t[best]:.3f} s it throws {reach[best]:.0f} m")

plt.style.use("flexel.apps.view.style")
figure, (left, right) = plt.subplots(1, 2, figsize=(7.5, 3.6))
left.plot(*motion.position("stone")[: best + 1].T)
draw(motion[best], left, fx.View(centre=(-1, 4.5, 0), span=11))
figure.suptitle("Trebuchet")
right.plot(motion.t, reach)
right.set(xlabel="time at which the sling opens [s]", ylabel="range [m]")
plt.show()

# %%
# The motion: play it, turn it, point at its parts.

# sphinx_gallery_thumbnail_path = 'images/gallery/trebuchet.png'
motion.view(title="A trebuchet", view=fx.View(trails=["stone"]))
