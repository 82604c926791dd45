"""Static equilibrium, load paths, buckling and vibrations: closed forms and convergence."""

import numpy as np
import pytest
from coarse import COARSE_MESH

import flexel as fx
from flexel.examples.published import published


def cantilever(n: int, EA: float = 1e6) -> fx.Model:
    """Clamped beam along x of length 1 with EI = GJ = 1, n elements."""
    m = fx.Model()
    p, r = m.point("P0", (0, 0, 0), fixed=True), m.frame("R0", fixed=True)
    for i in range(1, n + 1):
        q, s = m.point(f"P{i}", (i / n, 0, 0)), m.frame(f"R{i}")
        m.beam(f"b{i}", p, r, q, s, direction=(0, 1, 0), EA=EA, GJ=1.0, EIy=1.0, EIz=1.0, mass_per_length=1.0)
        p, r = q, s
    return m


def tip_error(n: int, load: float) -> float:
    rows = published("elastica_cantilever")["vertical_tip_load"]
    exact = next(float(row["w_over_L"]) for row in rows if float(row["PL2_EI"]) == load)
    m = cantilever(n, EA=1e8)
    m.load(f"P{n}.z", lambda t: load * t)
    path = m.build().static_path(t_end=1.0)
    assert path.message == ""
    assert path[-1].t == pytest.approx(1.0, abs=1e-14)
    return abs(path[-1][f"P{n}.z"] / exact - 1)


@COARSE_MESH
def test_an_elastica_under_an_end_force_converges_with_the_second_order() -> None:
    errors = [tip_error(n, 1.0) for n in (2, 4, 8)]
    orders = np.log2(np.array(errors[:-1]) / errors[1:])
    assert errors[-1] < 1.2e-3
    np.testing.assert_allclose(orders, 2.0, atol=0.15)


@COARSE_MESH
def test_an_end_moment_rolls_a_cantilever_up_to_a_circle() -> None:
    def gap(n: int) -> float:
        m = cantilever(n, EA=1e8)
        m.load(f"R{n}", (0, 0, lambda t: 2 * np.pi * t))
        path = m.build().static_path(t_end=1.0)
        assert path.message == ""
        return float(np.linalg.norm(path[-1].position(f"P{n}")))

    coarse, fine = gap(16), gap(32)
    assert np.log2(coarse / fine) == pytest.approx(2.0, abs=0.1)


@COARSE_MESH
def test_taking_all_loads_on_at_once_or_along_a_path_ends_in_the_same_equilibrium() -> None:
    m = cantilever(4)
    m.load("P4.z", 3.0)
    at_once = m.build().equilibrium()
    m = cantilever(4)
    m.load("P4.z", lambda t: 3.0 * t)
    along = m.build().static_path(t_end=1.0)[-1]
    np.testing.assert_allclose(at_once.position("P4"), along.position("P4"), atol=1e-11)


def test_a_path_ends_at_its_end_on_fine_meshes_too() -> None:
    """Where the last step's correction leans beyond the full load."""
    m = cantilever(48, EA=1e8)
    m.load("P48.z", 5.0)
    state = m.build().equilibrium()
    assert state["P48.z"] == pytest.approx(0.7137915236119127, rel=2e-4)
    assert state.force("P0.z") == pytest.approx(-5.0, rel=1e-8)


@COARSE_MESH
def test_equilibrium_balances_the_reactions_at_the_clamp() -> None:
    m = cantilever(4)
    m.load("P4.z", 3.0)
    state = m.build().equilibrium()
    assert state.force("P0.z") == pytest.approx(-3.0, rel=1e-10)
    assert state.force("P0.x") == pytest.approx(0.0, abs=1e-9)


def test_a_shallow_truss_snaps_through_along_the_closed_form() -> None:
    height, k = 0.1, 1000.0
    m = fx.Model()
    left, right = m.point("L", (-1, 0), fixed=True), m.point("R", (1, 0), fixed=True)
    top = m.point("T", (0, height))
    m.truss("a", left, top, stiffness=k)
    m.truss("b", right, top, stiffness=k)
    m.fix("T.x")
    m.load("T.y", lambda t: -t)
    l0 = np.hypot(1, height)

    def load(y: np.ndarray) -> np.ndarray:
        length = np.hypot(1, y)
        return -2 * k * (length - l0) * y / length

    peak = float(np.max(load(np.linspace(-height, height, 20001))))
    path = m.build().static_path(t_end=2 * peak)
    assert path.message == ""
    np.testing.assert_allclose(path.t, load(path["T.y"]), atol=1e-9 * peak)
    assert np.any(np.diff(path.t) < 0)  # the load falls while the truss snaps through
    assert path["T.y"][-1] < -height


