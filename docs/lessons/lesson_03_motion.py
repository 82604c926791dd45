"""
3. A motion
===========

Simulation: initial values, loads, accuracy, events, and how to know that a result is right.
"""

# %%
# A double pendulum
# -----------------

import numpy as np

import flexel as fx

m = fx.Model(gravity=(0, -9.81))
m.point("O", (0, 0), fixed=True)
m.point("A", (1, 0))
m.point("B", (2, 0))
m.truss("upper", "O", "A")
m.truss("lower", "A", "B")
m.point_mass("mass A", "A", 1.0)
m.point_mass("mass B", "B", 1.0)
s = m.build()

# %%
# Initial values
# --------------
# The initial configuration is the drawing, at rest. ``state_at`` finds another position, and rates that agree
# with it.

start = s.state_at(rates={"A.y": 1.0})
print("speeds of both points", start.velocity("A"), start.velocity("B"), "m/s")

# %%
# Accuracy
# --------
# ``rtol`` is the error of what is stored, relative to the range of each quantity. The method is chosen by the
# program; the message says which it was, and why.

motion = s.simulate(5, start=start, rtol=1e-8)
print(motion.message)

# %%
# Is it right?
# ------------
# Without friction the energy is constant, which the audit of every motion checks:

print(motion.verdict)
print(motion.energy)

# %%
# A motion that is chaotic amplifies every error. Simulate it twice, and see how far you can trust it:

loose = s.simulate(5, start=start, rtol=1e-4)
motion.plot("B.y", against=loose, labels=["1e-8", "1e-4"])

# %%
# Events
# ------
# An event is a zero of a function of the state; it may end the motion.

below = fx.Event("straight down", lambda state: state["A.x"], terminal=True)
until = s.simulate(5, events=[below])
print("A passes below O at", until.t[-1], "s")

# %%
# Exercise
# --------
# A mass of 2 kg falls from rest through a viscous fluid, with the force -c v, c = 3 N s/m. Its speed is m g/c
# (1 - exp(-c t/m)). Model the fluid as a spring without stiffness that damps, ``m.spring("P.y", 0.0,
# damping=3.0)``, and compare the speed after 1 s.
#
# Solution
# --------

m = fx.Model(gravity=(0, -9.81))
m.point("P", (0, 0))
m.fix("P.x")
m.point_mass("mass", "P", 2.0)
m.spring("P.y", 0.0, damping=3.0)
fall = m.build().simulate(1, rtol=1e-10)
found = -fall["P.y'"][-1]
known = 2 * 9.81 / 3 * (1 - np.exp(-3 / 2))
print("speed", found, "m/s, closed form", known, "m/s")
