"""Cables that hang, and ropes over one or two sheaves with masses at their ends, in the plane and in space.

A rope is laid by `Model.rope`; the case has the calls that it makes, so that the program of a failure and the twins do
not depend on it.
"""

from typing import Any

import numpy as np
from hypothesis import strategies as st

from campaign.calls import Call, Case, Made, call
from campaign.numbers import Draw, number, vectors
from campaign.parts_ropes import Line

AXLE = (0.0, 1.0, 0.0)
RADIUS, THICK = 0.2, 0.005  # of sheaves at the rope's surface, of the rope [m]


def _cable_properties(draw: Draw, calm: bool) -> dict[str, float]:
    """Soft cables: their waves are slow; `calm`: without damping."""
    more = {} if calm else {"damping": 1e-3, "bending_damping": 1e-4}
    EA, EI = draw(number(200, 2000)), draw(number(0.05, 0.5))
    return {"EA": EA, "EI": EI, "mass_per_length": draw(number(0.3, 1.0)), **more}


def _contact(draw: Draw, calm: bool) -> Made:
    """A contact, smooth or with one of the two frictions; `calm`: without any loss."""
    friction = "smooth" if calm else draw(st.sampled_from(["smooth", "coulomb", "bristles"]))
    options: dict[str, float] = {"exponent": draw(st.sampled_from([1.0, 1.5, 2.0])), "points": 3}
    if not calm:
        options["dissipation"] = draw(number(0.1, 2))
    if friction != "smooth":
        options["friction"] = draw(number(0.1, 0.6))
        options["slip_speed"] = draw(number(0.05, 0.2))
    if friction == "bristles":
        options |= {"bristle_stiffness": draw(number(50, 200)), "bristle_damping": draw(number(0.1, 0.5))}
    return Made("Contact", (draw(number(3e4, 3e5)),), options)


def _in_plane(size: int, x: float, z: float) -> tuple[float, ...]:
    """A place of the plane of the sheaves."""
    return (x, z) if size == 2 else (x, 0.0, z)


def _groove(draw: Draw, size: int) -> Made | None:
    grooves = [None, Made("VGroove", (draw(number(0.6, 1.4)),)), Made("RoundGroove", (1.1 * THICK, 0.8))]
    return draw(st.sampled_from(grooves)) if size == 3 else None


def _sheaves(draw: Draw, size: int, count: int) -> list[Call]:
    """Sheaves on fixed axles."""
    turn, held = ("angle", {}) if size == 2 else ("frame", {"axis": AXLE})
    calls = [call(turn, "ground", fixed=True)]
    for i in range(count):
        J = draw(number(0.02, 0.1))
        groove = _groove(draw, size)
        more: dict[str, Any] = {} if size == 2 else {"axle": AXLE, **({"groove": groove} if groove else {})}
        calls += [
            call("point", f"C{i}", _in_plane(size, 0.7 * i, 0.1 * i), fixed=True),
            call(turn, f"S{i}"),
            call("hinge", f"axle{i}", "ground", f"S{i}", **held),
            call("body", f"rim{i}", f"C{i}", f"S{i}", mass=1.0, inertia=J if size == 2 else (J, J, J)),
            call("sheave", f"sheave{i}", f"C{i}", f"S{i}", radius=RADIUS, **more),
        ]
    return calls


def laid(
    gravity: tuple[float, ...], calls: list[Call], path: list[Any], n: int, **options: Any
) -> list[Call]:
    """The calls that make a rope as `Model.rope` lays it."""
    m = Case("", gravity, tuple(calls)).model()
    contact, radius = options.pop("contact"), options.pop("radius")
    rope = m.rope("rope", path, n, contact=contact.value(), radius=radius, **options)
    properties = {key: z for key, z in options.items() if key != "tension"}
    made: list[Call] = []
    for node in rope.points:
        if node.name not in path:
            made.append(call("point", node.name, tuple(m.nodes[node.name].x0.tolist())))
    for node in rope.slopes:
        stretch = float(np.linalg.norm(node.x0))
        made.append(call("slope", node.name, tuple(node.x0.tolist()), stretch=stretch))
    for i, name in enumerate(rope.elements):
        made.append(
            call("cable", name, *m.instances[name].nodes, float(rope.s[i + 1] - rope.s[i]), **properties)
        )
    line = Line("rope", rope.elements, tuple(rope.s.tolist()), radius)
    return [*made, *(call("rope_contact", line, name, contact) for name in rope.contacts)]


