"""Results in files: the same numbers, names and units come back, and a simulation continues from them."""

import json
import pickle
import sys
import tracemalloc
from pathlib import Path

import numpy as np
import pytest
from rides import SUFFIXES, same
from scipy.io import loadmat

import flexel as fx
from flexel.apps.view.drawing import shapes
from flexel.examples.bicycle import bicycle

NAMES = [
    "lean.angle",
    "steer.angle'",
    "rear contact.x''",
    "force:rear.surface",
    "rear.longitudinal'",
    "head.z",
]


@pytest.mark.parametrize("suffix", SUFFIXES)
def test_a_file_gives_back_names_units_times_and_every_number(
    motion: fx.Motion, tmp_path: Path, suffix: str
) -> None:
    read = fx.load(motion.save(tmp_path / f"kick{suffix}"))
    assert isinstance(read, fx.Motion)
    assert np.array_equal(read.t, motion.t)
    assert read.structure.names == motion.structure.names
    for name in NAMES:
        assert np.array_equal(read[name], motion[name]), name
        assert read.unit(name) == motion.unit(name)
    assert read.unit("force:rear.surface") == "N"
    assert read.unit("rear contact.x''") == "m/s²"
    assert np.array_equal(read.position("head"), motion.position("head"))
    assert np.array_equal(read.energy["total"], motion.energy["total"])
    assert (read.statistics, read.message) == (motion.statistics, motion.message)
    assert [name for name, _ in read.events] == [name for name, _ in motion.events]
    assert all(same(a, b) for a, b in zip(read, motion, strict=True))
    assert all(same(a, b) for (_, a), (_, b) in zip(read.events, motion.events, strict=True))


@pytest.mark.parametrize("suffix", SUFFIXES)
def test_a_file_is_saved_again_as_it_was(motion: fx.Motion, tmp_path: Path, suffix: str) -> None:
    first = fx.load(motion.save(tmp_path / f"first{suffix}"))
    second = fx.load(first.save(tmp_path / "second.npz"))
    assert all(same(a, b) for a, b in zip(second, motion, strict=True))


def test_a_motion_from_a_file_needs_no_model_to_be_looked_at(motion: fx.Motion, tmp_path: Path) -> None:
    read = fx.load(motion.save(tmp_path / "kick.nc"))
    for mine, theirs in zip(shapes(read[-1]), shapes(motion[-1]), strict=True):
        assert mine.name == theirs.name
        assert all(np.array_equal(a, b) for a, b in zip(mine.lines, theirs.lines, strict=True))
    assert read.dofs == ("lean.angle", "steer.angle", "rear spin.angle")
    drawn = read.plot(path=tmp_path / "p.png")
    assert [axes.get_ylabel() for axes in drawn.axes] == ["angle [rad]"]
    with pytest.raises(fx.ModelError, match=r"did you mean lean\.angle"):
        read["lean.angel"]
    with pytest.raises(fx.ModelError, match=r"comes from a file.*system\.restore"):
        _ = read.system
    with pytest.raises(fx.ModelError, match="no dense output"):
        read.at(0.1)


# -- other programs -------------------------------------------------------------------------------


def test_matlab_finds_readable_names(motion: fx.Motion, tmp_path: Path) -> None:
    contents = loadmat(motion.save(tmp_path / "kick.mat"), simplify_cells=True)
    assert np.array_equal(contents["time"], motion.t)
    assert np.array_equal(contents["value"]["lean_angle"], motion["lean.angle"])
    assert np.array_equal(contents["force"]["rear_surface"], motion["force:rear.surface"])
    i = list(contents["quantity_names"]).index("rear contact.x")
    assert contents["rate_units"][i] == "m/s"


def test_a_table_has_a_column_with_its_unit_for_every_quantity(motion: fx.Motion, tmp_path: Path) -> None:
    import pandas

    exact = {"float_precision": "round_trip"} if int(pandas.__version__.split(".")[0]) < 3 else {}
    table = pandas.read_csv(motion.save(tmp_path / "kick.csv"), comment="#", **exact)
    for column, values in {
        "time [s]": motion.t,
        "lean.angle [rad]": motion["lean.angle"],
        "rear contact.x'' [m/s²]": motion["rear contact.x''"],
        "force:rear.surface [N]": motion["force:rear.surface"],
    }.items():
        assert table[column].to_numpy() == pytest.approx(values, rel=1e-15, abs=0.0), column


def test_the_matrices_of_a_linearization_are_tables_with_names(tmp_path: Path) -> None:
    lin = bicycle().linearize()
    lines = lin.save(tmp_path / "lin.csv").read_text(encoding="utf-8").splitlines()
    assert lines[1] == "M,lean.angle,steer.angle,rear spin.angle"
    label, *values = lines[3].split(",")
    assert (label, [float(value) for value in values]) == ("steer.angle", lin.M[1].tolist())
    assert lines[5] == "" and lines[6].startswith("C,")


