"""Mistakes in the declaration of joints, wheels and trusses, and in the nodes that any element is given."""

import math

from mistakes import Case, check, draw, each, flat

from flexel.parts.model import Model

ELEMENTS = {
    "unknown node": draw(
        lambda m: m.hinge("h", "R0", "R9", axis=(0, 0, 1)), "hinge 'h'", "'R9'", "known: O, A, R0, R1"
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
}


@each(ELEMENTS)
def test_a_mistake_in_an_element_is_named_with_its_remedy(case: Case) -> None:
    check(case)
