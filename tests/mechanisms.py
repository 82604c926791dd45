"""Mechanisms that several tests share."""

import json
from pathlib import Path

import numpy as np

import flexel as fx

DATA = Path(__file__).parent / "data"
DISC = json.loads((DATA / "rolling_disc.json").read_text())["data"]


def pendulum_model() -> fx.Model:
    """A planar rod of 1 m, at 60 degrees below the horizontal."""
    m = fx.Model(gravity=(0, -9.81))
    m.point("O", (0, 0), fixed=True)
    m.point("A", (0.5, -np.sqrt(0.75)))
    m.angle("ground", fixed=True)
    m.angle("turn")
    m.hinge("pivot", "ground", "turn")
    m.beam("rod", "O", "turn", "A", mass_per_length=1.0)
    return m


def pendulum() -> fx.System:
    """The rod, let go."""
    return pendulum_model().build()


def cantilever() -> fx.System:
    """A steel strip clamped at one end."""
    m = fx.Model()
    m.point("O", (0, 0, 0), fixed=True)
    m.point("A", (0.1, 0, 0))
    m.frame("wall", fixed=True)
    m.frame("tip")
    strip = fx.Rectangle(0.5e-3, 10e-3)
    m.beam("leaf", "O", "wall", "A", "tip", direction=(0, 1, 0), section=strip, material="steel")
    return m.build()


def rssr(universal: bool) -> fx.Model:
    """Crank about z, rocker about a skew axis, and a coupler between two ball joints (or one ball, one universal)."""
    m = fx.Model(gravity=(0, 0, -9.81))
    A0, D0 = m.point("A", (0, 0, 0), fixed=True), m.point("D", (1.5, 0.3, 0.2), fixed=True)
    b, c = m.point("B", (0.4, 0, 0)), m.point("C", (1.4, 0.9, 0.9))
    ground, crank, rocker = (m.frame(name, fixed=name == "ground") for name in ("ground", "crank", "rocker"))
    m.hinge("input", ground, crank, axis=(0, 0, 1))
    m.hinge("output", ground, rocker, axis=(1, 0.2, -0.1))
    m.beam("crank bar", A0, crank, b, mass_per_length=1.0)
    m.beam("rocker bar", D0, rocker, c, mass_per_length=1.0, inertia_per_length=(0.01, 0.02, 0.02))
    if universal:
        cross, coupler = m.frame("cross"), m.frame("coupler")
        line = np.array([1.0, 0.9, 0.9])
        first = np.cross(line, (0, 0, 1))
        m.hinge("pin1", crank, cross, axis=first)
        m.hinge("pin2", cross, coupler, axis=np.cross(line, first))
        m.beam("coupler bar", b, coupler, c, mass_per_length=0.5)
    else:
        m.truss("coupler bar", b, c, mass_per_length=0.5)
    m.independent("input.angle")
    m.initial("input.angle", 0.0, rate=2.0)
    return m


def disc(theta: float = np.pi / 2, rates: tuple[float, float, float] = (0.0, 0.0, 0.0)) -> fx.Model:
    """Disc with heading ψ (yaw), inclination θ of its axis (lean + π/2) and spin φ; rates (ψ', θ', ω₃)."""
    m = fx.Model(gravity=(0, 0, -DISC["g"]))
    ground, yawed, leaned, rolled = (
        m.frame(name, fixed=name == "ground") for name in ("ground", "Y", "L", "S")
    )
    hub, contact = m.point("hub", (0, 0, DISC["r"])), m.point("contact", (0, 0, 0))
    axle = (0, -1, 0)
    m.hinge("yaw", ground, yawed, axis=(0, 0, 1))
    m.hinge("lean", yawed, leaned, axis=(1, 0, 0))
    m.hinge("roll", leaned, rolled, axis=axle)
    m.wheel("wheel", hub, rolled, contact, radius=DISC["r"], axle=axle)
    m.body("disc", hub, rolled, mass=DISC["m"], inertia=(DISC["It"], DISC["Ia"], DISC["It"]))
    m.independent("yaw.angle", "lean.angle", "roll.angle")
    m.kinematic("contact.x", "contact.y")
    m.initial("lean.angle", theta - np.pi / 2, rate=rates[1])
    m.initial("yaw.angle", rate=rates[0])
    m.initial("roll.angle", rate=rates[2] - rates[0] * np.cos(theta))
    return m


def heavy_top() -> fx.System:
    data = json.loads((DATA / "heavy_top.json").read_text())["data"]
    m = fx.Model(gravity=data["gravity"])
    O, R = m.point("O", (0, 0, 0), fixed=True), m.frame("top")
    m.body("body", O, R, mass=data["mass"], inertia=data["J_com_body"], offset=data["com_in_body"])
    w = m.angular_velocity(R, body_axes=True)
    for axis, rate in zip("xyz", data["omega0_body"], strict=True):
        m.initial(f"{w}.w{axis}", rate=rate)
    return m.build()


def oscillator(speed: float, zeta: float = 0.05, cubic: float = 0.0, push: float = 1.0) -> fx.System:
    """A mass of 1 kg on a spring of 1 N/m, with a cubic part, under a harmonic force."""
    m = fx.Model()
    m.point("O", (0, 0), fixed=True)
    m.point("P", (10, 0))
    m.fix("P.y")
    m.point_mass("mass", "P", 1.0)
    m.truss("spring", "O", "P")
    m.law("spring.elongation", lambda e, ed: e + cubic * e**3 + 2 * zeta * ed)
    m.load("P.x", lambda t: push * np.cos(speed * t))
    m.independent("P.x")
    return m.build()


def slider_crank(dof: str) -> fx.Model:
    """A crank on a fixed hinge that drives a slider over a longer rod, in the plane."""
    m = fx.Model(gravity=(0, -9.81))
    O, A, B = m.point("O", (0, 0), fixed=True), m.point("A", (0.0, 0.3)), m.point("B", (0.8, 0.0))
    m.fix("B.y")
    ground, crank, rod = m.angle("ground", fixed=True), m.angle("crank"), m.angle("rod")
    m.hinge("crank hinge", ground, crank)
    m.beam("crank bar", O, crank, A, mass_per_length=3.0)
    m.beam("rod bar", A, rod, B, mass_per_length=2.0)
    m.point_mass("slider", B, 0.5)
    if dof:
        m.independent(dof)
    m.initial("crank hinge.angle", rate=12.0)
    return m


def slider(mass: float = 2.0, force: float = 0.0) -> fx.Model:
    """A mass on a line, held by whatever law is put on the truss 'strut' (drawn 1 m long)."""
    m = fx.Model()
    m.point("O", (0, 0, 0), fixed=True)
    m.point("A", (1, 0, 0))
    m.fix("A.y", "A.z")
    m.truss("strut", "O", "A")
    m.point_mass("body", "A", mass)
    if force:
        m.load("A.x", force)
    m.independent("strut.elongation")
    return m


def strut(length: float = 1.0) -> fx.Model:
    """A point mass on a bar along x that may change its length."""
    m = fx.Model()
    m.point("O", (0, 0, 0), fixed=True)
    m.point("A", (length, 0, 0))
    m.fix("A.y", "A.z")
    m.truss("strut", "O", "A")
    m.point_mass("mass", "A", 2.0)
    m.independent("strut.elongation")
    return m
