"""What careless users write: each mistake raises a flexel error that names the object and the remedy.

A case is a function, the class of the error, and words that its message must hold: the object first, then words of
the remedy.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
import pytest
import sympy

from flexel.base.errors import (
    CompilerError,
    ConstraintError,
    DynamicsError,
    FlexelError,
    LinearizationError,
    ModelError,
    PositionError,
)
from flexel.base.time_functions import Harmonic, Polynomial, Ramp, Table
from flexel.declare.curves import Curve
from flexel.integration.explicit import Event
from flexel.mechanics.linearization import Linearization
from flexel.model import Model
from flexel.spacar.reading import read_spacar
from flexel.system import System


def drawing() -> Model:
    """Two points and two frames, one of each fixed."""
    m = Model(gravity=(0, 0, -9.81))
    m.point("O", (0, 0, 0), fixed=True)
    m.point("A", (1, 0, 0))
    m.frame("R0", fixed=True)
    m.frame("R1")
    return m


def plane() -> Model:
    """The same in the plane."""
    m = Model()
    m.point("O", (0, 0), fixed=True)
    m.point("A", (1, 0))
    m.angle("R0", fixed=True)
    m.angle("R1")
    return m


def pendulum() -> Model:
    """A rod on a hinge."""
    m = drawing()
    m.hinge("pivot", "R0", "R1", axis=(0, 1, 0))
    m.beam("rod", "O", "R1", "A", mass_per_length=2.0)
    return m


def double() -> Linearization:
    """Linearization of a double pendulum, whose freedoms are coupled."""
    m = pendulum()
    m.frame("R2")
    m.point("B", (2, 0, 0))
    m.hinge("elbow", "R1", "R2", axis=(0, 1, 0))
    m.beam("forearm", "A", "R2", "B", mass_per_length=1.0)
    m.independent("pivot.angle", "elbow.angle")
    return m.build().linearize()


@dataclass(frozen=True)
class Case:
    """A mistake, the class of its error, and words of the message."""

    mistake: Callable[[], Any]
    words: tuple[str, ...]
    error: type[FlexelError] = ModelError


def draw(mistake: Callable[[Model], Any], *words: str, error: type[FlexelError] = ModelError) -> Case:
    """A mistake in a spatial drawing, found when it is made."""
    return Case(lambda: mistake(drawing()), words, error)


def flat(mistake: Callable[[Model], Any], *words: str) -> Case:
    """A mistake in a planar drawing, found when it is made."""
    return Case(lambda: mistake(plane()), words)


def built(mistake: Callable[[Model], Any], *words: str, error: type[FlexelError] = ModelError) -> Case:
    """A mistake in the pendulum, found when it is made or when the model is built."""

    def run() -> None:
        m = pendulum()
        mistake(m)
        m.build()

    return Case(run, words, error)


def system(mistake: Callable[[System], Any], *words: str, error: type[FlexelError] = ModelError) -> Case:
    """A mistake with the built pendulum."""
    return Case(lambda: mistake(pendulum().build()), words, error)


def linear(mistake: Callable[[Linearization], Any], *words: str) -> Case:
    """A mistake with the linearized double pendulum."""
    return Case(lambda: mistake(double()), words, LinearizationError)


NODES = {
    "gravity as text": Case(lambda: Model(gravity="down"), ("gravity", "'down'", "give real numbers")),
    "gravity as one number": Case(lambda: Model(gravity=9.81), ("gravity", "give 3 numbers")),
    "gravity None": Case(lambda: Model(gravity=None), ("gravity", "give real numbers")),
    "gravity NaN": Case(lambda: Model(gravity=(0, 0, math.nan)), ("gravity", "give finite numbers")),
    "point of four": draw(lambda m: m.point("P", (1, 2, 3, 4)), "point 'P'", "give 3 numbers"),
    "point as text": draw(lambda m: m.point("P", "abc"), "point 'P'", "give real numbers"),
    "point None": draw(lambda m: m.point("P", None), "point 'P'", "give real numbers"),
    "point of texts": draw(lambda m: m.point("P", ("1", "2", "3")), "point 'P'", "give real numbers"),
    "point ragged": draw(lambda m: m.point("P", ((1, 2), (3,))), "point 'P'", "give real numbers"),
    "point complex": draw(lambda m: m.point("P", (1, 2, 1j)), "point 'P'", "give real numbers"),
    "point NaN": draw(lambda m: m.point("P", (1, 2, math.nan)), "point 'P'", "give finite numbers"),
    "point infinite": draw(lambda m: m.point("P", (1, 2, math.inf)), "point 'P'", "give finite numbers"),
    "point without name": draw(lambda m: m.point("", (1, 2, 3)), "point ''", "choose another"),
    "point with a number for a name": draw(lambda m: m.point(3, (1, 2, 3)), "point 3", "choose another"),
    "point with a dot": draw(lambda m: m.point("a.b", (1, 2, 3)), "'a.b'", "without dots", "choose another"),
    "point with a prime": draw(lambda m: m.point("a'", (1, 2, 3)), "a'", "choose another"),
    "name and place swapped": draw(lambda m: m.point((1, 2, 3), "P"), "position", "give real numbers"),
    "point twice": draw(lambda m: m.point("O", (1, 2, 3)), "point 'O'", "taken", "choose another"),
    "element named as a node": draw(
        lambda m: m.hinge("O", "R0", "R1", axis=(0, 0, 1)), "hinge 'O'", "taken", "choose another"
    ),
    "node named as an element": built(lambda m: m.point("rod", (0, 0, 0)), "point 'rod'", "choose another"),
    "frame not of norm one": draw(
        lambda m: m.frame("R", (1, 1, 0, 0)), "frame 'R'", "norm 1.41421", "divide them by it"
    ),
    "frame of zeros": draw(lambda m: m.frame("R", (0, 0, 0, 0)), "frame 'R'", "norm 0"),
    "frame of three": draw(lambda m: m.frame("R", (1, 0, 0)), "frame 'R'", "give 4 numbers"),
    "frame as a matrix": draw(lambda m: m.frame("R", np.eye(3)), "frame 'R'", "give 4 numbers"),
    "frame NaN": draw(lambda m: m.frame("R", (math.nan, 0, 0, 0)), "frame 'R'", "give finite numbers"),
    "angle as text": draw(lambda m: m.angle("R", "x"), "angle 'R'", "give real numbers"),
    "angle None": draw(lambda m: m.angle("R", None), "angle 'R'", "give real numbers"),
}

ELEMENTS = {
    "unknown node": draw(
        lambda m: m.hinge("h", "R0", "R9", axis=(0, 0, 1)), "hinge 'h'", "'R9'", "did you mean R1"
    ),
    "None for a node": draw(lambda m: m.hinge("h", None, "R0", axis=(0, 0, 1)), "hinge 'h'", "give its name"),
    "list for a node": draw(
        lambda m: m.hinge("h", ["R0"], "R1", axis=(0, 0, 1)), "hinge 'h'", "give its name"
    ),
    "node of another model": draw(
        lambda m: m.truss("t", "O", Model().point("A", (5, 5, 5))), "truss 't'", "'A'", "another model", "use"
    ),
    "point for a frame": draw(
        lambda m: m.hinge("h", "R0", "A", axis=(0, 0, 1)), "hinge 'h'", "'A' is a point", "needs a frame"
    ),
    "frame for a point": draw(
        lambda m: m.point_mass("b", "R1", 2), "'b'", "'R1' is a frame", "needs a point"
    ),
    "ends of a beam in the wrong order": draw(
        lambda m: m.beam("b", "O", "A", "R1"), "beam 'b'", "needs a frame"
    ),
    "planar with spatial": flat(
        lambda m: m.truss("t", "O", m.point("P", (0, 0, 1))), "truss 't'", "'P'", "needs a planar_point"
    ),
    "spatial with planar": draw(
        lambda m: m.truss("t", "O", m.point("P", (0, 1))), "truss 't'", "'P'", "needs a point"
    ),
    "hinge without axis": draw(lambda m: m.hinge("h", "R0", "R1"), "hinge 'h'", "give axis="),
    "hinge about nothing": draw(
        lambda m: m.hinge("h", "R0", "R1", axis=(0, 0, 0)), "hinge 'h'", "no length", "give a direction"
    ),
    "axis by letter": draw(
        lambda m: m.hinge("h", "R0", "R1", axis="z"), "hinge 'h'", "axis", "give real numbers"
    ),
    "torsional stiffness as text": draw(
        lambda m: m.hinge("h", "R0", "R1", axis=(0, 0, 1), stiffness="a"), "hinge 'h'", "stiffness", "give"
    ),
    "negative torsional stiffness": draw(
        lambda m: m.hinge("h", "R0", "R1", axis=(0, 0, 1), stiffness=-1), "hinge 'h'", "stiffness", "positive"
    ),
    "no torsional stiffness": draw(
        lambda m: m.hinge("h", "R0", "R1", axis=(0, 0, 1), stiffness=0), "hinge 'h'", "stiffness", "positive"
    ),
    "two of three stiffnesses": draw(
        lambda m: m.hinge("h", "R0", "R1", axis=(0, 0, 1), stiffness=(1, 2)), "hinge 'h'", "one number or 3"
    ),
    "more damping than stiffness": draw(
        lambda m: m.hinge("h", "R0", "R1", axis=(0, 0, 1), stiffness=1, damping=(1, 2, 3)),
        "'h'",
        "equally many",
    ),
    "negative torsional damping": draw(
        lambda m: m.hinge("h", "R0", "R1", axis=(0, 0, 1), damping=-1),
        "hinge 'h'",
        "damping",
        "zero or a positive",
    ),
    "bearing without axis": draw(
        lambda m: m.bearing("b", "O", "R0", "A", "R1", axis=None), "bearing 'b'", "axis", "give"
    ),
    "wheel of negative radius": draw(
        lambda m: m.wheel("w", "O", "R1", "A", radius=-1, axle=(0, 1, 0)),
        "wheel 'w'",
        "radius",
        "give a positive",
    ),
    "wheel lying flat": draw(
        lambda m: m.wheel("w", "O", "R1", "A", radius=1, axle=(0, 0, 1)),
        "wheel 'w'",
        "normal to the road",
        "tilt",
    ),
    "wheel on a road without normal": draw(
        lambda m: m.wheel("w", "O", "R1", "A", radius=1, axle=(0, 1, 0), normal=(0, 0, 0)),
        "'w'",
        "road normal",
    ),
    "contact in the hub": draw(
        lambda m: m.wheel("w", "O", "R1", "O", radius=1, axle=(0, 1, 0)),
        "wheel 'w'",
        "put the contact on the road",
    ),
    "truss without length": draw(
        lambda m: m.truss("t", "O", m.point("P", (0, 0, 0))), "truss 't'", "coincide", "move one"
    ),
    "truss without stiffness": draw(
        lambda m: m.truss("t", "O", "A", stiffness=0), "truss 't'", "stiffness", "give a positive"
    ),
    "truss of NaN stiffness": draw(
        lambda m: m.truss("t", "O", "A", stiffness=math.nan), "truss 't'", "stiffness", "give finite"
    ),
    "truss of text stiffness": draw(
        lambda m: m.truss("t", "O", "A", stiffness="1e3"), "truss 't'", "stiffness", "give real"
    ),
    "damped rigid truss": draw(
        lambda m: m.truss("t", "O", "A", damping=3.0),
        "truss 't'",
        "damping",
        "m.spring('t.elongation', damping=…)",
    ),
    "truss of negative damping": draw(
        lambda m: m.truss("t", "O", "A", stiffness=1.0, damping=-3.0),
        "truss 't'",
        "damping",
        "zero or a positive",
    ),
    "truss of negative mass": draw(
        lambda m: m.truss("t", "O", "A", mass_per_length=-3),
        "truss 't'",
        "mass_per_length",
        "zero or a positive",
    ),
    "no mass": draw(lambda m: m.point_mass("b", "A", 0), "point mass 'b'", "mass 0", "give a positive"),
    "negative mass": draw(lambda m: m.point_mass("b", "A", -1), "point mass 'b'", "give a positive"),
    "None for a mass": draw(lambda m: m.point_mass("b", "A", None), "point mass 'b'", "give real"),
    "text for a mass": draw(lambda m: m.point_mass("b", "A", "2"), "point mass 'b'", "give real"),
    "body without mass": draw(
        lambda m: m.body("b", "A", "R1", mass=0, inertia=(1, 1, 1)), "body 'b'", "mass", "give a positive"
    ),
    "planar body with a tensor": flat(
        lambda m: m.body("b", "A", "R1", mass=1, inertia=(1, 2, 3)), "body 'b'", "inertia", "give one number"
    ),
    "planar body with a spatial offset": flat(
        lambda m: m.body("b", "A", "R1", mass=1, inertia=1, offset=(1, 2, 3)), "body 'b'", "offset", "give 2"
    ),
    "unknown type": draw(
        lambda m: m.element("e", "wheelie", "O"), "element 'e'", "'wheelie'", "did you mean wheel"
    ),
    "too few nodes": draw(
        lambda m: m.element("e", "truss", "O", l0=1), "truss 'e'", "its nodes are 'O'; give 2: p (point)"
    ),
    "nodes in a list": draw(
        lambda m: m.element("e", "truss", ["O", "A"], l0=1), "truss 'e'", "its nodes are ['O', 'A']; give 2"
    ),
    "unknown parameter": draw(
        lambda m: m.element("e", "truss", "O", "A", l0=1, rhoA=0, E=1),
        "truss 'e'",
        "E",
        "it takes l0",
    ),
    "missing parameter": draw(
        lambda m: m.element("e", "truss", "O", "A", l0=1), "truss 'e'", "rhoA missing", "it takes l0"
    ),
    "parameter of wrong size": draw(
        lambda m: m.element("e", "truss", "O", "A", l0=(1, 2), rhoA=0), "truss 'e'", "l0", "needs 1"
    ),
    "parameter as text": draw(
        lambda m: m.element("e", "truss", "O", "A", l0="a", rhoA=0), "truss 'e'", "l0", "give"
    ),
    "parameter NaN": draw(
        lambda m: m.element("e", "truss", "O", "A", l0=math.nan, rhoA=0),
        "truss 'e'",
        "l0",
        "give finite",
    ),
}

INERTIAS = {
    "negative": ((1, 1, -1), ("not positive definite", "check the signs")),
    "zero": ((0, 0, 0), ("not positive definite", "check the signs")),
    "products too large": ((1, 1, 1, 2, 0, 0), ("not positive definite", "check the signs")),
    "of no body": ((1, 1, 3), ("triangle inequality", "check the numbers")),
    "of no body, rotated": ((1.5, 1.5, 3.5, 1.0, 0, 0), ("triangle inequality", "check the numbers")),
    "two numbers": ((1, 1), ("give 3 principal moments",)),
    "one number": (1.0, ("give 3 principal moments",)),
    "not symmetric": ([[1, 0.1, 0], [0, 1, 0], [0, 0, 1]], ("give 3 principal moments", "symmetric")),
    "NaN": ((1, math.nan, 1), ("give finite numbers",)),
    "text": ("abc", ("give real numbers",)),
    "None": (None, ("give real numbers",)),
    "ragged": (((1, 2), (1,)), ("give real numbers",)),
}
for label, (value, words) in INERTIAS.items():
    ELEMENTS[f"inertia {label}"] = draw(
        lambda m, J=value: m.body("b", "A", "R1", mass=1, inertia=J), "body 'b'", "inertia", *words
    )

BEAMS: dict[str, tuple[dict[str, Any], tuple[str, ...]]] = {
    "neither rigid nor flexible": ({}, ("give rigid=True or EA",)),
    "rigid and flexible": ({"rigid": True, "EA": 1}, ("contradict", "drop one")),
    "shear alone": ({"GAz": 1.0}, ("GAz", "give EIy")),
    "shear of the other plane": ({"EIz": 1.0, "GAz": 1.0}, ("GAz", "give EIy")),
    "rigid with shear": ({"rigid": True, "GAz": 1.0}, ("contradict", "drop one")),
    "zero EA": ({"EA": 0}, ("EA 0", "give a positive")),
    "negative EIy": ({"EIy": -1}, ("EIy -1", "give a positive")),
    "NaN GAz": ({"EIy": 1, "GAz": math.nan}, ("GAz", "give finite")),
    "text EIy": ({"EIy": "stiff"}, ("EIy", "give real")),
    "direction along the beam": ({"EIz": 1, "direction": (1, 0, 0)}, ("parallel", "give another direction")),
    "direction by letter": ({"EIz": 1, "direction": "y"}, ("direction", "give real")),
    "negative mass": ({"EIz": 1, "mass_per_length": -1}, ("mass_per_length", "give zero or")),
    "one rotary inertia": ({"EIz": 1, "inertia_per_length": 1.0}, ("inertia_per_length", "give 3")),
    "negative rotary inertia": (
        {"EIz": 1, "inertia_per_length": (1, -1, 0)},
        ("negative entry", "give zero or"),
    ),
    "negative damping": ({"EIz": 1, "damping": -1}, ("damping", "give zero or")),
    "text damping": ({"EIz": 1, "damping": "a"}, ("damping", "give real")),
    "damped and rigid": ({"rigid": True, "damping": 1.0}, ("no effect", "give a stiffness")),
}
for label, (options, words) in BEAMS.items():
    ELEMENTS[f"beam {label}"] = draw(
        lambda m, options=options: m.beam("b", "O", "R0", "A", "R1", **options), "beam 'b'", *words
    )
ELEMENTS |= {
    "one frame and flexible": draw(
        lambda m: m.beam("b", "O", "R1", "A", EIy=1.0), "beam 'b'", "three-node", "give a second frame"
    ),
    "one frame and damping": draw(
        lambda m: m.beam("b", "O", "R1", "A", damping=1.0), "beam 'b'", "no effect", "drop it"
    ),
    "one frame, direction along": draw(
        lambda m: m.beam("b", "O", "R1", "A", direction=(1, 0, 0)), "beam 'b'", "parallel", "give another"
    ),
    "beam without length": draw(
        lambda m: m.beam("b", "O", "R0", "O", "R1", EIy=1.0), "beam 'b'", "coincide", "move one"
    ),
    "planar beam with EIy": flat(
        lambda m: m.beam("b", "O", "R0", "A", "R1", EIy=1.0), "beam 'b'", "EIy", "drop the others"
    ),
    "planar beam with torsion": flat(
        lambda m: m.beam("b", "O", "R0", "A", "R1", EIz=1.0, GJ=1.0), "beam 'b'", "GJ", "drop the others"
    ),
    "planar beam with direction": flat(
        lambda m: m.beam("b", "O", "R0", "A", "R1", EIz=1.0, direction=(0, 1, 0)),
        "beam 'b'",
        "direction",
        "drop",
    ),
    "planar beam with three rotary inertias": flat(
        lambda m: m.beam("b", "O", "R0", "A", "R1", EIz=1.0, inertia_per_length=(1, 1, 1)),
        "beam 'b'",
        "give 1",
    ),
}

ROLES = {
    "fix unknown": built(lambda m: m.fix("Q"), "fix", "'Q'", "known: O, A"),
    "fix unknown coordinate": built(lambda m: m.fix("A.q"), "fix", "'A'", "'q'", "it has x, y, z"),
    "fix None": built(lambda m: m.fix(None), "fix", "give its name"),
    "fix an element": built(lambda m: m.fix("pivot"), "fix", "'pivot' is an element", "m.rigid"),
    "fix a deformation": built(lambda m: m.fix("pivot.angle"), "fix", "'pivot' is an element", "m.rigid"),
    "fix a node of another model": built(
        lambda m: m.fix(Model().point("A", (5, 5, 5))), "fix", "'A'", "another model"
    ),
    "fix too much": built(
        lambda m: m.fix("A"), "over-constrained", "'rod.along'", "release 2 of them", error=ConstraintError
    ),
    "release unknown": built(lambda m: m.release("pivot.bend"), "'pivot.bend'", "did you mean pivot.bend"),
    "release a coordinate": built(lambda m: m.release("A.x"), "'A.x' is a coordinate", "use fix"),
    "release an element": built(lambda m: m.release("pivot"), "'pivot'", "did you mean pivot."),
    "release None": built(lambda m: m.release(None), "release", "give text such as"),
    "release a list": built(lambda m: m.release(["pivot.bend1"]), "release", "separate arguments"),
    "release a norm": built(lambda m: m.release("R1.norm"), "'R1.norm'", "always holds", "name another"),
    "rigid unknown": built(lambda m: m.rigid("pivot.agnle"), "'pivot.agnle'", "did you mean pivot.angle"),
    "rigid coordinate": built(lambda m: m.rigid("A.x"), "'A.x' is a coordinate", "use fix"),
    "rigid with a spring": built(
        lambda m: (m.spring("pivot.angle", 3.0), m.rigid("pivot.angle")), "'pivot.angle'", "law", "take one"
    ),
    "rigid and prescribed": built(
        lambda m: (m.prescribe("pivot.angle", 1.0), m.rigid("pivot.angle")), "'pivot.angle'", "take one"
    ),
    "hinge between a frame and itself": Case(
        lambda: _self_hinged().build(), ("hinge 'h'", "both its frames are 'R0'", "two bodies"), ModelError
    ),
    "independent unknown": built(
        lambda m: m.independent("pivot.agnle"), "'pivot.agnle'", "did you mean pivot.angle"
    ),
    "independent twice": built(
        lambda m: m.independent("pivot.angle", "pivot.angle"), "'pivot.angle'", "named twice", "once"
    ),
    "independent None": built(lambda m: m.independent(None), "independent", "give text such as"),
    "independent list": built(lambda m: m.independent(["pivot.angle"]), "independent", "separate arguments"),
    "independent node": built(
        lambda m: m.independent(m.nodes["A"]), "independent", "give text such as 'A.x'"
    ),
    "independent element": built(lambda m: m.independent("pivot"), "'pivot'", "did you mean pivot."),
    "independent norm": built(lambda m: m.independent("R1.norm"), "'R1.norm'", "name another"),
    "independent and fixed": built(lambda m: m.independent("O.y"), "'O.y' is fixed", "name coordinates"),
    "independent slip": built(
        lambda m: (m.angular_velocity("R1"), m.independent("R1.omega.wy")), "'R1.omega.wy' is a slip", "name"
    ),
    "independent and prescribed": built(
        lambda m: (m.prescribe("pivot.angle", 1), m.independent("pivot.angle")), "'pivot.angle'", "choose one"
    ),
    "independent and kinematic": built(
        lambda m: (m.kinematic("pivot.angle"), m.independent("pivot.angle")), "'pivot.angle'", "choose one"
    ),
    "too many freedoms": built(
        lambda m: m.independent("pivot.angle", "A.z"),
        "2 dynamic",
        "has 1",
        "take 1 of",
        error=ConstraintError,
    ),
    "too few freedoms": built(
        lambda m: (m.release("pivot.bend1"), m.independent("pivot.angle")),
        "under-constrained",
        "2 dynamic coordinate(s) are needed and 1 named",
        "m.independent",
        error=ConstraintError,
    ),
    "no freedoms": built(
        lambda m: m.independent(), "under-constrained", "or name none", error=ConstraintError
    ),
    "a freedom that does not move": built(
        lambda m: m.independent("A.x"), "'A.x' cannot be", "for example 'pivot.angle'", error=ConstraintError
    ),
    "kinematic without need": built(
        lambda m: m.kinematic("A.z"), "1 kinematic", "has 0", "take 1 of 'A.z' back", error=ConstraintError
    ),
    "kinematic unknown": built(
        lambda m: m.kinematic("pivot.agnle"), "'pivot.agnle'", "did you mean pivot.angle"
    ),
    "empty model": Case(lambda: Model().build(), ("no nodes", "add points and frames")),
    "build at no time": Case(lambda: pendulum().build(t=None), ("time t", "give real numbers")),
    "build at NaN": Case(lambda: pendulum().build(t=math.nan), ("time t", "give finite numbers")),
}


def _self_hinged() -> Model:
    m = drawing()
    m.hinge("h", "R0", "R0", axis=(0, 0, 1))
    return m


def _fails(t: Any) -> Any:
    raise ZeroDivisionError("no value")


MOTIONS = {
    "unknown": built(lambda m: m.prescribe("pivot.angel", 1.0), "'pivot.angel'", "did you mean pivot.angle"),
    "None": built(lambda m: m.prescribe("pivot.angle", None), "prescribe 'pivot.angle'", "give one of these"),
    "text": built(
        lambda m: m.prescribe("pivot.angle", "fast"), "prescribe 'pivot.angle'", "give one of these"
    ),
    "NaN": built(lambda m: m.prescribe("pivot.angle", math.nan), "prescribe 'pivot.angle'", "give finite"),
    "node": built(lambda m: m.prescribe("A", 1.0), "'A'", "did you mean A."),
    "node object": built(lambda m: m.prescribe(m.nodes["A"], 1.0), "prescribe", "give text such as 'A.x'"),
    "math.sin": built(
        lambda m: m.prescribe("pivot.angle", lambda t: math.sin(t)), "'pivot.angle'", "np.sin, not math.sin"
    ),
    "np.floor": built(
        lambda m: m.prescribe("pivot.angle", lambda t: np.floor(t)),
        "'pivot.angle'",
        "floor",
        "give the triple",
    ),
    "np.interp": built(
        lambda m: m.prescribe("pivot.angle", lambda t: np.interp(t, [0, 1], [0, 1])),
        "'pivot.angle'",
        "triple",
    ),
    "function that fails": built(
        lambda m: m.prescribe("pivot.angle", _fails), "prescribe 'pivot.angle'", "no value", "one argument t"
    ),
    "function of nothing": built(
        lambda m: m.prescribe("pivot.angle", lambda: 0), "'pivot.angle'", "one argument t"
    ),
    "function of two": built(
        lambda m: m.prescribe("pivot.angle", lambda t, x: t), "'pivot.angle'", "one argument t"
    ),
    "function without value": built(
        lambda m: m.prescribe("pivot.angle", lambda t: None), "'pivot.angle'", "must give one number"
    ),
    "function with an array": built(
        lambda m: m.prescribe("pivot.angle", lambda t: np.array([t, t])),
        "'pivot.angle'",
        "must give one number",
    ),
    "root of a negative number": built(
        lambda m: m.prescribe("pivot.angle", lambda t: np.sqrt(t - 1)), "'pivot.angle'", "t = 0 s"
    ),
    "pair": built(
        lambda m: m.prescribe("pivot.angle", (lambda t: t, lambda t: 1)), "'pivot.angle'", "(u, u', u'')"
    ),
    "triple of numbers": built(
        lambda m: m.prescribe("pivot.angle", (1, 2, 3)), "'pivot.angle'", "three functions"
    ),
    "triple without values": built(
        lambda m: m.prescribe("pivot.angle", (lambda t: None,) * 3), "'pivot.angle'", "must give one number"
    ),
    "triple with NaN": built(
        lambda m: m.prescribe("pivot.angle", (lambda t: math.nan,) * 3), "'pivot.angle'", "must be finite"
    ),
    "class": built(lambda m: m.prescribe("pivot.angle", Ramp), "'pivot.angle'", "Ramp is a class", "Ramp(…)"),
    "slip": built(
        lambda m: (m.angular_velocity("R1"), m.prescribe("R1.omega.wx", 1)), "'R1.omega.wx' is a slip", "only"
    ),
    "fixed": built(lambda m: m.prescribe("O.x", 1), "'O.x' is fixed", "release the node"),
    "two that depend": built(
        lambda m: (m.prescribe("pivot.angle", 0), m.prescribe("A.z", 0)),
        "over-constrained",
        "'pivot.angle'",
        "release one",
        error=ConstraintError,
    ),
    "unreachable": built(
        lambda m: m.prescribe("A.x", 1.5), "cannot be assembled", "'A.x'", "correct one", error=PositionError
    ),
    "Ramp backwards": Case(lambda: Ramp(1, 0, 0, 1), ("Ramp", "give t0 < t1")),
    "Ramp of text": Case(lambda: Ramp("a", "b", 0, 1), ("Ramp", "t0", "give real")),
    "Ramp of NaN": Case(lambda: Ramp(0, 1, math.nan, 1), ("Ramp", "u0", "give finite")),
    "Harmonic of NaN": Case(lambda: Harmonic(1, math.nan), ("Harmonic", "omega", "give finite")),
    "Harmonic of text": Case(lambda: Harmonic("a", 1), ("Harmonic", "amplitude", "give real")),
    "Polynomial of text": Case(lambda: Polynomial("abc"), ("Polynomial", "give real")),
    "Polynomial of nothing": Case(lambda: Polynomial([]), ("Polynomial", "give")),
    "Polynomial of one number": Case(lambda: Polynomial(3), ("Polynomial", "give a list")),
    "Table too short": Case(lambda: Table([0, 1], [0, 1]), ("Table", "at least four")),
    "Table of two lengths": Case(lambda: Table([0, 1, 2, 3], [0, 1]), ("Table", "one value for each")),
    "Table of vectors": Case(lambda: Table([0, 1, 2, 3], np.zeros((4, 2))), ("Table", "one value for each")),
    "Table of NaN": Case(
        lambda: Table([0, 1, 2, 3], [0, 1, math.nan, 2]), ("Table", "values", "give finite")
    ),
    "Table not sorted": Case(lambda: Table([0, 2, 1, 3], [0, 1, 2, 2]), ("Table", "sort them")),
    "beyond the Table": Case(
        lambda: _tabled().simulate(5.0), ("Table", "outside 0.0…3.0", "extend the table")
    ),
}


def _tabled() -> System:
    m = pendulum()
    m.prescribe("pivot.angle", Table([0, 1, 2, 3], [0, 1, 2, 3]))
    return m.build()


INITIAL = {
    "unknown": built(lambda m: m.initial("pivot.agle", 1), "'pivot.agle'", "did you mean pivot.angle"),
    "nothing": built(lambda m: m.initial("pivot.angle"), "initial 'pivot.angle'", "give one of them"),
    "text": built(lambda m: m.initial("pivot.angle", "a"), "initial 'pivot.angle'", "give real"),
    "NaN": built(lambda m: m.initial("pivot.angle", rate=math.nan), "initial 'pivot.angle'", "give finite"),
    "rigid": built(lambda m: m.initial("pivot.bend1", 0.1), "'pivot.bend1'", "rigid", "take it back"),
    "fixed": built(lambda m: m.initial("O.x", 0.1), "'O.x'", "fixed", "take it back"),
    "prescribed": built(
        lambda m: (m.prescribe("pivot.angle", 1), m.initial("pivot.angle", 1)),
        "'pivot.angle'",
        "take it back",
    ),
    "rate of a fixed coordinate": built(
        lambda m: m.initial("O.x", rate=0.1), "'O.x'", "fixed", "take it back"
    ),
    "rate of a rigid deformation": built(
        lambda m: m.initial("pivot.bend1", rate=1.0), "'pivot.bend1'", "rigid", "take it back"
    ),
    "two rates that contradict": built(
        lambda m: (m.initial("pivot.angle", rate=1), m.initial("A.z", rate=1)),
        "inconsistent",
        "'pivot.angle'",
        "at most 1",
        error=PositionError,
    ),
    "impossible rate": built(
        lambda m: m.initial("A.y", rate=1), "inconsistent", "'A.y'", "give at most 1", error=PositionError
    ),
    "unreachable": built(
        lambda m: m.initial("A.x", 1.5), "'rod.along'", "'A.x'", "correct one", error=PositionError
    ),
    "two values that contradict": built(
        lambda m: (m.initial("A.x", 0.5), m.initial("pivot.angle", 0.0)),
        "cannot be assembled",
        "'A.x'",
        "correct one",
        error=PositionError,
    ),
}

LOADS = {
    "unknown": built(lambda m: m.load("AA", (1, 2, 3)), "load", "'AA'", "did you mean A"),
    "unknown quantity": built(lambda m: m.load("A.q", 1), "'A.q'", "did you mean A."),
    "element": built(lambda m: m.load("pivot", 1), "load", "'pivot'", "known: O, A"),
    "None": built(lambda m: m.load(None, 1), "load", "give its name"),
    "two components": built(lambda m: m.load("A", (1, 2)), "load on 'A'", "2 components", "takes 3"),
    "one number": built(lambda m: m.load("A", 1.0), "load on 'A'", "takes a list of 3"),
    "no components": built(lambda m: m.load("A", None), "load on 'A'", "takes a list of 3"),
    "vector function": built(lambda m: m.load("A", lambda t: (0, 0, t)), "load on 'A'", "takes a list of 3"),
    "texts": built(lambda m: m.load("A", ("a", "b", "c")), "load on 'A'", "give one of these"),
    "NaN": built(lambda m: m.load("A", (math.nan, 0, 1)), "load on 'A'", "give finite"),
    "three numbers on an angle": built(
        lambda m: m.load("pivot.angle", (1, 2, 3)), "'pivot.angle'", "functions"
    ),
    "fixed point": built(lambda m: m.load("O", (1, 0, 1)), "load on 'O'", "fixed", "remove load or fixing"),
    "fixed frame": built(lambda m: m.load("R0", (1, 0, 1)), "load on 'R0'", "fixed", "remove load or fixing"),
    "fixed coordinate": built(
        lambda m: (m.fix("A.y"), m.release("rod.across1", "pivot.bend1"), m.load("A", (0, 1, 0))),
        "load on 'A.y'",
        "fixed",
        "remove load or fixing",
    ),
    "follower on a point": built(
        lambda m: m.load("A", (1, 0, 1), follower=True), "'A'", "no axes", "follower=frame"
    ),
    "follower on an angle": built(
        lambda m: m.load("pivot.angle", 1, follower=True), "'pivot.angle'", "leave follower"
    ),
    "norm": built(lambda m: m.load("R1.norm", 1), "'R1.norm'", "always holds", "name another"),
    "math.sin": built(
        lambda m: m.load("pivot.angle", lambda t: math.sin(t)), "'pivot.angle'", "np.sin, not math.sin"
    ),
    "slip not measured": built(lambda m: m.load("R1.omega.wx", 1), "'R1.omega.wx'", "did you mean"),
    "angular velocity of a point": built(
        lambda m: m.angular_velocity("A"), "angular_velocity", "needs a frame"
    ),
}

LAWS = {
    "spring unknown": built(lambda m: m.spring("pivot.a", 1), "'pivot.a'", "did you mean pivot.angle"),
    "spring on an element": built(lambda m: m.spring("pivot", 1), "'pivot'", "did you mean pivot."),
    "spring on Euler parameters": built(
        lambda m: m.spring("R1.lambda1", 1), "'R1.lambda1'", "measure an angle"
    ),
    "spring on a fixed coordinate": built(lambda m: m.spring("O.x", 1), "'O.x' is fixed", "remove spring"),
    "spring to itself": built(lambda m: m.spring(("A.x", "A.x"), 1), "'A.x'", "name another one"),
    "spring to nothing": built(lambda m: m.spring(("A.x", "pivot.a"), 1), "'pivot.a'", "did you mean"),
    "spring on a norm": built(lambda m: m.spring("R1.norm", 1), "'R1.norm'", "name another"),
    "spring on a slip": built(
        lambda m: (m.angular_velocity("R1"), m.spring("R1.omega.wx", 1)),
        "spring on 'R1.omega.wx': a slip",
        "no stiffness",
        "give damping alone",
    ),
    "free length on a slip": built(
        lambda m: (m.angular_velocity("R1"), m.spring("R1.omega.wx", damping=1, free_length=1)),
        "spring on 'R1.omega.wx': a slip",
        "no free_length",
    ),
    "slip and deformation": built(
        lambda m: (m.angular_velocity("R1"), m.spring(["R1.omega.wx", "pivot.angle"], damping=np.eye(2))),
        "spring on 'R1.omega.wx', 'pivot.angle'",
        "'R1.omega.wx' is a slip",
        "a damper of its own",
    ),
    "curve on a slip": built(
        lambda m: (m.angular_velocity("R1"), m.spring("R1.omega.wx", damping=Curve([[0, 1]]))),
        "spring on 'R1.omega.wx'",
        "takes a number or matrix",
    ),
    "four slips": built(
        lambda m: (
            m.wheel("w", "O", "R1", m.point("W", (0, 0, -1)), radius=1, axle=(0, 1, 0)),
            m.angular_velocity("R1"),
            m.spring(
                ["w.longitudinal", "w.lateral", "w.spin", "R1.omega.wx"],
                damping=np.eye(4),
            ),
        ),
        "4 slips; name 1 to 3",
    ),
    "damper on a slip that comes later": built(
        lambda m: (m.spring("R1.omega.wx", damping=1), m.angular_velocity("R1")),
        "'R1.omega.wx' is not a deformation",
        "before the damper on its slip",
    ),
    "spring of nothing": built(
        lambda m: m.spring("pivot.angle"), "spring on 'pivot.angle'", "give one of them"
    ),
    "spring by number": built(lambda m: m.spring(3, 1), "spring: 3 is not the name", "give one, a pair"),
    "spring by nothing": built(lambda m: m.spring([], np.eye(0)), "spring: [] is not the name", "give one"),
    "spring between three": built(
        lambda m: m.spring(("A.x", "A.y", "A.z"), 1),
        "spring between 'A.x' and 'A.y' and 'A.z'",
        "3 are given",
        "a list and matrices",
    ),
    "free length and preload": built(
        lambda m: m.spring("pivot.angle", 1, free_length=0.1, preload=2),
        "spring on 'pivot.angle': free_length and preload are both given",
        "drop one",
    ),
    "free length of a damper": built(
        lambda m: m.spring("pivot.angle", damping=1, free_length=0.1),
        "spring on 'pivot.angle': free_length without a stiffness",
        "drop it",
    ),
    "negative free length": built(
        lambda m: (m.truss("t", "O", "A"), m.spring("t.elongation", 1, free_length=-0.1)),
        "spring on 't.elongation'",
        "free_length -0.1",
        "zero or a positive",
    ),
    "preload of a curve": built(
        lambda m: m.spring("pivot.angle", Curve([[0, 1]]), preload=1),
        "spring on 'pivot.angle'",
        "its own preload",
        "add it there",
    ),
    "curve between two": built(
        lambda m: m.spring(("A.x", "A.y"), Curve([[0, 1]])),
        "spring between 'A.x' and 'A.y'",
        "one deformation",
    ),
    "formula of two": built(
        lambda m: m.spring(["A.x", "A.y"], lambda e: e),
        "spring on 'A.x', 'A.y'",
        "one deformation",
        "fx.compile",
    ),
    "damper with a force at rest": built(
        lambda m: m.spring("pivot.angle", damping=Curve([[4, 1]])),
        "spring on 'pivot.angle': damping gives 4 at rest",
    ),
    "spring text": built(lambda m: m.spring("pivot.angle", "stiff"), "spring on 'pivot.angle'", "give real"),
    "matrix of one": built(lambda m: m.spring("pivot.angle", np.eye(2)), "stiffness", "give one number"),
    "numbers for a list": built(
        lambda m: m.spring(["A.x", "A.y"], 3.0),
        "spring on 'A.x', 'A.y'",
        "stiffness has shape ()",
        "give (2, 2)",
    ),
    "spring None": built(lambda m: m.spring("pivot.angle", None), "'pivot.angle'", "give one of them"),
    "spring negative": built(
        lambda m: m.spring("pivot.angle", -1), "'pivot.angle'", "stiffness", "zero or a positive"
    ),
    "spring preload NaN": built(
        lambda m: m.spring("pivot.angle", 1, preload=math.nan), "preload", "give finite"
    ),
    "spring preload text": built(lambda m: m.spring("pivot.angle", 1, preload="x"), "preload", "give real"),
    "viscous on a deformation": built(
        lambda m: m.attach("viscous_1", ["pivot.angle"], C=1.0),
        "'pivot.angle' is not a slip",
        "m.spring(…, damping=…)",
    ),
    "viscous negative": built(
        lambda m: (m.angular_velocity("R1"), m.spring("R1.omega.wx", damping=-1)),
        "spring on 'R1.omega.wx'",
        "damping",
        "zero or",
    ),
    "linear law on seven": built(
        lambda m: m.spring([f"d.{i}" for i in range(7)], np.eye(7)), "7 deformations", "name 1 to 6"
    ),
    "linear law twice on one": built(
        lambda m: m.spring(["pivot.angle"] * 2, np.eye(2)), "'pivot.angle'", "each once"
    ),
    "linear law of wrong shape": built(
        lambda m: m.spring(["pivot.angle", "pivot.bend1"], np.eye(3)),
        "stiffness",
        "(3, 3)",
        "give (2, 2)",
    ),
    "linear law not symmetric": built(
        lambda m: m.spring(["pivot.angle", "pivot.bend1"], [[1, 2], [3, 4]]),
        "not symmetric",
        "make it so",
    ),
    "linear law indefinite": built(
        lambda m: m.spring(["pivot.angle", "pivot.bend1"], [[1, 2], [2, 1]]),
        "negative eigenvalue",
        "correct it",
    ),
    "linear law with two preloads": built(
        lambda m: m.spring(["pivot.angle"], [[1]], preload=[1, 2]), "preload", "give 1 numbers"
    ),
    "formula with a parameter": built(
        lambda m: m.law("pivot.angle", lambda e: e, k=3.0),
        "law on 'pivot.angle': a formula takes no k",
        "insert the numbers",
    ),
    "formula with an initial value": built(
        lambda m: m.law("pivot.angle", lambda e: e, initial={"z": 1.0}), "takes no initial", "insert"
    ),
    "formula on two": built(
        lambda m: m.law(["A.x", "A.y"], lambda e: e), "law on 'A.x', 'A.y'", "2 are named", "fx.compile_law"
    ),
    "built-in law by m.law": built(
        lambda m: m.law("pivot.angle", "stop"), "law on 'pivot.angle': 'stop' is text", "m.attach('stop', …)"
    ),
    "attached on one of two": built(
        lambda m: m.attach("linear_2", ["pivot.angle"], preload=0, S=1, D=0),
        "law 'linear_2' on 'pivot.angle'",
        "1 names; give 2 deformations",
    ),
    "attached with too few numbers": built(
        lambda m: m.attach("linear_2", ["pivot.angle", "pivot.bend1"], preload=[0, 0], S=1, D=[0, 0, 0]),
        "law 'linear_2'",
        "parameter S has 1 numbers; it needs 3",
    ),
    "law in a list": built(lambda m: m.attach([], ["pivot.angle"]), "unknown law '[]'", "known: "),
    "law in a mapping": built(lambda m: m.attach({}, ["pivot.angle"]), "unknown law '{}'", "known: "),
    "attached stop that pulls": built(
        lambda m: m.attach("stop", ["pivot.angle"], gap=0.1, stiffness=-1, damping=0),
        "law 'stop' on 'pivot.angle'",
        "stiffness -1",
        "give zero or",
    ),
    "attached contact of exponent 1/2": built(
        lambda m: m.attach("hertz", ["pivot.angle"], stiffness=1, exponent=0.5, dissipation=0),
        "law 'hertz' on 'pivot.angle'",
        "exponent 0.5",
        "give 1",
    ),
    "attached linear law that pushes": built(
        lambda m: m.attach("linear_1", ["pivot.angle"], preload=0, S=-1, D=0),
        "law 'linear_1' on 'pivot.angle'",
        "negative eigenvalue",
        "m.law",
    ),
    "formula with math.sin": built(
        lambda m: m.law("pivot.angle", lambda e, ed: math.sin(e)), "'pivot.angle'", "sympy.sin"
    ),
    "formula with np.sin": built(
        lambda m: m.law("pivot.angle", lambda e, ed: np.sin(e)), "'pivot.angle'", "sympy.sin"
    ),
    "formula with a branch": built(
        lambda m: m.law("pivot.angle", lambda e, ed: e if e > 0 else 0), "'pivot.angle'", "sympy.Piecewise"
    ),
    "formula with a symbol": built(
        lambda m: m.law("pivot.angle", lambda e, ed: sympy.Symbol("k") * e),
        "'pivot.angle'",
        "e*k",
        "insert the numbers",
    ),
    "formula with an open case": built(
        lambda m: m.law("pivot.angle", lambda e, ed: sympy.Piecewise((1e5 * e, e > 0))),
        "'pivot.angle'",
        "no value on one side of e = 0",
        "condition True",
    ),
    "formula that jumps": built(
        lambda m: m.law("pivot.angle", lambda e, ed: sympy.Piecewise((0, e < 0.1), (100, True))),
        "'pivot.angle'",
        "jumps at e = 0.1",
        "let the pieces join",
    ),
    "formula with a step": built(
        lambda m: m.law("pivot.angle", lambda e, ed: 1e4 * sympy.Heaviside(e)), "jumps at e = 0", "smooth"
    ),
    "formula of dry friction": built(
        lambda m: m.law("pivot.angle", lambda e, ed: 5 * sympy.sign(ed), energy=lambda e: 0 * e),
        "'pivot.angle'",
        "jumps at ed = 0",
        "tanh(ed/v)",
    ),
    "formula None": built(
        lambda m: m.law("pivot.angle", lambda e, ed: None), "'pivot.angle'", "insert the numbers"
    ),
    "formula as text": built(lambda m: m.law("pivot.angle", lambda e, ed: "3**"), "'pivot.angle'", "failed"),
    "no formula": built(lambda m: m.law("pivot.angle", 3.0), "'pivot.angle'", "write lambda e, ed"),
    "formula infinite": built(
        lambda m: m.law("pivot.angle", lambda e, ed: e / sympy.Integer(0)),
        "'pivot.angle'",
        "correct the formula",
    ),
    "formula complex": built(
        lambda m: m.law("pivot.angle", lambda e, ed: e * sympy.I), "'pivot.angle'", "not real", "correct"
    ),
    "formula without energy": built(
        lambda m: m.law("pivot.angle", lambda e, ed: e**3 * sympy.exp(sympy.sin(e**2))),
        "'pivot.angle'",
        "energy=",
    ),
    "energy infinite": built(lambda m: m.law("pivot.angle", lambda e, ed: 1 / e), "'pivot.angle'", "energy="),
    "energy of another law": built(
        lambda m: m.law("pivot.angle", lambda e, ed: e, energy=lambda e: e**3),
        "'pivot.angle'",
        "the derivative of the energy e**3",
        "correct one",
    ),
    "energy not callable": built(
        lambda m: m.law("pivot.angle", lambda e, ed: e, energy=3), "'pivot.angle'", "write lambda e"
    ),
    "unknown function": built(
        lambda m: m.law("pivot.angle", lambda e, ed: sympy.gamma(e), energy=lambda e: sympy.loggamma(e)),
        "'pivot.angle'",
    ),
    "formula on unknown": built(
        lambda m: m.spring(["pivot.agle"], [[1.0]]), "'pivot.agle'", "did you mean pivot.angle"
    ),
}

E1 = Event("e", lambda state: 1.0)
ANALYSES = {
    "no duration": system(lambda s: s.simulate(0), "simulate", "duration", "give a positive"),
    "duration None": system(lambda s: s.simulate(None), "simulate", "duration", "give real"),
    "duration NaN": system(lambda s: s.simulate(math.nan), "simulate", "duration", "give finite"),
    "negative duration": system(lambda s: s.simulate(-1), "simulate", "duration -1", "give a positive"),
    "duration as text": system(lambda s: s.simulate("1"), "simulate", "duration", "give real"),
    "unknown method": system(lambda s: s.simulate(1, method="RK4"), "'RK4'", "choose one of DOP853"),
    "method in small letters": system(lambda s: s.simulate(1, method="radau"), "'radau'", "choose one of"),
    "method None": system(lambda s: s.simulate(1, method=None), "method None", "choose one of"),
    "times backwards": system(lambda s: s.simulate(1, times=[0, 0.5, 0.4]), "times", "sort them"),
    "times before the start": system(lambda s: s.simulate(1, times=[-1, 0.4]), "times", "from 0 s"),
    "times after the end": system(lambda s: s.simulate(1, times=[0, 2]), "time 2 s", "lengthen the duration"),
    "no times": system(lambda s: s.simulate(1, times=[]), "times", "a list"),
    "one time": system(lambda s: s.simulate(1, times=0.4), "times", "a list"),
    "times NaN": system(lambda s: s.simulate(1, times=[0, math.nan]), "times", "give finite"),
    "times as text": system(lambda s: s.simulate(1, times="abc"), "times", "give real"),
    "no samples": system(lambda s: s.simulate(1, samples=0), "0 samples", "2 or more"),
    "half a sample": system(lambda s: s.simulate(1, samples=2.5), "2.5 samples", "whole number"),
    "negative tolerance": system(lambda s: s.simulate(1, rtol=-5), "rtol", "give more than"),
    "tolerance below rounding": system(lambda s: s.simulate(1, rtol=0), "rtol", "give more than 1e-13"),
    "tolerance as text": system(lambda s: s.simulate(1, rtol="tight"), "rtol", "give real"),
    "negative absolute tolerance": system(lambda s: s.simulate(1, atol=-5), "atol", "give more than"),
    "no step": system(lambda s: s.simulate(1, max_step=0), "max_step", "give more than"),
    "event not in a list": system(lambda s: s.simulate(1, events=E1), "events", "[Event(name, function)]"),
    "function for an event": system(lambda s: s.simulate(1, events=[lambda z: 1]), "events", "[Event("),
    "event upwards": system(
        lambda s: s.simulate(1, events=[Event("e", lambda z: 1.0, direction="up")]),
        "event 'e'",
        "direction 'up'",
        "give 1 (up)",
    ),
    "event without a function": system(
        lambda s: s.simulate(1, events=[Event("e", 3.0)]), "event 'e'", "3.0 is no function", "lambda s"
    ),
    "event of nothing": system(
        lambda s: s.simulate(1, events=[Event("e", lambda z: None)]), "event 'e'", "give real"
    ),
    "event of NaN": system(
        lambda s: s.simulate(1, events=[Event("e", lambda z: math.nan)]), "event 'e'", "give finite"
    ),
    "event of an unknown quantity": system(
        lambda s: s.simulate(1, events=[Event("e", lambda z: z["A.q"])]), "'A.q'", "did you mean"
    ),
    "start of another model": system(
        lambda s: s.simulate(1, start=pendulum().build().initial), "simulate", "another model", "of this one"
    ),
    "start no state": system(
        lambda s: s.simulate(1, start=3), "simulate", "int is no state", "system.initial"
    ),
    "linearize another model": system(
        lambda s: s.linearize(pendulum().build().initial), "linearize", "another model", "of this one"
    ),
    "linearize a motion": system(
        lambda s: s.linearize(s.simulate(0.01, samples=2)), "linearize", "motion[-1]"
    ),
    "value of an unknown": system(lambda s: s.state_at({"q": 1}), "state_at", "'q'", "known: "),
    "value of no freedom": system(
        lambda s: s.state_at({"A.x": 1}), "'A.x' is not a freedom", "'pivot.angle'"
    ),
    "value as text": system(lambda s: s.state_at({"pivot.angle": "a"}), "'pivot.angle'", "give real"),
    "value None": system(lambda s: s.state_at({"pivot.angle": None}), "'pivot.angle'", "give real"),
    "value NaN": system(lambda s: s.state_at({"pivot.angle": math.nan}), "'pivot.angle'", "give finite"),
    "values as a list": system(lambda s: s.state_at([1.0]), "state_at", "by name"),
    "rate None": system(lambda s: s.state_at(rates={"pivot.angle": None}), "'pivot.angle'", "give real"),
    "rate unknown": system(lambda s: s.state_at(rates={"pit": 1}), "'pit'", "did you mean"),
    "rate of a fixed coordinate": system(
        lambda s: s.state_at(rates={"O.x": 1}), "'O.x' cannot be 1", "give at most", error=PositionError
    ),
    "at no time": system(lambda s: s.state_at(t=math.nan), "state_at", "time t", "give finite"),
    "state of another model": system(
        lambda s: s.state_at(start=pendulum().build().initial), "state_at", "another model", "of this one"
    ),
    "steady of an unknown": system(lambda s: s.steady(unknown=["q"]), "'q'", "name one of them"),
    "steady rate unknown": system(lambda s: s.steady(unknown_rates=["q"]), "'q'", "name one of them"),
    "steady of another model": system(
        lambda s: s.steady(pendulum().build().initial), "another model", "of this one"
    ),
    "freedoms unknown": system(lambda s: s.use_freedoms(["q"]), "use_freedoms", "'q'", "known: "),
    "freedoms as text": system(lambda s: s.use_freedoms("pivot.angle"), "use_freedoms", "write ['…'"),
    "freedom fixed": system(lambda s: s.use_freedoms(["O.x"]), "'O.x' is fixed", "name coordinates"),
    "freedom rigid": system(
        lambda s: s.use_freedoms(["rod.along"]),
        "'rod.along' is constrained",
        "name others",
        error=ConstraintError,
    ),
    "state of an unknown": system(
        lambda s: s.initial["pivot.agle"], "'pivot.agle'", "did you mean pivot.angle"
    ),
    "rate of an unknown": system(
        lambda s: s.initial.rate("pivot.agle"), "'pivot.agle'", "did you mean pivot.angle"
    ),
    "position of an element": system(lambda s: s.initial.position("rod"), "'rod'", "known: O, A"),
    "motion of an unknown": system(
        lambda s: s.simulate(0.01, samples=2)["pivot.agle"], "'pivot.agle'", "did you mean pivot.angle"
    ),
    "motion after its end": system(lambda s: s.simulate(0.01, samples=2).at(5), "5 s", "0…0.01"),
    "motion at NaN": system(lambda s: s.simulate(0.01, samples=2).at(math.nan), "nan", "finite"),
    "reduced to an unknown": linear(lambda z: z.reduced(["q"]), "'q'", "name some of"),
    "reduced to nothing": linear(lambda z: z.reduced([]), "reduced", "name one"),
    "reduced twice": linear(lambda z: z.reduced(["elbow.angle"] * 2), "reduced", "each once"),
    "reduced but coupled": linear(
        lambda z: z.reduced(["elbow.angle"]), "'elbow.angle'", "'pivot.angle' enters through", "include it"
    ),
    "input fixed": linear(lambda z: z.state_space(["O.x"], ["A.x"]), "'O.x'", "fixed", "drop it"),
    "output without value": Case(
        lambda: _measured().state_space([], ["R1.omega.wy"]),
        ("'R1.omega.wy'", "ask for its rate"),
        LinearizationError,
    ),
    "input unknown": Case(lambda: double().state_space(["q"], []), ("'q'", "known: ")),
    "output unknown": Case(
        lambda: double().state_space([], ["farce:A.x"]), ("'farce:A.x'", "did you mean A.x")
    ),
    "inputs as text": Case(lambda: double().state_space("A.x", []), ("inputs", "write ['…'")),
    "reduced to a text": Case(lambda: double().reduced("elbow.angle"), ("reduced", "write ['…'")),
}


def strut() -> System:
    """A column of one flexible beam."""
    m = drawing()
    section = {"EA": 10.0, "GJ": 1.0, "EIy": 1.0, "EIz": 1.0}
    m.beam("b", "O", "R0", "A", "R1", **section, mass_per_length=1.0, inertia_per_length=(1, 1, 1))
    return m.build()


STATICS = {
    "of another model": Case(
        lambda: strut().equilibrium(start=strut().rest), ("equilibrium", "another model", "of this one")
    ),
    "from a number": Case(lambda: strut().equilibrium(start=3), ("int is no state", "system.initial")),
    "at a text": Case(lambda: strut().equilibrium(t="a"), ("time t", "give real")),
    "path to a text": Case(lambda: strut().static_path("a"), ("t_end", "give real")),
    "path to nowhere": Case(lambda: strut().static_path(0.0), ("t_end", "give another")),
    "buckling without load": Case(lambda: strut().buckling(increment={}), ("buckling", "name at least one")),
    "buckling under no load": Case(
        lambda: strut().buckling(increment={"A.x": 0.0}), ("buckling", "name at least")
    ),
    "buckling under an unknown load": Case(
        lambda: strut().buckling(increment={"A": -1.0}), ("buckling", "'A'", "did you mean A.")
    ),
    "buckling under a load on a support": Case(
        lambda: strut().buckling(increment={"O.x": -1.0}), ("'O.x'", "fixed", "name another")
    ),
    "buckling under a text": Case(lambda: strut().buckling(increment={"A.x": "a"}), ("'A.x'", "give real")),
    "buckling under a list": Case(lambda: strut().buckling(increment=["A.x"]), ("buckling", "by name")),
    "no modes": Case(lambda: strut().vibrations(count=0), ("vibrations", "1 or more")),
    "modes as text": Case(lambda: strut().vibrations(count="a"), ("vibrations", "whole number")),
    "steady of a text": Case(lambda: strut().steady(unknown="b.bend1"), ("steady", "write ['…'")),
    "free fall": Case(
        lambda: _falling().equilibrium(), ("stiffness is singular", "'A.", "support it"), DynamicsError
    ),
}


def _falling() -> System:
    m = drawing()
    m.fix("R1")
    m.point_mass("b", "A", 1.0)
    return m.build()


def _measured() -> Linearization:
    m = pendulum()
    m.angular_velocity("R1")
    return m.build().linearize()


GROUPS = {
    "node": NODES,
    "element": ELEMENTS,
    "role": ROLES,
    "motion": MOTIONS,
    "initial": INITIAL,
    "load": LOADS,
    "law": LAWS,
    "analysis": ANALYSES,
    "statics": STATICS,
}
CASES = {f"{group}: {label}": case for group, cases in GROUPS.items() for label, case in cases.items()}


@pytest.mark.parametrize("case", CASES.values(), ids=CASES)
def test_mistake_is_named_with_its_remedy(case: Case) -> None:
    with pytest.raises(case.error) as caught:
        case.mistake()
    message = str(caught.value)
    assert [word for word in case.words if word not in message] == [], message
    assert "np.float64" not in message


def test_massless_freedom_is_named() -> None:
    m = drawing()
    m.point_mass("b", "A", 1.0)
    with pytest.raises(DynamicsError, match=r"'R1\.lambda\d' moves no mass; give its bodies mass"):
        m.build().simulate(1.0)


def test_motion_that_leaves_the_reach_says_where() -> None:
    m = pendulum()
    m.prescribe("A.z", lambda t: -t)  # the rod is 1 m long
    with pytest.raises(
        PositionError,
        match=r"position at t = 1(\.\d+)? s cannot be reached.*check prescribed and initial values of 'A\.z'",
    ):
        m.build().simulate(1.5)


def test_missing_compiler_is_named_and_matters_for_formulas_only(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Any
) -> None:
    monkeypatch.setenv("CC", "/nowhere/cc")
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    m = pendulum()
    m.spring("pivot.angle", 2.0)
    m.build().simulate(0.01, samples=2)
    with pytest.raises(
        CompilerError, match=r"law on 'rod.along': no C compiler '/nowhere/cc'.*apt install gcc"
    ):
        m.law("rod.along", lambda e, ed: 3 * e + e**3)


def test_results_that_do_not_exist_are_told_with_those_that_do(tmp_path: Any) -> None:
    system = pendulum().build()
    motion, lin = system.simulate(0.1, times=[0.0]), system.linearize()
    with pytest.raises(ModelError, match=r"motion\[0.05\]: .* motion.at\(0.05\)"):
        motion[0.05]
    with pytest.raises(ModelError, match="mode 7: there are 2, numbered from 0"):
        lin.plot_mode(7)
    with pytest.raises(ModelError, match="periodic: period 0 is not positive"):
        system.periodic(0.0, 3)
    with pytest.raises(ModelError, match="periodic: 0 harmonics asked for"):
        system.periodic(1.0, 0)
    with pytest.raises(ModelError, match="read_spacar '.*none.dat': there is no such file"):
        read_spacar(tmp_path / "none.dat")
    pytest.importorskip("matplotlib", reason="drawing needs matplotlib: pip install 'flexel[plot]'")
    assert motion.plot("A.z").axes[0].lines[0].get_xdata().size == 1  # of a single state, without a warning


def test_a_model_that_failed_can_be_mended_and_built() -> None:
    m = pendulum()
    with pytest.raises(ModelError):
        m.hinge("elbow", "R1", "A", axis=(0, 1, 0))
    with pytest.raises(ModelError):
        m.beam("arm", "A", "R1", "O", "R0", EIy=1.0, mass_per_length=-1.0)
    system_ = m.build()  # nothing of the failed elements stays behind
    assert system_.dynamic == ("pivot.angle",)
    m.point("B", (2, 0, 0))
    m.frame("R2")
    m.hinge("elbow", "R1", "R2", axis=(0, 1, 0))
    m.beam("arm", "A", "R2", "B", mass_per_length=1.0)
    assert set(m.build().dynamic) == {"pivot.angle", "elbow.angle"}


@pytest.mark.parametrize(
    "declare",
    [
        lambda m: m.cable("new", "a", "s", "b", "t", EA=-1.0, EI=1.0),
        lambda m: m.cable("new", "a", "s", "b", "t", EA=1.0, EI=1.0, damping=-1.0),
        lambda m: m.beam("new", "a", "A", "b", "B", EA=1.0, GJ=1.0, EIy=1.0, EIz=1.0, damping=-1.0),
        lambda m: m.anchor("new", "a", "A", "b", "nowhere"),
        lambda m: m.truss("new", "a", "b", stiffness=1.0, damping=-1.0),
        lambda m: m.hinge("new", "A", "B", axis=(0, 0, 1), stiffness=-1.0),
    ],
)
def test_a_declaration_that_is_refused_leaves_nothing_behind(declare: Callable[[Model], None]) -> None:
    m = Model()
    for name, x in (("a", 0.0), ("b", 1.0)):
        m.point(name, (x, 0, 0))
    for name in ("A", "B"):
        m.frame(name)
    for name in ("s", "t"):
        m.slope(name, (1, 0, 0))
    with pytest.raises(ModelError):
        declare(m)
    assert (m.instances, m.laws, len(m.nodes)) == ({}, [], 6)
