"""
Flexure stage
=============

A stage on two leaf springs moves along a straight line, nearly: for small motions the stiffness is
:math:`24 E I/L^3`, and the stage sinks by :math:`3 u^2/(5 L)`.
"""

import matplotlib.pyplot as plt

import flexel as fx
from flexel.apps.view.plot import draw

length, EI, EA = 0.1, 0.05, 1e8
m = fx.Model()
m.angle("ground", fixed=True)
m.angle("stage")
for name, x in (("left", 0.0), ("right", 0.08)):
    m.point(f"{name} foot", (x, 0), fixed=True)
    for i in range(1, 5):
        m.point(f"{name} {i}", (x, i * length / 4))
        if i < 4:
            m.angle(f"{name} turn {i}")
        start = (f"{name} foot", "ground") if i == 1 else (f"{name} {i - 1}", f"{name} turn {i - 1}")
        end = (f"{name} {i}", "stage" if i == 4 else f"{name} turn {i}")
        m.beam(f"{name} leaf {i}", *start, *end, EA=EA, EIz=EI)
m.beam("stage bar", "left 4", "stage", "right 4")
m.load("left 4.x", lambda t: 12 * t)
s = m.build()
path = s.static_path(t_end=1.0)

force, moved = 12 * path.t, path["left 4.x"]
small = s.equilibrium(t=1e-3)
found = 12e-3 / small.position("left 4")[0]
known = 24 * EI / length**3
print("stiffness", found, "closed form", known, "N/m")

plt.style.use("flexel.apps.view.style")
figure, (left, right) = plt.subplots(1, 2, figsize=(7.5, 3.4))
draw(path[-1], left)
right.plot(1000 * moved, 1000 * (path["left 4.y"] - length), label="computed")
right.plot(1000 * moved, -600 * moved**2 / length, "--", label="3 u²/(5 L)")
right.set(xlabel="displacement of the stage [mm]", ylabel="height of the stage [mm]")
figure.suptitle("A stage on two leaf springs")
right.legend()
plt.show()

# %%
# The stage under a growing load: move the slider, point at its parts.

# sphinx_gallery_thumbnail_path = 'images/gallery/flexure_stage.png'
path.view(title="A stage on two leaf springs")
