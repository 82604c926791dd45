"""Laws that depend on time: motions, linearization at a time, energy, and analyses in which time has no meaning."""

from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
import pytest
import sympy
from mechanisms import slider
from scipy.integrate import solve_ivp

import flexel as fx
from flexel.base.arrays import Array
from flexel.derive import TIME, Law, symbol

K, A, OMEGA, C, MASS = 80.0, 0.4, 7.0, 0.3, 2.0
PERIOD = 2 * np.pi / OMEGA
METHODS = {"DOP853": 1e-9, "Radau": 1e-8, "generalized-alpha": 2e-5}


@pytest.fixture(autouse=True, scope="module")
def cache(tmp_path_factory: pytest.TempPathFactory) -> Iterator[None]:
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("XDG_CACHE_HOME", str(tmp_path_factory.mktemp("cache")))
        yield


def breathing(e: Any, ed: Any, t: Any) -> Any:
    """A spring whose stiffness varies, with a cubic term and a damper."""
    return K * (1 + A * sympy.cos(OMEGA * t)) * e + 900 * e**3 + C * ed


def model(law: Callable[..., Any] = breathing, **options: Any) -> fx.Model:
    m = slider(MASS)
    m.law("strut.elongation", law, **options)
    return m


def reference(times: Array, e0: float, v0: float) -> Array:
    """Elongation by SciPy, from the equation of motion as it is written by hand."""

    def rates(t: float, y: Array) -> list[float]:
        e, ed = y
        return [ed, -(K * (1 + A * np.cos(OMEGA * t)) * e + 900 * e**3 + C * ed) / MASS]

    found = solve_ivp(rates, (times[0], times[-1]), [e0, v0], "DOP853", times, rtol=1e-12, atol=1e-14)
    return np.asarray(found.y[0])


@pytest.mark.parametrize("method", METHODS)
def test_a_motion_is_that_of_its_equation(method: str) -> None:
    s = model().build()
    start = s.state_at({"strut.elongation": 0.1}, {"strut.elongation": 0.2})
    options: dict[str, Any] = {} if method != "generalized-alpha" else {"rtol": 1e-9, "spectral_radius": 1.0}
    if method != "generalized-alpha":
        options = {"rtol": 1e-11}
    motion = s.simulate(3.0, start=start, method=method, samples=31, **options)
    expected = reference(motion.t, 0.1, 0.2)
    assert motion["strut.elongation"] == pytest.approx(expected, abs=METHODS[method])


def test_variants_in_lanes_and_a_start_at_another_time_take_the_law_at_their_times() -> None:
    s = model().build()
    start = s.state_at({"strut.elongation": 0.1}, {"strut.elongation": 0.2})
    early = s.simulate(1.7, start=start, rtol=1e-11)
    late = s.simulate(1.3, start=early[-1], rtol=1e-11)
    assert late["strut.elongation"][-1] == pytest.approx(
        reference(np.array([0.0, 3.0]), 0.1, 0.2)[-1], abs=1e-9
    )
    rates = np.linspace(0.1, 0.3, 9)  # lanes of eight, and one more
    many = s.simulate_many(3.0, initial={"strut.elongation'": rates}, start=start, rtol=1e-11, samples=2)
    for rate, found in zip(rates, many["strut.elongation"], strict=True):
        assert found[-1] == pytest.approx(reference(np.array([0.0, 3.0]), 0.1, rate)[-1], abs=1e-9)


def test_a_linearization_is_that_of_its_time() -> None:
    s = model().build()
    for t in (0.0, 0.2, 1.1):
        lin = s.linearize(s.equilibrium(t=t))
        assert lin.K[0, 0] == pytest.approx(K * (1 + A * np.cos(OMEGA * t)), rel=1e-13)
        assert lin.C[0, 0] == pytest.approx(C, rel=1e-13)


def test_an_equilibrium_is_that_of_its_time() -> None:
    s = model(lambda e, ed, t: 50 * (1 + t) * e - 10 * t + 2 * ed).build()
    assert s.equilibrium()["strut.elongation"] == pytest.approx(0.0, abs=1e-14)
    rest = s.equilibrium(t=3.0)
    assert rest["strut.elongation"] == pytest.approx(30 / 200, rel=1e-12)
    assert s.equilibrium(rest)["strut.elongation"] == pytest.approx(30 / 200, rel=1e-12)
    assert s.vibrations(rest)[0].omega == pytest.approx(np.sqrt(200 / MASS), rel=1e-12)


def test_terms_without_time_store_energy_and_the_others_do_work() -> None:
    s = model().build()
    motion = s.simulate(2.0, start=s.state_at({"strut.elongation": 0.1}), rtol=1e-11, samples=801)
    e, ed, t = motion["strut.elongation"], motion.rate("strut.elongation"), motion.t
    assert motion.energy["strain"] == pytest.approx(K * e**2 / 2 + 225 * e**4, abs=1e-12)
    dissipated = np.array([state.dissipated for state in motion])
    assert dissipated == pytest.approx(C * ed**2 + K * A * np.cos(OMEGA * t) * e * ed, abs=1e-10)
    assert not motion.warnings


