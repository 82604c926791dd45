"""
Controller design
=================

A cart balances a rod. The linearization goes to a linear-quadratic design, and the gains come back into the nonlinear
model, whose eigenvalues are those of :math:`A - B K`.
"""

import matplotlib.pyplot as plt
import numpy as np
from scipy.linalg import solve_continuous_are

import flexel as fx
from flexel.apps.view.plot import draw

m = fx.Model(gravity=(0, -9.81))
m.point("cart", (0, 0))
m.fix("cart.y")
m.point("top", (0, 1))
m.angle("ground", fixed=True)
m.angle("rod")
m.hinge("pivot", "ground", "rod")
m.beam("pole", "cart", "rod", "top", mass_per_length=1)
m.point_mass("cart mass", "cart", 3.0)
m.point("wall", (-3, 0), fixed=True)
m.truss("rail", "wall", "cart")
m.independent("rail.elongation", "pivot.angle")
lin = m.build().linearize()
A, B, *_ = lin.state_space(["rail.elongation"])
X = solve_continuous_are(A, B, np.diag([1, 1, 10, 10]), 0.1 * np.eye(1))
K = 10 * B.T @ X
m.controller(K, inputs=lin.states, outputs=["rail.elongation"])
s = m.build()

found = np.sort_complex(s.linearize().eigenvalues())
known = np.sort_complex(np.linalg.eigvals(A - B @ K))
print("eigenvalues of the model", found, "of the design", known, "1/s")

motion = s.simulate(6, start=s.state_at({"pivot.angle": 0.5}))
plt.style.use("flexel.apps.view.style")
figure, (left, right) = plt.subplots(1, 2, figsize=(7.5, 3.4))
draw(motion[0], left)
right.plot(motion.t, motion["cart.x"], label="position of the cart [m]")
right.plot(motion.t, motion["pivot.angle"], label="angle of the rod [rad]")
right.set(xlabel="time [s]", ylabel="position, angle [m, rad]")
figure.suptitle("A cart balances a rod")
right.legend()
plt.show()

# %%
# The motion: play it, turn it, point at its parts.

# sphinx_gallery_thumbnail_path = 'images/gallery/controller.png'
motion.view(title="A cart balances a rod")
