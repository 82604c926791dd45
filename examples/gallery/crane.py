r"""
Crane with a swinging load
==========================

The trolley of a crane moves by 5 m. After most moves the load swings. With the smooth profile of `fx.Ramp` it
hangs still if the move takes 1.8346 periods: then :math:`\omega T/2 = 5.7635`, the first zero of the
spherical Bessel function :math:`j_2`.
"""

import matplotlib.pyplot as plt
import numpy as np

import flexel as fx

length = 4.0
period = 2 * np.pi * np.sqrt(length / 9.81)


def crane(periods: float) -> fx.System:
    """Return the crane, whose trolley moves for so many periods of the load."""
    m = fx.Model(gravity=(0, -9.81))
    m.point("trolley", (0, 0))
    m.point("load", (0, -length))
    m.fix("trolley.y")
    m.truss("rope", "trolley", "load")
    m.point_mass("mass", "load", 1000.0)
    m.prescribe("trolley.x", fx.Ramp(0, periods * period, 0, 5))
    m.independent("load.x")
    return m.build()


motions = {periods: crane(periods).simulate(16) for periods in (1.3, 1.8346)}
found, known = crane(1).linearize().modes()[0].omega, 2 * np.pi / period
print("swings at", found, "closed form", known, "rad/s")

plt.style.use("flexel.apps.view.style")
for periods, motion in motions.items():
    plt.plot(motion.t, motion["load.x"] - motion["trolley.x"], label=f"{periods} periods")
plt.xlabel("time [s]")
plt.ylabel("load ahead of the trolley [m]")
plt.title("Swing of the load")
plt.legend(title="duration of the move")
plt.show()

# %%
# The move after which the load swings: play it, turn it, point at its parts.

# sphinx_gallery_thumbnail_path = 'images/gallery/crane.png'
motions[1.3].view(title="A crane with a swinging load")
