"""Random frames of beams: trees and loops in the plane and in space, held, turning, driven or free, with bodies."""

from typing import Any

import numpy as np
from hypothesis import strategies as st

import flexel as fx
from campaign.algebra import across
from campaign.case import Case
from campaign.grammar import GRAVITY, Sketch
from campaign.numbers import Draw, links, moved, number, rates

STIFFNESS = {"EA": (200, 2000), "GJ": (1, 5), "EIy": (2, 12), "EIz": (2, 12)}
MODES = {"EA": ("elongation",), "GJ": ("torsion",), "EIy": ("bend1", "bend2"), "EIz": ("bend3", "bend4")}
PLANAR = {"EA": ("elongation",), "EIz": ("bend1", "bend2")}
BASES = ("held", "held", "hinged", "free", "turned", "shaken")
CALM = ("held", "hinged", "free")  # nothing is prescribed
APART = 0.3  # least distance of two joints that a beam connects [m]


class Frame(Sketch):
    """A frame of beams in the making; `calm`: energy is conserved."""

    calm: bool = True

    def base(self, kind: str) -> tuple[str, str]:
        """The first joint: held, free, on a hinge that turns freely or as prescribed, or shaken."""
        if kind == "held":
            return self.ground()
        first = self.point("O", (0.0,) * self.size), self.turn("R0")
        if kind == "free":
            self.body("b0", *first)
        if kind == "shaken":
            rest = [f"O.{axis}" for axis in "xyz"[1 : self.size]]
            self.add("fix", "R0", *rest)
            self.add(
                "prescribe",
                "O.x",
                fx.Harmonic(self.draw(number(0.02, 0.1)), self.draw(number(1, 8, 1))),
            )
        if kind in ("hinged", "turned"):
            self.add("fix", "O")
            self.hinge("hub", self.turn("G", fixed=True), "R0")
        if kind == "hinged":  # beams may all be on hinges of their own
            self.add("rotary_inertia", "hub inertia", "R0", 0.05 if self.planar else (0.05, 0.06, 0.07))
        if kind == "turned":
            steady = fx.Polynomial((0.0, self.draw(number(-4, 4)), self.draw(number(-3, 3))))
            self.add("prescribe", "hub.angle", self.draw(st.sampled_from((steady, fx.Harmonic(0.5, 3.0)))))
        return first

    def joint(self, i: int, at: tuple[str, str]) -> tuple[str, str]:
        """Where a beam begins at a joint: clamped there, or on a hinge of its own."""
        if self.draw(st.integers(0, 4)):
            return at
        self.hinge(f"h{i}", at[1], self.turn(f"H{i}"))
        return at[0], f"H{i}"

    def _options(self, arm: Any, whole: bool) -> dict[str, Any]:
        """Options of a beam along an arm; all of its modes are flexible if it is whole."""
        draw, modes = self.draw, PLANAR if self.planar else MODES
        some = st.lists(st.sampled_from(tuple(modes)), min_size=1, unique=True)
        chosen = tuple(modes) if whole else draw(some)
        options: dict[str, Any] = {key: draw(number(*STIFFNESS[key], 0.5)) for key in modes if key in chosen}
        for shear, bending in (("GAy", "EIz"), ("GAz", "EIy")):
            if bending in options and draw(st.booleans()):
                options[shear] = draw(number(50, 500, 1))
        options["mass_per_length"] = draw(number(0.5, 3))
        j = tuple(draw(number(0.02, 0.1)) for _ in range(3))
        options["inertia_per_length"] = j[0] if self.planar else j
        if not self.planar:
            c, s = np.cos(turn := draw(number(-3, 3))), np.sin(turn)
            first, second = across(np.array(arm))
            options["direction"] = tuple((c * first + s * second).round(4).tolist())
        if "EA" in options and draw(st.booleans()):
            options["initial_strain"] = draw(number(-0.02, 0.02, 0.001))
        if "EIz" in options and draw(st.booleans()):
            bend = draw(number(-0.3, 0.3))
            options["initial_curvature"] = bend if self.planar else self._curvature(options, bend)
        if draw(st.booleans()):
            options["second_order"] = False
        if not self.calm and draw(st.booleans()):
            options["damping"] = draw(number(0.001, 0.01, 0.001))
        return options

    def _curvature(self, options: dict[str, Any], bend: float) -> tuple[float, float, float]:
        """Twist and curvatures of an unloaded beam, where it is flexible."""
        return (0.1 if "GJ" in options else 0.0, -0.2 if "EIy" in options else 0.0, bend)

    def beam(self, name: str, p: tuple[str, str], q: tuple[str, str], whole: bool = False) -> None:
        """A beam between two joints, with loads on it; a rigid mode may be released."""
        arm = np.subtract(self.places[q[0]], self.places[p[0]])
        options = self._options(arm, whole)
        self.add("beam", name, *p, *q, **options)
        held = [
            mode
            for key, names in (PLANAR if self.planar else MODES).items()
            if key not in options
            for mode in names
        ]
        if held and self.draw(st.integers(0, 3)) == 0:
            self.add("release", f"{name}.{self.draw(st.sampled_from(held))}")
        if not self.calm and self.draw(st.booleans()):
            self.add("distributed_load", name, tuple(self.draw(number(-3, 3)) for _ in range(self.size)))
        if not self.calm and self.draw(st.integers(0, 2)) == 0:
            self.add("mass_damping", name, self.draw(number(0.1, 2)))

    def loaded(self, i: int, at: tuple[str, str]) -> None:
        """A body, a point mass or nothing at a joint."""
        kind = self.draw(st.sampled_from(("body", "mass", "")))
        if kind == "body":
            self.body(f"b{i}", *at)
        if kind == "mass":
            self.add("point_mass", f"m{i}", at[0], self.draw(number(0.2, 3)))


@st.composite
def frames(draw: Draw, size: int, closed: bool) -> Case:
    """A tree of one to three beams, or one of two or three closed by one more."""
    s = Frame(draw, size)
    s.calm = draw(st.booleans())
    base = draw(st.sampled_from(CALM if s.calm else BASES))
    joints = [s.base(base)]
    for i in range(1, draw(st.integers(1 + closed, 3)) + 1):
        at = draw(st.sampled_from(joints[-2:]))
        end = s.point(f"P{i}", moved(s.places[at[0]], draw(links(size)))), s.turn(f"R{i}")
        s.beam(f"B{i}", s.joint(i, at), end)
        s.loaded(i, end)
        joints.append(end)
    gap = np.subtract(s.places[joints[0][0]], s.places[joints[-1][0]])
    if closed and np.linalg.norm(gap) > APART:
        s.beam("closing", joints[0], joints[-1], whole=True)
    gravity = draw(st.sampled_from(GRAVITY[size]))
    known = {"adrift", *({"floating"} if s.calm and size == 3 else ())} if base == "free" else set()
    offsets = tuple(draw(number(-0.05, 0.05)) for _ in range(5))
    family = f"{'closed ' * closed}{'planar' if size == 2 else 'spatial'} beams"
    parts, speeds = tuple(s.parts), draw(rates(most=1.5))
    return Case(family, gravity, parts, speeds, 0.02, frozenset(known), offsets=offsets)


BEAMS = {
    "planar beams": frames(2, closed=False),
    "spatial beams": frames(3, closed=False),
    "closed planar beams": frames(2, closed=True),
    "closed spatial beams": frames(3, closed=True),
}
