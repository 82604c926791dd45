"""Results in files: the same numbers, names and units come back, and a simulation goes on from them."""

import json
import pickle
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from mechanisms import slider_crank
from scipy.io import loadmat

import flexel as fx
from flexel.derive.compile import compile_law
from flexel.derive.element import Internal, Law, Parameter, symbol
from flexel.examples.bicycle import bicycle, kick
from flexel.pictures.drawing import shapes

SUFFIXES = [".npz", ".nc", ".mat", ".csv"]
NAMES = [
    "lean.angle",
    "steer.angle'",
    "rear contact.x''",
    "force:rear.surface",
    "rear.longitudinal'",
    "head.z",
]
ARRAYS = ("x", "v", "a", "e", "J", "stress", "reactions", "z", "zd", "Phi_v")


def ride(duration: float, samples: int, **options: Any) -> fx.Motion:
    """A bicycle with rolling wheels at 4.5 m/s after a kick."""
    system = bicycle()
    return system.simulate(duration, start=kick(system, 4.5, 0.05)[0], samples=samples, **options)


@pytest.fixture(scope="module")
def motion() -> fx.Motion:
    """It steers through a given angle on the way."""
    motion = ride(0.5, 9, events=[fx.Event("steered", lambda state: state["steer.angle"] - 0.01)])
    assert motion.events
    return motion


def same(a: fx.State, b: fx.State) -> bool:
    """Whether two states are equal, bit for bit."""
    equal = all(np.array_equal(getattr(a, name), getattr(b, name)) for name in ARRAYS)
    return equal and (a.t, a.energy, a.drift, a.dissipated) == (b.t, b.energy, b.drift, b.dissipated)


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
    assert read.freedoms == ("lean.angle", "steer.angle", "rear spin.angle")
    drawn = read.plot(path=tmp_path / "p.png")
    assert [axes.get_ylabel() for axes in drawn.axes] == ["[rad]"]
    with pytest.raises(fx.ModelError, match=r"did you mean lean\.angle"):
        read["lean.angel"]
    with pytest.raises(fx.ModelError, match=r"comes from a file.*system\.restore"):
        _ = read.system
    with pytest.raises(fx.ModelError, match="no dense output"):
        read.at(0.1)


# -- going on -------------------------------------------------------------------------------------


@pytest.mark.parametrize("suffix", SUFFIXES)
def test_a_simulation_goes_on_from_a_file_bit_for_bit(tmp_path: Path, suffix: str) -> None:
    """The second half from the file equals the second half from memory; and both the run without a break."""
    options = {"rtol": 1e-12, "atol": 1e-13}
    first = ride(0.4, 5, **options)
    path = first.save(tmp_path / f"half{suffix}")
    another = bicycle()  # as in a new process
    state = another.restore(fx.load(path))
    assert same(state, first[-1])
    later = another.simulate(0.4, start=state, samples=5, **options)
    assert np.array_equal(later.x, first.system.simulate(0.4, start=first[-1], samples=5, **options).x)
    whole = ride(0.8, 9, **options)
    assert np.max(np.abs(later.x - whole.x[4:])) < 2e-11


def test_a_prescribed_motion_goes_on_to_the_same_digits(tmp_path: Path) -> None:
    """Without freedoms the integrator has no part in it, and the break leaves no trace."""

    def driven() -> fx.System:
        m = slider_crank("")
        m._rates.clear()
        m.prescribe("crank hinge.angle", lambda t: 9.0 * t + 0.2 * np.sin(3 * t))
        return m.build()

    system = driven()
    path = system.simulate(1.0, samples=51).save(tmp_path / "half.csv")
    other = driven()
    later = other.simulate(1.0, start=other.restore(fx.load(path)), samples=51)
    whole = system.simulate(2.0, times=later.t)
    assert later["crank hinge.angle"][-1] > 2 * np.pi
    for name in ("crank hinge.angle", "B.x", "B.x''", "force:crank hinge.angle"):
        scale = np.max(np.abs(whole[name]))
        assert np.max(np.abs(later[name] - whole[name][-51:])) < 1e-13 * scale, name


def test_the_choice_of_freedoms_goes_on(tmp_path: Path) -> None:
    """The slider was exchanged for another freedom near a dead centre; the file knows which."""
    s = slider_crank("B.x").build()
    first = s.simulate(0.1, samples=5)
    assert first.statistics["rechoices"] == 1
    assert first[-1].roles is not s.roles
    other = slider_crank("B.x").build()
    state = other.restore(fx.load(first.save(tmp_path / "first.npz")))
    assert np.array_equal(state.roles.dynamic, first[-1].roles.dynamic)
    later = other.simulate(0.3, start=state, samples=5)
    assert np.array_equal(later.x, s.simulate(0.3, start=first[-1], samples=5).x)
    assert other.dynamic == ("B.x",)


def test_turns_of_a_wound_spring_go_on(tmp_path: Path) -> None:
    """A torsion spring wound by many turns has its torque in the file."""

    def rotor() -> fx.System:
        m = fx.Model()
        m.point("O", (0, 0, 0), fixed=True)
        m.frame("R0", fixed=True)
        m.frame("R1")
        m.hinge("axle", "R0", "R1", axis=(0, 0, 1), stiffness=0.02)
        m.body("rotor", "O", "R1", mass=1.0, inertia=(0.5, 0.5, 0.5))
        m.initial("axle.angle", rate=20.0)
        return m.build()

    s = rotor()
    first = s.simulate(4.0, samples=11, rtol=1e-11, atol=1e-9)
    state = rotor().restore(fx.load(first.save(tmp_path / "wound.mat")), 2.0)
    assert state["axle.angle"] == first[5]["axle.angle"] > 5 * np.pi
    assert state.force("axle.angle") == first[5].force("axle.angle")
    w = np.sqrt(0.02 / 0.5)
    later = s.simulate(4.0, start=s.restore(state), samples=5, rtol=1e-11, atol=1e-9)
    assert np.max(np.abs(later["axle.angle"] - 20 / w * np.sin(w * later.t))) < 1e-6


