"""SPACAR's own results read: motions from .sbd, matrices from .sbm, state-space models from .ltv."""

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from click.testing import CliRunner
from mechanisms import DATA
from spacar_binary import ltv, sbd, write

import flexel as fx
from flexel.apps.cli.main import main
from flexel.base.arrays import Array

DECODED = json.loads((DATA / "two_leaf_pivot.json").read_text())
LETTERS = {"point": "p", "frame": "o"}


@pytest.fixture(scope="module")
def motion() -> fx.Motion:
    found = fx.load(DATA / "two_leaf_pivot.sbd")
    assert isinstance(found, fx.Motion)
    return found


@pytest.mark.parametrize("step", ["0", "4", "9"])
def test_coordinates_deformations_and_stresses_are_those_in_the_file(motion: fx.Motion, step: str) -> None:
    """By name, beside the numbers that were decoded independently."""
    state, record = motion[int(step)], DECODED["records"][step]
    for node in state.structure.nodes:
        places = [number - 1 for number in DECODED["LNP"][int(node.name[1:]) - 1] if number]
        assert state.position(node.name).tolist() == [record["X"][place] for place in places], node.name
    for beam in (1, 2, 3):
        for i, name in enumerate(("elongation", "torsion", "bend1", "bend2", "bend3", "bend4")):
            place = DECODED["LE"][beam - 1][i] - 1
            assert state[f"beam{beam}.{name}"] == record["E"][place]
            assert state.force(f"beam{beam}.{name}") == record["SIG"][place]


def test_roles_are_read(motion: fx.Motion) -> None:
    """The degrees of freedom in SPACAR's order, the prescribed coordinate, and what is fixed."""
    assert motion.dofs == tuple(
        f"beam3.{mode}" for mode in ("elongation", "torsion", "bend1", "bend3", "bend4")
    )
    names, roles = motion.structure.names, motion[0].roles
    assert [names[i] for i in roles.prescribed] == ["o8.lambda3"]
    assert {names[i].split(".")[0] for i in roles.rigid} == {"beam2", "o5", "o8"}
    assert [node.name for node in motion.structure.nodes if node.fixed.all()] == ["p1", "o2", "p10", "o11"]


def test_reactions_carry_the_weight(motion: fx.Motion) -> None:
    """Beams of 0.078 and 1.5 kg/m, 0.1 kg on the body, 9.81 m/s²."""
    weight = 9.81 * (0.078 * 0.2 * np.sqrt(2) + 1.5 * 0.1 + 0.1)
    assert motion.force("p1.z") + motion.force("p10.z") == pytest.approx(weight, rel=1e-9)


def test_section_forces_come_from_the_stresses(motion: fx.Motion) -> None:
    """The geometry of a beam is in the file: both ends pull with the reaction of the clamp."""
    clamp = [motion[9].force(f"p1.{axis}") for axis in "xyz"]
    start, end = motion[9].section_forces("beam1")
    for at in (start, end):  # forces at the ends differ by rounding: loads between them are in SPACAR's nodes
        assert np.linalg.norm([at.N, at.Vy, at.Vz]) == pytest.approx(np.linalg.norm(clamp), rel=0.05)


def test_what_is_not_in_the_file_is_refused_by_name(motion: fx.Motion) -> None:
    for attribute, what in (("system", "system.restore"), ("energy", "without energies")):
        with pytest.raises(fx.ModelError, match=what):
            getattr(motion, attribute)
    with pytest.raises(fx.ModelError, match="energy balance"):
        motion.energy_balance()
    with pytest.raises(fx.ModelError, match="no dense output"):
        motion.at(0.5)


def test_the_motion_is_saved_and_drawn_like_any_other(motion: fx.Motion, tmp_path: Path) -> None:
    again = fx.load(motion.save(tmp_path / "again.npz"))
    assert isinstance(again, fx.Motion) and np.array_equal(again.x, motion.x)
    assert "beam2" in motion.view(tmp_path / "x.html").read_text()


