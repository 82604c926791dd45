"""
Robot arm
=========

Two links with point masses at elbow and hand move in a vertical plane. The motions of the joints are prescribed; the
torques of the motors follow, as from the equations of the textbook.
"""

import matplotlib.pyplot as plt
import numpy as np

import flexel as fx
from flexel.apps.view.plot import draw

l, mass, g = (0.5, 0.4), (2.0, 1.0), 9.81
m = fx.Model(gravity=(0, -g))
m.point("O", (0, 0), fixed=True)
m.point("elbow", (l[0], 0))
m.point("hand", (l[0] + l[1], 0))
m.angle("ground", fixed=True)
for i, (start, end, name) in enumerate((("O", "elbow", "upper"), ("elbow", "hand", "fore"))):
    m.angle(name)
    m.beam(f"{name} arm", start, name, end)
    m.point_mass(f"mass {i}", end, mass[i])
m.hinge("shoulder motor", "ground", "upper")
m.hinge("elbow motor", "upper", "fore")
m.prescribe("shoulder motor.angle", lambda t: 0.8 * np.sin(2 * t))
m.prescribe("elbow motor.angle", lambda t: 1 - np.cos(3 * t))
motion = m.build().simulate(3)

shoulder, found = (-motion.force(f"{name} motor.angle") for name in ("shoulder", "elbow"))
t = motion.t
a, ad, add = 0.8 * np.sin(2 * t), 1.6 * np.cos(2 * t), -3.2 * np.sin(2 * t)
b, bdd = 1 - np.cos(3 * t), 9 * np.cos(3 * t)
inertia = l[1] ** 2 * (add + bdd) + l[0] * l[1] * (np.cos(b) * add + np.sin(b) * ad**2)
known = mass[1] * (inertia + g * l[1] * np.cos(a + b))
print("largest difference of the elbow's torque from the textbook", abs(found - known).max(), "N m")

plt.style.use("flexel.apps.view.style")
figure, (left, right) = plt.subplots(1, 2, figsize=(7.5, 3.4))
left.plot(*motion.position("hand").T)
draw(motion[40], left, fx.View(centre=(0.2, 0.1, 0), span=2))
right.plot(t, shoulder, label="shoulder")
right.plot(t, found, label="elbow")
right.set(xlabel="time [s]", ylabel="torque of the motor [N m]")
right.legend()
figure.suptitle("Torques of the motors along a path")
plt.show()

# %%
# The motion: play it, turn it, point at its parts.

# sphinx_gallery_thumbnail_path = 'images/gallery/robot_arm.png'
motion.view(title="A robot arm along a path", view=fx.View(trails=["hand"]))
