"""Wheels: knife edges and tori that roll on a plane, alone, with a body hung on them, and in the plane."""

import numpy as np
from hypothesis import strategies as st

from campaign.case import Case
from campaign.grammar import Sketch
from campaign.numbers import Draw, masses, number

UP = np.array([0.0, 0.0, 1.0])


def _rounded(x: object) -> tuple[float, ...]:
    return tuple(float(number) for number in np.asarray(x))


def _wheel(draw: Draw, s: Sketch, name: str, crown: bool) -> tuple[str, str]:
    """A leaning wheel that touches a plane road; its hub and its frame."""
    lean, heading = draw(number(-0.7, 0.7, 0.1)), draw(number(-3, 3, 0.1))
    radius = draw(number(0.3, 0.6))
    rho = draw(number(0.05, 0.2)) if crown else 0.0
    along = np.array([np.cos(heading), np.sin(heading), 0.0])
    left = np.cross(UP, along)
    axle = np.cos(lean) * left + np.sin(lean) * UP
    down = np.cross(along, axle)  # in the wheel's plane, across the heading; it points up
    contact = np.array([draw(number(-1, 1, 0.1)), draw(number(-1, 1, 0.1)), draw(number(-0.3, 0.3, 0.1))])
    down = -down if down[2] > 0 else down
    hub = contact + rho * UP - (radius - rho) * down
    w, c = s.point(f"{name} hub", _rounded(hub)), s.point(f"{name} contact", _rounded(contact))
    frame = s.turn(f"{name} frame")
    more = {"crown": rho} if crown else {}
    s.add("wheel", name, w, frame, c, radius=radius, axle=_rounded(axle), height=float(contact[2]), **more)
    s.body(f"{name} body", w, frame, offset=draw(st.booleans()))
    return w, frame


def _rolls(draw: Draw, crown: bool, family: str) -> Case:
    s = Sketch(draw, 3)
    hub, frame = _wheel(draw, s, "wheel", crown)
    if draw(st.booleans()):
        s.link(0, hub, frame)
    if draw(st.integers(0, 3)) == 0:
        s.add("spring", "wheel.lateral", damping=draw(number(1, 20, 1)))
    s.act()
    return s.case(family)


@st.composite
def knife_edge(draw: Draw) -> Case:
    """A disc, perhaps with a body on a hinge at its hub."""
    return _rolls(draw, False, "knife-edge wheel")


@st.composite
def torus(draw: Draw) -> Case:
    """The same with a round tyre."""
    return _rolls(draw, True, "toroidal wheel")


@st.composite
def cart(draw: Draw) -> Case:
    """A body on an upright wheel in the plane, with a trailer that has one too."""
    s = Sketch(draw, 2)
    p, turn = s.point("P", (0.1, 0.2)), s.turn("R")
    s.body("b", p, turn)
    _upright(draw, s, 0, p, turn)
    for i in range(draw(st.integers(0, 2))):
        p, turn = s.link(i, p, turn)
        _upright(draw, s, i + 1, p, turn)
    s.act()
    return s.case("upright wheels")


def _upright(draw: Draw, s: Sketch, i: int, point: str, turn: str) -> None:
    spin = s.turn(f"spin{i}")
    s.add("rotary_inertia", f"rim{i}", spin, draw(masses()) / 10)
    heading = draw(number(-3, 3, 0.1))
    direction = (round(float(np.cos(heading)), 6), round(float(np.sin(heading)), 6))
    s.add("planar_wheel", f"w{i}", point, turn, spin, radius=draw(number(0.1, 0.4)), direction=direction)


WHEELS = {"knife-edge wheel": knife_edge(), "toroidal wheel": torus(), "upright wheels": cart()}
