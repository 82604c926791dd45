"""`flexel run FOLDER`: all models of a folder beside SPACAR's own results of them."""

import shutil
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner
from coarse import COARSE_MESH
from mechanisms import DATA
from spacar_binary import write

import flexel as fx
from flexel.apps.cli.main import main
from flexel.apps.spacar.folder import run_folder

pytestmark = COARSE_MESH
PIVOT = "two_leaf_pivot"


def pivot(folder: Path) -> None:
    for suffix in (".dat", ".sbd", ".sbm"):
        shutil.copy(DATA / f"{PIVOT}{suffix}", folder)


def test_a_table_shows_how_well_they_agree(tmp_path: Path) -> None:
    """UT SPACAR's own results of load steps; beside them a model without results, and results without a model."""
    pivot(tmp_path)
    shutil.copy(DATA / "spacar_leaf.dat", tmp_path)
    shutil.copy(DATA / f"{PIVOT}.sbd", tmp_path / "other.SBD")
    result = CliRunner().invoke(main, ["run", str(tmp_path)])
    assert result.exit_code == 0, result.output
    report = run_folder(tmp_path)
    assert [row[:4] for row in report.rows] == [
        (f"{PIVOT}.dat", f"{PIVOT}{suffix}", "10", "10 of 10") for suffix in (".sbd", ".sbm")
    ]
    assert all(float(row[4]) < 1e-9 and row[5] and row[6] for row in report.rows)
    assert "other.SBD: there is no model of this name" in result.output
    assert "spacar_leaf.dat: there are no SPACAR results next to it; not run" in result.output


def test_each_kind_of_results_is_compared_with_the_mode_that_gives_it(tmp_path: Path) -> None:
    (tmp_path / "m.dat").write_text(
        "PLBEAM 1 1 2 3 4\nX 3 0 -0.5\nFIX 1\nDYNX 2 1\nXD 2 1 1.0\nXM 3 2.0\nGRAVITY 0 -9.81\n"
        "INPUTF 1 3 1\nOUTX 1 2 1\nTIMESTEP 1.0 10\nEND END\n"
    )
    file = fx.read_spacar(tmp_path / "m.dat")
    A, B, C, D = file.state_space()
    start = {"T": np.zeros((1, 1, 1))}
    write(
        tmp_path / "m.ltv", {"LTV": "LTV"}, start | {"A": A[None], "B": B[None], "C": C[None], "D": D[None]}
    )
    write(tmp_path / "m.sbm", {"SBM": "SBM"}, start | {"M0": 2 * file.matrices().M0[None]})
    report = run_folder(tmp_path)
    assert [(row[1], row[2]) for row in report.rows] == [("m.ltv", "9"), ("m.sbm", "4")]
    assert float(report.rows[0][4]) < 1e-12
    assert report.rows[1][4:6] == ("5.0e-01", "M0")


def test_what_cannot_be_read_is_named_and_the_others_are_compared(tmp_path: Path) -> None:
    pivot(tmp_path)
    (tmp_path / "a.dat").write_text("BEAM x\n")
    shutil.copy(DATA / f"{PIVOT}.sbd", tmp_path / "a.sbd")
    result = CliRunner().invoke(main, ["run", str(tmp_path)])
    assert result.exit_code == 1
    assert "a.dat, line 1: BEAM: 'x' is not a number" in result.output and "10 of 10" in result.output


def test_other_options_and_folders_without_models_are_refused(tmp_path: Path) -> None:
    with pytest.raises(fx.ModelError, match="no SPACAR file"):
        run_folder(tmp_path)
    result = CliRunner().invoke(main, ["run", str(tmp_path)])
    assert result.exit_code == 1 and "no SPACAR file" in result.output
    result = CliRunner().invoke(main, ["run", str(tmp_path), "--mode", "4"])
    assert result.exit_code == 2 and "only the option --dialect" in result.output
