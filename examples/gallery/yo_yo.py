"""
Yo-yo
=====

A spool unwinds from its string and falls. Its acceleration is :math:`g/(1 + J/(m r^2))`, and the string carries the
rest of its weight. A relation couples height and angle, over any number of turns.
"""

import matplotlib.pyplot as plt
import numpy as np

import flexel as fx

mass, J, r = 0.1, 4e-5, 0.006
m = fx.Model(gravity=(0, -9.81))
m.point("spool", (0, 1))
m.fix("spool.x")
m.angle("turn")
m.body("yo-yo", "spool", "turn", mass=mass, inertia=J)
m.relation("string", {"spool.y": 1.0, "turn.angle": r})
motion = m.build().simulate(1.2)

tension = abs(motion.force("string.relation")[0])
found = np.array([-motion.acceleration("spool.y")[0], tension])
known = (9.81 / (1 + J / (mass * r**2)), mass * 9.81 / (1 + mass * r**2 / J))
print("acceleration and tension", found, "closed form", known, "m/s², N")

plt.style.use("flexel.apps.view.style")
figure, (left, right) = plt.subplots(1, 2, figsize=(7.5, 3.4))
left.plot(motion.t, motion["spool.y"])
left.set(xlabel="time [s]", ylabel="height [m]")
right.plot(motion.t, motion["turn.angle"] / (2 * np.pi))
right.set(xlabel="time [s]", ylabel="turns [-]")
figure.suptitle("A yo-yo falls")
plt.show()

# %%
# The motion: play it, turn it, point at its parts.

# sphinx_gallery_thumbnail_path = 'images/gallery/yo_yo.png'
motion.view(title="A yo-yo falls")
