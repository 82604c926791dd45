"""The folder of a sweep: what is continued, what is refused, and how little memory it takes."""

import errno
import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from swept import numbers, picky, plain, slow

import flexel as fx
from flexel.apps.sweeps.columns import ColumnFile

xarray = pytest.importorskip("xarray", reason="sweeps need pip install 'flexel[sweep]'")
pytest.importorskip("joblib", reason="sweeps need pip install 'flexel[sweep]'")
TESTS = Path(__file__).resolve().parents[1]


def never(given: Any) -> dict[str, float]:
    """For a sweep in which nothing is left to do."""
    raise AssertionError("computed again")


def process(code: str, *arguments: str) -> subprocess.Popen[str]:
    """A Python that runs the code, with the test's functions."""
    known = os.environ | {"PYTHONPATH": str(TESTS)}
    return subprocess.Popen(
        [sys.executable, "-c", code, *arguments], env=known, stdout=subprocess.PIPE, text=True
    )


def test_a_finished_sweep_is_read_and_not_computed(tmp_path: Path) -> None:
    first = fx.sweep(plain, {"a": [1.0, 2.0], "b": [3.0, 4.0]}, numbers, executor="serial", folder=tmp_path)
    again = fx.sweep(plain, {"a": [1.0, 2.0], "b": [3.0, 4.0]}, never, executor="serial", folder=tmp_path)
    xarray.testing.assert_identical(first, again)
    xarray.testing.assert_identical(fx.open_sweep(tmp_path), again)


@pytest.mark.parametrize(
    ("points", "message"),
    [
        ({"a": [1.0, 2.0, 3.0], "b": [3.0, 4.0]}, "'a' has 2 values in it, not 3"),
        ({"a": [1.0, 2.0], "b": [3.0, 4.5]}, "'b' has other values in it"),
        ({"a": [1.0, 2.0]}, "its parameters are a, b, not a"),
        ([{"a": 1.0, "b": 3.0}], "its points are a grid, not a list"),
    ],
)
def test_other_points_are_refused_by_name(tmp_path: Path, points: Any, message: str) -> None:
    fx.sweep(plain, {"a": [1.0, 2.0], "b": [3.0, 4.0]}, numbers, executor="serial", folder=tmp_path)
    with pytest.raises(fx.ModelError, match=f"holds another sweep: {message}; give another folder"):
        fx.sweep(plain, points, numbers, executor="serial", folder=tmp_path)


def test_a_folder_with_other_things_is_refused(tmp_path: Path) -> None:
    (tmp_path / "thesis.tex").write_text("", encoding="utf-8")
    with pytest.raises(fx.ModelError, match="holds other files; give an empty or a new one"):
        fx.sweep(plain, {"a": [1.0]}, numbers, executor="serial", folder=tmp_path)
    with pytest.raises(fx.ModelError, match="is not the folder of a sweep"):
        fx.open_sweep(tmp_path)
    (tmp_path / "sweep.json").write_text("[]", encoding="utf-8")
    with pytest.raises(fx.ModelError, match=r"sweep.json cannot be read"):
        fx.open_sweep(tmp_path)


def test_failed_points_are_computed_again_when_asked(tmp_path: Path) -> None:
    points = {"a": [1.0, -2.0, 3.0]}
    for _ in range(2):  # the second time nothing is computed, and the warning stays
        with pytest.warns(fx.IncompleteWarning, match="1 failed"):
            fx.sweep(picky, points, numbers, executor="serial", folder=tmp_path)
    found = fx.sweep(plain, points, numbers, executor="serial", folder=tmp_path, retry_failed=True)
    assert found["sum"].values.tolist() == [2.0, -1.0, 4.0] and (found.failed == "").all()


def test_two_sweeps_do_not_write_to_one_folder(tmp_path: Path) -> None:
    def analyse(point: dict[str, float]) -> dict[str, float]:
        with pytest.raises(fx.ModelError, match="another process is writing to"):
            fx.sweep(plain, {"a": [1.0]}, numbers, executor="serial", folder=tmp_path)
        return {"x": 1.0}

    assert fx.sweep(plain, {"a": [1.0]}, analyse, executor="serial", folder=tmp_path).x == 1


PATIENCE_S = 300.0  # for what takes about a second on an idle machine
SWEEP = """
import sys, flexel as fx
from swept import plain, slow
if __name__ == "__main__":
    executor = sys.argv[2] if len(sys.argv) > 2 else None
    found = fx.sweep(plain, {"a": range(2000)}, slow, workers=2, executor=executor, folder=sys.argv[1])
    print(found.attrs["message"], int((found["failed"] == "").sum()))
"""


def computed(folder: Path) -> int:
    """Points that are on disk."""
    try:
        return int(np.count_nonzero(np.load(folder / "status.npy")))
    except (
        FileNotFoundError,
        EOFError,
        ValueError,
    ):  # not there, empty, or without all rows: it is being made
        return 0


def wait_for(folder: Path, count: int) -> None:
    """Wait until some points are on disk."""
    end = time.monotonic() + PATIENCE_S
    while computed(folder) < count:
        assert time.monotonic() < end
        time.sleep(0.02)


