"""What `flexel run model.dat` writes on wish: the log, and a .mat file with SPACAR's names."""

import re
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner
from coarse import COARSE_MESH
from mechanisms import DATA
from scipy.io import loadmat
from spacar_lines import file

import flexel as fx
from flexel.apps.cli.main import main
from flexel.apps.spacar.run_file import run_spacar
from flexel.base.arrays import Array
from flexel.results.saved.spacar_entries import TaggedEntries, read_entries

pytestmark = COARSE_MESH


PIVOT = DATA / "two_leaf_pivot.dat"


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    out = tmp_path_factory.mktemp("pivot")
    result = CliRunner().invoke(main, ["run", str(PIVOT), "--log", "--format", "mat", "--out", str(out)])
    assert result.exit_code == 0, result.output
    assert "two_leaf_pivot.log" in result.output and "two_leaf_pivot.mat" in result.output
    return out


@pytest.fixture(scope="module")
def theirs() -> TaggedEntries:
    return read_entries(DATA / "two_leaf_pivot.sbd")


def listed(log: str, what: str, part: str) -> list[tuple[int, int]]:
    """Numbers in a list of the log."""
    section = log[log.index(what) :].split("\n\n")[0]
    text = re.search(rf"^  {part}:\n((?:    .*\n?)*)", section, re.MULTILINE)
    return [(int(n), int(i)) for n, i in re.findall(r"[XE] (\d+) (\d+)", text[1] if text else "")]


@pytest.mark.parametrize(
    ("what", "counts", "table"), [("coordinates (", "NXP", "LNP"), ("deformations (", "NEP", "LE")]
)
def test_the_log_counts_as_spacar_does(
    folder: Path, theirs: TaggedEntries, what: str, counts: str, table: str
) -> None:
    """Fixed, dependent, prescribed, dynamic, kinematic, of coordinates and of deformations; and which they are."""
    log = (folder / "two_leaf_pivot.log").read_text()
    parts = ("fixed", "dependent", "prescribed", "dynamic", "kinematic")
    numbers = np.ravel(theirs.constant[counts])
    assert ", ".join(f"{part} {n}" for part, n in zip(parts, numbers, strict=True)) in log
    places = {
        (n, i): int(place)
        for n, row in enumerate(theirs.constant[table], 1)
        for i, place in enumerate(row, 1)
        if place
    }
    order = (0, 1, 2, 3, 4) if counts == "NXP" else (0, 2, 3, 4, 1)
    norms = range(4, 8) if counts == "NEP" else ()  # elements that SPACAR adds
    ends = np.cumsum([0, *numbers[list(order)]])
    for k, part in enumerate(order):
        own = {entry for entry, at in places.items() if ends[k] < at <= ends[k + 1] and entry[0] not in norms}
        assert set(listed(log, what, parts[part])) == own, parts[part]
    if counts == "NEP":
        assert "norms of orientation nodes:\n    2            5            8            11" in log


def test_the_log_lists_the_degrees_of_freedom_in_order(folder: Path) -> None:
    log = (folder / "two_leaf_pivot.log").read_text()
    rows = re.findall(r"^  (\d) +(E \d \d) +beam3", log, re.MULTILINE)
    assert rows == [(str(k), f"E 3 {i}") for k, i in enumerate((1, 2, 3, 5, 6), 1)]


def test_the_log_of_what_cannot_be_built_has_the_reason(tmp_path: Path) -> None:
    lines = [
        "BEAM 1 1 2 3 4 0 1 0",
        "X 3 1 0 0",
        "FIX 1",
        "FIX 2",
        "FIX 3",
        "END",
        "HALT",
        "EM 1 1",
        "END",
        "END",
    ]
    file(tmp_path, *lines)
    run_spacar(tmp_path / "model.dat", tmp_path, mode=0, log=True)
    assert "over-constrained" in (tmp_path / "model.log").read_text()
    with pytest.raises(fx.ModelError, match="give out"):
        run_spacar(PIVOT, log=True)


def test_a_mat_file_has_spacars_names(folder: Path, theirs: TaggedEntries) -> None:
    """Read through lnp and le, as with getfrsbf, the numbers are those of SPACAR's own file."""
    kept = loadmat(folder / "two_leaf_pivot.mat")
    assert kept["time"].shape == (10, 1) and kept["nx"].item() == 28 and kept["nddo"].item() == 5
    for ours, table, names in (
        ("lnp", "LNP", {"x": "X", "xd": "XD", "xdd": "XDD", "fx": "FX"}),
        ("le", "LE", {"e": "E", "ed": "ED", "edd": "EDD", "sig": "SIG"}),
    ):
        here, there = kept[ours], theirs.constant[table][: len(kept[ours])]
        assert here.shape == there.shape and np.array_equal(here > 0, there > 0)
        for name, tag in names.items():
            mine = kept[name][:, here[here > 0] - 1]
            other = theirs.records[tag][:, there[there > 0] - 1, 0]
            assert np.max(np.abs(mine - other)) <= 1e-9 * np.max(np.abs(other)), name
    matrices = read_entries(DATA / "two_leaf_pivot.sbm")
    for tag in ("M0", "C0", "D0", "K0", "N0", "G0"):
        other = np.moveaxis(matrices.records[tag], 0, -1)
        assert kept[tag.lower()].shape == (5, 5, 10)
        assert np.max(np.abs(kept[tag.lower()] - other)) <= 1e-9 * np.max(np.abs(other)), tag


def moment(q: Array, f: Array) -> Array:
    """The moment whose dual to Euler parameters is f."""
    a, b, c, d = q
    Q = np.array([[-b, -c, -d], [a, d, -c], [-d, a, b], [c, -b, a]])  # the derivative of q is Q omega / 2
    return Q.T @ f / 2


def test_loads_and_state_space_in_a_mat_file(tmp_path: Path) -> None:
    lines = ["BEAM 1 1 2 3 4 0 1 0", "X 3 1 0 0", "FIX 1", "FIX 2", "DYNE 1", "END", "HALT", "EM 1 1 1 1 1"]
    lines += [
        "ESTIFF 1 1e6 10 20 30",
        "XF 3 1 2 3",
        "XF 4 0.1 0.2 0.3",
        "END",
        "HALT",
        "INPUTF 1 3 2",
        "OUTX 1 3 2",
    ]
    found = file(tmp_path, *lines, "END", "END")
    run_spacar(tmp_path / "model.dat", tmp_path, mode=8, mat=True)
    kept = loadmat(tmp_path / "model.mat")
    fx_, x, lnp = kept["fx"][0], kept["x"][0], kept["lnp"]
    assert fx_[lnp[2, :3] - 1].tolist() == [1.0, 2.0, 3.0]
    assert moment(x[lnp[3] - 1], fx_[lnp[3] - 1]) == pytest.approx([0.1, 0.2, 0.3], rel=1e-12)
    A, B, C, D = found.state_space(found.system.equilibrium())
    for name, own in zip("abcd", (A, B, C, D), strict=True):
        assert np.allclose(kept[name], own, rtol=1e-9, atol=1e-9 * np.abs(own).max(initial=0.0))


def test_other_formats_and_options_are_refused() -> None:
    for options in (["--format", "nc"], ["--format", "mat", "--format", "csv"]):
        result = CliRunner().invoke(main, ["run", str(PIVOT), *options])
        assert result.exit_code == 2 and "--format mat" in result.output
