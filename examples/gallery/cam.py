r"""
Cam and follower
================

A cam of radius :math:`b + h\,(1 + \cos\theta)/2` turns at constant speed and lifts a tappet on a spring. On top of the
lobe the tappet wants to fly off: the contact force there is that of spring and weight, less
:math:`m h \Omega^2/2`. The contact between cam and tappet is an element of its own, written in SymPy.
"""

import matplotlib.pyplot as plt
import numpy as np
import sympy as sp

import flexel as fx
from flexel.derive import Deformation, Element, Let, Parameter, PlanarAngle, PlanarPoint

axis, cam, tip = PlanarPoint("c"), PlanarAngle("cam"), PlanarPoint("p")
base, lift = Parameter("base", 1, "m", "base circle"), Parameter("lift", 1, "m", "height of the lobe")
let = Let()
d = let.vector("d", tip.x - axis.x)
theta = let.scalar("theta", sp.atan2(d[1], d[0]) - cam.x[0])
gap = sp.sqrt(d.dot(d)) - base.symbol - lift.symbol * (1 + sp.cos(theta)) / 2
gap = Deformation("gap", "m", gap)
doc = "gap = |p - c| - r(theta)"
CAM = Element("cam", (axis, cam, tip), (base, lift), let.entries, (gap,), doc=doc, source="own")

b, h, mass, k, preload, speed = 0.03, 0.01, 0.4, 900.0, 30.0, 100.0
m = fx.Model(gravity=(0, -9.81))
m.point("axis", (0, 0), fixed=True)
m.angle("shaft")
m.point("tip", (0, b + h / 2))
m.fix("tip.x")
m.element("contact", fx.compile_element(CAM), "axis", "shaft", "tip", base=b, lift=h)
m.point_mass("tappet", "tip", mass)
m.spring("tip.y", k, preload=preload)
m.prescribe("shaft.angle", fx.Polynomial([0, speed]))
motion = m.build().simulate(4 * np.pi / speed, samples=401)

force = -motion.force("contact.gap")  # pressure is positive here
found = force[50]  # after a quarter of a turn, on top of the lobe
known = preload + k * h / 2 + mass * 9.81 - mass * h / 2 * speed**2
print("contact force on top of the lobe", found, "closed form", known, "N")

plt.style.use("flexel.apps.view.style")
plt.plot(motion["shaft.angle"], force)
plt.xlabel("angle of the cam [rad]")
plt.ylabel("contact force [N]")
plt.title("Force between cam and follower")
plt.show()

# %%
# The motion: play it, turn it, point at its parts.

turn = np.linspace(0, 2 * np.pi, 91)
outline = (b + h * (1 + np.cos(turn)) / 2) * np.array([np.cos(turn), np.sin(turn), 0 * turn])
# sphinx_gallery_thumbnail_path = 'images/gallery/cam.png'
motion.view(title="A cam and its follower", view=fx.View(sketches=[fx.Sketch("axis", "shaft", outline.T)]))
