"""Cables that hang, and ropes over one or two sheaves with masses at their ends, in the plane and in space.

A rope is laid by `Model.rope`; the case has the parts that it makes, so that the program of a failure and the twins do
not depend on it.
"""

from typing import Any

import numpy as np
from hypothesis import strategies as st

import flexel as fx
from campaign.case import Case, declared
from campaign.known_lines import KnownLine
from campaign.numbers import Draw, number, vectors
from flexel.model.part import Part

AXLE = (0.0, 1.0, 0.0)
RADIUS, THICK = 0.2, 0.005  # of sheaves at the rope's surface, of the rope [m]
TENSIONS, FLANKS, STIFFNESS = (
    (4.0, 15.0),
    (0.6, 1.4),
    (3e4, 3e5),
)  # [N], [rad], per length [N/m^(1 + exponent)]
HARDER = 10.0  # contacts with exponent two


def _cable_properties(draw: Draw, calm: bool) -> dict[str, float]:
    """Soft cables: their waves are slow; `calm`: without damping."""
    more = {} if calm else {"damping": 1e-3, "bending_damping": 1e-4}
    EA, EI = draw(number(200, 2000)), draw(number(0.05, 0.5))
    return {"EA": EA, "EI": EI, "mass_per_length": draw(number(0.3, 1.0)), **more}


def _contact(draw: Draw, calm: bool) -> fx.Contact:
    """A contact, smooth or with one of the two frictions; `calm`: without any loss.

    Those with exponent two are stiffer: the largest tension presses no rope into a sheave, or between the flanks of the
    sharpest groove, by half the radius, which `Model.rope` refuses.
    """
    friction = "smooth" if calm else draw(st.sampled_from(["smooth", "coulomb", "bristles"]))
    exponent = draw(st.sampled_from([1.0, 1.5, 2.0]))
    options: dict[str, Any] = {"exponent": exponent, "points": 3}
    if not calm:
        options["dissipation"] = draw(number(0.1, 2))
    if friction != "smooth":
        options["friction"] = draw(number(0.1, 0.6))
        options["slip_speed"] = draw(number(0.05, 0.2))
    if friction == "bristles":
        options |= {"bristle_stiffness": draw(number(50, 200)), "bristle_damping": draw(number(0.1, 0.5))}
    stiffness = draw(number(*STIFFNESS))
    return fx.Contact(HARDER * stiffness if exponent > 1.5 else stiffness, **options)


def _in_plane(size: int, x: float, z: float) -> tuple[float, ...]:
    """A place of the plane of the sheaves."""
    return (x, z) if size == 2 else (x, 0.0, z)


def _groove(draw: Draw, size: int) -> fx.VGroove | fx.RoundGroove | None:
    grooves = [None, fx.VGroove(draw(number(*FLANKS))), fx.RoundGroove(1.1 * THICK, 0.8)]
    return draw(st.sampled_from(grooves)) if size == 3 else None


def _sheaves(draw: Draw, size: int, count: int) -> list[Part[Any]]:
    """Sheaves on fixed axles."""
    turn, held = ("angle", {}) if size == 2 else ("frame", {"axis": AXLE})
    parts = [declared(turn, "ground", fixed=True)]
    for i in range(count):
        J = draw(number(0.02, 0.1))
        groove = _groove(draw, size)
        more: dict[str, Any] = {} if size == 2 else {"axle": AXLE, **({"groove": groove} if groove else {})}
        parts += [
            declared("point", f"C{i}", _in_plane(size, 0.7 * i, 0.1 * i), fixed=True),
            declared(turn, f"S{i}"),
            declared("hinge", f"axle{i}", "ground", f"S{i}", **held),
            declared("body", f"rim{i}", f"C{i}", f"S{i}", mass=1.0, inertia=J if size == 2 else (J, J, J)),
            declared("sheave", f"sheave{i}", f"C{i}", f"S{i}", radius=RADIUS, **more),
        ]
    return parts


