"""Variants of a system side by side: motions, linearized equations, root loci."""

import pickle
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import flexel as fx
from flexel.examples import bicycle_data as data
from flexel.examples.bicycle import bicycle, lean_steer, rolling
from flexel.examples.stable_speeds import LEAN_STEER
from flexel.examples.vehicle_runs import straight
from flexel.mechanics.modes import sort_eigenvalues
from flexel.results.analyses import variant_runs

RIDER = "frame and rider"


def oscillator(mass: float = 2.0, stiffness: float = 50.0, damping: float = 0.3) -> fx.System:
    m = fx.Model(gravity=(0, -9.81))
    m.point("O", (0, 0), fixed=True)
    m.point("A", (1, 0))
    m.angle("ground", fixed=True)
    m.angle("turn")
    m.hinge("pivot", "ground", "turn")
    m.beam("rod", "O", "turn", "A", mass_per_length=0.5)
    m.point_mass("bob", "A", mass)
    m.spring("pivot.angle", stiffness, damping)
    return m.build()


def rolled(system: fx.System) -> fx.State:
    return rolling(system, data.M1_SPEED, data.ROLL_RATE)


def test_variants_move_as_models_that_are_built_with_their_parameters() -> None:
    masses, stiffness, rates = [1.0, 2.0, 5.0], [20.0, 50.0, 90.0], [0.0, 1.0, -2.0]
    found = oscillator().simulate_many(
        2.0,
        parameters={"bob.mass": masses, "pivot.angle.stiffness": stiffness, "pivot.angle.damping": 0.1},
        initial={"pivot.angle'": rates},
        outputs=["pivot.angle", "pivot.angle'", "A.y''", "force:pivot.angle"],
        samples=5,
    )
    assert not found.failed and len(found) == 3
    for i, (m, k, rate) in enumerate(zip(masses, stiffness, rates, strict=True)):
        s = oscillator(m, k, 0.1)
        motion = s.simulate(2.0, start=s.state_at(rates={"pivot.angle": rate}), samples=5)
        for name in found.names:
            assert found[name][i] == pytest.approx(motion[name], rel=1e-9, abs=1e-9), (i, name)


def test_the_digits_depend_neither_on_threads_nor_on_neighbours() -> None:
    s = bicycle()
    start, masses = rolled(s), np.linspace(60, 110, 7)

    def steer(chosen: np.ndarray, threads: int) -> np.ndarray:
        found = s.simulate_many(
            1.0, parameters={f"{RIDER}.mass": chosen}, start=start, samples=3, threads=threads
        )
        return found["steer.angle"]

    one = steer(masses, 1)
    assert len(np.unique(one[:, -1])) == 7
    assert np.array_equal(one, steer(masses, 3))
    assert np.array_equal(one[::-1], steer(masses[::-1], 2))
    assert np.array_equal(one[3:4], steer(masses[3:4], 1))


def test_a_variant_is_the_system_with_its_parameters() -> None:
    s = bicycle()
    found = s.simulate_many(0.5, parameters={f"{RIDER}.mass": [70.0, 90.0]}, start=rolled(s), samples=3)
    again = found.motion(1)
    assert np.array_equal(again["lean.angle"], found["lean.angle"][1])
    assert again.system.parameters[f"{RIDER}.mass"] == 90.0
    assert s.parameters[f"{RIDER}.mass"] == 85.0 and found.motion(-1)[-1].t == 0.5
    heavy = s.with_parameters({f"{RIDER}.mass": 90.0})
    direct = heavy.simulate(0.5, start=rolled(heavy), samples=3)
    assert direct["lean.angle"] == pytest.approx(found["lean.angle"][1], rel=1e-9)
    for copied in (pickle.loads(pickle.dumps(system)) for system in (heavy, heavy.with_parameters({}))):
        assert copied.parameters[f"{RIDER}.mass"] == 90.0
        assert copied.linearize().M == pytest.approx(heavy.linearize().M, rel=1e-12)
    assert np.array_equal(pickle.loads(pickle.dumps(found)).motion(0)["lean.angle"], found["lean.angle"][0])


def test_every_element_of_a_type_has_its_own_parameters() -> None:
    """Ten point masses fill one block of eight lanes and begin another; the last one fills it."""
    m = fx.Model(gravity=(0, -9.81))
    for i in range(10):
        m.point(f"P{i}", (float(i), 0.0))
        m.point_mass(f"mass{i}", f"P{i}", 1.0)
        m.spring(f"P{i}.y", 100.0)
    m.independent(*(f"P{i}.{axis}" for i in range(10) for axis in "xy"))
    s = m.build()
    for i in (0, 7, 8, 9):
        lin = s.with_parameters({f"mass{i}.mass": 3.0, f"P{i}.y.stiffness": 7.0}).linearize()
        expected = {f"P{j}.y": 3.0 if j == i else 1.0 for j in range(10)}
        for name, mass in expected.items():
            k = lin.dynamic.index(name)
            assert lin.M[k, k] == mass and lin.K[k, k] == (7.0 if mass == 3.0 else 100.0)


