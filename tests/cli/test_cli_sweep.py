"""`flexel sweep`: a file with build, analyse and points."""

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner, Result
from longer import longer

import flexel as fx
from flexel.apps.cli.main import main

pytest.importorskip("xarray", reason="sweeps need pip install 'flexel[sweep]'")
pytest.importorskip("joblib", reason="sweeps need pip install 'flexel[sweep]'")
STUDY = """
import time
import flexel as fx
from own_parts import hanging

points = {"length": [0.25, 0.5, 1.0], "mass": [1.0, 2.0]}

def build(length, mass):
    return hanging(length, mass)

def analyse(system):
    return {"omega": abs(system.linearize().eigenvalues()).max()}
"""
PARTS = """
import flexel as fx

def hanging(length, mass):
    m = fx.Model(gravity=(0, 0, -9.81))
    m.point("pivot", (0, 0, 0), fixed=True)
    m.frame("ground", fixed=True)
    m.frame("rod")
    m.hinge("hinge", "ground", "rod", axis=(0, 1, 0))
    m.body("body", "pivot", "rod", mass=mass, inertia=(1e-9, 1e-9, 1e-9), offset=(0, 0, -length))
    return m
"""
MANY = """
import time

points = {"a": range(3000)}

def build(a):
    return a

def analyse(a):
    time.sleep(0.01)
    return {"twice": 2.0 * a}
"""


def run(*arguments: str | Path) -> Result:
    return CliRunner().invoke(main, ["sweep", *map(str, arguments)])


@pytest.fixture
def study(tmp_path: Path) -> Path:
    """A file that imports what lies beside it."""
    (tmp_path / "own_parts.py").write_text(PARTS, encoding="utf-8")
    file = tmp_path / "study.py"
    file.write_text(STUDY, encoding="utf-8")
    return file


def test_a_file_is_swept_into_a_folder(study: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    result = run(study, "--workers", "2")
    assert result.exit_code == 0, result.output
    assert "6 of 6 points computed; results are in out/study" in result.output
    assert "omega " in result.output and "median" in result.output
    data = fx.open_sweep("out/study")
    assert data.omega.dims == ("length", "mass")
    assert data.omega.sel(length=0.25).values == pytest.approx((9.81 / 0.25) ** 0.5, rel=1e-6)
    assert "own_parts" not in sys.modules or sys.path[0] != str(tmp_path)


def test_points_that_fail_are_reported_and_computed_again(study: Path, tmp_path: Path) -> None:
    out = tmp_path / "results"
    study.write_text(STUDY.replace("[1.0, 2.0]", "[1.0, -2.0]"), encoding="utf-8")
    first = run(study, "--out", out)
    assert first.exit_code == 1
    assert "3 of 6 points computed, 3 failed; the first, length = 0.25, mass = -2.0: " in first.output
    study.write_text(
        STUDY.replace("[1.0, 2.0]", "[1.0, -2.0]").replace("length, mass)\n\n", "length, abs(mass))\n\n"),
        encoding="utf-8",
    )
    assert run(study, "--out", out).exit_code == 1
    again = run(study, "--out", out, "--retry")
    assert again.exit_code == 0 and "6 of 6 points computed" in again.output


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (("points = ", "grid = "), "study.py: defines no points; define build, analyse, points"),
        (('"length": [', '"lenght": ['), "unknown parameter 'lenght'; did you mean length"),
        (("points = {", "points = {{"), "study.py, line 6"),
        (
            ("return hanging(", "return hangng("),
            "all 6|0 of 6 points computed, 6 failed.*NameError.*study.py, line 9",
        ),
    ],
)
def test_bad_files_are_answered_in_one_line(study: Path, change: tuple[str, str], message: str) -> None:
    study.write_text(STUDY.replace(*change), encoding="utf-8")
    result = run(study, "--out", study.parent / "out")
    assert result.exit_code == 1
    import re

    assert re.search(message, result.output) and "Traceback" not in result.output


@pytest.mark.parametrize(
    ("number", "status"), longer([(signal.SIGINT, 130), (signal.SIGKILL, -9)], (signal.SIGINT, 130))
)
def test_what_was_interrupted_or_killed_is_continued(tmp_path: Path, number: int, status: int) -> None:
    """Ctrl-C reaches all processes of the terminal, a kill only the command."""
    file, out = tmp_path / "many.py", tmp_path / "many"
    file.write_text(MANY, encoding="utf-8")
    command = [sys.executable, "-m", "flexel", "sweep", str(file), "--workers", "2", "--out", str(out)]
    with open(tmp_path / "printed", "w", encoding="utf-8") as printed:
        running = subprocess.Popen(command, stdout=printed, stderr=printed, start_new_session=True)
    end = time.monotonic() + 60
    while not (out / "status.npy").exists() or np.load(out / "status.npy").sum() < 20:
        assert time.monotonic() < end
        time.sleep(0.02)
    os.killpg(running.pid, number) if number == signal.SIGINT else running.kill()
    assert running.wait(timeout=60) == status
    reported = (tmp_path / "printed").read_text(encoding="utf-8")
    assert "Traceback" not in reported
    assert ("interrupted" in reported and "the same command continues" in reported) == (status == 130)
    kept = int(np.load(out / "status.npy").sum())
    assert 20 <= kept < 3000
    file.write_text(MANY.replace("0.01", "0").replace("2.0 * a", "-1.0"), encoding="utf-8")
    result = run(file, "--out", out, "--workers", "2")
    assert result.exit_code == 0, result.output
    data = fx.open_sweep(out)
    assert int((data.twice >= 0).sum()) == kept and int((data.twice == -1).sum()) == 3000 - kept
