"""Models that give the numbers which parts can do without, and which no other model of these tests gives."""

from collections.abc import Callable

import numpy as np
from own_cables import OWN_CABLE, OWN_LAW

import flexel as fx
from flexel.derive import Internal, Law, Parameter, symbol
from flexel.parts.elements import compile_law

STEEL = fx.Material(E=210e9, rho=7850.0, G=80e9, strength=300e6)
K, LAG = Parameter("k", 1, "N/m", "stiffness"), Parameter("lag", 1, "s", "relaxation time")
E, ED, CREEP = symbol("e"), symbol("ed"), symbol("creep")
MAXWELL = compile_law(
    Law(
        "own_maxwell", "k (e - creep)", (K, LAG), (E,), (ED,), (), (K.symbol * (E - CREEP),), (),
        K.symbol * (E - CREEP) ** 2 / 2, states=(Internal("creep", "m", (E - CREEP) / LAG.symbol),),
    )
)  # fmt: skip
SECTIONS = {
    "circle": fx.Circle(0.01),
    "tube": fx.Tube(0.02, 0.016),
    "rectangle": fx.Rectangle(0.01, 0.02),
    "box": fx.ClosedProfile([(-0.02, -0.01), (0.02, -0.01), (0.02, 0.01), (-0.02, 0.01)], 0.002),
    "i": fx.IBeam(0.1, 0.05, 0.005, 0.004),
    "l": fx.LBeam(0.1, 0.05, 0.01),
    "u": fx.UBeam(0.1, 0.05, 0.005, 0.004),
}


def cantilever(**given: object) -> fx.Model:
    """A beam that is clamped at one end."""
    m = fx.Model(gravity=(0, 0, -9.81))
    m.point("O", (0, 0, 0), fixed=True)
    m.frame("R", fixed=True)
    m.point("A", (1, 0, 0))
    m.frame("Q")
    m.beam("beam", "O", "R", "A", "Q", direction=(0, 1, 0), **given)  # type: ignore[arg-type]
    return m


def sheared() -> fx.Model:
    """A curved beam with stiffnesses of shear."""
    stiffness = {"EA": 1e6, "GJ": 1e3, "EIy": 1e3, "EIz": 2e3, "GAy": 1e5, "GAz": 2e5}
    return cantilever(
        **stiffness,
        mass_per_length=1.0,
        inertia_per_length=(0.1, 0.1, 0.1),
        initial_curvature=(0.01, 0.02, 0.03),
    )


def of_section(name: str) -> Callable[[], fx.Model]:
    """The beam with a section."""
    return lambda: cantilever(section=SECTIONS[name], material=STEEL)


def slack_line() -> fx.Model:
    """A cable line that is longer than its path, with given places of its nodes."""
    m = fx.Model(gravity=(0, -9.81))
    wire = fx.WireRope(0.01, wire_diameter=0.001)
    m.cable_line(
        "line", [(0.0, 0.0), (1.0, 0.0)], length=0.99, at=(0, 0.3, 0.6, 1), section=wire, material=STEEL
    )
    m.fix("line_p0", "line_p3")
    return m


def stretched_chain() -> fx.Model:
    """A chain of bars that are shorter than they are drawn."""
    m = fx.Model(gravity=(0, -9.81))
    m.chain("chain", [(0.0, 0.0), (1.0, 0.0)], length=0.99, at=(0, 0.3, 0.6, 1), mass_per_length=1.0, EA=1e4)
    m.fix("chain_p0", "chain_p3")
    return m


def spatial_cam() -> fx.Model:
    """A cam about an axis in space under a roller on a guide."""
    m = fx.Model()
    m.rigid_body("a", (0, 0, 0), mass=1.0, inertia=(1.0, 1.0, 1.0))
    m.rigid_body("b", (1, 0, 0), mass=1.0, inertia=(1.0, 1.0, 1.0))
    m.revolute("pin", "ground", "a", at=(0, 0, 0), axis=(0, 0, 1))
    m.prismatic("guide", "ground", "b", axis=(1, 0, 0))
    m.cam("lobe", "a", "b", (1.0, 0.0, 0.0), [1.0, 1.1, 1.2, 1.1, 1.0, 0.9], axis=(0, 0, 1))
    return m


def ball(groove: object = None) -> fx.Model:
    """A ball on bristles on a drum, its centre beside the point of its body."""
    m = fx.Model(gravity=(0, 0, -9.81))
    m.point("C", (0, 0, 0), fixed=True)
    m.frame("G", fixed=True)
    m.sheave("drum", "C", "G", radius=1.0, axle=(1, 0, 0), groove=groove)
    m.point("P", (0, 0, 1.2))
    m.frame("F")
    m.body("ball", "P", "F", mass=1.0, inertia=(1, 2, 1))
    contact = fx.Contact(1e5, friction=0.3, bristle_stiffness=1e3, bristle_damping=0.5)
    m.contact("touch", "P", "drum", contact, frame="F", at=(0.01, 0.02, 1.19), radius=0.2)
    return m


def wound() -> fx.Model:
    """A rope in a helical groove of a drum."""
    m = fx.Model()
    m.point("C", (0, 0, 0), fixed=True)
    m.frame("G", fixed=True)
    groove = fx.HelicalGroove(0.0108, lead=0.024, start=(0, 1, 0.1))
    m.sheave("D", "C", "G", radius=0.09, axle=(1, 0, 0), groove=groove)
    m.point("P", (0.0, 0.1, -1.0), fixed=True)
    m.rope("rope", ["D", "P"], 26, contact=fx.Contact(1e8), radius=0.01, length=1.1, turns=(0.25, 0.0), EA=1e5, EI=1.0,
        mass_per_length=0.1)  # fmt: skip
    return m


