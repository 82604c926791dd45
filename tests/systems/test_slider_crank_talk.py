"""The talk's slider-crank: two beams without second-order terms, linearized and full."""

import numpy as np
import pytest

from flexel.examples import slider_crank as example
from flexel.examples import slider_crank_branch as branches
from flexel.examples import slider_crank_data as data
from flexel.examples import slider_crank_talk as talk


def test_the_periodic_small_vibration_in_time_is_that_of_harmonic_balance() -> None:
    c = example.nominal_orbit(165.0, talk.ELEMENTS, 0.01, second_order=False).coefficients
    expected = c.harmonic_balance(example.HARMONICS).samples()[0]
    found = talk.periodic_in_time(c)
    assert found == pytest.approx(expected, abs=1e-6 * np.abs(expected).max())


def test_the_transition_has_the_floquet_multipliers() -> None:
    c = example.nominal_orbit(205.0, talk.ELEMENTS, 0.02, second_order=False).coefficients
    Y = np.eye(9)
    for step in talk.transitions(c):
        Y = step @ Y
    found = np.abs(np.linalg.eigvals(Y[:-1, :-1]))
    expected = np.abs(c.floquet_multipliers())[:4]
    # accurate to a share of the transition matrix's largest entry
    assert np.sort(found)[::-1][:4] == pytest.approx(expected, rel=1e-6, abs=1e-9)
    assert Y[-1] == pytest.approx(np.eye(9)[-1], abs=1e-14)


@pytest.mark.long
def test_the_linearized_transient_comes_closer_to_the_full_one_at_half_the_speed() -> None:
    off = []
    for speed in (data.SPEED, data.SPEED / 2):
        system = example.slider_crank(speed, talk.ELEMENTS, 0.02, second_order=False)
        run = system.simulate(
            example.SECONDS, times=example.TIMES, method="Radau", rtol=1e-8, atol=1e-11, progress=False
        )
        full = example.deflection(run, talk.ELEMENTS)
        off.append(np.abs(talk.linear_transient(speed, 0.02) - full).max() / np.abs(full).max())
    assert 0 < off[0] < 0.04
    assert off[1] < off[0] / 2


@pytest.mark.parametrize(
    ("zeta", "expected"),
    [(0.01, ((164.8, 0.01745), (205.46, 0.06067), (270.26, 0.10293))), (0.02, ((164.8, 0.01626),))],
)
def test_the_linearized_sweep_has_the_maxima_of_the_talk(
    zeta: float, expected: tuple[tuple[float, float], ...]
) -> None:
    """Near ω₀/5, ω₀/4 and ω₀/3; at ω₀/6 only with 1 % damping."""
    swept = example.linear_sweep(zeta, talk.ELEMENTS, harmonics=16, second_order=False)
    found = example.linear_maxima(zeta, swept, talk.ELEMENTS, second_order=False)
    assert len(found) == (4 if zeta == 0.01 else 3)
    first = example.omega0(talk.ELEMENTS, second_order=False)
    assert first / found[-3:, 0] == pytest.approx(data.TALK_RESONANCES, rel=0.03)
    for row, (speed, largest) in zip(found[-3:], expected, strict=False):
        assert row[0] == pytest.approx(speed, abs=0.06)
        assert row[1] == pytest.approx(largest, rel=5e-3)


def test_the_rod_itself_has_no_maximum_at_a_fifth_with_two_percent_damping() -> None:
    speeds = np.linspace(145.0, 185.0, 41)
    swept = example.linear_sweep(0.02, example.CONVERGED, speeds)
    assert np.all(np.diff(swept.largest) > 0)
    assert len(example.linear_maxima(0.02, swept, example.CONVERGED)) == 0


def test_the_full_motions_have_their_maximum_at_a_fifth_whatever_the_step() -> None:
    found = [
        talk.full_maxima(0.02, talk.full_motions(0.02, np.arange(160.0, 171.0, step).tolist()))
        for step in (2.0, 1.0)
    ]
    (coarse,), (fine,) = found
    assert fine == pytest.approx((166.13, 0.016132), rel=1e-4)
    assert coarse[0] == pytest.approx(fine[0], abs=2 * talk.SPEED_TOLERANCE)
    assert coarse[1] == pytest.approx(fine[1], rel=1e-6)


@pytest.mark.long
def test_the_maximum_of_a_curve_that_turns_back_is_on_its_upper_part() -> None:
    """At 1 % damping near ω₀/3: above the fold, on the stable motions, and higher than all others found."""
    branch = talk.full_branch(0.01, (262.0, 272.0))
    values = branches.deflections(branch, talk.ELEMENTS)
    first, second = branch.omega[branch.folds]
    assert first > second
    (top,) = talk.full_maxima(0.01, branch)
    assert second < top[0] < first
    assert values.max() < top[1] < 1.01 * values.max()
    start = branch[int(np.argmax(values))]
    for speed in (top[0] - 0.1, top[0] + 0.1):
        beside = talk.full_motion(0.01, speed, start)
        assert example.largest(example.deflection(beside.motion, talk.ELEMENTS)) < top[1]
        assert np.abs(beside.multipliers()).max() < 1
