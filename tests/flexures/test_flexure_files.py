"""Results of flexure mechanisms in files, tables and pictures."""

from pathlib import Path
from typing import Any

import flexure_tables as tables
import numpy as np
import pytest
from coarse import COARSE_MESH

import flexel as fx

OPTIONS: dict[str, Any] = {"steps": 2, "compliance": [5], "frequencies": 3, "buckling": 2}


@pytest.fixture(scope="module")
def found() -> fx.Flexure:
    return fx.flexure(*tables.guide(tables.IDEAL, force=(2.0, 0, 0), force_initial=(0, -5.0, 0)), OPTIONS)


@pytest.mark.parametrize("suffix", [".nc", ".npz", ".mat", ".csv"])
def test_a_file_gives_back_every_result(found: fx.Flexure, suffix: str, tmp_path: Path) -> None:
    if suffix == ".nc":
        pytest.importorskip("xarray", reason="files .nc need pip install 'flexel[xarray]'")
    read = fx.load(found.save(tmp_path / f"guide{suffix}"))
    assert isinstance(read, fx.Flexure)
    assert read.variables.keys() == found.variables.keys()
    for name, variable in found.variables.items():
        assert np.array_equal(read.variables[name].values, variable.values, equal_nan=True), name
    assert (read.released, read.redundant, read.notes) == (found.released, found.redundant, found.notes)
    assert str(read) == str(found)
    a, b = read.steps[-1], found.steps[-1]
    assert a.element(1).mises == pytest.approx(b.element(1).mises)
    assert a.element(1).at == b.element(1).at
    compliance = a.node(5).compliance
    assert compliance is not None and compliance.directions[1] == "y"
    with pytest.raises(fx.ModelError, match="has no system"):
        a.linearize()


def test_the_dataset_is_labelled(found: fx.Flexure) -> None:
    pytest.importorskip("xarray", reason="datasets need pip install 'flexel[xarray]'")
    data = found.to_xarray()
    last = data.isel(time=-1)
    step = found.steps[-1]
    assert float(last.position.sel(node="5", component="x")) == step.node(5).position[0]
    assert float(last.euler_angles.sel(node="5", turn="about z")) == step.node(5).euler_angles[0]
    own = step.node(5).compliance
    assert own is not None
    picked = last.compliance_body.sel(node="5", direction="x", load_direction="force y")
    assert float(picked) == pytest.approx(own.in_body[0, 1], rel=1e-12)
    assert np.isnan(last.compliance.sel(node="2")).all()
    assert float(last.stress.sel(element="1")) == pytest.approx(step.element(1).mises)
    assert np.isnan(last.stress.sel(element="2")) and np.isnan(step.element(2).mises)
    assert data.frequency.attrs["units"] == "Hz" and data.mode_shape.sizes["mode"] == 3


def test_arrays_and_steps_hold_the_same(found: fx.Flexure) -> None:
    step = found.steps[1]
    node = step.node(5)
    assert found.load.tolist() == [0.0, 0.5, 1.0] and found.message == "" and len(found) == 3
    for array, value in (
        (found.positions, node.position),
        (found.displacements, node.displacement),
        (found.quaternions, node.quaternion),
        (found.euler_angles, node.euler_angles),
        (found.forces, node.force),
        (found.moments, node.moment),
    ):
        assert array[1, 4].tolist() == value.tolist()
    assert node.compliance is not None
    assert found.compliance(5, body_axes=True)[1] == pytest.approx(node.compliance.in_body, rel=0)
    assert np.nanmax(found.stress[1]) == step.largest_stress
    assert found.frequencies[1].tolist() == step.frequencies.tolist()
    assert found.buckling[1].tolist() == step.buckling.tolist()
    assert step.state["node 5.x"] == node.position[0]
    assert step.element(1).safety == pytest.approx(1100e6 / step.element(1).mises)


def test_pictures_and_pages_are_written(found: fx.Flexure, tmp_path: Path) -> None:
    pytest.importorskip("matplotlib", reason="pictures need pip install 'flexel[plot]'")
    found.plot(path=tmp_path / "plot.png")
    found.plot(2, 5, path=tmp_path / "nodes.png")
    found.plot_shapes(0, 2, path=tmp_path / "shapes.png")
    found.steps[-1].plot_mode(2, tmp_path / "mode.png")
    found.view(tmp_path / "steps.html")
    found.steps[-1].view_modes(tmp_path / "modes.html")
    assert (
        all(path.stat().st_size > 5000 for path in tmp_path.iterdir()) and len(list(tmp_path.iterdir())) == 6
    )
    with pytest.raises(fx.ModelError, match="step 3; give a whole number, at most 2"):
        found.plot_shapes(3)


@COARSE_MESH
def test_a_displacement_out_of_reach_ends_the_steps_with_a_message() -> None:
    """A rigid arm of 50 mm on a rod that can only twist does not reach 80 mm to the side."""
    rod = tables.leaf([1], 1, [2]) | {"orientation": (1, 0, 0)}
    rows: dict[int, Any] = {1: {"fixed": True}, 3: {"displacement": {"x": 0.08}}}
    nodes = [[0, 0, 0], [0, 0, 0.1], [0, 0.05, 0.1]]
    with pytest.warns(fx.IncompleteWarning, match="stopped after step 2 of 4, at 0.5 of the loads"):
        found = fx.flexure(nodes, [[1, 2], [2, 3]], rows, [rod], {"steps": 4})
    assert len(found) == 3 and found.steps[-1].node(3).displacement[0] == pytest.approx(0.04)
    assert found.message in str(found)