@st.composite
def ropes(draw: Draw) -> Case:
    """A rope with masses at its ends over one sheave, in the plane also over two."""
    size = draw(st.sampled_from((2, 3)))
    gravity = _in_plane(size, 0.0, -9.81)
    count = draw(st.integers(1, 2)) if size == 2 else 1
    calls = _sheaves(draw, size, count)
    ends = (-RADIUS, -draw(number(0.15, 0.3))), (RADIUS + 0.7 * (count - 1), -draw(number(0.15, 0.3)))
    for name, (x, z) in zip("AB", ends, strict=True):
        calls += [
            call("point", name, _in_plane(size, x, z)),
            call("point_mass", f"mass {name}", name, draw(number(0.5, 2))),
        ]
    path: list[Any] = ["A", *((f"sheave{i}", -1 if size == 2 else 1) for i in range(count)), "B"]  # over them
    calm = draw(st.booleans())
    options = {
        "contact": _contact(draw, calm),
        "radius": THICK,
        "tension": draw(number(4, 15)),
        **_cable_properties(draw, calm),
    }
    n = draw(st.integers(7, 8)) + 5 * (count - 1)
    calls += laid(gravity, calls, path, n, **options)
    rates = draw(st.lists(number(-0.3, 0.3), min_size=5, max_size=9))
    return Case("ropes", gravity, tuple(calls), tuple(rates), 0.003, frozenset({"adrift"}))


@st.composite
def cables(draw: Draw) -> Case:
    """One to three cables in a line from a body that may clamp it, or the ground, with a mass at the end."""
    size = draw(st.sampled_from((2, 3)))
    start, clamped = draw(st.sampled_from(["fixed", "body"])), draw(st.booleans())
    turn = "angle" if size == 2 else "frame"
    held = {"fixed": True} if start == "fixed" else {}
    calls = [call("point", "P0", (0.0,) * size, **held), call(turn, "R", **held)]
    if start == "body":
        J = 0.1 if size == 2 else (0.1, 0.12, 0.15)
        calls.append(call("body", "hand", "P0", "R", mass=1.5, inertia=J, offset=draw(vectors(size, 0.2))))
    place, step = np.zeros(size), np.array(draw(vectors(size)))
    step = step / np.linalg.norm(step) if np.linalg.norm(step) > 0.1 else np.eye(size)[0]
    names, n = ["P0"], draw(st.integers(1, 3))
    for i in range(n + 1):
        bend = np.array(draw(vectors(size, 0.2)))
        calls.append(call("slope", f"d{i}", tuple((step + bend).tolist()), stretch=draw(number(0.95, 1.05))))
        if i:
            place = place + 0.3 * (step + np.array(draw(vectors(size, 0.2))))
            calls.append(call("point", f"P{i}", tuple(place.tolist())))
            names.append(f"P{i}")
    options = _cable_properties(draw, draw(st.booleans()))
    for i in range(n):
        l0 = draw(number(0.28, 0.34))
        calls.append(call("cable", f"c{i}", f"P{i}", f"d{i}", f"P{i + 1}", f"d{i + 1}", l0, **options))
    if clamped:
        calls.append(call("clamp", "grip", "R", "d0"))
    calls.append(call("point_mass", "bob", names[-1], draw(number(0.5, 2))))
    rates = draw(st.lists(number(-1, 1), min_size=5, max_size=9))
    known = frozenset({"adrift"} if start == "body" else ())
    return Case("cables", draw(vectors(size, 10.0)), tuple(calls), tuple(rates), 0.005, known)


ROPES = {"cables": cables(), "ropes": ropes()}
