r"""
Spinning top
============

A heavy top that spins fast enough precesses steadily. With the moments of inertia :math:`A` and :math:`C` about its
tip, its tilt stays constant where :math:`A \cos\vartheta\, \Omega^2 - C \omega_3 \Omega + m g l = 0`. Let go
without precession, it nods.
"""

import matplotlib.pyplot as plt
import numpy as np

import flexel as fx

mass, l, A, C, tilt, spin = 0.5, 0.06, 2.5e-3, 0.5e-3, 0.5, 200.0
m = fx.Model(gravity=(0, 0, -9.81))
m.point("O", (0, 0, 0), fixed=True)
m.frame("ground", fixed=True)
for name in ("yawed", "tilted", "top"):
    m.frame(name)
m.hinge("yaw", "ground", "yawed", axis=(0, 0, 1))
m.hinge("tilt", "yawed", "tilted", axis=(1, 0, 0))
m.hinge("spin", "tilted", "top", axis=(0, 0, 1))
m.body("body", "O", "top", mass=mass, inertia=(A - mass * l**2, A - mass * l**2, C), offset=(0, 0, l))
m.independent("yaw.angle", "tilt.angle", "spin.angle")
m.initial("tilt.angle", tilt)
s = m.build()
slow = np.roots([A * np.cos(tilt), -C * spin, mass * 9.81 * l]).min()
rates = {"yaw.angle": slow, "spin.angle": spin - slow * np.cos(tilt), "tilt.angle": 0}
steady = s.simulate(2, start=s.state_at({"tilt.angle": tilt}, rates), rtol=1e-10)
rates |= {"yaw.angle": 0, "spin.angle": spin}
nodding = s.simulate(2, start=s.state_at({"tilt.angle": tilt}, rates), samples=1001)

found, known = steady["yaw.angle"][-1] / 2, slow
print("steady precession at", found, "closed form", known, "rad/s")

plt.style.use("flexel.apps.view.style")
figure, axes = plt.subplots(figsize=(5, 5), subplot_kw={"projection": "polar"})
for motion, label in ((steady, "steady"), (nodding, "let go")):
    axes.plot(motion["yaw.angle"], np.degrees(motion["tilt.angle"]), label=label)
axes.set_title("tilt of the axis [°] over its heading")
axes.legend()
plt.show()

# %%
# The top, let go: play it, turn it, point at its parts.

stem = fx.Cylinder("O", "top", (0, 0, 0), (0, 0, 0.1), 0.004)
disc = fx.Cylinder("O", "top", (0, 0, 0.05), (0, 0, 0.07), 0.045)
# sphinx_gallery_thumbnail_path = 'images/gallery/spinning_top.png'
nodding.view(title="A spinning top, let go", view=fx.View(sketches=[stem, disc]))
