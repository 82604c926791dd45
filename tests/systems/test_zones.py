"""Zones of instability are traced to their edges, with their peaks; the bicycle's map has ranges without steps."""

import numpy as np
import pytest

from flexel.examples import cardan as example
from flexel.examples import stability_map, whipple
from flexel.examples.bicycle_data import CAPSIZE_SPEED, WEAVE_SPEED
from flexel.examples.cardan_zones import Zone, trace
from flexel.linear.periodic import Coefficients

ANGLES = [15.0, 25.0, 35.0, 45.0]


@pytest.fixture(scope="module")
def zone() -> Zone:
    """The first zone of Mathieu's equation with the modulation of the universal joint."""
    return trace(lambda b: lambda w: example.mathieu(example.modulation(b), w), ANGLES, 1, 0.12)


def test_its_edges_are_those_of_mathieu_functions(zone: Zone) -> None:
    exact = [example.mathieu_edges(example.modulation(np.radians(angle))) for angle in ANGLES]
    assert zone.angles.tolist() == [0.0, *ANGLES]
    assert np.column_stack([zone.low, zone.high])[1:] == pytest.approx(np.array(exact), abs=3e-6)


def test_its_peaks_are_refined(zone: Zone) -> None:
    """Nowhere within the zone is the growth larger than at the peak, which is that of the multipliers themselves."""
    for i, degrees in enumerate(ANGLES, 1):
        equations = example.modulation(np.radians(degrees))
        at_peak = example.growth(example.mathieu(equations, zone.peak[i]))
        assert zone.largest[i] == pytest.approx(at_peak, rel=1e-4)
        for speed in zone.peak[i] + 0.05 * (zone.high[i] - zone.low[i]) * np.array([-1, 1]):
            assert example.growth(example.mathieu(equations, float(speed))) < at_peak


def test_its_field_reaches_from_edge_to_edge_and_is_the_growth_between(zone: Zone) -> None:
    angle, speed, growth = zone.field(31, 41)
    assert np.array_equal(growth[[0, -1]], np.zeros((2, 31))) and angle[0, 0] == 0
    low, high = zone.edges(angle[0])
    assert speed[0] == pytest.approx(low) and speed[-1] == pytest.approx(high)
    j = int(np.argmin(np.abs(angle[0] - 35)))
    for i in (10, 20, 30):
        exact = example.growth(
            example.mathieu(example.modulation(np.radians(angle[i, j])), float(speed[i, j]))
        )
        assert growth[i, j] == pytest.approx(exact, rel=5e-3)
    assert np.all((zone.ridge(angle[0]) >= low) & (zone.ridge(angle[0]) <= high))


def test_a_zone_that_becomes_too_narrow_ends_there() -> None:
    """The third zone of the elastic shaft by its closed form."""

    def at(b: float) -> example.Callable[[float], Coefficients]:
        return lambda w: example.closed_coefficients(b, w, 1.0, 0.0, 64)

    found = trace(at, [5.0, 30.0, 35.0, 40.0, 45.0], 3, 0.03)
    assert found.angles.tolist() == [29.0, 30.0, 35.0, 40.0, 45.0]
    assert found.high[0] == found.low[0] and found.largest[0] == 0
    assert np.all((found.low < found.peak)[1:] & (found.peak < found.high)[1:])


def test_ranges_of_the_map_are_the_published_speeds_between_the_given_ones() -> None:
    xarray = pytest.importorskip("xarray", reason="sweeps need pip install 'flexel[sweep]'")
    w, c = np.array([1.02, 1.1, 1.2]), np.array([0.05, 0.08])
    exact = [[whipple.matrices(stability_map.parameters(float(a), float(b))) for b in c] for a in w]
    axes = ("wheelbase", "trail", "i", "j")
    data = {
        name: (axes, np.array([[e[name] for e in row] for row in exact])) for name in stability_map.MATRICES
    }
    found = xarray.Dataset(data, {"wheelbase": w, "trail": c})
    low, high, most = stability_map.ranges(found)
    assert (low[0, 1], high[0, 1]) == pytest.approx((WEAVE_SPEED, CAPSIZE_SPEED), abs=2e-4)
    steady = stability_map.stable(found)
    assert np.array_equal(most > 0, steady.any(axis=-1)) and not steady[2].any()
    assert np.array_equal(low[2], high[2])