def test_the_euler_load_and_the_frequencies_of_a_cantilever() -> None:
    system = cantilever(8).build()
    load = system.buckling(increment={"P8.x": -1.0}, count=1)[0].multiplier
    assert load == pytest.approx(np.pi**2 / 4, rel=1e-5)
    frequencies = [mode.omega for mode in system.vibrations(count=4)]
    exact = np.array([1.8751040687119612, 4.694091132974175]) ** 2
    np.testing.assert_allclose(frequencies, np.repeat(exact, 2), rtol=1e-4)


def test_frequencies_fall_to_zero_at_the_buckling_load() -> None:
    m = cantilever(4)
    m.load("P4.x", lambda t: -t)
    system = m.build()
    critical = system.buckling(increment={"P4.x": -1.0}, count=1)[0].multiplier
    state = system.static_path(t_end=0.999999 * critical)[-1]
    first = system.vibrations(state, count=1)[0].omega
    assert 0 < first < 1e-2
    assert system.buckling(state, increment={"P4.x": -1.0}, count=1)[0].multiplier < 1e-4


def test_an_unsupported_motion_is_named() -> None:
    m = fx.Model(gravity=(0, 0, -9.81))
    m.point_mass("stone", m.point("S", (0, 0, 1)), 1.0)
    with pytest.raises(fx.DynamicsError, match=r"nothing resists a motion of .*'S\.[xyz]'"):
        m.build().equilibrium()


def test_a_path_that_cannot_be_followed_says_where_it_stopped() -> None:
    m = fx.Model()
    m.truss("rod", m.point("O", (0, 0), fixed=True), m.point("A", (1, 0)))
    m.prescribe("A.y", lambda t: 2 * t)  # the rod is rigid: it can reach 1 and no more
    with pytest.warns(fx.IncompleteWarning, match="stopped at"):
        path = m.build().static_path(t_end=1.0)
    assert "stopped at" in path.message
    assert np.max(path.t) == pytest.approx(0.5, abs=0.05)
    assert np.max(path.t) < 0.5


def test_a_pendulum_drawn_askew_finds_its_way_down() -> None:
    m = fx.Model(gravity=(0, 0, -9.81))
    o, a = m.point("O", (0, 0, 0), fixed=True), m.point("A", (0.3, 0, -0.9))
    r0, r1 = m.frame("R0", fixed=True), m.frame("R1")
    m.hinge("pivot", r0, r1, axis=(0, 1, 0))
    m.beam("rod", o, r1, a, mass_per_length=2.0)
    state = m.build().equilibrium()
    length = float(np.hypot(0.3, 0.9))
    np.testing.assert_allclose(state.position("A"), (0, 0, -length), atol=1e-12)
    assert state.force("O.z") == pytest.approx(2.0 * length * 9.81, rel=1e-12)


def test_a_pendulum_that_may_spin_about_the_vertical_hangs_in_a_position_it_can_take() -> None:
    """Nothing resists its spin where it hangs: the last steps there are rounding divided by rounding."""
    m = fx.Model(gravity=(0.0, 0.0, -9.81))
    arm = np.array([0.195, 0.02, -0.04])
    m.point("O", (0.0, 0.0, 0.0), fixed=True)
    m.frame("R")
    m.body_point("arm", "O", "R", m.point("P", arm))
    m.body("bob", "P", "R", mass=0.5, inertia=(0.02, 0.02, 0.004, 0.0, 0.0, 0.0), offset=(0.0, 0.0, 0.0))
    rest = m.build().equilibrium()
    np.testing.assert_allclose(rest.position("P"), (0, 0, -np.linalg.norm(arm)), atol=1e-12)
    parameters = np.array([rest[f"R.lambda{i}"] for i in range(4)])
    assert np.linalg.norm(parameters) == pytest.approx(1.0, abs=1e-13)


