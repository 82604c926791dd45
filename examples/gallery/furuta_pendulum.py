"""
Furuta pendulum
===============

A motor turns a horizontal arm; at its end a pendulum turns about the arm. A linear-quadratic regulator, designed
from the linearization, keeps the pendulum upright.
"""

import matplotlib.pyplot as plt
import numpy as np
from scipy.linalg import solve_continuous_are

import flexel as fx

l, r, mass, J, g = 0.3, 0.2, 0.1, 2e-3, 9.81
m = fx.Model(gravity=(0, 0, -g))
m.point("O", (0, 0, 0), fixed=True)
m.point("elbow", (r, 0, 0))
m.point("bob", (r, 0, l))
m.frame("ground", fixed=True)
m.frame("arm")
m.frame("rod")
m.hinge("motor", "ground", "arm", axis=(0, 0, 1))
m.hinge("joint", "arm", "rod", axis=(1, 0, 0))
m.beam("arm bar", "O", "arm", "elbow")
m.beam("rod bar", "elbow", "rod", "bob")
m.body("rotor", "O", "arm", mass=1, inertia=(J, J, J))
m.point_mass("weight", "bob", mass)
m.independent("motor.angle", "joint.angle")
lin = m.build().linearize()
found = lin.eigenvalues().real.max()
known = np.sqrt(g / l * (J + mass * r**2) / J)
print("upright it falls at", found, "closed form", known, "1/s")

A, B, *_ = lin.state_space(["motor.angle"])
X = solve_continuous_are(A, B, np.diag([1, 1, 10, 100]), np.eye(1))
m.controller(B.T @ X, inputs=lin.states, outputs=["motor.angle"])
s = m.build()
motion = s.simulate(4, start=s.state_at({"joint.angle": 0.3}))

plt.style.use("flexel.apps.view.style")
plt.plot(motion.t, motion["joint.angle"], label="pendulum")
plt.plot(motion.t, motion["motor.angle"], label="arm")
plt.xlabel("time [s]")
plt.ylabel("angle [rad]")
plt.title("The controlled Furuta pendulum")
plt.legend()
plt.show()

# %%
# The motion: play it, turn it, point at its parts.

# sphinx_gallery_thumbnail_path = 'images/gallery/furuta_pendulum.png'
motion.view(title="The controlled Furuta pendulum")
