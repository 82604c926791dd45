"""Families of the campaign of default settings: all families, extended by what makes a motion difficult.

Each trait changes a ride: its units and origin first, while all parts can be changed, then its parts, its loads, its
size and its duration.
"""

from collections.abc import Callable
from dataclasses import fields, replace
from typing import Any

import numpy as np
from hypothesis import strategies as st

import flexel as fx
from campaign.case import declared, own
from campaign.changes import Change, Inapplicable, changed
from campaign.families import FAMILIES
from campaign.formulas import Formula
from campaign.grammar_hard import HARD
from campaign.numbers import Draw, number
from campaign.ride import Ride
from flexel.model.part import Part
from flexel.parts.loads import DistributedLoad, LoadPart
from flexel.parts.roles import Prescribe

Trait = Callable[[Draw, Ride], Ride]
UNITS = {  # of length and mass: how many of them are a metre, a kilogram
    "mm, t, s": (1e3, 1e-3),
    "km, kg, s": (1e-3, 1.0),
    "cm, g, s": (1e2, 1e3),
    "mm, kg, s": (1e3, 1.0),
}
DURATIONS = {  # [s] of families whose waves are fast, or whose steps are dear; see `ORDINARY`
    "ropes": (0.01, 0.03, 0.1),
    "cables": (0.02, 0.1, 0.3),
    "nearly flat loop": (1e-3, 0.1, 1.0),
    "tyres": (0.05, 0.2, 1.0),
    "carts": (0.05, 0.2, 1.0),
    "spatial beams": (0.05, 0.2, 0.5),
    "closed spatial beams": (0.05, 0.2, 0.5),
    "planar beams": (0.1, 0.5, 1.0),
    "closed planar beams": (0.1, 0.5, 1.0),
}
ORDINARY = (0.2, 0.5, 1.0)
STIFF = 0.2  # most, with a stiff part [s]
LONG = (10.0, 30.0)  # times as long


def exponent(draw: Draw, least: int, most: int) -> float:
    """A power of ten, times 1, 2 or 5."""
    return float(f"{draw(st.sampled_from((1, 2, 5)))}e{draw(st.integers(least, most))}")


def strange_units(draw: Draw, ride: Ride) -> Ride:
    """Other units of length and mass."""
    length, mass = UNITS[name := draw(st.sampled_from(sorted(UNITS)))]
    other = _changed(ride, Change(length=length, mass=mass), name)
    return replace(other, length=length, mass=mass) if name in other.traits else other


def far_origin(draw: Draw, ride: Ride) -> Ride:
    """A thousand to a million metres from the origin."""
    away = exponent(draw, 3, 5)
    far = _changed(ride, Change(shift=(away, -0.6 * away, 0.0)), "far origin")
    return replace(far, away=away) if "far origin" in far.traits else far


def _changed(ride: Ride, change: Change, trait: str) -> Ride:
    try:
        case = changed(ride.case, change)
    except Inapplicable:
        return replace(ride, traits=(*ride.traits, f"no {trait}"))
    slower = min(1.0, change.length)  # rates and offsets are given before it is known which are lengths
    case = replace(
        case,
        speeds={name: speed * (change.length if "." in name else 1.0) for name, speed in case.speeds.items()},
        rates=tuple(slower * rate for rate in case.rates),
        offsets=tuple(slower * offset for offset in case.offsets),
    )
    return replace(ride, case=case, traits=(*ride.traits, trait))


def _beside(draw: Draw, ride: Ride) -> tuple[str, tuple[float, ...], float]:
    """A point on which something is hung, a place beside it and the unit of mass."""
    point, place = ride.hook
    away = np.array([draw(number(0.2, 0.5)), draw(number(-0.3, 0.3)), draw(number(-0.3, 0.3))][: len(place)])
    return point, tuple((np.array(place) + ride.length * away).tolist()), ride.mass


def hard_spring(draw: Draw, ride: Ride) -> Ride:
    """A mass on a hard spring."""
    point, place, unit = _beside(draw, ride)
    options = draw(st.sampled_from(({}, {"damping": 1.0 * unit}, {"damping": 30.0 * unit})))
    return ride.having(
        "hard spring",
        declared("point", "hung", place),
        declared("truss", "hard", point, "hung"),
        declared("point_mass", "hung mass", "hung", draw(number(0.1, 1)) * unit),
        declared("spring", "hard.elongation", exponent(draw, 4, 6) * unit, **options),
    )