def test_a_hanging_rod_vibrates_about_its_equilibrium_if_no_state_is_given() -> None:
    m = fx.Model(gravity=(0, 0, -9.81))
    r1 = m.frame("R1")
    m.hinge("pivot", m.frame("R0", fixed=True), r1, axis=(0, 1, 0))
    m.beam("rod", m.point("O", (0, 0, 0), fixed=True), r1, m.point("A", (0.1, 0, -0.7)), mass_per_length=2.0)
    frequency = m.build().vibrations()[0].omega
    assert frequency**2 == pytest.approx(1.5 * 9.81 / np.hypot(0.1, 0.7), rel=1e-9)


def test_an_equilibrium_at_an_extreme_of_a_degree_of_freedom_can_be_linearized() -> None:
    m = fx.Model(gravity=(0, 0, -9.81))
    m.point("O", (0, 0, 0), fixed=True)
    m.point("P", (0.6, -0.9, 0))
    m.point_mass("mass", "P", 0.5)
    m.truss("bar", "O", "P", stiffness=20)
    m.independent("bar.elongation", "P.x", "P.z")  # below O, the elongation does not depend on P.y
    s = m.build()
    with pytest.warns(
        fx.CoordinateWarning, match="'P.z' are nearly singular at t = 0 s; .*'P.y' are used there"
    ):
        rest = s.equilibrium()
    length = np.hypot(0.6, 0.9) + 0.5 * 9.81 / 20
    assert rest["P.z"] == pytest.approx(-length, rel=1e-12)
    with pytest.warns(fx.CoordinateWarning, match="'P.y' are used there"):
        found = s.linearize(rest).eigenvalues().imag
    swing, bounce = np.sqrt(9.81 / length), np.sqrt(20 / 0.5)
    np.testing.assert_allclose(np.sort(found), [-bounce, -swing, -swing, swing, swing, bounce], rtol=1e-9)


def test_a_cable_whose_slope_vanishes_is_not_in_equilibrium() -> None:
    """Downhill from the unstable equilibrium of a hanging cable lies a place where its curvature has no bound."""
    m = fx.Model(gravity=(1.21, 5.55, -3.26))
    places = (
        (0.0, 0.0, 0.0),
        (0.055234109480598384, -0.24626211448880891, 0.15154200751231586),
        (0.17946821896119675, -0.5255242889776179, 0.3270840150246317),
        (0.26770232844179515, -0.7927863434664268, 0.44862602253694756),
    )
    slopes = (
        (0.4641136982686613, -0.9108737149626964, 0.6851400250410529, 0.98),
        (0.17411369826866127, -0.8408737149626965, 0.7251400250410529, 0.96),
        (0.4641136982686613, -0.8408737149626965, 0.4851400250410529, 0.97),
        (0.2941136982686613, -0.5308737149626965, 0.7551400250410529, 1.03),
    )
    m.point("P0", places[0], fixed=True)
    m.frame("R", fixed=True)
    m.slope("d0", slopes[0][:3], stretch=slopes[0][3])
    for i in (1, 2, 3):
        m.slope(f"d{i}", slopes[i][:3], stretch=slopes[i][3])
        m.point(f"P{i}", places[i])
    for i, length in enumerate((0.34, 0.34, 0.3)):
        ends = f"P{i}", f"d{i}", f"P{i + 1}", f"d{i + 1}"
        m.cable(f"c{i}", *ends, length, EA=393.8, EI=0.41, mass_per_length=0.41)
    m.clamp("grip", "R", "d0")
    m.point_mass("bob", "P3", 1.87)
    s = m.build()
    try:
        rest = s.equilibrium(stable=True)
    except fx.PositionError:
        return
    assert np.abs(s.state(rest.t, rest.x, 0 * rest.v).a).max() < 1e-6


def test_a_stiff_equilibrium_is_the_same_to_the_last_digit_whichever_way_leads_to_it(
    caplog: pytest.LogCaptureFixture,
) -> None:
    """A cantilever of EA L²/EI = 1e8 under P L²/EI = 10: the residual is rounding long before the position is exact."""
    m = cantilever(16, EA=1e8)
    m.load("P16.z", lambda t: -10.0 * t)
    s = m.build()
    with caplog.at_level("INFO", "flexel.statics"):
        direct = s.equilibrium(t=1.0)
    assert "gradually" not in caplog.text  # one search, at the whole load
    path = s.static_path(t_end=1.0)
    np.testing.assert_allclose(direct.x, path[-1].x, rtol=0, atol=1e-13)
    middle = path[len(path) // 2]
    np.testing.assert_allclose(s.equilibrium(middle).x, middle.x, rtol=0, atol=1e-12)
