"""Curves of springs and dampers: value, energy, continuity, digits; one-sided stops."""

from decimal import Decimal
from typing import Any

import numpy as np
import pytest
from mechanisms import strut

import flexel as fx
from flexel.parts.curves import NEVER, PIECES

POLYNOMIAL = (-4.0092e6, 2.8397e7, -6.7061e7, 5.2796e7)  # terms of a million newtons that nearly cancel


def test_a_polynomial_of_the_length_loses_no_digits() -> None:
    length = 0.44055648
    m = strut(length)
    m.spring("strut.elongation", fx.Curve([POLYNOMIAL]), free_length=0.0)
    s = m.build()
    for e in (0.0, -0.0057, 0.0213):
        Z = Decimal(length) + Decimal(e)
        exact = float(sum(Decimal(c) * Z**i for i, c in enumerate(POLYNOMIAL)))
        state = s.state_at({"strut.elongation": e})
        assert state.force("strut.elongation") == pytest.approx(exact, rel=1e-11)


def test_the_energy_of_a_curve_is_the_work_done_on_it() -> None:
    spring = fx.Curve([[-130.0, 150.0], [-45.0, 50.0], [-107.5, 100.0]], breaks=[0.85, 1.25])
    m = strut()
    m.spring("strut.elongation", spring, free_length=0.0)
    m.initial("A.x", rate=2.5)
    motion = m.build().simulate(4.0, rtol=1e-10, atol=1e-12)
    assert motion["A.x"].min() < 0.85 < 1.25 < motion["A.x"].max()  # through all three pieces
    E = motion.energy["total"]
    assert np.ptp(E) < 1e-7 * E[0]
    assert motion[0].energy.strain == pytest.approx(0.0, abs=1e-15)


def test_beyond_its_ends_a_curve_goes_on() -> None:
    c = fx.Curve([[0.0, 1.0], [1.0, 0.0, 0.0], [3.0, -1.0]], breaks=[1.0, 2.0])
    assert (c(-10.0), c(1.5), c(12.0)) == (-10.0, 1.0, -9.0)
    table = fx.Curve.through([0, 1, 2, 3], [0, 1, 4, 4])
    assert [table(x) for x in (0, 1, 2, 3)] == pytest.approx([0, 1, 4, 4], abs=1e-12)
    assert table(5.0) == pytest.approx(4.0 + (table(4.0) - 4.0) * 2, abs=1e-9)
    values = [table(x) for x in np.linspace(0, 3, 50)]
    assert np.all(np.diff(values) > -1e-9)  # no overshoot
    assert table.parameters(0.0)["breaks"][-1] == NEVER


def test_a_damper_acts_on_the_rate() -> None:
    damper = fx.Curve([[-416.42, 1844.3], [0.0, 9945.627, 33955.72, -59832.25, -395651.0], [1919.1638, 1634.727]],
                      breaks=[-0.2, 0.21])  # fmt: skip
    for rate, force in ((-1.5, -3182.87), (0.1, 1234.72255), (0.5, 2736.5273)):
        m = strut()
        m.spring("strut.elongation", damping=damper)
        m.initial("A.x", rate=rate)
        s = m.build().initial
        assert s.force("strut.elongation") == pytest.approx(force, rel=1e-6)
        assert s.dissipated == pytest.approx(force * rate, rel=1e-6)


def test_a_stop_is_one_sided_and_never_pulls() -> None:
    m = strut()
    m.stop("strut.elongation", gap=0.1, stiffness=1e4, damping=2.0)
    s = m.build()
    for e, rate, force in (
        (0.05, 1.0, 0.0),
        (0.2, 0.0, 1000.0),
        (0.2, 1.0, 3000.0),
        (0.2, -1.0, 0.0),
        (-0.5, 0.0, 0.0),
    ):
        state = s.state_at({"strut.elongation": e}, {"strut.elongation": rate})
        assert state.force("strut.elongation") == pytest.approx(force, rel=1e-12)


def test_curves_that_cannot_be_are_refused() -> None:
    with pytest.raises(fx.ModelError, match=r"curve: it jumps from 1 to 3 at 1; correct a coefficient"):
        fx.Curve([[0.0, 1.0], [3.0]], breaks=[1.0])
    with pytest.raises(fx.ModelError, match="are not increasing; sort them"):
        fx.Curve([[0.0], [0.0], [0.0]], breaks=[2.0, 1.0])
    with pytest.raises(fx.ModelError, match=f"give 1 to {PIECES} pieces, with a break"):
        fx.Curve([[0.0], [0.0]])
    with pytest.raises(fx.ModelError, match="piece 1 has 6 coefficients; give 1 to 5"):
        fx.Curve([[0.0] * 6])
    with pytest.raises(fx.ModelError, match=r"spring on 'strut.elongation': damping gives 4 at rest"):
        strut().spring("strut.elongation", damping=fx.Curve([[4.0, 1.0]]))


def test_a_break_in_free_play_joins_up_to_rounding() -> None:
    play = fx.Curve([[0.0], [-3e4 * 0.07, 3e4]], breaks=[0.07])
    assert play(0.05) == 0.0
    assert play(0.08) == pytest.approx(300.0)


def test_a_damper_through_a_table_gives_nothing_at_rest_up_to_rounding() -> None:
    m = strut()
    m.spring("strut.elongation", damping=fx.Curve.through([-0.3, -0.1, 0.1, 0.3], [-700, -350, 350, 700]))
    m.initial("strut.elongation", rate=0.1)
    assert m.build().initial.force("strut.elongation") == pytest.approx(350.0)


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ((3.0,), "pieces 3.0 are not a list; give"),
        ((None,), "pieces None are not a list; give"),
        (([0, 1], [0.0]), "piece 1 0 is not a list of coefficients; give"),
        (
            ([[[0, 1e5], [0, 0]]],),
            r"piece 1 \[\[0, 100000.0\], \[0, 0\]\] is not a list of coefficients; give",
        ),
    ],
)
def test_pieces_that_are_no_lists_are_refused(given: Any, message: str) -> None:
    with pytest.raises(fx.ModelError, match=f"curve: {message}"):
        fx.Curve(*given)


def test_a_place_that_is_not_a_number_is_refused() -> None:
    with pytest.raises(fx.ModelError, match="curve: place 'a' is not numeric; give"):
        fx.Curve([[0.0, 1.0]])("a")  # type: ignore[arg-type]