def test_one_entry_of_a_parameter_and_the_second_law_of_a_name() -> None:
    s = oscillator()
    assert s.with_parameters({"bob.gravity[1]": -1.62}).parameters["bob.gravity"].tolist() == [0, -1.62]
    m = fx.Model()
    m.point("A", (0, 0))
    m.point_mass("bob", "A", 1.0)
    m.spring("A.x", 3.0)
    m.spring("A.x", 4.0)
    both = m.build().with_parameters({"A.x.stiffness": 5.0, "A.x#2.stiffness": 6.0})
    assert both.linearize().K[0, 0] == pytest.approx(11.0)


def test_variants_that_fail_are_named_and_the_others_kept() -> None:
    m = fx.Model(gravity=(0, -9.81))
    for name, x in (("A", (0, 0)), ("B", (0.3, 0)), ("C", (1.0, 0.8)), ("D", (1.2, 0))):
        m.point(name, x, fixed=name in "AD")
    for bar in ("AB", "BC", "CD"):
        m.truss(bar, *bar, mass_per_length=1.0)
    m.independent("C.x")
    with pytest.warns(fx.IncompleteWarning, match="1 of 3"):
        found = m.build().simulate_many(0.1, initial={"C.x": [1.0, 50.0, 0.95]}, samples=2)
    assert list(found.failed) == [1] and "C.x" in found.failed[1]
    assert np.isnan(found["C.x"][1]).all() and np.isfinite(found["C.x"][[0, 2]]).all()
    assert found.statistics[1] == {} and found.statistics[2]["steps"] > 0
    with pytest.raises(fx.PositionError, match=r"C\.x"):
        found.motion(1)


def test_an_interrupt_keeps_what_is_done(monkeypatch: pytest.MonkeyPatch) -> None:
    one, done = variant_runs.Runner._one, []

    def interrupted(self: variant_runs.Runner, system: object, variant: object, i: int) -> None:
        if i == 2:
            raise KeyboardInterrupt
        one(self, system, variant, i)
        done.append(i)

    monkeypatch.setattr(variant_runs.Runner, "_one", interrupted)
    with pytest.warns(fx.IncompleteWarning, match="2 of 4 .*interrupted"):
        found = oscillator().linearize_many(parameters={"bob.mass": [1.0, 2.0, 3.0, 4.0]}, threads=1)
    assert done == [0, 1] and list(found.failed) == [2, 3] and "interrupted" in found.failed[3]
    assert np.isfinite(found.M[1]).all()


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"parameters": {"bob.mas": [1.0]}}, r"unknown parameter 'bob.mas'; did you mean bob.mass"),
        ({"parameters": {"rod.d0": [[1.0, 0.0], [1.1, 0.0]]}}, r"'rod.d0' changes the geometry.*fx.sweep"),
        (
            {"parameters": {"bob.mass": [1.0, 2.0], "pivot.angle.damping": [0.0] * 3}},
            r"differ: 'bob.mass' 2, 'pivot",
        ),
        (
            {"parameters": {"bob.gravity": [1.0, 2.0, 3.0]}},
            r"give \(variants, 2\); name one entry as 'bob.gravity\[0\]'",
        ),
        ({"parameters": {"bob.gravity[2]": 1.0}}, r"numbered from 0 to 1"),
        ({"parameters": {"pivot.angle.damping": [0.1, -0.1]}}, r"variant 1: 'pivot.angle'.*damping|D"),
        ({"parameters": {"bob.mass": "heavy"}}, r"parameter 'bob.mass'"),
        ({"parameters": [1.0]}, r"must be given by name"),
        ({"initial": {"pivot.angle": [[1.0]]}}, r"one number for each variant"),
        ({"threads": 0}, r"threads 0; give a whole number"),
        ({"outputs": ["rod.angel"]}, r"unknown name 'rod.angel'"),
        ({"relative": 1e-3}, r"unknown option 'relative'"),
    ],
)
def test_bad_input_is_named(arguments: dict, message: str) -> None:
    with pytest.raises(fx.ModelError, match=message):
        oscillator().simulate_many(0.1, **arguments)


