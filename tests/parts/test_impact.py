"""Dissipation factors from restitutions."""

import pytest

import flexel as fx

HC, LN = "hunt-crossley", "lankarani-nikravesh"


def factor(e: float, v: float, law: str) -> float:
    return fx.Contact.restitution(1e6, e, v, law=law).dissipation


def test_both_factors_agree_near_restitution_one_and_vanish_there() -> None:
    assert factor(1.0, 2.0, HC) == factor(1.0, 2.0, LN) == 0.0
    assert factor(0.999, 2.0, HC) == pytest.approx(factor(0.999, 2.0, LN), rel=1e-3)
    assert factor(0.5, 2.0, LN) == pytest.approx(0.75 * 0.75 / 2.0)
    assert factor(0.5, 2.0, HC) == pytest.approx(0.75 / 2.0)


def test_the_rest_of_the_contact_is_as_given() -> None:
    contact = fx.Contact.restitution(1e6, 0.9, 2.0, friction=0.2, points=3)
    assert (contact.stiffness, contact.friction, contact.points) == (1e6, 0.2, 3)
    assert contact.dissipation == factor(0.9, 2.0, "exact")
    assert contact.dissipation == pytest.approx(factor(0.9, 2.0, HC), rel=0.12)


@pytest.mark.parametrize("exponent", [1.0, 1.5])
@pytest.mark.parametrize("e", [0.01, 0.05, 0.5, 0.9, 0.999])
def test_a_mass_comes_back_with_the_restitution_that_was_asked_for(e: float, exponent: float) -> None:
    m = fx.Model()
    m.point("origin", (0, 0, 0), fixed=True)
    m.plane("floor", "origin", m.frame("ground", fixed=True), normal=(0, 0, 1))
    ball = m.point("ball", (0, 0, 1))
    m.point_mass("mass", ball, 2.0)
    m.fix("ball.x", "ball.y")
    m.contact("touch", ball, "floor", fx.Contact.restitution(1e6, e, 3.0, exponent=exponent))
    m.initial("ball.z", rate=-3.0)
    motion = m.build().simulate(1.0, samples=2)
    assert motion["ball.z'"][-1] == pytest.approx(3.0 * e, rel=1e-7)


@pytest.mark.parametrize(
    ("e", "v", "law", "message"),
    [
        (1.2, 1.0, HC, "contact: restitution 1.2 is not between 0 and 1"),
        (0.0, 1.0, "exact", "contact: restitution 0 takes a dissipation without bound; give a small number"),
        (0.5, 0.0, LN, "contact: speed of approach 0 is not positive"),
        (0.5, 1.0, "hertz", "contact: unknown law of restitution 'hertz'"),
    ],
)
def test_impossible_impacts_are_refused(e: float, v: float, law: str, message: str) -> None:
    with pytest.raises(fx.ModelError, match=message):
        factor(e, v, law)
