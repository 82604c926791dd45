"""
2. A mechanism
==============

A four-bar linkage: a closed loop. In flexel a loop needs nothing special. Two elements that end at the same
node are connected, and ``build`` finds out what can move.
"""

# %%
# Draw it
# -------
# A crank, a coupler and a rocker. The crank is a rigid beam, since its angle is to be prescribed; the other
# two are trusses: bars of constant length between two points.

import numpy as np

import flexel as fx


def linkage():
    m = fx.Model()
    m.point("O", (0, 0), fixed=True)
    m.point("A", (0, 0.1))
    m.point("B", (0.3, 0.25))
    m.point("C", (0.35, 0), fixed=True)
    m.angle("ground", fixed=True)
    m.angle("crank turn")
    m.hinge("motor", "ground", "crank turn")
    m.beam("crank", "O", "crank turn", "A")
    m.truss("coupler", "A", "B")
    m.truss("rocker", "C", "B")
    return m


# %%
# Count its degrees of freedom
# ----------------------------
# Deformations are zero unless something is said about them: a truss does not stretch, a rigid beam does not
# bend. The angle of a hinge is free. What remains are the degrees of freedom.

m = linkage()
print(m.constraint_report())

# %%
# Drive it
# --------
# A prescribed quantity is a function of time. Nothing is integrated here, since nothing is left to move
# freely: the motion is pure kinematics, with rates and accelerations.

m.prescribe("motor.angle", fx.Polynomial([0, 2 * np.pi]))  # one turn per second
motion = m.build().simulate(1, samples=201)
motion.plot_phase("B.x", "B.y")

# %%
# When a loop is over-constrained
# -------------------------------
# A second bar parallel to the coupler would only fit by chance. ``build`` says so, and names the deformations
# involved.

wrong = linkage()
wrong.truss("brace", "O", "B")
wrong.truss("second brace", "C", "A")
try:
    wrong.build()
except fx.FlexelError as error:
    print(str(error)[:400])

# %%
# Exercise
# --------
# Replace the rocker by a slider: B moves along the x axis only (``m.fix("B.y")``). Draw the crank of 0.1 m
# upright and the coupler 0.3 m long, and check the stroke of the slider, which is twice the length of the
# crank.
#
# Solution
# --------

m = fx.Model()
m.point("O", (0, 0), fixed=True)
m.point("A", (0, 0.1))
m.point("B", (np.sqrt(0.3**2 - 0.1**2), 0))
m.fix("B.y")
m.angle("ground", fixed=True)
m.angle("crank turn")
m.hinge("motor", "ground", "crank turn")
m.beam("crank", "O", "crank turn", "A")
m.truss("coupler", "A", "B")
m.prescribe("motor.angle", fx.Polynomial([0, 2 * np.pi]))
slider = m.build().simulate(1, samples=401)
found = np.ptp(slider["B.x"])
known = 0.2
print("stroke", found, "m, closed form", known, "m")
