"""Closed loops, with redundant constraints too, trusses, gears and relations."""

import numpy as np
from hypothesis import strategies as st

from campaign.case import Case
from campaign.grammar import Sketch
from campaign.numbers import Draw, directions, links, moved, number


def _flat(x: tuple[float, float], size: int) -> tuple[float, ...]:
    """A place of the plane in a model of two or three dimensions."""
    return (*x, *(0.0,) * (size - 2))


def _polygon(draw: Draw, count: int) -> list[tuple[float, float]]:
    """Corners of a polygon about the origin, which is shifted to begin there."""
    angles = np.cumsum([draw(number(0.5, 1.5, 0.1)) for _ in range(count)])
    angles *= 2 * np.pi / (angles[-1] + draw(number(0.5, 1.5, 0.1)))
    radii = [draw(number(0.4, 1.2)) for _ in range(count)]
    x = [(round(r * np.cos(a), 3), round(r * np.sin(a), 3)) for r, a in zip(radii, angles, strict=True)]
    return [(round(a - x[0][0], 3), round(b - x[0][1], 3)) for a, b in x]


@st.composite
def planar_loop(draw: Draw) -> Case:
    """A four-, five- or six-bar, its ends fixed."""
    s = Sketch(draw, 2)
    corners = _polygon(draw, draw(st.integers(4, 6)))
    last, turn = s.ground()
    for i, place in enumerate(corners[1:]):
        end = s.point(f"P{i}", place, **({"fixed": True} if i == len(corners) - 2 else {}))
        new = s.turn(f"R{i}")
        s.hinge(f"h{i}", turn, new)
        s.add("body_point", f"l{i}", last, new, end)
        s.body(f"b{i}", last, new)
        last, turn = end, new
    s.joints = s.joints[1:]
    s.act()
    return s.case("planar loop")


@st.composite
def nearly_flat(draw: Draw) -> Case:
    """A four-bar close to its change point, or in it: all its bars are nearly on a line."""
    s = Sketch(draw, 2)
    gap = draw(st.sampled_from((0.0, 1e-12, 1e-5, 1e-4, 1e-3, 1e-2)))
    s.point("O", (0.0, 0.0), fixed=True)
    s.point("A", (1.0, gap))
    s.point("B", (draw(number(1.5, 3)), -gap / 2))
    s.point("C", (draw(number(3.2, 4)), 0.0), fixed=True)
    for i, ends in enumerate(("OA", "AB", "BC")):
        turn = s.turn(f"R{i}")
        s.add("body_point", f"l{i}", ends[0], turn, ends[1])
        s.body(f"b{i}", ends[0], turn)
    return s.case("nearly flat loop", duration=1e-4)


@st.composite
def slider(draw: Draw) -> Case:
    """A crank, a rod and a slider on a fixed line."""
    s = Sketch(draw, 2)
    origin, ground = s.ground()
    crank = draw(number(0.2, 0.5)), draw(number(0, 6, 0.1))
    a = (round(crank[0] * np.cos(crank[1]), 3), round(crank[0] * np.sin(crank[1]), 3))
    s.point("A", a)
    s.point("B", (a[0] + draw(number(0.6, 1.2)), draw(number(-0.1, 0.1))))
    one, two = s.turn("R0"), s.turn("R1")
    s.hinge("h0", ground, one)
    s.hinge("h1", one, two)
    s.add("body_point", "crank", origin, one, "A")
    s.add("body_point", "rod", "A", two, "B")
    s.body("b0", "A", one)
    s.body("b1", "B", two)
    s.add("fix", "B.y")
    s.act()
    return s.case("slider-crank")


@st.composite
def rssr(draw: Draw) -> Case:
    """A crank and a rocker on skew axes, between them a bar on ball joints."""
    s = Sketch(draw, 3)
    a, ground = s.ground()
    d = s.point("D", (1.2, draw(number(-0.3, 0.3)), draw(number(-0.3, 0.3))), fixed=True)
    b = s.point("B", draw(links(3)))
    c = s.point("C", moved(s.places[d], draw(links(3))))
    one, two = s.turn("R0"), s.turn("R1")
    s.hinge("h0", ground, one)
    s.hinge("h1", ground, two)
    s.add("body_point", "crank", a, one, b)
    s.add("body_point", "rocker", d, two, c)
    s.body("b0", b, one)
    s.body("b1", c, two)
    s.truss("coupler", b, c, elastic=draw(st.booleans()))
    s.act()
    return s.case("spatial loop")


