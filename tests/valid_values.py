"""Valid calls of the public functions and of the classes of values."""

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import numpy as np
from own_elements import own_bar
from swept import numbers, plain
from travellers import HARDENING
from valid_call import Valid, calling

import flexel as fx

DATA = Path(__file__).parent / "data"


def with_section(section: Any) -> None:
    """A beam with the section."""
    m = fx.Model()
    m.point("O", (0, 0, 0), fixed=True)
    m.point("A", (1, 0, 0))
    m.frame("R0", fixed=True)
    m.frame("R1")
    m.beam(
        "b", "O", "R0", "A", "R1", direction=(0, 1, 0), section=section, material=fx.Material(1e9, 1e3, 0.3)
    )
    m.build()


def with_material(material: Any) -> None:
    """A beam of the material."""
    m = fx.Model()
    m.point("O", (0, 0, 0), fixed=True)
    m.point("A", (1, 0, 0))
    m.frame("R0", fixed=True)
    m.frame("R1")
    m.beam("b", "O", "R0", "A", "R1", direction=(0, 1, 0), section=fx.Circle(0.1), material=material)
    m.build()


def with_motion(motion: Any) -> None:
    """A point that is moved."""
    m = fx.Model()
    m.point("O", (0, 0), fixed=True)
    m.point("A", (1, 0))
    m.fix("A.y")
    m.prescribe("A.x", motion)
    m.build()


def with_curve(curve: Any) -> None:
    """A spring with the curve."""
    m = fx.Model()
    m.point("O", (0, 0), fixed=True)
    m.point("A", (1, 0))
    m.fix("A.y")
    m.point_mass("mass", "A", 1.0)
    m.spring("A.x", curve)
    m.build()


def with_contact(contact: Any) -> None:
    """A ball over a plane."""
    m = fx.Model()
    m.point("O", (0, 0, 0), fixed=True)
    m.frame("G", fixed=True)
    m.frame("R")
    m.plane("floor", "O", "G")
    m.point("A", (0, 0, 0.5))
    m.body("ball", "A", "R", mass=1.0, inertia=(1, 1, 1))
    m.contact("touch", "A", "floor", contact, frame="R", radius=0.1)
    m.build()


def with_groove(groove: Any) -> None:
    """A sheave with the groove."""
    m = fx.Model()
    m.point("O", (0, 0, 0), fixed=True)
    m.frame("G", fixed=True)
    m.sheave("S", "O", "G", radius=0.5, groove=groove)


def with_road(road: Any) -> None:
    """A tyre on the road."""
    m = fx.Model()
    m.point("H", (0, 0, 0.4))
    m.frame("R")
    m.body("wheel", "H", "R", mass=1.0, inertia=(1, 1, 1))
    m.tyre("tyre", "H", "R", radius=0.4, axle=(0, 1, 0), road=road)
    m.build()


def with_event(event: Any) -> None:
    """A motion in which the event is looked for."""
    m = fx.Model()
    m.point("A", (0, 0))
    m.fix("A.y")
    m.point_mass("mass", "A", 1.0)
    m.build().simulate(0.01, samples=2, events=[event])


def with_view(view: Any) -> None:
    """A page."""
    m = fx.Model()
    m.point("A", (0, 0, 0))
    m.point_mass("mass", "A", 1.0)
    m.build().simulate(0.01, samples=2).view("scene.html", view=view)


def with_solid(solid: Any) -> None:
    """A page with it."""
    with_view(fx.View(sketches=[solid]))


def in_beam(stressed: Any) -> Callable[[Any], None]:
    """Stresses of a section under the forces."""
    return lambda forces: stressed.stresses(forces) and None