def test_a_negative_mass_fails_and_a_new_mass_is_refused() -> None:
    with pytest.warns(fx.IncompleteWarning, match="1 of 2"):
        found = oscillator().simulate_many(0.1, parameters={"bob.mass": [1.0, -1.0]}, samples=2)
    assert list(found.failed) == [1] and "negative mass" in found.failed[1]
    with pytest.raises(
        fx.ModelError, match=r"'weightless.rhoA': the element has no mass in the system as built"
    ):
        m = fx.Model()
        for name, x in (("A", (0, 0)), ("B", (1, 0)), ("C", (2, 0))):
            m.point(name, x, fixed=name == "A")
        m.truss("heavy", "A", "B", mass_per_length=1.0)
        m.truss("weightless", "B", "C")
        m.point_mass("bob", "C", 1.0)
        m.build().with_parameters({"weightless.rhoA": 1.0})


def test_linearized_variants_are_those_of_single_systems() -> None:
    s, masses = oscillator(), [1.0, 2.0, 5.0]
    found = s.linearize_many(lambda system: system.equilibrium(), parameters={"bob.mass": masses})
    for i, mass in enumerate(masses):
        one = s.with_parameters({"bob.mass": mass})
        lin = one.linearize(one.equilibrium())
        assert found.M[i] == pytest.approx(lin.M, rel=1e-12) and found.K[i] == pytest.approx(lin.K, rel=1e-9)
        assert found.linearization(i).M == pytest.approx(lin.M, rel=1e-12)
    w = found.eigenvalues()
    assert w.shape == (3, 2) and sort_eigenvalues(w[2]) == pytest.approx(lin.eigenvalues(), rel=1e-9)
    with pytest.raises(fx.ModelError, match="give rates, or a function"):
        s.linearize_many(lambda system: system.equilibrium(), rates={"pivot.angle": [1.0]})
    with pytest.raises(fx.ModelError, match="variant 3; give a number from 0 to 2"):
        found.linearization(3)


def test_linearization_with_tyres_and_internal_states_at_many_speeds() -> None:
    s, state = straight(20.0)
    found = s.linearize_many(state)
    lin = s.linearize(state)
    for name in ("M", "C", "K", "A_k", "B_k", "Z", "Z_v", "Z_q", "Z_z"):
        assert getattr(found, name)[0] == pytest.approx(getattr(lin, name), rel=1e-9, abs=1e-9), name
    assert found.state_matrices[0] == pytest.approx(lin.state_matrix, rel=1e-9, abs=1e-9)


def test_root_loci_of_the_bicycle_are_the_published_ones(tmp_path: Path) -> None:
    s = bicycle()
    speeds = np.linspace(0.5, 10, 20)
    still = np.zeros(20)
    rates = {"rear hub.x": speeds, "lean.angle": still, "steer.angle": still}
    loci = s.root_loci(rates=rates, of=LEAN_STEER)
    M, C1, K0, K2 = (np.array(matrix) for matrix in (data.M, data.C1, data.K0, data.K2))
    for v, w in zip(speeds, loci.eigenvalues, strict=True):
        K = data.BENCHMARK["g"] * K0 + v**2 * K2
        A = np.block([[np.zeros((2, 2)), np.eye(2)], [-np.linalg.solve(M, K), -np.linalg.solve(M, v * C1)]])
        assert sort_eigenvalues(w) == pytest.approx(sort_eigenvalues(np.linalg.eigvals(A)), abs=2e-8)
        assert sort_eigenvalues(w) == pytest.approx(lean_steer(s, float(v)).eigenvalues(), rel=1e-10)
    assert np.flatnonzero(loci.stable).tolist() == [8, 9, 10, 11]
    assert np.abs(np.diff(loci.eigenvalues, axis=0)).max() < 3  # no column jumps to another branch
    loci.plot(tmp_path / "loci.png")
    assert (tmp_path / "loci.png").stat().st_size > 5_000
    both = s.root_loci(rates=rates, parameters={f"{RIDER}.mass": [85.0, 100.0]}, of=LEAN_STEER)
    assert both.eigenvalues.shape == (2, 20, 4) and np.array_equal(both.eigenvalues[0], loci.eigenvalues)


def test_root_loci_over_a_parameter_and_its_labels() -> None:
    pytest.importorskip("xarray", reason="labelled tables need pip install 'flexel[xarray]'")
    stiffness = np.linspace(20, 80, 13)
    loci = oscillator().root_loci(parameters={"pivot.angle.stiffness": stiffness})
    table = loci.to_xarray()
    assert np.array_equal(table["pivot.angle.stiffness"], stiffness) and table.branch_im.dims == (
        "variant",
        "branch",
    )
    assert np.abs(loci.eigenvalues[:, 0] * loci.eigenvalues[:, 1]).argmax() == 12
    with pytest.raises(fx.ModelError, match="give rates or parameters"):
        oscillator().root_loci()


