"""Mistakes in the declaration of masses and bodies, and in what `Model.add` is given."""

import math

from mistakes import Case, check, draw, each, flat

BODIES = {
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
    "of a rod without thickness": ((0, 1, 1), ("not positive definite", "zeros for a point mass")),
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
    BODIES[f"inertia {label}"] = draw(
        lambda m, J=value: m.body("b", "A", "R1", mass=1, inertia=J), "body 'b'", "inertia", *words
    )


@each(BODIES)
def test_a_mistake_in_a_body_is_named_with_its_remedy(case: Case) -> None:
    check(case)
