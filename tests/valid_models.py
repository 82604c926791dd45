"""Valid calls of the methods of `Model`; what they declare is judged by `Model.build`."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

from scipy.signal import StateSpace
from valid_call import Valid, calling

import flexel as fx
from flexel.parts.nodes import Point


def spatial() -> fx.Model:
    """A rod on a hinge, with a body at its end, and nodes of all kinds beside it."""
    m = fx.Model(gravity=(0, 0, -9.81))
    m.point("O", (0, 0, 0), fixed=True)
    m.point("A", (1, 0, 0))
    m.frame("R0", fixed=True)
    m.frame("R1")
    m.hinge("pivot", "R0", "R1", axis=(0, 1, 0))
    m.beam("rod", "O", "R1", "A", mass_per_length=2.0, inertia_per_length=(0.1, 0.1, 0.1))
    return m


def spare(*kinds: str) -> fx.Model:
    """The same with further nodes: points P, Q, frames F, slopes D, E."""
    m = spatial()
    for kind in kinds:
        if kind in "PQ":
            m.point(kind, (0, 1.0 + (kind == "Q"), 0))
        elif kind in "FG":
            m.frame(kind)
        else:
            m.slope(kind, (1, 0, 0))
    return m


def planar() -> fx.Model:
    """Two wheels on fixed axles, and a rod."""
    m = fx.Model(gravity=(0, -9.81))
    for name, x in (("A", 0.0), ("B", 0.5)):
        m.point(name, (x, 0), fixed=True)
        m.angle(f"F{name}")
        m.rotary_inertia(f"I{name}", f"F{name}", 0.1)
    return m


def rolling() -> fx.Model:
    """A hub in the plane."""
    m = planar()
    m.point("P", (0, 1))
    m.point_mass("mass", "P", 1.0)
    return m


def sheaves() -> fx.Model:
    """A sheave that does not turn, and the ends of a rope over it."""
    m = fx.Model()
    m.point("C", (0, 0), fixed=True)
    m.angle("G", fixed=True)
    m.sheave("S", "C", "G", radius=0.1)
    m.point("A", (-0.101, -0.4), fixed=True)
    m.point("B", (0.4, 0.101), fixed=True)
    return m


def lined() -> tuple[fx.Model, Any]:
    """A cable line above a plane."""
    m = fx.Model()
    m.point("C", (0, 0), fixed=True)
    m.angle("G", fixed=True)
    m.plane("floor", "C", "G", normal=(0, 1))
    line = m.cable_line("line", [(0.0, 0.1), (1.0, 0.1)], 3, EA=1e5, EI=1.0, mass_per_length=0.1)
    return m, line


def declared(make: Callable[[], fx.Model], method: str, **arguments: Any) -> Callable[[], Valid]:
    """A declaration in a model made anew, and its building."""

    def made() -> Valid:
        m = make()
        return Valid(getattr(m, method), arguments, lambda result: m.build() and None)

    return made


def rope_contact() -> Valid:
    """Contact of a line with a plane."""
    m, line = lined()
    arguments = {"cables": line, "surface": "floor", "contact": fx.Contact(1e6), "radius": 0.01}
    return Valid(m.rope_contact, arguments, lambda result: m.build() and None)


def own_law() -> fx.Model:
    """A bar whose elongation waits for a law."""
    m = spare("P")
    m.truss("bar", "A", "P", mass_per_length=1.0)
    return m


CABLE = {"EA": 1e5, "EI": 1.0, "mass_per_length": 0.1}
BEAM = {
    "EA": 1e6, "GJ": 1e3, "EIy": 1e3, "EIz": 1e3, "EIw": 1.0, "mass_per_length": 1.0,
    "warping_inertia_per_length": 1e-3, "warping": True,
}  # fmt: skip


def hub() -> fx.Model:
    """A hub one metre above the ground."""
    m = fx.Model()
    m.point("P", (0, 0, 1.0))
    m.frame("F")
    m.point("T", (0, 0, 0))
    m.body("disc", "P", "F", mass=1.0, inertia=(1, 2, 1))
    return m


def touching() -> fx.Model:
    """A ball over a floor."""
    m = hub()
    m.point("O", (0, 0, 0), fixed=True)
    m.frame("G", fixed=True)
    m.plane("floor", "O", "G")
    return m


def axle() -> fx.Model:
    """Two wheels on one axle."""
    m = hub()
    m.frame("F2")
    m.rotary_inertia("I2", "F2", (1, 1, 1, 0, 0, 0))
    m.point("P2", (0, 1, 1.0))
    m.point_mass("mass2", "P2", 1.0)
    return m


MODELS: dict[str, Callable[[], Valid]] = {
    "Model": lambda: calling(fx.Model, gravity=(0, 0, -9.81)),
    "Model.anchor": declared(
        lambda: spare("P", "D"), "anchor", name="z", point="O", frame="R1", end="P", slope="D"
    ),
    "Model.angle": declared(planar, "angle", name="z", value=0.5, fixed=True),
    "Model.angular_velocity": declared(spatial, "angular_velocity", frame="R1"),
    "Model.attach": declared(
        own_law,
        "attach",
        law="stop",
        on=["bar.elongation"],
        name="l",
        parameters={"gap": 0.1, "stiffness": 5.0, "damping": 0.1},
    ),
    "Model.add": lambda: calling(fx.Model().add, part=Point("z", (0.0, 0.0))),
    "Model.of": lambda: calling(fx.Model.of, gravity=(0.0, -9.81), parts=[Point("z", (0.0, 0.0))]),
    "Model.save": lambda: calling(spatial().save, path=Path("model.json")),
    "Model.axle_slip": declared(axle, "axle_slip", name="z", left=("P", "F"), right=("P2", "F2"), axle=(0, 1, 0)),
    "Model.beam": declared(
        lambda: spare("P", "F"), "beam", name="z", p="A", frame_p="R1", q="P", frame_q="F", direction=(0, 0, 1), **BEAM
    ),
    "Model.bearing": declared(
        lambda: spare("P", "F"), "bearing", name="z", p="O", rp="R0", q="P", rq="F", axis=(0, 1, 0)
    ),
    "Model.body": declared(
        spatial, "body", name="z", point="A", frame="R1", mass=1.0, inertia=(1.0, 1.0, 1.0), offset=(0.1, 0, 0)
    ),
    "Model.body_point": declared(lambda: spare("P"), "body_point", name="z", p="O", frame="R1", q="P"),
    "Model.build": lambda: calling(spatial().build),
    "Model.cable": declared(
        lambda: spare("P", "Q", "D", "E"), "cable", name="z", p="P", slope_p="D", q="Q", slope_q="E",
        length=1.0, **CABLE
    ),
    "Model.cable_line": declared(
        fx.Model, "cable_line", name="z", path=[(0.0, 0.0), (1.0, 0.0)], n=2, **CABLE
    ),
    "Model.chain": declared(
        fx.Model, "chain", name="z", path=[(0.0, 0.0), (1.0, 0.0)], n=2, mass_per_length=1.0, EA=1e3
    ),
    "Model.clamp": declared(lambda: spare("D"), "clamp", name="z", frame="R1", slope="D"),
    "Model.contact": declared(
        touching, "contact", name="z", point="P", surface="floor", contact=fx.Contact(1e5), frame="F", radius=0.1
    ),
    "Model.distributed_load": declared(spatial, "distributed_load", beam="rod", value=(0.0, 0.0, 1.0)),
    "Model.element": declared(
        lambda: spare("P"), "element", name="z", kind="truss", nodes=("A", "P"), parameters={"l0": 1.0, "rhoA": 0.1}
    ),
    "Model.controller": declared(
        spatial, "controller", function=StateSpace(1.0, [[0.1, 0.0]], 1.0, [[1.0, 1.0]], dt=0.01), name="z",
        inputs=["pivot.angle", "pivot.angle'"],
        outputs=["pivot.angle"], period=0.01, delay=0.02, limits=(-1.0, 1.0), reference={"pivot.angle": 0.1},
        anti_windup=0.1, state=[0.0],
    ),
    "Model.fix": declared(lambda: spare("P"), "fix", names=("P.x", "P.y", "P.z")),
    "Model.frame": declared(spatial, "frame", name="z", orientation=(1.0, 0.0, 0.0, 0.0), fixed=True),
    "Model.hinge": declared(
        lambda: spare("F"), "hinge", name="z", p="R1", q="F", axis=(0, 1, 0), stiffness=1.0, damping=0.1
    ),
    "Model.independent": declared(spatial, "independent", names=("pivot.angle",)),
    "Model.initial": declared(spatial, "initial", name="pivot.angle", value=0.1, rate=0.2),
    "Model.kinematic": declared(spatial, "kinematic", names=()),
    "Model.law": declared(spatial, "law", on="pivot.angle", law=lambda e, ed: 3 * e + ed, energy=lambda e: 1.5 * e**2),
    "Model.load": declared(spatial, "load", target="A", value=(0.0, 0.0, 1.0)),
    "Model.mass_damping": declared(spatial, "mass_damping", element="rod", rate=0.1),
    "Model.planar_belt": declared(
        planar, "planar_belt", name="b", p="A", angle_p="FA", q="B", angle_q="FB", radius_p=0.2, radius_q=0.1,
        stiffness=1e3
    ),
    "Model.planar_gear": declared(
        planar, "planar_gear", name="g", p="A", angle_p="FA", q="B", angle_q="FB", radius_p=0.2, radius_q=0.3
    ),
    "Model.planar_wheel": declared(
        rolling, "planar_wheel", name="z", point="P", heading="FA", spin="FB", radius=0.1, direction=(1.0, 0.0)
    ),
    "Model.plane": declared(spatial, "plane", name="z", point="O", frame="R0", normal=(0.0, 0.0, 1.0)),
    "Model.point": declared(spatial, "point", name="z", position=(0.0, 0.0, 1.0), fixed=True),
    "Model.point_mass": declared(spatial, "point_mass", name="z", point="A", mass=1.0),
    "Model.prescribe": declared(spatial, "prescribe", name="pivot.angle", motion=fx.Harmonic(1.0, 2.0)),
    "Model.quadric": declared(
        touching, "quadric", name="z", point="P", quadratic=(1.0, 1.0, 1.0, 0.0, 0.0, 0.0), constant=-1.0
    ),
    "Model.relation": declared(planar, "relation", name="z", terms={"FA.angle": 1.0, "FB.angle": -2.0}),
    "Model.release": declared(spatial, "release", names=("pivot.bend1",)),
    "Model.rigid": declared(own_law, "rigid", names=("bar.elongation",)),
    "Model.rope": declared(
        sheaves, "rope", name="z", path=["A", "S", "B"], n=20, contact=fx.Contact(1e8, dissipation=10.0), radius=1e-3,
        tension=5.0, EA=1e5, EI=1e-5, mass_per_length=0.01,
    ),
    "Model.rope_contact": rope_contact,
    "Model.look": declared(
        spatial, "look", elements=["rod"], section=fx.Circle(0.1), colour=(0.1, 0.2, 0.3), opacity=0.5, hidden=False
    ),
    "Model.rotary_inertia": declared(
        spatial, "rotary_inertia", name="z", frame="R1", inertia=(1.0, 1.0, 1.0, 0.0, 0.0, 0.0)
    ),
    "Model.sheave": declared(
        spatial, "sheave", name="z", point="O", frame="R0", radius=0.1, axle=(0.0, 0.0, 1.0),
        groove=fx.RoundGroove(0.01)
    ),
    "Model.slope": declared(spatial, "slope", name="z", direction=(1.0, 0.0, 0.0), fixed=True),
    "Model.spring": declared(spatial, "spring", on="pivot.angle", stiffness=1.0, damping=0.1),
    "Model.stop": declared(own_law, "stop", name="bar.elongation", gap=0.1, stiffness=1e3, damping=1.0),
    "Model.truss": declared(
        lambda: spare("P"), "truss", name="z", p="A", q="P", stiffness=1e3, damping=1.0, mass_per_length=0.1
    ),
    "Model.tyre": declared(
        hub, "tyre", name="z", hub="P", frame="F", radius=1.0, axle=(0, 1, 0), road=fx.Waves(0.01, 1.0),
        law="vertical_tyre", parameters={"stiffness": 1e5, "damping": 10.0},
    ),
    "Model.warping": declared(spatial, "warping", name="z", fixed=True),
    "Model.wheel": declared(
        hub, "wheel", name="z", hub="P", frame="F", contact="T", radius=1.0, axle=(0, -1, 0), normal=(0, 0, 1)
    ),
}  # fmt: skip
