"""Mistakes of careless users: each raises a flexel error that names the object and the remedy.

A case is a function, the class of the error, and words that its message must hold: the object first, then words of
the remedy.  The tables stand in the files `test_bad_*.py` of each subject.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import pytest

from flexel.base.errors import FlexelError, LinearizationError, ModelError
from flexel.parts.model import Model
from flexel.results.linearization import Linearization
from flexel.results.system_facade import System


def drawing() -> Model:
    """Two points and two frames, one of each fixed."""
    m = Model(gravity=(0, 0, -9.81))
    m.point("O", (0, 0, 0), fixed=True)
    m.point("A", (1, 0, 0))
    m.frame("R0", fixed=True)
    m.frame("R1")
    return m


def plane() -> Model:
    """The same in the plane."""
    m = Model()
    m.point("O", (0, 0), fixed=True)
    m.point("A", (1, 0))
    m.angle("R0", fixed=True)
    m.angle("R1")
    return m


def pendulum() -> Model:
    """A rod on a hinge."""
    m = drawing()
    m.hinge("pivot", "R0", "R1", axis=(0, 1, 0))
    m.beam("rod", "O", "R1", "A", mass_per_length=2.0)
    return m


def double() -> Linearization:
    """Linearization of a double pendulum, whose degrees of freedom are coupled."""
    m = pendulum()
    m.frame("R2")
    m.point("B", (2, 0, 0))
    m.hinge("elbow", "R1", "R2", axis=(0, 1, 0))
    m.beam("forearm", "A", "R2", "B", mass_per_length=1.0)
    m.independent("pivot.angle", "elbow.angle")
    return m.build().linearize()


@dataclass(frozen=True)
class Case:
    """A mistake, the class of its error, and words of the message."""

    mistake: Callable[[], Any]
    words: tuple[str, ...]
    error: type[FlexelError] = ModelError


def draw(mistake: Callable[[Model], Any], *words: str, error: type[FlexelError] = ModelError) -> Case:
    """A mistake in a spatial drawing, found when it is made."""
    return Case(lambda: mistake(drawing()), words, error)


def flat(mistake: Callable[[Model], Any], *words: str) -> Case:
    """A mistake in a planar drawing, found when it is made."""
    return Case(lambda: mistake(plane()), words)


def built(mistake: Callable[[Model], Any], *words: str, error: type[FlexelError] = ModelError) -> Case:
    """A mistake in the pendulum, found when it is made or when the model is built."""

    def run() -> None:
        m = pendulum()
        mistake(m)
        m.build()

    return Case(run, words, error)


def system(mistake: Callable[[System], Any], *words: str, error: type[FlexelError] = ModelError) -> Case:
    """A mistake with the built pendulum."""
    return Case(lambda: mistake(pendulum().build()), words, error)


def linear(mistake: Callable[[Linearization], Any], *words: str) -> Case:
    """A mistake with the linearized double pendulum."""
    return Case(lambda: mistake(double()), words, LinearizationError)


def each(cases: Mapping[str, Case]) -> pytest.MarkDecorator:
    """Parametrize a test over a table of mistakes, by their labels."""
    return pytest.mark.parametrize("case", cases.values(), ids=cases.keys())


def check(case: Case) -> None:
    """The mistake raises its error, the message holds all words, and no number is printed as NumPy's."""
    with pytest.raises(case.error) as caught:
        case.mistake()
    message = str(caught.value)
    assert [word for word in case.words if word not in message] == [], message
    assert "np.float64" not in message
