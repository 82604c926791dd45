"""
Sampled controller
==================

A motor keeps a rod upright. Its controller measures every 20 ms, its torque changes one period later and is limited.
From a small angle the rod is raised; from a larger one the torque is not enough.
"""

import matplotlib.pyplot as plt
import numpy as np
from scipy.signal import cont2discrete

import flexel as fx


def upright() -> fx.Model:
    """Build a rod that falls."""
    m = fx.Model(gravity=(0, -9.81))
    m.point("O", (0, 0), fixed=True)
    m.point("tip", (0, 1))
    m.angle("ground", fixed=True)
    m.angle("arm")
    m.hinge("motor", "ground", "arm")
    m.beam("rod", "O", "arm", "tip", mass_per_length=2)
    return m


K, T = np.array([[6.0, 30.0]]), 0.02  # of the rate and the angle
lin = upright().build().linearize()
A, B, C, D = lin.state_space(["motor.angle"], lin.states)
m = upright()
m.controller(K, inputs=lin.states, outputs=["motor.angle"], period=T, delay=T, limits=(-5, 5))
s = m.build()

Ad, Bd, *_ = cont2discrete((A, B, C, D), T)
known = np.sort_complex(np.linalg.eigvals(np.block([[Ad, Bd], [-K, np.zeros((1, 1))]])))
found = np.sort_complex(s.linearize().sampled().eigenvalues()[:3])
print("eigenvalues of one period", found, "of the discrete system", known)

plt.style.use("flexel.apps.view.style")
figure, (left, right) = plt.subplots(1, 2, figsize=(7.5, 3.4))
for start in (0.3, 0.45, 0.5):
    motion = s.simulate(1.5, start=s.state_at({"motor.angle": start}), samples=601)
    left.plot(motion.t, motion["motor.angle"], label=f"from {start} rad")
    right.plot(motion.t, motion["controller.u"])
left.set(xlabel="time [s]", ylabel="angle [rad]", ylim=(-0.2, 1.5))
right.set(xlabel="time [s]", ylabel="torque [N m]")
left.legend()
figure.suptitle("A pendulum with a sampled, saturated controller")
plt.show()

# %%
# The motion that stays upright from farthest: play it, turn it, point at its parts.

# sphinx_gallery_thumbnail_path = 'images/gallery/sampled_controller.png'
s.simulate(1.5, start=s.state_at({"motor.angle": 0.45})).view(title="A pendulum with a sampled controller")
