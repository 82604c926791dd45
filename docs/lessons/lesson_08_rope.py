"""
8. A rope
=========

A rope over a sheave that is held: Euler and Eytelwein's formula. Then the same rope over a sheave that turns.
"""

# %%
# Two weights and a sheave
# ------------------------
# A sheave is a surface on a body. ``m.rope`` lays a taut rope over it, out of cable elements that touch it
# with friction.

import matplotlib.pyplot as plt
import numpy as np

import flexel as fx

radius, friction = 0.1, 0.3


def sheave(held, left, right):
    m = fx.Model(gravity=(0, -9.81))
    m.point("centre", (0, 0), fixed=True)
    m.angle("ground", fixed=True)
    m.angle("wheel")
    m.hinge("axle", "ground", "wheel")
    m.body("rim", "centre", "wheel", mass=1.0, inertia=0.005)
    m.sheave("sheave", "centre", "wheel", radius=radius - 1e-3)
    m.point("A", (-radius, -0.4))
    m.point("B", (radius, -0.4))
    m.point_mass("left", "A", left)
    m.point_mass("right", "B", right)
    rope = m.rope(
        "rope",
        ["A", "sheave", "B"],
        24,
        contact=fx.Contact(1e9, friction=friction, slip_speed=1e-3, dissipation=10.0),
        tension=9.81 * (left + right) / 2,
        radius=1e-3,
        EA=1e5,
        EI=1e-5,
        mass_per_length=0.01,
        damping=1e-3,
    )
    if held:
        m.rigid("axle.angle")
    return m.build(), rope


# %%
# Does it hold?
# -------------
# Friction carries a ratio of tensions of at most exp(μ π) = 2.57. With weights of 2 and 3 kg the rope stays.

s, rope = sheave(held=True, left=3.0, right=2.0)
options = {"method": "generalized-alpha", "step": 2e-3, "spectral_radius": 0.5}
motion = s.simulate(0.2, **options)
print(f"3 kg and 2 kg: it slides by {1e3 * abs(np.ptp(motion['A.y'])):.2f} mm")

# %%
# With 6 and 2 kg it slides, and the tensions of both sides have this ratio:

s, rope = sheave(held=True, left=6.0, right=2.0)
motion = s.simulate(0.2, **options)
_, tension = rope.tension(motion[-1])
print(f"6 kg and 2 kg: it slides by {abs(np.ptp(motion['A.y'])):.3f} m, ratio {tension[0] / tension[-1]:.3f}")
print(f"of Euler and Eytelwein {np.exp(friction * np.pi):.3f}")

# %%
# Along the rope
# --------------
# The tension falls exponentially where the rope touches the sheave.

place, tension = rope.tension(motion[-1])
plt.style.use("flexel.apps.view.style")
plt.plot(place, tension)
plt.xlabel("along the rope [m]")
plt.ylabel("tension [N]")
plt.title("Tension of a rope that slides over a sheave")
plt.show()

# %%
# Exercise
# --------
# Let the sheave turn, with weights of 3 and 2 kg: Atwood's machine. Without slip the acceleration is (m₁ -
# m₂) g/(m₁ + m₂ + I/R²), with the inertia I of the sheave and the mass of the rope small. How far does the
# load fall in 0.3 s?
#
# Solution
# --------

s, rope = sheave(held=False, left=3.0, right=2.0)
motion = s.simulate(0.3, **options)
found = motion["A.y"][0] - motion["A.y"][-1]
known = (3.0 - 2.0) * 9.81 / (5.0 + 0.005 / radius**2) * 0.3**2 / 2
print(f"drop {found:.5f} m, of a rope without mass and stretch {known:.5f} m")
