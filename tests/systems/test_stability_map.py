"""The stability map of the bicycle: formulas of the benchmark, and the criterion of Routh and Hurwitz."""

from pathlib import Path

import numpy as np
import pytest

from flexel.examples import bicycle_data as data
from flexel.examples import stability_map, whipple
from flexel.examples.stability_map import SPEEDS, rows, stable, sweep, widths


def test_the_formulas_give_the_published_matrices() -> None:
    found = whipple.matrices(data.BENCHMARK)
    for name in ("M", "C1", "K0", "K2"):
        assert found[name] == pytest.approx(np.array(getattr(data, name)), rel=1e-13, abs=1e-13)


def test_the_map_is_right_at_each_point() -> None:
    pytest.importorskip("joblib", reason="sweeps need pip install 'flexel[sweep]'")
    found = sweep(4, executor="serial")
    assert [row.name for row in rows(found) if row.ok is False] == []
    steady = stable(found)
    for i, j, k in ((0, 0, 200), (1, 2, 150), (3, 3, 220), (0, 3, 120), (2, 1, 300)):
        M, C1, K0, K2 = (found[name].values[i, j] for name in stability_map.MATRICES)
        v = float(SPEEDS[k])
        K = data.BENCHMARK["g"] * K0 + v**2 * K2
        A = np.block([[np.zeros((2, 2)), np.eye(2)], [-np.linalg.solve(M, K), -np.linalg.solve(M, v * C1)]])
        assert steady[i, j, k] == (np.linalg.eigvals(A).real.max() < 0)
    assert np.isnan(widths(steady)[3, 0]) and widths(steady)[0, 3] > 3  # long without trail, short with it


def test_the_stable_range_of_the_benchmark() -> None:
    one = {name: np.array(getattr(data, name))[None, None] for name in stability_map.MATRICES}
    steady = stable({name: type("Values", (), {"values": value}) for name, value in one.items()})[0, 0]
    inside = SPEEDS[steady]
    assert inside[0] == pytest.approx(data.WEAVE_SPEED, abs=0.025)
    assert inside[-1] == pytest.approx(data.CAPSIZE_SPEED, abs=0.025)


@pytest.mark.slow
@pytest.mark.long
def test_the_picture(tmp_path: Path) -> None:
    pytest.importorskip("matplotlib", reason="pictures need pip install 'flexel[plot]'")
    pytest.importorskip("joblib", reason="sweeps need pip install 'flexel[sweep]'")
    from flexel.examples.stability_map_figures import stability

    assert stability(sweep(6), tmp_path / "map.png").stat().st_size > 10_000
