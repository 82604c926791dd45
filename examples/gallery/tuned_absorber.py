r"""
Tuned absorber
==============

A small mass on a spring and damper calms a large one. Whatever the damper, the response passes through two fixed
points; with Den Hartog's tuning both have the height :math:`\sqrt{1 + 2/\mu}`, :math:`\mu` being the ratio of the
masses.
"""

import matplotlib.pyplot as plt
import numpy as np

import flexel as fx

mu = 0.05


def absorber(damping: float) -> fx.System:
    """Return the main mass and the small one on it, on springs and a damper."""
    m = fx.Model()
    m.point("ground", (0, 0), fixed=True)
    for name, x, mass in (("main", 1.0, 1.0), ("small", 2.0, mu)):
        m.point(name, (x, 0))
        m.fix(f"{name}.y")
        m.point_mass(f"{name} mass", name, mass)
    m.truss("spring", "ground", "main", stiffness=1.0)
    m.truss("absorber", "main", "small")
    m.spring("absorber.elongation", mu / (1 + mu) ** 2, damping * 2 * mu / (1 + mu))
    return m.build()


def response(damping: float, omega: np.ndarray) -> np.ndarray:
    """Return the amplitude of the main mass for a force of one newton."""
    A, B, C, D = absorber(damping).linearize().state_space(["main.x"], ["main.x"])
    return np.array([abs(C @ np.linalg.solve(1j * w * np.eye(len(A)) - A, B) + D)[0, 0] for w in omega])


best = np.sqrt(3 * mu / (8 * (1 + mu)))
fixed = np.sqrt((1 + np.array([-1, 1]) * np.sqrt(mu / (2 + mu))) / (1 + mu))
found, known = response(best, fixed), np.full(2, np.sqrt(1 + 2 / mu))
print("height of the fixed points", found, "Den Hartog", known)

omega = np.linspace(0.7, 1.3, 400)
plt.style.use("flexel.apps.view.style")
for damping in (best / 4, best, 3 * best):
    plt.semilogy(omega, response(damping, omega), label=f"damping ratio {damping:.2f}")
plt.plot(fixed, found, "ko", label="fixed points")
plt.xlabel("frequency of the force / natural frequency [-]")
plt.ylabel("amplitude / static deflection [-]")
plt.title("Response of the main mass")
plt.legend()
plt.show()

# %%
# The modes, with a slider for the amplitude.

# sphinx_gallery_thumbnail_path = 'images/gallery/tuned_absorber.png'
absorber(best).linearize().view(title="Modes of a mass with its absorber")
