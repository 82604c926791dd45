"""A declaration that is refused leaves nothing behind in the model."""

from collections.abc import Callable

import pytest
from mistakes import pendulum

from flexel.base.errors import ModelError
from flexel.parts.model import Model


def test_a_model_that_failed_can_be_mended_and_built() -> None:
    m = pendulum()
    with pytest.raises(ModelError):
        m.hinge("elbow", "R1", "A", axis=(0, 1, 0))
    with pytest.raises(ModelError):
        m.beam("arm", "A", "R1", "O", "R0", EIy=1.0, mass_per_length=-1.0)
    system_ = m.build()  # nothing of the failed elements stays behind
    assert system_.dynamic == ("pivot.angle",)
    m.point("B", (2, 0, 0))
    m.frame("R2")
    m.hinge("elbow", "R1", "R2", axis=(0, 1, 0))
    m.beam("arm", "A", "R2", "B", mass_per_length=1.0)
    assert set(m.build().dynamic) == {"pivot.angle", "elbow.angle"}


@pytest.mark.parametrize(
    "declare",
    [
        lambda m: m.cable("new", "a", "s", "b", "t", EA=-1.0, EI=1.0),
        lambda m: m.cable("new", "a", "s", "b", "t", EA=1.0, EI=1.0, damping=-1.0),
        lambda m: m.beam("new", "a", "A", "b", "B", EA=1.0, GJ=1.0, EIy=1.0, EIz=1.0, damping=-1.0),
        lambda m: m.anchor("new", "a", "A", "b", "nowhere"),
        lambda m: m.truss("new", "a", "b", stiffness=1.0, damping=-1.0),
        lambda m: m.hinge("new", "A", "B", axis=(0, 0, 1), stiffness=-1.0),
    ],
)
def test_a_declaration_that_is_refused_leaves_nothing_behind(declare: Callable[[Model], None]) -> None:
    m = Model()
    for name, x in (("a", 0.0), ("b", 1.0)):
        m.point(name, (x, 0, 0))
    for name in ("A", "B"):
        m.frame(name)
    for name in ("s", "t"):
        m.slope(name, (1, 0, 0))
    with pytest.raises(ModelError):
        declare(m)
    assert (m.instances, m.laws, len(m.nodes)) == ({}, [], 6)
