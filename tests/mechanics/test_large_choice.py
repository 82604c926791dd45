"""Degrees of freedom of large models: named ones are taken as they are if they determine the model."""

import numpy as np
import pytest

import flexel as fx
from flexel.examples.linkages import (
    CRANK,
    GRAVITY,
    SPACING,
    cranks_acceleration,
    ladder,
    ladder_error,
    ladder_state,
)
from flexel.mechanics import diagnose

MANY = 220  # pairs of coordinates: matrices are sparse


def cranks(*independent: str, doubled: bool = False) -> fx.Model:
    """Parallel cranks tied by couplers; doubled, one coupler is there twice."""
    m = fx.Model(gravity=(0, -GRAVITY))
    for i in range(MANY):
        m.point(f"a{i}", (SPACING * i, 0), fixed=True)
        m.point(f"b{i}", (SPACING * i, CRANK))
        m.truss(f"crank{i}", f"a{i}", f"b{i}", mass_per_length=1.0)
    for i in range(1, MANY):
        m.truss(f"coupler{i}", f"b{i - 1}", f"b{i}")
    if doubled:
        m.truss("second", "b6", "b7")
    if independent:
        m.independent(*independent)
    return m


def test_named_ones_that_determine_the_model_need_no_null_space(monkeypatch: pytest.MonkeyPatch) -> None:
    """A regular matrix shows at once that no condition is redundant; dense null spaces take minutes."""
    monkeypatch.setattr(diagnose, "null_space", pytest.fail)
    assert list(cranks("b0.x").build().dynamic) == ["b0.x"]


def test_a_redundant_condition_is_named_all_the_same() -> None:
    with pytest.raises(
        fx.ConstraintError, match=r"1 rigid or prescribed condition\(s\) is redundant, among '.*second"
    ):
        cranks("b0.x", doubled=True).build()


@pytest.mark.parametrize("names", [("b0.y",), ("b0.x", "b1.x")])
def test_those_that_do_not_determine_it_are_refused(names: tuple[str, ...]) -> None:
    """The cranks stand upright: their tips do not move up; two of them depend on one another."""
    with pytest.raises(
        fx.ConstraintError, match="do not determine the 440 coordinates of this model; name none"
    ):
        cranks(*names).build()


def test_without_names_one_is_chosen() -> None:
    assert len(cranks().build().dynamic) == 1


@pytest.mark.parametrize("n", [3, MANY])
def test_cranks_side_by_side_move_as_one_body(n: int) -> None:
    """With dense and sparse matrices; the closed form is that of one compound pendulum."""
    assert ladder_error(ladder(n).rhs(0.0, ladder_state()), n) < 1e-10
    assert cranks_acceleration(1) == pytest.approx(-1.5 * GRAVITY / CRANK * np.cos(0.7))
