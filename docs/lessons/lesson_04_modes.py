"""
4. Linearization and modes
==========================

Small motions about a state: eigenvalues, modes of vibration, and their pictures. The linearization is
analytic: no differences, no step size.
"""

# %%
# Two coupled pendulums
# ---------------------

import numpy as np

import flexel as fx

length, mass, stiffness = 1.0, 1.0, 5.0


def pendulums(down=1.0, damping=0.0):
    m = fx.Model(gravity=(0, -9.81))
    for name, x in (("left", 0.0), ("right", 0.5)):
        m.point(f"{name} pivot", (x, 0), fixed=True)
        m.point(name, (x, -down * length))
        m.truss(f"{name} bar", f"{name} pivot", name)
        m.point_mass(f"{name} mass", name, mass)
    m.truss("coupling", "left", "right")
    m.spring("coupling.elongation", stiffness, damping)
    m.independent("left.x", "right.x")
    return m.build()


# %%
# Modes
# -----
# ``linearize`` takes a state; the initial one, if none is given. Each of its ``modes`` has a frequency, a
# damping ratio and a shape by names.

lin = pendulums().linearize()
for mode in lin.modes():
    print(mode)
lin.plot_mode(0)

# %%
# In the first mode both swing together, and the spring keeps its length; in the second they swing against one
# another.

found_modes = [mode.omega for mode in lin.modes()]
known_modes = np.sqrt([9.81 / length, 9.81 / length + 2 * stiffness / mass]).tolist()
print("frequencies", found_modes, "closed form", known_modes, "rad/s")

# %%
# Stability
# ---------
# Small motions with an eigenvalue λ grow as exp(λ t). Drawn upright, the pendulums fall together; the spring
# just keeps them from falling apart:

print(pendulums(down=-1.0).linearize().eigenvalues(), "1/s")

# %%
# A state-space model
# -------------------
# Forces are inputs, and any quantities are outputs; see lesson 9 for what to do with it.

A, B, C, D = lin.state_space(["left.x"], ["right.x"])
print(A.shape, B.shape, C.shape, D.shape)

# %%
# Exercise
# --------
# Give the coupling a damper of 0.2 N s/m. It does not act in the first mode. The second mode has the damping
# ratio c/(m ω₂). Check this with ``mode.damping``, and simulate: what remains of a motion that starts with
# one pendulum displaced?
#
# Solution
# --------

damped = pendulums(damping=0.2)
second = max(damped.linearize().modes(), key=lambda mode: mode.damping)
found = second.damping
known = 0.2 / (mass * known_modes[1])
print("damping ratio", found, "closed form", known)
motion = damped.simulate(40, start=damped.state_at({"left.x": 0.02, "right.x": 0.5}))
motion.plot(["left.x", "right.x"])  # in the end both swing together
