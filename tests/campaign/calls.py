"""A model as plain data: the calls that make it. The model, the program to print and the twins come from one list."""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

import flexel as fx
from flexel.base.arrays import Array

SUFFIXES = {"frame": tuple(f"lambda{i}" for i in range(4)), "angle": ("angle",)}  # of others: x, y, z


@dataclass(frozen=True)
class Made:
    """An object of flexel as an argument: ``fx.name(*args, **options)``."""

    name: str
    args: tuple[Any, ...] = ()
    options: Mapping[str, Any] = field(default_factory=dict)

    def __repr__(self) -> str:
        return f"fx.{self.name}({written(self.args, self.options)})"

    def value(self) -> Any:
        """The object."""
        return getattr(fx, self.name)(*map(real, self.args), **{k: real(z) for k, z in self.options.items()})


@dataclass(frozen=True)
class Own:
    """An object from a module of the campaign as an argument: an own element or law, compiled once."""

    module: str
    name: str

    def __repr__(self) -> str:
        return f"{self.module}.{self.name}()"

    def value(self) -> Any:
        """The object."""
        return getattr(__import__(f"campaign.{self.module}", fromlist=[self.name]), self.name)()


@dataclass(frozen=True)
class Call:
    """A call of a method of the model: ``m.method(*args, **options)``."""

    method: str
    args: tuple[Any, ...] = ()
    options: Mapping[str, Any] = field(default_factory=dict)

    def __repr__(self) -> str:
        return f"m.{self.method}({written(self.args, self.options)})"

    @property
    def name(self) -> str:
        """Its first argument: the name of what it makes."""
        return str(self.args[0])


def call(method: str, *args: Any, **options: Any) -> Call:
    """A call with its arguments, written as it is made."""
    return Call(method, args, options)


def written(args: tuple[Any, ...], options: Mapping[str, Any]) -> str:
    """Arguments as in a program."""
    return ", ".join([*map(shown, args), *(f"{key}={shown(z)}" for key, z in options.items())])


def shown(value: Any) -> str:
    """A value as in a program; numbers with all digits and without NumPy's types."""
    if isinstance(value, np.ndarray):
        value = value.tolist()
    if isinstance(value, np.generic):
        value = value.item()
    if isinstance(value, tuple):
        return f"({', '.join(map(shown, value))}{',' if len(value) == 1 else ''})"
    if isinstance(value, list):
        return f"[{', '.join(map(shown, value))}]"
    if isinstance(value, dict):
        return "{" + ", ".join(f"{key!r}: {shown(z)}" for key, z in value.items()) + "}"
    return repr(value)


def real(value: Any) -> Any:
    """What a value stands for."""
    if isinstance(value, Made | Own):
        return value.value()
    if isinstance(value, tuple | list):
        return type(value)(map(real, value))
    return value


@dataclass(frozen=True)
class Case:
    """A model and a state of it.

    Attributes
    ----------
    family : str
        The family that it was drawn from.
    gravity : tuple of float
        [m/s²]; its length says whether the model is planar.
    calls : tuple of Call
        What makes the model.
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
    calls: tuple[Call, ...]
    rates: tuple[float, ...] = (0.5,)
    duration: float = 0.05
    known: frozenset[str] = frozenset()
    offsets: tuple[float, ...] = ()
    speeds: Mapping[str, float] = field(default_factory=dict)

    def model(self) -> fx.Model:
        """The model of flexel."""
        m = fx.Model(gravity=self.gravity)
        for z in self.calls:
            getattr(m, z.method)(*map(real, z.args), **{key: real(a) for key, a in z.options.items()})
        return m

    def start(self, system: fx.System) -> fx.State:
        """The state in which equations are compared: that drawn, or beside it, with the rates of the case."""
        rates, names, more = self.rates_of(system.dynamic), system.dynamic, self.offsets
        rest = system.unaccelerated
        values = {z: rest[z] + more[i % len(more)] for i, z in enumerate(names)} if more else None
        return system.state_at(values, rates) if rates else system.initial

    def rates_of(self, dynamic: tuple[str, ...]) -> dict[str, float]:
        """Rates of the degrees of freedom."""
        rates = {name: self.rates[i % len(self.rates)] for i, name in enumerate(dynamic)}
        return rates | {name: speed for name, speed in self.speeds.items() if name in rates}

    def program(self) -> str:
        """The shortest program that makes the model and its state."""
        own = sorted(
            {z.module for c in self.calls for z in (*c.args, *c.options.values()) if isinstance(z, Own)}
        )
        lines = ["import flexel as fx", *(f"from campaign import {module}" for module in own), ""]
        lines += [f"m = fx.Model(gravity={shown(self.gravity)})", *map(repr, self.calls), "s = m.build()"]
        lines.append(f"rates = {shown(self.rates)}")
        lines.append("rates = {z: rates[i % len(rates)] for i, z in enumerate(s.dynamic)}")
        if self.speeds:
            lines.append(f"rates |= {{z: v for z, v in {shown(dict(self.speeds))}.items() if z in rates}}")
        values = ""
        if self.offsets:
            lines.append(f"more, drawn = {shown(self.offsets)}, s.unaccelerated")
            values = "{z: drawn[z] + more[i % len(more)] for i, z in enumerate(s.dynamic)}, "
        return "\n".join([*lines, f"state = s.state_at({values}rates=rates)"]) + "\n"

    def with_calls(self, *more: Call) -> "Case":
        """The case with further calls."""
        return replace(self, calls=(*self.calls, *more))


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
        return tuple(f"{self.name}.{z}" for z in SUFFIXES.get(self.kind, "xyz")[: self.drawn.size])


def drawn_nodes(case: Case) -> dict[str, Node]:
    """Nodes by name, with the coordinates that ``m.fix`` and ``fixed=True`` hold."""
    found: dict[str, Node] = {}
    for z in case.calls:
        if z.method == "slope":
            line = np.array(z.args[1], float)
            line *= z.options.get("stretch", 1.0) / np.linalg.norm(line)
            found[z.name] = Node(
                z.name, z.method, line, np.full(line.size, bool(z.options.get("fixed", False)))
            )
        if z.method in ("point", "frame", "angle"):
            default = {"frame": (1.0, 0.0, 0.0, 0.0), "angle": 0.0, "point": ()}[z.method]
            keyword = {"frame": "orientation", "angle": "value", "point": "position"}[z.method]
            value = z.args[1] if len(z.args) > 1 else z.options.get(keyword, default)
            place = np.atleast_1d(np.array(value, float))
            held = np.full(place.size, bool(z.options.get("fixed", False)))
            found[z.name] = Node(z.name, z.method, place, held)
        if z.method == "fix":
            for name in z.args:
                node, _, part = str(name).rpartition(".") if name not in found else (name, "", "")
                rows = [f"{node}.{part}" == k for k in found[node].names] if part else slice(None)
                found[node].fixed[rows] = True
    return found
