"""Pulleys with belts between them, rigid or elastic, open or crossed; a pulley may swing on an arm."""

from typing import Any

from hypothesis import strategies as st

from campaign.case import Case
from campaign.grammar import Sketch
from campaign.numbers import Draw, number


@st.composite
def belts(draw: Draw) -> Case:
    """Two or three pulleys in a row; the last one may hang on an arm."""
    s = Sketch(draw, 2)
    s.ground()
    last, turn = "O", s.turn("R0")
    s.hinge("h0", "G", turn)
    s.body("b0", "O", turn, offset=draw(st.booleans()))
    for i in range(1, draw(st.integers(1, 2)) + 1):
        place = (s.places[last][0] + draw(number(0.5, 0.9)), draw(number(-0.3, 0.3)))
        swings = draw(st.booleans())
        centre = s.point(f"P{i}", place, **({} if swings else {"fixed": True}))
        if swings:
            s.hinge(f"swing{i}", "G", arm := s.turn(f"arm{i}"))
            s.add("body_point", f"l{i}", last, arm, centre)
        s.turn(f"R{i}")
        s.hinge(f"h{i}", "G", f"R{i}")
        s.body(f"b{i}", centre, f"R{i}", offset=False)
        _belts(s, i, (last, f"R{i - 1}", centre, f"R{i}"))
        last = centre
    return s.case("belts", duration=0.03)


def _belts(s: Sketch, i: int, ends: tuple[str, str, str, str]) -> None:
    """One straight part, or both of a belt that goes around; two rigid ones would contradict each other."""
    a, b = s.draw(number(0.05, 0.2)), s.draw(number(0.05, 0.2)) * s.draw(st.sampled_from((-1, 1)))
    both = s.draw(st.booleans())
    for side in (1, -1) if both else (s.draw(st.sampled_from((1, -1))),):
        elastic: dict[str, Any] = {}
        if both or s.draw(st.booleans()):
            elastic["stiffness"] = s.draw(number(100, 900, 10))
            if s.draw(st.booleans()):
                elastic["damping"] = s.draw(number(0.5, 3))
        name = f"belt{i}{'a' if side > 0 else 'b'}"
        s.add("planar_belt", name, *ends, radius_p=side * a, radius_q=side * b, **elastic)


BELTS = {"belts": belts()}
