r"""
Walking leg
===========

Chebyshev's lambda linkage, of which he built a walking machine in 1878. While the crank makes half a turn, the tip
moves along a line that is nearly straight; then it is lifted. (In the machine a parallelogram carries this motion down
to a foot.) With a crank of length 1 and bars of 2.5 the tip is :math:`4` above the crank's axis in the middle of the
step and :math:`2 \sqrt 6` in the middle of the lift.
"""

import matplotlib.pyplot as plt
import numpy as np

import flexel as fx
from flexel.apps.view.plot import draw

m = fx.Model()
m.point("O", (0, 0), fixed=True)
m.point("C", (2, 0), fixed=True)
m.point("A", (-1, 0))
m.point("B", (0.5, 2))
m.point("foot", (2, 4))
m.angle("crank", np.pi)
m.angle("leg")
m.beam("crank bar", "O", "crank", "A")
m.truss("rocker", "C", "B")
m.beam("leg bar", "A", "leg", "B")
m.body_point("shank", "A", "leg", "foot")
m.prescribe("crank.angle", fx.Polynomial([np.pi, 2 * np.pi]))
motion = m.build().simulate(1, samples=401)

height = motion["foot.y"]
found, known = height[[0, 200]], np.array([4, 2 * np.sqrt(6)])
print("height of the tip in the middle of step and lift", found, "closed form", known)

plt.style.use("flexel.apps.view.style")
figure, axes = plt.subplots(figsize=(4.5, 5))
axes.plot(*motion.position("foot").T)
draw(motion[60], axes, fx.View(centre=(2, 2.5, 0), span=7))
axes.set_title("Path of the foot")
plt.show()

# %%
# The motion: play it, turn it, point at its parts.

# sphinx_gallery_thumbnail_path = 'images/gallery/walking_leg.png'
motion.view(title="A walking leg", view=fx.View(trails=["foot"]))