def test_a_spring_by_a_formula_of_time_counts_from_its_free_length() -> None:
    m = slider(MASS)
    m.spring("strut.elongation", lambda e, ed, t: 40 * (1 + t) * e, free_length=0.9)
    s = m.build()
    assert s.at_rest.force("strut.elongation") == pytest.approx(4.0, rel=1e-14)
    assert s.equilibrium(t=2.0)["strut.elongation"] == pytest.approx(-0.1, rel=1e-12)


def test_a_short_pulse_is_not_stepped_over() -> None:
    """A triangle of 10 ms and 100 N: impulse 0.5 N s, on a mass that nothing else moves."""
    hat = lambda e, ed, t: -sympy.Max(0, 100 - 2e4 * sympy.Abs(t - 7.0))  # noqa: E731
    for method, tight in (("DOP853", 1e-9), ("Radau", 1e-9), ("generalized-alpha", 1e-4)):
        motion = model(hat).build().simulate(10.0, method=method, samples=3)
        assert motion.rate("strut.elongation")[-1] == pytest.approx(0.5 / MASS, rel=tight)


def test_a_periodic_motion_is_the_one_that_a_simulation_tends_to() -> None:
    def forced(e: Any, ed: Any, t: Any) -> Any:
        return breathing(e, ed, t) + 3 * ed - sympy.sin(2 * OMEGA * t)

    s = model(forced).build()
    found = s.periodic(period=PERIOD, harmonics=14)
    end = s.simulate(40 * PERIOD, rtol=1e-11)[-1]
    assert found["strut.elongation"][0] == pytest.approx(end["strut.elongation"], abs=1e-9)


def test_the_floquet_multipliers_are_those_of_mathieus_equation() -> None:
    s = model(lambda e, ed, t: K * (1 + A * sympy.cos(OMEGA * t)) * e + C * ed).build()
    columns = []
    for y0 in ([1.0, 0.0], [0.0, 1.0]):
        found = solve_ivp(
            lambda t, y: [y[1], -(K * (1 + A * np.cos(OMEGA * t)) * y[0] + C * y[1]) / MASS],
            (0, PERIOD), y0, "DOP853", rtol=1e-12, atol=1e-14,
        )  # fmt: skip
        columns.append(found.y[:, -1])
    expected = np.linalg.eigvals(np.column_stack(columns))
    found = s.periodic(period=PERIOD, harmonics=8).multipliers()
    assert np.sort(np.abs(found)) == pytest.approx(np.sort(np.abs(expected)), rel=1e-6)


def test_a_period_that_a_law_does_not_have_is_refused() -> None:
    s = model().build()
    with pytest.raises(
        fx.LinearizationError, match=r"'strut.elongation' depends on time, but not with the period 1 s"
    ):
        s.periodic(period=1.0, harmonics=3)
    assert s.periodic(period=2 * PERIOD, harmonics=3).period == pytest.approx(2 * PERIOD)


def test_steady_motion_and_other_speeds_are_refused() -> None:
    # the first has a whole number of periods in a second
    for rate in (2 * np.pi, OMEGA):
        s = model(lambda e, ed, t, w=rate: K * (2 + sympy.cos(w * t)) * e + ed).build()
        with pytest.raises(
            fx.PositionError, match="'strut.elongation' depends on time, so no motion is steady"
        ):
            s.steady()
        with pytest.raises(fx.LinearizationError, match="'strut.elongation' depends on time, and its speed"):
            s.periodic_branch(period=2 * np.pi / rate, end=1.3, harmonics=2)


def test_a_compiled_law_that_depends_on_time_says_so() -> None:
    e, ed, phase = symbol("e"), symbol("ed"), symbol("phase")
    law = fx.compile_law(
        Law("wave", "k(t) e", (), (e,), (ed,), (), (e * (2 + phase),), (), let=((phase, sympy.sin(TIME)),))
    )
    assert law.spec.timed
    plain = fx.compile_law(Law("plain", "k e", (), (e,), (ed,), (), (2 * e,), ()))
    assert not plain.spec.timed
    with pytest.raises(fx.PositionError, match="no motion is steady"):
        model(law).build().steady()


@pytest.mark.parametrize(
    ("law", "options", "message"),
    [
        (lambda e, ed, t: sympy.Piecewise((e, t < 2), (3 * e, True)), {}, "jumps at t = 2"),
        (lambda e, ed, t: sympy.sqrt(t - 3) * e, {}, "verif|real|not a number|finite"),
        (lambda e, ed, t: e * t, {"energy": lambda e, t: e}, "energy failed on the symbols e"),
        (lambda e, ed, t: e * t, {"ranges": {"t": (2, 1)}}, "increasing"),
        (lambda e, ed, t: e * t, {"ranges": {"time": (0, 1)}}, "'time'"),
    ],
)
def test_formulas_without_sense_are_refused(law: Any, options: dict[str, Any], message: str) -> None:
    with pytest.raises(fx.ModelError, match=message):
        model(law, **options).build()


def test_a_range_of_times_is_where_a_formula_is_verified() -> None:
    m = model(lambda e, ed, t: sympy.sqrt(t - 3) * (e - 0.1), ranges={"t": (3.5, 9.0)})
    rest = m.build(t=4.0).equilibrium(t=7.0)
    assert rest["strut.elongation"] == pytest.approx(0.1, rel=1e-12)
