r"""
Cost and error of the integrators
=================================

A chain of three links swings from the horizontal for two seconds. The table shows what each method and tolerance costs,
and how far the end is from a result with a tolerance of 1e-12. The explicit method of order 8, DOP853, is the cheapest
for mechanisms without high frequencies. The implicit methods are for stiff models: Radau IIA, of order 5, for smooth
motions; generalized-:math:`\alpha`, of order 2, for contact and large models.
"""

import matplotlib.pyplot as plt
import numpy as np

import flexel as fx

m = fx.Model(gravity=(0, -9.81))
chain = m.chain("chain", [(0, 0), (1, 0)], 3, mass_per_length=1.0)
m.fix(chain.points[0])
s = m.build()
end = chain.points[-1].name
exact = s.simulate(2, rtol=1e-12, atol=1e-14).position(end)[-1]
cases = {
    "DOP853": (1e-4, 1e-6, 1e-8, 1e-10),
    "Radau": (1e-4, 1e-6, 1e-8),
    "generalized-alpha": (1e-4, 1e-6, 1e-8),
}
print(f"{'method':18}{'tolerance':>10}{'evaluations':>13}{'error':>10} m")
plt.style.use("flexel.apps.view.style")
for method, tolerances in cases.items():
    costs, errors = [], []
    for tolerance in tolerances:
        motion = s.simulate(2, method=method, rtol=tolerance, atol=tolerance / 100)
        costs.append(motion.statistics["evaluations"])
        errors.append(np.linalg.norm(motion.position(end)[-1] - exact))
        print(f"{method:18}{tolerance:10.0e}{costs[-1]:13d}{errors[-1]:10.1e}")
    plt.loglog(costs, errors, "o-", label=method)
found, known = s.simulate(2).position(end)[-1], exact  # with the tolerances of flexel

plt.xlabel("evaluations of the equations of motion [-]")
plt.ylabel("error of the end [m]")
plt.title("Cost and error of the integrators")
plt.legend()
plt.show()

# %%
# The motion: play it, turn it, point at its parts.

# sphinx_gallery_thumbnail_path = 'images/gallery/integrators.png'
motion.view(title="A pendulum of three links", view=fx.View(trails=[end]))
