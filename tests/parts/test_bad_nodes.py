"""Mistakes in the declaration of nodes."""

import math

import numpy as np
from mistakes import Case, built, check, draw, each

from flexel.parts.model import Model

NODES = {
    "gravity as text": Case(lambda: Model(gravity="down"), ("gravity", "'down'", "give real numbers")),
    "gravity as one number": Case(lambda: Model(gravity=9.81), ("gravity", "not a vector", "(0, -9.81)")),
    "gravity None": Case(lambda: Model(gravity=None), ("gravity", "give real numbers")),
    "gravity NaN": Case(lambda: Model(gravity=(0, 0, math.nan)), ("gravity", "give finite numbers")),
    "point of four": draw(lambda m: m.point("P", (1, 2, 3, 4)), "point 'P'", "give 2 or 3 numbers"),
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
    "point with a zero byte": draw(
        lambda m: m.point("a\0b", (1, 2, 3)), "control characters", "choose another"
    ),
    "point with half a character": draw(lambda m: m.point("a\ud800", (1, 2, 3)), "files cannot hold"),
    "point with a line end": draw(lambda m: m.point("a\nb", (1, 2, 3)), "control characters"),
    "point with a formula": draw(lambda m: m.point("=1+1", (1, 2, 3)), "'=1+1'", "spreadsheet", "formula"),
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


@each(NODES)
def test_a_mistake_in_a_node_is_named_with_its_remedy(case: Case) -> None:
    check(case)
