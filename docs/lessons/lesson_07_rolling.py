"""
7. Rolling: from a disc to a bicycle
====================================

A wheel that rolls has fewer velocities than positions: it can reach every place, but it cannot move sideways.
flexel calls the coordinates that the velocities do not reach at once *kinematic*, and linearizes rolling
systems analytically.
"""

# %%
# A rolling disc
# --------------
# A wheel element joins its hub, its orientation and its contact point. Three hinges in a row give the angles
# names: yaw, lean and roll.

import numpy as np
from scipy.optimize import brentq

import flexel as fx
from flexel.examples.bicycle import bicycle

g, r = 9.81, 0.3
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
m.body("rim", "hub", "disc", mass=2.0, inertia=np.array([0.25, 0.5, 0.25]) * 2.0 * r**2)
m.independent("yaw.angle", "lean.angle", "roll.angle")
s = m.build()
print(s)

# %%
# Stability at a speed
# --------------------
# ``root_loci`` linearizes at many speeds. A disc stays upright if its angular speed exceeds √(g/(3 r)).

critical = np.sqrt(g / (3 * r))
for factor in (0.9, 1.1):
    lin = s.linearize(s.state_at(rates={"roll.angle": -factor * critical}))
    print(f"at {factor} of the critical speed:", lin.eigenvalues().real.max().round(3), "1/s")
loci = s.root_loci(rates={"roll.angle": -np.linspace(0.1, 2, 60) * critical})
loci.plot()

# %%
# A motion
# --------
# Pushed at 1.5 times the critical speed, it wobbles and goes on.

start = s.state_at(rates={"roll.angle": -1.5 * critical, "lean.angle": 0.2, "yaw.angle": 0})
motion = s.simulate(4, start=start)
motion.plot_phase("contact.x", "contact.y")
print("energy kept within", np.ptp(motion.energy["total"]), "J")

# %%
# A bicycle
# ---------
# Two wheels, two frames and a steering axis: the benchmark bicycle (Meijaard, Papadopoulos, Ruina and Schwab
# 2007) is one of flexel's examples, as one function of 30 lines. Between its weave and its capsize speed it
# is stable without a rider.

ride = bicycle()
speeds = np.linspace(1, 10, 91)
weave = ride.root_loci(rates={"rear spin.angle": -speeds / 0.3}, of=["lean.angle", "steer.angle"])
stable = speeds[weave.eigenvalues.real.max(axis=1) < 0]
print(f"stable from {stable[0]:.1f} to {stable[-1]:.1f} m/s; published 4.29 to 6.02 m/s")

# %%
# Exercise
# --------
# A hoop, with all its mass at the rim, has the inertia m r² (1/2, 1, 1/2), and its critical speed is √(g/(4
# r)). Find this from the eigenvalues ±λ: at which speed does λ² change its sign?
#
# Solution
# --------

hoop = s.with_parameters({"rim.J": np.array([0.5, 1.0, 0.5, 0, 0, 0]) * 2.0 * r**2})


def growth(speed):
    lin = hoop.linearize(hoop.state_at(rates={"roll.angle": -speed}))
    return np.sum(
        lin.eigenvalues() ** 2
    ).real  # of ±λ and zeros: positive where it falls, negative where it wobbles


found = brentq(growth, 0.5 * critical, 1.5 * critical, xtol=1e-10)
known = np.sqrt(g / (4 * r))
print("critical speed", found, "closed form", known, "rad/s")