def test_matrices_are_those_in_the_file() -> None:
    records = fx.load(DATA / "two_leaf_pivot.sbm")
    assert isinstance(records, fx.SpacarRecords) and len(records) == 10
    for step, record in DECODED["records"].items():
        for tag in ("M0", "K0", "G0"):
            assert records[tag][int(step)].tolist() == record[tag]
    with pytest.raises(fx.ModelError, match="tag 'M'; .*M0"):
        records["M"]
    with pytest.raises(fx.ModelError, match="A, B, C are missing"):
        records.state_space()


def test_state_space_models(tmp_path: Path) -> None:
    """A file of two records, in the format that the description gives."""
    records = fx.load(ltv(tmp_path / "x.ltv"))
    assert isinstance(records, fx.SpacarRecords)
    A, B, C, D = records.state_space(1)
    assert A.tolist() == [[0, 1], [-9, -0.1]]
    assert B.tolist() == [[0], [2]] and C.tolist() == [[1, 0]] and D.tolist() == [[0]]
    assert records.t.tolist() == [0.0, 0.5] and records.constant["NX"] == 2
    with pytest.raises(fx.ModelError, match="record 2 does not exist"):
        records.state_space(2)
    pytest.importorskip("control", reason="python-control is not installed")
    assert records.to_control(0).dcgain() == pytest.approx(0.5)
    pytest.importorskip("xarray", reason="xarray is not installed")
    assert records.to_xarray()["A"].shape == (2, 2, 2)


def test_a_state_space_file_with_all_entries(tmp_path: Path) -> None:
    """Tags, shapes and order as in the description; without DFT, outputs do not see inputs directly."""
    nx, nu, ny, nt = 4, 2, 3, 5
    rng = np.random.default_rng(3)
    shapes = {"A": (nx, nx), "B": (nx, nu), "C": (ny, nx), "D": (ny, nu), "M0": (2, 2), "C0B": (2, 2)}
    shapes |= {"K0B": (2, 2), "U0": (nu, 1), "Y0": (ny, 1)}
    records = {"T": np.arange(nt).reshape(nt, 1, 1) / 10}
    records |= {tag: rng.normal(size=(nt, *shape)) for tag, shape in shapes.items()}
    counts = {"NX": [[nx]], "NU": [[nu]], "NY": [[ny]], "NNOM": [[1]], "NRBM": [[0]], "NYS": [[ny]]}
    for direct in (1, 0):
        constant = {"LTV": "LTV version 0.0", **counts, "DFT": [[direct]], "X0": rng.normal(size=(nx, 1))}
        found = fx.load(write(tmp_path / "a.ltv", constant, records))
        assert isinstance(found, fx.SpacarRecords) and found.t.tolist() == [0.0, 0.1, 0.2, 0.3, 0.4]
        assert {tag: found[tag].shape[1:] for tag in shapes} == shapes
        for tag in shapes:
            assert found[tag].tolist() == records[tag].tolist()
        A, B, C, D = found.state_space(3)
        assert (A == records["A"][3]).all() and (B == records["B"][3]).all() and (C == records["C"][3]).all()
        assert (D == (records["D"][3] if direct else 0)).all() and D.shape == (ny, nu)
        assert found.constant["X0"].shape == (nx, 1) and found.constant["LTV"] == "LTV version 0.0"
        # without D, as without DFT
        kept = {tag: values for tag, values in records.items() if tag != "D"}
        without = fx.load(write(tmp_path / "b.ltv", constant, kept))
        assert isinstance(without, fx.SpacarRecords) and not without.state_space(0)[3].any()
    no_inputs = {
        tag: values[:, :, :0] if tag == "B" else values
        for tag, values in records.items()
        if tag not in ("D", "U0")
    }
    free = fx.load(write(tmp_path / "c.ltv", {"LTV": "LTV", "NU": [[0]]}, no_inputs))
    assert isinstance(free, fx.SpacarRecords) and free.state_space(0)[3].shape == (ny, 0)


def test_elements_of_unknown_type_keep_spacars_numbers(tmp_path: Path) -> None:
    """A motion in the plane; what would evaluate the element says that it is not built in."""
    found = fx.load(sbd(tmp_path / "x.sbd"))
    assert isinstance(found, fx.Motion) and found.dofs == ("p2.y",)
    assert found["element1.e1"] == pytest.approx([0, 0.01, 0.02])
    assert found["force:element1.e1"] == pytest.approx([0, 0.5, 1.0])
    assert found.t.tolist() == [0.0, 0.1, 0.2] and found["p2.x"][-1] == pytest.approx(1.02)
    with pytest.raises(fx.ModelError, match="not built in"):
        found[0].J  # noqa: B018
    assert found.view(tmp_path / "x.html").exists()


