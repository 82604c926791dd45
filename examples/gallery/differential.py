"""
Differential
============

The cage of a differential turns at the mean speed of its two wheels, and gives both the same torque. In this model,
which is a single relation, the wheel with the small inertia, as on ice, runs away.
"""

import matplotlib.pyplot as plt

import flexel as fx

torque, inertia = 100.0, {"left": 4.0, "right": 0.5}
m = fx.Model()
for name in ("cage", "left", "right"):
    m.angle(name)
for name, value in inertia.items():
    m.rotary_inertia(f"{name} wheel", name, value)
m.relation("bevel gears", {"cage.angle": 1.0, "left.angle": -0.5, "right.angle": -0.5})
m.load("cage.angle", torque)
motion = m.build().simulate(2)

found = [float(motion.acceleration(f"{name}.angle")[0]) for name in inertia]
known = [torque / 2 / value for value in inertia.values()]
print("accelerations", found, "closed form", known, "rad/s²")

plt.style.use("flexel.apps.view.style")
for name in ("left", "cage", "right"):
    plt.plot(motion.t, motion.rate(f"{name}.angle"), label=name)
plt.xlabel("time [s]")
plt.ylabel("angular velocity [rad/s]")
plt.title("The differential of a car in a bend")
plt.legend()
plt.show()