FORCES = fx.SectionForces(1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0)
SECTIONS = {
    "Circle": fx.Circle(0.1),
    "ClosedProfile": fx.ClosedProfile([(0, 0), (0.1, 0), (0.1, 0.05), (0, 0.05)], 0.002),
    "IBeam": fx.IBeam(0.2, 0.1, 0.01, 0.01),
    "LBeam": fx.LBeam(0.1, 0.08, 0.01),
    "Rectangle": fx.Rectangle(0.1, 0.2),
    "Tube": fx.Tube(0.1, 0.05),
    "UBeam": fx.UBeam(0.2, 0.1, 0.01, 0.01),
    "WireRope": fx.WireRope(0.02),
}


def _sections() -> dict[str, Callable[[], Valid]]:
    found: dict[str, Callable[[], Valid]] = {}
    for name, section in SECTIONS.items():
        found[f"{name}.shear_factors"] = lambda profile=section: calling(profile.shear_factors, nu=0.3)
        found[f"{name}.stresses"] = lambda profile=section: calling(profile.stresses, f=FORCES)
    return found


def points() -> fx.Points:
    """Six points of a grid."""
    return fx.grid({"a": [1.0, 2.0], "b": [3.0, 4.0, 5.0]})


TABLE = fx.Table([0.0, 1.0, 2.0, 3.0], [0.0, 1.0, 0.0, 1.0])
CONTACT = fx.Contact(1e6)
WAVES = fx.Waves(0.01, 1.0)
COUNTS: Mapping[str, Any] = {"executor": "serial", "progress": False}

