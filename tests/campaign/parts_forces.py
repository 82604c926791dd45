"""Springs, dampers, loads, prescribed motions and own laws."""

from typing import Any

import numpy as np

import flexel as fx
from campaign.oracle import jacobian
from campaign.parts import Drawing, Measure, handler
from campaign.twin import Twin
from flexel.base.arrays import Array
from flexel.parts import springs
from flexel.parts.loads import LoadPart
from flexel.parts.roles import Prescribe, Release


def function(value: Any) -> Any:
    """A function of time u(t), analytic, from a number or flexel's."""
    if isinstance(value, fx.Harmonic):
        return lambda t: value.offset + value.amplitude * np.sin(value.omega * t + value.phase)
    if isinstance(value, fx.Polynomial):
        return lambda t: sum(c * t**i for i, c in enumerate(value.coefficients)) + 0 * t
    if callable(value):
        raise KeyError(f"no function of time {value}")
    return lambda t: value + 0 * t


class Spring(Twin):
    """U = preload e + k (e - free)²/2 and a damper c ė."""

    def __init__(self, measure: Measure, k: float, c: float, free: float, preload: float) -> None:
        self.nodes, self.value = measure.nodes, measure.value
        self.k, self.c, self.free, self.preload, self.conserves = k, c, free, preload, not c

    def potential(self, x: Array) -> Array:
        e = self.value(x)
        return self.preload * e + self.k * (e - self.free) ** 2 / 2

    def force(self, x: Array, v: Array, z: Array, t: float) -> Array:
        slope = jacobian(self.value, x)
        return -self.c * (slope @ v) * slope


class SlipDamper(Twin):
    """τ = c s on a slip."""

    conserves = False

    def __init__(self, slip: Measure, c: float) -> None:
        self.nodes, self.value, self.c = slip.nodes, slip.value, c

    def force(self, x: Array, v: Array, z: Array, t: float) -> Array:
        row = self.value(x)
        return -self.c * (row @ v) * row


class Load(Twin):
    """A generalized force on a deformation or coordinate."""

    conserves = False

    def __init__(self, measure: Measure, value: Any) -> None:
        self.nodes, self.value, self.function = measure.nodes, measure.value, function(value)

    def force(self, x: Array, v: Array, z: Array, t: float) -> Array:
        return self.function(t) * jacobian(self.value, x)


class Prescribed(Twin):
    """e = u(t)."""

    conserves = False

    def __init__(self, measure: Measure, value: Any, start: float) -> None:
        self.nodes, self.value, self.function, self.start = (
            measure.nodes,
            measure.value,
            function(value),
            start,
        )

    def rigid(self, x: Array, t: Array) -> Array:
        return np.array([self.start + self.value(x) - self.function(t)])


@handler(springs.Spring, options="stiffness damping free_length preload")
def _spring(drawing: Drawing, part: springs.Spring) -> None:
    name, numbers = str(part.on), (part.stiffness, part.damping, part.free_length, part.preload)
    k, c, free, preload = (float(value or 0.0) for value in numbers)
    if name in drawing.slips:
        drawing.free(name)
        drawing.twins.append(SlipDamper(drawing.slips[name], c))
        return
    measure = drawing.measured(name)
    drawing.free(name)
    if free and name.endswith(".elongation"):  # given as the length of the bar
        free -= float(np.linalg.norm(np.subtract(*(drawing.x(node) for node in measure.nodes))))
    drawing.twins.append(Spring(measure, k, c, free, preload))


@handler(Release)
def _release(drawing: Drawing, part: Release) -> None:
    drawing.free(*part.names)


@handler(LoadPart)
def _load(drawing: Drawing, part: LoadPart) -> None:
    target, value = str(part.target), part.value
    if target not in drawing.nodes:
        drawing.twins.append(Load(drawing.measured(target), value))
        return
    for name, component in zip(drawing.nodes[target].names, value, strict=True):  # a point
        drawing.twins.append(Load(drawing.measured(name), component))


@handler(Prescribe)
def _prescribe(drawing: Drawing, part: Prescribe) -> None:
    name = part.name
    measure = drawing.measured(name)
    drawing.free(name)
    node, _, _ = name.rpartition(".")
    start = 0.0
    if node in drawing.nodes:  # a coordinate is prescribed itself, not how far it is from where it was drawn
        start = float(drawing.nodes[node].drawn[drawing.nodes[node].names.index(name)])
    drawing.twins.append(Prescribed(measure, part.motion, start))
