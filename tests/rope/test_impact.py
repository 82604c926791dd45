"""Dissipation factors from restitutions."""

import pytest

import flexel as fx
from flexel.rope.impact import hunt_crossley, lankarani_nikravesh


def test_both_factors_agree_near_restitution_one_and_vanish_there() -> None:
    assert hunt_crossley(1.0, 2.0) == lankarani_nikravesh(1.0, 2.0) == 0.0
    assert hunt_crossley(0.999, 2.0) == pytest.approx(lankarani_nikravesh(0.999, 2.0), rel=1e-3)
    assert lankarani_nikravesh(0.5, 2.0) == pytest.approx(0.75 * 0.75 / 2.0)


@pytest.mark.parametrize(
    ("e", "v", "message"), [(1.2, 1.0, "not between 0 and 1"), (0.5, 0.0, "not positive")]
)
def test_impossible_impacts_are_refused(e: float, v: float, message: str) -> None:
    with pytest.raises(fx.ModelError, match=message):
        hunt_crossley(e, v)
