"""Vibrations to the last digits, under follower forces, with rolling wheels, and about states that are not at rest."""

import warnings

import numpy as np
import pytest
from columns import pinned

import flexel as fx
from flexel.examples.bicycle import bicycle


def chain(n: int, EA: float, EI: float, way: tuple[float, float], mass: float = 0.0) -> fx.Model:  # noqa: N803
    """A planar cantilever of length 1 in a direction."""
    m = fx.Model()
    points = [m.point(f"P{i}", np.array(way) * i / n, fixed=i == 0) for i in range(n + 1)]
    angles = [m.angle(f"R{i}", fixed=i == 0) for i in range(n + 1)]
    for i in range(n):
        ends = points[i], angles[i], points[i + 1], angles[i + 1]
        m.beam(f"b{i}", *ends, EA=EA, EIz=EI, mass_per_length=mass)
    return m


def beck(load: float) -> fx.System:
    m = chain(10, 1e6, 1.0, (1.0, 0.0), 1.0)
    m.load("P10", (-load, 0.0), follower="R10")
    return m.build()


def test_a_column_under_a_following_force_vibrates_as_its_linearization_says() -> None:
    """Beck's column at half its flutter load."""
    system = beck(10.0)
    state = system.equilibrium()
    found = [mode.omega for mode in system.vibrations(state, count=3)]
    exact = sorted({round(value, 6) for value in abs(system.linearize(state).eigenvalues().imag)})
    assert found[0] == pytest.approx(5.176, abs=1e-3)
    np.testing.assert_allclose(found, exact[:3], rtol=1e-6)


def test_flutter_is_refused_by_name() -> None:
    """Beck's column loses stability at P l²/EI = 20.05."""
    system = beck(21.0)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", fx.UnstableWarning)
        state = system.equilibrium()
    with pytest.raises(fx.DynamicsError, match=r"vibrations: the state flutters .*linearize\(state\)\.modes"):
        system.vibrations(state)


@pytest.mark.parametrize("n", [1, 8, 40])
def test_a_stiff_leaf_spring_vibrates_to_the_last_digits(n: int) -> None:
    """A mass at the tip, drawn oblique: 3 EI / (m l³) and EA / (m l), which differ by 1e7."""
    m = chain(n, 3e7, 3.0, (0.6, 0.8))
    m.point_mass("tip", f"P{n}", 2.0)
    found = [mode.omega for mode in m.build().vibrations(count=2)]
    np.testing.assert_allclose(found, np.sqrt([4.5, 1.5e7]), rtol=1e-13)


def test_wheels_that_roll_vibrate_as_the_linearization_says() -> None:
    """The bicycle at rest falls over with 3.131 and 5.531 1/s (Meijaard et al., 2007)."""
    system = bicycle()
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", fx.UnstableWarning)
        state = system.equilibrium()
    found = [mode.omega for mode in system.vibrations(state, count=2)]
    np.testing.assert_allclose(found, [-5.53094371765393, -3.13164324790656], rtol=1e-7)


def loaded() -> fx.System:
    m = chain(2, 1e3, 1.0, (1.0, 0.0), 1.0)
    m.load("P2", (0.0, 0.5))
    return m.build()


def test_a_state_that_is_not_in_equilibrium_is_named() -> None:
    system = loaded()
    for analysis in (
        lambda: system.vibrations(system.initial),
        lambda: system.buckling(increment={"P2.x": -1.0}),
    ):
        with pytest.warns(fx.UnsteadyWarning, match=r"not in equilibrium: 0\.5 N on 'P2\.y'"):
            analysis()


def test_a_state_that_moves_is_named() -> None:
    m = chain(2, 1e3, 1.0, (1.0, 0.0), 1.0)
    m.initial("P2.y", rate=0.1)
    system = m.build()
    with pytest.warns(fx.UnsteadyWarning, match=r"the state moves \('R2\.angle' at .* rad/s"):
        system.vibrations(system.initial)


