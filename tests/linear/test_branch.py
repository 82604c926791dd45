"""Branches of periodic motions: closed forms, folds, stability, agreement with simulation, bad input."""

from pathlib import Path

import numpy as np
import pytest
from mechanisms import oscillator
from scipy.optimize import fsolve

import flexel as fx
from flexel.derive import TIME, Law, Parameter, symbol
from flexel.linear.speeds import PeriodicCurve

SPEED, ZETA, CUBIC, PUSH = 0.7, 0.02, 0.05, 0.1
PERIOD = 2 * np.pi / SPEED


def duffing() -> fx.System:
    """A mass on a hardening spring, whose resonance bends over to higher speeds."""
    return oscillator(SPEED, ZETA, CUBIC, PUSH)


@pytest.fixture(scope="module")
def branch() -> fx.PeriodicBranch:
    return duffing().periodic_branch(period=PERIOD, end=2 * np.pi / 1.4, harmonics=5)


def unbalance(a: float, w: float) -> float:
    """Amplitude a and speed w of the first harmonic alone satisfy the balance where this is zero."""
    return ((1 + 0.75 * CUBIC * a * a - w * w) ** 2 + (2 * ZETA * w) ** 2) * a * a - PUSH**2


def slope(a: float, w: float) -> float:
    """Derivative of the same by the amplitude, zero at a fold."""
    stiffness = 1 + 0.75 * CUBIC * a * a - w * w
    return 2 * a * (stiffness * (stiffness + 1.5 * CUBIC * a * a) + (2 * ZETA * w) ** 2)


def test_one_harmonic_follows_the_closed_form_through_both_folds() -> None:
    found = duffing().periodic_branch(period=PERIOD, end=2 * np.pi / 1.4, harmonics=1)
    a = np.abs(found.harmonics("P.x")[:, 1])
    assert max(abs(unbalance(*pair)) for pair in zip(a, found.omega, strict=True)) < 1e-9
    assert len(found.folds) == 2
    for i in found.folds:
        exact = fsolve(lambda pair: (unbalance(*pair), slope(*pair)), (a[i], found.omega[i]))
        assert found.omega[i] == pytest.approx(exact[1], rel=1e-7)


@pytest.mark.long
def test_folds_do_not_depend_on_the_step_nor_on_the_direction(branch: fx.PeriodicBranch) -> None:
    fine = duffing().periodic_branch(period=PERIOD, end=2 * np.pi / 1.4, harmonics=5, step=0.07)
    assert len(fine) > 2 * len(branch)
    assert fine.omega[fine.folds] == pytest.approx(branch.omega[branch.folds], rel=1e-7)
    down = branch[-1].motion.system.periodic_branch(period=branch[-1].period, end=PERIOD, harmonics=5)
    assert down.omega[down.folds][::-1] == pytest.approx(branch.omega[branch.folds], rel=1e-7)
    assert down[-1].omega == pytest.approx(SPEED, rel=1e-12)
    assert down[-1]["P.x"] == pytest.approx(branch[0]["P.x"], abs=1e-8)


def test_a_multiplier_is_one_at_folds_and_larger_between_them(branch: fx.PeriodicBranch) -> None:
    first, last = branch.folds
    assert branch.modulus[[first, last]] == pytest.approx(1, abs=1e-5)
    assert [stable for _, stable in branch.stretches] == [True, False, True]
    assert branch.stretches[1][0] == slice(first, last + 1)
    assert np.all(branch.modulus[first + 1 : last] > 1)
    assert branch.kinds[0] == branch.kinds[-1] == "end"
    (peak,) = branch.peaks
    assert first < peak < last
    assert branch.modulus[peak] == branch.modulus.max()
    product = branch.multipliers.prod(axis=1)  # damping is constant
    assert product == pytest.approx(np.exp(-4 * np.pi * ZETA / branch.omega), rel=1e-5)


def test_both_stable_motions_at_one_speed_are_those_of_simulation(branch: fx.PeriodicBranch) -> None:
    first, last = branch.folds
    below, above = branch[first - 2], branch[last + 2]
    assert abs(below.omega - above.omega) < 0.05
    for solution in (below, above):
        run = solution.motion.system.simulate(30 * solution.period, start=solution.motion[0], samples=31)
        assert run["P.x"] == pytest.approx(np.full(31, solution["P.x"][0]), abs=2e-4)


def test_a_disturbed_unstable_motion_leaves_as_its_multiplier_says(branch: fx.PeriodicBranch) -> None:
    (peak,) = branch.peaks
    solution = branch[peak]
    system, start = solution.motion.system, solution.motion[0]
    runs = []
    for push in (1e-5, -1e-5):
        state = system.state_at({"P.x": start["P.x"] + push}, start=start)
        runs.append(
            system.simulate(40 * solution.period, start=state, samples=41, rtol=1e-11, atol=1e-13)["P.x"]
        )
    apart = np.abs(runs[0] - runs[1])
    assert apart[30] / apart[20] == pytest.approx(branch.modulus[peak] ** 10, rel=1e-2)


