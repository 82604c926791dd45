"""`flexel view` makes the same page of a saved result as of the result itself."""

import json
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from click.testing import CliRunner
from coarse import COARSE_MESH
from mechanisms import cantilever, pendulum

import flexel as fx
from flexel.apps.cli import main as cli
from flexel.apps.view.page import mode_data, scene_data
from flexel.apps.view.page.coding import coded


def scene_in(path: Path) -> Any:
    """The data of a page."""
    found = re.search(r'id="scene">(.*?)</script>', path.read_text(), flags=re.S)
    assert found is not None
    return json.loads(found[1])


def run(*arguments: object) -> Any:
    return CliRunner().invoke(cli.main, ["view", *map(str, arguments)])


@pytest.mark.parametrize("suffix", [".npz", ".mat", ".csv", ".nc"])
def test_a_saved_motion_is_shown_without_its_model(tmp_path: Path, suffix: str) -> None:
    """The page holds the stored states, as one that is written from the motion itself."""
    if suffix == ".nc":
        pytest.importorskip("h5netcdf", reason="pip install 'flexel[xarray]'")
    motion = pendulum().simulate(0.5, samples=11, progress=False)
    result = run(motion.save(tmp_path / f"swing{suffix}"), "--title", "Swing")
    assert result.exit_code == 0, result.output
    assert result.output.strip() == f"wrote {tmp_path / 'swing.html'}"
    shown, expected = scene_in(tmp_path / "swing.html"), scene_data(motion, frames=11, title="Swing")
    assert np.allclose(shown["times"], expected["times"])
    assert shown["shapes"] == coded(expected)["shapes"] and shown["numbers"] == coded(expected)["numbers"]
    assert shown["title"] == "Swing"


def test_modes_of_a_saved_linearization(tmp_path: Path) -> None:
    """Of a linearization the modes are shown, with the same shapes."""
    system = cantilever()
    lin = system.linearize(system.equilibrium())
    page = tmp_path / "modes.html"
    result = run(lin.save(tmp_path / "lin.npz"), "--out", page)
    assert result.exit_code == 0, result.output
    assert scene_in(page)["modes"] == mode_data(lin)["modes"]
    assert scene_in(lin.view(tmp_path / "own.html"))["modes"] == mode_data(lin)["modes"]


def test_the_motion_of_a_spacar_file_is_shown(tmp_path: Path, checkout: Path) -> None:
    """`flexel run model.dat --out` leaves a motion to be viewed: here a belt and gears."""
    arguments = ["run", str(checkout / "tests" / "data" / "spacar_four_bar.dat"), "--out", str(tmp_path)]
    assert CliRunner().invoke(cli.main, arguments).exit_code == 0
    result = run(tmp_path / "spacar_four_bar_motion.npz")
    assert result.exit_code == 0, result.output
    shown = scene_in(tmp_path / "spacar_four_bar_motion.html")["shapes"]
    assert sorted(shape["name"] for shape in shown if shape["style"] == "rim") == [
        "gear7",
        "gear7",
        "plbelt6",
        "plbelt6",
    ]


def test_the_tables_of_a_spacar_run_name_the_motion_next_to_them(tmp_path: Path, checkout: Path) -> None:
    """They are the first that one tries to view; of an analysis without a motion there is none to name."""
    data = checkout / "tests" / "data"
    for name, mode in (("spacar_four_bar", "1"), ("spacar_cantilever", "7"), ("spacar_cantilever", "8")):
        arguments = ["run", str(data / f"{name}.dat"), "--out", str(tmp_path / mode), "--mode", mode]
        assert CliRunner().invoke(cli.main, arguments).exit_code == 0
    for suffix in (".npz", ".csv"):
        result = run(tmp_path / "1" / f"spacar_four_bar{suffix}")
        assert result.exit_code == 1
        assert "is a table of a SPACAR run" in result.output
        assert f"give '{tmp_path / '1' / 'spacar_four_bar_motion.npz'}'" in result.output
    for mode in "78":
        result = run(tmp_path / mode / "spacar_cantilever.npz")
        assert result.exit_code == 1
        assert (
            "is a table of a SPACAR run" in result.output
            and "its motion is not next to this file" in result.output
        )


@COARSE_MESH
def test_the_load_steps_of_a_spacar_file_are_kept_and_played(tmp_path: Path, checkout: Path) -> None:
    path = str(checkout / "tests" / "data" / "two_leaf_pivot.dat")
    made = CliRunner().invoke(cli.main, ["run", path, "--out", str(tmp_path)])
    assert made.exit_code == 0 and "9 load steps" in made.output
    kept = tmp_path / "two_leaf_pivot_motion.npz"
    assert f"wrote {kept}" in made.output
    motion = fx.load(kept)
    system, states = fx.read_spacar(path).static_steps()
    assert motion.t == pytest.approx(np.linspace(0, 1, 10))
    assert motion["p7.x"] == pytest.approx([state["p7.x"] for state in states], rel=0, abs=0)
    assert system.structure.names == motion.structure.names
    assert run(kept).exit_code == 0
    assert scene_in(kept.with_suffix(".html"))["times"] == pytest.approx(motion.t)


def test_a_file_that_is_not_a_result_is_reported(tmp_path: Path) -> None:
    """In one line, without a traceback."""
    path = tmp_path / "notes.npz"
    path.write_text("import os")
    result = run(path)
    assert result.exit_code == 1
    assert "notes.npz" in result.output and "Traceback" not in result.output
