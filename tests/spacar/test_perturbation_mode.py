"""Mode 3: small motions about the nominal motion, in which deformations keep their initial values."""

from pathlib import Path

import numpy as np
import pytest
from scipy.io import loadmat
from spacar_lines import file

from flexel.apps.spacar.analysis_modes import MODES, Results
from flexel.apps.spacar.reading import read_spacar
from flexel.apps.spacar.run_file import run_spacar

DATA = Path(__file__).parent.parent / "data"
CRANK = (DATA / "slider_crank.dat").read_text()


def both(folder: Path, text: str) -> tuple[Results, Results]:
    """Results of mode 3 and of the full motion, mode 1."""
    path = folder / "crank.dat"
    path.write_text(text)
    found = read_spacar(path)
    return MODES[3](found).results, MODES[1](found).results


def difference(small: Results, full: Results, name: str) -> float:
    """Largest difference of the nominal value and its small change from the full one, relative to the change."""
    return float(
        np.max(np.abs(small[name] + small[f"d{name}"] - full[name])) / np.max(np.abs(small[f"d{name}"]))
    )


def test_nominal_motion_and_small_changes_are_the_full_motion_to_first_order(tmp_path: Path) -> None:
    """At half the speed inertia bends the rod by a fourth: what is left out is a fourth as large beside it."""
    fast, slow = (both(tmp_path, CRANK.replace("XD 2 1 1.5", f"XD 2 1 {speed}")) for speed in (1.5, 0.75))
    for name in ("e_2_2", "e_2_3", "e_3_2", "e_3_3"):
        assert difference(*fast, name) < 0.06
        assert difference(*slow, name) < 0.4 * difference(*fast, name)
    for name in ("x_6_1", "x_6_2", "x_9_1"):
        assert difference(*fast, name) < 0.15


def test_its_matrices_are_those_along_the_nominal_motion() -> None:
    """K0, N0 and G0 add up to the stiffness of the equations that were integrated."""
    found = read_spacar(DATA / "slider_crank.dat")
    results = MODES[3](found).results
    along = found.system.along(times=results["t"])
    assert np.max(np.abs(results["K0"] + results["N0"] + results["G0"] - along.K)) < 1e-14 * np.max(along.K)
    assert np.array_equal(results["M0"], along.M)
    assert np.max(np.abs(results["e_2_2"])) < 1e-15  # nominal: the rod is straight


def test_a_rate_at_the_start_is_a_small_motion(tmp_path: Path) -> None:
    """A mass on a spring: closed form."""
    lines = ["PLTRUSS 1 1 2", "X 2 1 0", "FIX 1", "FIX 2 2", "DYNE 1", "END", "HALT"]
    file(tmp_path, *lines, "XM 2 2.0", "ESTIFF 1 50", "STARTDE 1 1 0 0.003", "TIMESTEP 2 40")
    results = MODES[3](read_spacar(tmp_path / "model.dat")).results
    assert results["de_1_1"] == pytest.approx(0.003 / 5 * np.sin(5 * results["t"]), abs=1e-9)
    assert results["dx_2_1"] == pytest.approx(results["de_1_1"], abs=1e-15)


def test_the_report_and_the_files_have_them(tmp_path: Path) -> None:
    report = run_spacar(DATA / "slider_crank.dat", tmp_path, mode=3, mat=True).report
    assert "small changes from it" in report and "plbeam2.bend1: " in report
    heads = (tmp_path / "slider_crank.csv").read_text().splitlines()[0]
    assert "e_2_2" in heads and "de_2_2" in heads and "dx_6_1" in heads
    table, small = (
        loadmat(tmp_path / "slider_crank.mat"),
        MODES[3](read_spacar(DATA / "slider_crank.dat")).results,
    )
    for name, places, (n, i) in (("dx", "lnp", (6, 1)), ("de", "le", (2, 2))):
        column = table[name][:, table[places][n - 1, i - 1] - 1]
        assert np.array_equal(column, small[f"{name}_{n}_{i}"]) and np.any(column)