def test_an_ensemble_as_a_labelled_table() -> None:
    pytest.importorskip("xarray", reason="labelled tables need pip install 'flexel[xarray]'")
    with pytest.warns(fx.IncompleteWarning, match="1 of 2"):
        found = oscillator().simulate_many(
            0.2, parameters={"bob.mass": [1.0, -1.0], "bob.gravity": [[0, -1], [0, -2]]}
        )
    table = found.to_xarray()
    assert table["pivot.angle"].dims == ("variant", "time") and table["pivot.angle"].units == "rad"
    assert table["bob.mass"].values.tolist() == [1.0, -1.0] and "negative mass" in str(table.failed.values[1])
    assert table["bob.gravity"].shape == (2, 2)
    with pytest.raises(fx.ModelError, match="unknown quantity that was kept 'A.y'.*outputs"):
        found["A.y"]


@pytest.mark.parametrize(
    "call",
    [
        lambda s, parameters: s.simulate_many(0.1, parameters=parameters),
        lambda s, parameters: s.linearize_many(parameters=parameters),
        lambda s, parameters: s.root_loci(parameters=parameters),
    ],
)
def test_variants_without_any_result_raise_the_reason_of_the_first(call: Any) -> None:
    """A mass of zero cannot be accelerated; some such masses are a warning that counts them."""
    m = fx.Model()
    m.point("A", (0, 0))
    m.fix("A.y")
    m.point_mass("bob", "A", 1.0)
    m.spring("A.x", 3.0)
    s = m.build()
    with pytest.raises(fx.DynamicsError, match=r"2 of 2 variants failed; number 0: .*moves no mass"):
        call(s, {"bob.mass": [0.0, 0.0]})
    with pytest.raises(fx.DynamicsError, match=r"_(many|loci): .*moves no mass"):
        call(s, {"bob.mass": [0.0]})
    with pytest.warns(fx.IncompleteWarning, match=r"1 of 3 variants failed; number 1: .*moves no mass"):
        call(s, {"bob.mass": [1.0, 0.0, 2.0]})


@pytest.mark.parametrize("threads", [1, 2])
def test_what_single_motions_warn_of_is_said_once_a_cause(threads: int) -> None:
    """Bicycles that fall, whose wheels would lift: a warning for each wheel, not for each variant."""
    system = bicycle()
    rates = np.linspace(0.1, 0.3, 12)
    with pytest.warns(fx.AuditWarning) as caught:
        system.simulate_many(
            2.0, initial={"lean.angle'": rates}, samples=101, method="DOP853", threads=threads
        )
    texts = sorted(str(one.message) for one in caught)
    assert len(texts) == len({text.split("wheel ")[1].split(" pulls")[0] for text in texts}) <= 2
    assert all(" of 12 variants, number 0 first: wheel '" in text for text in texts)


def test_a_point_of_root_loci_is_computed_again_in_the_coordinates_of_its_state() -> None:
    """A mass on a spring that is drawn level and hangs: its elongation is no coordinate of a state below the pivot."""
    m = fx.Model(gravity=(0, -9.81))
    O, B = m.point("O", (0, 0), fixed=True), m.point("B", (1, 0))
    m.truss("spring", O, B, stiffness=1e3)
    m.point_mass("ball", B, 1.0)
    system = m.build()
    loci = system.root_loci(system.equilibrium(), parameters={"ball.mass": [1.0, 1.0]})
    again = loci.linearizations.linearization(0)
    assert np.sort_complex(again.eigenvalues()) == pytest.approx(
        np.sort_complex(loci.eigenvalues[0]), abs=1e-9
    )


def test_root_loci_over_a_load_are_about_the_steady_state_of_each_variant() -> None:
    """A pendulum drawn level, pulled aside: the squared frequency is the resultant of load and weight over m l."""
    m = fx.Model(gravity=(0, -9.81))
    m.point("O", (0, 0), fixed=True)
    m.point("A", (1, 0))
    m.truss("rod", "O", "A")
    m.point_mass("ball", "A", 1.0)
    m.load("A", (5.0, 0.0))
    loads = np.array([5.0, 20.0, 50.0])
    loci = m.build().root_loci(parameters={"load A.value[0]": loads})
    assert np.abs(loci.eigenvalues.real).max() < 1e-9
    assert np.abs(loci.eigenvalues[:, 0].imag) ** 2 == pytest.approx(np.hypot(loads, 9.81), rel=1e-9)