@pytest.mark.parametrize("executor", ["joblib", "serial"])
def test_after_a_kill_the_rest_is_computed(tmp_path: Path, executor: str) -> None:
    """Points on disk are not computed again; the digits are those of a sweep that nobody killed."""
    running = process(SWEEP, str(tmp_path), executor)
    wait_for(tmp_path, 20)
    running.kill()
    running.wait()  # its workers have its stdout too, and end when they have been idle for a while
    assert running.stdout is not None
    running.stdout.close()
    kept = computed(tmp_path)
    assert 20 <= kept < 2000
    partial = fx.open_sweep(tmp_path)
    assert partial.attrs["message"] == f"{kept} of 2000 points computed"
    assert (partial.failed == "not computed").sum() == 2000 - kept
    assert np.isfinite(partial["sum"].values[partial.failed.values == ""]).all()
    counted = fx.sweep(
        plain,
        {"a": range(2000)},
        lambda point: numbers(point) | {"sum": -point["a"]},
        folder=tmp_path,
        executor="serial",
    )
    assert int((counted["sum"] > 0).sum()) == kept
    whole = fx.sweep(plain, {"a": range(2000)}, numbers, executor="serial")
    assert (counted.powers == whole.powers).all()


@pytest.mark.parametrize("executor", ["joblib", "serial"])
def test_ctrl_c_keeps_what_is_done(tmp_path: Path, executor: str) -> None:
    running = process(SWEEP, str(tmp_path), executor)
    wait_for(tmp_path, 20)
    running.send_signal(signal.SIGINT)
    assert running.wait(timeout=PATIENCE_S) == 0
    assert running.stdout is not None
    printed = running.stdout.readline()  # not up to the end: a worker that still starts has this file too
    running.stdout.close()
    kept = computed(tmp_path)
    assert printed.strip() == f"interrupted: {kept} of 2000 points computed {kept}"
    assert 20 <= kept < 2000


def test_an_interrupted_simulation_is_not_a_result(tmp_path: Path) -> None:
    """`System.simulate` answers Ctrl-C with the motion up to there: a sweep does not take it for the whole."""

    def analyse(system: fx.System) -> dict[str, float]:
        os.kill(os.getpid(), signal.SIGINT)
        return {"end": float(system.simulate(1.0).t[-1])}

    from swept import pendulum

    found = fx.sweep(pendulum, {"length": [0.5, 0.6]}, analyse, executor="serial", folder=tmp_path)
    assert found.attrs["message"] == "interrupted: 0 of 2 points computed" and "end" not in found


def test_a_message_that_was_cut_off_is_removed(tmp_path: Path) -> None:
    with pytest.warns(fx.IncompleteWarning):
        fx.sweep(picky, {"a": [1.0, -2.0, 3.0]}, numbers, executor="serial", folder=tmp_path)
    with open(tmp_path / "failed.jsonl", "a", encoding="utf-8") as stream:
        stream.write('[2, "no')
    assert fx.open_sweep(tmp_path).failed.values[2] == ""
    with pytest.warns(fx.IncompleteWarning):
        fx.sweep(picky, {"a": [1.0, -2.0, 3.0]}, never, executor="serial", folder=tmp_path)
    lines = (tmp_path / "failed.jsonl").read_text(encoding="utf-8").splitlines()
    assert [json.loads(line)[0] for line in lines] == [1]


MEMORY = """
import resource, sys, numpy as np, flexel as fx
from swept import plain
def analyse(point): return {"x": np.full(400, point["a"])}
def used(): return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
if __name__ == "__main__":
    fx.sweep(plain, {"a": range(1000)}, analyse, workers=2, folder=sys.argv[1] + "/few")
    before = used()
    found = fx.sweep(plain, {"a": range(25_000)}, analyse, workers=2, folder=sys.argv[1] + "/many")
    print(used() - before, found.x.nbytes / 2**20, float(found.x[-1, -1]), found.attrs["message"])
"""


@pytest.mark.slow
@pytest.mark.long
def test_many_points_need_little_memory(tmp_path: Path) -> None:
    """Of results of 76 MB the driving process holds a fraction at a time."""
    printed = process(MEMORY, str(tmp_path)).communicate(timeout=120)[0].split(maxsplit=3)
    more, size, last = map(float, printed[:3])
    assert printed[3].strip() == "25000 of 25000 points computed"
    assert size == pytest.approx(76.3, abs=0.1) and last == 24_999
    assert more < 40
    assert slow({"a": 1.0, "b": 1.0})["sum"] == 2


def test_a_full_disk_is_named_and_the_sweep_continues_from_what_it_has(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    points, put = {"a": [1.0, 2.0, 3.0], "b": [3.0]}, ColumnFile._put
    room = [4]  # pieces that the disk still takes, the empty files of the two results among them

    def full(file: ColumnFile, begin: int, rows: Any) -> None:
        room[0] -= 1
        if room[0] < 0:
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
        put(file, begin, rows)

    monkeypatch.setattr(ColumnFile, "_put", full)
    with pytest.raises(fx.FlexelError, match=r"sweep: cannot write to .*No space left.*continues from there"):
        fx.sweep(plain, points, numbers, executor="serial", folder=tmp_path, chunk=1)
    monkeypatch.setattr(ColumnFile, "_put", put)
    again = fx.sweep(plain, points, numbers, executor="serial", folder=tmp_path, chunk=1)
    xarray.testing.assert_identical(again, fx.sweep(plain, points, numbers, executor="serial"))