def own_pages() -> fx.Model:
    """A cable, a line of cables and a rope on a sheave with an element and a law of the user."""
    own = {"element": OWN_CABLE, "law": OWN_LAW, "parameters": {"hardening": 200.0}, "EA": 1e5, "EI": 1.0}
    m = fx.Model(gravity=(0, -9.81))
    m.point("A", (0, 0), fixed=True)
    m.point("B", (1, 0))
    m.cable("cable", "A", m.slope("a", (1, 0)), "B", m.slope("b", (1, 0)), **own)  # type: ignore[arg-type]
    m.cable_line("line", [(0, -1), (1, -1)], 2, **own)  # type: ignore[arg-type]
    m.point("C", (0, 2), fixed=True)
    m.angle("F", fixed=True)
    m.sheave("S", "C", "F", radius=0.3)
    m.point("P", (-0.3, 1), fixed=True)
    m.point("Q", (0.3, 1))
    m.rope("rope", ["P", "S", "Q"], 12, contact=fx.Contact(1e8), radius=0.01, **own)  # type: ignore[arg-type]
    m.fix("line_p0", "line_p2", "Q")
    return m


def slider() -> fx.Model:
    """Two masses on a line, with bars between."""
    m = fx.Model()
    m.point("O", (0, 0, 0), fixed=True)
    for name, x in (("A", 1), ("B", 2)):
        m.point(name, (x, 0, 0))
        m.fix(f"{name}.y", f"{name}.z")
        m.point_mass(f"mass {name}", name, 2.0)
    m.truss("bar", "O", "A")
    m.truss("rod", "A", "B")
    return m


def strained() -> fx.Model:
    """Springs with a free length and with a preload, for one deformation and for two that a matrix couples."""
    m = slider()
    matrix = [[3.0, 1.0], [1.0, 2.0]]
    m.spring("bar.elongation", 100.0, free_length=0.9)
    m.spring("rod.elongation", 100.0, preload=3.0)
    m.spring(["bar.elongation", "rod.elongation"], matrix, free_length=[1.1, 0.9])
    m.spring(["bar.elongation", "rod.elongation"], matrix, preload=[0.2, -0.1])
    return m


def creeping() -> fx.Model:
    """A law with an internal state of its own."""
    m = slider()
    m.law(["bar.elongation"], MAXWELL, name="damper", k=50.0, lag=0.3, initial={"creep": 0.01})
    m.law("rod.elongation", MAXWELL, k=50.0, lag=0.3)
    return m


def rolling() -> fx.Model:
    """Magic Formula tyres whose slips lag, one with its law, and one that a law was attached to."""
    values = {
        "stiffness": 5e4, "damping": 300.0, "load0": 4000.0, "rolling_radius": 0.3, "friction": (0.9, -0.1),
        "slip_stiffness": 15.0, "cornering": (12.0, 2.0), "camber_stiffness": 0.5, "shape": (1.3, -0.2),
        "trail": (0.03, 5.0), "relaxation": (0.2, 0.4),
    }  # fmt: skip
    m = fx.Model(gravity=(0, 0, -9.81))
    for name, y in (("left", 1.0), ("right", -1.0)):
        m.point(f"{name} hub", (0.0, y, 0.28))
        m.frame(f"{name} wheel")
        m.body(f"{name} rim", f"{name} hub", f"{name} wheel", mass=40.0, inertia=(1.2, 1.4, 1.2))
    wheel = {"radius": 0.3, "axle": (0, 1, 0), "crown": 0.05}
    start = {"kappa": 0.01, "tan_alpha": 0.02}
    m.tyre("left", "left hub", "left wheel", **wheel, law="magic_formula", initial=start, **values)
    m.tyre("right", "right hub", "right wheel", **wheel)
    slips = ("deflection", "camber", "forward", "rolling", "longitudinal", "lateral", "spin")
    m.attach("magic_formula", [f"right.{slip}" for slip in slips], name="rubber", initial=start, **values)
    return m


def regulated(**given: float) -> fx.Model:
    """A controller of gains."""
    m = slider()
    m.controller(np.array([[30.0, 2.0]]), inputs=["A.x", "A.x'"], outputs=["B.x"], **given)  # type: ignore[arg-type]
    return m


def held() -> fx.Model:
    """A mass that is kept at a place beside its drawn one."""
    m = slider()
    m.spring("bar.elongation", 100.0)
    m.spring("rod.elongation", 100.0)
    m.prescribe("B.x", 2.1)
    return m


OPTIONAL: dict[str, Callable[[], fx.Model]] = {
    "sheared": sheared,
    **{f"section {name}": of_section(name) for name in SECTIONS},
    "slack line": slack_line,
    "stretched chain": stretched_chain,
    "spatial cam": spatial_cam,
    "ball": ball,
    "ball in a groove": lambda: ball(fx.VGroove(1.2)),
    "wound": wound,
    "own pages": own_pages,
    "strained": strained,
    "creeping": creeping,
    "rolling": rolling,
    "regulated": regulated,
    "sampled": lambda: regulated(period=0.01, delay=0.004),
    "held": held,
}
