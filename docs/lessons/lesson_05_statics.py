"""
5. Statics
==========

Equilibrium, large deflections and buckling of flexible beams.
"""

# %%
# A cantilever
# ------------
# A beam with *two* orientations is flexible. Its stiffness comes from a section and a material, or from
# numbers. A long beam is divided into several elements.

import numpy as np

import flexel as fx

length, n = 0.5, 4
E, width, height = 210e9, 20e-3, 2e-3
EI, EA = E * width * height**3 / 12, E * width * height


def cantilever():
    m = fx.Model()
    for i in range(n + 1):
        m.point(f"P{i}", (i * length / n, 0), fixed=i == 0)
        m.angle(f"R{i}", fixed=i == 0)
    for i in range(n):
        m.beam(f"beam {i}", f"P{i}", f"R{i}", f"P{i + 1}", f"R{i + 1}", EA=EA, EIz=EI)
    return m


# %%
# Equilibrium
# -----------
# Loads are forces on coordinates or deformations. ``equilibrium`` needs no mass.

m = cantilever()
m.load(f"P{n}.y", -0.01)  # small
rest = m.build().equilibrium()
print("deflection", rest[f"P{n}.y"], "closed form", -0.01 * length**3 / (3 * EI), "m")

# %%
# Large deflections
# -----------------
# A load that grows is a function of time, which serves as the load parameter of a path of equilibria.
# Deformations *within* an element are assumed small, and a warning says where they are not: with four
# elements it asks for twelve.

n = 12
m = cantilever()
m.load(f"P{n}.y", lambda t: -40.0 * t)
path = m.build().static_path(t_end=1.0)
path.plot(f"P{n}.y", f"P{n}.x")
path.plot_shapes(0.25, 0.5, 1.0)

# %%
# Forces in sections
# ------------------

print(path[-1].outputs("beam 0")["moment_p"], "N m at the wall")

# %%
# Exercise
# --------
# Push along the beam, with a force towards the wall at its free end. Euler's load of a cantilever is π² EI/(4
# l²). Find it with ``s.buckling(increment={…: -1.0})``, whose results have a ``multiplier``. How large is the
# error with four elements?
#
# Solution
# --------

n = 4
s = cantilever().build()
mode = s.buckling(increment={f"P{n}.x": -1.0}, count=1)[0]
found = mode.multiplier
known = np.pi**2 * EI / (4 * length**2)
print("buckling load", found, "N, Euler", known, "N, relative error", found / known - 1)
