"""What the grammars of all families share: bodies hung on each other, and what acts on their joints."""

from dataclasses import dataclass, field
from typing import Any

from hypothesis import strategies as st

import flexel as fx
from campaign.case import Case, declared, own
from campaign.numbers import Draw, directions, inertias, links, masses, moved, number, orientations, rates
from flexel.model.part import Part

GRAVITY = {
    2: ((0.0, -9.81), (2.0, -5.0), (0.0, 0.0)),
    3: ((0.0, 0.0, -9.81), (1.0, -2.0, -8.0), (0.0, 0.0, 0.0)),
}


@dataclass
class Sketch:
    """A case in the making.

    Attributes
    ----------
    draw : callable
        From hypothesis.
    size : int
        Two in the plane, three in space.
    parts : list of Part
    places : dict of str to tuple
        Points as drawn.
    joints : list of str
        Angles and elongations on which something may act.
    """

    draw: Draw
    size: int
    parts: list[Part[Any]] = field(default_factory=list)
    places: dict[str, tuple[float, ...]] = field(default_factory=dict)
    joints: list[str] = field(default_factory=list)

    @property
    def planar(self) -> bool:
        """In the plane."""
        return self.size == 2

    def add(self, method: str, *args: Any, **options: Any) -> None:
        """A part, by a method of `Model`."""
        self.parts.append(declared(method, *args, **options))

    def point(self, name: str, place: tuple[float, ...], **options: Any) -> str:
        """A point."""
        self.places[name] = place
        self.add("point", name, place, **options)
        return name

    def turn(self, name: str, fixed: bool = False) -> str:
        """An orientation."""
        held = {"fixed": True} if fixed else {}
        if self.planar:
            self.add("angle", name, 0.0 if fixed else self.draw(number(-1, 1, 0.1)), **held)
        elif fixed:
            self.add("frame", name, **held)
        else:
            self.add("frame", name, self.draw(orientations()))
        return name

    def ground(self) -> tuple[str, str]:
        """A fixed point and a fixed orientation."""
        return self.point("O", (0.0,) * self.size, fixed=True), self.turn("G", fixed=True)

    def body(self, name: str, point: str, frame: str, offset: bool = True) -> None:
        """A body at a point."""
        if self.planar:
            J: Any = self.draw(number(0.05, 0.5))
        else:
            J = self.draw(inertias())
        more = {"offset": tuple(self.draw(number(-0.2, 0.2)) for _ in range(self.size))} if offset else {}
        self.add("body", name, point, frame, mass=self.draw(masses()), inertia=J, **more)

    def hinge(self, name: str, p: str, q: str) -> None:
        """A hinge whose angle something may act on."""
        self.add("hinge", name, p, q, **({} if self.planar else {"axis": self.draw(directions())}))
        self.joints.append(f"{name}.angle")

    def link(self, i: int, point: str, frame: str, hinged: bool = True) -> tuple[str, str]:
        """A body from a joint to a new point, on a hinge or (in space) on a ball joint."""
        end = self.point(f"P{i}", moved(self.places[point], self.draw(links(self.size))))
        turn = self.turn(f"R{i}")
        if hinged:
            self.hinge(f"h{i}", frame, turn)
        self.add("body_point", f"l{i}", point, turn, end)
        self.body(f"b{i}", end, turn)
        return end, turn

    def truss(self, name: str, p: str, q: str, elastic: bool) -> None:
        """A bar with or without mass, rigid or with a spring."""
        mass = self.draw(st.sampled_from((0.0, 0.8)))
        self.add("truss", name, p, q, **({"mass_per_length": mass} if mass else {}))
        if elastic:
            self.add("spring", f"{name}.elongation", self.draw(number(20, 400, 1)), **self.draw(extras()))

    def act(self) -> None:
        """Springs, dampers, moments, motions and laws on some of the joints."""
        for i, name in enumerate(self.joints):
            what = self.draw(st.sampled_from(("",) * 6 + ACTIONS))
            if what == "spring":
                self.add("spring", name, self.draw(number(1, 40, 1)), **self.draw(extras()))
            elif what == "load":
                self.add("load", name, fx.Harmonic(self.draw(number(1, 9, 1)), 3.0, 0.4))
            elif what == "motion":
                self.add("prescribe", name, fx.Harmonic(0.3, self.draw(number(1, 6, 1))))
            elif what == "law":
                k, lag = self.draw(number(5, 40, 1)), self.draw(number(0.05, 0.5))
                self.add("law", (name,), own("MAXWELL"), name=f"law{i}", k=k, lag=lag)

    def case(self, family: str, *known: str, duration: float = 0.05) -> Case:
        """The case, with gravity and rates."""
        gravity = self.draw(st.sampled_from(GRAVITY[self.size]))
        return Case(family, gravity, tuple(self.parts), self.draw(rates()), duration, frozenset(known))


ACTIONS = ("spring", "spring", "load", "motion", "law")


def extras() -> st.SearchStrategy[dict[str, float]]:
    """What may come with a stiffness."""
    return st.sampled_from(({}, {}, {"damping": 0.7}, {"preload": 3.0}, {"damping": 0.2, "preload": -2.0}))