def test_modes_that_a_moment_couples_slightly_have_the_frequencies_of_the_linearization() -> None:
    """A moment about a fixed axis couples two equal modes: they grow by 0.1 % of their frequency, or less."""
    turns = 2 * np.pi / 3 * np.arange(3)
    feet = 0.05 * np.column_stack([np.cos(turns), np.sin(turns), np.zeros(3)])
    rods = {
        "elements": [1, 2, 3],
        "section": "circle",
        "dimensions": 1e-3,
        "material": "spring steel",
        "orientation": (1, 0, 0),
        "flexible": [2, 3, 4, 5, 6],
    }
    with pytest.warns(fx.UnstableWarning, match="in motion"):
        stage = fx.flexure(
            [*feet, *(feet + [0, 0, 0.1]), [0, 0, 0.1]],
            [[1, 4], [2, 5], [3, 6], [4, 7], [5, 7], [6, 7]],
            {i: {"fixed": True} for i in (1, 2, 3)}
            | {7: {"mass": 0.3, "inertia": (1e-4, 1e-4, 2e-4), "moment": (0, 0, 0.2)}},
            [rods],
            {"steps": 2, "frequencies": 3, "buckling": 0},
        )
    exact = stage.steps[-1].linearize().eigenvalues().imag
    lowest = np.sort(exact[exact > 0])[:3] / (2 * np.pi)
    np.testing.assert_allclose(stage.frequencies[-1], lowest, rtol=1e-7)


def free_ring(n: int, R: float, height: float) -> fx.System:
    """A free steel ring of n beams with a square section [m] in space."""
    m, E, A, J = fx.Model(gravity=(0, 0, 0)), 2.1e11, height**2, height**4 / 12
    for i in range(n):
        m.point(f"p{i}", (R * np.cos(2 * np.pi * i / n), R * np.sin(2 * np.pi * i / n), 0))
        m.frame(f"r{i}")
    for i in range(n):
        ends = (f"p{i}", f"r{i}", f"p{(i + 1) % n}", f"r{(i + 1) % n}")
        m.beam(f"b{i}", *ends, EA=E * A, EIy=E * J, EIz=E * J, GJ=0.3 * E * J, mass_per_length=7800 * A)
    return m.build()


@pytest.mark.parametrize(
    ("n", "R", "height"), [(24, 0.3, 1e-2), (90, 0.3, 1e-2), (90, 0.05, 3e-3), (90, 2.0, 1e-3)]
)
def test_a_free_ring_has_six_motions_without_stiffness_and_pairs(n: int, R: float, height: float) -> None:
    """Closed form (Love 1927, section 293); with sparse matrices it fluttered, or had five such motions."""
    found = np.array([mode.omega for mode in free_ring(n, R, height).vibrations(count=10)])
    unit = np.sqrt(2.1e11 * height**2 / 12 / 7800) / R**2
    plane = 2 * 3 / np.sqrt(5) * unit
    across = 2 * 3 / np.sqrt(4 + 1 / 0.3) * unit
    assert np.max(np.abs(found[:6])) < 1e-3 * plane
    assert np.allclose(found[6:], np.sort([plane, plane, across, across]), rtol=6 / n**2)


def test_motions_of_a_free_beam_have_no_frequency() -> None:
    """They had rounding errors, some of them negative as if unstable; closed form: (λL)² of a free beam."""
    m, n = fx.Model(gravity=(0, 0, 0)), 12
    for i in range(n + 1):
        m.point(f"P{i}", (i / n, 0, 0))
        m.frame(f"R{i}")
    section = {"EA": 1e6, "GJ": 1.0, "EIy": 1.0, "EIz": 1.0}
    mass = {"mass_per_length": 1.0, "inertia_per_length": (1e-4, 5e-5, 5e-5)}
    for i in range(n):
        m.beam(f"b{i}", f"P{i}", f"R{i}", f"P{i + 1}", f"R{i + 1}", direction=(0, 1, 0), **section, **mass)
    found = [mode.omega for mode in m.build().vibrations(count=8)]
    assert found[:6] == [0.0] * 6
    assert found[6:] == pytest.approx([4.730040744862704**2] * 2, rel=2e-3)


