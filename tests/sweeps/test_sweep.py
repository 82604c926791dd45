"""A sweep as its user calls it: labels, results of all kinds, points that fail, bad input."""

from concurrent.futures import Executor, ProcessPoolExecutor, ThreadPoolExecutor
from multiprocessing import get_context
from typing import Any

import numpy as np
import pytest
from swept import numbers, pendulum, picky, plain, swing

import flexel as fx

xarray = pytest.importorskip("xarray", reason="sweeps need pip install 'flexel[sweep]'")
pytest.importorskip("joblib", reason="sweeps need pip install 'flexel[sweep]'")
AXES = {"length": [0.3, 0.5, 0.8], "mass": [1.0, 2.0]}


@pytest.fixture(scope="module")
def serial() -> Any:
    """The pendulum over length and mass, in this process."""
    return fx.sweep(pendulum, AXES, swing, executor="serial")


def test_a_grid_is_labelled_and_its_numbers_are_right(serial: Any) -> None:
    """A rod about its end: omega² = 3g/2L, whatever its mass; it swings with about that."""
    assert serial.omega.dims == ("length", "mass") and serial.angle.dims == ("length", "mass", "angle_0")
    for length in AXES["length"]:
        found = serial.omega.sel(length=length)
        assert found.values == pytest.approx(np.sqrt(1.5 * 9.81 / length), rel=1e-4)
    assert serial.angle.sel(length=0.5, mass=2.0)[0] == pytest.approx(0.3)
    assert serial.eigenvalues.dtype == complex
    assert (serial.failed == "").all() and serial.attrs["message"] == "6 of 6 points computed"


@pytest.mark.long
def test_digits_do_not_depend_on_executor_or_chunks(serial: Any) -> None:
    executors: list[tuple[Any, int | None]] = [(None, None), (None, 1), ("joblib", 4), ("serial", 5)]
    for executor, chunk in executors:
        found = fx.sweep(pendulum, AXES, swing, executor=executor, workers=2, chunk=chunk)
        xarray.testing.assert_identical(found, serial)
    with ThreadPoolExecutor(2) as threads, ProcessPoolExecutor(2, get_context("spawn")) as processes:
        for given in (threads, processes):
            xarray.testing.assert_identical(fx.sweep(pendulum, AXES, swing, executor=given, chunk=2), serial)
            assert given.submit(int, "3").result() == 3  # it is the user's, and still works


def test_an_executor_may_be_made_by_a_function() -> None:
    made: list[Executor] = []

    def make() -> Executor:
        made.append(ThreadPoolExecutor(2))
        return made[-1]

    assert float(fx.sweep(plain, {"a": [1, 2]}, numbers, executor=make)["sum"][1]) == 3
    assert len(made) == 1
    with pytest.raises(RuntimeError, match="shutdown"):
        made[0].submit(int)


def test_functions_of_a_notebook_are_sent_along() -> None:
    """Closures and lambdas, which have no module to be found in."""
    offset = 10.0
    found = fx.sweep(
        lambda a: {"a": a + offset}, {"a": [1.0, 2.0]}, lambda point: {"y": point["a"]}, workers=2
    )
    assert found.y.values.tolist() == [11.0, 12.0]


def test_points_one_by_one_have_one_dimension() -> None:
    found = fx.sweep(plain, [{"a": 1.0, "b": 2.0}, {"a": 3.0, "b": 5.0}], numbers, executor="serial")
    assert found["sum"].dims == ("point",) and found["sum"].values.tolist() == [3.0, 8.0]
    assert found.a.values.tolist() == [1.0, 3.0] and found.powers.shape == (2, 3)


def test_texts_are_parameters_too() -> None:
    radii = {"small": 0.1, "large": 0.2}
    found = fx.sweep(lambda wheel: radii[wheel], {"wheel": ["small", "large"]}, lambda r: {"r": r}, workers=2)
    assert float(found.r.sel(wheel="large")) == 0.2


def test_labelled_arrays_keep_dimensions_labels_and_units() -> None:
    def analyse(point: dict[str, float]) -> dict[str, Any]:
        modes = xarray.DataArray(
            [point["a"], point["b"]], {"mode": ["weave", "wobble"]}, "mode", attrs={"units": "rad/s"}
        )
        return {"omega": modes, "damping": 0.1 * modes}

    found = fx.sweep(plain, {"a": [1.0, 2.0]}, analyse, executor="serial")
    assert found.omega.dims == ("a", "mode") and found.omega.attrs == {"units": "rad/s"}
    assert float(found.damping.sel(a=2.0, mode="wobble")) == pytest.approx(0.1)


def test_results_may_become_complex_later() -> None:
    """As eigenvalues, which NumPy returns as real numbers where all are."""
    found = fx.sweep(
        plain,
        {"a": [1.0, 4.0, -4.0]},
        lambda point: {"root": np.emath.sqrt(point["a"])},
        executor="serial",
        chunk=1,
    )
    assert found.root.values.tolist() == [1, 2, 2j]