def stiff_beam(draw: Draw, ride: Ride) -> Ride:
    """A stiff beam that carries a body, on a hinge in the plane or a ball joint in space."""
    point, place, unit = _beside(draw, ride)
    force = unit * ride.length  # a newton
    moment = force * ride.length**2
    turn = "angle" if ride.planar else "frame"
    options: dict[str, Any] = {"EA": exponent(draw, 4, 5) * force, "EIz": exponent(draw, 1, 3) * moment}
    if not ride.planar:
        options |= {"EIy": options["EIz"], "GJ": options["EIz"]}
    if draw(st.booleans()):
        options["damping"] = 1e-4
    J = 0.02 * unit * ride.length**2
    parts = [
        declared(turn, "root"),
        declared(turn, "end"),
        declared("point", "carried", place),
        declared(
            "beam",
            "stiff",
            point,
            "root",
            "carried",
            "end",
            mass_per_length=0.5 * unit / ride.length,
            **options,
        ),
        declared(
            "body", "carried body", "carried", "end", mass=0.3 * unit, inertia=J if ride.planar else (J, J, J)
        ),
    ]
    if not ride.planar:
        parts.append(declared("body", "root body", point, "root", mass=0.1 * unit, inertia=(J, J, J)))
    return ride.having("stiff beam", *parts)


def _bar(draw: Draw, ride: Ride, name: str) -> list[Part[Any]]:
    """A bar from a point to the ground."""
    point, place, _ = _beside(draw, ride)
    return [
        declared("point", f"{name} end", place, fixed=True),
        declared("truss", name, point, f"{name} end"),
    ]


def strong_damper(draw: Draw, ride: Ride) -> Ride:
    """A damper to the ground that is much too strong."""
    c = exponent(draw, 2, 4) * ride.mass
    return ride.having(
        "strong damper", *_bar(draw, ride, "dash"), declared("spring", "dash.elongation", damping=c)
    )


def negative_damper(draw: Draw, ride: Ride) -> Ride:
    """A damper to the ground that drives."""
    c = -draw(number(0.1, 2)) * ride.mass
    k = exponent(draw, 1, 2) * ride.mass
    law = declared("law", ("driver.elongation",), own("DRIVER"), name="drive", k=k, c=c)
    return ride.having("negative damper", *_bar(draw, ride, "driver"), law)


def stop(draw: Draw, ride: Ride) -> Ride:
    """A stop between a point and the ground."""
    gap, k = draw(number(0.01, 0.2)) * ride.length, exponent(draw, 3, 6) * ride.mass
    damping = draw(st.sampled_from((0.0, 0.5))) / ride.length
    parts = (*_bar(draw, ride, "buffer"), declared("stop", "buffer.elongation", gap, k, damping=damping))
    return ride.having("stop", *parts)


def _push(ride: Ride, trait: str, function: Any) -> Ride:
    """A force along a coordinate that is a function of time."""
    return ride.having(trait, declared("load", ride.driven[0], function))


def kinked(draw: Draw, ride: Ride) -> Ride:
    """A force with kinks."""
    T, f = ride.case.duration, draw(number(1, 20)) * ride.mass * ride.length
    w = float(draw(number(3, 30))) / T
    t1 = round(draw(number(0.1, 0.9)) * T, 9)
    table = fx.Table([0.0, t1 / 2, t1, 2 * T], [0.0, f, -f / 2, f], kind="linear")
    texts = (
        f"{f!r} * np.minimum(t, {t1!r}) / {t1!r}",
        f"{f!r} * abs(np.sin({w!r} * t))",
        f"{f!r} * np.maximum(np.cos({w!r} * t), 0.2)",
    )
    return _push(ride, "kinked", draw(st.sampled_from((table, *map(Formula, texts)))))