VALUES: dict[str, Callable[[], Valid]] = {
    "Circle": lambda: Valid(fx.Circle, {"diameter": 0.1}, with_section),
    "ClosedProfile": lambda: Valid(
        fx.ClosedProfile,
        {"corners": [(0.0, 0.0), (0.1, 0.0), (0.1, 0.05), (0.0, 0.05)], "thickness": 0.002},
        with_section,
    ),
    "Contact": lambda: Valid(fx.Contact, {"stiffness": 1e6}, with_contact),
    "Contact.restitution": lambda: Valid(
        fx.Contact.restitution, {"stiffness": 1e6, "restitution": 0.5, "speed": 1.0}, with_contact
    ),
    "Contact.depth": lambda: calling(CONTACT.depth, load=1.0, length=0.1),
    "Curve": lambda: Valid(fx.Curve, {"pieces": [[0, 3e4], [-700.0, 4e4]], "breaks": [0.07]}, with_curve),
    "Curve.through": lambda: Valid(
        fx.Curve.through, {"x": np.array([0.0, 1.0, 2.0]), "y": np.array([0.0, 1.0, 4.0])}, with_curve
    ),
    "Event": lambda: Valid(fx.Event, {"name": "e", "function": lambda state: state["A.x"] - 1.0}, with_event),
    "Harmonic": lambda: Valid(fx.Harmonic, {"amplitude": 1.0, "omega": 2.0}, with_motion),
    "Harmonic.rates": lambda: calling(fx.Harmonic(1.0, 2.0).rates, t=0.5),
    "HelicalGroove": lambda: Valid(
        fx.HelicalGroove, {"radius": 0.01, "lead": 0.025, "start": (1.0, 0.0, 0.0)}, with_groove
    ),
    "IBeam": lambda: Valid(
        fx.IBeam, {"height": 0.2, "width": 0.1, "flange": 0.01, "web": 0.01}, with_section
    ),
    "LBeam": lambda: Valid(fx.LBeam, {"height": 0.1, "width": 0.08, "thickness": 0.01}, with_section),
    "Material": lambda: Valid(fx.Material, {"E": 1e9, "rho": 1e3, "nu": 0.3}, with_material),
    "Points.point": lambda: calling(points().point, index=1),
    "Points.shown": lambda: calling(points().shown, index=1),
    "Polynomial": lambda: Valid(fx.Polynomial, {"coefficients": (1.0, 2.0)}, with_motion),
    "Polynomial.rates": lambda: calling(fx.Polynomial((1.0, 2.0)).rates, t=0.5),
    "Ramp": lambda: Valid(fx.Ramp, {"t0": 0.0, "t1": 1.0, "u0": 0.0, "u1": 5.0}, with_motion),
    "Ramp.rates": lambda: calling(fx.Ramp(0.0, 1.0, 0.0, 5.0).rates, t=0.5),
    "Rectangle": lambda: Valid(fx.Rectangle, {"height": 0.1, "width": 0.2}, with_section),
    "RoundGroove": lambda: Valid(fx.RoundGroove, {"radius": 0.01}, with_groove),
    "SectionForces": lambda: Valid(fx.SectionForces, {}, in_beam(SECTIONS["Circle"])),
    "Table": lambda: Valid(
        fx.Table, {"t": np.array([0.0, 1.0, 2.0, 3.0]), "u": np.array([0.0, 1.0, 0.0, 1.0])}, with_motion
    ),
    "Table.rates": lambda: calling(TABLE.rates, t=0.5),
    "Tube": lambda: Valid(fx.Tube, {"outer": 0.1, "inner": 0.05}, with_section),
    "UBeam": lambda: Valid(
        fx.UBeam, {"height": 0.2, "width": 0.1, "flange": 0.01, "web": 0.01}, with_section
    ),
    "VGroove": lambda: Valid(fx.VGroove, {}, with_groove),
    "Box": lambda: Valid(
        fx.Box, {"point": "A", "frame": None, "centre": (0, 0, 0), "sides": (1, 1, 1)}, with_solid
    ),
    "Cylinder": lambda: Valid(
        fx.Cylinder,
        {"point": "A", "frame": None, "start": (0, 0, 0), "end": (0, 0, 1), "radius": 0.1},
        with_solid,
    ),
    "Mesh": lambda: Valid(
        fx.Mesh, {"point": "A", "frame": None, "path": DATA / "tetrahedron.obj", "scale": 1.0}, with_solid
    ),
    "Sketch": lambda: Valid(
        fx.Sketch, {"point": "A", "frame": None, "drawn": [(0, 0, 0), (1, 0, 0)]}, with_solid
    ),
    "View": lambda: Valid(fx.View, {"up": (0, 0, 1), "centre": (0, 0, 0), "span": 1.0}, with_view),
    "Waves": lambda: Valid(fx.Waves, {"amplitude": 0.01, "wavelength": 1.0}, with_road),
    "Waves.level": lambda: calling(WAVES.level, x=0.5, y=0.5),
    "WireRope": lambda: Valid(fx.WireRope, {"diameter": 0.02}, with_section),
    "ElementPage.evaluate": lambda: calling(
        fx.page("planar_truss").evaluate, x={"p": (0, 0), "q": (3, 4)}, parameters={"l0": 4.5, "rhoA": 1.0}
    ),
    "compile_element": lambda: calling(fx.compile_element, element=own_bar(), ranges={"l0": (1.0, 2.0)}),
    "compile_law": lambda: calling(fx.compile_law, law=HARDENING, ranges={"e": (1.0, 2.0)}),
    "grid": lambda: calling(fx.grid, axes={"a": [1.0, 2.0]}),
    "listed": lambda: calling(fx.listed, points=[{"a": 1.0}, {"a": 2.0}]),
    "load": lambda: calling(fx.load, path=Path("saved.npz")),
    "open_sweep": lambda: calling(fx.open_sweep, folder=Path("sweep")),
    "page": lambda: calling(fx.page, element="truss"),
    "read_spacar": lambda: Valid(
        fx.read_spacar, {"path": DATA / "slider_crank.dat"}, lambda file: file.system and None
    ),
    "sample": lambda: calling(fx.sample, parameters={"a": (1.0, 2.0)}, count=3),
    "sweep": lambda: calling(fx.sweep, build=plain, points={"a": [1, 2]}, analyse=numbers, **COUNTS),
    "turn": lambda: calling(fx.turn, axis=(0, 0, 1), angle=1.0),
    **_sections(),
}