def test_a_point_that_fails_keeps_its_message_and_the_others_their_results() -> None:
    with pytest.warns(
        fx.IncompleteWarning, match=r"3 of 5.* 2 failed; the first, a = -2.0: ValueError: no -2.0"
    ):
        found = fx.sweep(picky, {"a": [1.0, -2.0, 3.0, -4.0, 5.0]}, numbers, workers=2)
    assert found["sum"].values.tolist() == pytest.approx([2, np.nan, 4, np.nan, 6], nan_ok=True)
    assert str(found.failed.sel(a=-4.0).item()).startswith("ValueError: no -4.0 (swept.py, line ")
    assert [bool(failure) for failure in found.failed.values] == [False, True, False, True, False]


def test_errors_of_flexel_are_kept_as_they_are() -> None:
    with pytest.warns(fx.IncompleteWarning):
        found = fx.sweep(pendulum, {"mass": [2.0, -1.0]}, swing, executor="serial")
    assert found.failed.values[0] == "" and found.failed.values[1].startswith("body 'body': ")


@pytest.mark.parametrize("chunk", [1, 2, 6])
def test_the_form_is_that_of_the_first_point_that_succeeds(chunk: int) -> None:
    """Whatever the chunks are: the points of another form fail, and say why."""

    def analyse(point: dict[str, float]) -> dict[str, Any]:
        return {"x": np.ones(3 if point["a"] in (-1.0, 1.0, 3.0) else 2)}

    with pytest.warns(fx.IncompleteWarning):
        found = fx.sweep(picky, {"a": [-1.0, 1.0, 2.0, 3.0, 4.0, 5.0]}, analyse, workers=2, chunk=chunk)
    assert found.x.shape == (6, 3)
    expected = "analyse returned an array (x_0: 2) as 'x' here, and an array (x_0: 3) at other points; return the same"
    assert [failure == expected for failure in found.failed.values] == [False, False, True, False, True, True]


@pytest.mark.parametrize(
    ("returned", "message"),
    [
        (3.0, "analyse returned 3.0; return a dict"),
        ({}, "return a dict"),
        ({"stable": "yes"}, "'yes' as 'stable'; return numbers"),
        ({"x": [[1.0], [1.0, 2.0]]}, "as 'x'; return numbers"),
        ({"a": 1.0}, "'a', a name in use"),
        ({"failed": 1.0}, "'failed', a name in use"),
    ],
)
def test_where_all_points_fail_the_sweep_does(returned: Any, message: str) -> None:
    with pytest.raises(
        fx.ModelError, match=rf"0 of 2 points computed, 2 failed; the first, a = 1: .*{message}"
    ):
        fx.sweep(plain, {"a": [1, 2]}, lambda _: returned, executor="serial")


def test_a_dimension_may_not_be_a_parameter() -> None:
    with pytest.raises(fx.ModelError, match="'x' with the dimension 'a', a name in use"):
        fx.sweep(plain, {"a": [1, 2]}, lambda _: {"x": xarray.DataArray([1.0], dims="a")}, executor="serial")


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"points": {"lenght": [1.0]}}, "unknown parameter 'lenght'; did you mean length"),
        ({"build": lambda length, width: None}, "build needs 'width'"),
        ({"build": fx.Model()}, "build is .*; give a function"),
        ({"analyse": None}, "analyse is None; give a function"),
        ({"points": 3}, "3 is not a set of points"),
        ({"executor": "cluster"}, "executor is 'cluster'; give 'joblib', 'serial'"),
        ({"workers": 0}, "workers 0; give a whole number, 1 or more"),
        ({"chunk": 0}, "chunk 0; give a whole number, 1 or more"),
    ],
)
def test_bad_input_is_named(options: dict[str, Any], message: str) -> None:
    given = {"build": pendulum, "points": {"length": [1.0]}, "analyse": swing} | options
    with pytest.raises(fx.ModelError, match=message):
        fx.sweep(**given)


def test_an_executor_that_is_closed_is_named() -> None:
    with ThreadPoolExecutor(1) as threads:
        pass
    with pytest.raises(fx.FlexelError, match="the executor accepts no work: .*give an open one"):
        fx.sweep(plain, {"a": [1.0]}, numbers, executor=threads)


def test_what_cannot_be_sent_is_named() -> None:
    import threading

    lock = threading.Lock()
    with pytest.raises(fx.ModelError, match="cannot be sent to other processes: .*executor='serial'"):
        fx.sweep(lambda a: {"a": a, "l": lock}, {"a": [1.0]}, lambda point: {"y": point["a"]})
    assert fx.sweep(lambda a: lock, {"a": [1.0]}, lambda point: {"y": 1}, executor="serial").y == 1
