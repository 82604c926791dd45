"""
Differential
============

The cage of a differential turns at the mean speed of its two wheels, and gives both the same torque. In this model,
which is a single relation, the wheel with the small inertia, as on ice, runs away.
"""

import matplotlib.pyplot as plt

import flexel as fx

torque, inertia, places = 100.0, {"left": 4.0, "right": 0.5}, {"left": 0.7, "cage": 0.0, "right": -0.7}
m = fx.Model()
m.frame("axle", fixed=True)
for name, y in places.items():
    m.point(f"{name} hub", (0, y, 0), fixed=True)
    m.frame(name)
    m.hinge(f"{name} turn", "axle", name, axis=(0, 1, 0))
for name, value in inertia.items():
    m.body(f"{name} wheel", f"{name} hub", name, mass=20, inertia=(value / 2, value, value / 2))
m.relation("bevel gears", {"cage turn.angle": 1.0, "left turn.angle": -0.5, "right turn.angle": -0.5})
m.load("cage turn.angle", torque)
motion = m.build().simulate(2)

found = [float(motion.acceleration(f"{name} turn.angle")[0]) for name in inertia]
known = [torque / 2 / value for value in inertia.values()]
print("accelerations", found, "closed form", known, "rad/s²")

plt.style.use("flexel.apps.view.style")
for name in ("left", "cage", "right"):
    plt.plot(motion.t, motion.rate(f"{name} turn.angle"), label=name)
plt.xlabel("time [s]")
plt.ylabel("angular velocity [rad/s]")
plt.title("The differential of a car in a bend")
plt.legend()
plt.show()

# %%
# The motion: play it, turn it, point at its parts.

rims = [
    fx.Cylinder(f"{name} hub", name, (0, y - 0.05, 0), (0, y + 0.05, 0), 0.3) for name, y in places.items()
]
spokes = [fx.Box(f"{name} hub", name, (0, y, 0), (0.5, 0.14, 0.06)) for name, y in places.items()]
shaft = fx.Cylinder("cage hub", "axle", (0, -0.7, 0), (0, 0.7, 0), 0.04)
# sphinx_gallery_thumbnail_path = 'images/gallery/differential.png'
motion.view(title="A differential", view=fx.View(sketches=[shaft, *rims, *spokes]))
