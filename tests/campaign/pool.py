"""Users' elements and a law with an internal state: defined as a user does, compiled once, and their twins."""

from typing import Any

import numpy as np
import sympy as sp

import flexel as fx
from campaign.algebra import dot, norm, rotated
from campaign.parts import Drawing, Measure, handler
from campaign.parts_bodies import Bar
from campaign.parts_forces import Load
from campaign.twin import Twin
from flexel.base.arrays import Array
from flexel.derive import (
    Deformation,
    Element,
    Frame,
    Internal,
    Law,
    Let,
    Parameter,
    PlanarAngle,
    PlanarPoint,
    Point,
    Slip,
    symbol,
)
from flexel.derive.compiled import CompiledElement, CompiledLaw
from flexel.derive.declare.rotation import combination, triad
from flexel.parts.elements import ElementPart
from flexel.parts.laws import LawPart


def strut() -> CompiledElement:
    """A bar with mass whose measure is half the difference of the squared lengths over its length."""
    p, q = Point("p"), Point("q")
    l0, mass = Parameter("l0", 1, "m", "length"), Parameter("mass", 1, "kg", "mass")
    gravity = Parameter("gravity", 3, "m/s^2", "gravity")
    d = q.x - p.x
    green = (d.dot(d) - l0.symbol**2) / (2 * l0.symbol)
    energy = mass.symbol * (p.v.dot(p.v) + p.v.dot(q.v) + q.v.dot(q.v)) / 6
    weight = -mass.symbol * gravity.vector.dot(p.x + q.x) / 2
    return fx.compile_element(
        Element(
            "campaign_strut",
            (p, q),
            (l0, mass, gravity),
            (),
            (Deformation("stretch", "m", green),),
            kinetic_energy=energy,
            potential=weight,
            doc="stretch = (d.d - l0^2)/(2 l0)",
            source="campaign",
        )
    )


def cam() -> CompiledElement:
    """A cam in the plane and the tip of its follower."""
    axis, turn, tip = PlanarPoint("c"), PlanarAngle("cam"), PlanarPoint("p")
    base = Parameter("base", 1, "m", "radius of the base circle")
    lift = Parameter("lift", 1, "m", "height of the lobe")
    let = Let()
    d = let.vector("d", tip.x - axis.x)
    c, s = sp.cos(turn.x[0]), sp.sin(turn.x[0])
    r = let.scalar("r", sp.sqrt(d.dot(d)))
    along = let.scalar("along", (c * d[0] + s * d[1]) / r)
    gap = Deformation("gap", "m", r - base.symbol - lift.symbol * (1 + along) / 2)
    text = "gap = |p - c| - base - lift (1 + cos theta)/2"
    return fx.compile_element(
        Element(
            "campaign_cam", (axis, turn, tip), (base, lift), let.entries, (gap,), doc=text, source="campaign"
        )
    )


def skate() -> CompiledElement:
    """A blade in space: its point does not move along one direction of its frame."""
    p, r = Point("p"), Frame("r")
    side = Parameter("side", 3, "1", "direction without motion, in the axes of the frame")
    let = Let()
    across = let.vector("across", combination(triad(r.x), side.vector))
    sideways = Slip("sideways", "m/s", across.dot(p.v))
    text = "sideways = (R side).v"
    return fx.compile_element(
        Element(
            "campaign_skate", (p, r), (side,), let.entries, slips=(sideways,), doc=text, source="campaign"
        )
    )


def maxwell() -> CompiledLaw:
    """A spring beside a spring and a dashpot in series."""
    e, ed, creep = symbol("e"), symbol("ed"), symbol("creep")
    k, lag = Parameter("k", 1, "N/m", "stiffness"), Parameter("lag", 1, "s", "time constant")
    state = Internal("creep", "m", (e - creep) / lag.symbol)
    force = k.symbol * (e - creep)
    energy = k.symbol * (e - creep) ** 2 / 2
    text = "sigma = k (e - creep)"
    return fx.compile_law(
        Law(
            "campaign_maxwell",
            text,
            (k, lag),
            (e,),
            (ed,),
            (),
            (force,),
            (),
            energy,
            "campaign",
            states=(state,),
        )
    )


class Maxwell(Twin):
    """The law on one deformation."""

    conserves = False

    def __init__(self, measure: Measure, name: str, k: float, lag: float) -> None:
        self._load = Load(measure, 1.0)
        self.nodes, self.states, self._k, self._lag = measure.nodes, (f"{name}.creep",), k, lag
        self._value = measure.value

    def force(self, x: Array, v: Array, z: Array, t: float) -> Array:
        return -self._k * (self._value(x) - z[0]) * self._load.force(x, v, z, t)

    def zdot(self, x: Array, v: Array, z: Array, t: float) -> Array:
        return np.array([(self._value(x) - z[0]) / self._lag])


@handler(LawPart, options="name parameters")
def _law(drawing: Drawing, part: LawPart) -> None:
    (name,) = part.on
    measure = drawing.measured(name)
    drawing.free(name)
    drawing.twins.append(Maxwell(measure, str(part.name), **(part.parameters or {})))


@handler(ElementPart, options="parameters")
def _element(drawing: Drawing, part: ElementPart) -> None:
    assert isinstance(part.kind, CompiledElement)
    makers = {"campaign_strut": _strut, "campaign_cam": _cam, "campaign_skate": _skate}
    makers[part.kind.spec.name](drawing, part.name, tuple(map(str, part.nodes)), **(part.parameters or {}))


def _strut(drawing: Drawing, name: str, nodes: tuple[str, ...], *, l0: float, mass: float) -> None:
    def stretch(x: Array) -> Array:
        return (dot(x[3:] - x[:3], x[3:] - x[:3]) - l0**2) / (2 * l0)

    drawing.measure(f"{name}.stretch", nodes, stretch, True)
    drawing.twins.append(Bar((nodes[0], nodes[1]), mass, drawing.gravity))


def _cam(drawing: Drawing, name: str, nodes: tuple[str, ...], *, base: float, lift: float) -> None:
    def gap(x: Array) -> Array:
        d = x[3:] - x[:2]
        along = np.cos(x[2]) * d[0] + np.sin(x[2]) * d[1]
        return norm(d) - base - lift * (1 + along / norm(d)) / 2

    drawing.measure(f"{name}.gap", nodes, gap, True)


def _skate(drawing: Drawing, name: str, nodes: tuple[str, ...], *, side: Any) -> None:
    def sideways(x: Array) -> Array:
        return np.concatenate([rotated(x[3:], np.array(side)), 0 * x[3:]])

    drawing.slip(f"{name}.sideways", nodes, sideways, True)
