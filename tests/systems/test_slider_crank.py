"""The flexible slider-crank gives the reference numbers."""

from typing import Any

import numpy as np
import pytest

import flexel as fx
from flexel.examples import slider_crank as example
from flexel.examples import slider_crank_branch as branches
from flexel.examples import slider_crank_data as data
from flexel.examples.published import published
from flexel.linear import periodic


@pytest.fixture(scope="module")
def benchmark() -> dict[str, Any]:
    return published("slider_crank_flexible")


def test_the_pinned_rod_has_the_frequencies_of_the_talk_and_of_the_closed_form() -> None:
    exact = (np.pi / data.DATA["l"]) ** 2 * np.sqrt(data.DATA["EI"] / data.DATA["rhoA"])
    assert exact == pytest.approx(data.OMEGA0_EXACT, rel=1e-12)
    assert round(example.omega0(2)) in (832, 833)
    errors = [example.omega0(n) / exact - 1 for n in (2, 4, 8)]
    assert np.log2(errors[0] / errors[1]) == pytest.approx(4, abs=0.1)
    assert np.log2(errors[1] / errors[2]) == pytest.approx(4, abs=0.1)


@pytest.mark.parametrize("zeta", [0.01, 0.02])
def test_two_elements_without_second_order_terms_give_the_printed_extremes(zeta: float) -> None:
    found = periodic.refined(example.nonlinear(data.SPEED, 2, zeta, second_order=False))
    assert (found.max(), found.min()) == pytest.approx(data.TWO_ELEMENTS_EXTREMES[zeta], rel=6e-4)


def test_second_order_terms_make_two_elements_as_good_as_four_without() -> None:
    converged = example.nonlinear(data.SPEED, 8)
    off = {
        (n, order): abs(
            example.largest(example.nonlinear(data.SPEED, n, second_order=order)) / example.largest(converged)
            - 1
        )
        for n, order in ((2, False), (2, True), (4, True))
    }
    assert off[2, False] > 0.02 > 0.002 > off[2, True]
    assert off[4, True] < 3e-4


def test_harmonics_are_those_of_the_reference_rod() -> None:
    found = example.amplitudes(example.nonlinear(data.SPEED, 4))
    assert np.max(np.abs(found - data.HARMONICS)) < 1e-3 * max(data.HARMONICS)


def test_planar_and_spatial_model_agree() -> None:
    """Transient and linearized periodic motion, the same numbers to rounding of the integrator."""
    planar, spatial = (example.slider_crank(data.SPEED, spatial=space) for space in (False, True))
    runs = [
        system.simulate(0.01, samples=21, method="Radau", rtol=1e-9, atol=1e-12)
        for system in (planar, spatial)
    ]
    a, b = (example.deflection(motion, 2) for motion in runs)
    assert np.max(np.abs(a - b)) < 1e-7
    a, b = (example.linearized(data.SPEED, spatial=space) for space in (False, True))
    assert np.max(np.abs(a - b)) < 1e-12


def test_the_transient_follows_the_reference(benchmark: dict[str, Any]) -> None:
    reference = benchmark["transient"]["0.02"]
    count = 17  # up to 0.04 s
    system = example.slider_crank(data.SPEED, example.CONVERGED, 0.02)
    times = reference["t"][:count]
    motion = system.simulate(times[-1], times=times, method="Radau", rtol=1e-6, atol=1e-9)
    expected = np.array(reference["midpoint_defl_over_l"][:count])
    assert np.max(np.abs(example.deflection(motion, example.CONVERGED) - expected)) < 3e-5


def test_a_linearized_sweep_peaks_near_thirds_and_quarters_of_the_first_frequency() -> None:
    found = example.linear_sweep(0.02)
    assert found.speeds.size == 200
    inner = found.largest[1:-1]
    tops = found.speeds[1:-1][(inner > found.largest[:-2]) & (inner > found.largest[2:]) & (inner > 0.03)]
    assert tops == pytest.approx([205, 269], abs=2)
    slow = found.harmonics[0] / found.quasi_static[0]
    assert slow[1:3] == pytest.approx([1, 1], abs=0.02)