def laid(
    gravity: tuple[float, ...], parts: list[Part[Any]], path: list[Any], n: int, **options: Any
) -> list[Part[Any]]:
    """The parts that make a rope as `Model.rope` lays it."""
    m = Case("", gravity, tuple(parts)).model()
    contact, radius = options.pop("contact"), options.pop("radius")
    rope = m.rope("rope", path, n, contact=contact, radius=radius, **options)
    properties = {key: value for key, value in options.items() if key != "tension"}
    made: list[Part[Any]] = []
    for node in rope.points:
        if node.name not in path:
            made.append(declared("point", node.name, tuple(m.nodes[node.name].x0.tolist())))
    for node in rope.slopes:
        stretch = float(np.linalg.norm(node.x0))
        made.append(declared("slope", node.name, tuple(node.x0.tolist()), stretch=stretch))
    for i, name in enumerate(rope.elements):
        made.append(
            declared("cable", name, *m.instances[name].nodes, float(rope.s[i + 1] - rope.s[i]), **properties)
        )
    line = KnownLine("rope", rope.elements, tuple(rope.s.tolist()), radius)
    return [*made, line, *(declared("rope_contact", "rope", name, contact) for name in rope.contacts)]


@st.composite
def ropes(draw: Draw) -> Case:
    """A rope with masses at its ends over one sheave, in the plane also over two."""
    size = draw(st.sampled_from((2, 3)))
    gravity = _in_plane(size, 0.0, -9.81)
    count = draw(st.integers(1, 2)) if size == 2 else 1
    parts = _sheaves(draw, size, count)
    ends = (-RADIUS, -draw(number(0.15, 0.3))), (RADIUS + 0.7 * (count - 1), -draw(number(0.15, 0.3)))
    for name, (x, z) in zip("AB", ends, strict=True):
        parts += [
            declared("point", name, _in_plane(size, x, z)),
            declared("point_mass", f"mass {name}", name, draw(number(0.5, 2))),
        ]
    path: list[Any] = ["A", *((f"sheave{i}", -1 if size == 2 else 1) for i in range(count)), "B"]  # over them
    calm = draw(st.booleans())
    options = {
        "contact": _contact(draw, calm),
        "radius": THICK,
        "tension": draw(number(*TENSIONS)),
        **_cable_properties(draw, calm),
    }
    n = draw(st.integers(7, 8)) + 5 * (count - 1)
    parts += laid(gravity, parts, path, n, **options)
    rates = draw(st.lists(number(-0.3, 0.3), min_size=5, max_size=9))
    return Case("ropes", gravity, tuple(parts), tuple(rates), 0.003, frozenset({"adrift"}))


@st.composite
def cables(draw: Draw) -> Case:
    """One to three cables in a line from a body that may clamp it, or the ground, with a mass at the end."""
    size = draw(st.sampled_from((2, 3)))
    start, clamped = draw(st.sampled_from(["fixed", "body"])), draw(st.booleans())
    turn = "angle" if size == 2 else "frame"
    held = {"fixed": True} if start == "fixed" else {}
    parts = [declared("point", "P0", (0.0,) * size, **held), declared(turn, "R", **held)]
    if start == "body":
        J = 0.1 if size == 2 else (0.1, 0.12, 0.15)
        parts.append(
            declared("body", "hand", "P0", "R", mass=1.5, inertia=J, offset=draw(vectors(size, 0.2)))
        )
    place, step = np.zeros(size), np.array(draw(vectors(size)))
    step = step / np.linalg.norm(step) if np.linalg.norm(step) > 0.1 else np.eye(size)[0]
    names, n = ["P0"], draw(st.integers(1, 3))
    for i in range(n + 1):
        bend = np.array(draw(vectors(size, 0.2)))
        parts.append(
            declared("slope", f"d{i}", tuple((step + bend).tolist()), stretch=draw(number(0.95, 1.05)))
        )
        if i:
            place = place + 0.3 * (step + np.array(draw(vectors(size, 0.2))))
            parts.append(declared("point", f"P{i}", tuple(place.tolist())))
            names.append(f"P{i}")
    options = _cable_properties(draw, draw(st.booleans()))
    for i in range(n):
        l0 = draw(number(0.28, 0.34))
        parts.append(declared("cable", f"c{i}", f"P{i}", f"d{i}", f"P{i + 1}", f"d{i + 1}", l0, **options))
    if clamped:
        parts.append(declared("clamp", "grip", "R", "d0"))
    parts.append(declared("point_mass", "bob", names[-1], draw(number(0.5, 2))))
    rates = draw(st.lists(number(-1, 1), min_size=5, max_size=9))
    known = frozenset({"adrift"} if start == "body" else ())
    return Case("cables", draw(vectors(size, 10.0)), tuple(parts), tuple(rates), 0.005, known)


ROPES = {"cables": cables(), "ropes": ropes()}
