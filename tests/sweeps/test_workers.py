"""Workers that die, executors that break down, and a cluster of two workers."""

import os
import warnings
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context
from pathlib import Path
from typing import Any

import pytest
from swept import deadly, lethal, numbers, pendulum, plain, swing

import flexel as fx

xarray = pytest.importorskip("xarray", reason="sweeps need pip install 'flexel[sweep]'")
pytest.importorskip("joblib", reason="sweeps need pip install 'flexel[sweep]'")
DIED = "its worker died each time, even when it ran alone; it may need more memory"


def check(found: Any) -> None:
    """Of the points 0, 1, … 9 the fourth has killed its worker, and only that one is lost."""
    failed = {float(a): text for a, text in zip(found.a.values, found.failed.values, strict=True) if text}
    assert failed == {3.0: DIED}
    assert [found["sum"].sel(a=a) for a in range(10) if a != 3] == [a + 1 for a in range(10) if a != 3]


@pytest.mark.slow
def test_a_point_that_kills_its_worker_is_named_and_the_rest_kept() -> None:
    with pytest.warns(
        fx.IncompleteWarning, match="9 of 10 points computed, 1 failed; the first, a = 3.0: its worker"
    ):
        check(fx.sweep(deadly, {"a": [float(i) for i in range(10)]}, numbers, workers=2, chunk=4))


@pytest.mark.slow
@pytest.mark.long
def test_if_all_workers_die_the_sweep_says_so() -> None:
    with pytest.raises(fx.FlexelError, match=r"all workers die, the last at a = .*executor='serial'"):
        fx.sweep(lethal, {"a": [1.0, 2.0, 3.0, 4.0]}, numbers, workers=2)


@pytest.mark.slow
@pytest.mark.long
def test_an_executor_of_the_user_that_breaks_down_is_not_replaced(tmp_path: Path) -> None:
    """But one that a function makes is; and what was computed is in the folder."""
    points = {"a": [0.0, 1.0, 2.0, 4.0, 3.0, 5.0, 6.0, 7.0, 8.0, 9.0]}

    def make() -> ProcessPoolExecutor:
        return ProcessPoolExecutor(1, get_context("spawn"))

    with (
        make() as processes,
        pytest.raises(fx.FlexelError, match="the executor broke down .*give another one"),
    ):
        fx.sweep(deadly, points, numbers, executor=processes, chunk=1, folder=tmp_path)
    assert fx.open_sweep(tmp_path)["sum"].values[:2].tolist() == [1.0, 2.0]
    with pytest.warns(fx.IncompleteWarning, match="a = 3.0"):
        check(fx.sweep(deadly, points, numbers, executor=make, folder=tmp_path))


@pytest.fixture(scope="module")
def client() -> Iterator[Any]:
    """A client of a cluster of two workers on this machine, which gives a task up when one worker has died of it."""
    distributed = pytest.importorskip("distributed", reason="clusters need pip install 'flexel[cluster]'")
    import dask

    with warnings.catch_warnings(), dask.config.set({"distributed.scheduler.allowed-failures": 0}):
        warnings.simplefilter("default")  # the cluster's own are not what is tested
        with (
            distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster,
            distributed.Client(cluster) as client,
        ):
            yield client


@pytest.mark.filterwarnings("default")
@pytest.mark.long
def test_a_cluster_gives_the_digits_of_one_process(client: Any) -> None:
    axes = {"length": [0.3, 0.5, 0.8], "mass": [1.0, 2.0]}
    found = fx.sweep(pendulum, axes, swing, executor=client)
    xarray.testing.assert_identical(found, fx.sweep(pendulum, axes, swing, executor="serial"))


@pytest.mark.filterwarnings("default")
def test_both_workers_of_a_cluster_work(client: Any) -> None:
    """Each point says where it was computed."""

    def analyse(point: dict[str, float]) -> dict[str, int]:
        import os
        import time

        time.sleep(0.02)
        return {"process": os.getpid()}

    found = fx.sweep(plain, {"a": range(40)}, analyse, executor=client)
    assert len(set(found.process.values.tolist())) == 2


@pytest.mark.filterwarnings("default")
def test_a_worker_of_a_cluster_that_dies_takes_one_point_with_it(client: Any) -> None:
    with pytest.warns(fx.IncompleteWarning, match="1 failed"):
        check(fx.sweep(deadly, {"a": [float(i) for i in range(10)]}, numbers, executor=client, chunk=5))


@pytest.mark.filterwarnings("default")
def test_the_command_uses_the_cluster_at_an_address(client: Any, tmp_path: Path) -> None:
    from click.testing import CliRunner

    from flexel.apps.cli.main import main

    file, out = tmp_path / "where.py", tmp_path / "results"
    file.write_text(
        "import os, time\n"
        "points = [{'a': i} for i in range(30)]\n"
        "def build(a):\n    return a\n"
        "def analyse(a):\n    time.sleep(0.02)\n    return {'twice': 2 * a, 'process': os.getpid()}\n",
        encoding="utf-8",
    )
    command = ["sweep", str(file), "--scheduler", client.scheduler.address, "--out", str(out)]
    result = CliRunner().invoke(main, command)
    assert result.exit_code == 0, result.output
    found = fx.open_sweep(out)
    assert found.twice.values.tolist() == [2.0 * i for i in range(30)]
    workers = set(client.run(os.getpid).values())
    assert set(found.process.values.tolist()) <= workers and os.getpid() not in workers
