"""
Delta robot
===========

Three motors on a plate move three arms, and rods from their ends carry the tool. The parallelograms of rods only keep
the tool level; each is modelled as one rod to the tool's centre, with the plate made smaller by the tool's radius.
Virtual work gives the torques that hold the load.
"""

import matplotlib.pyplot as plt
import numpy as np

import flexel as fx
from flexel.apps.view.plot import draw

plate, arm, rod, down = 0.1, 0.2, 0.45, 0.3
m = fx.Model(gravity=(0, 0, -9.81))
m.frame("ground", fixed=True)
out, height = plate + arm * np.cos(down), -arm * np.sin(down)
m.point("tool", (0, 0, height - np.sqrt(rod**2 - out**2)))
m.point_mass("load", "tool", 1.0)
for i in range(3):
    c, s = np.cos(2 * np.pi * i / 3), np.sin(2 * np.pi * i / 3)
    m.point(f"motor {i}", (plate * c, plate * s, 0), fixed=True)
    m.point(f"knee {i}", (out * c, out * s, height))
    m.frame(f"arm {i}")
    m.hinge(f"drive {i}", "ground", f"arm {i}", axis=(-s, c, 0))
    m.beam(f"upper {i}", f"motor {i}", f"arm {i}", f"knee {i}")
    m.truss(f"rod {i}", f"knee {i}", "tool")
    m.prescribe(f"drive {i}.angle", lambda t, i=i: 0.4 * np.sin(t) ** 3 * np.sin(8 * t + 2 * np.pi * i / 3))
motion = m.build().simulate(np.pi, samples=401)

found = np.array([motion.force(f"drive {i}.angle")[0] for i in range(3)])  # at rest
drop = arm * np.cos(down) + out * arm * np.sin(down) / np.sqrt(
    rod**2 - out**2
)  # of the tool by turn of the arms
known = np.full(3, 9.81 * drop / 3)
print("torques of the motors at rest", found, "by virtual work", known, "N m")

plt.style.use("flexel.apps.view.style")
axes = plt.figure(figsize=(5, 5)).add_subplot(projection="3d")
axes.plot(*motion.position("tool").T)
draw(motion[0], axes, fx.View(centre=(0, 0, -0.3), span=0.9))
axes.set_title("Path of the tool")
plt.show()

# %%
# The motion: play it, turn it, point at its parts.

# sphinx_gallery_thumbnail_path = 'images/gallery/delta_robot.png'
motion.view(title="A delta robot", view=fx.View(trails=["tool"]))
