"""The parts of a file's model, each with the line that declares it."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import Any

from flexel.apps.spacar.lexer import Line
from flexel.apps.spacar.problems import Problems
from flexel.base.errors import ModelError
from flexel.model.part import Part
from flexel.parts.loads import AngularVelocity, LoadPart
from flexel.parts.looks import LookPart
from flexel.parts.model import Model
from flexel.parts.roles import Fix, Independent, Initial, Kinematic, Prescribe, Release, Rigid
from flexel.parts.springs import Spring

# parts that name what others declare, and add no node or element
ABOUT_DECLARED = (
    Fix, LoadPart, Prescribe, Independent, Kinematic, Initial, Rigid, Release, Spring, AngularVelocity, LookPart,
)  # fmt: skip
KINDS = ("truss", "planar_truss", "beam_warping")  # of elements, which are not names of this model


@dataclass(frozen=True)
class Declaration:
    """A part of the model, and the line of the file that declares it."""

    part: Part[Any]
    line: Line

    @classmethod
    def of(cls, line: Line, kind: Callable[..., Part[Any]], *args: Any, **options: Any) -> Declaration:
        """Make a part of some kind; an error reports the line of the file."""
        try:
            return cls(kind(*args, **options), line)
        except ModelError as error:
            raise line.error(str(error)) from error


def checked_model(gravity: Sequence[float], declarations: Iterable[Declaration], problems: Problems) -> Model:
    """Build the model and collect all errors; parts that need a failed declaration are left out."""
    model = Model(gravity=tuple(gravity))
    for declaration in declarations:
        known = model.nodes.keys() | model.instances.keys() | _new(declaration.part)
        if problems and not _names(declaration.part.call()[0]) <= known:
            continue
        with problems.collected():
            _add(model, declaration)
    return model


def _add(model: Model, declaration: Declaration) -> None:
    """Add a part to the model; an error reports the line of the file."""
    try:
        model.add(declaration.part)
    except ModelError as error:
        raise declaration.line.error(str(error)) from error


def _new(part: Part[Any]) -> set[str]:
    """Return the name that a part declares; none if it refers only to declared names."""
    return set() if isinstance(part, ABOUT_DECLARED) else {part.call()[0][0]}


def _names(given: Any) -> set[str]:
    """Return names of nodes and elements in arguments."""
    if isinstance(given, str):
        return set() if given in KINDS else {given.split(".")[0]}
    return set().union(*map(_names, given)) if isinstance(given, (tuple, list)) else set()
