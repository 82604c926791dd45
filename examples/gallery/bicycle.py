"""
Self-stability of a bicycle
===========================

The benchmark bicycle of Meijaard, Papadopoulos, Ruina and Schwab (2007), rider and all. Without control it is stable
between the weave speed and the capsize speed.
"""

import matplotlib.pyplot as plt
import numpy as np

import flexel as fx

m = fx.Model(gravity=(0, 0, 9.81))  # x forward, y right, z down
hub, contact = m.point("hub", (0, 0, -0.3)), m.point("contact", (0, 0, 0))
hub2, contact2 = m.point("front hub", (1.02, 0, -0.35)), m.point("front contact", (1.02, 0, 0))
axis = np.array([np.tan(np.pi / 10), 0, 1])
head = m.point("head", np.array([1.1, 0, 0]) - 0.9 * axis)
yaw, lean, frame, rear, fork, front = map(m.frame, ("yawed", "leaned", "frame", "rear", "fork", "front"))
m.hinge("yaw", m.frame("ground", fixed=True), yaw, axis=(0, 0, 1))
m.hinge("lean", yaw, lean, axis=(1, 0, 0))
m.hinge("pitch", lean, frame, axis=(0, 1, 0))
m.hinge("steer", frame, fork, axis=axis)
m.hinge("spin", frame, rear, axis=(0, 1, 0))
m.hinge("front spin", fork, front, axis=(0, 1, 0))
m.beam("top tube", hub, frame, head)
m.beam("fork tube", head, fork, hub2)
m.wheel("rear wheel", hub, rear, contact, radius=0.3, axle=(0, 1, 0), normal=(0, 0, -1))
m.wheel("front wheel", hub2, front, contact2, radius=0.35, axle=(0, 1, 0), normal=(0, 0, -1))
m.body("rider", hub, frame, mass=85, inertia=(9.2, 11, 2.8, 0, 2.4, 0), offset=(0.3, 0, -0.6))
m.body("bar", hub2, fork, mass=4, inertia=(0.05892, 0.06, 0.00708, 0, -0.00756, 0), offset=(-0.12, 0, -0.35))
m.body("rear rim", hub, rear, mass=2, inertia=(0.0603, 0.12, 0.0603))
m.body("front rim", hub2, front, mass=3, inertia=(0.1405, 0.28, 0.1405))
m.independent("lean.angle", "steer.angle", "spin.angle")
s = m.build()
speeds = np.linspace(3, 8, 251)
loci = s.root_loci(rates={"spin.angle": -speeds / 0.3}, of=["lean.angle", "steer.angle"])

growth = loci.eigenvalues.real.max(axis=1)
change = np.flatnonzero(np.diff(np.sign(growth)))
found = speeds[change] - growth[change] * np.diff(speeds)[change] / np.diff(growth)[change]
known = [4.29238253634111, 6.02426201538837]  # published
print("weave and capsize speed", found, "published", known, "m/s")

plt.style.use("flexel.apps.view.style")
plt.plot(speeds, loci.eigenvalues.real, "k.", markersize=2)
plt.axvspan(*found, alpha=0.2, label="stable")
plt.gca().set(ylim=(-6, 2), xlabel="speed [m/s]", ylabel="real part of the eigenvalues [1/s]")
plt.title("Eigenvalues of the uncontrolled bicycle")
plt.legend()
plt.show()

# %%
# A ride at a stable speed after a kick: play it, turn it, point at its parts.

kicked = s.state_at(rates={"lean.angle": 0.4, "steer.angle": 0, "spin.angle": -4.6 / 0.3})
# sphinx_gallery_thumbnail_path = 'images/gallery/bicycle.png'
s.simulate(5, start=kicked).view(title="The bicycle at 4.6 m/s")
