"""The model of a file as a list of calls of `Model`: run here, or printed as Python by the converter.

One list serves both, so a converted file cannot differ from the one that was read.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, fields
from typing import Any

from flexel.base.errors import ModelError
from flexel.base.time_functions import Polynomial
from flexel.declare.round_sections import Circle
from flexel.declare.sections import Rectangle
from flexel.model import Model
from flexel.spacar.lexer import Line
from flexel.spacar.problems import Problems

# methods whose first argument is not a new name
ABOUT_DECLARED = frozenset(
    "fix load prescribe independent kinematic initial rigid release spring angular_velocity look".split()
)
KINDS = ("truss", "planar_truss", "beam_warping")  # of `Model.element`, which are not names of this model


@dataclass(frozen=True)
class Call:
    """One method of `Model` with its arguments: numbers, texts, tuples, mappings, polynomials and sections.

    Attributes
    ----------
    line : Line
        Its line in the file.
    """

    method: str
    arguments: tuple[Any, ...]
    options: dict[str, Any]
    line: Line

    def apply(self, model: Model) -> None:
        """Call the method; an error reports the line of the file."""
        try:
            getattr(model, self.method)(*self.arguments, **self.options)
        except ModelError as error:
            raise self.line.error(str(error)) from error

    def __str__(self) -> str:
        options = [f"{key}={literal(value)}" for key, value in self.options.items()]
        return f"m.{self.method}({', '.join([*map(literal, self.arguments), *options])})"


def literal(value: Any) -> str:
    """Python source of an argument."""
    if isinstance(value, (Rectangle, Circle)):
        sizes = (getattr(value, z.name) for z in fields(value))
        return f"fx.{type(value).__name__}({', '.join(map(literal, sizes))})"
    if isinstance(value, Polynomial):
        return f"fx.Polynomial({literal(tuple(value.coefficients))})"
    if isinstance(value, str):
        return '"' + value.replace("\\", "\\\\").replace('"', '\\"') + '"'
    if isinstance(value, tuple):
        return f"({', '.join(map(literal, value))}{',' if len(value) == 1 else ''})"
    if isinstance(value, list):
        return f"[{', '.join(map(literal, value))}]"
    if isinstance(value, dict):
        return "{" + ", ".join(f"{literal(k)}: {literal(v)}" for k, v in value.items()) + "}"
    return repr(float(value)) if isinstance(value, float) else repr(value)


def build_model(gravity: Sequence[float], calls: Iterable[Call]) -> Model:
    """The model that the calls declare.

    Raises
    ------
    ModelError
        The first call that the model refuses; names file and line.
    """
    model = Model(gravity=tuple(gravity))
    for call in calls:
        call.apply(model)
    return model


def checked_model(gravity: Sequence[float], calls: Iterable[Call], problems: Problems) -> Model:
    """The same, with all refusals collected; where something could not be declared, what needs it is left out."""
    model = Model(gravity=tuple(gravity))
    for call in calls:
        if problems and not _names(call.arguments) <= model.nodes.keys() | model.instances.keys() | _new(
            call
        ):
            continue
        with problems.collected():
            call.apply(model)
    return model


def _new(call: Call) -> set[str]:
    """The name that a call declares; none if it is about declared names alone."""
    return set() if call.method in ABOUT_DECLARED else {call.arguments[0]}


def _names(given: Any) -> set[str]:
    """Names of nodes and elements in arguments."""
    if isinstance(given, str):
        return set() if given in KINDS else {given.split(".")[0]}
    return set().union(*map(_names, given)) if isinstance(given, (tuple, list)) else set()
