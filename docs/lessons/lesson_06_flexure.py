"""
6. A flexure
============

A stage on two leaf springs: stiffness, natural frequencies, parasitic motion and stress, in space.
"""

# %%
# The parallelogram
# -----------------
# Each leaf is clamped to the ground and to the stage. ``m.leaf_spring`` divides it into beams, with a section
# and a material. The stage is a body: its orientation is that of both upper ends.

import flexel as fx

length, thickness, width, distance = 0.05, 0.3e-3, 20e-3, 0.06
strip = fx.Rectangle(thickness, width)


def guide():
    m = fx.Model()
    m.frame("ground", fixed=True)
    m.frame("stage")
    for name, x in (("left", 0.0), ("right", distance)):
        m.point(f"{name} foot", (x, 0, 0), fixed=True)
        m.point(f"{name} top", (x, 0, length))
        m.leaf_spring(
            name,
            f"{name} foot",
            "ground",
            f"{name} top",
            "stage",
            direction=(1, 0, 0),
            section=strip,
            material="steel",
        )
    m.beam("plate", "left top", "stage", "right top")
    m.body("table", "left top", "stage", mass=0.2, inertia=(1e-4, 1e-4, 1e-4), offset=(distance / 2, 0, 0))
    return m


# %%
# Over-constraint
# ---------------
# Two leaves hold the stage in more ways than needed: in reality this is what makes a flexure sensitive to
# tolerances. The leaves are elastic in all directions here, so that nothing has to be released.

s = guide().build()
print(s)

# %%
# Frequencies
# -----------

lin = s.linearize()
for mode in lin.modes()[:3]:
    print(f"{mode.hertz:.2f} Hz")
lin.plot_mode(0)

# %%
# Stroke
# ------
# A force moves the stage by millimetres. It also moves down: by 3 u²/(5 l).

m = guide()
m.load("left top.x", lambda t: 4.0 * t)
path = m.build().static_path(t_end=1.0)
u, down = path["left top.x"][-1], length - path["left top.z"][-1]
print(
    f"stroke {1e3 * u:.3f} mm, parasitic {1e6 * down:.2f} µm, closed form {1e6 * 0.6 * u**2 / length:.2f} µm"
)
path.plot_shapes(1.0)

# %%
# Stress
# ------

worst = path[-1].largest_stress()
print(f"{worst.mises / 1e6:.1f} MPa in {worst.beam}, end {worst.end}")

# %%
# Exercise
# --------
# Each leaf has the stiffness 12 EI/l³ when its ends do not turn, with E/(1 - ν²) in place of E if it is wide
# (a beam knows nothing of that). Compare the stiffness of the stage for a small force with two leaves of
# beams.
#
# Solution
# --------

m = guide()
m.load("left top.x", 1e-3)
small = m.build().equilibrium()
found = 1e-3 / small["left top.x"]
E = 210e9
known = 2 * 12 * E * width * thickness**3 / 12 / length**3
print("stiffness", found, "N/m, closed form", known, "N/m")
