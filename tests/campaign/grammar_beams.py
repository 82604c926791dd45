"""Random frames of beams: trees and loops in space and in the plane, clamped, turning, driven, with bodies on them."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from hypothesis import strategies as st

from campaign.algebra import norm
from campaign.calls import Call, Case, Made, call

Draw = Any
STIFFNESS = {"EA": (100.0, 2000.0), "GJ": (0.5, 5.0), "EIy": (1.0, 12.0), "EIz": (1.0, 12.0)}
PLANAR = ("EA", "EIz")
BASES = ("clamped", "hinged", "turned", "shaken", "free")


def numbers(least: float, most: float) -> st.SearchStrategy[float]:
    """Numbers of four decimals."""
    return st.integers(round(least * 1e4), round(most * 1e4)).map(lambda z: z / 1e4)


def vectors(size: int, most: float = 1.0) -> st.SearchStrategy[tuple[float, ...]]:
    """Vectors of which no component exceeds `most`."""
    return st.tuples(*[numbers(-most, most)] * size)


def directions(size: int) -> st.SearchStrategy[tuple[float, ...]]:
    """Vectors that are not short."""
    return vectors(size).filter(lambda z: norm(np.array(z)) > 0.3)


def orientations() -> st.SearchStrategy[tuple[float, ...]]:
    """Euler parameters."""
    return directions(4).map(lambda z: tuple((np.array(z) / np.linalg.norm(z)).tolist()))


def harmonics(most: float) -> st.SearchStrategy[Made]:
    """Harmonic functions of time that start from zero."""
    return st.tuples(numbers(-most, most), numbers(1.0, 8.0)).map(lambda z: Made("Harmonic", z))


@dataclass
class Frame:
    """A frame of beams while it is drawn."""

    draw: Draw
    size: int
    calls: list[Call] = field(default_factory=list)
    places: list[tuple[float, ...]] = field(default_factory=list)

    def node(self, place: Sequence[float], **options: Any) -> None:
        """The point P and the frame R of the next joint."""
        i = len(self.places)
        self.places.append(tuple(place))
        self.calls.append(call("point", f"P{i}", tuple(place), **options))
        if self.size == 2:
            self.calls.append(call("angle", f"R{i}", self.draw(numbers(-2, 2)), **options))
        else:
            self.calls.append(call("frame", f"R{i}", self.draw(orientations()), **options))

    def base(self, kind: str) -> None:
        """The first joint: held, on a hinge that turns freely or as prescribed, shaken, or free."""
        held = {} if kind in ("free", "shaken") else {"fixed": True}
        place = (0.0,) * self.size
        if kind in ("clamped", "free", "shaken"):
            self.node(place, **held)
        if kind == "shaken":
            motion = self.draw(harmonics(0.1))
            self.calls += [
                call("fix", "R0", *(f"P0.{z}" for z in "yz"[: self.size - 1])),
                call("prescribe", "P0.x", motion),
            ]
        if kind in ("hinged", "turned"):
            self.node(place)
            ground = (
                call("angle", "ground", fixed=True) if self.size == 2 else call("frame", "ground", fixed=True)
            )
            axis = {} if self.size == 2 else {"axis": self.draw(directions(3))}
            self.calls += [call("fix", "P0"), ground, call("hinge", "hub", "ground", "R0", **axis)]
            if kind == "turned":
                rate = Made("Polynomial", ((0.0, self.draw(numbers(-4, 4)), self.draw(numbers(-3, 3))),))
                self.calls.append(
                    call(
                        "prescribe",
                        "hub.angle",
                        self.draw(st.sampled_from([rate, self.draw(harmonics(0.5))])),
                    )
                )

    def properties(self, whole: bool) -> dict[str, Any]:
        """Options of a beam; all of its modes are flexible if it is whole."""
        draw, modes = self.draw, PLANAR if self.size == 2 else tuple(STIFFNESS)
        chosen = (
            list(modes) if whole else draw(st.lists(st.sampled_from(list(modes)), min_size=1, unique=True))
        )
        options: dict[str, Any] = {z: draw(numbers(*STIFFNESS[z])) for z in modes if z in chosen}
        for shear, bending in (("GAy", "EIz"), ("GAz", "EIy")):
            if bending in options and draw(st.booleans()):
                options[shear] = draw(numbers(50.0, 2000.0))
        options["mass_per_length"] = draw(numbers(0.5, 3.0))
        inertia = st.tuples(*[numbers(0.01, 0.1)] * 3)
        options["inertia_per_length"] = draw(numbers(0.01, 0.1) if self.size == 2 else inertia)
        if draw(st.booleans()):
            options["damping"] = draw(numbers(0.001, 0.01))
        if draw(st.booleans()):
            options["second_order"] = False
        if self.size == 3:
            options["direction"] = draw(directions(3))
        if "EA" in options and draw(st.booleans()):
            options["initial_strain"] = draw(numbers(-0.02, 0.02))
        if "EIz" in options and draw(st.booleans()):
            bend = draw(numbers(-0.2, 0.2))
            options["initial_curvature"] = bend if self.size == 2 else (0.0, 0.0, bend)
        return options

    def beam(self, i: int, j: int, tree: bool) -> None:
        """A beam from joint i to joint j; one that closes a loop is flexible in all of its modes."""
        name = f"B{j}" if tree else "closing"
        options = self.properties(whole=not tree)
        line = np.subtract(self.places[j], self.places[i])
        if "direction" in options and np.linalg.norm(np.cross(line, options["direction"])) < 0.1:
            options["direction"] = tuple(np.roll(line, 1).tolist())
        self.calls.append(call("beam", name, f"P{i}", f"R{i}", f"P{j}", f"R{j}", **options))
        if self.draw(st.integers(0, 3)) == 0:
            self.calls.append(call("distributed_load", name, self.draw(vectors(self.size, 3.0))))
        if self.draw(st.integers(0, 5)) == 0:
            self.calls.append(call("mass_damping", name, self.draw(numbers(0.1, 2.0))))

    def load(self, i: int) -> None:
        """A body, a point mass or nothing at a joint."""
        kind = self.draw(st.sampled_from(["body", "mass", "none"]))
        mass = self.draw(numbers(0.2, 3.0))
        if kind == "mass":
            self.calls.append(call("point_mass", f"m{i}", f"P{i}", mass))
        if kind == "body":
            moment = numbers(0.05, 0.2)
            J = (
                self.draw(moment)
                if self.size == 2
                else (0.1, *self.draw(st.tuples(*[numbers(0.06, 0.15)] * 2)))
            )
            offset = self.draw(vectors(self.size, 0.2))
            self.calls.append(call("body", f"body{i}", f"P{i}", f"R{i}", mass=mass, inertia=J, offset=offset))


@st.composite
def frames(draw: Draw, size: int, closed: bool) -> Case:
    """A tree of one to three beams, or one of two or three closed by one more."""
    frame = Frame(draw, size)
    frame.base(draw(st.sampled_from(BASES)))
    count = draw(st.integers(2 if closed else 1, 3))
    for j in range(1, count + 1):
        i = draw(st.integers(max(j - 2, 0), j - 1))
        step = draw(directions(size))
        place = tuple(round(a + b, 4) for a, b in zip(frame.places[i], step, strict=True))
        frame.node(place)
        frame.beam(i, j, tree=True)
        frame.load(j)
    if closed and np.linalg.norm(np.subtract(frame.places[0], frame.places[count])) > 0.2:
        frame.beam(0, count, tree=False)
    offsets = draw(st.lists(numbers(-0.05, 0.05), min_size=3, max_size=7))
    rates = draw(st.lists(numbers(-1.0, 1.0), min_size=3, max_size=7))
    gravity = draw(vectors(size, 10.0))
    return Case(
        f"{'closed ' * closed}{'planar' if size == 2 else 'spatial'} beams",
        gravity,
        tuple(frame.calls),
        tuple(rates),
        0.03,
        offsets=tuple(offsets),
    )


BEAMS = {
    "planar beams": frames(2, closed=False),
    "spatial beams": frames(3, closed=False),
    "closed planar beams": frames(2, closed=True),
    "closed spatial beams": frames(3, closed=True),
}
