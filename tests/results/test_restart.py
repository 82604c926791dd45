"""Simulations continued from saved results."""

from pathlib import Path

import numpy as np
import pytest
from mechanisms import slider_crank
from rides import SUFFIXES, ride, same

import flexel as fx
from flexel.derive import Internal, Law, Parameter, symbol
from flexel.derive.user_definitions import compile_law
from flexel.examples.bicycle import bicycle

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
    """Without degrees of freedom the integrator has no part in it, and the break leaves no trace."""

    def driven() -> fx.System:
        m = slider_crank("")
        m.lowering.rates.clear()
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


@pytest.mark.filterwarnings("ignore::flexel.base.errors.CoordinateWarning")
def test_the_choice_of_dofs_goes_on(tmp_path: Path) -> None:
    """The slider was exchanged for another degree of freedom near a dead centre; the file knows which."""
    s = slider_crank("B.x").build()
    first = s.simulate(0.0966, samples=5)
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
    """Accelerations are those of the continuing model, unless the saved ones are requested."""

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
    with pytest.raises(fx.ModelError, match="restore: str is not a motion or a state"):
        s.restore("fall.npz")  # type: ignore[arg-type]


def test_a_state_of_another_model_is_refused_by_name(motion: fx.Motion, tmp_path: Path) -> None:
    read = fx.load(motion.save(tmp_path / "kick.npz"))
    with pytest.raises(
        fx.ModelError, match="only one of the saved state and this model has 'crank hinge.angle'"
    ):
        slider_crank("").build().restore(read)
    free = slider_crank("B.x").build().simulate(0.05, samples=3)
    held = slider_crank("")
    held.lowering.rates.clear()
    held.prescribe("crank hinge.angle", lambda t: 0 * t)
    with pytest.raises(
        fx.ModelError, match=r"restore: the saved state has the degrees of freedom \('B\.x',\)"
    ):
        held.build().restore(free)


def test_a_state_of_a_model_with_other_dimensions_is_refused_by_name() -> None:
    """A rod of 1 m in a model whose rod has 2 m: before, the state was handed over with the rod cut to half."""

    def pendulum(length: float, mass: float = 1.0) -> fx.System:
        m = fx.Model(gravity=(0, -9.81))
        m.point("O", (0, 0), fixed=True)
        m.point("A", (0.6 * length, -0.8 * length))
        m.truss("rod", "O", "A")
        m.point_mass("mass", "A", mass)
        return m.build()

    motion = pendulum(1.0).simulate(1.0, samples=3)
    assert pendulum(1.0, mass=5.0).restore(motion)["A.x"] == motion["A.x"][-1]  # the same positions
    for as_saved in (False, True):
        with pytest.raises(
            fx.ModelError, match=r"does not fit this model: the rigid 'rod\.elongation' would be -1"
        ):
            pendulum(2.0).restore(motion, as_saved=as_saved)
