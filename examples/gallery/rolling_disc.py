r"""
Rolling disc
============

A thin disc rolls on a plane without slip, for example a coin. Upright and straight ahead it is stable if it rolls
faster than :math:`\omega^2 = g/(3 r)`; slower, it falls.
"""

import matplotlib.pyplot as plt
import numpy as np

import flexel as fx

r, mass, g = 0.2, 1.0, 9.81
m = fx.Model(gravity=(0, 0, -g))
m.point("hub", (0, 0, r))
m.point("contact", (0, 0, 0))
m.frame("ground", fixed=True)
for name in ("yawed", "leaned", "disc"):
    m.frame(name)
m.hinge("yaw", "ground", "yawed", axis=(0, 0, 1))
m.hinge("lean", "yawed", "leaned", axis=(1, 0, 0))
m.hinge("roll", "leaned", "disc", axis=(0, -1, 0))
m.wheel("wheel", "hub", "disc", "contact", radius=r, axle=(0, -1, 0))
m.body("coin", "hub", "disc", mass=mass, inertia=np.array([0.25, 0.5, 0.25]) * mass * r**2)
m.independent("yaw.angle", "lean.angle", "roll.angle")
s = m.build()
critical = np.sqrt(g / (3 * r))
speeds = np.linspace(0.2, 2, 37) * critical
loci = s.root_loci(rates={"roll.angle": -speeds})
growth = loci.eigenvalues.real.max(axis=1)

found = growth[0]
known = np.sqrt((g / r - 3 * speeds[0] ** 2) / 1.25)
print("falls at", found, "closed form", known, "1/s; stable above", critical, "rad/s")

wobble = s.simulate(
    6, start=s.state_at(rates={"roll.angle": -1.2 * critical, "lean.angle": 0.2, "yaw.angle": 0})
)
plt.style.use("flexel.apps.view.style")
figure, (left, right) = plt.subplots(1, 2, figsize=(7.5, 3.4))
left.plot(speeds / critical, growth)
left.set(xlabel="speed / critical speed [-]", ylabel="growth rate [1/s]", title="stability")
right.plot(*wobble.position("contact")[:, :2].T)
right.set(xlabel="x [m]", ylabel="y [m]", title="track after a push")
figure.suptitle("A rolling disc")
plt.show()

# %%
# The motion: play it, turn it, point at its parts.

# sphinx_gallery_thumbnail_path = 'images/gallery/rolling_disc.png'
wobble.view(title="A rolling disc")
