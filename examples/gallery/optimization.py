"""
Optimization with SciPy
=======================

A spring is to balance an arm in every position. SciPy's least squares varies its stiffness and its
tension, and finds the spring of balanced lamps: :math:`k = m g l/(a b)`, and a free length of zero.
"""

import matplotlib.pyplot as plt
import numpy as np
from scipy.optimize import least_squares

import flexel as fx

mass, l, a, b = 2.0, 0.5, 0.3, 0.2  # spring from a above the pivot to b along the arm
angles = np.linspace(-1.2, 1.2, 9)


def lamp(design: np.ndarray) -> fx.System:
    """Return the lamp on its arm, for a stiffness [N/m] and a force as drawn [N] of the spring."""
    m = fx.Model(gravity=(0, -9.81))
    m.point("pivot", (0, 0), fixed=True)
    m.point("hook", (0, a), fixed=True)
    m.point("eye", (b, 0))
    m.point("end", (l, 0))
    m.angle("arm")
    m.beam("arm bar", "pivot", "arm", "end")
    m.body_point("eye on arm", "pivot", "arm", "eye")
    m.point_mass("lamp", "end", mass)
    m.truss("spring", "hook", "eye")
    m.spring("spring.elongation", design[0], preload=design[1])
    m.independent("arm.angle")
    return m.build()


def torques(design: np.ndarray) -> np.ndarray:
    """Return the moments that remain in several positions."""
    s = lamp(design)
    states = [s.state_at({"arm.angle": angle}) for angle in angles]
    return np.array([mass * l**2 * state.acceleration("arm.angle") for state in states])


first = np.array([100.0, 30.0])
found = least_squares(torques, first, x_scale=[100, 30], xtol=1e-12).x
stiffness = mass * 9.81 * l / (a * b)
known = np.array([stiffness, stiffness * np.hypot(a, b)])
print("stiffness and tension", found, "closed form", known)

plt.style.use("flexel.apps.view.style")
plt.plot(np.degrees(angles), torques(first), label="first guess")
plt.plot(np.degrees(angles), torques(found), label="optimum")
plt.xlabel("angle of the arm [°]")
plt.ylabel("residual moment [N m]")
plt.title("A balanced arm")
plt.legend()
plt.show()

# %%
# The balanced arm, pushed: play it, turn it, point at its parts.

s = lamp(found)
# sphinx_gallery_thumbnail_path = 'images/gallery/optimization.png'
s.simulate(4, start=s.state_at({"arm.angle": -1.0}, {"arm.angle": 0.5})).view(title="A balanced arm")
