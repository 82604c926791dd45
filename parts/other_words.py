"""Names that beginners and users of other programs look for in a model: the remedy in an AttributeError."""

from __future__ import annotations

from collections.abc import Iterable

from flexel.base.near_names import near_names

CALLS: dict[tuple[str, ...], str] = {
    ("damper", "dashpot", "shock_absorber", "spring_damper"): "a damper is m.spring(on, damping=…)",
    ("force", "torque", "moment", "add_force", "apply_force", "external_force"): "a force is m.load(target, value)",
    ("motor", "actuator", "drive", "driver", "motion"): (
        "a drive that imposes a motion is m.prescribe(name, motion), a given force or torque m.load(target, value)"
    ),
    ("joint", "add_joint"): "joints are m.revolute, m.prismatic, m.spherical, m.universal, m.cylindrical, m.weld, …",
    ("pin", "pin_joint", "hinge_joint", "revolute_joint"): "a pin is m.revolute(name, a, b, at, axis)",
    ("slider", "sliding_joint", "translational", "prismatic_joint"): "a slider is m.prismatic(name, a, b, axis)",
    ("ball", "ball_joint", "spherical_joint"): "a ball joint is m.spherical(name, a, b, at)",
    ("fixed_joint", "rigid_joint", "lock", "clamp_joint"): "m.weld joins two bodies, m.fix holds nodes",
    ("constraint", "add_constraint"): "m.rigid(name) holds a deformation, m.relation relates several quantities",
    ("mass", "particle"): "a mass is m.point_mass(name, point, mass) or m.rigid_body(name, position, mass=…)",
    ("add_body", "rigidbody", "link"): "a body is m.rigid_body(name, position, mass=…, inertia=…)",
    ("rod", "bar", "strut"): "a massless bar is m.truss(name, p, q), one with mass m.beam",
    ("node", "marker", "add_node"): "nodes are m.point(name, position) and m.frame(name)",
    ("pulley", "drum"): "a pulley or drum is m.sheave(name, point, frame, radius=…)",
    ("cable_over_pulleys", "string"): "a rope is m.rope(name, along, elements), a string without mass m.cable",
    (
        "simulate", "equilibrium", "linearize", "state_at", "vibrations", "modes", "root_loci", "buckling",
        "compliance", "steady", "periodic", "summary", "integrate", "solve", "run",
    ): "analyses belong to the built system: s = m.build(), then s.simulate(…), s.equilibrium(), s.linearize(), …",
}  # fmt: skip


def no_call(name: str, known: Iterable[str]) -> str:
    """Write the message for a name that a model does not have: what it is called here, or similar names."""
    start = f"a model has no '{name}'"
    if remedy := next((text for words, text in CALLS.items() if name.lower() in words), ""):
        return f"{start}; {remedy}"
    similar = near_names(name, [word for word in known if not word.startswith("_")])
    return f"{start}; did you mean {', '.join(similar)}?" if similar else start