def pulse(draw: Draw, ride: Ride) -> Ride:
    """A short force: a rectangle, or a smooth pulse."""
    T, f = ride.case.duration, exponent(draw, 1, 2) * ride.mass * ride.length
    t1, width = round(draw(number(0.1, 0.9)) * T, 9), round(draw(number(0.01, 0.1, 0.001)) * T, 12)
    box = fx.Table([0.0, t1, t1 + width], [0.0, f, 0.0], kind="step")
    bell = Formula(f"{f!r} * np.exp(-((t - {t1!r}) / {width!r}) ** 2)")
    return _push(ride, "pulse", draw(st.sampled_from((box, bell))))


def sampled_controller(draw: Draw, ride: Ride) -> Ride:
    """A sampled controller that pulls a coordinate back."""
    name, value = ride.driven
    k, c = draw(number(5, 100, 1)) * ride.mass, draw(number(0, 5)) * ride.mass
    period = float(f"{ride.case.duration / draw(st.sampled_from((7, 40, 200))):.3g}")
    delay = draw(st.sampled_from((0.0, 0.0, 0.5))) * period
    given = {"inputs": [name, f"{name}'"], "outputs": [name], "period": period, "delay": delay}
    target = {"reference": {name: value}}
    return ride.having("sampled controller", declared("controller", [[k, c]], **given, **target))


def event(draw: Draw, ride: Ride) -> Ride:
    """An event where a coordinate passes the middle of its range."""
    return replace(ride, watched=ride.driven[0], traits=(*ride.traits, "event"))


def _without(part: Part[Any], *names: str) -> Part[Any]:
    """A part with some fields as they are by default."""
    return replace(part, **{item.name: item.default for item in fields(part) if item.name in names})


def small(draw: Draw, ride: Ride) -> Ride:
    """A small motion: nothing that drives it, slow rates."""
    amplitude = float(f"1e-{draw(st.integers(2, 8))}")
    parts = [
        _without(part, "preload", "initial_strain", "initial_curvature")
        for part in ride.case.parts
        if not isinstance(part, (LoadPart, Prescribe, DistributedLoad))
    ]
    case = replace(
        ride.case,
        gravity=(0.0,) * len(ride.case.gravity),
        rates=tuple(rate * amplitude for rate in ride.case.rates),
        speeds={name: speed * amplitude for name, speed in ride.case.speeds.items()},
        offsets=(),
    )
    return replace(replace(ride, case=case, amplitude=amplitude).mapped("small", parts))


def long(draw: Draw, ride: Ride) -> Ride:
    """A long time."""
    duration = ride.case.duration * draw(st.sampled_from(LONG))
    return replace(ride, case=replace(ride.case, duration=duration), traits=(*ride.traits, "long"))


FIRST: tuple[Trait, ...] = (strange_units, far_origin)
SIZES: tuple[Trait, ...] = (small, long)  # before what depends on the duration, and is not to be taken out
PARTS: tuple[Trait, ...] = (
    hard_spring,
    stiff_beam,
    strong_damper,
    negative_damper,
    stop,
    kinked,
    pulse,
    sampled_controller,
    event,
)


def some(draw: Draw, traits: tuple[Trait, ...], one_in: int) -> tuple[Trait, ...]:
    """One of some traits, or, more often, none."""
    return (draw(st.sampled_from(traits)),) if draw(st.integers(1, one_in)) == one_in else ()


@st.composite
def rides(draw: Draw, family: str) -> Ride:
    """A model of a family, with up to four traits."""
    case = draw({**FAMILIES, **HARD}[family])
    duration = draw(st.sampled_from(DURATIONS.get(family, ORDINARY)))
    ride = Ride(replace(case, duration=duration))
    for trait in (*some(draw, FIRST, 4), *some(draw, SIZES, 4)):
        ride = trait(draw, ride)
    parts = draw(st.lists(st.sampled_from(PARTS), max_size=2, unique=True))
    if set(parts) & {hard_spring, stiff_beam, strong_damper}:
        ride = replace(ride, case=replace(ride.case, duration=min(ride.case.duration, STIFF)))
    for trait in parts:
        ride = trait(draw, ride)
    return ride


RIDES: dict[str, st.SearchStrategy[Ride]] = {family: rides(family) for family in (*FAMILIES, *HARD)}
