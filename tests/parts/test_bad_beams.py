"""Mistakes in the declaration of beams."""

import math
from typing import Any

from mistakes import Case, check, draw, each, flat

OPTIONS: dict[str, tuple[dict[str, Any], tuple[str, ...]]] = {
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


BEAMS = {
    f"beam {label}": draw(
        lambda m, options=options: m.beam("b", "O", "R0", "A", "R1", **options), "beam 'b'", *words
    )
    for label, (options, words) in OPTIONS.items()
}
BEAMS |= {
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


@each(BEAMS)
def test_a_mistake_in_a_beam_is_named_with_its_remedy(case: Case) -> None:
    check(case)