def test_internal_states_of_laws_go_on(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A Maxwell element remembers in the file how far its dashpot has crept."""
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    e, z, k = symbol("e"), symbol("creep"), Parameter("k", 1, "N/m", "stiffness")
    states = (Internal("creep", "m", (e - z) / 0.3),)
    spring = k.symbol * (e - z)
    law = compile_law(
        Law(
            "maxwell",
            "in series",
            (k,),
            (e,),
            (symbol("ed"),),
            (),
            (spring,),
            (),
            states=states,
        )
    )

    def oscillator() -> fx.System:
        m = fx.Model()
        m.point("O", (0, 0, 0), fixed=True)
        m.point("A", (1, 0, 0))
        m.fix("A.y", "A.z")
        m.truss("bar", "O", "A")
        m.point_mass("mass", "A", 2.0)
        m.law(["bar.elongation"], law, name="damper", k=50.0)
        m.initial("A.x", 1.1)
        return m.build()

    for suffix in SUFFIXES:
        first = oscillator().simulate(0.5, samples=6)
        read = fx.load(first.save(tmp_path / f"crept{suffix}"))
        assert np.array_equal(read["damper.creep"], first["damper.creep"])
        assert np.array_equal(read["damper.creep'"], first["damper.creep'"])
        assert (read.unit("damper.creep"), read.unit("damper.creep'")) == ("m", "m/s")
        again = oscillator()
        later = again.simulate(0.5, start=again.restore(read), samples=6)
        from_memory = first.system.simulate(0.5, start=first[-1], samples=6)
        assert np.array_equal(later["damper.creep"], from_memory["damper.creep"])
    saved = oscillator().linearize()
    read_lin = fx.load(saved.save(tmp_path / "lin.nc"))
    assert np.array_equal(read_lin.state_matrix, saved.state_matrix)
    assert read_lin.internal == ("damper.creep",)


def test_a_changed_load_counts_from_the_restart_on(tmp_path: Path) -> None:
    """Accelerations are those of the model that goes on, unless the saved ones are asked for."""

    def stone(push: float) -> fx.System:
        m = fx.Model(gravity=(0, 0, -9.81))
        m.point("P", (0, 0, 2.0))
        m.point_mass("stone", "P", 0.5)
        m.load("P.x", push)
        return m.build()

    read = fx.load(stone(0.0).simulate(0.5, samples=3).save(tmp_path / "fall.npz"))
    s = stone(3.0)
    assert s.restore(read).acceleration("P.x") == pytest.approx(6.0)
    assert s.restore(read, as_saved=True).acceleration("P.x") == 0.0
    assert s.restore(read, 0.25)["P.z"] == read[1]["P.z"]
    with pytest.raises(fx.ModelError, match=r"no state is stored at t = 0\.3 s; the nearest time is 0\.25 s"):
        s.restore(read, 0.3)
    with pytest.raises(fx.ModelError, match=r"another model; .*system\.restore"):
        s.simulate(1.0, start=read[-1])
    with pytest.raises(fx.ModelError, match="restore: str is no motion or state"):
        s.restore("fall.npz")  # type: ignore[arg-type]


def test_a_state_of_another_model_is_refused_by_name(motion: fx.Motion, tmp_path: Path) -> None:
    read = fx.load(motion.save(tmp_path / "kick.npz"))
    with pytest.raises(
        fx.ModelError, match="only one of the saved state and this model has 'crank hinge.angle'"
    ):
        slider_crank("").build().restore(read)
    free = slider_crank("B.x").build().simulate(0.05, samples=3)
    held = slider_crank("")
    held._rates.clear()
    held.prescribe("crank hinge.angle", lambda t: 0 * t)
    with pytest.raises(fx.ModelError, match=r"restore: the saved state has the freedoms \('B\.x',\)"):
        held.build().restore(free)


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

    table = pandas.read_csv(motion.save(tmp_path / "kick.csv"), comment="#")
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
    assert (label, [float(z) for z in values]) == ("steer.angle", lin.M[1].tolist())
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


# -- files that are no results --------------------------------------------------------------------


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
        with pytest.raises(fx.ModelError, match="no result saved by flexel, or it is damaged") as told:
            fx.load(tmp_path / name)
        assert "unsafely" not in str(told.value)  # NumPy would advise to load a pickle


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
    with pytest.raises(fx.ModelError, match="there is no such file"):
        fx.load(tmp_path / "nothing.nc")
    with pytest.raises(
        fx.ModelError, match=r"suffix '\.pkl' is unknown; use one of \.nc, \.npz, \.mat, \.csv"
    ):
        motion.save(tmp_path / "kick.pkl")
    header = json.dumps({"format": "flexel result 99"})
    np.savez(tmp_path / "later.npz", header=np.array(header))
    with pytest.raises(fx.ModelError, match="its header is not of the format 'flexel result 1'"):
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
