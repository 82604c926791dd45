"""Families that are difficult by themselves: impacts, instabilities, stiff vibrations, fast rotors, kinked drives."""

from typing import Any

import numpy as np
from hypothesis import strategies as st

import flexel as fx
from campaign.case import Case, own
from campaign.formulas import Formula
from campaign.grammar import GRAVITY, Sketch
from campaign.numbers import Draw, inertias, masses, number, rates


@st.composite
def balls(draw: Draw) -> Case:
    """One or two balls or discs above a plane, which may be tilted; they strike, bounce, slide and roll."""
    size = draw(st.sampled_from((2, 3)))
    s = Sketch(draw, size)
    ground, level = s.ground()
    tilt = draw(st.sampled_from((0.0, 0.0, 0.3)))
    normal = (-np.sin(tilt), *(0.0,) * (size - 2), np.cos(tilt))
    s.add("plane", "floor", ground, level, normal=tuple(float(component) for component in normal))
    for i in range(draw(st.integers(1, 2))):
        radius, height = draw(number(0.02, 0.2)), draw(number(0.0, 0.5))
        place = (0.6 * i, *(0.0,) * (size - 2), radius + height + 0.2 * i)
        p, r = s.point(f"P{i}", place), s.turn(f"R{i}")
        s.body(f"b{i}", p, r, offset=False)
        options: dict[str, Any] = {"exponent": draw(st.sampled_from((1.0, 1.5)))}
        if draw(st.booleans()):
            options["dissipation"] = draw(number(0.1, 2))
        if draw(st.booleans()):
            options |= {"friction": draw(number(0.1, 0.6)), "slip_speed": draw(number(0.01, 0.2))}
        stiffness = 10.0 ** draw(st.integers(4, 8))
        contact = fx.Contact(stiffness, per="point", **options)
        s.add("contact", f"c{i}", p, "floor", contact, frame=r, radius=radius)
    gravity = (0.0, *(0.0,) * (size - 2), -9.81)
    return Case("balls", gravity, tuple(s.parts), draw(rates(most=2.0)), known=frozenset({"adrift"}))


@st.composite
def points(draw: Draw) -> Case:
    """A point that falls or is thrown on a hard plane or a thin bar."""
    s = Sketch(draw, 2)
    ground, level = s.ground()
    if draw(st.booleans()):
        s.add("plane", "top", ground, level, normal=(0.0, 1.0))
    else:
        s.add("sheave", "top", ground, level, radius=0.005)
    p = s.point("P", (0.0, draw(number(0.05, 3))))
    s.add("point_mass", "m", p, draw(masses()))
    contact = fx.Contact(10.0 ** draw(st.integers(6, 9)), per="point")
    s.add("contact", "touch", p, "top", contact)
    return Case("falling points", (0.0, -9.81), tuple(s.parts), draw(rates(most=3.0)))


@st.composite
def inverted(draw: Draw) -> Case:
    """One to three pendulums upright in the plane, disturbed by little."""
    s = Sketch(draw, 2)
    last, turn = s.ground()
    for i in range(draw(st.integers(1, 3))):
        y = s.places[last][1] + draw(number(0.3, 1))
        end = s.point(f"P{i}", (0.0, y))
        new = s.turn(f"R{i}")
        s.hinge(f"h{i}", turn, new)
        s.add("body_point", f"l{i}", last, new, end)
        s.body(f"b{i}", end, new, offset=False)
        last, turn = end, new
    disturbed = 10.0 ** -draw(st.integers(1, 6))
    speeds = tuple(rate * disturbed for rate in draw(rates(most=2.0)))
    return Case("inverted pendulums", (0.0, -9.81), tuple(s.parts), speeds)


@st.composite
def vibrations(draw: Draw) -> Case:
    """Two or three masses on a line of springs whose stiffnesses differ by up to a hundred million."""
    s = Sketch(draw, 2)
    last, _ = s.ground()
    for i in range(draw(st.integers(2, 3))):
        end = s.point(f"P{i}", (0.5 * (i + 1), 0.0))
        s.add("fix", f"{end}.y")
        s.add("point_mass", f"m{i}", end, draw(masses()))
        s.add("truss", f"t{i}", last, end)
        k = 10.0 ** draw(st.integers(0, 7))
        c = draw(st.sampled_from((0.0, 0.0, 1e-4, 1e-2, -1e-6))) * k
        if c >= 0:
            s.add("spring", f"t{i}.elongation", k, **({"damping": c} if c else {}))
        else:
            s.add("law", (f"t{i}.elongation",), own("DRIVER"), name=f"drive{i}", k=k, c=c)
        last = end
    return Case("vibrations", draw(st.sampled_from(GRAVITY[2])), tuple(s.parts), draw(rates()))


