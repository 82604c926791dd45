"""`flexel check`, `flexel run` and `flexel view` of a model saved as JSON."""

import importlib
import sys
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner, Result

import flexel as fx
from flexel.apps.cli import main as cli

PUSHES = """\
def push(t):
    return 0.1 * t
"""


def call(*arguments: object) -> Result:
    return CliRunner().invoke(cli.main, [str(argument) for argument in arguments])


def pendulum() -> fx.Model:
    m = fx.Model(gravity=(0, 0, -9.81))
    m.point("O", (0, 0, 0), fixed=True)
    m.point("A", (1, 0, 0))
    m.hinge("pivot", m.frame("R0", fixed=True), m.frame("R"), axis=(0, 1, 0))
    m.beam("rod", "O", "R", "A", mass_per_length=2.0)
    return m


@pytest.fixture
def saved(tmp_path: Path) -> Path:
    return pendulum().save(tmp_path / "pendulum.json")


@pytest.fixture
def pushed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """A model with a function of a module that is in the folder of the file, and not on Python's path."""
    folder = tmp_path / "models"
    folder.mkdir()
    (folder / "pushes_of_a_test.py").write_text(PUSHES, encoding="utf-8")
    m = pendulum()
    with monkeypatch.context() as within:
        within.syspath_prepend(folder)
        m.load("pivot.angle", importlib.import_module("pushes_of_a_test").push)
        file = m.save(folder / "pushed.json")
    del sys.modules["pushes_of_a_test"]
    yield file
    sys.modules.pop("pushes_of_a_test", None)


def test_a_saved_model_is_simulated(saved: Path, tmp_path: Path) -> None:
    result = call("run", saved, "--time", 0.5, "--samples", 11, "--out", tmp_path / "results")
    assert result.exit_code == 0, result.output
    motion = fx.load(tmp_path / "results" / "pendulum.npz")
    assert isinstance(motion, fx.Motion)
    here = pendulum().build().simulate(0.5, samples=11)
    assert np.array_equal(motion["pivot.angle"], here["pivot.angle"])


def test_functions_of_modules_beside_the_file_are_found(pushed: Path, tmp_path: Path) -> None:
    before = list(sys.path)
    result = call("run", pushed, "--time", 0.5, "--samples", 11, "--out", tmp_path / "results")
    assert result.exit_code == 0, result.output
    assert sys.path == before
    m = pendulum()
    m.load("pivot.angle", lambda t: 0.1 * t)
    motion = fx.load(tmp_path / "results" / "pushed.npz")
    assert isinstance(motion, fx.Motion)
    assert np.array_equal(motion["pivot.angle"], m.build().simulate(0.5, samples=11)["pivot.angle"])


def test_a_saved_model_says_nothing_of_how_long_to_simulate(saved: Path, tmp_path: Path) -> None:
    result = call("run", saved, "--out", tmp_path / "results")
    assert result.exit_code == 2
    assert "does not say how long to simulate; give --time SECONDS." in result.stderr
    assert not (tmp_path / "results").exists()


def test_a_saved_model_is_checked(saved: Path) -> None:
    result = call("check", saved)
    assert result.exit_code == 0, result.output
    assert result.stdout == f"{pendulum().check()}\n"


def test_findings_about_a_saved_model_are_a_status(tmp_path: Path) -> None:
    m = pendulum()
    m.point("lost", (0, 0, 1))
    result = call("check", m.save(tmp_path / "pendulum.json"))
    assert result.exit_code == 1
    assert "lost" in result.stdout


def test_a_saved_model_is_drawn(saved: Path) -> None:
    result = call("view", saved)
    assert result.exit_code == 0, result.output
    page = saved.with_suffix(".html").read_text(encoding="utf-8")
    assert "<title>pendulum" in page and '"times":[0.0]' in page


@pytest.mark.parametrize("command", [("run", "--time", 1), ("check",), ("view",)], ids=lambda given: given[0])
def test_a_file_of_something_else_ends_in_one_line(command: tuple[object, ...], tmp_path: Path) -> None:
    file = tmp_path / "numbers.json"
    file.write_text("[1, 2]", encoding="utf-8")
    name, *options = command
    result = call(name, file, *options)
    assert result.exit_code == 1
    assert "this is not a flexel model; give a file written by Model.save" in result.stderr
    assert len(result.stderr.strip().splitlines()) == 1