def of(found: Any) -> list[Array]:
    """All tables of a motion or of matrices, by record."""
    if isinstance(found, fx.SpacarRecords):
        return [found.t, *found.matrices.values()]
    return [np.array([getattr(state, name) for state in found]) for name in ("x", "v", "e", "stresses")]


@pytest.mark.parametrize("name", ["two_leaf_pivot.sbd", "two_leaf_pivot.sbm"])
def test_damaged_files_are_read_up_to_their_end_or_refused(tmp_path: Path, name: str) -> None:
    """Cut anywhere, with other bytes in the headers, or another file altogether."""
    whole, path = (DATA / name).read_bytes(), tmp_path / name
    theirs = fx.load(DATA / name)
    one = whole.index(b"TDAT") + 20 + (len(whole) - whole.index(b"TDAT") - 20) // 10  # bytes with one record
    rng = np.random.default_rng(1)
    for size in [0, 3, 19, 20, 21, *rng.integers(0, len(whole), 40)]:
        path.write_bytes(whole[: int(size)])
        if size < one:
            with pytest.raises(fx.ModelError, match=r"load '.*SPACAR"):
                fx.load(path)
            continue
        with pytest.warns(fx.IncompleteWarning, match=r"ends after \d of the 10 records"):
            found = fx.load(path)
        parts = zip(of(theirs), of(found), strict=True)
        assert 1 <= len(found) < 10 and all(
            np.array_equal(table[: len(found)], part) for table, part in parts
        )
    for tag in (b"TDEF", b"LNP ", b"M0  "):
        if tag in whole:
            at = whole.index(tag)
            path.write_bytes(whole[:at] + bytes(20) + whole[at + 20 :])
            with pytest.raises(fx.ModelError, match=r"load '"):
                fx.load(path)
    with pytest.raises(fx.ModelError, match="does not exist"):
        fx.load(tmp_path / "none.sbd")


def test_view_of_matrices_is_refused(tmp_path: Path) -> None:
    found = CliRunner().invoke(main, ["view", str(DATA / "two_leaf_pivot.sbm")])
    assert found.exit_code == 2 and "give the .sbd file" in found.output
    out = tmp_path / "x.html"
    assert (
        CliRunner().invoke(main, ["view", str(DATA / "two_leaf_pivot.sbd"), "--out", str(out)]).exit_code == 0
    )
    assert out.exists()


def test_nodes_of_warping_are_named_as_in_an_input_file(tmp_path: Path) -> None:
    """A BEAMW between p1, o2, w3 and p4, o5, w6, one that twists evenly at its free end."""
    x = np.array([0.0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0.5])
    constant = {
        "NXP": [[8, 8, 0, 0, 0]],
        "NEP": [[0, 8, 0, 0, 0]],
        "LNP": [[1, 2, 3, 0], [4, 5, 6, 7], [8, 0, 0, 0], [9, 10, 11, 0], [12, 13, 14, 15], [16, 0, 0, 0]],
        "LE": [[1, 2, 3, 4, 5, 6, 7, 8]],
        "LN": [[1, 2, 3, 4, 5, 6]],
        "IT": [[77]],
        "RL0": [[1.0]],
        "RXYZ": np.zeros((1, 9)),
    }
    nodes = dict.fromkeys(("XD", "XDD", "FXT"), np.zeros((1, 16, 1)))
    modes = dict.fromkeys(("E", "ED", "EDD", "SIG"), np.zeros((1, 8, 1)))
    records = {"T": np.zeros((1, 1, 1)), "X": x.reshape(1, 16, 1)} | nodes | modes
    found = fx.load(write(tmp_path / "a.sbd", constant, records))
    assert isinstance(found, fx.Motion)
    assert found[0]["w6.twist"] == 0.5 and found[0]["w3.twist"] == 0.0
    assert found[0].position("o5").tolist() == [1.0, 0.0, 0.0, 0.0]
