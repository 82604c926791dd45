"""A model as its parts, with a state.  The model, the program to print and the twins come from one list."""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from importlib import import_module
from typing import Any

import numpy as np

import flexel as fx
from flexel.base.arrays import Array
from flexel.model.part import Part
from flexel.parts.cables import Slope
from flexel.parts.model_program import literal, program
from flexel.parts.nodes import Angle, Frame, Point
from flexel.parts.roles import Fix

SUFFIXES = {"frame": tuple(f"lambda{i}" for i in range(4)), "angle": ("angle",)}  # of others: x, y, z


class Kept(list[Part[Any]]):
    """The parts that methods of `Model` declare."""

    def add(self, part: Part[Any]) -> None:
        """Keep a part."""
        self.append(part)


def declared(method: str, *args: Any, **options: Any) -> Part[Any]:
    """The part that a method of `Model` declares."""
    kept = Kept()
    getattr(fx.Model, method)(kept, *args, **options)
    return kept[0]


def own(name: str) -> Any:
    """A compiled element or law of the campaign; all are compiled when the first is drawn."""
    return getattr(import_module("campaign.compiled"), name)


@dataclass(frozen=True)
class Case:
    """A model and a state of it.

    Attributes
    ----------
    family : str
        The family that it was drawn from.
    gravity : tuple of float
        [m/s²]; its length says whether the model is planar.
    parts : tuple of Part
        Those of the model.
    rates : tuple of float
        Of the dynamic degrees of freedom in the order in which the system has them; as many as needed are used, in
        turn.
    duration : float
        Of the motions that are compared [s].
    offsets : tuple of float
        What is added to the values of the dynamic degrees of freedom as drawn, in turn; none leaves them.
    speeds : dict of str to float
        Rates of degrees of freedom that are given by name, if the system has them.
    known : frozenset of str
        What the family promises: ``floating`` (no reaction of the ground), ``redundant`` (conditions that follow from
        others in every configuration; they are released as flexel's report says).
    """

    family: str
    gravity: tuple[float, ...]
    parts: tuple[Part[Any], ...]
    rates: tuple[float, ...] = (0.5,)
    duration: float = 0.05
    known: frozenset[str] = frozenset()
    offsets: tuple[float, ...] = ()
    speeds: Mapping[str, float] = field(default_factory=dict)

    def model(self) -> fx.Model:
        """The model of flexel."""
        return fx.Model.of(self.gravity, self.parts)

    def start(self, system: fx.System) -> fx.State:
        """The state in which equations are compared: that drawn, or beside it, with the rates of the case."""
        rates, names, more = self.rates_of(system.dynamic), system.dynamic, self.offsets
        rest = system.unaccelerated
        values = {name: rest[name] + more[i % len(more)] for i, name in enumerate(names)} if more else None
        return system.state_at(values, rates) if rates else system.initial

    def rates_of(self, dynamic: tuple[str, ...]) -> dict[str, float]:
        """Rates of the degrees of freedom."""
        rates = {name: self.rates[i % len(self.rates)] for i, name in enumerate(dynamic)}
        return rates | {name: speed for name, speed in self.speeds.items() if name in rates}

    def program(self) -> str:
        """The shortest program that makes the model and its state."""
        lines = [program(np.array(self.gravity), self.parts) + "s = m.build()"]
        lines.append(f"rates = {literal(self.rates)}")
        lines.append("rates = {name: rates[i % len(rates)] for i, name in enumerate(s.dynamic)}")
        if self.speeds:
            lines.append(
                f"rates |= {{name: speed for name, speed in {literal(dict(self.speeds))}.items() if name in rates}}"
            )
        values = ""
        if self.offsets:
            lines.append(f"more, drawn = {literal(self.offsets)}, s.unaccelerated")
            values = "{name: drawn[name] + more[i % len(more)] for i, name in enumerate(s.dynamic)}, "
        return "\n".join([*lines, f"state = s.state_at({values}rates=rates)"]) + "\n"

    def having(self, *more: Part[Any]) -> "Case":
        """The case with further parts."""
        return replace(self, parts=(*self.parts, *more))


@dataclass(frozen=True)
class Node:
    """A node as it is drawn."""

    name: str
    kind: str
    drawn: Array
    fixed: Array

    @property
    def names(self) -> tuple[str, ...]:
        """Names of its coordinates."""
        return tuple(f"{self.name}.{suffix}" for suffix in SUFFIXES.get(self.kind, "xyz")[: self.drawn.size])


def drawn_nodes(case: Case) -> dict[str, Node]:
    """Nodes by name, with the coordinates that ``m.fix`` and ``fixed=True`` hold."""
    found: dict[str, Node] = {}
    for part in case.parts:
        if isinstance(part, Slope):
            line = np.array(part.direction, float)
            _draw(found, "slope", part, line * (part.stretch / np.linalg.norm(line)))
        elif isinstance(part, Point):
            _draw(found, "point", part, part.position)
        elif isinstance(part, Frame):
            _draw(found, "frame", part, part.orientation)
        elif isinstance(part, Angle):
            _draw(found, "angle", part, part.value)
        elif isinstance(part, Fix):
            for name in map(str, part.names):
                node, _, component = name.rpartition(".") if name not in found else (name, "", "")
                rows = [f"{node}.{component}" == k for k in found[node].names] if component else slice(None)
                found[node].fixed[rows] = True
    return found


def _draw(found: dict[str, Node], kind: str, part: Point | Frame | Angle | Slope, value: Any) -> None:
    """Add the node of a part."""
    place = np.atleast_1d(np.array(value, float))
    found[part.name] = Node(part.name, kind, place, np.full(place.size, bool(part.fixed)))
