"""Springs, dampers, loads, prescribed motions and own laws."""

from typing import Any

import numpy as np

from campaign.calls import Call, Made
from campaign.oracle import jacobian
from campaign.parts import Drawing, Measure, handler
from campaign.twin import Twin
from flexel.base.arrays import Array


def function(value: Any) -> Any:
    """A function of time u(t), analytic, from a number or what makes flexel's."""
    if not isinstance(value, Made):
        return lambda t: value + 0 * t
    if value.name == "Harmonic":
        amplitude, omega, phase, offset = (*value.args, 0.0, 0.0)[:4]
        return lambda t: offset + amplitude * np.sin(omega * t + phase)
    if value.name == "Polynomial":
        return lambda t: sum(c * t**i for i, c in enumerate(value.args[0])) + 0 * t
    raise KeyError(f"no function of time {value.name}")


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


@handler("spring", options="stiffness damping free_length preload")
def _spring(drawing: Drawing, call: Call) -> None:
    name, *numbers = call.args
    k = numbers[0] if numbers else call.options.get("stiffness") or 0.0
    c = numbers[1] if len(numbers) > 1 else call.options.get("damping") or 0.0
    if name in drawing.slips:
        drawing.free(name)
        drawing.twins.append(SlipDamper(drawing.slips[name], c))
        return
    measure = drawing.measured(name)
    drawing.free(name)
    free, preload = call.options.get("free_length") or 0.0, call.options.get("preload") or 0.0
    if free and name.endswith(".elongation"):  # given as the length of the bar
        free -= float(np.linalg.norm(np.subtract(*(drawing.x(z) for z in measure.nodes))))
    drawing.twins.append(Spring(measure, k, c, free, preload))


@handler("release")
def _release(drawing: Drawing, call: Call) -> None:
    drawing.free(*call.args)


@handler("load")
def _load(drawing: Drawing, call: Call) -> None:
    target, value = call.args
    if target not in drawing.nodes:
        drawing.twins.append(Load(drawing.measured(target), value))
        return
    for name, part in zip(drawing.nodes[target].names, value, strict=True):  # a point
        drawing.twins.append(Load(drawing.measured(name), part))


@handler("prescribe")
def _prescribe(drawing: Drawing, call: Call) -> None:
    name, value = call.args
    measure = drawing.measured(name)
    drawing.free(name)
    node, _, _ = name.rpartition(".")
    start = 0.0
    if node in drawing.nodes:  # a coordinate is prescribed itself, not how far it is from where it was drawn
        start = float(drawing.nodes[node].drawn[drawing.nodes[node].names.index(name)])
    drawing.twins.append(Prescribed(measure, value, start))
