"""
Whirling shaft
==============

A disc spins at the end of a flexible shaft. Its gyroscopic moments split each natural frequency into a forward and a
backward whirl. The shaft is massless, so that a matrix of two complex equations gives the exact values.
"""

import matplotlib.pyplot as plt
import numpy as np

import flexel as fx

length, EI, mass, across, along = 0.4, 800.0, 3.0, 0.01, 0.02
m = fx.Model()
m.point("wall", (0, 0, 0), fixed=True)
m.point("tip", (length, 0, 0))
m.frame("clamp", fixed=True)
for name in ("end", "disc"):
    m.frame(name)
m.beam("shaft", "wall", "clamp", "tip", "end", direction=(0, 1, 0), EIy=EI, EIz=EI)
m.hinge("spin", "end", "disc", axis=(1, 0, 0))
m.body("rotor", "tip", "disc", mass=mass, inertia=(along, across, across))
s = m.build()
speeds = np.linspace(0, 600, 61)
loci = s.root_loci(rates={"spin.angle": speeds})

K = EI / length**3 * np.array([[12, -6 * length], [-6 * length, 4 * length**2]])
M, G = np.diag([mass, across]), np.diag([0, along * speeds[-1]])
A = np.block([[np.zeros((2, 2)), np.eye(2)], [-np.linalg.solve(M, K), 1j * np.linalg.solve(M, G)]])
known = np.sort(abs(np.linalg.eigvals(A)))
last = loci.eigenvalues[-1].imag
found = np.sort(last[last > 1])
print("whirls at the highest speed", found, "closed form", known, "rad/s")

plt.style.use("flexel.apps.view.style")
plt.plot(speeds, np.sort(abs(loci.eigenvalues.imag))[:, 2:], "k.", markersize=3)
plt.plot(speeds, speeds, "--", label="whirl = speed: critical speeds")
plt.xlabel("speed of the shaft [rad/s]")
plt.ylabel("frequency of the whirl [rad/s]")
plt.title("Whirl of a shaft with a disc")
plt.legend()
plt.show()

# %%
# The modes at the highest speed, with a slider for the amplitude.

# sphinx_gallery_thumbnail_path = 'images/gallery/whirling_shaft.png'
s.linearize(s.state_at(rates={"spin.angle": speeds[-1]})).view(title="Whirl of a shaft with a disc")
