"""Points of sweeps: grids, lists, samples, and what is refused."""

from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest
from scipy import stats

import flexel as fx


def test_a_grid_has_all_combinations_and_the_last_parameter_changes_first() -> None:
    points = fx.grid({"speed": [4, 5.5], "tyre": ["soft", "hard"], "rider": (True, False)})
    assert len(points) == 8 and points.shape == (2, 2, 2)
    assert points.point(1) == {"speed": 4.0, "tyre": "soft", "rider": False}
    assert points.point(6) == {"speed": 5.5, "tyre": "hard", "rider": True}
    assert points.columns(3, 5) == {
        "speed": [4.0, 5.5],
        "tyre": ["hard", "soft"],
        "rider": [False, True],
    }
    assert [type(value) for value in points.point(0).values()] == [float, str, bool]


def test_a_grid_of_many_points_keeps_only_its_axes() -> None:
    points = fx.grid({"a": np.arange(1000), "b": np.linspace(0, 1, 1000), "c": range(1000)})
    assert len(points) == 10**9
    assert points.point(10**9 - 1) == {"a": 999, "b": 1.0, "c": 999}


def test_lists_give_points_one_by_one() -> None:
    points = fx.listed({"length": [0.1, 0.2], "load": [5, 2.5]})
    assert [points.point(i) for i in range(2)] == [{"length": 0.1, "load": 5.0}, {"length": 0.2, "load": 2.5}]
    assert points.dims == ("point",)


def test_a_generator_gives_points_one_by_one() -> None:
    def generated() -> Iterator[dict[str, Any]]:
        for i in range(25_000):
            yield {"b": "even" if i % 2 == 0 else "uneven", "a": i if i < 20_000 else i + 0.5}

    points = fx.listed(generated())
    assert len(points) == 25_000
    assert points.point(24_999) == {"b": "uneven", "a": 24_999.5}


def test_a_latin_hypercube_has_one_point_in_each_interval() -> None:
    spread = stats.norm(0.3e-3, 5e-6)
    points = fx.sample({"thickness": spread, "length": (0.099, 0.101)}, 50, seed=7)
    columns = points.columns(0, 50)
    assert sorted(np.floor(50 * spread.cdf(columns["thickness"])).astype(int)) == list(range(50))
    assert sorted(np.floor((np.array(columns["length"]) - 0.099) / 0.002 * 50).astype(int)) == list(range(50))
    assert points.columns(0, 50) == fx.sample(
        {"thickness": spread, "length": (0.099, 0.101)}, 50, seed=7
    ).columns(0, 50)
    assert points.point(0) != fx.sample({"thickness": spread, "length": (0.099, 0.101)}, 50).point(0)


def test_random_points_are_independent_of_one_another() -> None:
    column = fx.sample({"a": (0, 1)}, 50, method="random").columns(0, 50)["a"]
    intervals = np.floor(50 * np.array(column)).astype(int)
    assert 0 < len(set(intervals)) < 50
    assert all(0 <= value <= 1 for value in column)


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: fx.grid({}), "names no parameter"),
        (lambda: fx.grid({"a": 3.0}), "'a' is 3.0; give a list"),
        (lambda: fx.grid({"a": "soft"}), "'a' is 'soft'; give a list"),
        (lambda: fx.grid({"a": []}), "'a' has no values"),
        (lambda: fx.grid({"a": [1.0, "x"]}), "'a' are not all numbers"),
        (lambda: fx.grid({"a": [1.0, None]}), "'a' are not all numbers"),
        (lambda: fx.grid({"a": [[1.0, 2.0]]}), "'a' are not all numbers"),
        (lambda: fx.grid({"a": np.eye(2)}), "'a' are not all numbers"),
        (lambda: fx.grid({"a": [1.0, float("nan")]}), "not finite"),
        (lambda: fx.grid({"failed": [1.0]}), "'failed' cannot be a parameter"),
        (lambda: fx.listed({"a": [1, 2], "b": [1, 2, 3]}), "differ in length: 'a' 2, 'b' 3.*fx.grid"),
        (lambda: fx.listed([{"a": 1}, {"b": 2}]), "point 1 differs from point 0 in 'a', 'b'"),
        (lambda: fx.listed([{"a": 1}, 3]), "point 1 is 3"),  # type: ignore[list-item]
        (lambda: fx.listed([]), "there are none"),
        (lambda: fx.sample({"a": (1, 0)}, 5), "limits of 'a', 1 and 0, do not increase"),
        (lambda: fx.sample({"a": 1.0}, 5), "'a' is 1.0; give \\(low, high\\) or a distribution"),
        (lambda: fx.sample({"a": (0, 1)}, 0), "number of points 0; give a whole number, 1 or more"),
        (lambda: fx.sample({"a": (0, 1)}, 3, method="sobol"), "method 'sobol' is unknown"),  # type: ignore[arg-type]
    ],
)
def test_bad_points_are_refused_by_name(make: Any, message: str) -> None:
    with pytest.raises(fx.ModelError, match=message):
        make()
