"""
9. A controller
===============

From the linearization to a state feedback, and back into the nonlinear model.
"""

# %%
# A rod to balance
# ----------------
# An upright rod with a motor at its foot falls over:

import numpy as np
from scipy.linalg import solve_continuous_are

import flexel as fx


def upright():
    m = fx.Model(gravity=(0, -9.81))
    m.point("O", (0, 0), fixed=True)
    m.angle("ground", fixed=True)
    m.angle("arm")
    m.point("tip", (0, 0.5))
    m.hinge("motor", "ground", "arm")
    m.beam("rod", "O", "arm", "tip", mass_per_length=2)
    return m


lin = upright().build().linearize()
print(lin.eigenvalues(), "1/s")

# %%
# State space with names
# ----------------------
# Inputs are forces on coordinates or deformations, here the torque of the motor.

A, B, C, D = lin.state_space(["motor.angle"], ["tip.x"])
print("states", lin.states)
lin.bode("motor.angle", "tip.x")

# %%
# Design
# ------
# A linear-quadratic regulator; any method that gives a matrix of gains will do.

X = solve_continuous_are(A, B, np.diag([1, 100]), 0.1 * np.eye(1))
K = 10 * B.T @ X
print("gains", K)

# %%
# In the model
# ------------
# ``m.controller`` measures its inputs and acts on its outputs, in the nonlinear model: from 0.5 rad, too.

m = upright()
m.controller(K, inputs=lin.states, outputs=["motor.angle"])
regulated = m.build()
balanced = regulated.simulate(2, start=regulated.state_at({"motor.angle": 0.5}))
balanced.plot("motor.angle", "controller.u")
found_poles = np.sort(regulated.linearize().eigenvalues().real)
known_poles = np.sort(np.linalg.eigvals(A - B @ K).real)
print("poles", found_poles, "of the design", known_poles, "1/s")

# %%
# Exercise
# --------
# A spring to the upright position, ``m.spring("motor.angle", k)``, does the same without a controller, if it
# is stiffer than the weight: k > m g l/2. Check this with the eigenvalues for 1.01 and 0.99 of this
# stiffness, and find the frequency for k = 10 N m/rad: ω² = (k - m g l/2)/(m l²/3).
#
# Solution
# --------

weight = 2 * 0.5 * 9.81 * 0.5 / 2
for factor in (0.99, 1.01):
    m = upright()
    m.spring("motor.angle", factor * weight)
    print(factor, m.build().linearize().eigenvalues())
m = upright()
m.spring("motor.angle", 10.0)
found = m.build().linearize().modes()[0].omega
known = np.sqrt((10.0 - weight) / (2 * 0.5 * 0.5**2 / 3))
print("frequency", found, "rad/s, closed form", known, "rad/s")