@st.composite
def redundant(draw: Draw) -> Case:
    """A planar loop of bodies in space with a hinge at each corner: three conditions too many."""
    s = Sketch(draw, 3)
    corners = _polygon(draw, draw(st.integers(4, 5)))
    last, turn = s.ground()
    for i, place in enumerate(corners[1:]):
        end = s.point(f"P{i}", _flat(place, 3), **({"fixed": True} if i == len(corners) - 2 else {}))
        new = s.turn(f"R{i}")
        s.add("hinge", f"h{i}", turn, new, axis=(0.0, 0.0, 1.0))
        s.add("body_point", f"l{i}", last, new, end)
        s.body(f"b{i}", last, new)
        last, turn = end, new
    s.add("hinge", "last", turn, "G", axis=(0.0, 0.0, 1.0))
    if draw(st.booleans()):
        s.add("spring", "h1.angle", 20.0, damping=0.5)
    return s.case("redundant loop", "redundant")


def _truss(draw: Draw, size: int, family: str) -> Case:
    s = Sketch(draw, size)
    held = [s.point(f"G{i}", place, fixed=True) for i, place in enumerate(_grounds(size))]
    joined = list(held)
    for i in range(draw(st.integers(1, 3))):
        new = s.point(f"P{i}", moved(s.places[joined[-1]], draw(links(size))))
        s.add("point_mass", f"m{i}", new, draw(number(0.5, 3, 0.5)))
        ends = draw(st.lists(st.sampled_from(joined), min_size=1, max_size=size + 1, unique=True))
        rigid = draw(st.integers(0, size - 1))
        for k, p in enumerate(ends):
            gap = sum((u - v) ** 2 for u, v in zip(s.places[p], s.places[new], strict=True))
            if gap > 0.06:
                s.truss(f"t{i}{k}", p, new, elastic=k >= rigid)
        joined.append(new)
    s.act()
    return s.case(family)


def _grounds(size: int) -> list[tuple[float, ...]]:
    return [_flat(place, size) for place in ((0.0, 0.0), (1.3, 0.1), (0.4, -0.9))]


@st.composite
def planar_truss(draw: Draw) -> Case:
    """Masses on bars, rigid and elastic, in the plane."""
    return _truss(draw, 2, "planar truss")


@st.composite
def truss(draw: Draw) -> Case:
    """Masses on bars, rigid and elastic, in space."""
    return _truss(draw, 3, "spatial truss")


@st.composite
def gears(draw: Draw) -> Case:
    """A planet on a turning carrier."""
    s = Sketch(draw, 2)
    origin, ground = s.ground()
    carrier, sun, planet = s.turn("C"), s.turn("S"), s.turn("R")
    s.point("P", draw(links(2)))
    s.hinge("carrier", ground, carrier)
    s.hinge("sun", ground, sun)
    s.add("body_point", "arm", origin, carrier, "P")
    s.body("arm body", "P", carrier)
    s.add("rotary_inertia", "sun wheel", sun, draw(number(0.1, 0.5)))
    s.body("planet wheel", "P", planet)
    a, b = draw(number(0.1, 0.5)), draw(st.sampled_from((0.2, 0.3, -0.8)))
    s.add("planar_gear", "mesh", origin, sun, "P", planet, radius_p=a, radius_q=b)
    s.act()
    return s.case("gears")


@st.composite
def relations(draw: Draw) -> Case:
    """Two joints of a chain, or a screw, related to each other."""
    s = Sketch(draw, 3)
    if draw(st.booleans()):
        at = s.ground()
        for i in range(3):
            at = s.link(i, *at)
        first, second = draw(st.sampled_from((("h0.angle", "h1.angle"), ("h2.angle", "h0.angle"))))
        s.add("relation", "relation", {first: 1.0, second: draw(number(0.3, 2, 0.1))})
        return s.case("relations")
    origin, ground = s.ground()
    nut, turn = s.point("P", (0.3, 0.1, -0.2)), s.turn("R")
    s.add("bearing", "guide", origin, ground, nut, turn, axis=draw(directions()))
    s.add("release", "guide.axial")
    s.body("nut", nut, turn)
    s.add("relation", "screw", {"guide.axial": 1.0, "guide.angle": -draw(number(0.02, 0.3))})
    return s.case("relations")


LOOPS = {
    "planar loop": planar_loop(),
    "nearly flat loop": nearly_flat(),
    "slider-crank": slider(),
    "spatial loop": rssr(),
    "redundant loop": redundant(),
    "planar truss": planar_truss(),
    "spatial truss": truss(),
    "gears": gears(),
    "relations": relations(),
}
