"""What limits the digits and the steps of DOP853: positions are found to rounding, and laws see the positions found."""

import numpy as np

from flexel.examples import bicycle_data as data
from flexel.examples import vehicle_runs as runs
from flexel.examples.bicycle import bicycle, rolling
from flexel.examples.vehicle import vehicle


def test_the_energy_of_a_bicycle_has_no_jumps_at_tight_tolerances() -> None:
    """Manoeuvre M1: rounding only (6.7e-13 in one step with positions found to 1e-13 only)."""
    b = bicycle()
    start = rolling(b, data.M1_SPEED, data.ROLL_RATE)
    motion = b.simulate(5.0, start=start, samples=201, method="DOP853", rtol=1e-12, atol=1e-14)
    energy = motion.energy["total"]
    assert np.max(np.abs(np.diff(energy))) < 2e-13 * abs(energy[0])


def test_stiff_tyres_are_no_noise_to_the_step_control() -> None:
    """Five seconds of steering took 1149 steps when tyres saw deformations from before the last correction."""
    s = vehicle(30.0, rack=runs.rounded_ramp())
    motion = s.simulate(5.0, start=runs.start(s, 30.0), method="DOP853", rtol=1e-3, samples=2, rechoose=False)
    assert motion.statistics["steps"] < 200