def test_a_system_that_runs_faster_is_the_one_with_faster_motions_and_loads() -> None:
    slow, fast = (oscillator(w, cubic=0.1).simulate(4 / w, samples=9) for w in (1.0, 3.0))
    found = oscillator(1.0, cubic=0.1).time_scaled(3.0).simulate(4 / 3.0, samples=9)
    assert found["P.x"] == pytest.approx(fast["P.x"], abs=1e-12)
    assert not np.allclose(found["P.x"], slow["P.x"], atol=1e-3)
    m = fx.Model()
    m.point("A", (0, 0))
    m.fix("A.y")
    m.point_mass("mass", "A", 2.0)
    m.prescribe("A.x", fx.Harmonic(0.5, 2.0, phase=0.3))
    state = m.build(t=0.4).time_scaled(1.5).initial
    assert state.t == pytest.approx(0.4 / 1.5)
    assert state.rate("A.x") == pytest.approx(1.5 * np.cos(1.1))
    assert state.force("A.x") == pytest.approx(-2.0 * 0.5 * 9 * np.sin(1.1))


def test_the_derivative_by_the_speed_is_that_of_finite_differences() -> None:
    """A driven base and a force that are run through faster."""
    m = fx.Model(gravity=(0, -9.81))
    for name in ("O", "A", "B"):
        m.point(name, {"O": (0, 0), "A": (0.2, 0), "B": (0.9, 0.1)}[name], fixed=name == "O")
    for name in ("g", "a", "b"):
        m.angle(name, fixed=name == "g")
    m.hinge("motor", "g", "a")
    m.beam("arm", "O", "a", "A")
    m.hinge("joint", "a", "b", stiffness=30.0, damping=0.1)
    m.beam("bar", "A", "b", "B", mass_per_length=2.0)
    m.prescribe("motor.angle", fx.Polynomial((0.0, 3.0)))
    m.load("B.y", lambda t: np.sin(6 * t))
    curve = PeriodicCurve(m.build(), 3.0, 24, 3, 1.0)
    unknowns = np.random.default_rng(1).normal(scale=0.05, size=7)
    h = 1e-5

    def force(p: float) -> np.ndarray:
        return curve.equations(np.append(unknowns, p), None).coefficients.F

    here = curve.equations(np.append(unknowns, 0.0), None)
    numerical = (force(h) - force(-h)) / (2 * h)
    A = -curve.pack(here.coefficients.responses(3, numerical)[0])
    assert here.both[:, 1] == pytest.approx(A, abs=1e-7 * np.abs(A).max())


def test_a_branch_is_drawn_and_tabulated(branch: fx.PeriodicBranch, tmp_path: Path) -> None:
    pytest.importorskip("matplotlib")
    drawn = branch.plot("P.x", "P.x'", path=tmp_path / "branch.png")
    assert [axes.get_ylabel() for axes in drawn.axes] == ["P.x [m]", "P.x' [m/s]", "largest multiplier [-]"]
    assert [line.get_linestyle() for line in drawn.axes[0].lines[:3]] == ["-", "--", "-"]
    pytest.importorskip("pandas")
    table = branch.to_pandas()
    assert list(table["kind"][table["kind"] != ""]) == ["end", "fold", "peak", "fold", "end"]
    assert table["neglected"].max() < 1e-4


# -- bad input ------------------------------------------------------------------------------------


def test_a_branch_that_is_not_finished_keeps_what_it_has_and_says_so() -> None:
    with pytest.warns(fx.IncompleteWarning, match="the branch stopped at 0.7"):
        found = duffing().periodic_branch(period=PERIOD, end=1.0, harmonics=1, most=3)
    assert len(found) == 4
    assert "allow more or smaller steps" in found.message


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"end": PERIOD}, "both periods are"),
        ({"end": -1.0}, "end"),
        ({"step": 0.0}, "step"),
        ({"harmonics": 0}, "harmonics 0; give a whole number, 1 or more"),
    ],
)
def test_options_without_sense_are_refused(options: dict[str, float], message: str) -> None:
    given = {"period": PERIOD, "end": 5.0, "harmonics": 1, **options}
    with pytest.raises(fx.ModelError, match=message):
        duffing().periodic_branch(**given)  # type: ignore[arg-type]


def test_a_law_that_depends_on_time_is_refused() -> None:
    k, e, ed = Parameter("k", 1, "N/m", "stiffness"), symbol("e"), symbol("ed")
    wavering = Law("wavering", "k(t) e", (k,), (e,), (ed,), (), (k.symbol * e * (2 + TIME) + ed,), ())
    m = fx.Model()
    m.point("O", (0, 0), fixed=True)
    m.point("P", (1, 0))
    m.fix("P.y")
    m.point_mass("mass", "P", 1.0)
    m.truss("spring", "O", "P")
    m.law("spring.elongation", fx.compile_law(wavering), k=3.0)
    m.load("P.x", lambda t: 0.1 * np.sin(t))
    with pytest.raises(fx.LinearizationError, match="'spring.elongation' depends on time"):
        m.build().periodic_branch(period=2 * np.pi, end=6.0, harmonics=1)
