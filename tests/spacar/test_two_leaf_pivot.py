"""UT SPACAR's own results of a file of SPACAR Light: two leaf springs on a stiff body, turned in nine steps.

The numbers are decoded from its .sbd and .sbm, see `two_leaf_pivot.json`.
"""

import json
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from click.testing import CliRunner
from coarse import COARSE_MESH
from scipy.linalg import eigvals

from flexel.apps.cli.main import main
from flexel.base.arrays import Array

pytestmark = COARSE_MESH


DATA = Path(__file__).parent.parent / "data"
FILE = DATA / "two_leaf_pivot.dat"
TOLERANCE = 1e-9  # of the largest entry of each block
MATRICES = ("M0", "K0", "G0", "N0")
THEIRS: dict[str, Any] = json.loads((DATA / "two_leaf_pivot.json").read_text())
RECORDS = [0, 4, 9]


@pytest.fixture(scope="module")
def ran(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Array]:
    """Results of `flexel run` on the file as it stands."""
    folder = tmp_path_factory.mktemp("pivot")
    result = CliRunner().invoke(main, ["run", str(FILE), "--out", str(folder)])
    assert result.exit_code == 0, result.output
    assert "mode 10" in result.output
    with np.load(folder / "two_leaf_pivot.npz") as kept:
        return {name: kept[name] for name in kept}


def difference(ours: Array, theirs: Array) -> float:
    """Largest difference, relative to the largest entry."""
    return float(np.max(np.abs(ours - theirs)) / np.max(np.abs(theirs)))


def in_order(ran: dict[str, Array], step: int, letter: str, places: list[list[int]]) -> Array:
    """Our values in the order of SPACAR's vector; NaN where a file has no such quantity, of the norms."""
    found = np.full(max(map(max, places)), np.nan)
    for subject, row in enumerate(places, 1):
        for i, place in enumerate(row, 1):
            if place and f"{letter}_{subject}_{i}" in ran:
                found[place - 1] = ran[f"{letter}_{subject}_{i}"][step]
    return found


@pytest.mark.parametrize("step", RECORDS)
def test_positions_are_spacars(ran: dict[str, Array], step: int) -> None:
    ours = in_order(ran, step, "x", THEIRS["LNP"])
    assert ours.size == 28 and difference(ours, np.array(THEIRS["records"][str(step)]["X"])) < TOLERANCE


@pytest.mark.parametrize("step", RECORDS)
@pytest.mark.parametrize(("letter", "name"), [("e", "E"), ("s", "SIG")])
def test_deformations_and_stresses_are_spacars(
    ran: dict[str, Array], letter: str, name: str, step: int
) -> None:
    """Those of the rigid beam under its weight, too, which has no fixed-end moments."""
    ours, theirs = in_order(ran, step, letter, THEIRS["LE"]), np.array(THEIRS["records"][str(step)][name])
    own = ~np.isnan(ours)
    assert np.count_nonzero(own) == 18
    assert difference(ours[own], theirs[own]) < TOLERANCE


@pytest.mark.parametrize("step", RECORDS)
@pytest.mark.parametrize("name", MATRICES)
def test_matrices_are_spacars(ran: dict[str, Array], name: str, step: int) -> None:
    """In its order of degrees of freedom, with rotary inertia lumped at the nodes."""
    theirs = np.array(THEIRS["records"][str(step)][name])
    if not theirs.any():
        assert not ran[name][step].any()
        return
    assert difference(ran[name][step], theirs) < TOLERANCE


@pytest.mark.parametrize("step", RECORDS)
def test_frequencies_are_those_of_spacars_matrices(ran: dict[str, Array], step: int) -> None:
    M0, K0, G0, N0 = (np.array(THEIRS["records"][str(step)][name]) for name in MATRICES)
    theirs = np.sort(np.sqrt(eigvals(K0 + N0 + G0, M0).real))
    assert ran["frequencies"].shape == (10, 5)
    assert np.max(np.abs(ran["frequencies"][step] / theirs - 1)) < TOLERANCE


def test_the_converted_program_gives_the_same(ran: dict[str, Array], tmp_path: Path) -> None:
    target = tmp_path / "pivot.py"
    assert CliRunner().invoke(main, ["convert", str(FILE), str(target)]).exit_code == 0
    run = subprocess.run([sys.executable, target], capture_output=True, text=True, check=True, cwd=tmp_path)
    printed = dict(line.split() for line in run.stdout.splitlines())
    assert abs(float(printed["p7.x"]) - ran["x_7_1"][-1]) < 1e-12
    assert abs(float(printed["beam3.bend3"]) - ran["e_3_5"][-1]) < 1e-12
