"""
Weave, wobble and capsize of a motorcycle
=========================================

The rider is one body with the frame; the steered front has a damper, and the tyres have side slip, camber and
relaxation. Without control the machine falls slowly (capsize) and snakes at 2 to 3 Hz (weave); above 38 m/s its
steering shakes at 7 Hz (wobble). The tyre loads come from the static equilibrium.
"""

from typing import Any

import matplotlib.pyplot as plt
import numpy as np

import flexel as fx

m = fx.Model(gravity=(0, 0, -9.81))  # x forward, y left, z up
m.rigid_body("machine", (0.62, 0, 0.6), mass=240, inertia=(28, 40, 24, 0, 2, 0))
m.rigid_body("fork", (1.1, 0, 0.9), mass=12, inertia=(0.9, 0.8, 0.25))
m.revolute("steer", "machine", "fork", at=(1.1, 0, 0.9), axis=(0.453, 0, -0.892), damping=6.8)
m.cardan_chain("yaw", "lean", "pitch", body="machine")
law: dict[str, Any] = {"stiffness": 180e3, "damping": 250, "friction": (1.2, -0.1), "slip_stiffness": 15}
law |= {"camber_stiffness": 0.8, "shape": (1.5, -0.5), "trail": (0.02, 5), "relaxation": (0.12, 0.22)}
wheels = ("rear", "machine", 0, 0.31, 1500, 0.09, 18), ("front", "fork", 1.45, 0.3, 1300, 0.06, 14)
for end, body, x, R, load, crown, mass in wheels:
    hub = (x, 0, R - 0.005)
    wheel = m.rigid_body(end, hub, mass=mass, inertia=(mass / 35, mass / 20, mass / 35))
    m.revolute(f"{end} spin", body, end, at=hub, axis=(0, 1, 0))
    own = law | {"load0": load, "rolling_radius": R - 0.004, "cornering": (load / 120, 2)}
    own |= {"radius": R, "axle": (0, 1, 0), "crown": crown}
    m.tyre(f"{end} tyre", wheel.point, wheel.frame, law="magic_formula", **own)
angles = [f"{name}.angle" for name in ("yaw", "lean", "pitch", "steer", "rear spin", "front spin")]
m.independent("machine.x", "machine.y", "machine.z", *angles)
s = m.build()
v = np.linspace(5, 60, 111)
rates = {"machine.x": v, "rear spin.angle": v / 0.306, "front spin.angle": v / 0.296}
start = s.steady(rates={name: r[0] for name, r in rates.items()}, unknown=["machine.z", "pitch.angle"])
values = s.root_loci(start, rates=rates).eigenvalues

masses = {"machine": 240, "fork": 12, "rear": 18, "front": 14}
moment = sum(9.81 * mass * (start[f"{body}.x"] - start["rear.x"]) for body, mass in masses.items())
front = moment / (start["front.x"] - start["rear.x"])
known = np.array([9.81 * sum(masses.values()) - front, front])
found = np.array([start.force("rear tyre.deflection"), start.force("front tyre.deflection")])
print("tyre loads", found, "of the static equilibrium", known, "N")

plt.style.use("flexel.apps.view.style")
plt.scatter(v.repeat(values.shape[1]), values.real, 5, abs(values.imag) / 6.2832)
plt.colorbar(label="frequency [Hz]")
plt.gca().set(ylim=(-12, 5), xlabel="speed [m/s]", ylabel="real part of the eigenvalues [1/s]")
plt.title("Eigenvalues of a motorcycle")
plt.show()

# %%
# A ride at 30 m/s after a kick: play it, turn it, point at its parts.

ride = {name: float(rate[50]) for name, rate in rates.items()}
steady = s.steady(rates=ride, unknown=["machine.z", "pitch.angle"])
kicked = s.state_at(rates=ride | {"lean.angle": 0.6}, start=steady)
# sphinx_gallery_thumbnail_path = 'images/gallery/motorcycle.png'
s.simulate(3, start=kicked).view(title="A motorcycle at 30 m/s")