def test_a_nonlinear_sweep_agrees_with_the_reference() -> None:
    speeds = (150.0, 180.0, 190.0, 200.0, 205.0, 208.0)
    found = example.nonlinear_sweep(0.02, 4, speeds)
    expected = [row[2] for row in data.SWEEP if row[0] in speeds]
    assert found.largest == pytest.approx(expected, rel=3e-3)


def test_one_value_of_many_elements_is_near_that_of_the_table() -> None:
    steady = next(row for row in data.SWEEP if row[0] == data.SPEED)
    assert example.largest(example.nonlinear(data.SPEED, 8, 0.01)) == pytest.approx(steady[1], rel=1.5e-3)


def test_even_harmonics_are_excited_by_varying_stiffness_alone_and_the_fifth_cancels() -> None:
    n, direct, stiffness, both, predicted, found = branches.excitation(example.CONVERGED, True).T
    even = n % 2 == 0
    assert np.max(np.abs(direct[even])) < 1e-12
    assert np.hypot(direct + stiffness, 0)[even] == pytest.approx(both[even], rel=1e-2)
    fifth = n == 5
    assert both[fifth] < 0.06 * np.abs(direct[fifth])
    assert np.all(np.abs(np.log(predicted / found)) < np.log(1.8))
    coarse = branches.excitation(2, False)
    assert coarse[fifth, 3] > 6 * both[fifth]
    assert coarse[fifth, 5] > coarse[n == 6, 5]  # the talk's model shows the fifth, not the sixth
    assert found[fifth] < found[n == 6] / 3


@pytest.fixture(scope="module")
def folded() -> fx.PeriodicBranch:
    """Two elements, 1 % damping, through both folds."""
    return branches.followed(0.01, (245.0, 275.0), step=0.2, elements=2)


@pytest.mark.long
def test_the_folds_do_not_depend_on_the_step_and_have_a_multiplier_one(folded: fx.PeriodicBranch) -> None:
    first, last = folded.folds
    assert folded.omega[[first, last]] == pytest.approx([263.2, 250.5], abs=0.1)
    assert folded.modulus[[first, last]] == pytest.approx(1, abs=5e-4)
    assert np.all(folded.modulus[first + 1 : last] > 1)
    assert [stable for _, stable in folded.stretches] == [True, False, True]
    fine = branches.followed(0.01, (258.0, 266.0), step=0.1, elements=2)
    assert fine.omega[fine.folds[0]] == pytest.approx(folded.omega[first], rel=1e-8)
    assert fine[-1].omega == pytest.approx(258.0, rel=1e-12)  # back on the unstable branch
    assert fine.modulus[-1] > 1.2


@pytest.mark.long
def test_disturbances_of_both_stable_motions_decay(folded: fx.PeriodicBranch) -> None:
    """The deflection after twenty simulated turns, from a start with 2 % of all deformations added."""
    first, last = folded.folds
    for k in (first - 3, last + 4):
        solution = folded[k]
        assert folded.stable[k]
        system, start = solution.motion.system, solution.motion[0]
        disturbed = system.state_at({name: 1.02 * start[name] for name in system.dynamic}, start=start)
        run = system.simulate(
            20 * solution.period, start=disturbed, samples=21, method="DOP853", rtol=1e-7, atol=1e-10
        )
        found, expected = example.deflection(run, 2), example.deflection(solution.motion, 2)
        off = np.abs(found - expected[0]) / example.largest(expected)
        assert off[-1] < max(0.05 * off.max(), 5e-4)


def test_a_narrow_maximum_of_the_multiplier_is_found_between_motions_far_apart() -> None:
    """A pair of multipliers meets on the negative real axis between 316 and 321 rad/s only."""
    found = branches.followed(0.02, (312.5, 340.0), step=0.5, elements=2)
    (peak,) = found.peaks
    assert np.max(np.delete(found.modulus, peak)[:-1]) < 0.725  # of the others, but for the end
    assert branches.peaks(found)[0] == pytest.approx((318.4, 0.734), rel=3e-3)
    assert found.multipliers[peak, 0].imag == 0
    assert found.multipliers[peak, 0].real < 0