def test_what_floats_under_forces_within_it_does_not_flutter() -> None:
    """Two bodies that press on each other; rounding errors coupled their motions as if forces had no potential."""
    m = fx.Model(gravity=(0, 0, 0))
    m.point("O", (0.3, -0.2, 0.1))
    m.frame("R", (0.3623577544766736, -0.24909792362652178, 0.7472937708795654, -0.49819584725304356))
    inertia = (0.13255, 0.18104, 0.25181, -0.01141, 0.0035, -0.01567)
    m.body("b", "O", "R", mass=1.0, inertia=inertia, offset=(-0.08, 0.08, 0.07))
    m.point("P", (0.38, -0.042, 0.448))
    m.frame("S")
    m.body_point("arm", "O", "S", "P")
    inertia = (0.16824, 0.09283, 0.13654, -0.01166, 0.00105, 0.00695)
    m.body("c", "P", "S", mass=1.7, inertia=inertia, offset=(-0.11, -0.02, -0.1))
    m.truss("strut", "O", "P", mass_per_length=0.8)
    m.spring("strut.elongation", 60.0, preload=2.0)
    assert [mode.omega for mode in m.build().vibrations()] == [0.0] * 9


def plate(n: int) -> fx.System:
    """Masses on springs, joined by bars in a plane, above which each vibrates alone."""
    m = fx.Model()
    for i in range(n):
        for j in range(n):
            m.point_mass(f"m{i} {j}", m.point(f"P{i} {j}", (i, j, 0)), 1.0)
            for axis, stiffness in zip("xyz", (50.0, 100.0, 150.0), strict=True):
                m.spring(f"P{i} {j}.{axis}", stiffness)
    for i in range(n):
        for j in range(n):
            for p, q in ((i + 1, j), (i, j + 1), (i + 1, j + 1)):
                if max(p, q) < n:
                    m.truss(f"t{i} {j} {p} {q}", f"P{i} {j}", f"P{p} {q}", stiffness=1e4)
    return m.build()


@pytest.mark.parametrize("n", [11, 12, 14])
def test_repeated_frequencies_are_found_as_often_as_they_are_repeated(n: int) -> None:
    """Of n² frequencies √150, with sparse matrices three to seven were found, and then higher ones."""
    found = [mode.omega for mode in plate(n).vibrations(count=12)]
    assert found[3:] == pytest.approx([np.sqrt(150)] * 9, rel=1e-9)


def test_cantilevers_around_a_hub_vibrate_alike() -> None:
    """36 of them, 1296 coordinates: "no convergence" after 10 s."""
    m = fx.Model()
    hub = m.point("O", (0, 0), fixed=True), m.angle("hub", fixed=True)
    for b in range(36):
        way, last = np.array([np.cos(b * np.pi / 18), np.sin(b * np.pi / 18)]), hub
        for i in range(12):
            end = m.point(f"P{b} {i}", way * (i + 1) / 12), m.angle(f"R{b} {i}")
            m.beam(f"B{b} {i}", *last, *end, EA=1e6, EIz=1.0, mass_per_length=1.0)
            last = end
    found = [mode.omega for mode in m.build().vibrations(count=10)]
    assert found == pytest.approx([3.5160153] * 10, rel=1e-5)


@pytest.mark.parametrize("count", [1, 2])
def test_the_unstable_motion_is_the_lowest(count: int) -> None:
    """A column under twice Euler's load, ω² = -π⁴, with a mass on a spring beside it; that alone was found first."""
    m = pinned(140, 1e4, 2 * np.pi**2)
    m.point_mass("beside", m.point("Z", (0, 1)), 1.0)
    m.fix("Z.y")
    m.spring("Z.x", 3.0)
    s = m.build()
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", fx.UnstableWarning)
        rest = s.equilibrium()
    found = [mode.omega for mode in s.vibrations(rest, count=count)]
    assert found == pytest.approx([-9.8696, np.sqrt(3.0)][:count], rel=5e-3)
