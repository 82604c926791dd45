"""
1. Names and nodes
==================

A pendulum, and how to address everything in it. A model consists of *nodes* (points and orientations) and
*elements* between them (rods, hinges, wheels, springs). Everything has a name, and results are read by these
names.
"""

# %%
# Nodes
# -----
# A planar model has points ``(x, y)`` and angles. Points and angles are declared as they are drawn;
# ``fixed=True`` holds them. Units are SI, angles are in radians.

import numpy as np

import flexel as fx

m = fx.Model(gravity=(0, -9.81))
m.point("O", (0, 0), fixed=True)
m.point("tip", (0.6, -0.8))  # the rod is drawn at an angle: 1 m long
m.angle("ground", fixed=True)
m.angle("rod turn")

# %%
# Elements
# --------
# A hinge measures the angle from one orientation to another. A beam between two points with *one* orientation
# is rigid: it turns with this orientation, and has a constant length.

m.hinge("pivot", "ground", "rod turn")
m.beam("rod", "O", "rod turn", "tip", mass_per_length=2.0)

# %%
# The system
# ----------
# ``build`` compiles the model. It finds how many degrees of freedom there are, and chooses them unless you
# name them with ``m.independent``.

s = m.build()
print(s)

# %%
# Results by name
# ---------------
# A *quantity* is ``node.coordinate`` or ``element.deformation``; a prime denotes its rate, ``force:`` its
# force.

motion = s.simulate(3)
print("angle", motion["pivot.angle"][-1], "rad, speed", motion["pivot.angle'"][-1], "rad/s")
print("tip", motion["tip.x"][-1], motion["tip.y"][-1], "m")
motion.plot("pivot.angle", ["tip.x", "tip.y"])

# %%
# The motion itself, as the last line of a cell, or ``motion.view()``, shows the pendulum: play it, turn it, point
# at its parts.

motion

# %%
# A wrong name is an error that suggests the right one:

try:
    motion["pivot.angel"]
except fx.ModelError as error:
    print(error)

# %%
# Exercise
# --------
# Small oscillations of a rod about its end have the period 2π √(2 l / (3 g)). Let the pendulum go near its
# rest, at 0.01 rad from the vertical, and compare. ``s.state_at({"pivot.angle": …})`` is a state with a given
# value of a degree of freedom; angles count from the drawing, so that the rod hangs down at -0.6435 rad. An
# event of ``simulate`` is a zero of a function of the state: ``events=[fx.Event("through", lambda state:
# state["tip.x"])]``.
#
# Solution
# --------

down = np.arctan2(0.8, 0.6) - np.pi / 2
start = s.state_at({"pivot.angle": down + 0.01})
through = fx.Event("through", lambda state: state["tip.x"])
small = s.simulate(3, start=start, rtol=1e-10, events=[through])
times = [state.t for _, state in small.events]
found = 2 * (times[1] - times[0])  # it goes through the middle twice in a period
known = (
    2 * np.pi * np.sqrt(2 / (3 * 9.81)) * (1 + 0.01**2 / 16)
)  # with the first correction for the amplitude
print("period", found, "s, closed form", known, "s")
