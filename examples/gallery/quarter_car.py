"""
Quarter car
===========

A quarter of a car on its spring, above the wheel on its tyre. The road shakes it through the tyre; the body resonates
near 1 Hz and the wheel near 10 Hz.
"""

import matplotlib.pyplot as plt
import numpy as np

import flexel as fx

body, wheel, spring, tyre, damper = 300.0, 40.0, 15e3, 180e3, 1200.0
m = fx.Model()
for name, height in (("road", 0.0), ("hub", 0.3), ("chassis", 0.8)):
    m.point(name, (0, height))
    m.fix(f"{name}.x")
m.point_mass("wheel", "hub", wheel)
m.point_mass("body", "chassis", body)
m.truss("tyre", "road", "hub", stiffness=tyre)
m.truss("strut", "hub", "chassis", stiffness=spring, damping=damper)
m.prescribe("road.y", 0.0)
lin = m.build().linearize()

M, C = np.diag([body, wheel]), damper * np.array([[1, -1], [-1, 1]])
K = np.array([[spring, -spring], [-spring, spring + tyre]])
A = np.block([[np.zeros((2, 2)), np.eye(2)], [-np.linalg.solve(M, K), -np.linalg.solve(M, C)]])
found, known = np.sort(abs(lin.eigenvalues())), np.sort(abs(np.linalg.eigvals(A)))
print("natural frequencies", found, "textbook", known, "rad/s")

A, B, c, d = lin.state_space(["displacement:road.y"], ["chassis.y", "hub.y"])
hertz = np.geomspace(0.2, 30, 400)
answer = [c @ np.linalg.solve(2j * np.pi * f * np.eye(len(A)) - A, B) + d for f in hertz]
plt.style.use("flexel.apps.view.style")
plt.loglog(hertz, abs(np.array(answer)[:, :, 0]), label=["body", "wheel"])
plt.xlabel("frequency [Hz]")
plt.ylabel("amplitude / amplitude of the road [-]")
plt.title("Response of a quarter car to the road")
plt.legend()
plt.show()

# %%
# The modes, with a slider for the amplitude.

# sphinx_gallery_thumbnail_path = 'images/gallery/quarter_car.png'
lin.view(title="Modes of a quarter car")
