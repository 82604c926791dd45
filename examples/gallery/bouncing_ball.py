r"""
Bouncing ball
=============

A ball falls on a floor, through Hertz's contact. It loses nothing, and returns to the height from which it fell. At the
deepest point the contact, :math:`F = K \delta^{3/2}`, holds all the energy:
:math:`\frac{2}{5} K \delta^{5/2} = m g (h + \delta)`.
"""

import matplotlib.pyplot as plt
import numpy as np
from scipy.optimize import brentq

import flexel as fx

mass, radius, height, K = 0.1, 0.02, 0.3, 1e7
m = fx.Model(gravity=(0, 0, -9.81))
m.point("ball", (0, 0, radius + height))
m.fix("ball.x", "ball.y")
m.point("ground", (0, 0, 0), fixed=True)
m.frame("level", fixed=True)
m.plane("floor", "ground", "level")
m.point_mass("mass", "ball", mass)
m.contact("bounce", "ball", "floor", fx.Contact(K, exponent=1.5), radius=radius)
s = m.build()
fall = np.sqrt(2 * height / 9.81)
motion = s.simulate(4 * fall, samples=2001, rtol=1e-10, atol=1e-12)

impact = s.simulate(
    0.995 * fall + 0.01, times=np.linspace(0, 0.01, 4001) + 0.995 * fall, rtol=1e-10, atol=1e-12
)
found, known = (
    -impact["bounce.gap"].min(),
    brentq(lambda depth: 0.4 * K * depth**2.5 - mass * 9.81 * (height + depth), 0, 0.01),
)
print("deepest", found, "Hertz", known, "m")

plt.style.use("flexel.apps.view.style")
figure, (left, right) = plt.subplots(1, 2, figsize=(7.5, 3.4))
left.plot(motion.t, motion["ball.z"] - radius)
left.set(xlabel="time [s]", ylabel="height [m]")
right.plot(1e6 * (impact.t - fall), -impact.force("bounce.gap"))
right.set(xlabel="time since contact [µs]", ylabel="force [N]", xlim=(-200, 2200))
figure.suptitle("A ball bounces on a plane")
plt.show()

# %%
# The motion: play it, turn it, point at its parts.

# sphinx_gallery_thumbnail_path = 'images/gallery/bouncing_ball.png'
motion.view(title="A ball bounces on a plane")
