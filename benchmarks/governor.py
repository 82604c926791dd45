"""A flyball governor: two arms on a spindle, tied to a sliding collar by stiff springs with dampers."""

from __future__ import annotations

import flexel as fx

SECONDS = 0.5
SPEED = 8.0  # of the spindle when it starts [rad/s]
STIFFNESS, DAMPING = 8e4, 40.0  # of the ties [N/m], [N s/m]


def governor() -> fx.System:
    """Build the governor, which is far from its steady motion when it starts."""
    m = fx.Model(gravity=(0, 0, -9.81))
    m.point("O", (0, 0, 0), fixed=True)
    m.frame("G", fixed=True)
    spindle = m.frame("spindle")
    m.hinge("shaft", "G", spindle, axis=(0, 0, 1))
    m.rotary_inertia("rotor", spindle, (0.1, 0.1, 0.1, 0.0, 0.0, 0.0))
    collar = m.point("collar", (0.0, 0.0, -0.25))
    m.fix("collar.x", "collar.y")
    m.point_mass("collar mass", collar, 1.5)
    for i, side in enumerate((1.0, -1.0)):
        arm = m.frame(f"arm {i}")
        m.hinge(f"pivot {i}", spindle, arm, axis=(0, side, 0))
        ball = m.point(f"ball {i}", (0.15 * side, 0.0, -0.2))
        m.beam(f"bar {i}", "O", arm, ball, mass_per_length=0.5)
        m.point_mass(f"ball mass {i}", ball, 2.0)
        m.truss(f"tie {i}", ball, collar, stiffness=STIFFNESS, damping=DAMPING)
    m.initial("shaft.angle", rate=SPEED)
    return m.build()