@st.composite
def rotors(draw: Draw) -> Case:
    """A free body that spins fast and tumbles, or a top on its tip."""
    s = Sketch(draw, 3)
    tip = draw(st.booleans())
    p, r = s.point("P", (0.1, -0.2, 0.3), **({"fixed": True} if tip else {})), s.turn("R")
    offset = {"offset": (0.0, 0.0, draw(number(0.05, 0.2)))} if tip else {}
    s.add("body", "b", p, r, mass=draw(masses()), inertia=draw(inertias()), **offset)
    fast = draw(st.sampled_from((1.0, 5.0, 30.0)))
    speeds = tuple(fast * rate for rate in draw(rates()))
    s.add("body_point", "arm", p, r, s.point("nose", (0.4, -0.2, 0.3)))
    gravity = draw(st.sampled_from(GRAVITY[3]))
    return Case("rotors", gravity, tuple(s.parts), speeds, known=frozenset({"adrift"}))


@st.composite
def tethered(draw: Draw) -> Case:
    """One or two bodies that spin fast on springs, which are fixed beside their centres of mass."""
    s = Sketch(draw, 3)
    last, _ = s.ground()
    for i in range(draw(st.integers(1, 2))):
        p, r = s.point(f"P{i}", (0.3 * i, -0.1, -0.8 * (i + 1))), s.turn(f"R{i}")
        s.body(f"b{i}", p, r, offset=False)
        beside = s.point(
            f"Q{i}", (0.3 * i + 0.1, 0.1 * draw(st.sampled_from((-1, 0, 1))) - 0.1, -0.8 * i - 0.7)
        )
        s.add("body_point", f"arm{i}", p, r, beside)
        s.add("truss", f"t{i}", last, beside)
        s.add("spring", f"t{i}.elongation", 10.0 ** draw(st.integers(0, 3)))
        last = p
    fast = draw(st.sampled_from((1.0, 5.0, 30.0)))
    speeds = tuple(fast * rate for rate in draw(rates()))
    return Case("tethered bodies", (0.0, 0.0, -9.81), tuple(s.parts), speeds, known=frozenset({"adrift"}))


@st.composite
def driven(draw: Draw) -> Case:
    """A pendulum on a trolley that moves as prescribed, with kinks of the path or of its rate."""
    s = Sketch(draw, 2)
    ground = s.turn("G", fixed=True)
    trolley, bob, turn = s.point("T", (0.0, 0.0)), s.point("P", (draw(number(-0.3, 0.3)), -0.7)), s.turn("R")
    s.add("fix", "T.y")
    s.hinge("pivot", ground, turn)
    s.add("body_point", "rod", trolley, turn, bob)
    s.body("b", bob, turn)
    a, t1 = draw(number(0.1, 1)), draw(number(0.05, 0.9))
    texts = (
        f"{a!r} * np.minimum(t, {t1!r})",
        f"{a!r} * np.minimum(t, {t1!r}) ** 2",
        f"{a!r} * abs(t - {t1!r})",
        f"{a!r} * np.where(t < {t1!r}, 0.0, (t - {t1!r}) ** 2)",
    )
    knots = fx.Table([0.0, t1, 2 * t1, 400.0], [0.0, a, 0.0, 0.0], kind="linear")
    harmonic = fx.Harmonic(a, draw(number(1, 40, 1)))
    s.add("prescribe", "T.x", draw(st.sampled_from((*map(Formula, texts), knots, harmonic))))
    return Case("driven pendulums", (0.0, -9.81), tuple(s.parts), draw(rates()))


@st.composite
def spun(draw: Draw) -> Case:
    """A slender steel beam of one to three elements on a hub: spun up, released, or with a body at its end."""
    s = Sketch(draw, 2)
    last = s.ground()
    hub = s.turn("hub")
    s.hinge("shaft", last[1], hub)
    n = draw(st.integers(1, 3))
    E, width = draw(st.sampled_from((7e10, 2.1e11))), draw(st.sampled_from((2e-3, 5e-3, 1e-2)))
    section = {"EA": E * width**2, "EIz": E * width**4 / 12, "mass_per_length": 7800 * width**2}
    if draw(st.booleans()):
        section["damping"] = 1e-5
    last = (last[0], hub)
    for i in range(n):
        end = s.point(f"P{i}", (round((i + 1) / n, 6), 0.0)), s.turn(f"S{i}")
        s.add("beam", f"B{i}", *last, *end, **section)
        last = end
    if draw(st.booleans()):
        s.body("tip", *last)
    if draw(st.booleans()):
        turn = (0.0, 0.0, draw(number(0.2, 2)))
        s.add("prescribe", "shaft.angle", fx.Polynomial(turn))
    return Case("steel beams", draw(st.sampled_from(GRAVITY[2])), tuple(s.parts), draw(rates(most=0.3)))


HARD: dict[str, st.SearchStrategy[Case]] = {
    "balls": balls(),
    "falling points": points(),
    "inverted pendulums": inverted(),
    "vibrations": vibrations(),
    "rotors": rotors(),
    "tethered bodies": tethered(),
    "driven pendulums": driven(),
    "steel beams": spun(),
}
