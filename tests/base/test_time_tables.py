"""Tables of values over time: cubic, linear and steps."""

import numpy as np
import pytest

import flexel as fx

TIMES, VALUES = [0.0, 1.0, 2.0, 3.0], [0.0, 2.0, 1.0, 1.0]


def pushed(load: fx.Table) -> fx.System:
    """A mass of 2 kg on a line, pushed by a load."""
    m = fx.Model()
    m.point("A", (0, 0))
    m.fix("A.y")
    m.point_mass("mass", "A", 2.0)
    m.load("A.x", load)
    return m.build()


def test_a_linear_table_is_the_interpolation_of_numpy_and_names_its_kinks() -> None:
    table = fx.Table(TIMES, VALUES, kind="linear")
    for t in np.linspace(0, 3, 31):
        assert table.rates(t)[0] == pytest.approx(np.interp(t, TIMES, VALUES), abs=1e-15)
    assert [table.rates(t)[1] for t in (0.5, 1.0, 2.5)] == [2.0, -1.0, 0.0]
    assert table.knots.tolist() == [1.0, 2.0]


def test_a_table_of_steps_holds_each_value_until_the_next_time() -> None:
    table = fx.Table([0.0, 1.0, 2.0, 3.0], [5.0, 5.0, 7.0, 9.0], kind="step")
    assert [table.rates(t) for t in (0.0, 1.5, 2.0, 2.9)] == [
        (rate, 0.0, 0.0) for rate in (5.0, 5.0, 7.0, 7.0)
    ]
    assert table.rates(3.0)[0] == 9.0
    assert table.knots.tolist() == [2.0, 3.0]


def test_points_on_a_line_are_no_kinks() -> None:
    times = np.linspace(0, 1, 11)
    assert fx.Table(times, 3 * times + 0.1, kind="linear").knots.size == 0


@pytest.mark.parametrize("kind", ["linear", "step"])
def test_a_mass_follows_a_load_that_is_not_smooth(kind: str) -> None:
    """Its speed is the integral of the load over its mass: areas of trapezia and of rectangles."""
    speed = pushed(fx.Table(TIMES, VALUES, kind=kind)).simulate(3, rtol=1e-9, atol=1e-11)["A.x'"][-1]
    areas = {"linear": 1.0 + 1.5 + 1.0, "step": 0.0 + 2.0 + 1.0}
    assert speed == pytest.approx(areas[kind] / 2.0, abs=1e-7)