def test_xarray_and_pandas_have_labels_and_units(motion: fx.Motion) -> None:
    whole = motion.to_xarray()
    steer = whole["rate"].sel(quantity="steer.angle")
    assert np.array_equal(steer, motion.rate("steer.angle"))
    assert steer["rate_unit"] == "rad/s"
    assert whole["time"].attrs["units"] == "s"
    few = motion.to_xarray("lean.angle", "force:rear.surface")
    assert few["force:rear.surface"].attrs["units"] == "N"
    frame = motion.to_pandas("lean.angle", "lean.angle''")
    assert frame.index.name == "time"
    assert frame.attrs["units"] == {"time": "s", "lean.angle": "rad", "lean.angle''": "rad/s²"}
    assert np.array_equal(frame["lean.angle''"], motion.acceleration("lean.angle"))
    assert "rear.longitudinal" not in motion.to_pandas()


# -- files that are not results -------------------------------------------------------------------


class Trap:
    """Would be executed by a reader that unpickles."""

    def __reduce__(self) -> tuple[object, tuple[str]]:
        return exec, ("raise SystemExit('executed')",)


def test_nothing_in_a_file_is_executed(motion: fx.Motion, tmp_path: Path) -> None:
    np.savez(tmp_path / "trap.npz", header=np.array([Trap()], dtype=object), allow_pickle=True)
    (tmp_path / "pickle.npz").write_bytes(pickle.dumps(Trap()))
    text = motion.save(tmp_path / "kick.csv").read_text().splitlines()
    (tmp_path / "trap.csv").write_text("\n".join([text[0], text[1], text[2].replace("0.0", "exit()", 1)]))
    for name in ("trap.npz", "pickle.npz", "trap.csv"):
        with pytest.raises(fx.ModelError, match="not a result saved by flexel, or it is damaged") as reported:
            fx.load(tmp_path / name)
        assert "unsafely" not in str(reported.value)  # NumPy would advise to load a pickle


@pytest.mark.parametrize("suffix", SUFFIXES)
def test_damaged_and_foreign_files_are_refused(motion: fx.Motion, tmp_path: Path, suffix: str) -> None:
    path = motion.save(tmp_path / f"kick{suffix}")
    path.write_bytes(path.read_bytes()[: path.stat().st_size // 3])
    foreign = tmp_path / f"foreign{suffix}"
    foreign.write_text("time,x\n0,1\n")
    for file in (path, foreign):
        with pytest.raises(fx.ModelError, match=f"load '{file}'.*damaged"):
            fx.load(file)


def test_missing_files_unknown_suffixes_and_other_versions_are_named(
    motion: fx.Motion, tmp_path: Path
) -> None:
    with pytest.raises(fx.ModelError, match="the file does not exist"):
        fx.load(tmp_path / "nothing.nc")
    with pytest.raises(
        fx.ModelError, match=r"suffix '\.pkl' is unknown; use one of \.nc, \.npz, \.mat, \.csv"
    ):
        motion.save(tmp_path / "kick.pkl")
    header = json.dumps({"format": "flexel result 99"})
    np.savez(tmp_path / "later.npz", header=np.array(header))
    with pytest.raises(fx.ModelError, match="its header is not of the format 'flexel result 2'"):
        fx.load(tmp_path / "later.npz")


@pytest.mark.parametrize(
    ("module", "name"), [("xarray", "kick.nc"), ("h5netcdf", "kick.nc"), ("h5py", "kick.nc")]
)
def test_missing_packages_are_named_with_the_command_that_installs_them(
    motion: fx.Motion, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, module: str, name: str
) -> None:
    monkeypatch.setitem(sys.modules, module, None)
    with pytest.raises(fx.FlexelError, match=rf"needs {module}, .*pip install 'flexel\[xarray\]'"):
        motion.save(tmp_path / name)
    assert fx.load(motion.save(tmp_path / "kick.npz")).t.size == motion.t.size


def test_an_archive_whose_numbers_are_more_than_it_says_is_refused_before_they_are_unpacked(
    motion: fx.Motion, tmp_path: Path
) -> None:
    """Two hundred megabytes of zeros need two hundred kilobytes of a file; memory is counted while it is read."""
    good = motion.save(tmp_path / "kick.npz")
    with np.load(good) as file:
        arrays = {name: file[name] for name in file.files}
    name = next(key for key, values in arrays.items() if key != "header" and values.ndim == 2)
    bad = tmp_path / "bad.npz"
    np.savez_compressed(bad, **(arrays | {name: np.zeros(25_000_000)}))
    assert bad.stat().st_size < 1e6
    tracemalloc.start()
    with pytest.raises(fx.ModelError, match="damaged"):
        fx.load(bad)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert peak < 2e7
