"""`flexel run model.dat --compare`: the largest differences from SPACAR's own results, and where they are."""

import re
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner
from coarse import COARSE_MESH
from mechanisms import DATA
from spacar_binary import write
from spacar_lines import file

import flexel as fx
from flexel.apps.cli.main import main
from flexel.apps.spacar.run_file import run_spacar
from flexel.base.arrays import Array
from flexel.results.saved.spacar_entries import read_entries

pytestmark = COARSE_MESH


PIVOT = DATA / "two_leaf_pivot.dat"
PENDULUM = [
    "PLBEAM 1 1 2 3 4",
    "X 3 0 -0.5",
    "FIX 1",
    "DYNX 2 1",
    "END",
    "HALT",
    "XM 3 2.0",
    "GRAVITY 0 -9.81",
]
PENDULUM += ["TIMESTEP 0.2 4", "END", "HALT", "INPUTF 1 3 1", "OUTX 1 2 1", "END", "END"]


def ratios(report: str) -> dict[str, float]:
    """The ratio of each row of the tables."""
    found = [re.split(r" {2,}", line.strip()) for line in report.splitlines()]
    return {
        cells[0]: float(cells[3])
        for cells in found
        if len(cells) > 3 and re.fullmatch(r"[0-9.]+e[+-]\d+", cells[3])
    }


def test_spacars_own_results_agree() -> None:
    options = ["--compare", str(DATA / "two_leaf_pivot.sbd"), "--compare", str(DATA / "two_leaf_pivot.sbm")]
    result = CliRunner().invoke(main, ["run", str(PIVOT), *options])
    assert result.exit_code == 0, result.output
    report = result.output[result.output.index("compared with two_leaf_pivot.sbd, 10 records") :]
    found = ratios(report)
    assert found.keys() >= {"coordinates", "reactions", "deformations", "stresses", "M0", "K0", "G0", "N0"}
    assert len(found) == 14 and max(found.values()) < 1e-9 and found["stresses"] > 0
    assert "not" not in report  # everything has a counterpart


def test_a_changed_number_is_found(tmp_path: Path) -> None:
    """A coordinate of node 7 in record 3, a stress of element 3 in record 5, and an entry of G0 in record 2."""
    motion = read_entries(DATA / "two_leaf_pivot.sbd")
    records = {tag: values.copy() for tag, values in motion.records.items()}
    records["X"][3, motion.constant["LNP"][6, 1] - 1, 0] += 1e-3
    records["SIG"][5, motion.constant["LE"][2, 3] - 1, 0] -= 0.5
    matrices = read_entries(DATA / "two_leaf_pivot.sbm")
    changed = {tag: values.copy() for tag, values in matrices.records.items()}
    changed["G0"][2, 0, 4] += 7.0
    paths = [
        write(tmp_path / "a.sbd", motion.constant, records),
        write(tmp_path / "a.sbm", matrices.constant, changed),
    ]
    report = run_spacar(PIVOT, compare=paths).report
    assert re.search(r"coordinates +1\.000e-03 +1\.000e\+00 +1\.0e-03  node 7, 2, record 3\n", report)
    assert re.search(r"stresses +5\.000e-01 .*element 3, 4, record 5\n", report)
    assert re.search(r"G0 +7\.000e\+00 .*row 1, column 5, record 2\n?", report)
    assert ratios(report)["deformations"] < 1e-9


def test_what_has_no_counterpart_is_reported(tmp_path: Path) -> None:
    """Records beyond ours, a node and an element that the file does not have, and one that SPACAR does not have."""
    motion = read_entries(DATA / "two_leaf_pivot.sbd")
    constant = {
        tag: value.copy() if isinstance(value, np.ndarray) else value
        for tag, value in motion.constant.items()
    }
    constant["LNP"][[2, 9]] = constant["LNP"][[9, 2]]  # node 10 is called 3
    with pytest.raises(fx.ModelError, match="element 3 has the node 10, which the file does not have"):
        run_spacar(PIVOT, compare=[write(tmp_path / "a.sbd", constant, motion.records)])
    constant["LN"][constant["LN"] == 10] = 3
    text = PIVOT.read_text().replace("ITERSTEP	10	  9", "ITERSTEP 10 6")
    (tmp_path / "short.dat").write_text(text)
    changed = write(tmp_path / "a.sbd", constant, motion.records)
    report = run_spacar(tmp_path / "short.dat", compare=[changed]).report
    assert "3 records have no state here: the first is 7" in report
    assert "nodes that are not there (number: coordinate or mode): 10: 1, 10: 2, 10: 3" in report
    assert "nodes that are not here (number: coordinate or mode): 3: 1, 3: 2, 3: 3" in report
    report = run_spacar(PIVOT, mode=0, compare=[DATA / "two_leaf_pivot.sbm"]).report
    assert "no states to compare; choose another --mode" in report


def ltv(path: Path, t: Array, tables: tuple[Array, ...]) -> Path:
    records = {"T": t.reshape(-1, 1, 1)} | {
        name: np.stack([A] * t.size) for name, A in zip("ABCD", tables, strict=True)
    }
    return write(path, {"LTV": "LTV"}, records)


def test_state_spaces_are_compared_at_their_times(tmp_path: Path) -> None:
    found = file(tmp_path, *PENDULUM)
    tables = found.state_space()
    start = ltv(tmp_path / "start.ltv", np.array([0.0]), tables)
    along = ltv(tmp_path / "along.ltv", np.array([0.0, 0.1, 0.13, 0.2]), tables)
    report = run_spacar(tmp_path / "model.dat", mode=9, compare=[start]).report
    assert max(ratios(report)[name] for name in "ABCD") < 1e-12
    assert "4 states here have no record: the first is 1, t = 0.05" in report
    report = run_spacar(tmp_path / "model.dat", mode=9, compare=[along]).report
    assert "1 records have no state here: the first is 2, t = 0.13" in report
    assert "2 states here have no record: the first is 1, t = 0.05" in report
    report = run_spacar(tmp_path / "model.dat", mode=4, compare=[along]).report
    assert "this analysis does not give them: A, B, C, D; choose another --mode" in report


def test_files_that_are_no_results_of_spacar_are_refused(tmp_path: Path) -> None:
    (tmp_path / "a.csv").write_text("t\n")
    (tmp_path / "b.sbd").write_bytes(b"no result")
    for name, what in (("a.csv", "give one of .sbd, .sbm, .ltv"), ("b.sbd", "damaged")):
        result = CliRunner().invoke(main, ["run", str(PIVOT), "--compare", str(tmp_path / name)])
        assert result.exit_code == 1 and what in result.output
    (tmp_path / "m.py").write_text("import flexel\n")
    result = CliRunner().invoke(main, ["run", str(tmp_path / "m.py"), "--compare", str(tmp_path / "a.csv")])
    assert result.exit_code == 2 and "--compare" in result.output
