"""
Shimmy of a caster
==================

A caster is towed by a pivot on a sideways spring. Its wheel does not slip sideways, and yet the trailing wheel wobbles
more and more: for the mass in the pivot the characteristic polynomial
:math:`(J + m a^2) s^3 + m a v s^2 + k a^2 s + k a v` always has growing roots.
"""

import matplotlib.pyplot as plt
import numpy as np

import flexel as fx

a, mass, J, k, v = 0.1, 5.0, 0.02, 5000.0, 3.0
m = fx.Model()
m.point("pivot", (0, 0))
m.point("axle", (-a, 0))
m.angle("fork")
m.angle("spin")
m.beam("trail", "pivot", "fork", "axle")
m.planar_wheel("wheel", "axle", "fork", "spin", radius=0.05)
m.body("caster", "pivot", "fork", mass=mass, inertia=J)
m.spring("pivot.y", k)
m.prescribe("pivot.x", fx.Polynomial([0, v]))
m.independent("fork.angle")
m.kinematic("pivot.y", "spin.angle")
s = m.build()

known = np.sort_complex(np.roots([J + mass * a**2, mass * a * v, k * a**2, k * a * v]))
values = s.linearize().eigenvalues()
found = np.sort_complex(values[abs(values) > 1e-6])  # the turn of the wheel itself is neutral
print("eigenvalues", found, "closed form", known, "1/s")

motion = s.simulate(1.2, start=s.state_at(rates={"fork.angle": 0.05}), samples=601)
plt.style.use("flexel.apps.view.style")
plt.plot(motion["pivot.x"], 1000 * motion["pivot.y"])
plt.xlabel("distance travelled [m]")
plt.ylabel("lateral displacement of the pivot [mm]")
plt.title("Shimmy of a caster")
plt.show()

# %%
# The motion: play it, turn it, point at its parts.

# sphinx_gallery_thumbnail_path = 'images/gallery/caster_shimmy.png'
motion.view(title="Shimmy of a caster")
