"""Modes of a flexure over its load steps are followed by their shapes, in the figure and in its legend."""

import flexure_tables as tables
import numpy as np
import pytest
from coarse import COARSE_MESH

import flexel as fx
from flexel.linear.tracking import Branches

LOAD = np.linspace(0, 1, 5)


def listed(rows: list[dict[int, float]]) -> tuple[np.ndarray, np.ndarray]:
    """Values in increasing order, and unit shapes of the modes by their numbers, in the same order."""
    ordered = [sorted(row.items(), key=lambda pair: pair[1]) for row in rows]
    values = np.array([[f for _, f in row] for row in ordered])
    return values, np.array([[np.eye(4)[k] for k, _ in row] for row in ordered])


def test_modes_that_cross_keep_their_shapes_and_names() -> None:
    rows = [{0: 1 + 2 * p, 1: 2.0, 2: 2.5 - p} for p in LOAD]
    values, shapes = listed(rows)
    found = Branches.of_shapes(LOAD, values, shapes, ["a", "b", "c", "d"])
    assert found.names == ["a", "b", "c"]
    for j, k in enumerate((0, 1, 2)):
        assert found.eigenvalues[:, j].real == pytest.approx([row[k] for row in rows])


def test_a_mode_that_leaves_the_list_ends_and_the_one_that_enters_begins() -> None:
    rows = [{0: 1.0, 1: 2.0} if p < 0.6 else {0: 1.0, 3: 1.9} for p in LOAD]
    found = Branches.of_shapes(LOAD, *listed(rows), ["a", "b", "c", "d"])
    assert found.names == ["a", "b", "d"]
    assert np.isnan(found.eigenvalues[:, 1]).tolist() == [False, False, False, True, True]
    assert np.isnan(found.eigenvalues[:, 2]).tolist() == [True, True, True, False, False]


def test_steps_without_modes_stay_unknown() -> None:
    values, shapes = listed([{0: 1.0, 1: 2.0}] * 5)
    values[[0, 2]] = np.nan
    shapes[[0, 2]] = np.nan
    found = Branches.of_shapes(LOAD, values, shapes, ["a", "b", "c", "d"])
    assert found.names == ["a", "b"]
    assert np.isnan(found.eigenvalues[:, 0]).tolist() == [True, False, True, False, False]
    none = Branches.of_shapes(LOAD, np.full((5, 2), np.nan), np.full((5, 2, 4), np.nan), list("abcd"))
    assert none.eigenvalues.shape == (5, 0) and none.names == []


@COARSE_MESH
def test_the_figure_has_a_line_for_each_mode_by_name() -> None:
    """A cross hinge that is turned: its torsional mode comes down from the third place to the first."""
    pytest.importorskip("matplotlib", reason="pictures need pip install 'flexel[plot]'")
    hinge = fx.flexure(
        *tables.hinge(tables.IDEAL, moment=(0, 0, 0.6)), {"steps": 8, "frequencies": 4, "buckling": 0}
    )
    panel = next(axes for axes in hinge.plot().axes if axes.get_ylabel() == "frequency [Hz]")
    f = hinge.frequencies[:, :3]
    lines = {line.get_label(): np.asarray(line.get_ydata()) for line in panel.lines}
    drawn = np.sort(np.array(list(lines.values())), axis=0)[:3].T  # NaN last
    assert np.allclose(drawn, f)
    assert all(name.partition(": ")[2] for name in lines)
    places = [
        {int(np.argmin(abs(hinge.frequencies[i] - f))) for i, f in enumerate(line) if np.isfinite(f)}
        for line in lines.values()
    ]
    assert any(len(columns) > 1 for columns in places)  # two cross, and keep their lines
