"""Chains, trees and floating bodies, in the plane and in space."""

from hypothesis import strategies as st

from campaign.case import Case, own
from campaign.grammar import Sketch
from campaign.numbers import Draw, directions, links, masses, moved


def _hung(draw: Draw, size: int, family: str, branched: bool, most: int, balls: bool = False) -> Case:
    s = Sketch(draw, size)
    joints = [s.ground()]
    for i in range(draw(st.integers(1, most))):
        at = draw(st.sampled_from(joints)) if branched else joints[-1]
        joints.append(s.link(i, *at, hinged=not (balls and draw(st.booleans()))))
    s.act()
    return s.case(family)


@st.composite
def planar_chain(draw: Draw) -> Case:
    """A pendulum of bodies in the plane."""
    return _hung(draw, 2, "planar chain", False, 4)


@st.composite
def planar_tree(draw: Draw) -> Case:
    """A branched pendulum in the plane."""
    return _hung(draw, 2, "planar tree", True, 5)


@st.composite
def chain(draw: Draw) -> Case:
    """Bodies on hinges and ball joints in space."""
    return _hung(draw, 3, "spatial chain", False, 3, balls=True)


@st.composite
def tree(draw: Draw) -> Case:
    """Branched, on hinges in space."""
    return _hung(draw, 3, "spatial tree", True, 4)


@st.composite
def floating(draw: Draw) -> Case:
    """Bodies joined to each other and not to the ground, with a spring between two points."""
    s = Sketch(draw, 3)
    first = s.point("O", (0.3, -0.2, 0.1)), s.turn("R")
    s.body("b", *first)
    at = first
    for i in range(draw(st.integers(1, 2))):
        at = s.link(i, *at, hinged=draw(st.booleans()))
    s.add("truss", "strut", "O", at[0], mass_per_length=0.8)
    s.add("spring", "strut.elongation", 60.0, preload=2.0)
    return s.case("floating", "floating")


@st.composite
def strut_and_skate(draw: Draw) -> Case:
    """Users' elements: a body with a blade, and a strut with a mass at its end."""
    s = Sketch(draw, 3)
    p, r = s.point("P", (0.2, 0.1, 0.4)), s.turn("R")
    s.body("b", p, r)
    s.add("element", "blade", own("SKATE"), p, r, side=draw(directions()))
    for i in range(draw(st.integers(0, 2))):
        q = s.point(f"Q{i}", moved(s.places[p], draw(links(3))))
        s.add("point_mass", f"m{i}", q, draw(masses()))
        s.add("element", f"strut{i}", own("STRUT"), p, q, l0=_length(s, p, q), mass=draw(masses()))
        if draw(st.booleans()):
            s.add("spring", f"strut{i}.stretch", 60.0)
        p = q
    return s.case("users' elements in space")


def _length(s: Sketch, p: str, q: str) -> float:
    return float(sum((a - b) ** 2 for a, b in zip(s.places[p], s.places[q], strict=True)) ** 0.5)


@st.composite
def cams(draw: Draw) -> Case:
    """A user's element in the plane: a cam, its follower on a spring, guided or on an arm."""
    s = Sketch(draw, 2)
    s.ground()
    s.add("angle", "shaft", 0.0)
    s.add("body", "flywheel", "O", "shaft", mass=2.0, inertia=0.3)
    base, lift = 0.3, draw(st.sampled_from((0.05, 0.1)))
    tip = s.point("tip", (0.0, base + lift / 2))
    s.add("element", "cam", own("CAM"), "O", "shaft", tip, base=base, lift=lift)
    s.add("point_mass", "follower", tip, draw(masses()))
    if draw(st.booleans()):
        s.add("fix", "tip.x")
    s.add("spring", "tip.y", 50.0, preload=20.0)
    return s.case("users' elements in the plane")


CHAINS = {
    "planar chain": planar_chain(),
    "planar tree": planar_tree(),
    "spatial chain": chain(),
    "spatial tree": tree(),
    "floating": floating(),
    "users' elements in space": strut_and_skate(),
    "users' elements in the plane": cams(),
}
